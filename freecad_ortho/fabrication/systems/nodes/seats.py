"""Where the end plates of beams stand, and the bolts in them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.beams.end_plates import EndPlates
from freecad_ortho.fabrication.systems.beams.geometry import BeamGeometry
from solver.mesh.quadmesh import FloatArray, unit_rows

# Sign of a beam's own direction, away from the vertex at its start and at its end.
_AWAY = np.array([1.0, -1.0])


@dataclass(frozen=True, eq=False)
class Seats:
    """The end plates of all beams, (E, 2) at their starts and ends; heights are along the axes, mm.

    Attributes:
        low: lower end of the plate, from the vertex.
        high: upper end.
        out: (E, 2, 3) square to the axis, from the vertex into the beam.
        up: (E, 2, 3) along the axis.
        reach: from the axis to the beam, behind the plate.
    """

    low: FloatArray
    high: FloatArray
    out: FloatArray
    up: FloatArray
    reach: FloatArray

    def place(self, edge: int, end: int, width: float) -> tuple[FloatArray, FloatArray]:
        """Origin (3,) of a plate's coordinates from its vertex, and their directions (3, 3).

        x runs across the beam, y along the axis, z towards the hub, from the side of the beam on.
        """
        out, up = self.out[edge, end], self.up[edge, end]
        across = np.cross(up, -out)
        origin = self.reach[edge, end] * out + self.low[edge, end] * up - width / 2 * across
        return origin, np.stack([across, up, -out])


def seats(site: Site, beams: BeamGeometry, plates: EndPlates) -> Seats:
    """The plates cover their beams, but for what would stand above these or into panels."""
    slope = beams.slopes
    longer = np.sqrt(1 + slope**2)
    along, up = beams.frame[:, None, 0], beams.frame[:, None, 1]
    axis = unit_rows((slope[..., None] * along + up).reshape(-1, 3)).reshape(-1, 2, 3)
    out = _AWAY[:, None] * (along - slope[..., None] * up) / longer[..., None]
    reach = beams.hub_radii[site.mesh.connectivity.edges] + plates.setback
    top = beams.up(1)[:, None] * longer
    rise = _AWAY * slope
    bottom = (beams.up(1) - beams.height)[:, None] * longer
    lower = np.minimum(rise * reach, rise * (reach - plates.thickness))
    beside = (plates.width - 2 * beams.section_half) / 2
    drop = beside * _fall(site, beams)[:, None] * longer
    return Seats(bottom + rise * reach, top + lower - drop, out, axis, reach)


def _fall(site: Site, beams: BeamGeometry) -> FloatArray:
    """(E,) how far panels fall off from a beam's upper side, mm per mm; of two the steeper."""
    net = site.mesh.connectivity
    normals = unit_rows(site.mesh.face_area_vectors)
    fall = np.zeros(len(net.edges))
    for column, sign in ((0, -1.0), (1, 1.0)):
        face = net.edge_faces[:, column]
        normal = normals[face]
        sideways = sign * np.einsum("ek,ek->e", normal, beams.frame[:, 2])
        steep = sideways / np.einsum("ek,ek->e", normal, beams.frame[:, 1])
        fall = np.maximum(fall, np.where(face >= 0, steep, 0.0))
    return fall
