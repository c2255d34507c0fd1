"""XLSX: the lists of parts, nodes, stock and sheets, and masses with prices to be filled in."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

from freecad_ortho.fabrication.production import Production
from freecad_ortho.fabrication.tables import lists

if TYPE_CHECKING:
    from xlsxwriter import Workbook

# The same structure gives the same file: no clock.
_CREATED = datetime(2000, 1, 1)
_NUMBER = re.compile(r"-?\d+(\.\d+)?(e[-+]?\d+)?")
_WIDEST = 40


def write_xlsx(
    path: Path, production: Production, project: str, say: Callable[[float], None]
) -> None:
    """Write the lists as sheets of one workbook, each with a filter in its head.

    Args:
        path: file to write.
        production: of the structure.
        project: its name, the title of the workbook.
        say: called with the fraction done; may raise to stop.

    Raises:
        OSError: the file cannot be written.
    """
    from xlsxwriter import Workbook
    from xlsxwriter.exceptions import FileCreateError

    # What begins with = is a name, not a formula.
    book = Workbook(
        str(path), {"strings_to_formulas": False, "strings_to_urls": False, "in_memory": True}
    )
    book.set_properties({"title": project, "created": _CREATED})
    tables = {**lists(production), "sheets": _sheets(production)}
    _masses(book, production)
    for number, (name, (columns, rows)) in enumerate(tables.items()):
        say(number / len(tables))
        _sheet(book, name, columns, rows)
    try:
        book.close()
    except FileCreateError as error:
        raise OSError(str(error)) from error


def _sheets(production: Production) -> tuple[Sequence[str], list[list[object]]]:
    columns = ("name", "material", "thickness_mm", "parts", "waste_share")
    rows: list[list[object]] = [
        [
            sheet.name,
            sheet.material,
            sheet.thickness,
            " ".join(placement.name for placement in sheet.placements),
            sheet.waste,
        ]
        for sheet in production.sheets
    ]
    return columns, rows


def _masses(book: Workbook, production: Production) -> None:
    """What there is of each material, and a column for its price."""
    page = book.add_worksheet("mass and cost")
    head = book.add_format({"bold": True, "bottom": 1})
    number, money = (
        book.add_format({"num_format": "#,##0.0"}),
        book.add_format({"bg_color": "#fff2cc"}),
    )
    total = book.add_format({"bold": True, "top": 1, "num_format": "#,##0.0"})
    columns = ("material", "parts", "volume m3", "mass kg", "price per kg", "cost")
    for place, name in enumerate(columns):
        page.write_string(0, place, name, head)
    materials: dict[str, dict[str, Any]] = production.structure.report()["materials"]
    for row, (name, found) in enumerate(materials.items(), start=1):
        page.write_string(row, 0, name)
        page.write_number(row, 1, found["parts"])
        page.write_number(
            row, 2, found["volume_mm3"] * 1e-9, book.add_format({"num_format": "0.000"})
        )
        page.write_number(row, 3, found["mass_kg"], number)
        page.write_blank(row, 4, None, money)
        page.write_formula(row, 5, f"=D{row + 1}*E{row + 1}", number, 0)
    last = len(materials) + 1
    page.write_string(last, 0, "total", total)
    mass = sum(found["mass_kg"] for found in materials.values())
    page.write_formula(last, 3, f"=SUM(D2:D{last})", total, mass)
    page.write_formula(last, 5, f"=SUM(F2:F{last})", total, 0)
    page.set_column(0, 0, 30)
    page.set_column(1, 5, 14)


def _sheet(
    book: Workbook, name: str, columns: Sequence[str], rows: Sequence[Sequence[object]]
) -> None:
    page = book.add_worksheet(name)
    head = book.add_format({"bold": True, "bottom": 1, "text_wrap": True})
    for place, column in enumerate(columns):
        page.write_string(0, place, column, head)
        texts = [str(cells[place]) for cells in rows]
        is_number = all(_NUMBER.fullmatch(text) for text in texts if text)
        widest = len(column)
        for row, text in enumerate(texts, start=1):
            if not text:
                continue
            if is_number:
                page.write_number(row, place, float(text))
            else:
                page.write_string(row, place, text)
            widest = max(widest, len(text))
        page.set_column(place, place, min(widest + 2, _WIDEST))
    page.freeze_panes(1, 1)
    page.autofilter(0, 0, max(len(rows), 1), len(columns) - 1)
