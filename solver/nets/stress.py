"""Principal stress nets: orthogonal meshes whose edges carry the loads."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from solver.errors import InputError
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.nets.net import Easier, Net, Way
from solver.nets.options import NetOptions
from solver.nets.orthogonal import require_right_angles
from solver.problem import Problem
from solver.statics import VerticalLoads, refuse_mechanisms, start_densities, unbalanced
from solver.terms.equilibrium import Equilibrium

# Supports that lie nearer to one line, in mean edges, do not hold a net.
_LINE = 1e-3
# A start whose heights differ by less, in mean edges, is level.
_LEVEL = 1e-9
_SIGNS = {"free": 0, "compression": -1, "tension": 1}


def stress(problem: Problem, options: NetOptions) -> Problem:
    """Require equal diagonals, and balance at every vertex that is neither supported nor fixed.

    Supports may slide along curves. Loads are vertical.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, section 4.5.
    """
    net = problem.mesh.connectivity
    supports = problem.supported
    refuse_mechanisms(net, supports)
    _refuse_one_line(problem)
    free = np.flatnonzero(~supports & net.referenced)
    if not len(free):
        raise InputError("supports: every vertex is supported; leave some free to carry load")
    points = problem.start[: 3 * net.vertex_count].reshape(-1, 3)
    if np.ptp(points[net.referenced, 2]) <= _LEVEL:
        raise InputError(
            "stress: the start lies level, where no force along its edges carries a vertical load; "
            "raise its middle, or find its form first"
        )
    sign = _SIGNS[options.forces]
    loads = _loads(problem, options, free)
    density = start_densities(net, points, loads.at(problem.start), supports, sign)
    # Forces of the order of one are as easy to move as coordinates: count loads in that measure.
    unit = float(np.abs(density).mean())
    density, loads = density / unit, replace(loads, scale=loads.scale / unit)
    shared = problem.scalars(density if sign == 0 else np.sqrt(np.abs(density)))

    require_right_angles(problem, options)

    def left(mesh: QuadMesh, scalars: FloatArray) -> FloatArray:
        shape = (mesh.vertices - problem.centre) / problem.scale
        force = scalars[shared - shared[0]]
        signed = force if sign == 0 else sign * force**2
        return unbalanced(net, shape, signed, loads.at(shape.ravel()), free)

    for centres, neighbours, edges in _by_valence(problem, free):
        term = Equilibrium(centres, neighbours, shared[edges], loads, sign)
        problem.require(term, left, lambda index: f"vertex {free[index]}")
    real = 1.0 / (loads.scale * problem.scale)

    def densities(mesh: QuadMesh, scalars: FloatArray) -> FloatArray:
        force = scalars[shared - shared[0]]
        return np.asarray(real * (force if sign == 0 else sign * force**2))

    def forces(mesh: QuadMesh, scalars: FloatArray) -> FloatArray:
        return np.asarray(densities(mesh, scalars) * mesh.edge_lengths)

    problem.details["force_densities"] = lambda *found: densities(*found).tolist()
    problem.details["least_force"] = lambda *found: float(forces(*found).min())
    problem.details["largest_force"] = lambda *found: float(forces(*found).max())
    return problem


def _refuse_one_line(problem: Problem) -> None:
    """Say which component would swing around a line that holds all its supports."""
    net = problem.mesh.connectivity
    for part in range(int(net.components.max()) + 1):
        own = np.zeros(net.vertex_count, dtype=bool)
        own[net.faces[net.components == part]] = True
        held = problem.mesh.vertices[own & problem.supported]
        extents = np.linalg.svd(held - held.mean(axis=0), compute_uv=False)
        if extents[1] <= _LINE * problem.scale:
            raise InputError(
                f"supports: those of component {part} lie on one line and it would be a mechanism; "
                "support a vertex beside that line"
            )


def _loads(problem: Problem, options: NetOptions, free: IntArray) -> VerticalLoads:
    """Loads as asked, scaled so that their mean over the free vertices is one at the start."""
    raw = VerticalLoads(
        problem.mesh.connectivity,
        per_vertex=options.load,
        per_area=options.load_area * problem.scale**2,
        per_length=options.load_length * problem.scale,
    )
    if not any((raw.per_vertex, raw.per_area, raw.per_length)):
        raw = replace(raw, per_vertex=1.0)
    mean = float(raw.at(problem.start)[free].mean())
    if not mean > 0:
        raise InputError(
            f"load: the mean load is {mean:.3g}; give loads that sum to more than zero"
        )
    return replace(raw, scale=1.0 / mean)


def _by_valence(problem: Problem, free: IntArray) -> list[tuple[IntArray, IntArray, IntArray]]:
    """Centres, neighbours (n, s) and edges (n, s) of the free vertices, grouped by valence."""
    net = problem.mesh.connectivity
    count = len(net.edges)
    ends = np.concatenate([net.edges[:, 0], net.edges[:, 1]])
    others = np.concatenate([net.edges[:, 1], net.edges[:, 0]])
    edges = np.tile(np.arange(count), 2)
    order = np.argsort(ends, kind="stable")
    begins = np.searchsorted(ends[order], np.arange(net.vertex_count))
    groups = []
    for valence in np.unique(net.edge_valence[free]):
        centres = free[net.edge_valence[free] == valence]
        places = order[begins[centres][:, None] + np.arange(valence)]
        groups.append((centres, others[places], edges[places]))
    return groups


NETS = (
    Net(
        "stress",
        stress,
        place=130,
        title="principal stress: equilibrium",
        condition="equal diagonals, forces in balance at every free vertex",
        purpose="grid shells whose members carry the load without bending",
        gives="Edges along the principal stresses, in equilibrium.",
        options=("load", "load_area", "load_length", "forces", "singular"),
        supports="boundary",
        held="supports",
        begins_as="stress",
        way=Way(
            easier=(
                Easier("orthogonal", 10.0, evenness=1.0),
                Easier("orthogonal", 100.0),
                Easier("orthogonal"),
            ),
            guarded=True,
            early=True,
            righted=True,
        ),
    ),
)
