"""A cross section by its outlines, and the numbers that statics and lists need of it.

Coordinates: y to the right, z up, from the middle of the section's box. Axes are those of
EN 1993-1-1, 1.7: bending about y is that of a beam under its weight.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import TypedDict

import numpy as np

from freecad_ortho.fabrication.material import MATERIALS, Material
from freecad_ortho.fabrication.profiles.outline import Moments, Side, moments, rounded
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray


@dataclass(frozen=True, eq=False)
class Ring:
    """A closed outline: a polygon whose corners may be rounded.

    Attributes:
        corners: (n, 2) y and z, mm; counter-clockwise, those of a hole clockwise.
        radii: (n,) by which corners are rounded, mm; 0 for sharp ones.
    """

    corners: FloatArray
    radii: FloatArray

    @cached_property
    def sides(self) -> tuple[Side, ...]:
        """Straight sides and arcs, one after the other."""
        return rounded(self.corners, self.radii)

    def less_round(self) -> Ring:
        """The polygon alone, where it is one: what is round all over stays."""
        straight = any(side.centre is None for side in self.sides)
        return replace(self, radii=0 * self.radii) if straight else self


class Called(TypedDict):
    """What a profile is called and made of, beside its shape; as in :class:`Profile`."""

    name: str
    series: str
    material: str
    materials: tuple[str, ...]
    standard: str


@dataclass(frozen=True, eq=False)
class Profile:
    """A cross section; mm, mm2, mm3 and mm4.

    Attributes:
        name: as it is ordered, ``HEB160``, ``tube:100x60x5``.
        series: of the catalogue, ``HEB``, ``tube``.
        rings: the outline, and those of its holes.
        torsion: Saint-Venant's torsion constant, mm4.
        shear_area_y: to the right, mm2.
        shear_area_z: up, mm2.
        material: name of the material that it is made of where nothing else is said.
        materials: names of all that it may be made of.
        standard: where its dimensions are from.
        wall: thickness of its web or walls, mm; of solid ones their width.
    """

    name: str
    series: str
    rings: tuple[Ring, ...]
    torsion: float
    shear_area_y: float
    shear_area_z: float
    material: str
    materials: tuple[str, ...]
    standard: str
    wall: float

    @property
    def rectangular(self) -> bool:
        """Whether all its outlines are upright rectangles, with corners that may be rounded."""
        corners = [np.round(ring.corners, 6) for ring in self.rings]
        return all(
            len(points) == 4 and all(len(np.unique(along)) == 2 for along in points.T)
            for points in corners
        )

    @cached_property
    def sides(self) -> tuple[Side, ...]:
        """Of all rings."""
        return tuple(side for ring in self.rings for side in ring.sides)

    @cached_property
    def _about_box(self) -> Moments:
        return moments(self.sides)

    @cached_property
    def box(self) -> FloatArray:
        """(2, 2) least and largest y and z, mm."""
        corners = self.rings[0].corners
        return np.array([corners.min(axis=0), corners.max(axis=0)])

    @property
    def width(self) -> float:
        """Overall, mm."""
        return float(np.ptp(self.box[:, 0]))

    @property
    def height(self) -> float:
        """Overall, mm."""
        return float(np.ptp(self.box[:, 1]))

    @property
    def area(self) -> float:
        """Of the section, mm2."""
        return self._about_box.area

    @property
    def centroid(self) -> tuple[float, float]:
        """Its y and z from the middle of the box, mm."""
        return self._about_box.y / self.area, self._about_box.z / self.area

    @property
    def inertia_y(self) -> float:
        """Second moment of area about y through the centroid: for loads that act down, mm4."""
        return self._about_box.zz - self.area * self.centroid[1] ** 2

    @property
    def inertia_z(self) -> float:
        """About z through the centroid: for loads from the side, mm4."""
        return self._about_box.yy - self.area * self.centroid[0] ** 2

    @property
    def inertia_yz(self) -> float:
        """Product moment about the centroid, mm4; 0 where one axis is one of symmetry."""
        product = self._about_box.yz - self.area * self.centroid[0] * self.centroid[1]
        noise = 1e-12 * (self.inertia_y + self.inertia_z)
        return 0.0 if abs(product) <= noise else product

    @property
    def modulus_y(self) -> float:
        """Elastic modulus for bending about y, of the further edge, mm3."""
        return self.inertia_y / float(np.abs(self.box[:, 1] - self.centroid[1]).max())

    @property
    def modulus_z(self) -> float:
        """Elastic modulus for bending about z, of the further edge, mm3."""
        return self.inertia_z / float(np.abs(self.box[:, 0] - self.centroid[0]).max())

    @property
    def perimeter(self) -> float:
        """Length of the outer outline, mm: what is painted."""
        return sum(
            float(np.linalg.norm(side.end - side.start))
            if side.centre is None
            else side.radius * abs(side.sweep)
            for side in self.rings[0].sides
        )

    def mass_per_metre(self, material: Material) -> float:
        """kg/m of this section in a material."""
        return material.mass(1000.0 * self.area)

    def less_round(self) -> Profile:
        """The same without roundings of corners and roots; round tubes stay."""
        return replace(self, rings=tuple(ring.less_round() for ring in self.rings))

    def made_of(self, chosen: Material) -> Material:
        """The chosen material, or the section's own in place of plain steel.

        Raises:
            InputError: a material that the section is not made of.
        """
        if not self.materials or chosen.name in self.materials:
            return chosen
        if chosen.name == "steel":
            usual, own = MATERIALS["steel"], MATERIALS[self.material]
            same = chosen.density == usual.density
            return own if same else replace(own, density=chosen.density)
        raise InputError(
            f"section: {self.name} is made of {', '.join(self.materials)}, not of {chosen.name}; "
            "choose another material or section"
        )
