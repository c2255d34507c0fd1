"""XLSX: lists of parts, nodes, stock, sheets and off-cuts; masses and stock with their prices."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

from freecad_ortho.fabrication.exchange.costs import OFF_CUT_COLUMNS, bought, off_cuts
from freecad_ortho.fabrication.prices import Prices
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
    tables = {
        **lists(production),
        "sheets": _sheets(production),
        "off-cuts": (OFF_CUT_COLUMNS, off_cuts(production)),
    }
    prices = production.workshop.price_list
    _masses(book, production, prices)
    _stock_costs(book, production, prices)
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


def _masses(book: Workbook, production: Production, prices: Prices) -> None:
    """What there is of each material, its price a kg, and what follows."""
    page = _Costs(book, "mass and cost", ("material", "parts", "volume m3", "mass kg"), "kg")
    materials: dict[str, dict[str, Any]] = production.structure.report()["materials"]
    for name, found in materials.items():
        volume, mass = found["volume_mm3"] * 1e-9, found["mass_kg"]
        page.row([name, found["parts"], volume, mass], prices.get((name, "kg")))
    page.total(sum(found["mass_kg"] for found in materials.values()))


def _stock_costs(book: Workbook, production: Production, prices: Prices) -> None:
    """What is bought of bars and sheets, whole ones, its price a metre, m2 or piece."""
    columns = ("item", "material", "size mm", "pieces", "unit", "amount")
    page = _Costs(book, "cost of stock", columns, "unit")
    for each in bought(production):
        unit, amount = each.unit, each.amount
        price = prices.get((each.item, unit))
        if price is None and (each.item, "piece") in prices:
            unit, amount, price = "piece", each.pieces, prices[each.item, "piece"]
        page.row([each.item, each.material, each.size, each.pieces, unit, amount], price)
    page.total(None)


class _Costs:
    """A sheet whose rows end with an amount, its price and the cost that follows from both.

    Args:
        book: to which it is added.
        name: of the sheet.
        columns: before the price, the last one the amount.
        unit: that the price is for.
    """

    def __init__(self, book: Workbook, name: str, columns: Sequence[str], unit: str) -> None:
        self._page, self._row, self._cost = book.add_worksheet(name), 1, 0.0
        self._letter = chr(ord("A") + len(columns) - 1)
        self._amount = len(columns) - 1
        head = book.add_format({"bold": True, "bottom": 1})
        self._number = book.add_format({"num_format": "#,##0.000"})
        self._money = book.add_format({"bg_color": "#fff2cc", "num_format": "#,##0.00"})
        self._bold = book.add_format({"bold": True, "top": 1, "num_format": "#,##0.0"})
        for place, words in enumerate((*columns, f"price per {unit}", "cost")):
            self._page.write_string(0, place, words, head)
        self._page.set_column(0, 0, 30)
        self._page.set_column(1, len(columns) + 1, 14)

    def row(self, cells: Sequence[Any], price: float | None) -> None:
        """Write a line; a price that is not known stays to be filled in."""
        row, after = self._row, self._amount + 1
        for place, cell in enumerate(cells):
            if isinstance(cell, str):
                self._page.write_string(row, place, cell)
            else:
                self._page.write_number(
                    row, place, cell, None if cell == int(cell) else self._number
                )
        if price is None:
            self._page.write_blank(row, after, None, self._money)
        else:
            self._page.write_number(row, after, price, self._money)
        cost = cells[-1] * (price or 0.0)
        letter = chr(ord(self._letter) + 1)
        formula = f"={self._letter}{row + 1}*{letter}{row + 1}"
        self._page.write_formula(row, after + 1, formula, self._number, cost)
        self._row, self._cost = row + 1, self._cost + cost

    def total(self, amount: float | None) -> None:
        """Write the sums; of amounts of different units there is none."""
        self._page.write_string(self._row, 0, "total", self._bold)
        sums = [(self._amount, amount), (self._amount + 2, self._cost)]
        for place, value in sums:
            letter = chr(ord("A") + place)
            if value is not None and self._row > 1:
                formula = f"=SUM({letter}2:{letter}{self._row})"
                self._page.write_formula(self._row, place, formula, self._bold, value)


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
