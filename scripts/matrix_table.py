"""Prints one table of several test runs: a row a suite, a column a FreeCAD.

usage: python scripts/matrix_table.py here.xml trixie.xml ...
"""

from __future__ import annotations

import re
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path


def read(path: Path) -> tuple[str, dict[str, str]]:
    """Read a JUnit file: what FreeCAD said of itself, and seconds (or the verdict) by test name.

    A test has recorded the former as the property "freecad".
    """
    run = ElementTree.parse(path).getroot()
    versions = [item.get("value") for item in run.iter("property") if item.get("name") == "freecad"]
    column = {_short(case.get("name", "?")): _verdict(case) for case in run.iter("testcase")}
    return versions[0] if versions else "FreeCAD ? (no suite ran)", column


def _short(test: str) -> str:
    return re.sub(r"^test_\w+\[(ortho_\w+)\]$", r"\1", test)


def _verdict(case: ElementTree.Element) -> str:
    if case.find("failure") is not None or case.find("error") is not None:
        return "FAILED"
    if case.find("skipped") is not None:
        return "skipped"
    return f"{float(case.get('time', 0)):.1f}"


def table(columns: dict[str, dict[str, str]]) -> str:
    """Lay out a table; rows that took no time anywhere are left out.

    Args:
        columns: heading -> test name -> seconds or verdict.
    """
    names = list(dict.fromkeys(name for column in columns.values() for name in column))
    names = [name for name in names if any(c.get(name, "0.0") != "0.0" for c in columns.values())]
    rows = [["seconds", *columns]]
    rows += [[name, *(column.get(name, "-") for column in columns.values())] for name in names]
    rows.append(["in all", *(f"{_total(column):.1f}" for column in columns.values())])
    widths = [max(map(len, cells)) for cells in zip(*rows, strict=True)]
    return "\n".join(_line(row, widths) for row in rows)


def _total(column: dict[str, str]) -> float:
    return sum(float(cell) for cell in column.values() if cell[0].isdigit())


def _line(cells: list[str], widths: list[int]) -> str:
    first, *rest = (cell.rjust(width) for cell, width in zip(cells, widths, strict=True))
    return "  ".join([first.strip().ljust(widths[0]), *rest])


def main(paths: list[Path]) -> None:
    """Print the versions and the table."""
    columns = {}
    for path in paths:
        versions, column = read(path)
        print(f"{path.stem}: {versions}")
        columns[f"{versions.split()[1]} ({path.stem})"] = column
    print(table(columns))


if __name__ == "__main__":
    main([Path(name) for name in sys.argv[1:]])
