"""Bodies of plates with any outline: what is not convex is known as triangles that fill it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from freecad_ortho.fabrication.bodies import Body, Divided, Polyhedron, Prism, prism_sides
from freecad_ortho.fabrication.pattern import polygon_area
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    import cadquery

# Area, as a part of the square of the outline's size, up to which three corners lie on a line.
_STRAIGHT = 1e-12


@dataclass(frozen=True, eq=False)
class Pierced(Body):
    """A plate with openings, which the clash check fills.

    Attributes:
        whole: the plate without them; x and y in its plane, from z = 0 to its thickness.
        cutouts: polygons (M, 2), square through the plate.
        thickness: of the plate, mm.
    """

    whole: Polyhedron
    cutouts: tuple[FloatArray, ...]
    thickness: float

    @property
    def points(self) -> FloatArray:
        """Those of the whole plate."""
        return self.whole.points

    @property
    def volume(self) -> float:
        """That of the whole plate less its openings."""
        area = sum(abs(polygon_area(cutout)) for cutout in self.cutouts)
        return self.whole.volume - area * self.thickness

    def solid(self) -> cadquery.Solid:
        """Build the closed solid."""
        prisms = [Prism(cutout, 0.0, self.thickness).solid() for cutout in self.cutouts]
        solid: cadquery.Solid = self.whole.solid().cut(*prisms).Solids()[0]
        return solid

    def pieces(self) -> tuple[Polyhedron, ...]:
        """Those of the whole plate."""
        return self.whole.pieces()


def plate_body(
    under: FloatArray, over: FloatArray, thickness: float, cutouts: tuple[FloatArray, ...] = ()
) -> Polyhedron | Pierced:
    """The body of a plate from z = 0 up.

    Args:
        under: (N, 2) its lower outline, counter-clockwise, mm.
        over: (N, 2) its upper one, with sides parallel to those.
        thickness: of the plate, mm.
        cutouts: openings (M, 2) within both.
    """
    count = len(under)
    levels = np.repeat([0.0, thickness], count)
    corners = np.column_stack([np.concatenate([under, over]), levels])
    whole = Polyhedron(corners, prism_sides(count))
    if not _convex(under):
        blocks = [
            Polyhedron(corners[np.r_[triangle, triangle + count]], prism_sides(3))
            for triangle in triangles_in(under)
        ]
        whole = Divided(corners, whole.loops, tuple(blocks))
    return Pierced(whole, cutouts, thickness) if cutouts else whole


def triangles_in(polygon: FloatArray) -> IntArray:
    """(N - 2, 3) corners of triangles that fill a counter-clockwise polygon (N, 2): its ears."""
    left, found = list(range(len(polygon))), []
    while len(left) > 3:
        ring = polygon[left]
        ear = _ear(ring)
        found.append([left[ear - 1], left[ear], left[(ear + 1) % len(left)]])
        del left[ear]
    return np.array([*found, left])


def _ear(ring: FloatArray) -> int:
    """The corner of a polygon (N, 2) to cut off: of those whose triangle is free the best formed.

    Corners on a straight line go last, so that no triangle is left without area.
    """
    before, after = np.roll(ring, 1, axis=0), np.roll(ring, -1, axis=0)
    area = _cross(ring - before, after - ring)
    sides = [np.linalg.norm(one - other, axis=1) for one, other in ((ring, before), (after, ring))]
    shape = area / np.maximum(sides[0] ** 2 + sides[1] ** 2, np.finfo(float).tiny)
    free = np.array([_is_free(ring, corner) for corner in range(len(ring))])
    return int(np.where(free & (area > 0), shape, -np.inf).argmax())


def _is_free(ring: FloatArray, corner: int) -> bool:
    """Whether no other corner lies in the triangle of a corner and its neighbours."""
    count = len(ring)
    numbers = [corner - 1, corner, (corner + 1) % count]
    triangle = ring[numbers]
    others = np.delete(ring, [number % count for number in numbers], axis=0)
    sides = np.roll(triangle, -1, axis=0) - triangle
    inside = _cross(sides[:, None], others[None] - triangle[:, None]) >= 0
    return not inside.all(axis=0).any()


def _convex(polygon: FloatArray) -> bool:
    step = np.roll(polygon, -1, axis=0) - polygon
    turns = _cross(step, np.roll(step, -1, axis=0))
    flat: BoolArray = turns >= -_STRAIGHT * float((np.ptp(polygon, axis=0) ** 2).sum())
    return bool(flat.all())


def _cross(one: FloatArray, other: FloatArray) -> FloatArray:
    return np.asarray(one[..., 0] * other[..., 1] - one[..., 1] * other[..., 0])
