"""Vertices at which no hub stands, as an edge beam does."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.edge_beam.geometry import EdgeGeometry
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import FloatArray

# Names of nodes that a message says.
_SHOWN = 5
# How far the corners of a hub reach, in its radius: its faces turn by little more than 90 degrees.
_CORNERS = 1.43


def without_hubs(site: Site, diameter: float | FloatArray) -> BoolArray:
    """(V,) true for the vertices where a hub would cut into an edge beam.

    ``diameter`` of all hubs or (V,) of each, mm.
    """
    edge_beam = site.geometry_of("edge-beam", EdgeGeometry)
    count = len(site.mesh.vertices)
    result = np.zeros(count, dtype=bool)
    if edge_beam is None:
        return result
    each = np.broadcast_to(diameter, count)
    for size in np.unique(each).tolist():
        near = edge_beam.near(site.mesh.vertices, site.axes.offsets, _CORNERS * size / 2)
        result |= near & (each == size)
    return result


def beside_edge_beam(site: Site, vertices: Sequence[int]) -> list[int]:
    """Of vertices without a hub those that an edge beam leaves no room for.

    On a net without a border it stands on the boundary, where no beams meet.
    """
    if site.geometry_of("edge-beam", EdgeGeometry) is None:
        return []
    on_it = site.mesh.connectivity.boundary_vertices
    return [vertex for vertex in vertices if site.trimming is not None or not on_it[vertex]]


def no_room_words(names: Sequence[str]) -> tuple[str, ...]:
    """A message where hubs are left out beside an edge beam."""
    if not names:
        return ()
    shown = ", ".join(names[:_SHOWN]) + (" ..." if len(names) > _SHOWN else "")
    return (
        f"nodes: no room for a hub beside the edge beam at {shown}, {len(names)} in all, where "
        "beams are mitred; smaller hubs or a narrower edge beam help",
    )
