"""Which unknowns an element sees, for terms on faces, edges and single vertices."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from solver.mesh.connectivity import IntArray
from solver.terms.base import coordinates_of


@dataclass(frozen=True, eq=False)
class OnFaces:
    """One element a face; ``faces`` is (n, 4)."""

    faces: IntArray

    @cached_property
    def unknowns(self) -> IntArray:
        """(n, 12) coordinates of the four corners."""
        return coordinates_of(self.faces)


@dataclass(frozen=True, eq=False)
class OnEdges:
    """One element an edge; ``edges`` is (n, 2)."""

    edges: IntArray

    @cached_property
    def unknowns(self) -> IntArray:
        """(n, 6) coordinates of both ends."""
        return coordinates_of(self.edges)


@dataclass(frozen=True, eq=False)
class OnVertices:
    """One element a vertex; ``vertices`` is (n,)."""

    vertices: IntArray

    @cached_property
    def unknowns(self) -> IntArray:
        """(n, 3) coordinates of each vertex."""
        return coordinates_of(self.vertices[:, None])
