"""Vertices at which no hub stands, as an edge beam does."""

from __future__ import annotations

import numpy as np

from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.edge_beam.geometry import EdgeGeometry
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import FloatArray

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
