"""A surface cut open so that its direction field can be told apart: along u, along v.

The cut runs from each singular vertex to the border and between borders; off the cut the four
directions of neighbouring triangles go over into each other without a turn.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.align.field import QUARTER, DirectionField, turns
from solver.align.triangle_mesh import TriangleMesh, spanning
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray


@dataclass(frozen=True, eq=False)
class Cut:
    """Directions that agree off a cut.

    Attributes:
        angles: (T,) of the direction of u in each triangle's frame.
        edges: (E,) whether an inner edge is cut.
        turns: (E,) by how many quarter turns coordinates of the first triangle are turned to become
            those of the second; 0 off the cut.
    """

    angles: FloatArray
    edges: BoolArray
    turns: IntArray


def cut_open(mesh: TriangleMesh, field: DirectionField) -> Cut:
    """Comb a field along a tree of triangles and keep what has to be cut."""
    turned, crossed = _combed(mesh, turns(mesh, field.angles)[0])
    angles = field.angles + turned * QUARTER
    quarters = turns(mesh, angles)[0] % 4
    edges = _pruned(mesh, ~crossed, field.quarters != 0)
    return Cut(angles, edges, np.where(edges, -quarters % 4, 0))


def _combed(mesh: TriangleMesh, quarters: IntArray) -> tuple[IntArray, BoolArray]:
    """Quarter turns (T,) of the triangles, and which edges (E,) the tree crosses."""
    turned = np.zeros(len(mesh.triangles), dtype=np.int64)
    crossed = np.zeros(len(mesh.edges), dtype=bool)
    for triangle, before, edge, forwards in spanning(mesh):
        turned[triangle] = turned[before] + (-quarters[edge] if forwards else quarters[edge])
        crossed[edge] = True
    return turned, crossed


def _pruned(mesh: TriangleMesh, edges: BoolArray, singular: BoolArray) -> BoolArray:
    """Take away branches of the cut that end where nothing is singular."""
    start, end = mesh.ends
    kept = singular | mesh.on_rim
    at: dict[int, list[int]] = {}
    for edge in np.flatnonzero(edges).tolist():
        at.setdefault(int(start[edge]), []).append(edge)
        at.setdefault(int(end[edge]), []).append(edge)
    left = {vertex: len(ends) for vertex, ends in at.items()}
    edges = edges.copy()
    loose = [vertex for vertex, count in left.items() if count == 1 and not kept[vertex]]
    while loose:
        vertex = loose.pop()
        branches = [one for one in at[vertex] if edges[one]]
        if not branches:
            continue
        edge = branches[0]
        edges[edge] = False
        other = int(end[edge] if start[edge] == vertex else start[edge])
        left[other] -= 1
        if left[other] == 1 and not kept[other]:
            loose.append(other)
    return edges
