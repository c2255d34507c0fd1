"""Irregular vertices moved so that their faces do not fold.

A map has a singular vertex where the triangles have one, which may lie beside the place that the
lines around turn about, by a part of a triangle: enough to turn a corner of a face inside out.
"""

from __future__ import annotations

import numpy as np

from solver.align.triangle_mesh import TriangleMesh
from solver.analysis.measures import flipped
from solver.mesh.closest import TriangleSurface
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh

# In mean edges, how far round its neighbours' middle the surface is looked at.
_AROUND = 1.5


def unfolded(net: QuadMesh, surface: TriangleMesh) -> QuadMesh:
    """Move irregular vertices of folded faces to the middle of their neighbours, if that helps.

    Args:
        net: as it was read from a map.
        surface: onto which they are set.
    """
    folded = flipped(net)
    connected = net.connectivity
    irregular = ~connected.regular & ~connected.boundary_vertices
    wanted = np.unique(net.faces[folded])
    for vertex in wanted[irregular[wanted]].tolist():
        places = net.vertices.copy()
        middle = places[_neighbours(connected.edges, vertex)].mean(axis=0)
        places[vertex] = _foot(surface, middle, _AROUND * net.mean_edge)
        moved = net.with_vertices(places)
        left = flipped(moved)
        if left.sum() < folded.sum():
            net, folded = moved, left
    return net


def _neighbours(edges: IntArray, vertex: int) -> IntArray:
    ends = edges[(edges == vertex).any(axis=1)]
    found: IntArray = ends[ends != vertex]
    return found


def _foot(surface: TriangleMesh, place: FloatArray, reach: float) -> FloatArray:
    """The closest point of a surface that is near."""
    near = np.linalg.norm(surface.centres - place, axis=1) < reach
    if not near.any():
        return place
    foot: FloatArray = TriangleSurface(surface.points, surface.triangles[near]).closest(
        place[None]
    )[0][0]
    return foot
