"""What a border leaves of a net: faces whole or in pieces, and stretches of edges.

A net that follows a surface does not follow its border: it overhangs it by up to a face. Parts are
cut by the surface that the net's axes along the border span.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from freecad_ortho.fabrication.trimming.cells import cells_of, divided, spans_of, within
from freecad_ortho.fabrication.trimming.course import CourseCrossing, Followed, course_of
from freecad_ortho.fabrication.trimming.rays import Rays, bilinear
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh

if TYPE_CHECKING:
    import shapely

# How far beyond a face, along its sides, the cuts through it are led on: plates may be wider.
_REACH = 0.25


@dataclass(frozen=True, eq=False)
class Trimming:
    """What is within a border.

    Attributes:
        whole: (F,) true for faces that are within it altogether.
        regions: by face, of those that it cuts, polygons in (u, v) that are within it; where they
            reach the face's sides they go on beyond.
        spans: by edge, what of it is within the border, from its first vertex (0) to the other (1).
        crossings: by edge, where the border crosses it.
        missed: length of the border that the net does not reach, mm.
        lines: the border.
    """

    whole: BoolArray
    regions: dict[int, tuple[shapely.Polygon, ...]]
    spans: dict[int, tuple[tuple[float, float], ...]]
    crossings: dict[int, list[CourseCrossing]]
    missed: float
    lines: tuple[Followed, ...]

    @classmethod
    def of(cls, mesh: QuadMesh, offsets: FloatArray, border: Sequence[FloatArray]) -> Trimming:
        """Trim a net.

        Args:
            mesh: the net.
            offsets: (V, 3) of a parallel mesh: the axes.
            border: closed polylines (N, 3) near it.

        Raises:
            InputError: a border that is far from the net or leaves nothing of it.
        """
        course = course_of(mesh, Rays.of(mesh, offsets), border)
        cells = cells_of(len(mesh.faces), course)
        kept = within(mesh, course, cells)
        if not kept.any():
            raise InputError("border: it leaves nothing of the net; leave it out")
        whole = np.zeros(len(mesh.faces), dtype=bool)
        pieces: dict[int, list[tuple[shapely.Polygon, bool]]] = {}
        for cell, inside in zip(cells, kept.tolist(), strict=True):
            if cell.polygon is None:
                whole[cell.face] = inside
            else:
                pieces.setdefault(cell.face, []).append((cell.polygon, inside))
        regions = {
            face: _regions(some, course.chords[face])
            for face, some in pieces.items()
            if any(inside for _, inside in some)
        }
        inside = [cell for cell, inside in zip(cells, kept.tolist(), strict=True) if inside]
        spans = spans_of(mesh.connectivity, inside)
        missed = sum(miss.length for miss in course.beyond)
        return cls(whole, regions, spans, course.crossings, missed, tuple(course.lines))

    @property
    def made(self) -> BoolArray:
        """(F,) true for faces of which anything is within the border."""
        made = self.whole.copy()
        made[list(self.regions)] = True
        return made

    def vertices(self, edges: IntArray) -> BoolArray:
        """(V,) true for the vertices of edges (E, 2) that are within the border."""
        within = np.zeros(int(edges.max()) + 1, dtype=bool)
        for edge, spans in self.spans.items():
            first, second = edges[edge]
            within[first] |= spans[0][0] <= 0.0
            within[second] |= spans[-1][1] >= 1.0
        return within

    def along(self, edge: int, place: float) -> FloatArray | None:
        """(3,) direction of the border where it cuts an edge at a place; None where unknown."""
        near = min(
            self.crossings.get(edge, ()), key=lambda one: abs(one.place - place), default=None
        )
        return None if near is None else near.along

    def flat_regions(self, face: int, corners: FloatArray) -> list[shapely.Polygon]:
        """The regions of a face between its corners (4, 2) in a plane, mm; the largest first."""
        import shapely

        # Points that all but coincide may change places on the way into the plane.
        mapped = [
            shapely.make_valid(shapely.transform(region, lambda uv: bilinear(corners, uv)))
            for region in self.regions[face]
        ]
        parts = [part for region in mapped for part in shapely.get_parts(region)]
        found = [part for part in parts if part.geom_type == "Polygon"]
        return sorted(found, key=lambda region: -region.area)


def _regions(
    cells: Sequence[tuple[shapely.Polygon, bool]], chords: Sequence[FloatArray]
) -> tuple[shapely.Polygon, ...]:
    """Of the cells of a face those that are kept, with what goes on from them beyond its sides."""
    import shapely

    parts: list[list[shapely.Polygon]] = [[] for _ in cells]
    for part in divided(chords, _REACH):
        shared = [part.intersection(cell).area for cell, _ in cells]
        if max(shared) > 0:
            parts[int(np.argmax(shared))].append(part)
    kept = [some for some, (_, inside) in zip(parts, cells, strict=True) if inside and some]
    joined = [shapely.get_parts(shapely.unary_union(some)) for some in kept]
    return tuple(max(some, key=lambda part: part.area) for some in joined)
