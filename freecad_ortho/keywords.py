"""Settings of the macro API by their names, with their types, as editors and checkers read them.

Those that tables of options have are in :mod:`freecad_ortho.option_keywords`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, TypedDict

from freecad_ortho.option_keywords import (
    DesignOptions,
    FamilyWord,
    Feature,
    NetChoices,
    Sizes,
    WorkshopSettings,
)
from solver import Constraints, NetOptions

__all__ = [
    "CheckSettings",
    "DesignSettings",
    "Feature",
    "NetSettings",
    "PassedSettings",
    "Sizes",
    "StructureSettings",
    "WorkshopSettings",
]


class StructureSettings(Sizes, total=False):
    """What a Structure of a document can be told."""

    beams: Feature
    family: FamilyWord
    trimmed: bool
    lines: Sequence[int]
    material: str
    density: float


class DesignSettings(DesignOptions, total=False):
    """Members, supports and loads of a structural check; kN and m, lengths in mm."""

    wind: str | Sequence[str]
    load: str | Sequence[str]


class CheckSettings(DesignSettings, total=False):
    """What a structural check of a document can be told."""

    beams: Feature | None
    cladding: Feature | None
    combinations: Sequence[str]


class PassedSettings(TypedDict, total=False):
    """What the solver is told in one call, and the Net of a document does not keep."""

    max_steps: int
    backend: str | None
    options: NetOptions
    constraints: Constraints


class NetSettings(PassedSettings, NetChoices, total=False):
    """What the Net of a document can be told."""

    net: str
    fix: str | Sequence[int | str]
    handles: Mapping[int, Sequence[float]]
    glide: Sequence[Any]
    close_to: Sequence[Any]
    symmetry: str
