"""Where beams are joined to the arms of stars by cover plates, and the holes in their webs."""

from __future__ import annotations

import numpy as np

from freecad_ortho.fabrication.pattern import Hole
from freecad_ortho.fabrication.systems.beams.cover_plates import CoverPlates
from freecad_ortho.fabrication.systems.beams.geometry import BeamGeometry
from freecad_ortho.fabrication.systems.beams.sections import Section
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray

# Sign of a beam's own direction, away from the vertex at its start and at its end.
AWAY = np.array([1.0, -1.0])


def joint_middles(
    beams: BeamGeometry, section: Section, covers: CoverPlates, edges: IntArray
) -> FloatArray:
    """(E, 2, 2) the middle of the joint at each end, along the beam and up, mm.

    ``edges`` (E, 2) are the vertices at the ends.
    """
    low, high = section.web_levels(beams)
    up = (low + high)[:, None] / 2
    reach = (beams.hub_radii[edges] + covers.clearance / 2) * np.sqrt(1 + beams.slopes**2)
    starts = np.stack([0 * beams.lengths, beams.lengths], axis=1)
    along = starts + beams.slopes * up + AWAY * reach
    return np.stack([along, np.broadcast_to(up, along.shape)], axis=2)


def bolt_places(middles: FloatArray, covers: CoverPlates, side: int) -> FloatArray:
    """(E, 2, N, 2) the bolts beside the middles of joints: on the beam, 1, or on the arm, -1."""
    shift = np.array([[covers.back, height] for height in covers.heights])
    sign = np.stack([side * AWAY, np.ones(2)], axis=1)
    return np.asarray(middles[:, :, None] + sign[:, None] * shift)


def web_holes(
    beams: BeamGeometry, section: Section, edges: IntArray
) -> dict[int, tuple[Hole, ...]]:
    """By edge the holes in its web, along the beam and up; none without cover plates."""
    covers = beams.bolted
    if not isinstance(covers, CoverPlates):
        return {}
    places = bolt_places(joint_middles(beams, section, covers, edges), covers, 1)
    joined = beams.meeting & (beams.hub_radii[edges] > 0)
    return {
        edge: tuple(
            Hole(place, covers.bolt.hole)
            for end in np.flatnonzero(joined[edge])
            for place in places[edge, end]
        )
        for edge in np.flatnonzero(joined.any(axis=1)).tolist()
    }
