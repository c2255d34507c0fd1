"""What of a structural check is drawn: positions, colours of members, and words for the legend."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import FreeCAD
import numpy as np

from freecad_ortho import convert
from freecad_ortho.view import check_combination
from freecad_ortho.view.colour_scale import ColourScale
from freecad_ortho.view.colours import palette
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray

translate = FreeCAD.Qt.translate

UTILISATION, DISPLACEMENT, AXIAL, NONE = "Utilisation", "Displacement", "Axial force", "None"
COLOURINGS = (UTILISATION, DISPLACEMENT, AXIAL, NONE)
AS_DRAWN, DEFLECTED, BUCKLING = "As drawn", "Deflected", "Buckling"
SHAPES = (AS_DRAWN, DEFLECTED, BUCKLING)
# Properties of a check that are drawn.
DRAWN_FROM = (
    "Nodes",
    "MemberNodes",
    "MemberUtilisation",
    "AxialForces",
    "Displacements",
    "BucklingFactors",
    "BucklingShapes",
)
# How far the largest displacement is drawn, by the longest side of the frame.
_DRAWN = 0.06
_PLAIN = (0.23, 0.29, 0.36)


@dataclass(frozen=True)
class Look:
    """How a check is seen.

    Attributes:
        colours: one of ``COLOURINGS``.
        shape: one of ``SHAPES``.
        mode: number of the buckling shape, from 1.
        enlarged: times that displacements are drawn as large, 0 for what fits.
        combination: whose forces and displacements are drawn.
    """

    colours: str
    shape: str
    mode: int
    enlarged: float
    combination: str = check_combination.GOVERNING

    @property
    def chosen(self) -> str:
        """The combination where it is not the one that governs, for a note."""
        return "" if self.combination == check_combination.GOVERNING else f", {self.combination}"


@dataclass(frozen=True, eq=False)
class Drawn:
    """A frame as it is drawn.

    Attributes:
        points: (N + M, 3) nodes, then middles of members, where they are, mm.
        lines: (M, 3) points of each member.
        moved: (N + M, 3) how far points are drawn from there, mm; None where the frame itself is
            drawn.
        colours: (M, 3) RGB of the members.
        scale: of the legend, None where the colours say nothing.
        title: of the legend.
        note: below the title.
    """

    points: FloatArray
    lines: IntArray
    moved: FloatArray | None
    colours: FloatArray
    scale: ColourScale | None
    title: str
    note: str


def drawn(feature: FreeCAD.DocumentObject, look: Look) -> Drawn | None:
    """What is drawn of a check; nothing before it was checked or while its results are written."""
    nodes, members = convert.array(feature.Nodes), np.array(feature.MemberNodes, dtype=np.int64)
    members = members.reshape(-1, 2)
    whole = len(feature.MemberUtilisation) == len(feature.AxialForces) == len(members)
    if not whole or not len(members) or members.max() >= len(nodes):
        return None
    points = _with_middles(nodes, members)
    moves, times, moving = _moves(feature, look, points, members)
    values, scale, title, note = _values(feature, look, moves, members)
    colours = np.tile(_PLAIN, (len(members), 1))
    if scale is not None and values is not None:
        colours = palette(scale.fractions(values), scale.signed)
    shown = None if moves is None or look.shape == AS_DRAWN else times * moves
    middles = len(nodes) + np.arange(len(members))
    lines = np.column_stack([members[:, 0], middles, members[:, 1]])
    return Drawn(points, lines, shown, colours, scale, title, f"{note}{moving}")


def _with_middles(values: FloatArray, members: IntArray) -> FloatArray:
    """(N + M, 3) values of nodes, then those half way between the ends of members."""
    return np.concatenate([values, values[members].mean(axis=1)])


def _moves(
    feature: Any, look: Look, points: FloatArray, members: IntArray
) -> tuple[FloatArray | None, float, str]:
    """Displacements, how many times as large they are drawn, and words for that."""
    if look.shape == BUCKLING:
        rows = convert.array(feature.BucklingShapes)
        shapes = rows[: len(rows) // len(points) * len(points)].reshape(-1, len(points), 3)
        if not 1 <= look.mode <= min(len(shapes), len(feature.BucklingFactors)):
            return None, 1.0, ""
        moves = shapes[look.mode - 1]
    else:
        nodes = len(points) - len(members)
        found = check_combination.displacements(feature, look.combination, nodes)
        if found is None:
            return None, 1.0, ""
        moves = _with_middles(found, members)
    largest = float(np.linalg.norm(moves, axis=1).max())
    fits = _DRAWN * float(np.ptp(points, axis=0).max()) / largest if largest else 1.0
    times = look.enlarged or float(f"{fits:.2g}")
    if look.shape == BUCKLING:
        return moves, fits * (look.enlarged or 1.0), ""
    words = translate("Ortho", ", drawn {:g} times")
    return moves, times, words.format(times) if look.shape == DEFLECTED else ""


def _values(
    feature: Any, look: Look, moves: FloatArray | None, members: IntArray
) -> tuple[FloatArray | None, ColourScale | None, str, str]:
    """Values of the members, their scale, and its title and note."""
    if look.colours == UTILISATION:
        used = 100 * np.array(feature.MemberUtilisation)
        note = translate("Ortho", "max {:.0f} %").format(used.max())
        return used, ColourScale(0.0, 100.0, unit="%"), translate("Ortho", "Utilisation"), note
    if look.colours == AXIAL:
        force = _axial(feature, look, len(members))
        most = float(np.abs(force).max()) or 1.0
        note = translate("Ortho", "{:.3g} to {:.3g} kN").format(force.min(), force.max())
        note += look.chosen
        scale = ColourScale(-most, most, signed=True, unit="kN")
        return force, scale, translate("Ortho", "Axial force"), note
    if look.colours == DISPLACEMENT and moves is not None:
        size = np.linalg.norm(moves, axis=1)
        most = float(size.max()) or 1.0
        # A member bows as much as its middle, or moves as its ends do.
        values = np.maximum(size[members].mean(axis=1), size[-len(members) :])
        if look.shape == BUCKLING:
            title = translate("Ortho", "Buckling shape {}").format(look.mode)
            factor = feature.BucklingFactors[look.mode - 1]
            note = translate("Ortho", "factor {:.2f}").format(factor)
            return values / most, ColourScale(0.0, 1.0), title, note
        note = translate("Ortho", "max {:.3g} mm").format(most) + look.chosen
        return values, ColourScale(0.0, most, unit="mm"), translate("Ortho", "Displacement"), note
    return None, None, "", ""


def _axial(feature: Any, look: Look, members: int) -> FloatArray:
    """(M,) largest axial force along each member, kN; of all combinations where it is used most."""
    forces = check_combination.forces(feature, look.combination, members)
    if not look.chosen or forces is None:
        return np.array(feature.AxialForces)
    along = forces[:, :, 0]
    return np.take_along_axis(along, np.abs(along).argmax(axis=1)[:, None], axis=1)[:, 0]
