"""Limits that the user sets, and the verdict on a part."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import ClassVar

from freecad_ortho.fabrication.part import Part, measure_words
from freecad_ortho.fabrication.plate_limits import complaints as plate_complaints
from freecad_ortho.fabrication.sizes import positive
from solver.option import Option

OK = "ok"
# Limits of parts whose patterns are straight or arcs.
_OF_PATTERNS = ("straightness_mm", "radius_spread_mm")
# Share of the limit below which shear is not worth a word.
_LITTLE = 1e-3


@dataclass(frozen=True)
class Limits:
    """The largest values of a part's measures that still pass; None for whatever comes.

    Args:
        gap_mm: from plane or developable.
        twist_deg: of a beam.
        straightness_mm: of an unrolled axis that is meant to be straight.
        radius_spread_mm: of an unrolled axis that is meant to be an arc.
        lean_deg: from the surface normal.

    Raises:
        InputError: a limit that is not positive and finite.
    """

    gap_mm: float | None = 1.0
    twist_deg: float | None = 1.0
    straightness_mm: float | None = 1.0
    radius_spread_mm: float | None = 1.0
    lean_deg: float | None = None

    # In the order of the fields; 0 is no limit.
    options: ClassVar[tuple[Option, ...]] = (
        Option(
            "limit_gap",
            1.0,
            "length",
            "Parts pass that are off a plane or developable by this at most; 0: any",
            brief="largest gap; 0 for any",
        ),
        Option(
            "limit_twist",
            1.0,
            "angle",
            "Beams pass that twist by this at most; 0: any",
            brief="largest twist; 0 for any",
        ),
        Option(
            "limit_straightness",
            1.0,
            "length",
            "Unrolled axes pass that are off straight by this at most; 0: any",
            brief="largest straightness; 0 for any",
        ),
        Option(
            "limit_radius_spread",
            1.0,
            "length",
            "Unrolled axes pass that are off their arc by this at most; 0: any",
            brief="largest radius spread; 0 for any",
        ),
        Option(
            "limit_lean",
            0.0,
            "angle",
            "Parts pass that lean from the surface normal by this at most; 0: any",
            absent="any",
            brief="largest lean",
        ),
    )

    @classmethod
    def of(cls, values: Mapping[str, float]) -> Limits:
        """Make the limits from values of some of ``options``.

        Raises:
            InputError: a limit below 0.
        """
        names = {
            option.name: own.name for option, own in zip(cls.options, fields(cls), strict=True)
        }
        return cls(**{names[name]: value or None for name, value in values.items()})

    def __post_init__(self) -> None:
        for field in fields(self):
            if (value := getattr(self, field.name)) is not None:
                name, unit = _words(field.name)
                positive(f"limit of {name}", value, unit)


def verdict(part: Part, limits: Limits) -> str:
    """Say "ok", or in one sentence what exceeds which limit."""
    complaints = []
    skipped = _OF_PATTERNS if part.curved else ()
    for field in fields(limits):
        if field.name in skipped:
            continue
        limit, value = getattr(limits, field.name), getattr(part.measures, field.name)
        if limit is not None and value is not None and value > limit:
            name, unit = _words(field.name)
            complaints.append(f"{name} {value:.3g} {unit} exceeds {limit:g} {unit}")
    if words := _overstressed(part):
        complaints.append(words)
    material = part.material
    bearing = part.measures.bearing_mm
    if bearing is not None and bearing < material.bearing:
        where = (
            f"bears {bearing:.3g} mm" if bearing >= 0 else f"ends {-bearing:.3g} mm beside a beam"
        )
        complaints.append(f"{where}, {material.name} needs {material.bearing:g} mm of bearing")
    use = part.measures.bend_use_percent
    if use is not None and use > 100:
        complaints.append(
            f"warp {part.measures.warp_mm:.3g} mm is {use:.0f} % of what {material.name} may be "
            f"bent to cold, it leaves {part.measures.cold_MPa:.3g} MPa"
        )
    if part.assembly:
        complaints.append(part.assembly)
    if part.pattern is not None and material.plate_limits is not None:
        complaints += plate_complaints(
            part.pattern, part.thickness, part.mass, material.name, material.plate_limits
        )
    return "; ".join(complaints) or OK


def von_mises(bending: float, shear: float) -> float:
    """Stress by which bending and shear stress in one place are judged, MPa.

    Source: von Mises (1913), Mechanik der festen Koerper im plastisch-deformablen Zustand.
    """
    return math.hypot(bending, math.sqrt(3) * shear)


def _overstressed(part: Part) -> str:
    """How far the stress of bending and twisting a plate exceeds its material's limit, if it does.

    The largest bending and the largest shear stress count as if they were in one place.
    """
    measures, material = part.measures, part.material
    bending, shear = measures.stress_MPa or 0.0, measures.shear_MPa or 0.0
    limit, radius = material.bending_limit, measures.min_bend_radius_mm
    if von_mises(bending, shear) <= limit:
        return ""
    needed = f"{material.least_radius(part.thickness):.0f} mm"
    bent = "" if radius is None else f"bent to {radius:.0f} mm"
    if shear <= _LITTLE * limit:
        return (
            f"bending stress {bending:.3g} MPa exceeds {limit:g} MPa of {material.name}: {bent}, "
            f"needs {needed}"
        )
    whole = f"stress {von_mises(bending, shear):.3g} MPa exceeds {limit:g} MPa of {material.name}"
    return (
        f"{whole}: bending {bending:.3g} MPa{bent and f', {bent}'}, and {shear:.3g} MPa of shear "
        f"from torsion of {measures.torsion_deg_per_m or 0.0:.3g} degrees a metre"
    )


def _words(field: str) -> tuple[str, str]:
    """Name and unit of a measure, the unit in a word."""
    name, unit = measure_words(field)
    return name, unit.replace("deg", "degrees")
