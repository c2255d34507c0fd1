"""Units of length that a mesh file may be in; everything that is cut is in millimetres."""

from __future__ import annotations

from solver.option import one_of

MILLIMETRES = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4, "ft": 304.8}


def millimetres_per(unit: str) -> float:
    """Length of one unit in mm.

    Raises:
        InputError: an unknown unit.
    """
    one_of("unit", unit, MILLIMETRES)
    return MILLIMETRES[unit]
