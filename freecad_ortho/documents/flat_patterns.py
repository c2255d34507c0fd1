"""Flat patterns in documents: laid out, nested, drawn on pages."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import FreeCAD

from freecad_ortho import convert
from freecad_ortho.documents.common import removed_on_failure, transaction
from freecad_ortho.objects import flat_patterns, places
from freecad_ortho.objects.structure import is_structure
from solver.errors import InputError

if TYPE_CHECKING:
    Length = float | str | FreeCAD.Units.Quantity


def add_flat_patterns(
    structures: FreeCAD.DocumentObject | Sequence[FreeCAD.DocumentObject],
    sheet: tuple[Length, Length] | None = None,
    spacing: Length = 10.0,
    grain: str = "none",
    nesting: str = "boxes",
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
    for name, word, words in (
        ("grain", grain, ("none", "along")),
        ("nesting", nesting, ("boxes", "outlines")),
    ):
        if word not in words:
            raise InputError(f"{name}: expected {' or '.join(words)}, got '{word}'")
    width, height = (0.0, 0.0) if sheet is None else sheet
    document = chosen[0].Document
    with transaction(document, FreeCAD.Qt.translate("Ortho", "Flat patterns")):
        feature = flat_patterns.create(
            document,
            chosen,
            SheetWidth=convert.millimetres(width, "sheet width"),
            SheetHeight=convert.millimetres(height, "sheet height"),
            Spacing=convert.millimetres(spacing, "spacing"),
            Grain=grain.capitalize(),
            Nesting=nesting.capitalize(),
            Seed=seed,
            Kerf=convert.millimetres(kerf, "kerf"),
        )
        with removed_on_failure(feature):
            flat_patterns.rebuild(feature)
        feature.purgeTouched()
    return feature
