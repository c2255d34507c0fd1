"""What IFC says of a part: its class, quantities and properties."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from freecad_ortho.fabrication.part import Part, measure_words
from freecad_ortho.fabrication.production import Production

# Class, predefined type and set of quantities by kind; what is unknown is a proxy.
_CLASSES = {
    "beam": ("IfcBeam", "BEAM", "Qto_BeamBaseQuantities"),
    "arch-plate": ("IfcBeam", "BEAM", "Qto_BeamBaseQuantities"),
    "web": ("IfcBeam", "BEAM", "Qto_BeamBaseQuantities"),
    "edge-beam": ("IfcBeam", "BEAM", "Qto_BeamBaseQuantities"),
    "flange": ("IfcBeam", "BEAM", "Qto_BeamBaseQuantities"),
    "lamella": ("IfcMember", "MEMBER", "Qto_MemberBaseQuantities"),
    "panel": ("IfcPlate", "CURTAIN_PANEL", "Qto_PlateBaseQuantities"),
    "louvre": ("IfcPlate", "SHEET", "Qto_PlateBaseQuantities"),
    "bent panel": ("IfcPlate", "SHEET", "Qto_PlateBaseQuantities"),
    "patch": ("IfcPlate", "SHEET", "Qto_PlateBaseQuantities"),
    "splice": ("IfcPlate", "SHEET", "Qto_PlateBaseQuantities"),
    "cover-plate": ("IfcPlate", "SHEET", "Qto_PlateBaseQuantities"),
    "end-plate": ("IfcPlate", "SHEET", "Qto_PlateBaseQuantities"),
    "pressure-plate": ("IfcMember", "MEMBER", "Qto_MemberBaseQuantities"),
    "cap": ("IfcMember", "MEMBER", "Qto_MemberBaseQuantities"),
    "adapter": ("IfcMember", "MEMBER", "Qto_MemberBaseQuantities"),
    "foot": ("IfcMember", "POST", "Qto_MemberBaseQuantities"),
    "foot-plate": ("IfcPlate", "SHEET", "Qto_PlateBaseQuantities"),
    "fin": ("IfcPlate", "SHEET", "Qto_PlateBaseQuantities"),
    "cleat": ("IfcDiscreteAccessory", "BRACKET", ""),
    "node": ("IfcDiscreteAccessory", "NOTDEFINED", ""),
    "cone": ("IfcDiscreteAccessory", "NOTDEFINED", ""),
    "sleeve": ("IfcDiscreteAccessory", "NOTDEFINED", ""),
}
_UNKNOWN = ("IfcBuildingElementProxy", "NOTDEFINED", "Qto_BuildingElementProxyQuantities")
SET = "Ortho_Part"

Make = Callable[..., Any]


def class_of(part: Part) -> tuple[str, str, str]:
    """Class, predefined type and set of quantities, which may have no name."""
    return _CLASSES.get(part.kind, _UNKNOWN)


class Facts:
    """Quantities and properties of parts; those that say the same share a property."""

    def __init__(self, make: Make, guid: Callable[[str], str], production: Production) -> None:
        self.make, self.guid, self.production = make, guid, production
        names = (part.name for part in production.structure.parts)
        self.verdicts = dict(zip(names, production.verdicts, strict=True))
        self.places, self.equal_to = production.places, production.groups.equal_to
        self.values: dict[tuple[str, str], Any] = {}

    def describe(self, part: Part, element: Any) -> None:
        """Give an element what is known of its part."""
        facts = self._facts(part)
        values = [self._value(name, value) for name, value in facts.items()]
        self._define(part, element, "IfcPropertySet", SET, [None, values])
        quantities = class_of(part)[2] or f"{SET}_Quantities"
        amounts = self._amounts(part)
        self._define(part, element, "IfcElementQuantity", quantities, [None, None, amounts])

    def _facts(self, part: Part) -> dict[str, str | int | float]:
        facts: dict[str, str | int | float] = {"Verdict": self.verdicts[part.name]}
        if part.family:
            facts["Family"] = part.family
        for name, number in (("Line", part.line), ("Face", part.face)):
            if number is not None:
                facts[name] = number
        if part.vertices:
            facts["Vertices"] = " ".join(map(str, part.vertices))
        lists = {"EqualTo": self.equal_to, "CutFrom": self.places}
        facts |= {key: names[part.name] for key, names in lists.items() if part.name in names}
        for field, value in vars(part.measures).items():
            if value is not None:
                words, unit = measure_words(field)
                name = "".join(word.capitalize() for word in words.split())
                facts[f"{name}_{re.sub(r'[^A-Za-z]+', '_', unit)}".rstrip("_")] = float(value)
        if part.note:
            facts["Note"] = part.note
        return facts

    def _define(self, part: Part, element: Any, kind: str, name: str, contents: list[Any]) -> None:
        key = f"{name} {part.name}"
        made = self.make(kind, self.guid(key), None, name, *contents)
        self.make(
            *("IfcRelDefinesByProperties", self.guid(f"of {key}"), None, None, None, [element]),
            made,
        )

    def _value(self, name: str, value: str | int | float) -> Any:
        """A property; parts of which it says the same share it."""
        key = name, repr(value)
        if key not in self.values:
            kind = {str: "IfcText", int: "IfcInteger", float: "IfcReal"}[type(value)]
            wrapped = self.make(kind, value)
            self.values[key] = self.make("IfcPropertySingleValue", name, None, wrapped, None)
        return self.values[key]

    def _amounts(self, part: Part) -> list[Any]:
        """Sizes in mm, area in m2, volume in m3, mass in kg."""
        sizes = {"Length": part.length}
        if class_of(part)[0] == "IfcPlate":
            sizes = {"Width": part.thickness}
        found = [
            self.make("IfcQuantityLength", name, None, None, float(value), None)
            for name, value in sizes.items()
            if value > 0
        ]
        if part.area > 0 and "Width" in sizes:
            area = part.area * 1e-6
            found.append(self.make("IfcQuantityArea", "NetArea", None, None, area, None))
        volume = part.volume * 1e-9
        found.append(self.make("IfcQuantityVolume", "NetVolume", None, None, volume, None))
        found.append(self.make("IfcQuantityWeight", "NetWeight", None, None, part.mass, None))
        return found
