"""What every term offers to the solver."""

from __future__ import annotations

from typing import NamedTuple, Protocol, TypeGuard

import numpy as np

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray


class Linearisation(NamedTuple):
    """Residuals of all elements of a term and their derivatives.

    Attributes:
        residual: (n, m) dimensionless residuals, m a element.
        jacobian: (n, m, k) derivatives by the k unknowns of each element.
    """

    residual: FloatArray
    jacobian: FloatArray


class Size(NamedTuple):
    """How large a term is in the form in which the paper states it.

    Attributes:
        auxiliary: unknowns that the paper adds for it (normals, centres); eliminated here.
        equations: squared expressions that the paper sums.
    """

    auxiliary: int
    equations: int


class Term(Protocol):
    """One energy: a sum of squared residuals over small elements of the mesh.

    A term sees the unknowns as one flat vector: three coordinates a vertex, then shared scalars.
    Lengths are in mean edges of the start mesh.
    """

    @property
    def name(self) -> str:
        """Word under which reports show the residual."""

    @property
    def unknowns(self) -> IntArray:
        """(n, k) positions of each element's unknowns in the flat vector."""

    @property
    def linear(self) -> bool:
        """True where the Jacobian is constant, so that it is assembled once."""

    @property
    def size(self) -> Size:
        """Auxiliary unknowns and equations as the paper counts them."""

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return residuals and Jacobian at the flat vector ``x``."""


class FollowingTerm(Term, Protocol):
    """A term with data that depend on the current shape and are held fixed during a step."""

    def follow(self, x: FloatArray) -> Term:
        """Return the term with its data renewed at ``x``; the stencil stays the same."""


def follows(term: Term) -> TypeGuard[FollowingTerm]:
    """Whether a term has data to renew.

    Asked by name: ``isinstance`` with a protocol fails once PySide2 is loaded beside Python 3.12 or
    later.
    """
    return hasattr(term, "follow")


def coordinates_of(vertices: IntArray) -> IntArray:
    """Positions in the flat vector of the coordinates of an (n, s) array of vertices: (n, 3 s)."""
    return (3 * vertices[..., None] + np.arange(3)).reshape(len(vertices), 3 * vertices.shape[1])


def points_of(x: FloatArray, unknowns: IntArray) -> FloatArray:
    """Gather the points of each element: (n, s, 3) from the (n, 3 s) positions of coordinates."""
    return x[unknowns].reshape(len(unknowns), unknowns.shape[1] // 3, 3)


def dot(a: FloatArray, b: FloatArray) -> FloatArray:
    """Row by row scalar product of two (n, 3) arrays: (n,)."""
    return np.asarray(np.einsum("ij,ij->i", a, b))


def length(a: FloatArray) -> FloatArray:
    """Row by row length of an (n, 3) array: (n,)."""
    return np.sqrt(dot(a, a))
