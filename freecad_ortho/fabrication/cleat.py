"""Cleats: angles folded from plate that join two plates in the corner where these cross.

The legs lie on both plates and meet in the line in which the sides of these cross: a prism along
that line, whose section has the six corners

    0, b e1, b e1 + t n1, (e1 + e2) t / sin(alpha), b e2 + t n2, b e2

with the unit vectors e along the legs, n square to them into the corner, the legs' length b, their
thickness t, and the angle alpha between them.

Where a plate runs askew to that line its leg follows it: from the inner corner of the fold on, at
t / tan(alpha / 2), the leg rises by its slope, a parallelogram as long square to the line.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from freecad_ortho.fabrication.bodies import Divided, Polyhedron, prism_sides
from freecad_ortho.fabrication.bolts import Bolt
from freecad_ortho.fabrication.drilled import Drill, DrilledWalls
from freecad_ortho.fabrication.ruled import RuledBody
from freecad_ortho.fabrication.ruled_sides import Bore
from solver.mesh.quadmesh import FloatArray, unit_rows

# Sides of a cleat with askew legs that their bolts pass: on the plates, and inside.
_ASKEW = ((6, 8), (11, 9))


@dataclass(frozen=True)
class CleatSizes:
    """What all cleats of a structure have in common; mm.

    Attributes:
        bolt: in the holes; None where no bolt of the list passes them.
        hole: diameter of the holes.
        thickness: of the legs.
        height: along the corner.
        levels: of the bolts in each leg, from its middle.
        back: from the corner to the bolts.
        reach: from the corner to the ends of the legs.
        plate: thickness of the plates that are joined.
        lift: of the bolts of one leg above the middle of the corner, and of those of the other
            below it, where one plate stands on the other.
    """

    bolt: Bolt | None
    hole: float
    thickness: float
    height: float
    levels: tuple[float, ...]
    back: float
    reach: float
    plate: float
    lift: float = 0.0

    @property
    def rim(self) -> float:
        """From the outer bolts to the nearer end of the cleat along the corner, mm."""
        return self.height / 2 - self.lift - max(self.levels)

    @property
    def beside(self) -> float:
        """How far fins on the other side of the plates reach from the middle, mm."""
        return float(np.hypot(self.reach + self.plate, self.plate + 2 * self.thickness))


@dataclass(frozen=True, eq=False)
class Leg:
    """One leg of a cleat.

    Attributes:
        part: name of the plate that it lies on.
        way: (3,) unit vector along it, from the corner.
        out: (3,) unit normal of the plate there, into the corner.
        gap: between the plate's own side and the leg, as a twisted plate leaves its plane, mm.
        side: 1 where its bolts are ``lift`` further along the corner, -1 where further back.
        slope: how far it rises along the corner per length of it, beside its fold.
    """

    part: str
    way: FloatArray
    out: FloatArray
    gap: float
    side: float = 1.0
    slope: float = 0.0


@dataclass(frozen=True, eq=False)
class Cleat:
    """A cleat in its place.

    Attributes:
        name: of the part.
        vertex: of the net.
        corner: (3,) middle of the line in which its legs meet, mm.
        up: (3,) unit vector along that line.
        legs: both; ``up``, the first and the second turn like x, y and z.
        sizes: of all cleats.
    """

    name: str
    vertex: int
    corner: FloatArray
    up: FloatArray
    legs: tuple[Leg, Leg]
    sizes: CleatSizes

    @cached_property
    def angle(self) -> float:
        """Between the legs, radians."""
        return float(np.arccos(np.clip(self.legs[0].way @ self.legs[1].way, -1, 1)))

    @property
    def frame(self) -> FloatArray:
        """(3, 3) directions of the part's own coordinates: those of its pattern, then across."""
        return np.stack([-self.legs[0].way, self.up, self.legs[0].out])

    @property
    def origin(self) -> FloatArray:
        """(3,) of these: the lower end of the first leg, on its plate."""
        sizes = self.sizes
        low = sizes.height / 2 + self.drop
        return self.corner + sizes.reach * self.legs[0].way - low * self.up

    @property
    def fold(self) -> float:
        """From the corner to where the fold's inner corner is above a leg, mm."""
        return self.sizes.thickness / float(np.tan(self.angle / 2))

    @property
    def askew(self) -> bool:
        """Whether a leg rises."""
        return any(leg.slope != 0 for leg in self.legs)

    @property
    def drop(self) -> float:
        """How far legs fall below their fold, mm."""
        return max(0.0, *(-self.rise(leg, self.sizes.reach) for leg in (0, 1)))

    def rise(self, leg: int, along: float) -> float:
        """How far a leg has risen along the corner so far from it, mm."""
        return self.legs[leg].slope * max(along - self.fold, 0.0)

    def levels(self, leg: int) -> FloatArray:
        """(N,) of the bolts of a leg along the corner, from its middle, mm."""
        return np.array(self.sizes.levels) + self.legs[leg].side * self.sizes.lift

    def bolts(self, leg: int) -> FloatArray:
        """(N, 3) where the bolts of a leg pass the side that lies on its plate."""
        sizes = self.sizes
        levels = (self.levels(leg) + self.rise(leg, sizes.back))[:, None]
        return np.asarray(self.corner + sizes.back * self.legs[leg].way + levels * self.up)

    def section(self) -> FloatArray:
        """(6, 2) corners of its section, along the first leg and off it, counter-clockwise."""
        sizes, angle = self.sizes, self.angle
        ways = np.array([[1.0, 0.0], [np.cos(angle), np.sin(angle)]])
        outs = np.array([[0.0, 1.0], [np.sin(angle), -np.cos(angle)]])
        ends = sizes.reach * ways
        inner = sizes.thickness / np.sin(angle) * ways.sum(axis=0)
        lifts = sizes.thickness * outs
        return np.array(
            [np.zeros(2), ends[0], ends[0] + lifts[0], inner, ends[1] + lifts[1], ends[1]]
        )

    @property
    def developed(self) -> float:
        """Length of a leg along its middle, from the fold, mm."""
        return self.sizes.reach - self.sizes.thickness / 2 / float(np.tan(self.angle / 2))

    def body(self) -> DrilledWalls:
        """Its body in its own coordinates, computed from corner points."""
        sizes = self.sizes
        # The sides after both ends begin at each corner: on the plates 0 and 5, inside 2 and 3.
        whole, bored = (self._askew(), _ASKEW) if self.askew else (self._even(), ((2, 4), (7, 5)))
        drills, bores = [], []
        for leg, sides in enumerate(bored):
            out = self.frame @ self.legs[leg].out
            for place in (self.bolts(leg) - self.origin) @ self.frame.T:
                lift = sizes.thickness * out
                drills.append(Drill(place + lift / 2, out, sizes.hole, sizes.thickness))
                bores.append(Bore(place, place + lift, sizes.hole, sides))
        solid = RuledBody(whole.corners, whole.loops, bores=tuple(bores))
        return DrilledWalls(whole, solid, tuple(drills))

    def _even(self) -> Divided:
        """Without its holes: a prism along the corner."""
        sizes, section = self.sizes, self.section()
        along, off = np.tile(section, (2, 1)).T
        corners = np.column_stack([sizes.reach - along, np.repeat([0.0, sizes.height], 6), off])
        blocks = tuple(
            Polyhedron(corners[[*ring, *(k + 6 for k in ring)]], prism_sides(4))
            for ring in ((0, 1, 2, 3), (0, 3, 4, 5))
        )
        return Divided(corners, prism_sides(6), blocks)

    def _askew(self) -> Divided:
        """Without its holes: a prism about the fold, and legs that rise from it."""
        sizes, angle, fold = self.sizes, self.angle, self.fold
        outer, first, over, inner, above, second = self.section()
        starts = fold * np.array([[1.0, 0.0], [np.cos(angle), np.sin(angle)]])
        ring = np.array([outer, starts[0], first, over, inner, above, second, starts[1]])
        rises = np.zeros(8)
        rises[[2, 3]], rises[[5, 6]] = (self.rise(leg, sizes.reach) for leg in (0, 1))
        along, off = np.tile(ring, (2, 1)).T
        up = np.tile(rises + self.drop, 2) + np.repeat([0.0, sizes.height], 8)
        corners = np.column_stack([sizes.reach - along, up, off])
        ends = ((0, 1, 4, 7), (1, 2, 3, 4), (4, 5, 6, 7))
        blocks = tuple(
            Polyhedron(corners[[*end, *(k + 8 for k in end)]], prism_sides(4)) for end in ends
        )
        loops = [tuple(k + 8 for k in end) for end in ends]
        loops += [tuple(reversed(end)) for end in ends]
        loops += [(0, 1, 2, 10, 9, 8), (2, 3, 11, 10), (3, 4, 12, 11)]
        loops += [(4, 5, 13, 12), (5, 6, 14, 13), (6, 7, 0, 8, 15, 14)]
        return Divided(corners, tuple(loops), blocks)


@dataclass(frozen=True, eq=False)
class OnCleats:
    """Plates that are joined by cleats, for what is built below them.

    Attributes:
        cleats: by their vertices.
        around: by vertices on feet (N, 3) points that the plates beside them lie within, mm.
    """

    cleats: Mapping[int, Cleat]
    around: Mapping[int, FloatArray]


def corner_of(
    points: tuple[FloatArray, FloatArray], normals: tuple[FloatArray, FloatArray], near: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Where two planes cross: the point (3,) of their line nearest to one, and its direction (3,).

    Args:
        points: one of each plane.
        normals: of both, unit vectors that are not parallel.
        near: (3,) the point.
    """
    along = unit_rows(np.cross(*normals)[None])[0]
    rows = np.stack([*normals, along])
    levels = np.array([normals[0] @ points[0], normals[1] @ points[1], along @ near])
    return np.linalg.solve(rows, levels), along
