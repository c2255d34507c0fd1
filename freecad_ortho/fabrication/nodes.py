"""The nodes of a structure: where they are, what meets there, and under which angles."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from freecad_ortho.fabrication.part import Part, part_names
from freecad_ortho.fabrication.site import Site
from solver.mesh.quadmesh import FloatArray, unit_rows


@dataclass(frozen=True, eq=False)
class Node:
    """A mesh vertex at which parts meet.

    Attributes:
        name: ``N0000`` is vertex 0.
        vertex: number of the mesh vertex, counted from 0.
        point: (3,) in the coordinates of the structure, mm.
        axis: (3,) unit vector that all beams share.
        parts: names of the parts at this vertex, in their order.
        neighbours: the vertices at the other ends of the edges that are built on, in their order
            around the axis, counter-clockwise seen from its tip.
        angles_deg: from each of these edges to the next, seen along the axis; 360 in all.
        slopes_deg: of each edge above the plane square to the axis.
    """

    name: str
    vertex: int
    point: FloatArray
    axis: FloatArray
    parts: tuple[str, ...]
    neighbours: tuple[int, ...]
    angles_deg: tuple[float, ...]
    slopes_deg: tuple[float, ...]


def nodes(site: Site, parts: Sequence[Part]) -> tuple[Node, ...]:
    """Describe every vertex that a part belongs to, in the order of the vertices."""
    meeting: dict[int, list[str]] = defaultdict(list)
    for part in parts:
        for vertex in part.vertices:
            meeting[vertex].append(part.name)
    names = part_names("N", len(site.mesh.vertices))
    around = _around(site)
    return tuple(
        Node(
            names[vertex],
            vertex,
            site.mesh.vertices[vertex] + site.shift,
            site.axes.directions[vertex],
            tuple(meeting[vertex]),
            *around.get(vertex, ((), (), ())),
        )
        for vertex in sorted(meeting)
    )


def _around(
    site: Site,
) -> dict[int, tuple[tuple[int, ...], tuple[float, ...], tuple[float, ...]]]:
    """Neighbours, angles between them and slopes, for each vertex of a chosen edge, in degrees."""
    edges = site.mesh.connectivity.edges[site.chosen_edges]
    vertex = np.concatenate([edges[:, 0], edges[:, 1]])
    other = np.concatenate([edges[:, 1], edges[:, 0]])
    axis = site.axes.directions[vertex]
    arm = unit_rows(site.mesh.vertices[other] - site.mesh.vertices[vertex])
    first = unit_rows(np.cross(np.eye(3)[np.abs(axis).argmin(axis=1)], axis))
    second = np.cross(axis, first)
    turn = np.arctan2(np.einsum("hk,hk->h", arm, second), np.einsum("hk,hk->h", arm, first))
    slope = np.degrees(np.arcsin(np.clip(np.einsum("hk,hk->h", arm, axis), -1, 1)))
    # From the smallest neighbour on, whatever the direction that angles are counted from.
    lowest = np.full(len(site.mesh.vertices), len(site.mesh.vertices))
    np.minimum.at(lowest, vertex, other)
    base = np.zeros(len(site.mesh.vertices))
    starts = other == lowest[vertex]
    base[vertex[starts]] = turn[starts]
    turn = np.where(starts, 0.0, (turn - base[vertex]) % (2 * np.pi))
    order = np.lexsort((turn, vertex))
    result = {}
    for group in np.split(order, np.flatnonzero(np.diff(vertex[order])) + 1):
        full = np.append(turn[group], 2 * np.pi)
        angles = np.degrees(np.diff(full))
        result[int(vertex[group[0]])] = (
            tuple(other[group].tolist()),
            tuple(angles.tolist()),
            tuple(slope[group].tolist()),
        )
    return result
