"""The flat pattern of a part: what is cut, drilled, bent and engraved, in the plane."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from solver.mesh.quadmesh import FloatArray, unit_rows

if TYPE_CHECKING:
    import shapely

# Distance, mm, below which two sides of an outline touch rather than cross.
_TOUCHING = 1e-6


@dataclass(frozen=True, eq=False)
class Mark:
    """A line or a text to engrave on a flat pattern.

    Attributes:
        points: (2, 2) ends of a line, or (1, 2) the middle of a text, mm.
        text: what to write, empty for a line.
        size: text height, mm.
        angle: direction of the text, degrees.
    """

    points: FloatArray
    text: str = ""
    size: float = 0.0
    angle: float = 0.0


@dataclass(frozen=True, eq=False)
class Hole:
    """A round hole through the plate.

    Attributes:
        centre: (2,) mm.
        diameter: mm.
    """

    centre: FloatArray
    diameter: float


@dataclass(frozen=True, eq=False)
class Bend:
    """A straight line along which the plate is bent.

    Attributes:
        points: (2, 2) ends of the line, mm.
        angle_deg: by which the two sides leave their common plane, positive when they rise towards
            the side that is seen.
        axis: (2,) where the axis crosses the line, mm, None where the part has none.
        twist_deg: by which the plate turns about its axis from this line to the next, as a
            right-handed screw; 0 where it is plane between them.
    """

    points: FloatArray
    angle_deg: float
    axis: FloatArray | None = None
    twist_deg: float = 0.0


@dataclass(frozen=True, eq=False)
class Bevel:
    """A side that leans from square to the plate.

    Attributes:
        points: (2, 2) ends of its inner line, where the plate is cut back, mm.
        angle_deg: from square, positive where it opens towards the side that is seen: its inner
            line lies there; negative where it is undercut: its inner line is on the far side.
    """

    points: FloatArray
    angle_deg: float

    @property
    def hidden(self) -> bool:
        """Whether its inner line is on the far side."""
        return self.angle_deg < 0


@dataclass(frozen=True, eq=False)
class FlatPattern:
    """The true outline of a plate in its own plane, lower left corner of its box at the origin.

    Attributes:
        outline: (N, 2) corners, counter-clockwise, mm.
        marks: what to engrave.
        label: (2,) middle of the name, inside the outline.
        label_size: text height of the name, mm.
        cutouts: closed polygons (M, 2) inside the outline, clockwise or not.
        holes: round holes.
        axis: (K, 2) the unrolled parameter line, None where there is none.
        bends: bend lines.
        label_angle: direction of the name, degrees.
        bevels: sides that are not square to the plate.
        seen: the side of the part that is seen, in a word or two.
    """

    outline: FloatArray
    marks: tuple[Mark, ...]
    label: FloatArray
    label_size: float
    cutouts: tuple[FloatArray, ...] = ()
    holes: tuple[Hole, ...] = ()
    axis: FloatArray | None = None
    bends: tuple[Bend, ...] = ()
    label_angle: float = 0.0
    bevels: tuple[Bevel, ...] = ()
    seen: str = ""

    @property
    def size(self) -> FloatArray:
        """(2,) width and height of the outline's box, mm."""
        return np.asarray(self.outline.max(axis=0) - self.outline.min(axis=0))

    @property
    def area(self) -> float:
        """Area inside the outline less cutouts and holes, mm2."""
        cut = sum(abs(polygon_area(cutout)) for cutout in self.cutouts)
        drilled = sum(np.pi * hole.diameter**2 / 4 for hole in self.holes)
        return float(polygon_area(self.outline) - cut - drilled)


def polygon_area(outline: FloatArray) -> float:
    """Signed area of a polygon (N, 2), positive when counter-clockwise."""
    x, y = (outline - outline[0]).T
    return float(0.5 * (x @ np.roll(y, -1) - y @ np.roll(x, -1)))


def overlaps_itself(polygon: FloatArray) -> bool:
    """Whether two sides of a closed polygon (N, 2) cross each other."""
    ends = np.roll(polygon, -1, axis=0)
    steps = unit_rows(ends - polygon)

    def side(points: FloatArray) -> FloatArray:
        arms = points[None] - polygon[:, None]
        distance = steps[:, None, 0] * arms[..., 1] - steps[:, None, 1] * arms[..., 0]
        return np.where(np.abs(distance) <= _TOUCHING, 0.0, np.sign(distance))

    apart = side(polygon) * side(ends) < 0
    return bool((apart & apart.T).any())


def longest_within(line: FloatArray, plate: shapely.Geometry) -> FloatArray | None:
    """The longest part of a line (2, 2) that lies on a plate; None where it is off it."""
    import shapely

    cut = shapely.LineString(line).intersection(plate)
    pieces = [piece for piece in shapely.get_parts(cut) if piece.length > 0]
    return np.array(max(pieces, key=lambda piece: piece.length).coords) if pieces else None


def fitted_text_size(text: str, width: float, height: float, largest: float = 30.0) -> float:
    """Height of a single line of text that fits into a box, mm.

    A character of the plain stroke fonts that cutting software uses is at most as wide as high.
    """
    return float(min(0.8 * width / max(len(text), 1), 0.6 * height, largest))


def texts_between(
    name: str,
    beside: Sequence[str],
    ends: tuple[float, float],
    middle: float,
    size: tuple[float, float],
) -> tuple[tuple[Mark, ...], FloatArray, float]:
    """Marks of a straight plate that say what is beside its ends; place and size of its name.

    Args:
        name: of the part.
        beside: before its start and behind its end, "" for nothing.
        ends: between which there is room, along the plate, mm.
        middle: half its height.
        size: length and height.
    """
    # A third of the clear length for the name, a quarter at each end for what is beside it.
    start, end = ends
    length, height = size
    clear, centre = max(end - start, 0.2 * length), (start + end) / 2
    marks = [
        Mark(
            np.array([[centre + sign * 0.36 * clear, middle]]),
            text,
            fitted_text_size(text, 0.24 * clear, 0.5 * height, 15.0),
        )
        for text, sign in zip(beside, (-1.0, 1.0), strict=True)
        if text
    ]
    return tuple(marks), np.array([centre, middle]), fitted_text_size(name, 0.4 * clear, height)
