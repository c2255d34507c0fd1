"""A part to be made: its corner points, its flat pattern and its numbers."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    import cadquery

Loops = tuple[tuple[int, ...], ...]


@dataclass(frozen=True, eq=False)
class Mark:
    """A line or a text to scribe on a flat pattern.

    Attributes:
        points: (2, 2) ends of a line, or (1, 2) the middle of a text, mm.
        text: what to write, empty for a line.
        size: text height, mm.
        angle: direction of the text, degrees.
        hidden: true for a line that belongs to the far side of the plate.
    """

    points: FloatArray
    text: str = ""
    size: float = 0.0
    angle: float = 0.0
    hidden: bool = False


@dataclass(frozen=True, eq=False)
class FlatPattern:
    """The true outline of a plate in its own plane, lower left corner of its box at the origin.

    Attributes:
        outline: (N, 2) corners, counter-clockwise, mm.
        marks: what to scribe.
        label: (2,) middle of the name, inside the outline.
        label_size: text height of the name, mm.
    """

    outline: FloatArray
    marks: tuple[Mark, ...]
    label: FloatArray
    label_size: float

    @property
    def size(self) -> FloatArray:
        """(2,) width and height of the outline's box, mm."""
        return np.asarray(self.outline.max(axis=0) - self.outline.min(axis=0))

    @property
    def area(self) -> float:
        """Area inside the outline, mm2."""
        return polygon_area(self.outline)


@dataclass(frozen=True, eq=False)
class Part:
    """One beam or panel.

    Attributes:
        name: ``B0001`` is edge 0, ``P0001`` is face 0; the same name in every file.
        kind: "beam" or "panel".
        corners: (N, 3) corner points in the part's own coordinates, mm: x and y are those of the
            flat pattern, z goes across the plate.
        loops: point numbers around each planar side, counter-clockwise seen from outside.
        origin: (3,) where the origin of the part's own coordinates is, mm.
        frame: (3, 3) directions of its x, y and z, one a row.
        pattern: the flat pattern.
        length: of the flat pattern, along the beam or the panel's first side, mm.
        height: of the beam's plate, or of the panel's flat pattern across its length, mm.
        thickness: of the plate, mm.
        area: of one face of the plate, the flat pattern's outline, mm2.
        volume: from the formula, mm3.
        mass: kg.
        twist_deg: angle by which the two axes miss a common plane with the edge, 0 for panels.
        vertices: numbers of the mesh vertices it belongs to, counted from 0.
        face: number of the mesh face counted from 0, None for a beam.
    """

    name: str
    kind: str
    corners: FloatArray
    loops: Loops
    origin: FloatArray
    frame: FloatArray
    pattern: FlatPattern
    length: float
    height: float
    thickness: float
    area: float
    volume: float
    mass: float
    twist_deg: float
    vertices: tuple[int, ...]
    face: int | None = None

    @property
    def points(self) -> FloatArray:
        """(N, 3) corner points in the place where the part is built in, mm."""
        return np.asarray(self.origin + self.corners @ self.frame)

    def solid(self) -> cadquery.Solid:
        """Return the closed solid in its place, mm; built once from the corner points.

        Its own coordinates are those of the flat pattern, its location is ``origin`` and ``frame``:
        so it keeps its digits far from the model's origin, and lies flat when taken alone.
        """
        return self._solid

    @cached_property
    def _solid(self) -> cadquery.Solid:
        from freecad_ortho.fabrication.solids import placed, polyhedron_solid

        return placed(polyhedron_solid(self.corners, self.loops), self.origin, self.frame)


def part_names(letter: str, count: int) -> list[str]:
    """Names of the parts numbered 0 to count - 1: four digits, more when there are more."""
    width = max(4, len(str(count)))
    return [f"{letter}{number + 1:0{width}d}" for number in range(count)]


def polygon_area(outline: FloatArray) -> float:
    """Signed area of a polygon (N, 2), positive when counter-clockwise."""
    x, y = (outline - outline[0]).T
    return float(0.5 * (x @ np.roll(y, -1) - y @ np.roll(x, -1)))


def fitted_text_size(text: str, width: float, height: float, largest: float = 30.0) -> float:
    """Height of a single line of text that fits into a box, mm.

    A character of the plain stroke fonts that cutting software uses is at most as wide as high.
    """
    return float(min(0.8 * width / max(len(text), 1), 0.6 * height, largest))
