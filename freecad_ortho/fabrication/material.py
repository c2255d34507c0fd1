"""Materials: what a part weighs and how far it bends."""

from __future__ import annotations

from dataclasses import dataclass, replace

from freecad_ortho.fabrication.sizes import positive
from solver.errors import InputError


@dataclass(frozen=True)
class Material:
    """A material by the numbers that fabrication needs.

    Args:
        name: as the report shall call it.
        density: kg/m3.
        youngs_modulus: MPa, in the direction of bending.
        bending_limit: largest bending stress allowed, MPa.
        fold_factor: least inner radius of a cold fold, in thicknesses.

    Raises:
        InputError: a number that is not positive and finite.
    """

    name: str
    density: float
    youngs_modulus: float
    bending_limit: float
    fold_factor: float

    def __post_init__(self) -> None:
        positive("density", self.density, "kg/m3")
        positive("Young's modulus", self.youngs_modulus, "MPa")
        positive("bending limit", self.bending_limit, "MPa")
        positive("fold factor", self.fold_factor, "thicknesses")

    def mass(self, volume: float) -> float:
        """Mass of a volume in mm3, kg."""
        return volume * 1e-9 * self.density

    def bending_stress(self, thickness: float, radius: float) -> float:
        """Stress E t / (2 R) in the outer fibre of a plate bent elastically, MPa; sizes in mm."""
        return self.youngs_modulus * thickness / (2 * radius)

    def least_radius(self, thickness: float) -> float:
        """Radius at which a plate reaches the bending limit, mm."""
        return self.youngs_modulus * thickness / (2 * self.bending_limit)


# Strengths are characteristic values of common grades, without partial safety factors: structural
# steel S355 (EN 10025), aluminium EN AW-6060 T66 (EN 755), birch plywood and spruce C24 along the
# grain (EN 789, EN 338), grid shell laths of glass fibre reinforced polymer.
MATERIALS = {
    "steel": Material("steel", 7850.0, 210_000.0, 355.0, 1.0),
    "stainless": Material("stainless", 7900.0, 200_000.0, 220.0, 1.5),
    "aluminium": Material("aluminium", 2700.0, 70_000.0, 160.0, 2.0),
    "plywood": Material("plywood", 680.0, 10_000.0, 40.0, 30.0),
    "timber": Material("timber", 420.0, 11_000.0, 24.0, 60.0),
    "gfrp": Material("gfrp", 1900.0, 25_000.0, 240.0, 50.0),
}


def material(name: str = "steel", density: float | None = None) -> Material:
    """Look a material up; ``density`` in kg/m3 overrides the preset's.

    Raises:
        InputError: an unknown name or a density that cannot be used.
    """
    if name not in MATERIALS:
        raise InputError(f"material: expected one of {', '.join(MATERIALS)}, got '{name}'")
    preset = MATERIALS[name]
    return preset if density is None else replace(preset, density=density)
