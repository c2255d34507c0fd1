"""Limits that the user sets, and the verdict on a part."""

from __future__ import annotations

from dataclasses import dataclass, fields

from freecad_ortho.fabrication.part import Part, measure_words
from freecad_ortho.fabrication.sizes import positive

OK = "ok"
# Limits of parts whose patterns are straight or arcs.
_OF_PATTERNS = ("straightness_mm", "radius_spread_mm")


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
    stress, material = part.measures.stress_MPa, part.material
    if stress is not None and stress > material.bending_limit:
        complaints.append(
            f"bending stress {stress:.3g} MPa exceeds {material.bending_limit:g} MPa of "
            f"{material.name}: bent to {part.measures.min_bend_radius_mm:.0f} mm, needs "
            f"{material.least_radius(part.thickness):.0f} mm"
        )
    if part.assembly:
        complaints.append(part.assembly)
    return "; ".join(complaints) or OK


def _words(field: str) -> tuple[str, str]:
    """Name and unit of a measure, the unit in a word."""
    name, unit = measure_words(field)
    return name, unit.replace("deg", "degrees")
