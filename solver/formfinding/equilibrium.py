"""Equilibrium under tension and loads: one linear solve, iterated where forces follow the shape."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from scipy.sparse import coo_array, csr_array
from scipy.sparse.csgraph import connected_components
from scipy.sparse.linalg import splu

from solver.errors import InputError
from solver.formfinding.forces import Tension, VertexLoads
from solver.formfinding.mixing import Mixing
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.local_origin import LocalOrigin
from solver.mesh.mirror import size_of
from solver.mesh.quadmesh import FloatArray, QuadMesh, refuse_other

# A shape of which a vertex is farther away than this many times its size has no equilibrium.
_BLOWN_UP = 1e2


@dataclass(frozen=True, eq=False)
class FormFound:
    """A shape in equilibrium.

    Attributes:
        mesh: the shape; connectivity as before.
        links: (K, 2) vertices of what pulls (edges, for cables).
        densities: (K,) their force densities.
        forces: (V, 3) loads.
        reactions: (V, 3) forces of the supports, zero elsewhere.
        unbalanced: largest force left at a free vertex, in the directions that its tension settles
            / mean force in a link.
        iterations: linear solves.
        converged: whether ``unbalanced`` is below the tolerance.
        message: what happened, and what to do where it did not converge.
    """

    mesh: QuadMesh
    links: IntArray
    densities: FloatArray
    forces: FloatArray
    reactions: FloatArray
    unbalanced: float
    iterations: int = 0
    converged: bool = False
    message: str = ""


@dataclass(frozen=True, eq=False)
class _State:
    """A shape, the forces that are left where they matter, and the directions that matter."""

    found: FormFound
    left: FloatArray
    freedom: FloatArray | None


def find_form(
    mesh: QuadMesh,
    supports: BoolArray,
    tension: Tension,
    loads: VertexLoads | None = None,
    *,
    tolerance: float = 1e-10,
    max_iterations: int = 500,
    callback: Callable[[int, float], bool | None] | None = None,
) -> FormFound:
    """Move all vertices that are not supported into equilibrium.

    At every free vertex i: ``sum_j q_ij (x_j - x_i) + p_i = 0``. With fixed densities q and loads p
    this is one linear system; where they follow the shape it is solved again until it holds. A mesh
    that is far from the origin is worked on about a local origin.

    Args:
        mesh: start; for fixed densities and loads only its supports' positions matter.
        supports: (V,) true where a vertex is held.
        tension: a :class:`CableNet` or a :class:`Membrane`.
        loads: loads in the unit of density x length; none by default.
        tolerance: on the largest unbalanced force / mean force in a link.
        max_iterations: of linear solves.
        callback: called with iteration and unbalanced force; returning true stops.

    Raises:
        InputError: no support, no free vertex, or a part that no tension holds.
    """
    refuse_other(mesh)
    origin = LocalOrigin.of_mesh(mesh)
    found = _found(
        origin.near_mesh(mesh),
        supports,
        tension,
        VertexLoads() if loads is None else loads,
        tolerance,
        max_iterations,
        callback,
    )
    return replace(found, mesh=origin.back_mesh(found.mesh))


def _found(
    mesh: QuadMesh,
    supports: BoolArray,
    tension: Tension,
    loads: VertexLoads,
    tolerance: float,
    max_iterations: int,
    callback: Callable[[int, float], bool | None] | None,
) -> FormFound:
    held = np.asarray(supports, dtype=bool) | ~mesh.connectivity.referenced
    _check(mesh, held, tension)
    size, linear = size_of(mesh.vertices), tension.linear and not loads.follow
    state = _state(mesh, held, tension, loads)
    mixing = Mixing()
    iteration = 0
    while iteration < max_iterations:
        iteration += 1
        solved = _solve(state, held)
        if solved is not None and not linear:
            solved = mixing(state.found.mesh.vertices, solved)
        if solved is None or np.abs(solved - mesh.vertices).max() > _BLOWN_UP * size:
            return _ended(state, iteration, False, _lost(linear))
        state = _state(mesh.with_vertices(solved), held, tension, loads)
        stop = callback is not None and callback(iteration, state.found.unbalanced)
        if linear or state.found.unbalanced <= tolerance or stop:
            break
    # A linear solve is as good as its matrix lets it be.
    if state.found.unbalanced <= (max(tolerance, 1e-8) if linear else tolerance):
        return _ended(state, iteration, True, "in equilibrium")
    words = (
        f"unbalanced by {state.found.unbalanced:.1e} after {iteration} solves; start closer to the "
        "shape, lower the load or allow more iterations"
    )
    return _ended(state, iteration, False, words)


def _ended(state: _State, iterations: int, converged: bool, message: str) -> FormFound:
    s = state.found
    return FormFound(
        s.mesh, s.links, s.densities, s.forces, s.reactions, s.unbalanced,
        iterations, converged, message,
    )  # fmt: skip


def _lost(linear: bool) -> str:
    if linear:
        return "no equilibrium: tension and compression cancel; change the densities"
    return "no equilibrium near: the shape runs away; lower the load or raise the tension"


def _check(mesh: QuadMesh, held: BoolArray, tension: Tension) -> None:
    if held.shape != (len(mesh.vertices),):
        raise InputError(f"supports: expected {len(mesh.vertices)} flags, got shape {held.shape}")
    if held.all():
        raise InputError("supports: every vertex is held; free some")
    links, densities = tension.links(mesh)
    pulling = links[densities != 0]
    graph = coo_array((np.ones(len(pulling)), pulling.T), shape=(len(held),) * 2)
    label = connected_components(graph, directed=False)[1]
    loose = ~np.isin(label, label[held & mesh.connectivity.referenced]) & ~held
    if loose.any():
        raise InputError(
            f"supports: {int(loose.sum())} vertices hang on no support, the first is vertex "
            f"{int(np.argmax(loose))}; hold a vertex of that part or give its edges a density"
        )


def _laplacian(count: int, links: IntArray, densities: FloatArray) -> csr_array:
    one, two = links.T
    rows = np.concatenate([one, two, one, two])
    columns = np.concatenate([two, one, one, two])
    values = np.concatenate([-densities, -densities, densities, densities])
    return csr_array(coo_array((values, (rows, columns)), shape=(count, count)))


def _solve(state: _State, held: BoolArray) -> FloatArray | None:
    """(V, 3) positions after one solve with the state's densities and loads; None if singular.

    The step d solves L d = f, f what is left of the forces in the directions that matter, and is
    taken in these directions alone: so it vanishes exactly where f does.
    """
    matrix = _laplacian(len(held), state.found.links, state.found.densities)
    free = np.flatnonzero(~held)
    try:
        factor = splu(
            matrix[free][:, free].tocsc(),
            permc_spec="MMD_AT_PLUS_A",
            options={"SymmetricMode": True},
        )
    except RuntimeError:
        return None
    step = np.zeros_like(state.found.mesh.vertices)
    step[free] = factor.solve(np.ascontiguousarray(state.left[free]))
    positions = state.found.mesh.vertices + _along(state.freedom, step)
    return positions if np.isfinite(positions).all() else None


def _along(freedom: FloatArray | None, vectors: FloatArray) -> FloatArray:
    return vectors if freedom is None else np.einsum("vxy,vy->vx", freedom, vectors)


def _state(mesh: QuadMesh, held: BoolArray, tension: Tension, loads: VertexLoads) -> _State:
    """Forces in the present shape and what is left of them."""
    links, densities = tension.links(mesh)
    forces = loads.forces(mesh)
    left = forces - _laplacian(len(held), links, densities) @ mesh.vertices
    lengths = np.linalg.norm(mesh.vertices[links[:, 1]] - mesh.vertices[links[:, 0]], axis=1)
    mean = float((np.abs(densities) * lengths).mean())
    freedom = tension.freedom(mesh)
    matters = _along(freedom, left)
    worst = float(np.linalg.norm(matters[~held], axis=1).max())
    reactions = np.where(held[:, None], -left, 0.0)
    if freedom is not None and (mesh.connectivity.boundary_vertices & ~held).any():
        # A border that moves has to take the net inside along: even it out within the surface.
        edges = mesh.connectivity.edges
        even = np.full(len(edges), 2 * float(np.abs(densities).mean()))
        pull = -(_laplacian(len(held), edges, even) @ mesh.vertices)
        matters, freedom = matters + pull - _along(freedom, pull), None
    found = FormFound(mesh, links, densities, forces, reactions, worst / max(mean, 1e-300))
    return _State(found, matters, freedom)
