"""Which unknowns an element sees, for terms on faces, edges and single vertices."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from functools import cached_property

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray
from solver.terms.base import Linearisation, Size, coordinates_of


class Elements(ABC):
    """Base of terms on elements of one kind.

    Such a term has a ``name`` and says how it is linearised. Unless it says otherwise it is not
    linear, and the paper counts one equation an element.
    """

    name: str
    linear: bool = False

    @property
    @abstractmethod
    def unknowns(self) -> IntArray:
        """(n, k) positions of each element's unknowns in the flat vector."""

    @property
    def size(self) -> Size:
        """One equation an element."""
        return Size(0, len(self.unknowns))

    @abstractmethod
    def linearise(self, x: FloatArray) -> Linearisation:
        """Return residuals and Jacobian at the flat vector ``x``."""


@dataclass(frozen=True, eq=False)
class OnFaces(Elements):
    """One element a face; ``faces`` is (n, 4)."""

    faces: IntArray

    @cached_property
    def unknowns(self) -> IntArray:
        """(n, 12) coordinates of the four corners."""
        return coordinates_of(self.faces)


@dataclass(frozen=True, eq=False)
class OnEdges(Elements):
    """One element an edge; ``edges`` is (n, 2)."""

    edges: IntArray

    @cached_property
    def unknowns(self) -> IntArray:
        """(n, 6) coordinates of both ends."""
        return coordinates_of(self.edges)


@dataclass(frozen=True, eq=False)
class OnVertices(Elements):
    """One element a vertex; ``vertices`` is (n,)."""

    vertices: IntArray

    @cached_property
    def unknowns(self) -> IntArray:
        """(n, 3) coordinates of each vertex."""
        return coordinates_of(self.vertices[:, None])
