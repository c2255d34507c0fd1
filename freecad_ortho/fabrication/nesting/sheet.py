"""A sheet and what lies on it."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

import numpy as np

from freecad_ortho.fabrication.pattern import FlatPattern, polygon_area
from solver.mesh.quadmesh import FloatArray


@dataclass(frozen=True, eq=False)
class Placement:
    """A flat pattern on a sheet: turned about its origin, then moved.

    Attributes:
        name: of the part.
        pattern: in its own coordinates, mm.
        angle_deg: counter-clockwise.
        shift: (2,) mm.
    """

    name: str
    pattern: FlatPattern
    angle_deg: float
    shift: FloatArray

    @property
    def outline(self) -> FloatArray:
        """(N, 2) the outline on the sheet, mm."""
        return self.on_sheet(self.pattern.outline)

    def on_sheet(self, points: FloatArray) -> FloatArray:
        """Bring points (N, 2) of the pattern onto the sheet."""
        return turned(points, self.angle_deg) + self.shift


@dataclass(frozen=True, eq=False)
class Sheet:
    """One sheet, its lower left corner at the origin.

    Attributes:
        name: ``sheet-001``; the name of its file begins with it.
        width: mm.
        height: mm.
        thickness: of the plates on it, mm.
        placements: what is cut from it.
        material: of these plates, its name.
    """

    name: str
    width: float
    height: float
    thickness: float
    placements: tuple[Placement, ...]
    material: str

    @property
    def title(self) -> str:
        """What to take from the store: ``sheet 001 steel 20 mm``."""
        return f"{self.name.replace('-', ' ')} {self.material} {self.thickness:g} mm"

    @property
    def file_name(self) -> str:
        """The same as the name of its file, ``sheet-001-steel-20mm.dxf``."""
        return drawing_name(self.name, self.material, self.thickness)

    @property
    def used(self) -> float:
        """Area inside the outlines, mm2."""
        return sum(polygon_area(placement.pattern.outline) for placement in self.placements)

    @property
    def waste(self) -> float:
        """Part of the sheet outside of the outlines, 0 to 1."""
        return 1 - self.used / (self.width * self.height)


def drawing_name(name: str, material: str, thickness: float, *more: str) -> str:
    """Name of a file that says what its parts are cut from: ``sheet-001-steel-20mm.dxf``."""
    return file_words(name, material, f"{thickness:g}mm", *more) + ".dxf"


def file_words(*words: str) -> str:
    """Words joined to a name that every file system takes."""
    return "-".join(re.sub(r"[^\w.]+", "-", word) for word in words if word)


def turned(points: FloatArray, angle_deg: float) -> FloatArray:
    """Points (N, 2) turned about the origin; quarter turns are exact."""
    quarter, rest = divmod(angle_deg, 90.0)
    cosine, sine = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[int(quarter) % 4]
    if rest:
        cosine, sine = math.cos(math.radians(angle_deg)), math.sin(math.radians(angle_deg))
    return np.asarray(points @ np.array([[cosine, sine], [-sine, cosine]], dtype=float))
