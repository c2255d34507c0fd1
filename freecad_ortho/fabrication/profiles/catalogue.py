"""The catalogue of sections: from the name that one orders to the profile."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from freecad_ortho.fabrication.profiles import shapes
from freecad_ortho.fabrication.profiles.profile import Profile
from freecad_ortho.fabrication.profiles.rolled import HEA, HEB, HEM, IPE, UPE, Rolled
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    # Of the standard library from Python 3.11 on.
    from typing_extensions import Unpack

    from freecad_ortho.fabrication.profiles.profile import Called

STEELS = ("steel", "S235", "S275", "S355", "stainless")
GLULAM = ("GL24h", "GL28h", "GL30h", "GL32h")
SOLID_TIMBER = ("C24", "C30")
# Empty for whatever there is.
ANY: tuple[str, ...] = ()

_EN_10365 = "EN 10365"
_ROLLED: Mapping[str, Mapping[str, Rolled]] = {
    "IPE": IPE, "HEA": HEA, "HEB": HEB, "HEM": HEM, "UPE": UPE,
}  # fmt: skip
_HE = re.compile(r"HE(\d+)([ABM])")
_SIZE = re.compile(r"\d+(\.\d+)?")


@dataclass(frozen=True)
class Series:
    """Sections of one kind, whose names are the series', a colon and sizes in mm.

    Attributes:
        example: a name.
        sizes: what its numbers are, in order, ``height x width x wall``.
        fewest: how many of them there have to be; a square needs no second side.
        made: from the sizes to the profile; words are its name, series, material ...
        material: that it is made of by default.
        materials: that it may be made of, empty for any.
        standard: where its sizes are from.
    """

    example: str
    sizes: str
    fewest: int
    made: Callable[..., Profile]
    material: str
    materials: tuple[str, ...]
    standard: str

    @property
    def most(self) -> int:
        """How many sizes there may be."""
        return self.sizes.count(" x ") + 1


def _hot_finished(*sizes: float, **words: Unpack[Called]) -> Profile:
    """EN 10210-2, table 2 and annex B: radii of 1.5 and 1.0 times the wall for what they weigh."""
    height, width, wall = _three(sizes)
    return shapes.tube(height, width, wall, 1.5 * wall, wall, **words)


def _extruded(*sizes: float, **words: Unpack[Called]) -> Profile:
    return shapes.tube(*_three(sizes), 0.0, 0.0, **words)


def _three(sizes: tuple[float, ...]) -> tuple[float, float, float]:
    return sizes[0], sizes[-2], sizes[-1]


def _plate(thickness: float, height: float, **words: Unpack[Called]) -> Profile:
    return shapes.rectangle(thickness, height, **words)


def _timber(grade: str, standard: str) -> Series:
    return Series(
        f"{grade}:80x200", "width x height", 2, shapes.rectangle, grade, (grade,), standard
    )


SERIES: Mapping[str, Series] = {
    "tube": Series(
        *("tube:100x60x5", "height x width x wall", 2, _hot_finished, "steel"),
        *((*STEELS, "aluminium", "gfrp"), "EN 10210-2"),
    ),
    "chs": Series(
        *("chs:88.9x5", "diameter x wall", 2, shapes.round_tube, "steel"),
        *((*STEELS, "aluminium", "gfrp"), "EN 10210-2"),
    ),
    "plate": Series(
        *("plate:10x200", "thickness x height", 2, _plate, "steel", ANY, "EN 10058, EN 10029"),
    ),
    "alu": Series(
        *("alu:120x50x3", "height x width x wall", 2, _extruded, "aluminium", ("aluminium",)),
        "EN 755-9, EN 12020-2",
    ),
    **{grade: _timber(grade, "EN 14080") for grade in GLULAM},
    **{grade: _timber(grade, "EN 338, EN 1313-1") for grade in SOLID_TIMBER},
}
# Other names for the same.
_ALIASES = {"shs": "tube", "rhs": "tube"}


def names() -> tuple[str, ...]:
    """One name of every series, as a choice to begin with."""
    rolled = ("IPE200", "HEA160", "HEB160", "HEM160", "UPE160", "tee:IPE200")
    return (*(series.example for series in SERIES.values()), *rolled)


@lru_cache(maxsize=64)
def _named(text: str) -> Profile:
    series, colon, sizes = (word.strip() for word in text.partition(":"))
    known = {name.lower(): name for name in SERIES}
    key = _ALIASES.get(series.lower(), series.lower())
    if not colon:
        return _rolled(text)
    if key == "tee":
        return _rolled(sizes, tee=True)
    if key not in known:
        raise InputError(
            f"section: there is no series '{series}'; take one of {', '.join(SERIES)}, tee, "
            "polygon or a rolled section as HEB160"
        )
    name = known[key]
    return _with_sizes(name, SERIES[name], sizes)


def profile(text: str) -> Profile:
    """The profile of a name: ``tube:100x60x5``, ``HEB160``, ``GL24h:80x200``, ``polygon:FILE``.

    Args:
        text: a name. Sizes are in mm; a tube with two of them is square. Of a polygon the points
            themselves, ``polygon:0,0 60,0 30,80``, or a file with one a line; what follows ``|``
            or an empty line is a hole.

    Raises:
        InputError: an unknown series or size, sizes that make no section, a file that cannot be
            read.
    """
    if text.strip().lower().startswith("polygon:"):
        return _own(text.strip())
    return _named(text.strip())


def polygon(name: str, *rings: FloatArray) -> Profile:
    """A section of one's own.

    Args:
        name: as lists shall call it.
        rings: (n, 2) the outline, then holes; y to the right, z up, mm.

    Raises:
        InputError: outlines that make no section.
    """
    return shapes.polygon(
        [np.asarray(ring, dtype=float) for ring in rings],
        name=name,
        series="polygon",
        material="steel",
        materials=ANY,
        standard="",
    )


def _with_sizes(name: str, series: Series, sizes: str) -> Profile:
    numbers = [number.strip() for number in sizes.lower().split("x")]
    fits = series.fewest <= len(numbers) <= series.most
    if not fits or not all(_SIZE.fullmatch(number) for number in numbers):
        raise InputError(
            f"section: {name} expects {series.sizes} in mm, as {series.example}, got '{sizes}'"
        )
    values = [float(number) for number in numbers]
    return series.made(
        *values,
        name=f"{name}:{'x'.join(f'{value:g}' for value in values)}",
        series=name,
        material=series.material,
        materials=series.materials,
        standard=series.standard,
    )


def _rolled(text: str, tee: bool = False) -> Profile:
    short = _HE.sub(r"HE\2\1", re.sub(r"[\s-]", "", text).upper())
    letters, size = short[:3], short[3:]
    series = _ROLLED.get(letters)
    if series is None or (tee and letters == "UPE"):
        raise InputError(
            f"section: expected a rolled section as IPE200, HEB160 or UPE160, or a series with "
            f"sizes as tube:100x60x5, got '{text}'"
        )
    if size not in series:
        raise InputError(
            f"section: there is no {letters}{size}; take one of {letters} {', '.join(series)}"
        )
    made = shapes.tee if tee else shapes.channel if letters == "UPE" else shapes.i_section
    return made(
        series[size],
        name=f"tee:{letters}{size}" if tee else letters + size,
        series="tee" if tee else letters,
        material="steel",
        materials=STEELS,
        standard=_EN_10365,
    )


def _own(text: str) -> Profile:
    given = text.partition(":")[2].strip()
    inline = re.fullmatch(r"[-+\d.,eE\s|]*", given)
    words = given if inline else _text_of(Path(given))
    parts = words.split("|") if inline else re.split(r"\n\s*\n", words)
    rings = [_points(part, " " if inline else "\n", given) for part in parts if part.strip()]
    if not rings:
        raise InputError(f"section: {given or 'the polygon'} has no points; write one a line")
    return polygon(text if inline else f"polygon:{Path(given).stem}", *rings)


def _text_of(path: Path) -> str:
    try:
        lines = path.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        reason = getattr(error, "strerror", None) or "it is no text"
        raise InputError(
            f"section: the polygon file {path} cannot be read ({reason}); give a text file with "
            "one point a line"
        ) from error
    return "\n".join(line.partition("#")[0].strip() for line in lines if line.strip()[:1] != "#")


def _points(text: str, between: str, where: str) -> FloatArray:
    rows = [row for row in text.strip().split(between) if row.strip()]
    try:
        pairs = [[float(number) for number in re.split(r"[\s,;]+", row.strip())] for row in rows]
    except ValueError as error:
        raise InputError(
            f"section: {where}: expected two numbers a point, in mm ({error}); write 0,0 60,0 30,80"
        ) from error
    if any(len(pair) != 2 for pair in pairs):
        raise InputError(f"section: {where}: expected two numbers a point, in mm; write 0,0 60,0")
    return np.array(pairs)
