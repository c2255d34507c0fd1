"""From a mesh in mm to solids, flat patterns and parts lists; knows no FreeCAD."""

from freecad_ortho.fabrication.files import FILES, stage_seconds, write
from freecad_ortho.fabrication.limits import Limits
from freecad_ortho.fabrication.material import (
    BUILD_UPS,
    MATERIALS,
    Material,
    material,
    materials_of,
)
from freecad_ortho.fabrication.part import Measures, Part
from freecad_ortho.fabrication.pattern import Bend, FlatPattern, Hole, Mark
from freecad_ortho.fabrication.place import Place
from freecad_ortho.fabrication.site import Selection, Site
from freecad_ortho.fabrication.sizes import OFFSETS
from freecad_ortho.fabrication.solids import brep_text
from freecad_ortho.fabrication.structure import Structure, build
from freecad_ortho.fabrication.systems import (
    SYSTEMS,
    Beams,
    BentPanels,
    Lamellas,
    Panels,
    Patches,
    System,
    SystemParts,
    system_of,
    systems_of,
)
from freecad_ortho.fabrication.workers import local_pool
from freecad_ortho.fabrication.workshop import Workshop

__all__ = [
    "BUILD_UPS",
    "FILES",
    "MATERIALS",
    "OFFSETS",
    "SYSTEMS",
    "Beams",
    "Bend",
    "BentPanels",
    "FlatPattern",
    "Hole",
    "Lamellas",
    "Limits",
    "Mark",
    "Material",
    "Measures",
    "Panels",
    "Part",
    "Patches",
    "Place",
    "Selection",
    "Site",
    "Structure",
    "System",
    "SystemParts",
    "Workshop",
    "brep_text",
    "build",
    "local_pool",
    "material",
    "materials_of",
    "stage_seconds",
    "system_of",
    "systems_of",
    "write",
]
