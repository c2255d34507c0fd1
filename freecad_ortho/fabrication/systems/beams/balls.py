"""Ball nodes: round tubes with conical ends, sleeves and bolts that are screwed into a ball.

The axes of all tubes of a node meet in the middle of its ball. A bolt sits in the end of a cone,
its head within; a hexagonal sleeve on it is pinned to it and turned by a wrench, which screws it
into the ball until the sleeve is pressed between ball and cone. Drawn back it leaves the tube its
own length, so a tube goes in between two balls that stand.

Sources: threads 1.1 bolts deep in the ball, sleeves 1.8 bolts across their corners, and balls so
large that neither holes nor sleeves meet are typical of bolted ball nodes, after JGJ 7-2010
(Technical specification for space frame structures, section 5.3), whose text was not at hand: to
be checked against the standard of the place; widths across flats: ISO 272, hexagon bars of
EN 10278.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from freecad_ortho.fabrication.bolts import LENGTHS, Bolt
from freecad_ortho.fabrication.part import part_names
from freecad_ortho.fabrication.sizes import check_size
from freecad_ortho.fabrication.systems.beams.frames import Around
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray

# Depth of threads in a ball and width of sleeves across their corners, in bolts: typical values.
_DEPTH, _ACROSS = 1.1, 1.8
# Hexagon bars by their width across flats, mm.
_FLATS = (22.0, 24.0, 27.0, 30.0, 32.0, 36.0, 41.0, 46.0, 50.0, 55.0, 60.0)
# Of a sleeve what its pin takes: its slot is the thread's depth, a pin of a quarter of the bolt
# and 4 mm long, 6 mm from both ends.
_PIN, _PLAY, _ENDS = 0.25, 4.0, 6.0
# Cones widen by at most 1 mm in this many, and have room for a head and so much behind it, mm.
_TAPER, _BEHIND = 1.0, 10.0
# Between neighbouring cones and sleeves, beside a head in its cone, and between holes, mm.
_CLEAR, _BESIDE, _WALL = 3.0, 1.0, 3.0
# Walls of cones beside a head are at least so thick where those of their tubes are, mm.
_THIN = 5.0
# Balls and cones come in steps of this, mm.
_STEP = 5.0
# Thread that runs out at the end of a hole, in pitches.
_RUN_OUT = 2.0


@dataclass(frozen=True)
class BallJoints:
    """Sizes of all balls, sleeves and cones of a structure.

    Args:
        bolt: their size.
        tube: diameter of the tubes, mm.
        wall: of the tubes, mm.
        apart: (V,) the smallest angle between two beams at each vertex, radians.
        diameter: of the balls, mm; None for as large as each has to be.

    Raises:
        InputError: a size that cannot be used, or tubes too small for the bolts.
    """

    bolt: Bolt
    tube: float
    wall: float
    apart: FloatArray
    diameter: float | None = None

    def __post_init__(self) -> None:
        if self.diameter is not None:
            check_size("hub diameter", self.diameter)
        least = self.corners + 2 * _STEP
        around = self._head + min(self.wall, _THIN)
        if self.tube < least or self.end_radius < around:
            within = max(least, 2 * around + _STEP)
            raise InputError(
                f"bolts: the cone of a tube {self.tube:g} x {self.wall:g} mm has no room for the "
                f"head of {self.bolt.name}; take smaller bolts or tubes of about {within:.0f} mm"
            )
        if self.longest > LENGTHS[-1]:
            raise InputError(f"bolts: {self.bolt.name} are too large for balls; take smaller ones")

    @property
    def flats(self) -> float:
        """Width of the sleeves across their flats, mm."""
        least = _ACROSS * self.bolt.diameter * math.cos(math.pi / 6)
        return next(flats for flats in _FLATS if flats >= least)

    @property
    def corners(self) -> float:
        """Width of the sleeves across their corners, and of the cones' small ends, mm."""
        return self.flats / math.cos(math.pi / 6)

    @property
    def sleeve(self) -> float:
        """Length of the sleeves, mm."""
        diameter = self.bolt.diameter
        needed = (_DEPTH + _PIN) * diameter + _PLAY + 2 * _ENDS
        return _STEP * math.ceil(needed / _STEP - 1e-9)

    @property
    def end(self) -> float:
        """Thickness of the end of a cone below the head of its bolt, mm."""
        return self.bolt.clamped_plate

    @property
    def cone(self) -> float:
        """Length of the cones, mm."""
        needed = max(_TAPER * (self.tube - self.corners), self.end + self.bolt.head + _BEHIND)
        return _STEP * math.ceil(needed / _STEP - 1e-9)

    @property
    def end_radius(self) -> float:
        """Of a cone outside where the head of its bolt lies, mm."""
        taper = (self.tube - self.corners) / 2 / self.cone
        return self.corners / 2 + taper * self.end

    @property
    def room(self) -> float:
        """Radius within a cone behind the head of its bolt, mm."""
        return max(self.end_radius - self.wall, self._head)

    @property
    def _head(self) -> float:
        """Radius that the head of a bolt takes in its cone, mm."""
        return self.bolt.corners / 2 + _BESIDE

    @property
    def longest(self) -> float:
        """Least length of a bolt, mm."""
        return self.end + self.sleeve + _DEPTH * self.bolt.diameter

    @property
    def length(self) -> float:
        """Of the bolts, mm."""
        return float(next(length for length in LENGTHS if length >= self.longest))

    @property
    def thread(self) -> float:
        """Depth of a bolt in its ball, mm."""
        return self.length - self.end - self.sleeve

    @property
    def depth(self) -> float:
        """Of the holes below their seats, mm."""
        return float(math.ceil(self.thread + _RUN_OUT * self.bolt.pitch))

    @property
    def setback(self) -> float:
        """From the seat on the ball to the tube, mm."""
        return self.sleeve + self.cone

    def needed(self, angle: FloatArray) -> FloatArray:
        """(N,) from the middle of a ball to its seats where two beams are so far apart, mm.

        Sleeves, cones and tubes stay apart, a wall is left between holes, and a wrench turns a
        sleeve beside the next one.

        Args:
            angle: (N,) radians.
        """
        slope = np.tan(np.minimum(angle, 3.1) / 2)
        half = self.corners / 2
        sleeves = (half + _CLEAR / 2) / slope
        tubes = (self.tube / 2 + _CLEAR / 2) / slope - self.setback
        holes = self.depth + (self.bolt.drill + _WALL) / 2 / slope
        with np.errstate(divide="ignore"):
            wrench = np.where(
                angle < np.pi / 2,
                (self.wrench + half * np.cos(angle)) / np.sin(angle) - self.sleeve / 2,
                0.0,
            )
        return np.asarray(np.max([sleeves, tubes, holes, wrench], axis=0))

    @property
    def wrench(self) -> float:
        """Free distance from the middle of a sleeve that a wrench on it takes, mm (ISO 7738)."""
        return 1.05 * self.flats + 1.0

    def seat(self, diameter: FloatArray) -> FloatArray:
        """From the middle of balls to their seats, as wide as sleeves across their corners, mm."""
        half = np.maximum(diameter / 2, self.corners / 2)
        return np.asarray(np.sqrt(half**2 - (self.corners / 2) ** 2))

    def diameters(self, seats: FloatArray) -> FloatArray:
        """Of the balls with these seats, mm; 0 where there is none."""
        return np.asarray(np.where(seats > 0, 2 * np.hypot(seats, self.corners / 2), 0.0))

    def radii(self, around: Around, count: int) -> FloatArray:
        """(V,) from the middle of each ball to its seats, mm; 0 where no beams meet.

        Raises:
            InputError: beams that come too near each other for balls of the size that is given.
        """
        met = np.zeros(count, dtype=bool)
        met[around.vertex[around.left >= 0]] = True
        needed = np.where(met, self.needed(self.apart), 0.0)
        least = 2 * np.hypot(needed, self.corners / 2)
        if self.diameter is None:
            sizes = np.ceil(least / _STEP - 1e-9) * _STEP
            return np.where(met, self.seat(sizes), 0.0)
        worst = int(np.argmax(np.where(met, least, 0.0)))
        if least[worst] > self.diameter + 1e-9:
            angle = float(np.degrees(self.apart[worst]))
            size = _STEP * math.ceil(float(least[worst]) / _STEP)
            raise InputError(
                f"hub: at {part_names('N', count)[worst]} two beams meet at {angle:.1f} degrees, "
                f"where {self.bolt.name} and tubes of {self.tube:g} mm need a ball of {size:g} mm, "
                f"not {self.diameter:g}; take that, smaller bolts or thinner tubes"
            )
        return np.where(met, self.seat(np.full(count, self.diameter)), 0.0)


def smallest_angles(along: FloatArray, edges: IntArray, built: BoolArray, count: int) -> FloatArray:
    """(V,) the smallest angle between two edges at each vertex, radians; pi where none meet.

    Args:
        along: (E, 3) their directions.
        edges: (E, 2) their vertices.
        built: (E,) which of them count.
        count: V.
    """
    chosen = edges[built]
    vertex = chosen.T.ravel()
    arms = np.concatenate([along[built], -along[built]])
    order = np.argsort(vertex, kind="stable")
    vertex, arms = vertex[order], arms[order]
    apart = np.full(count, np.pi)
    for step in range(1, int(np.bincount(vertex, minlength=1).max(initial=1))):
        same = vertex[step:] == vertex[:-step]
        cosine = np.einsum("nk,nk->n", arms[step:], arms[:-step])
        np.minimum.at(apart, vertex[step:][same], np.arccos(np.clip(cosine[same], -1, 1)))
    return apart
