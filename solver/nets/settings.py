"""What a user can set about any net, and the guides that all recipes share."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from solver.errors import InputError
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import QuadMesh
from solver.nets.net import Net
from solver.problem import Problem
from solver.terms.closeness import Closeness
from solver.terms.edge_guard import EdgeGuard
from solver.terms.edge_vectors import EdgeVectors
from solver.terms.evenness import Evenness
from solver.terms.face_guard import FaceGuard
from solver.terms.fairness import Fairness
from solver.terms.isometry import Isometry
from solver.terms.multi import multi_net

_GUARDED = 0.6
# Cosine between opposite edges of a face below which they are turned back.
_UPRIGHT = 0.3


@dataclass(frozen=True)
class Weights:
    """Start weights of the guides; all fade to zero.

    Attributes:
        fairness: straight parameter lines (w1 of the paper).
        multi: orthogonality of neighbouring pairs of faces (w2 of the paper).
        closeness: vertices stay where they started.
        evenness: parameter lines that bend evenly.
        smooth_motion: the motion, not the shape, is drawn straight.
        edge_vectors: edges keep direction and length.
        isometry: faces keep their shape (w_iso of the paper's table 2); off unless asked for.
        edge_guard: edges shorter than _GUARDED of the shortest at the start are pushed back; it
            stays to the end, where no edge is that short any more.
        face_guard: opposite edges of a face are kept within some 70 degrees of each other; it
            stays to the end, too.
    """

    fairness: float = 1e-2
    multi: float = 1e-3
    closeness: float = 3e-3
    evenness: float = 0.0
    smooth_motion: float = 1e-1
    edge_vectors: float = 2e-2
    isometry: float = 0.0
    edge_guard: float = 0.0
    face_guard: float = 0.0

    def __post_init__(self) -> None:
        for name, value in vars(self).items():
            if not np.isfinite(value) or value < 0:
                raise InputError(f"{name}: expected a weight of zero or more, got {value}")

    def ladder(self) -> list[Weights]:
        """Weights of successive attempts.

        First these; then, for meshes that fairness creases at their irregular vertices, the nearest
        net without smoothing; then, for meshes that collapse, ever more fairness.
        """
        nearest = replace(
            self,
            fairness=0.1 * self.fairness,
            closeness=10 * self.closeness,
            smooth_motion=0.0,
            edge_vectors=0.0,
        )
        fairer = replace(self, fairness=10 * self.fairness)
        fairest = replace(self, fairness=100 * self.fairness)
        guarded = replace(nearest, edge_guard=0.1)
        return [self, nearest, guarded, fairer, fairest]

    def even(self, evenness: float) -> Weights:
        """The same for nets that keep a start's noise as soon as they may: only smooth it."""
        return replace(self, evenness=evenness, smooth_motion=0.0, edge_vectors=0.0)


def add_guides(problem: Problem, attempts: Sequence[Weights]) -> Problem:
    """Add the guides that all recipes share, with their weights in each attempt."""
    net, start = problem.mesh.connectivity, problem.start
    used = np.flatnonzero(net.referenced)
    shortest = problem.edge_ratio_start
    points = start[: 3 * net.vertex_count].reshape(-1, 3)
    return (
        problem.guide(Fairness(net.line_triples), *(w.fairness for w in attempts))
        .guide(multi_net(net), *(w.multi for w in attempts))
        .guide(Closeness(used, points[used]), *(w.closeness for w in attempts))
        .guide(Evenness(net.line_quadruples), *(w.evenness for w in attempts))
        .guide(
            Fairness(net.line_triples, start, "smooth motion"),
            *(w.smooth_motion for w in attempts),
        )
        .guide(EdgeVectors(net.edges, start), *(w.edge_vectors for w in attempts))
        .guide(Isometry(net.faces, points), *(w.isometry for w in attempts))
        .guard(EdgeGuard(net.edges, _GUARDED * shortest), *(w.edge_guard for w in attempts))
        .guard(FaceGuard(net.faces, _UPRIGHT), *(w.face_guard for w in attempts))
    )


def fixed_vertices(mesh: QuadMesh, fix: str | Sequence[int], net: Net | None = None) -> BoolArray:
    """(V,) mask of the vertices that ``none``, ``corners``, ``boundary`` or numbers name.

    Corners are boundary vertices where no parameter line runs along the boundary; on a boundary
    that is one smooth loop there are none. Of a ``net`` that needs supports its own are meant where
    nothing is named.

    Raises:
        InputError: an unknown word or a number out of range.
    """
    around = mesh.connectivity
    if isinstance(fix, str):
        word = fix.strip().lower()
        if word == "none" and net is not None:
            word = net.supports
        if word == "none":
            return np.zeros(around.vertex_count, dtype=bool)
        if word == "corners":
            return _some(around.corners, "corners")
        if word == "boundary":
            return _some(around.boundary_vertices, "boundary")
        fix = _numbers(fix)
    chosen = np.asarray(list(fix), dtype=np.int64)
    wrong = chosen[(chosen < 0) | (chosen >= around.vertex_count)]
    if len(wrong):
        raise InputError(
            f"fix: vertex {wrong[0]} does not exist; vertices are numbered 0 to "
            f"{around.vertex_count - 1}"
        )
    mask = np.zeros(around.vertex_count, dtype=bool)
    mask[chosen] = True
    return mask


def _some(mask: BoolArray, word: str) -> BoolArray:
    if not mask.any():
        raise InputError(f"fix: the mesh has no {word}; name vertices by number, or use none")
    return mask.copy()


def _numbers(text: str) -> list[int]:
    try:
        return [int(word) for word in text.split(",")]
    except ValueError:
        raise InputError(
            f"fix: expected none, corners, boundary or vertex numbers such as 0,5,12, got '{text}'"
        ) from None
