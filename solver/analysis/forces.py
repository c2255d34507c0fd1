"""Forces in the edges of a net under equal loads, as far as its shape can carry them."""

from __future__ import annotations

import numpy as np

from solver.linear.least_squares import smallest_solution
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.statics import equilibrium_system, refuse_mechanisms


def force_densities(mesh: QuadMesh, supports: BoolArray | None = None) -> FloatArray:
    """(E,) force densities in 1 / unit that balance a unit load down at each free vertex best.

    Of all that are equally good the smallest: a net that is in equilibrium is balanced exactly.

    Args:
        mesh: the net.
        supports: (V,) true where a vertex is held; the boundary when not given.

    Raises:
        InputError: a component stands on fewer than three supports.
    """
    net = mesh.connectivity
    held = net.boundary_vertices if supports is None else supports
    refuse_mechanisms(net, held)
    # At edges of length one, so that a model in mm and in m are solved alike.
    points = mesh.vertices / mesh.mean_edge
    matrix, right = equilibrium_system(net, points, np.ones(len(points)), held)
    return smallest_solution(matrix, right) / mesh.mean_edge


def edge_forces(mesh: QuadMesh, supports: BoolArray | None = None) -> FloatArray:
    """(E,) force in each edge in multiples of the load of a vertex, positive for tension.

    Raises:
        InputError: a component stands on fewer than three supports.
    """
    return force_densities(mesh, supports) * mesh.edge_lengths
