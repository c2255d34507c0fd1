"""How numbers with units, places and planes are written, on the command line and in macros.

The command line takes numbers without unit for those of the file, macros for mm.
"""

from __future__ import annotations

import math
import re

import numpy as np

from freecad_ortho.units import MILLIMETRES
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray

# A number and the unit behind it.
_QUANTITY = re.compile(r"\s*([-+.\d]+(?:e[-+]?\d+)?)\s*(?:([a-z°]+)(\^?2)?)?\s*", re.IGNORECASE)
# A force, and what length or area it is for.
_LOAD = re.compile(
    r"\s*([-+.\d]+(?:e[-+]?\d+)?)\s*([kM]?N)?\s*(?:/\s*([a-z]+)(\^?2)?)?\s*", re.IGNORECASE
)
_ANGLES = {"deg": 1.0, "°": 1.0, "rad": math.degrees(1.0)}
_KILONEWTONS = {"n": 1e-3, "kn": 1.0, "mn": 1e3}
_POWERS = {"length": 1, "distance": 1, "area": 2}
# Loads, and of what power of length each is.
LOADS = {"force": 0, "per_length": 1, "per_area": 2}
_AXES = "xyz"


def number(text: str, kind: str, unit: str, bare: str | None = None) -> float | None:
    """The number that a text says with or without a unit; None where it says none of this kind.

    Args:
        text: ``1.5``, ``1500 mm``, ``2 m2``, ``0.5 rad``, ``1.5 kN/m2``.
        kind: of an :class:`solver.option.Option`.
        unit: of length, of the value.
        bare: that of a text without one, by default the same.
    """
    if kind in LOADS:
        return _load(text, LOADS[kind], unit, bare or unit)
    match = _QUANTITY.fullmatch(text)
    if match is None:
        return None
    word, square = (match[2] or "").lower(), match[3]
    factor: float | None = None
    if kind == "angle" and not square:
        factor = _ANGLES.get(word or "deg")
    elif kind in _POWERS and (not word or (kind == "area") == bool(square)):
        of = MILLIMETRES.get(word or bare or unit)
        factor = of and (of / MILLIMETRES[unit]) ** _POWERS[kind]
    elif not word:
        factor = 1.0
    return _times(match[1], factor)


def place(
    name: str, text: str, unit: str = "mm", bare: str | None = None
) -> tuple[int, FloatArray]:
    """The vertex and the (3,) place of ``12:0,0,3.5m``.

    Args:
        name: what is read, for refusals.
        text: as it was given.
        unit: of the place.
        bare: that of numbers without one, by default the same.

    Raises:
        InputError: another text.
    """
    vertex, _, where = text.partition(":")
    numbers = [number(word, "distance", unit, bare) for word in where.split(",")]
    if not vertex.strip().isdecimal() or len(numbers) != 3 or None in numbers:
        raise InputError(f"{name}: expected I:x,y,z such as 12:0,0,3.5m, got '{text[:40]}'")
    return int(vertex), np.array(numbers, dtype=np.float64)


def plane(text: str, unit: str = "mm", bare: str | None = None) -> tuple[int, float] | None:
    """Number of the axis and place of ``z=0`` or ``x=1.5m``; None of another text.

    Args:
        text: as it was given.
        unit: of the place.
        bare: that of a number without one, by default the same.
    """
    axis, sign, where = text.replace(" ", "").partition("=")
    found = number(where, "distance", unit, bare) if sign else None
    return None if found is None or axis not in tuple(_AXES) else (_AXES.index(axis), found)


def mirror_planes(text: str) -> str:
    """Letters of coordinate planes, without what parts them: ``x, y`` is ``xy``.

    Raises:
        InputError: another letter.
    """
    letters = text.replace(",", "").replace(" ", "").lower()
    if set(letters) - set(_AXES):
        raise InputError(f"symmetry: expected letters out of x, y, z, got '{text[:40]}'")
    return letters


def _load(text: str, power: int, unit: str, bare: str) -> float | None:
    """A force by a power of length, kN where its unit is named."""
    match = _LOAD.fullmatch(text)
    if match is None or (match[3] and power != (2 if match[4] else 1)):
        return None
    of = MILLIMETRES.get((match[3] or bare).lower())
    force = _KILONEWTONS[(match[2] or "kN").lower()]
    return _times(match[1], of and force * (MILLIMETRES[unit] / of) ** power)


def _times(digits: str, factor: float | None) -> float | None:
    try:
        value = float(digits)
    except ValueError:
        return None
    if factor is None or not math.isfinite(value):
        return None
    return value if factor == 1.0 else value * factor
