"""Who makes a part: carpenters, glaziers or, by default, those who work metal."""

from __future__ import annotations

from freecad_ortho.fabrication.material import Material

# Wood is lighter than water, kg/m3; what metal, glass and fibres are made of is not.
_WATER = 1000.0


def is_wood(material: Material) -> bool:
    """Whether a part of this material goes to a carpenter."""
    return material.density < _WATER and not material.layers


def is_metal(material: Material) -> bool:
    """Whether a part of this material is cut by machines for steel: neither wood nor glass."""
    return not (is_wood(material) or material.layers or "glass" in material.name)


# By the names of formats for machines, which work one kind of material: what that is.
MACHINED = {"btlx": (is_wood, "wood"), "nc1": (is_metal, "metal")}
