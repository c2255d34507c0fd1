"""From a mesh in mm to solids, flat patterns and parts lists; knows no FreeCAD."""

from freecad_ortho.fabrication.files import FILES, stage_seconds, write
from freecad_ortho.fabrication.part import FlatPattern, Mark, Part
from freecad_ortho.fabrication.settings import (
    OFFSETS,
    STEEL_DENSITY,
    BeamSettings,
    PanelSettings,
)
from freecad_ortho.fabrication.solids import brep_text
from freecad_ortho.fabrication.structure import Structure, build

__all__ = [
    "FILES",
    "OFFSETS",
    "STEEL_DENSITY",
    "BeamSettings",
    "FlatPattern",
    "Mark",
    "PanelSettings",
    "Part",
    "Structure",
    "brep_text",
    "build",
    "stage_seconds",
    "write",
]
