"""Sections of beams: plate, hollow rectangle, welded I and T; corner points without booleans.

A hollow section is one part, cut from a tube. I and T are welded from plates, each a part with a
flat pattern of its own: the web is cut like a plate beam; a flange is cut square to its own plane,
as far back as its worse side needs, so that a laser cuts it and nothing overlaps.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from freecad_ortho.fabrication.bodies import BOX_SIDES, Body, Hollow, Loops, Polyhedron
from freecad_ortho.fabrication.systems.beams.geometry import LOOPS, BeamGeometry
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray
from solver.option import one_of

# Sections with sizes of their own; all others are those of ``fabrication/profiles/catalogue.py``.
SECTIONS = ("plate", "hollow", "I", "T")


def _hollow_loops() -> Loops:
    """Outer corners 0 to 11 as in ``LOOPS``, inner ones 12 to 23 in the same order."""
    inner = 12
    sides = [LOOPS[0], LOOPS[1], LOOPS[3], LOOPS[6]]
    loops = list(sides)
    loops += [tuple(number + inner for number in reversed(side)) for side in sides]
    # Each end is two halves of a frame, which meet in the middle plane.
    for middle, side in ((0, 1), (3, 2), (3, 4), (0, 5)):
        half = (middle, side, side + 6, middle + 6)
        rim = (*half, *(number + inner for number in reversed(half)))
        loops.append(rim if (side in (1, 4)) else tuple(reversed(rim)))
    return tuple(loops)


HOLLOW_LOOPS = _hollow_loops()
# Corners and sides of the walls: below, above, on the right, on the left.
_HOLLOW_WALLS = (
    ((*range(6), *range(12, 18)), LOOPS),
    ((*range(18, 24), *range(6, 12)), LOOPS),
    ((13, 1, 2, 14, 19, 7, 8, 20), BOX_SIDES),
    ((16, 4, 5, 17, 22, 10, 11, 23), BOX_SIDES),
)


class BeamSizes(NamedTuple):
    """BeamSizes of beams, mm: see the settings of the same names."""

    height: float
    thickness: float
    section_width: float


@dataclass(frozen=True)
class Section:
    """The cross section of all beams.

    Args:
        kind: plate, hollow, I or T (flange at the top).
        thickness: of the plate, the tube's wall or the web, mm.
        width: of the tube or the flanges, mm; a plate's is its thickness.
        flange: thickness of the flanges, mm.

    Raises:
        InputError: an unknown kind, or sizes that make no section.
    """

    kind: str
    thickness: float
    width: float
    flange: float

    def __post_init__(self) -> None:
        one_of("section", self.kind, SECTIONS)
        if self.kind == "plate":
            return
        least = 2 * self.thickness if self.kind == "hollow" else self.thickness
        if self.width <= least:
            raise InputError(
                f"section width: expected more than {least:g} mm for {self.thickness:g} mm walls, "
                f"got {self.width:g}; take a wider section or thinner walls"
            )

    @property
    def overall_width(self) -> float:
        """Of everything, across the beam, mm."""
        return self.thickness if self.kind == "plate" else self.width

    @property
    def name(self) -> str:
        """As it is ordered: nothing, as it is of plates or of a tube of no one height."""
        return ""

    def size(self, height: float) -> str:
        """What a beam of this height is sawn from, in words; mm."""
        return f"tube {height:.1f} x {self.width:g} x {self.thickness:g}"

    def catalogue_name(self, height: float) -> str:
        """Name of the catalogue's section that is nearest to it at this height, mm.

        A hollow one is a hot-finished tube, which its round corners make a little weaker; welded I
        and T are polygons, without their welds.
        """
        if self.kind == "plate":
            return f"plate:{self.thickness:.9g}x{height:.9g}"
        if self.kind == "hollow":
            return f"tube:{height:.9g}x{self.width:.9g}x{self.thickness:.9g}"
        web, below = (self.width - self.thickness) / 2, height - self.flange
        left = [(0.0, height), (0.0, below), (web, below)]
        foot = [(web, self.flange), (0.0, self.flange), (0.0, 0.0)]
        left += foot if self.kind == "I" else [(web, 0.0)]
        right = [(self.width - y, z) for y, z in reversed(left)]
        return "polygon:" + " ".join(f"{y:.9g},{z:.9g}" for y, z in (*left, *right))

    def refuse_low(self, height: float) -> None:
        """Refuse beams that their walls or flanges fill.

        Raises:
            InputError: naming the least height.
        """
        filled = {"plate": 0.0, "hollow": 2 * self.thickness, "I": 2 * self.flange}
        least = filled.get(self.kind, self.flange)
        if height <= least:
            raise InputError(
                f"beam height: {height:.1f} mm is filled by the section's {least:g} mm of walls or "
                "flanges; take higher beams or thinner plates"
            )

    @property
    def flanges(self) -> tuple[float, float]:
        """Thickness of flanges below and above a web, mm."""
        return self.flange * (self.kind == "I"), self.flange * (self.kind in ("I", "T"))

    def web_levels(self, geometry: BeamGeometry) -> tuple[FloatArray, FloatArray]:
        """(E,) twice: heights of the lower and upper side of the webs in their beams, mm."""
        below, above = self.flanges
        return geometry.up(0) + below, geometry.up(1) - above

    def pieces(self, geometry: BeamGeometry) -> tuple[SectionPiece, ...]:
        """The parts that a beam of this section is made of.

        Raises:
            InputError: a beam too low for its walls.
        """
        self.refuse_low(float(geometry.height.min()))
        low, high = geometry.up(0), geometry.up(1)
        wall, half = self.thickness, self.overall_width / 2
        if self.kind == "plate":
            corners = prism(geometry, low, high, half)
            return (SectionPiece("", "plate", corners, LOOPS, wall, geometry.height),)
        if self.kind == "hollow":
            outer = prism(geometry, low, high, half)
            inner = prism(geometry, low + wall, high - wall, half - wall)
            corners = np.concatenate([outer, inner], axis=1)
            return (SectionPiece("", "tube", corners, HOLLOW_LOOPS, wall, geometry.height),)
        # What is left are I and T.
        flange = self.flange
        web_low, web_high = self.web_levels(geometry)
        web = prism(geometry, web_low, web_high, wall / 2)
        made = [SectionPiece("-web", "plate", web, LOOPS, wall, web_high - web_low)]
        width = np.full(len(low), self.width)
        top = _flange(geometry, high - flange, high, half)
        made.append(SectionPiece("-top", "flange", top, LOOPS, flange, width))
        if self.kind == "I":
            bottom = _flange(geometry, low, low + flange, half)
            made.append(SectionPiece("-bottom", "flange", bottom, LOOPS, flange, width))
        return tuple(made)


@dataclass(frozen=True, eq=False)
class SectionPiece:
    """One part of every beam, as arrays with a row an edge.

    Attributes:
        suffix: what the part's name has after the beam's.
        role: "plate" (with the flat pattern of the beam's plane), "flange" or "tube".
        corners: (E, N, 3) in the coordinates of the beam: along, up, right.
        loops: sides of the body.
        thickness: of the plate or wall, mm.
        width: (E,) of the plate or tube, mm.
    """

    suffix: str
    role: str
    corners: FloatArray
    loops: Loops
    thickness: float
    width: FloatArray

    def origin(self, edge: int) -> FloatArray:
        """Of a tube's or plate's coordinates in those of its beam: its lowest corner."""
        low = self.corners[edge][[0, 3, 9, 6]].min(axis=0)
        return np.array([low[0], low[1], 0.0])

    def body(self, edge: int, origin: FloatArray, turn: FloatArray) -> Body:
        """Body of one beam's part; ``turn`` has the part's directions in the beam's, one a row."""
        corners = (self.corners[edge] - origin) @ turn.T
        if self.role != "tube":
            return Polyhedron(corners, self.loops)
        walls = (Polyhedron(corners[list(wall)], loops) for wall, loops in _HOLLOW_WALLS)
        return Hollow(corners, self.loops, tuple(walls))

    def skin(self, edge: int) -> float:
        """Outer surface of a tube without its ends, mm2."""
        corners, total = self.corners[edge], 0.0
        for loop in ((6, 7, 8, 9, 10, 11), (0, 1, 2, 3, 4, 5), (1, 2, 8, 7), (4, 5, 11, 10)):
            side = corners[list(loop)]
            arms = side - side[0]
            total += float(np.linalg.norm(np.cross(arms[1:-1], arms[2:]).sum(axis=0))) / 2
        return total

    def weighed(self, edge: int) -> float | None:
        """Volume by which it weighs where its solid leaves something out, mm3."""
        return None

    def cut_words(self, edge: int) -> tuple[str | None, str | None]:
        """How its start and end are sawn, where that is not by the angles of the node axes."""
        return None, None


def prism(geometry: BeamGeometry, low: FloatArray, high: FloatArray, half: float) -> FloatArray:
    """(E, 12, 3) corners between two heights (E,), the ends along the axes."""
    return np.concatenate([geometry.ring(low, half), geometry.ring(high, half)], axis=1)


def _flange(geometry: BeamGeometry, low: FloatArray, high: FloatArray, half: float) -> FloatArray:
    """(E, 12, 3) the same with ends upright on the flange, within the ends along the axes."""
    corners = prism(geometry, low, high, half).reshape(-1, 2, 6, 3)
    stations = corners[..., 0]
    starts = np.array([True, True, False, False, False, True])
    inner = np.where(starts, stations.max(axis=1), stations.min(axis=1))
    corners[..., 0] = inner[:, None]
    return corners.reshape(-1, 12, 3)
