"""Vertices at which no hub stands, as an edge beam does."""

from __future__ import annotations

import numpy as np

from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.edge_beam.geometry import EdgeGeometry
from solver.mesh.connectivity import BoolArray

# How far the corners of a hub reach, in its radius: its faces turn by little more than 90 degrees.
_CORNERS = 1.43


def without_hubs(site: Site, diameter: float) -> BoolArray:
    """(V,) true for the vertices where a hub of a diameter, mm, would cut into an edge beam."""
    edge_beam = site.geometry_of("edge-beam", EdgeGeometry)
    if edge_beam is None:
        return np.zeros(len(site.mesh.vertices), dtype=bool)
    return edge_beam.near(site.mesh.vertices, site.axes.offsets, _CORNERS * diameter / 2)
