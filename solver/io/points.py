"""Lists of points or values: one row a line, numbers apart by commas, semicolons or blanks.

In a line with semicolons, a comma between two digits is a decimal comma.
"""

from __future__ import annotations

import os
import re

import numpy as np

from solver.errors import InputError
from solver.io.reading import read_text
from solver.mesh.quadmesh import FloatArray

_DECIMAL_COMMA = re.compile(r"(?<=\d),(?=\d)")


def read_points(
    path: str | os.PathLike[str], columns: tuple[int, ...] = (3,), least: int = 2
) -> FloatArray:
    """(n, k) numbers of a text file; ``#`` starts a comment, ``v`` lines of an OBJ file count too.

    Args:
        path: the file.
        columns: how many numbers a row may have.
        least: how many rows there have to be.

    Raises:
        InputError: a row that is not numbers, rows of different length, or too few of them.
    """
    name, rows = os.fspath(path), []
    only_v = name.lower().endswith(".obj")
    for number, line in enumerate(read_text(path).split("\n"), start=1):
        data = line.split("#")[0]
        if ";" in data:
            data = _DECIMAL_COMMA.sub(".", data).replace(";", " ")
        words = data.replace(",", " ").split()
        if not words or (only_v and words[0] != "v"):
            continue
        try:
            rows.append([float(word) for word in words[only_v:]])
        except ValueError:
            raise InputError(
                f"{name}, line {number}: expected numbers, got '{line.strip()[:40]}'; mend the line"
            ) from None
        if len(rows[-1]) not in columns or len(rows[-1]) != len(rows[0]):
            wanted = " or ".join(str(k) for k in columns)
            raise InputError(
                f"{name}, line {number}: expected {wanted} numbers a line, all alike, got "
                f"{len(rows[-1])}; mend the line (a comma alone separates: decimals have a point)"
            )
    if len(rows) < least:
        raise InputError(f"{name}: expected at least {least} points, got {len(rows)}; add points")
    if not np.isfinite(rows).all():
        raise InputError(f"{name}: expected finite numbers, got NaN or infinite ones; mend it")
    return np.array(rows, dtype=np.float64).reshape(len(rows), -1 if rows else columns[0])
