"""The systems that a net can be built with. A new one needs a line here, and no more elsewhere."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from freecad_ortho.fabrication.material import MATERIALS, Material
from freecad_ortho.fabrication.systems.arches import Arches
from freecad_ortho.fabrication.systems.beams import Beams
from freecad_ortho.fabrication.systems.bent_panels import BentPanels
from freecad_ortho.fabrication.systems.edge_beam import EdgeBeam, edge_section_beside
from freecad_ortho.fabrication.systems.feet import Feet
from freecad_ortho.fabrication.systems.lamellas import Lamellas
from freecad_ortho.fabrication.systems.louvres import Louvres
from freecad_ortho.fabrication.systems.nodes import ENDS_OF, Nodes
from freecad_ortho.fabrication.systems.panels import Panels
from freecad_ortho.fabrication.systems.patches import Patches
from freecad_ortho.fabrication.systems.shared_options import USUAL_CLEARANCE
from freecad_ortho.fabrication.systems.system import System, SystemParts
from solver.errors import InputError
from solver.option import unknown

# In the order in which they are built: later ones may lie on earlier ones.
SYSTEMS: dict[str, type[System]] = {
    system.name: system
    for system in (
        EdgeBeam,
        Beams,
        Nodes,
        Arches,
        Panels,
        Louvres,
        Lamellas,
        BentPanels,
        Patches,
        Feet,
    )
}

__all__ = [
    "SYSTEMS",
    "Arches",
    "Beams",
    "BentPanels",
    "EdgeBeam",
    "Feet",
    "Lamellas",
    "Louvres",
    "Nodes",
    "Panels",
    "Patches",
    "System",
    "SystemParts",
    "system_of",
    "systems_of",
]


def systems_of(
    names: str, values: Mapping[str, Any], materials: Mapping[str, Material] | None = None
) -> list[System]:
    """Make systems by their names, joined by "+", from the values of their options.

    Options that are not given take their defaults. Panels of a build-up are as thick as it is
    unless told, beams leave room for hubs, and an edge beam has a section like theirs.

    Raises:
        InputError: an unknown system or one twice, an option that none of them has, a value that
            cannot be used.
    """
    wanted = names.split("+")
    if set(wanted) - set(SYSTEMS) or len(set(wanted)) < len(wanted):
        raise unknown("system", names, SYSTEMS, "several joined by '+'")
    _refuse_unknown(wanted, values)
    ends = ENDS_OF.get(values.get("node", "hub"))
    if "nodes" in wanted and ends is not None:
        values = {"ends": ends, **values}
    sized = any(values.get(f"edge_{size}") is not None for size in ("height", "width"))
    if "edge-beam" in wanted and "beams" in wanted and not sized:
        values = {"edge_section": edge_section_beside(values.get("section", "plate")), **values}
    chosen = [system for name, system in SYSTEMS.items() if name in wanted]
    result = []
    for system in chosen:
        settings = {each.name: values.get(each.name, each.default) for each in system.options}
        of = MATERIALS["steel"] if materials is None else materials[system.name]
        if "panel_thickness" in settings and settings["panel_thickness"] is None:
            settings["panel_thickness"] = of.thickness
        result.append(system_of(system.name, settings, of))
    return result


def system_of(name: str, values: Mapping[str, Any], material: Material) -> System:
    """Make a system of a material from a value for each of its options.

    Where no clearance is given, slots have that of the material, all else the usual one.

    Raises:
        InputError: a value that cannot be used.
    """
    system = SYSTEMS[name]
    if "clearance" in values and values["clearance"] is None:
        slotted = system.slotted(values)
        values = {**values, "clearance": material.clearance if slotted else USUAL_CLEARANCE}
    return system.of(values)


def _refuse_unknown(wanted: Sequence[str], values: Mapping[str, Any]) -> None:
    """Refuse values of options that none of the wanted systems has."""
    users: dict[str, list[str]] = {}
    for name, system in SYSTEMS.items():
        for option in system.options:
            users.setdefault(option.name, []).append(name)
    for option_name in values:
        found = users.get(option_name, [])
        if not found:
            raise InputError(
                f"{option_name}: no system has such a size; there are {', '.join(users)}"
            )
        if not set(found) & set(wanted):
            raise InputError(
                f"{option_name}: {'+'.join(wanted)} has no such size, it is of {', '.join(found)}; "
                "leave it out"
            )
