"""How members stand on the net: as beams, or as the lamellas of its lines."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from freecad_ortho.fabrication.systems.lamellas.direction import pattern_on
from freecad_ortho.fabrication.systems.lamellas.settings import LamellaSettings
from solver.frame.model import Frame
from solver.mesh.lines import ParameterLines
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows
from solver.offset.axes import torsion_free_axes

BEAMS, LYING = "beams", "lying"
STANCES = (BEAMS, "standing", LYING, "tilted")


def axes_of(mesh: QuadMesh, position: str) -> FloatArray:
    """(V, 3) unit directions of the vertices that sections stand along, or lie across.

    Args:
        mesh: the net, mm.
        position: one of ``STANCES``.

    Raises:
        InputError: tilted lamellas on a net without two families of lines.
    """
    if position == BEAMS:
        return torsion_free_axes(mesh).directions
    # Lying ones lie across what standing ones stand along.
    stands = position if position != LYING else "standing"
    return pattern_on(mesh, LamellaSettings(position=stands)).axes


def heights_of(mesh: QuadMesh, axes: FloatArray, position: str) -> FloatArray:
    """(M, 3) where the heights of the members' sections point to, half way between both ends.

    Args:
        mesh: the net, whose edges are the members.
        axes: (V, 3) of its vertices.
        position: one of ``STANCES``.
    """
    ends = np.asarray(mesh.connectivity.edges)
    mean = np.asarray(axes[ends].sum(axis=1))
    if position != LYING:
        return mean
    along = mesh.vertices[ends[:, 1]] - mesh.vertices[ends[:, 0]]
    return unit_rows(np.cross(mean, along))


def bends(mesh: QuadMesh, frame: Frame) -> Iterator[tuple[int, float]]:
    """Each place where a line bends across its thickness: the member before it and 1 / radius.

    The turn of the tangent from one member to the next, across the heights of both, by the length
    between their middles.

    Args:
        mesh: the net.
        frame: its first members are on the edges of the net.
    """
    points, axes = mesh.vertices, frame.axes
    ends = np.asarray(mesh.connectivity.edges)
    length = np.linalg.norm(points[ends[:, 1]] - points[ends[:, 0]], axis=1)
    for line in ParameterLines.of(mesh).all:
        edges, vertices = line.edges, line.vertices
        if line.closed:
            vertices, edges = np.append(vertices, vertices[:2]), np.append(edges, edges[:1])
        if len(edges) < 2:
            continue
        tangent = unit_rows(np.diff(points[vertices], axis=0))
        height = axes[edges, 2]
        same = np.sign(np.einsum("ec,ec->e", height[1:], height[:-1]))[:, None]
        across = unit_rows(np.cross(height[:-1] + same * height[1:], tangent[:-1] + tangent[1:]))
        turn = np.abs(np.einsum("ec,ec->e", tangent[1:] - tangent[:-1], across))
        each = 2.0 * turn / (length[edges[1:]] + length[edges[:-1]])
        yield from zip(edges[:-1].tolist(), each.tolist(), strict=True)
