"""Cover plates that bolt the webs of beams to the arms of a welded star of plates.

An arm and its beam lie in one plane, end to end; a cover plate on each side joins them, with bolts
through all three. All cover plates of a structure are alike.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from freecad_ortho.fabrication.bolts import BOLTS, Bolt, plate_of
from freecad_ortho.fabrication.part import part_names
from freecad_ortho.fabrication.sizes import check_size
from freecad_ortho.fabrication.systems.beams.frames import Around
from solver.errors import InputError
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray

# Radii and heights are multiples of this, mm.
_STEP = 5.0
# What cover plates leave free of a web above and below: room for a weld, mm.
_MARGIN = 10.0


@dataclass(frozen=True)
class CoverPlates:
    """Sizes of all cover plates and arms of a structure.

    Args:
        wanted: size of the bolts; where webs have no room for it they are smaller, see ``bolt``.
        count: 1 or 2 on each side of a joint, above each other.
        web: thickness of the webs and arms, mm.
        section: width of the beams, mm.
        clearance: between an arm and its beam, mm.
        low: height of the lowest web, mm.
        steep: the most that an axis moves along a beam per mm up.
        diameter: of the stars, mm; None for as large as each has to be.

    Raises:
        InputError: a size that cannot be used, or webs too low for the bolts.
    """

    wanted: Bolt
    count: int
    web: float
    section: float
    clearance: float
    low: float
    steep: float
    diameter: float | None = None

    def __post_init__(self) -> None:
        if self.diameter is not None:
            check_size("hub diameter", self.diameter)
        if not self.has_room:
            fewer = "one bolt above each other or " if self.count > 1 else ""
            raise InputError(
                f"bolts: the lowest web is {self.low:.1f} mm high and takes cover plates of "
                f"{self.height:g} mm, {self.count} of {self.bolt.name}, the smallest, take "
                f"{self._column(self.bolt):.1f} mm; take {fewer}higher beams"
            )

    @cached_property
    def bolt(self) -> Bolt:
        """The largest size up to the wanted one that webs have room for, else the smallest."""
        sizes = list(BOLTS.values())
        smaller = sizes[: sizes.index(self.wanted) + 1][::-1]
        return next((size for size in smaller if self.height >= self._column(size)), smaller[-1])

    @property
    def has_room(self) -> bool:
        """Whether the webs are high enough for the bolts."""
        return self.height >= self._column(self.bolt)

    def _column(self, bolt: Bolt) -> float:
        """What bolts above each other take, mm."""
        return 2 * bolt.edge + (self.count - 1) * bolt.spacing

    @property
    def setback(self) -> float:
        """From the end of an arm to the beam, mm."""
        return self.clearance

    @property
    def height(self) -> float:
        """Of the cover plates, mm."""
        return _STEP * math.floor((self.low - 2 * _MARGIN) / _STEP)

    @property
    def thickness(self) -> float:
        """Of each of both cover plates, mm: together as thick as the web."""
        return plate_of(self.web / 2)

    @property
    def apart(self) -> float:
        """From bolt to bolt above it, mm."""
        return max(self.height / 2, self.bolt.spacing) if self.count > 1 else 0.0

    @property
    def back(self) -> float:
        """From the middle of the joint to the bolts along the beam, mm."""
        longer = math.hypot(1.0, self.steep)
        ends = (self.bolt.edge + self.clearance / 2) * longer + self.steep * self.apart / 2
        return float(math.ceil(ends))

    @property
    def half_length(self) -> float:
        """Half the length of the cover plates, mm."""
        return self.back + math.ceil(self.bolt.edge)

    @property
    def grip(self) -> float:
        """What the bolts clamp, mm."""
        return self.web + 2 * self.thickness

    @property
    def length(self) -> float:
        """Of the bolts, mm."""
        return self.bolt.through(self.grip)

    @property
    def _skew(self) -> float:
        """How far a corner of a cover plate is nearer to the axis than its middle, mm."""
        return self.steep * self.height / 2 - self.clearance / 2

    @property
    def heights(self) -> list[float]:
        """Of the bolts from the middle of the web, mm."""
        return [-self.apart / 2, self.apart / 2] if self.count > 1 else [0.0]

    def covers(self, slope: FloatArray) -> FloatArray:
        """Radii at which neither cover plates of neighbours meet nor their flanges, mm.

        Args:
            slope: tangent of half the angle between them.
        """
        plates = (self.web / 2 + self.thickness) / slope + self.half_length + self._skew
        return np.asarray(np.maximum(plates, self.section / 2 / slope))

    def wrench(self, slope: FloatArray) -> FloatArray:
        """Radii at which a wrench turns on heads and nuts beside a neighbour, mm."""
        tip = self.length - self.bolt.washer - self.grip
        out = self.web / 2 + self.thickness + max(tip, self.bolt.washer + self.bolt.head)
        return np.asarray(out / slope + self.bolt.wrench + self.back + self._skew)

    def way_in(self, slope: FloatArray) -> FloatArray:
        """Radii at which bolts are put in beside a neighbour, mm."""
        out = self.web / 2 + self.thickness + self.length + self.bolt.head
        return np.asarray(out / slope + self.bolt.corners / 2 + self.back + self._skew)

    def radii(self, around: Around, count: int) -> FloatArray:
        """(V,) from the axis of each of the vertices to the ends of its arms, mm.

        Raises:
            InputError: cover plates that meet in stars of the diameter that is given.
        """
        built = np.flatnonzero(around.left >= 0)
        left = half_slopes(around.angle[built])
        # From the beam on the right of each: its own gap is the one on its right.
        right = np.empty_like(left)
        place = np.full(len(around.left), -1)
        place[built] = np.arange(len(built))
        right[place[around.left[built]]] = left
        narrow, wide = np.minimum(left, right), np.maximum(left, right)
        vertex = around.vertex[built]
        if self.diameter is not None:
            self._refuse_meeting(narrow, vertex, count)
            return np.full(count, self.diameter / 2)
        needed = np.maximum(np.maximum(self.covers(narrow), self.wrench(narrow)), self.way_in(wide))
        radii = np.zeros(count)
        np.maximum.at(radii, vertex, needed)
        return np.asarray(np.ceil(radii / _STEP - 1e-9) * _STEP)

    def _refuse_meeting(self, slope: FloatArray, vertex: IntArray, count: int) -> None:
        assert self.diameter is not None
        needed = self.covers(slope)
        worst = int(np.argmax(needed))
        if 2 * needed[worst] <= self.diameter:
            return
        name = part_names("N", count)[int(vertex[worst])]
        angle = float(np.degrees(2 * np.arctan(slope[worst])))
        raise InputError(
            f"hub: at {name} two beams meet at {angle:.1f} degrees, where the cover plates of a "
            f"star of {self.diameter:g} mm meet; take {2 * float(needed[worst]):.0f} mm hub "
            "diameter, smaller bolts or thinner beams"
        )


def half_slopes(angle: FloatArray) -> FloatArray:
    """(N,) tangents of half of angles, radians; infinite from a straight one on."""
    return np.asarray(np.where(angle < np.pi, np.tan(np.minimum(angle, 3.0) / 2), np.inf))
