"""End plates of beams and the hollow hubs that they are bolted to.

The hub is a hollow prism of one wall. Bolts are put in from inside and end in threads of the end
plates, so that beams of any section are bolted alike, hollow or not. A plate has one bolt in its
middle, or two above each other.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from freecad_ortho.fabrication.bolts import LENGTHS, Bolt, longest_within
from freecad_ortho.fabrication.part import part_names
from freecad_ortho.fabrication.sizes import check_size, rounded_down
from freecad_ortho.fabrication.systems.beams.frames import Around
from solver.errors import InputError
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray

# Widest angle between the normals of neighbouring faces of a hub; more faces fill wider gaps.
WIDEST = np.radians(91.0)
# Hubs measure a multiple of this across their faces, plates are as wide, mm.
_STEP = 5.0


@dataclass(frozen=True)
class EndPlates:
    """Sizes of all end plates and hubs of a structure.

    Args:
        bolt: their size.
        count: 1 or 2 a beam.
        section: width of the beams, mm.
        clearance: between hub and end plate, mm.
        diameter: of the hubs across their faces, mm; None for as large as each has to be.
        own_wall: thickness of the hubs' walls, mm; None for that of the rule.

    Raises:
        InputError: a size that cannot be used.
    """

    bolt: Bolt
    count: int
    section: float
    clearance: float
    diameter: float | None = None
    own_wall: float | None = None

    def __post_init__(self) -> None:
        if self.own_wall is not None:
            check_size("hub wall", self.own_wall)
        if self.thread < self.bolt.thread and self.own_wall is None:
            most = LENGTHS[-1] - self.bolt.washer - self.wall - self.bolt.thread
            raise InputError(
                f"clearance: {self.bolt.name} do not reach over {self.clearance:g} mm from the hub "
                f"to the end plate; take {most:g} mm at most"
            )
        if self.thread < self.bolt.thread:
            raise InputError(
                f"hub wall: of {self.bolt.name}x{self.length:g} a wall of {self.wall:g} mm leaves "
                f"{max(self.thread, 0):g} mm for the thread in the end plate, which takes "
                f"{self.bolt.thread:g} mm; take a wall of {self.bolt.clamped_plate:g} mm"
            )
        if self.diameter is not None:
            check_size("hub diameter", self.diameter)
            if self.diameter <= 2 * self.wall + self.bolt.corners:
                raise InputError(
                    f"hub diameter: {self.diameter:g} mm leave no room for a bolt {self.bolt.name} "
                    f"within walls of {self.wall:g} mm; take a larger hub or smaller bolts"
                )

    @property
    def wall(self) -> float:
        """Of the hubs, mm."""
        return self.bolt.clamped_plate if self.own_wall is None else self.own_wall

    @property
    def thickness(self) -> float:
        """Of the end plates, mm."""
        return self.bolt.threaded_plate

    @property
    def width(self) -> float:
        """Of the end plates, mm: of the beams, or what the bolts' edge distances ask for."""
        return max(self.section, _STEP * math.ceil(2 * self.bolt.edge / _STEP))

    @property
    def length(self) -> float:
        """Of the bolts, mm: they end in the plate or flush with it."""
        return longest_within(self.grip + self.thickness)

    @property
    def grip(self) -> float:
        """From the head of the bolt to the plate, mm."""
        return self.bolt.washer + self.wall + self.clearance

    @property
    def thread(self) -> float:
        """Depth of the thread in the plate, mm."""
        return self.length - self.grip

    @property
    def shims(self) -> float:
        """Between hub and end plate these bolts take so much, mm: the clearance, and more thread.

        A thread as deep as the bolt is thick is left.
        """
        return self.clearance + self.thread - self.bolt.thread

    @property
    def way_in(self) -> float:
        """How far from the wall the hub has to be free for a bolt to be put in, mm."""
        return self.bolt.head + self.length

    @property
    def taken(self) -> float:
        """What stands in from the wall where a bolt is in its place, mm."""
        return self.bolt.head + self.bolt.washer

    @property
    def setback(self) -> float:
        """From the face of the hub to the beam, mm."""
        return self.clearance + self.thickness

    def needed(self, angle: FloatArray) -> FloatArray:
        """(N,) radius of hubs where two of their beams are so far apart, mm.

        The end plates stand on their faces, a wrench turns between the walls beside a bolt, and a
        bolt passes the head of the one across.

        Args:
            angle: (N,) radians.
        """
        slope = np.tan(np.minimum(angle, WIDEST) / 2)
        faces, wrench = self.width / 2 / slope, self.wall + self.bolt.wrench / slope
        across = self.wall + (self.way_in + self.taken) / 2
        return np.asarray(np.maximum(np.maximum(faces, wrench), across))

    def radii(self, around: Around, count: int) -> FloatArray:
        """(V,) from the axis of each of the vertices to the faces of its hub, mm.

        Raises:
            InputError: beams too wide for the faces of a hub of the diameter that is given.
        """
        built = np.flatnonzero(around.left >= 0)
        angle, vertex = around.angle[built], around.vertex[built]
        if self.diameter is not None:
            self._refuse_narrow(angle, vertex, count)
            return np.full(count, self.diameter / 2)
        radii = np.zeros(count)
        np.maximum.at(radii, vertex, self.needed(angle))
        return np.asarray(np.ceil(2 * radii / _STEP - 1e-9) * _STEP / 2)

    def _refuse_narrow(self, angle: FloatArray, vertex: IntArray, count: int) -> None:
        assert self.diameter is not None
        free = self.diameter * np.tan(np.minimum(angle, WIDEST) / 2)
        worst = int(np.argmin(free))
        if free[worst] >= self.width:
            return
        name = part_names("N", count)[int(vertex[worst])]
        larger = _STEP * math.ceil(self.diameter * self.width / free[worst] / _STEP)
        narrower = (
            f"a section at most {rounded_down(float(free[worst]))} mm wide"
            if self.section >= self.width
            else "smaller bolts"
        )
        raise InputError(
            f"hub: at {name} two beams meet at {np.degrees(angle[worst]):.1f} degrees, and faces "
            f"of a hub of {self.diameter:g} mm are {free[worst]:.1f} mm wide there for end plates "
            f"of {self.width:g} mm; take {narrower}, or {larger:g} mm hub diameter"
        )
