"""What the user chooses about beams and panels, checked on the way in."""

from __future__ import annotations

import math
from dataclasses import dataclass

from solver.errors import InputError

OFFSETS = ("above", "centre", "below")
STEEL_DENSITY = 7850.0
# Below it, mm, the CAD kernel takes the corners of a plate for one point.
_SMALLEST = 1e-3


@dataclass(frozen=True)
class BeamSettings:
    """A system of beams: a plate of this height and thickness along every edge.

    Args:
        height: mm between the mesh and its parallel mesh; each beam's own height follows the
            parallel mesh and differs from it by the deviation in ``Structure.report()``.
        thickness: plate thickness, mm.
        offset: along the axes the beams occupy ``[0, height]`` (above), half to each side (centre)
            or ``[-height, 0]`` (below) of the mesh.

    Raises:
        InputError: a length that is not positive and finite, or an unknown offset.
    """

    height: float
    thickness: float
    offset: str = "centre"

    def __post_init__(self) -> None:
        _size("beam height", self.height)
        _size("beam thickness", self.thickness)
        _known_offset(self.offset)

    @property
    def levels(self) -> tuple[float, float]:
        """Lower and upper level along the axes, mm from the mesh."""
        return _levels(self.offset, self.height)


@dataclass(frozen=True)
class PanelSettings:
    """A system of panels: a plate of this thickness in every face.

    Args:
        thickness: plate thickness, mm.
        gap: joint between neighbours measured on the mesh, mm; each side shrinks by half of it.
        offset: along the face normal the panels occupy ``[0, thickness]`` (above), half to each
            side (centre) or ``[-thickness, 0]`` (below); with beams they lie on top instead.

    Raises:
        InputError: a length that is not positive and finite, or an unknown offset.
    """

    thickness: float
    gap: float
    offset: str = "centre"

    def __post_init__(self) -> None:
        _size("panel thickness", self.thickness)
        _size("gap", self.gap)
        _known_offset(self.offset)

    @property
    def levels(self) -> tuple[float, float]:
        """Lower and upper level along the face normal, mm from the mesh."""
        return _levels(self.offset, self.thickness)


def positive(name: str, value: float, unit: str) -> None:
    """Refuse a value that is not a positive finite number.

    Raises:
        InputError: naming the value.
    """
    number = isinstance(value, (int, float)) and not isinstance(value, bool)
    if not number or not math.isfinite(value) or value <= 0:
        raise InputError(f"{name}: expected a number above 0 {unit}, got {value}; give a size")


def _size(name: str, value: float) -> None:
    positive(name, value, "mm")
    if value < _SMALLEST:
        raise InputError(
            f"{name}: expected at least {_SMALLEST:g} mm, got {value:g}; check the unit"
        )


def rounded_down(value: float) -> str:
    """Three digits of a limit that is itself still allowed."""
    digits = 2 - math.floor(math.log10(value)) if value > 0 else 0
    scale = 10.0**-digits
    return f"{math.floor(value / scale) * scale:.6g}"


def _known_offset(offset: str) -> None:
    if offset not in OFFSETS:
        raise InputError(f"offset: expected one of {', '.join(OFFSETS)}, got '{offset}'")


def _levels(offset: str, size: float) -> tuple[float, float]:
    lower = {"above": 0.0, "centre": -size / 2, "below": -size}[offset]
    return lower, lower + size
