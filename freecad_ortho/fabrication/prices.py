"""What things cost: a list by the user."""

from __future__ import annotations

import csv
import io
import math
import os
from collections.abc import Mapping

from solver.errors import InputError
from solver.io.reading import read_text

UNITS = ("kg", "m", "m2", "piece")
# By what is bought and the unit in which it is.
Prices = Mapping[tuple[str, str], float]


def read_prices(path: str | os.PathLike[str]) -> Prices:
    """Prices of a CSV file with rows ``item, unit, price``; commas or semicolons part them.

    An item is a material (``steel``), a section of stock (``IPE200``, ``strip 200 x 12``) or a
    sheet (``sheet steel 12 mm``); units are ``kg``, ``m``, ``m2`` and ``piece``. A first row of
    names is passed over, and what follows ``#`` in a line.

    Raises:
        InputError: no such file, or a row that is none of these.
    """
    name, found = os.fspath(path), {}
    text = read_text(path)
    mark = ";" if ";" in text else ","
    lines = (line.split("#")[0] for line in text.split("\n"))
    for number, row in enumerate(csv.reader(io.StringIO("\n".join(lines)), delimiter=mark), 1):
        cells = [cell.strip() for cell in row]
        if not any(cells) or (number == 1 and cells[-1].lower() == "price"):
            continue
        price = _number(cells[2]) if len(cells) == 3 else None
        if price is None or cells[1] not in UNITS or not cells[0]:
            raise InputError(
                f"{name}, line {number}: expected item, unit ({', '.join(UNITS)}) and price, got "
                f"'{mark.join(row)[:40]}'; mend the line"
            )
        if (cells[0], cells[1]) in found:
            raise InputError(
                f"{name}, line {number}: {cells[0]} has a price a {cells[1]} already; keep one"
            )
        found[cells[0], cells[1]] = price
    if not found:
        raise InputError(f"{name}: no price in it; write rows as steel,kg,2.40")
    return found


def _number(text: str) -> float | None:
    """A price, None for what is none; with semicolons the comma may be a decimal one."""
    try:
        value = float(text.replace(",", "."))
    except ValueError:
        return None
    return value if math.isfinite(value) and value >= 0 else None
