"""A net as a sum of terms: what must vanish, and what guides the way there."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from solver.analysis.measures import (
    area,
    edge_ratio,
    flipped,
    sharpest_crease,
    smoothness,
    thickness,
)
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.terms.base import Term, follows
from solver.tuning import Tuning

# What every term has.
_TERM = ("name", "unknowns", "linear", "size", "linearise")
# A measure sees the mesh in model units and the shared scalars.
Judgement = Callable[[QuadMesh, FloatArray], FloatArray]
Detail = float | list[float]


def of_mesh(measure: Callable[..., FloatArray], **settings: object) -> Judgement:
    """Turn a measure of the bare mesh into one that a problem can use."""
    return lambda mesh, scalars: measure(mesh, **settings)


def place_of(term: Term, index: int) -> str:
    """Name the face, edge or vertex to which an element of a term belongs."""
    if hasattr(term, "faces"):
        return f"face {index}"
    if hasattr(term, "edges"):
        return "edge {} - {}".format(*term.edges[index])
    for name in ("stars", "vertices", "pairs", "centres"):
        if hasattr(term, name):
            return f"vertex {int(np.ravel(getattr(term, name)[index])[0])}"
    return f"element {index}"


@dataclass(frozen=True)
class Guide:
    """A term that shapes the path and fades to zero, so that it does not disturb the result.

    Attributes:
        weight: factor of its energy at the start, where an attempt has no other.
        lasting: it does not fade; for one-sided terms that are silent on a sound result.
    """

    term: Term
    weight: float
    lasting: bool = False


@dataclass
class Problem:
    """What the solver is asked: a start, free unknowns, constraints and guides.

    Unknowns are dimensionless: vertices are measured from ``centre`` in units of ``scale``, the
    mean edge of the start mesh, so that millimetres and metres take the same steps.

    Args:
        net: name of the net.
        mesh: the start, in model units.
        fixed: (V,) true for vertices that must not move; they are eliminated.
        supports: (V,) true for vertices that carry what a net is loaded with, by default the fixed
            ones; others may slide.
        may_flatten: whether a plane is a shape as good as any other.
        may_resize: whether the size of the surface is not what was drawn: sheets and what is
            dragged.
        tuning: the numbers of the solver.
        exempt: how many faces, in diagonal variants vertices, lie at singular vertices and are not
            asked for right angles.
    """

    net: str
    mesh: QuadMesh
    fixed: BoolArray
    constraints: list[Term] = field(default_factory=list)
    guides: list[Guide] = field(default_factory=list)
    measures: dict[str, Judgement] = field(default_factory=dict)
    details: dict[str, Callable[[QuadMesh, FloatArray], Detail]] = field(default_factory=dict)
    may_flatten: bool = False
    may_resize: bool = False
    tuning: Tuning = field(default_factory=Tuning)
    places: dict[str, Callable[[int], str]] = field(default_factory=dict)
    exempt: int = 0
    supports: BoolArray | None = None

    def __post_init__(self) -> None:
        used = self.mesh.connectivity.referenced
        self.scale = self.mesh.mean_edge
        self.centre = self.mesh.vertices[used].mean(axis=0)
        self.start: FloatArray = ((self.mesh.vertices - self.centre) / self.scale).ravel()
        self.free: BoolArray = np.repeat(used & ~self.fixed, 3)

    @property
    def supported(self) -> BoolArray:
        """(V,) true for vertices that carry loads."""
        return self.fixed if self.supports is None else self.supports

    def scalars(self, values: FloatArray) -> IntArray:
        """Add unknowns that elements share; return their positions in the flat vector."""
        first = len(self.start)
        self.start = np.append(self.start, values)
        self.free = np.append(self.free, np.ones(len(values), dtype=bool))
        return np.arange(first, len(self.start))

    def scalar(self, value: float) -> int:
        """Add one unknown that many elements share; return its position in the flat vector."""
        return int(self.scalars(np.array([value]))[0])

    def require(
        self,
        term: Term,
        measure: Judgement | None = None,
        place: Callable[[int], str] | None = None,
    ) -> Problem:
        """Add a term that has to vanish, and the measure by which that is judged.

        By default that is the size of the term's own residuals. Terms that share a name are judged
        by one measure, the last given. ``place`` names the face, edge or vertex to which an entry
        of the measure belongs; by default the term's own.

        Raises:
            InputError: it is no term.
        """
        missing = [word for word in _TERM if not hasattr(term, word)]
        if missing:
            kind = type(term).__name__
            raise InputError(f"term: {kind} has no {', '.join(missing)}; see solver.Term")
        self.constraints.append(term)
        self.measures[term.name] = measure or self._own_residual(term.name)
        self.places[term.name] = place or (lambda index: self._place(term.name, index))
        return self

    def _place(self, name: str, index: int) -> str:
        for term in self.constraints:
            if term.name == name:
                if index < len(term.unknowns):
                    return place_of(term, index)
                index -= len(term.unknowns)
        return f"element {index}"

    def _own_residual(self, name: str) -> Judgement:
        """Measure by the residuals of the constraints with a name, looked up afresh.

        They are as the solver sees them, lengths in mean edges of the start.
        """

        def measure(mesh: QuadMesh, scalars: FloatArray) -> FloatArray:
            points = ((mesh.vertices - self.centre) / self.scale).ravel()
            x = np.concatenate([points, scalars])
            parts = []
            for term in self.constraints:
                if term.name == name:
                    fresh = term.follow(x) if follows(term) else term
                    parts.append(np.linalg.norm(fresh.linearise(x).residual, axis=1))
            return np.concatenate(parts)

        return measure

    def guide(self, term: Term, weight: float) -> Problem:
        """Add a term that fades; a weight of zero leaves it out."""
        if weight > 0:
            self.guides.append(Guide(term, weight))
        return self

    def retarget(self, term: Term) -> int:
        """Put a term in the place of the guide of that name; return the guide's number.

        The stencil must be the same, so that the equations need not be laid out anew.

        Raises:
            KeyError: there is no such guide.
        """
        for k, guide in enumerate(self.guides):
            if guide.term.name == term.name:
                self.guides[k] = replace(guide, term=term)
                return k
        raise KeyError(term.name)

    @property
    def terms(self) -> list[Term]:
        """Constraints, then the terms of all guides."""
        return [*self.constraints, *(guide.term for guide in self.guides)]

    def at(self, mesh: QuadMesh) -> FloatArray:
        """The flat vector of the vertices of a mesh and the scalars of the start."""
        x = self.start.copy()
        x[: 3 * len(mesh.vertices)] = ((mesh.vertices - self.centre) / self.scale).ravel()
        return x

    def mesh_at(self, x: FloatArray) -> QuadMesh:
        """Mesh in model units at ``x``; vertices that are not free keep every bit."""
        count = self.mesh.connectivity.vertex_count
        moved = self.mesh.vertices + self.scale * (x - self.start)[: 3 * count].reshape(-1, 3)
        free = self.free[: 3 * count].reshape(-1, 3)
        return self.mesh.with_vertices(np.where(free, moved, self.mesh.vertices))

    @cached_property
    def edge_ratio_start(self) -> float:
        """Shortest / mean edge of the start."""
        return edge_ratio(self.mesh)

    @cached_property
    def thickness_start(self) -> float:
        """Smallest extent of the start over its largest."""
        return thickness(self.mesh)

    @cached_property
    def crease_start(self) -> float:
        """Sharpest angle between neighbouring faces of the start, degrees."""
        return sharpest_crease(self.mesh)

    @cached_property
    def area_start(self) -> float:
        """Area of the start, in model units."""
        return area(self.mesh)

    @cached_property
    def smoothness_start(self) -> float:
        """How evenly the lines of the start bend."""
        return smoothness(self.mesh)

    @cached_property
    def flipped_start(self) -> int:
        """Number of folded faces of the start."""
        return int(flipped(self.mesh).sum())

    @property
    def variables(self) -> int:
        """Number of unknowns of the net as the paper counts them, auxiliary ones included."""
        return len(self.start) + sum(term.size.auxiliary for term in self.constraints)

    @property
    def equations(self) -> int:
        """Number of equations of the net as the paper counts them."""
        return sum(term.size.equations for term in self.constraints)
