"""What is bought as simple solids: bolts with hexagon heads and plain shanks, and what else is."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from freecad_ortho.fabrication.bodies import Body, Prism
from freecad_ortho.fabrication.fasteners import Fasteners
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.solids import compound
from freecad_ortho.fabrication.turned import TurnedBody
from solver.mesh.quadmesh import FloatArray, unit_rows

if TYPE_CHECKING:
    import cadquery


@dataclass(frozen=True, eq=False)
class Hardware:
    """What is drawn beside the parts.

    Attributes:
        fasteners: bolts, each size one shape.
        loose: gaskets and setting blocks.
    """

    fasteners: tuple[Fasteners, ...] = ()
    loose: tuple[Part, ...] = ()


NO_HARDWARE = Hardware()
_HEXAGON = np.pi / 3 * np.arange(6)


def bolt_bodies(fasteners: Fasteners) -> tuple[Body, ...]:
    """Head, shank, washers and nut of one of them, each by itself.

    z runs from the head to the thread, 0 is under the head. Threads are as thick as the bolt.
    """
    bolt = fasteners.bolt
    head = Prism(hexagon(bolt.corners), -bolt.head, 0.0)
    shank = TurnedBody(
        np.array([(0.0, bolt.diameter / 2), (fasteners.length, bolt.diameter / 2)]),
        np.array([(0.0, 0.0), (fasteners.length, 0.0)]),
    )
    bodies: list[Body] = [head, shank]
    # Washers pass a bolt with some tenths of a millimetre (ISO 7089: 17 mm for M16).
    inner = bolt.diameter / 2 + 0.5
    for low in (0.0, fasteners.grip - bolt.washer)[: fasteners.washers]:
        high = low + bolt.washer
        ring = [(low, bolt.washer_width / 2), (high, bolt.washer_width / 2)]
        bodies.append(TurnedBody(np.array(ring), np.array([(low, inner), (high, inner)])))
    if fasteners.nut:
        low, high = fasteners.grip, fasteners.grip + bolt.nut
        bodies.append(Prism(hexagon(bolt.corners), low, high, bolt.diameter))
    return tuple(bodies)


def bolt_shape(fasteners: Fasteners) -> cadquery.Compound:
    """One of them with its washers and nut, in the coordinates of ``bolt_bodies``."""
    return compound(body.solid() for body in bolt_bodies(fasteners))


def bolt_frames(fasteners: Fasteners) -> FloatArray:
    """(N, 3, 3) directions of x, y and z of each, one a row; heads lie as they come."""
    along = fasteners.directions
    # The axis that each is least along.
    least = np.eye(3)[np.abs(along).argmin(axis=1)]
    first = unit_rows(np.cross(along, least))
    return np.stack([first, np.cross(along, first), along], axis=1)


def hexagon(corners: float) -> FloatArray:
    """(6, 2) corners of a hexagon so wide across them, mm."""
    return np.asarray(corners / 2 * np.stack([np.cos(_HEXAGON), np.sin(_HEXAGON)], axis=1))
