"""Lamellas at the border of a surface: what is left of their lines, and where they end."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.beams.border import BorderEnds
from freecad_ortho.fabrication.systems.beams.frames import beam_frames
from freecad_ortho.fabrication.systems.lamellas.axis import Lamella
from freecad_ortho.fabrication.systems.lamellas.settings import LamellaSettings
from freecad_ortho.fabrication.systems.lamellas.splices import (
    Joint,
    piece_between,
    square_end,
)
from solver.mesh.lines import ParameterLine
from solver.mesh.quadmesh import FloatArray, unit_rows

# A crossing is at least so many thicknesses before the end of a lamella, and this far, mm.
_THICKNESSES, _BEYOND = 3.0, 5.0
# Part of its last edge that a lamella takes up at most.
_MOST = 0.95
_SHOWN = 5
# A border that runs along a lamella cuts it no more slanted than this, mm along per mm across.
_STEEPEST = 2.0


@dataclass(frozen=True, eq=False)
class Run:
    """A part of a line on which a lamella is built.

    Attributes:
        line: from the last vertex before the border to the first one after it, or to its own end.
        suffix: of the lamella's name.
        cut: whether its first and last edge end at the border.
    """

    line: ParameterLine
    suffix: str
    cut: tuple[bool, bool]


class Border:
    """The border, as lamellas see it."""

    def __init__(self, site: Site) -> None:
        self._site = site
        self._ends = BorderEnds.at_border(site, beam_frames(site.mesh, site.axes))
        self._edges = site.mesh.connectivity.edges
        self.left_out: list[str] = []
        self.trimmed = 0
        self.over = 0.0

    def runs(self, lines: Sequence[ParameterLine]) -> list[Run]:
        """What is left of lines; pieces without a vertex within the border are left out."""
        found = []
        for line in lines:
            runs = self._ends.runs(line, self._ends.within, self._edges)
            for number, run in enumerate(runs):
                ends = [(int(run.edges[k]), int(run.vertices[k])) for k in (0, -1)]
                cut = [not run.closed and self._cuts(edge, vertex) for edge, vertex in ends]
                suffix = chr(ord("a") + number) if number else ""
                if len(run.edges) < 2 and any(cut):
                    self.left_out.append(f"{line.family.upper()}{line.number:03d}{suffix}")
                else:
                    found.append(Run(run, suffix, (cut[0], cut[1])))
        return found

    def _cuts(self, edge: int, vertex: int) -> bool:
        return bool(self._ends.cut[edge, int(self._edges[edge, 1] == vertex)])

    def trim(self, lamella: Lamella, run: Run, settings: LamellaSettings) -> Lamella:
        """The lamella on a run, cut where it comes to the border."""
        if not any(run.cut):
            return lamella
        self.trimmed += 1
        joints = [
            self._joint(lamella, run, end, settings) if run.cut[end] else None for end in (0, 1)
        ]
        return piece_between(lamella, joints[0], joints[1], "", settings)

    def _joint(
        self, lamella: Lamella, run: Run, end: int, settings: LamellaSettings
    ) -> Joint | None:
        """Where an end of a lamella is cut, its whole section within the border; None nowhere."""
        edge, vertex = int(run.line.edges[-end]), int(run.line.vertices[-end])
        side = int(self._edges[edge, 1] == vertex)
        place = float(self._ends.places[edge, side])
        share = place if side else 1.0 - place
        length = float(self._site.mesh.edge_lengths[edge])
        across = settings.thickness if settings.standing else settings.width
        slanted = across / 2 * abs(float(self._ends.slant[edge, side]))
        least = _THICKNESSES * settings.thickness + _BEYOND
        wanted = share * length - slanted
        beyond = min(max(wanted, least), _MOST * length)
        self.over = max(self.over, beyond - share * length)
        face = lamella.stations[-2] if end else lamella.stations[0]
        left = float(lamella.ribbon.strip.lengths[face]) - beyond
        # Beside others at an irregular vertex it may end before the border.
        if left <= 0:
            return None
        joint = Joint(face, beyond if end else left, False)
        if settings.border_cut == "square":
            return joint
        # Of the way to the border only what the plate's thickness takes.
        slanted = settings.thickness / 2 * abs(float(self._square_to(edge, side, settings)))
        wanted = share * length - slanted
        left = float(lamella.ribbon.strip.lengths[face]) - wanted
        along = replace(joint, place=wanted if end else left)
        ruling, skew = self._ruling(lamella, along, edge, side)
        fits = skew <= _STEEPEST and wanted - settings.width / 2 * skew >= least
        if not fits or not 0 < along.place < lamella.ribbon.strip.lengths[face]:
            return joint
        return replace(along, ruling=ruling)

    def _square_to(self, edge: int, side: int, settings: LamellaSettings) -> float:
        """How far the border moves along an edge per mm of the plate's thickness."""
        both = self._ends.slant if settings.standing else self._ends.lean
        return float(both[edge, side])

    def _ruling(
        self, lamella: Lamella, joint: Joint, edge: int, side: int
    ) -> tuple[FloatArray, float]:
        """Direction (3,) in which the border cuts a strip, and how far it leaves the square cut.

        The border is the surface that the axes along it span; mm along the strip per mm across it.
        """
        site = self._site
        place = float(self._ends.places[edge, side])
        ends = site.axes.offsets[self._edges[edge]]
        axis = (1 - place) * ends[0] + place * ends[1]
        strip = lamella.ribbon.strip
        _, square = square_end(strip, joint)
        ahead = strip.along[joint.face]
        tangent = None if site.trimming is None else site.trimming.along(edge, place)
        if tangent is None:
            return square, np.inf
        normal = np.cross(tangent, axis)
        skew = float(square @ normal) / float(ahead @ normal)
        return unit_rows((square - skew * ahead)[None])[0], abs(skew)

    def words(self) -> list[str]:
        """What is to be said."""
        said = []
        if self.left_out:
            shown = ", ".join(self.left_out[:_SHOWN])
            shown += " ..." if len(self.left_out) > _SHOWN else ""
            said.append(
                f"lamellas: left out at the border what crosses no other: {shown}, "
                f"{len(self.left_out)} in all"
            )
        if self.over > 0:
            said.append(
                f"lamellas: some end up to {self.over:.3g} mm over the border, as they cross "
                "others right before it"
            )
        return said
