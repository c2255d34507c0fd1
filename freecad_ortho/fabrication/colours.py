"""Colours by what parts are made of."""

from __future__ import annotations

from freecad_ortho.fabrication.material import Material
from freecad_ortho.fabrication.profiles.catalogue import GLULAM, SOLID_TIMBER

Colour = tuple[int, int, int, int]
# Red, green, blue and opacity: of the first word that is in the material's name.
_COLOURS: dict[str, Colour] = {
    "glass": (150, 200, 220, 120),
    "steel": (140, 145, 155, 255),
    "aluminium": (200, 205, 210, 255),
    "ply": (205, 165, 110, 255),
    "wood": (205, 165, 110, 255),
    "timber": (205, 165, 110, 255),
    **dict.fromkeys((*GLULAM, *SOLID_TIMBER), (205, 165, 110, 255)),
}
_OTHER: Colour = (180, 180, 180, 255)


def colour_of(material: Material) -> Colour:
    """Red, green, blue and opacity, 0 to 255."""
    found = (colour for word, colour in _COLOURS.items() if word in material.name)
    return next(found, _OTHER)
