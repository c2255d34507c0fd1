"""Who makes a part: carpenters, glaziers or, by default, those who work metal."""

from __future__ import annotations

from freecad_ortho.fabrication.material import Material
from freecad_ortho.fabrication.profiles.catalogue import GLULAM, SOLID_TIMBER

_WOOD = (*GLULAM, *SOLID_TIMBER, "timber", "plywood")


def is_wood(material: Material) -> bool:
    """Whether a part of this material goes to a carpenter."""
    return material.name in _WOOD


def is_metal(material: Material) -> bool:
    """Whether a part of this material is cut by machines for steel: neither wood nor glass."""
    return not (is_wood(material) or material.layers or "glass" in material.name)
