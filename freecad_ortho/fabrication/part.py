"""A part to be made: its body, its place, its flat pattern and its numbers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from freecad_ortho.fabrication.bodies import Body
from freecad_ortho.fabrication.material import Material
from freecad_ortho.fabrication.pattern import FlatPattern
from freecad_ortho.fabrication.solids import placed, solid_from_bytes
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    import cadquery


@dataclass(frozen=True)
class Measures:
    """How true a part is; None where a measure has no meaning for it.

    Attributes:
        gap_mm: distance of the geometry from what a plane or developable part can follow.
        twist_deg: angle by which a beam's two axes miss a common plane with its edge.
        straightness_mm: largest distance of the unrolled axis from a straight line.
        radius_mm: of the arc that the unrolled axis is meant to follow.
        radius_spread_mm: largest distance of the unrolled axis from that arc.
        min_bend_radius_mm: smallest radius to which the plate is bent.
        stress_MPa: bending stress at that radius; filled in by the structure.
        shear_MPa: shear stress where the plate is twisted most, beyond what its bends turn it.
        combined_MPa: of both, von Mises; filled in by the structure.
        lean_deg: largest angle between the part's upright and the surface normal.
        torsion_deg_per_m: largest torsion along the part.
        misfit_mm: how far lower sides of beams of one constant section lie apart at its nodes.
        warp_mm: how far the fourth corner of a panel that is bent cold is off the others' plane.
        cold_MPa: stress that this leaves in it.
        bend_use_percent: of what its material may take of that for long.
        bearing_mm: least width that a panel lies on beams; negative where it ends beside them.
    """

    gap_mm: float | None = None
    twist_deg: float | None = None
    straightness_mm: float | None = None
    radius_mm: float | None = None
    radius_spread_mm: float | None = None
    min_bend_radius_mm: float | None = None
    stress_MPa: float | None = None
    shear_MPa: float | None = None
    combined_MPa: float | None = None
    lean_deg: float | None = None
    torsion_deg_per_m: float | None = None
    bearing_mm: float | None = None
    misfit_mm: float | None = None
    warp_mm: float | None = None
    cold_MPa: float | None = None
    bend_use_percent: float | None = None


def measure_words(field: str) -> tuple[str, str]:
    """Name and unit of a measure from its field name: ``torsion_deg_per_m`` is torsion, deg/m."""
    name, _, over = field.partition("_per_")
    name, _, unit = name.rpartition("_")
    return name.replace("_", " "), f"{unit}/{over}" if over else unit


class _Built:
    """The solid of a part, once it is built; it cannot leave its process."""

    def __init__(self) -> None:
        self.solid: cadquery.Solid | None = None

    def __reduce__(self) -> tuple[type[_Built], tuple[()]]:
        return _Built, ()


@dataclass(frozen=True, eq=False)
class Part:
    """One beam, lamella, panel, node ...

    Attributes:
        name: depends on the connectivity only (``B0000`` is edge 0, ``P0000`` is face 0); the same
            name in every file.
        kind: what it is, in one word: "beam", "panel" ...
        body: in the part's own coordinates, mm; where there is a flat pattern, x and y are those of
            the pattern and z goes across the plate.
        origin: (3,) where the origin of the part's own coordinates is, mm.
        frame: (3, 3) directions of its x, y and z, one a row.
        pattern: the flat pattern, None for parts that are not cut from a plate.
        length: along the part, mm; of a flat pattern, the box's first side.
        width: across the length, mm: the height of a beam's plate, a panel's second side.
        thickness: of the plate, mm.
        area: of one face of the plate, the flat pattern's outline, mm2.
        volume: from the formula, mm3.
        material: what it is made of.
        vertices: numbers of the mesh vertices it belongs to, counted from 0.
        face: number of the mesh face counted from 0, None where it belongs to none.
        family: "u" or "v" of the parameter line it lies on, "" for none.
        line: number of that line in its family, counted from 0, None for none.
        measures: how true it is.
        curved: its pattern is cut curved where others of its kind are straight or arcs: how far
            it is from these is measured, but no limit.
        assembly: in one clause what keeps it from being put together, "" where nothing does.
        note: how to cut a part that has no flat pattern, in words.
        height: of the section where the width is not that, as the flat pattern is curved, mm.
        section_width: of a tube, across its height, mm.
        section: of the catalogue, as it is ordered, "" for all others.
        weighed: volume by which it weighs, mm3, where its solid leaves roundings of its section
            out; None for the solid's own.
    """

    name: str
    kind: str
    body: Body
    origin: FloatArray
    frame: FloatArray
    pattern: FlatPattern | None
    length: float
    width: float
    thickness: float
    area: float
    volume: float
    material: Material
    vertices: tuple[int, ...] = ()
    face: int | None = None
    family: str = ""
    line: int | None = None
    measures: Measures = Measures()
    curved: bool = False
    assembly: str = ""
    note: str = ""
    height: float | None = None
    section_width: float | None = None
    section: str = ""
    weighed: float | None = None
    _built: _Built = field(default_factory=_Built, init=False, repr=False)

    @property
    def mass(self) -> float:
        """Mass, kg."""
        return self.material.mass(self.volume if self.weighed is None else self.weighed)

    @property
    def section_height(self) -> float:
        """Height of the section, mm: of a straight plate its width."""
        return self.width if self.height is None else self.height

    @property
    def points(self) -> FloatArray:
        """(N, 3) points of the body in the place where the part is built in, mm."""
        return np.asarray(self.origin + self.body.points @ self.frame)

    def solid(self) -> cadquery.Solid:
        """Return the closed solid in its place, mm; built once.

        Its own coordinates are those of the body, its location is ``origin`` and ``frame``: so it
        keeps its digits far from the model's origin, and a plate lies flat when taken alone.
        """
        if self._built.solid is None:
            self._take(self.body.solid())
        assert self._built.solid is not None
        return self._built.solid

    def take_solid(self, data: bytes) -> None:
        """Take over the solid of the body as another process built it."""
        self._take(solid_from_bytes(data))

    @property
    def has_solid(self) -> bool:
        """True where the solid is built already."""
        return self._built.solid is not None

    def _take(self, solid: cadquery.Solid) -> None:
        self._built.solid = placed(solid, self.origin, self.frame)


def piece_name(name: str, number: int) -> str:
    """The name of one of the pieces of a part: P0012, P0012b, P0012c ..."""
    return name if number == 0 else f"{name}{chr(ord('a') + number)}"


def some_names(names: Sequence[str], shown: int | None = None) -> str:
    """Names in one line: the first so many, and how many more the report lists; else all."""
    if shown is None or len(names) <= shown:
        return ", ".join(names)
    return f"{', '.join(names[:shown])} and {len(names) - shown} more, which the report lists"


def part_names(letter: str, count: int) -> list[str]:
    """Names of the parts numbered 0 to count - 1: four digits, more when there are more.

    The number in a name is that of the edge, face or vertex in messages and lists.
    """
    width = max(4, len(str(count - 1)))
    return [f"{letter}{number:0{width}d}" for number in range(count)]
