"""Loads and force densities of a net that carries itself."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_array

from solver.errors import InputError
from solver.linear.least_squares import smallest_solution, solution_above
from solver.mesh.connectivity import BoolArray, Connectivity, IntArray
from solver.mesh.quadmesh import FloatArray

# Least force density, in mean loads by mean edge, of an edge whose force must have a sign.
_LEAST = 1e-3


@dataclass(frozen=True, eq=False)
class VerticalLoads:
    """Vertical loads in multiples of the mean load at the start, downwards.

    Args:
        connectivity: the net.
        scale: one over the mean load at the start.
        per_vertex: load of each vertex.
        per_area: load of a unit of surface, a quarter of each face to each corner.
        per_length: weight of a unit of edge, half of each edge to each end.
    """

    connectivity: Connectivity
    per_vertex: float = 0.0
    per_area: float = 0.0
    per_length: float = 0.0
    scale: float = 1.0

    def at(self, x: FloatArray) -> FloatArray:
        """(V,) loads for the shape in the flat vector ``x``."""
        net = self.connectivity
        count = net.vertex_count
        points = x[: 3 * count].reshape(-1, 3)
        load = np.full(count, float(self.per_vertex))
        if self.per_area:
            a, b, c, d = (points[net.faces[:, k]] for k in range(4))
            area = 0.5 * np.linalg.norm(np.cross(c - a, d - b), axis=1)
            load += self.per_area * np.bincount(
                net.faces.ravel(), np.repeat(0.25 * area, 4), minlength=count
            )
        if self.per_length:
            ends = points[net.edges]
            length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
            load += self.per_length * np.bincount(
                net.edges.ravel(), np.repeat(0.5 * length, 2), minlength=count
            )
        return np.asarray(self.scale * load)


def refuse_mechanisms(net: Connectivity, supports: BoolArray) -> None:
    """Refuse supports (V,) that leave a component fewer than three supported vertices.

    Raises:
        InputError: naming the component with the fewest.
    """
    corners = np.zeros((int(net.components.max()) + 1, net.vertex_count), dtype=bool)
    corners[np.repeat(net.components, 4), net.faces.ravel()] = True
    standing = (corners & supports).sum(axis=1)
    if (standing < 3).any():
        part = int(np.argmin(standing))
        raise InputError(
            f"supports: component {part} has {standing[part]} supported vertices and would be a "
            "mechanism; support at least three vertices of each component"
        )


def start_densities(
    net: Connectivity, points: FloatArray, load: FloatArray, supports: BoolArray, sign: int
) -> FloatArray:
    """(E,) force densities that balance the loads on the given shape as well as possible.

    Zero in edges between two supports: whatever they carry, nothing else is loaded by it.

    Args:
        net: the net.
        points: (V, 3) positions.
        load: (V,) loads downwards.
        supports: (V,) true where a vertex is supported.
        sign: 0 for any force, -1 for compression only, 1 for tension only.
    """
    busy = ~supports[net.edges].all(axis=1)
    matrix, right = equilibrium_system(net, points, load, supports)
    matrix = matrix[:, busy]
    densities = np.zeros(len(net.edges))
    densities[busy] = smallest_solution(matrix, right)
    if sign and not (sign * densities[busy] >= _LEAST).all():
        densities[busy] = sign * solution_above(sign * matrix, right, _LEAST)
    return densities


def equilibrium_system(
    net: Connectivity, points: FloatArray, load: FloatArray, supports: BoolArray
) -> tuple[csr_array, FloatArray]:
    """Linear equations for the force densities: three a free vertex, one unknown an edge.

    Args:
        net: the net.
        points: (V, 3) positions.
        load: (V,) loads downwards.
        supports: (V,) true where a vertex is supported.
    """
    first, second = net.edges.T
    span = points[first] - points[second]
    edge = np.arange(len(first))
    free = ~supports & net.referenced
    row_of = np.where(free, np.cumsum(free) - 1, -1)
    rows, columns, values = [], [], []
    for end, direction in ((first, span), (second, -span)):
        keep = free[end]
        for c in range(3):
            rows.append(3 * row_of[end[keep]] + c)
            columns.append(edge[keep])
            values.append(direction[keep, c])
    count = int(free.sum())
    matrix = csr_array(
        (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))),
        shape=(3 * count, len(edge)),
    )
    right = np.zeros(3 * count)
    right[2::3] = -load[free]
    return matrix, right


def unbalanced(
    net: Connectivity, points: FloatArray, densities: FloatArray, load: FloatArray, free: IntArray
) -> FloatArray:
    """(n,) length of the force that is left at each of the ``free`` vertices / mean load."""
    first, second = net.edges.T
    pull = densities[:, None] * (points[first] - points[second])
    count = net.vertex_count
    force = np.stack(
        [
            np.bincount(first, pull[:, c], count) - np.bincount(second, pull[:, c], count)
            for c in range(3)
        ],
        axis=1,
    )
    force[:, 2] += load
    return np.asarray(np.linalg.norm(force[free], axis=1) / np.abs(load[free]).mean())
