"""Materials: what a part weighs and how far it bends."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

from freecad_ortho.fabrication.build_up import (
    GLASS_DENSITY,
    STRENGTHS,
    MaterialLayer,
    cavity,
    density_of,
    layers_of,
    pane,
    panes_of,
    thickness_of,
)
from freecad_ortho.fabrication.plate_limits import LIMITS, PlateLimits
from freecad_ortho.fabrication.sizes import positive
from solver.errors import InputError
from solver.option import unknown

# Float glass: modulus, MPa, and Poisson's ratio of EN 572-1 (EN 16612 has 0.23, which gives 2 %
# less shear).
_GLASS_MODULUS, _GLASS_POISSON = 70_000.0, 0.2
# Least bearing, mm: of glass the edge cover of DIN 18008-2 on lines; of metals and wood for want of
# a rule what leaves room for a screw's edge or a bead of glue, with tolerances.
_ON_GLASS, _ON_METAL, _ON_WOOD = 10.0, 5.0, 10.0
# Clearance of slots, mm. Typical values from practice, for want of a rule: milled aluminium is more
# exact than what is cut, and timber swells and shrinks across the grain.
_IN_ALUMINIUM, _IN_TIMBER = 0.5, 1.5
# Yield strengths of structural steels up to 40 mm, MPa: EN 1993-1-1, table 3.1.
_GRADES = {"S235": 235.0, "S275": 275.0, "S355": 355.0}
# Density of water, kg/m3.
_WATER = 1000.0
# Lighter than this no material is a metal, kg/m3.
_LIGHTEST_METAL = 2000.0
# Insulating units may be named by their panes and cavities alone, in mm (EN 1279).
_UNIT = "insulating-glass"
_UNIT_NAME = re.compile(rf"{_UNIT}((?:-\d{{1,3}}(?:\.\d{{1,2}})?)+)")
# Build-ups that a form offers to begin with; there are as many as one likes.
BUILD_UPS = ("glass:8", "glass:8+1.52+8", "glass:44.2", "glass:6/16/44.2", "glass:8t/16ar/88.4")


@dataclass(frozen=True)
class Material:
    """A material by the numbers that fabrication needs.

    Args:
        name: as the report shall call it.
        density: kg/m3; of a build-up its mass by its whole volume.
        youngs_modulus: MPa, in the direction of bending.
        bending_limit: largest bending stress allowed, MPa.
        bearing: least width that a panel lies on its beams, mm.
        layers: of a build-up, the outermost first; empty for what is solid and cut from sheets of
            any thickness.
        poisson: Poisson's ratio.
        own_shear_modulus: MPa, where it does not follow from these two, as in what has fibres.
        plate_limits: what plates of it can be made, None where nothing is known of that.
        clearance: that slots in it have beside what goes into them where none is given, mm.

    Raises:
        InputError: a number that is not positive and finite.
    """

    name: str
    density: float
    youngs_modulus: float
    bending_limit: float
    bearing: float
    layers: tuple[MaterialLayer, ...] = ()
    poisson: float = 0.3
    own_shear_modulus: float | None = None
    plate_limits: PlateLimits | None = None
    clearance: float = 1.0

    def __post_init__(self) -> None:
        positive("density", self.density, "kg/m3")
        positive("Young's modulus", self.youngs_modulus, "MPa")
        positive("bending limit", self.bending_limit, "MPa")
        positive("Poisson's ratio", self.poisson, "")
        if self.own_shear_modulus is not None:
            positive("shear modulus", self.own_shear_modulus, "MPa")
        positive("bearing", self.bearing, "mm")
        positive("clearance", self.clearance, "mm")
        for layer in self.layers:
            positive("layer", layer.thickness, "mm")

    @property
    def thickness(self) -> float | None:
        """Of a build-up, mm; None for what comes in any thickness."""
        return thickness_of(self.layers) if self.layers else None

    @property
    def stepped(self) -> bool:
        """Whether the layers of a build-up are not all of one size."""
        return any(layer.step > 0 for layer in self.layers)

    def mass(self, volume: float) -> float:
        """Mass of a volume in mm3, kg."""
        return volume * 1e-9 * self.density

    def bending_stress(self, thickness: float, radius: float) -> float:
        """Stress E t / (2 R) in the outer fibre of a plate bent elastically, MPa; sizes in mm.

        In a build-up that of its thickest pane: panes bend each by itself.
        """
        return self.youngs_modulus * self._bent(thickness) / (2 * radius)

    def least_radius(self, thickness: float) -> float:
        """Radius at which a plate reaches the bending limit, mm."""
        return self.youngs_modulus * self._bent(thickness) / (2 * self.bending_limit)

    @property
    def wood(self) -> bool:
        """Whether it is one of wood: with fibres, and lighter than water."""
        fibres = self.own_shear_modulus is not None and not self.layers
        return fibres and self.density < _WATER

    @property
    def shear_modulus(self) -> float:
        """Its own, or E / (2 (1 + Poisson's ratio)), MPa."""
        if self.own_shear_modulus is not None:
            return self.own_shear_modulus
        return self.youngs_modulus / (2 * (1 + self.poisson))

    def shear_stress(self, thickness: float, twist: float) -> float:
        """Largest shear stress G t theta' of a thin plate that is twisted elastically, MPa.

        In a build-up that of its thickest pane.

        Args:
            thickness: mm, small beside the width of the plate.
            twist: theta', radians per mm.

        Source: Timoshenko, Goodier (1951), Theory of Elasticity, section 94: narrow rectangle.
        """
        return self.shear_modulus * self._bent(thickness) * abs(twist)

    def _bent(self, thickness: float) -> float:
        panes = panes_of(self.layers)
        return max(each.thickness for each in panes) if panes else thickness


def _glass(name: str) -> Material:
    return Material(
        name,
        GLASS_DENSITY,
        _GLASS_MODULUS,
        STRENGTHS[name],
        _ON_GLASS,
        poisson=_GLASS_POISSON,
        plate_limits=LIMITS[name],
    )


def _steel(grade: str, strength: float) -> Material:
    return Material(grade, 7850.0, 210_000.0, strength, _ON_METAL)


def _timber(name: str, density: float, modulus: float, strength: float, shear: float) -> Material:
    sizes = name, density, modulus, strength, _ON_WOOD
    return Material(*sizes, own_shear_modulus=shear, clearance=_IN_TIMBER)


def build_up(name: str, layers: Sequence[MaterialLayer]) -> Material:
    """Glass in layers: as heavy as they are by its whole volume, as strong as the weakest pane.

    Panes bend each by itself: interlayers creep under what lasts, and shear is not counted on.
    """
    kinds = {each.of for each in panes_of(layers)}
    return Material(
        name,
        density_of(layers),
        _GLASS_MODULUS,
        min(STRENGTHS[kind] for kind in kinds),
        _ON_GLASS,
        tuple(layers),
        _GLASS_POISSON,
        plate_limits=LIMITS["glass"].strictest(*(LIMITS[kind] for kind in kinds)),
    )


def insulating_unit(*layers: float) -> Material:
    """An insulating glass unit of annealed panes: pane, cavity, pane ..., mm (EN 1279).

    Raises:
        InputError: a build-up that does not begin and end with a pane.
    """
    name = "-".join([_UNIT, *(f"{layer:g}" for layer in layers)])
    if len(layers) < 3 or len(layers) % 2 == 0:
        raise InputError(
            f"material: {name} is no unit of pane, cavity, pane ... in mm; write "
            f"{_UNIT}-6-16-6, or {_UNIT}-4-12-4-12-4 for three panes"
        )
    for layer in layers:
        positive("layer", layer, "mm")
    made = [cavity(size) if number % 2 else pane(size) for number, size in enumerate(layers)]
    return build_up(name, made)


# Strengths are characteristic values of common grades, without partial safety factors.
MATERIALS = {
    material.name: material
    for material in (
        # S355: EN 1993-1-1, 3.2.6 and table 3.1 up to 40 mm; weight of EN 1991-1-1, table A.4.
        Material("steel", 7850.0, 210_000.0, 355.0, _ON_METAL),
        *(_steel(grade, strength) for grade, strength in _GRADES.items()),
        # 1.4301: EN 1993-1-4, 2.1.3 and table 2.1, hot rolled plate; density of EN 10088-1.
        Material("stainless", 7900.0, 200_000.0, 210.0, _ON_METAL),
        # EN AW-6060 T66: EN 1999-1-1, 3.2.5 and table 3.2b, extruded, thicker than 3 mm.
        Material("aluminium", 2700.0, 70_000.0, 150.0, _ON_METAL, clearance=_IN_ALUMINIUM),
        # Birch, 18 mm, along its face: Handbook of Finnish Plywood (2007), after EN 789.
        Material("plywood", 680.0, 10_000.0, 40.0, _ON_WOOD, own_shear_modulus=620.0),
        # C24: EN 338, table 1, means but for the strength.
        _timber("timber", 420.0, 11_000.0, 24.0, 690.0),
        # Softwood by EN 338, table 1, glued laminated timber by EN 14080, table 5: means but for
        # the strength.
        _timber("C24", 420.0, 11_000.0, 24.0, 690.0),
        _timber("C30", 460.0, 12_000.0, 30.0, 750.0),
        _timber("GL24h", 420.0, 11_500.0, 24.0, 650.0),
        _timber("GL28h", 460.0, 12_600.0, 28.0, 650.0),
        _timber("GL30h", 480.0, 13_600.0, 30.0, 650.0),
        _timber("GL32h", 490.0, 14_200.0, 32.0, 650.0),
        # Pultruded, E23: EN 13706-3; density and shear modulus of the Fiberline Design Manual.
        Material("gfrp", 1900.0, 23_000.0, 240.0, _ON_METAL, own_shear_modulus=3_000.0),
        *(_glass(name) for name in STRENGTHS),
        insulating_unit(6, 16, 6),
        insulating_unit(4, 12, 4, 12, 4),
    )
}


def metal_for(material: Material) -> Material:
    """What is welded, folded or bolted on to join parts of a material.

    It is that itself where it is a metal, and steel for wood, glass and other light ones.
    """
    metal = material.density > _LIGHTEST_METAL and not material.layers
    return material if metal and material.plate_limits is None else MATERIALS["steel"]


def material(name: str = "steel", density: float | None = None) -> Material:
    """Look a material up, or make a build-up from its name, ``glass:6/16/44.2``.

    Args:
        name: of a preset, a build-up after ``glass:``, ``strengthened-glass:`` or
            ``toughened-glass:``, or an insulating unit such as ``insulating-glass-8-16-6``; in
            capital or small letters.
        density: kg/m3, to override the preset's.

    Raises:
        InputError: an unknown name or a density that cannot be used.
    """
    word = "".join(name.lower().split())
    made = next((known for key, known in MATERIALS.items() if key.lower() == word), None)
    glass, colon, layers = word.partition(":")
    if made is None and colon and glass in STRENGTHS:
        made = build_up(word, layers_of(layers, glass))
    unit = _UNIT_NAME.fullmatch(word)
    if made is None and unit is not None:
        made = insulating_unit(*map(float, unit[1][1:].split("-")))
    if made is None:
        also = f"a build-up such as {BUILD_UPS[1]} or {BUILD_UPS[3]}"
        raise unknown("material", name, MATERIALS, also)
    return made if density is None else replace(made, density=density)


def materials_of(
    text: str, systems: Sequence[str], density: float | None = None
) -> dict[str, Material]:
    """The material of each system, from ``steel`` or ``steel,panels=glass``.

    Args:
        text: one material for all systems, those of single systems after their names, or both;
            separated by commas.
        systems: names of all systems that are built.
        density: kg/m3, of what has no material named for it alone.

    Raises:
        InputError: an unknown material, a system that is not built or named twice, or several
            materials for all.
    """
    general, single = "", {}
    for entry in text.split(","):
        system, equals, name = (word.strip() for word in entry.rpartition("="))
        if equals and (system not in systems or system in single):
            raise InputError(
                f"material: expected {', '.join(systems)} before '=', each once, got "
                f"'{entry.strip()}'"
            )
        if equals:
            single[system] = material(name)
        elif general:
            raise InputError(
                f"material: '{general}' and '{name}' are both for everything; name the system of "
                f"one, as {systems[-1]}={name}"
            )
        else:
            general = name
    others = material(general or "steel", density)
    return {system: single.get(system, others) for system in systems}
