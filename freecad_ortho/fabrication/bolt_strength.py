"""What bolts bear by EN 1993-1-8, table 3.4: design resistances of one bolt, N.

Tension 0.9 fub As / gM2, shear 0.6 fub As / gM2 a plane with the thread in it, bearing
k1 ab fu d t / gM2, punching 0.6 pi dm t fu / gM2; gM2 = 1.25 (EN 1993-1-8, 2.2). Bolts are of
grade 8.8. Stress areas are those of ISO 898-1, table 4, tensile strengths of plates those of
EN 1993-1-1, table 3.1, up to 40 mm.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from freecad_ortho.fabrication.bolts import Bolt
from freecad_ortho.fabrication.material import Material

# Tensile strength of grade 8.8, MPa, and the factor by which resistances are divided.
STRENGTH, SAFETY = 800.0, 1.25
# Stress areas by diameter, mm2.
AREAS = {12: 84.3, 16: 157.0, 20: 245.0, 24: 353.0, 27: 459.0, 30: 561.0}
_SMALL = {5: 14.2, 6: 20.1, 8: 36.6, 10: 58.0}
# Tensile strengths of what plates are made of, MPa; of plain steel that of the weakest.
_TENSILE = {"steel": 360.0, "S235": 360.0, "S275": 430.0, "S355": 490.0}

COLUMNS = ("tension_kN", "shear_kN", "bearing_kN")


@dataclass(frozen=True)
class Clamped:
    """How a bolt is built in; mm.

    Args:
        bolt: its size.
        planes: in which it is sheared; 0 where it is pulled alone.
        plate: thickness of the thinnest plate that bears on it, of two on the same side together.
        head: thickness of the plate that its head pulls at.
        edge: least distance to the edge of a plate, along and across the force.
        apart: least distance between two bolts, None where there is one alone.
        material: of the plates.
    """

    bolt: Bolt
    planes: int
    plate: float
    head: float
    edge: float
    apart: float | None
    material: Material

    @property
    def tension(self) -> float:
        """Of the bolt, or of the plate that its head is pulled through, N."""
        own = 0.9 * STRENGTH * _area(self.bolt) / SAFETY
        strength = _TENSILE.get(self.material.name)
        if strength is None:
            return own
        mean = (self.bolt.flats + self.bolt.corners) / 2
        return min(own, 0.6 * math.pi * mean * self.head * strength / SAFETY)

    @property
    def shear(self) -> float | None:
        """In all planes together, N; None where it is pulled alone."""
        if not self.planes:
            return None
        return self.planes * 0.6 * STRENGTH * _area(self.bolt) / SAFETY

    @property
    def bearing(self) -> float | None:
        """Of the plates, N; None where it is pulled alone, and for plates without a rule here."""
        strength = _TENSILE.get(self.material.name)
        if strength is None or not self.planes:
            return None
        hole = self.bolt.hole
        along = [self.edge / (3 * hole), STRENGTH / strength, 1.0]
        across = [2.8 * self.edge / hole - 1.7, 2.5]
        if self.apart is not None:
            along.append(self.apart / (3 * hole) - 0.25)
            across.append(1.4 * self.apart / hole - 1.7)
        both = min(along) * min(across)
        return both * strength * self.bolt.diameter * self.plate / SAFETY

    def row(self) -> tuple[object, ...]:
        """For lists, kN, see ``COLUMNS``."""
        found = (self.tension, self.shear, self.bearing)
        return tuple("" if force is None else round(force / 1e3, 1) for force in found)

    def report(self, count: int) -> dict[str, float]:
        """The same by their names, without what there is none of, and how many join an end."""
        pairs = zip(COLUMNS, self.row(), strict=True)
        found = {f"bolt_{name}": value for name, value in pairs if isinstance(value, float)}
        return {"bolts_an_end": count, **found}


def _area(bolt: Bolt) -> float:
    """Stress area, mm2."""
    return (AREAS | _SMALL)[round(bolt.diameter)]


def bolts_used(nodes: Mapping[str, Any], forces: Mapping[str, float]) -> str:
    """How far bolts are used by the largest forces at ends of members, in words.

    Tension and shear together by EN 1993-1-8, table 3.4: Fv / FvRd + Ft / (1.4 FtRd); what webs
    are pulled by between cover plates shears their bolts, and balls take no shear by their bolts.

    Args:
        nodes: what the report says of bolted nodes.
        forces: of a structural check, tension_kN, compression_kN, shear_kN and moment_kNm.
    """
    count, pull, shear = nodes["bolts_an_end"], forces["tension_kN"], forces["shear_kN"]
    along, across = nodes["bolt_tension_kN"], nodes.get("bolt_shear_kN", 0.0)
    across = min(across, nodes.get("bolt_bearing_kN", across))
    if nodes["kind"] in ("star", "through"):
        used = math.hypot(max(pull, forces["compression_kN"]), shear) / (count * across)
        words = f"{across:g} kN each across"
    elif nodes["kind"] == "ball":
        used = pull / (count * along)
        words = f"{along:g} kN each in tension"
    else:
        together = pull / (1.4 * count * along) + shear / (count * across)
        used = max(pull / (count * along), together)
        words = f"{along:g} kN each in tension and {across:g} kN across"
    also = "shear and moments" if nodes["kind"] == "ball" else "moments"
    return (
        f"Bolts of the nodes, {count} an end, bear {words} (EN 1993-1-8, table 3.4). Members pull "
        f"with {pull:.3g} kN at most, press with {forces['compression_kN']:.3g} kN and shear with "
        f"{shear:.3g} kN at their ends: taken together bolts are used to {100 * used:.0f} %. The "
        f"{also} there, {forces['moment_kNm']:.3g} kNm at most, are not counted."
    )
