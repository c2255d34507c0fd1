"""Flat patterns in documents: laid out, nested, drawn on pages."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import FreeCAD

from freecad_ortho import convert
from freecad_ortho.documents.common import changing, removed_on_failure, transaction
from freecad_ortho.fabrication.workshop import ON_SHEETS
from freecad_ortho.objects import flat_patterns, places
from freecad_ortho.objects.option_properties import stored
from freecad_ortho.objects.structure import is_structure
from solver.errors import InputError

if TYPE_CHECKING:
    from freecad_ortho.option_keywords import (
        GrainWord,
        NestingWord,
    )

    Length = float | str | FreeCAD.Units.Quantity


def add_flat_patterns(
    structures: FreeCAD.DocumentObject | Sequence[FreeCAD.DocumentObject],
    sheet: tuple[Length, Length] | None = None,
    spacing: Length = 10.0,
    grain: GrainWord = "none",
    nesting: NestingWord = "boxes",
    seed: int = 0,
    kerf: Length = 0.0,
) -> FreeCAD.DocumentObject:
    """Add the flat patterns of structures on one net, which follow them.

    Args:
        structures: a Structure, or several on the same Net.
        sheet: width and height of the sheets to nest on; without it the patterns lie in rows.
        spacing: clear distance of parts from each other and from the rim of a sheet.
        grain: ``"none"`` lets parts turn, ``"along"`` keeps their length along the sheet.
        nesting: ``"boxes"`` or ``"outlines"``.
        seed: of the search for a dense nesting.
        kerf: width of the cut that the outlines are compensated for.

    Raises:
        InputError: nothing to lay out, or no part that fits on a sheet; the document is unchanged.
    """
    chosen = list(structures) if isinstance(structures, (list, tuple)) else [structures]
    for item in chosen:
        places.refuse_link(item)
    if not chosen or not all(is_structure(item) for item in chosen):
        raise InputError("flat patterns: expected structures; select some first")
    properties = _properties(
        sheet or (0.0, 0.0), spacing=spacing, grain=grain, nesting=nesting, seed=seed, kerf=kerf
    )
    document = chosen[0].Document
    with transaction(document, FreeCAD.Qt.translate("Ortho", "Flat patterns")):
        feature = flat_patterns.create(document, chosen, **properties)
        with removed_on_failure(feature):
            flat_patterns.rebuild(feature)
        feature.purgeTouched()
    return feature


def change_flat_patterns(
    target: FreeCAD.DocumentObject,
    /,
    *,
    sheet: tuple[Length, Length] | None = None,
    spacing: Length | None = None,
    grain: str | None = None,
    nesting: str | None = None,
    seed: int | None = None,
    kerf: Length | None = None,
) -> None:
    """Lay flat patterns out with other settings; pages follow.

    Args:
        target: the flat patterns.
        sheet: as for :func:`add_flat_patterns`; ``(0, 0)`` for rows. What is not given stays.
        spacing: as there.
        grain: as there.
        nesting: as there.
        seed: as there.
        kerf: as there.

    Raises:
        InputError: no flat patterns, or settings with which nothing can be laid out; they are
            unchanged.
    """
    places.refuse_link(target)
    if not flat_patterns.is_flat_patterns(target):
        label = getattr(target, "Label", target)
        raise InputError(f"flat patterns: {label} is none; select flat patterns first")
    properties = _properties(
        sheet, spacing=spacing, grain=grain, nesting=nesting, seed=seed, kerf=kerf
    )
    with changing(target, properties):
        flat_patterns.rebuild(target)


def _properties(sheet: tuple[Length, Length] | None, **given: Any) -> dict[str, Any]:
    """Values of the properties for those settings that are given."""
    found: dict[str, Any] = {}
    for name, side in zip(("width", "height"), sheet or (), strict=False):
        found[f"Sheet{name.capitalize()}"] = convert.millimetres(side, f"sheet {name}")
    for option in ON_SHEETS:
        value = given[option.name]
        if value is None:
            continue
        if option.kind == "length":
            value = convert.millimetres(value, option.name)
        option.check(value)
        found |= stored(option, value, titled=True)
    return found
