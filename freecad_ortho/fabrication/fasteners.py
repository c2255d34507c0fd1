"""What is bought to join parts: bolts with washers and nuts where they stand, and what else."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from freecad_ortho.fabrication.bolts import GRADE, HEADS, NUTS, Bolt
from solver.mesh.quadmesh import FloatArray

COLUMNS = (
    *("item", "size", "length_mm", "grip_mm", "standard", "grade", "count", "unit", "joins"),
)


@dataclass(frozen=True, eq=False)
class Fasteners:
    """Bolts that are alike, and where they stand.

    Attributes:
        bolt: their size.
        length: from under the head, mm.
        grip: from under the head to the nut, or to the plate that has the thread, mm; washers are
            within it.
        washers: of each, 0 to 2: under the head, then under the nut.
        nut: whether each has one; without, it ends in a thread.
        holds: what they join, in words.
        places: (N, 3) under the middles of their heads, mm, in the coordinates of parts.
        directions: (N, 3) unit vectors from head to thread.
        joins: (N,) names of the parts that each goes through, from the head on.
    """

    bolt: Bolt
    length: float
    grip: float
    washers: int
    nut: bool
    holds: str
    places: FloatArray
    directions: FloatArray
    joins: tuple[tuple[str, ...], ...]

    @property
    def name(self) -> str:
        """As it is ordered: ``M16x60``."""
        return f"{self.bolt.name}x{self.length:g}"

    @property
    def count(self) -> int:
        """How many there are."""
        return len(self.places)


@dataclass(frozen=True)
class Supply:
    """Something else that is bought for a structure.

    Attributes:
        item: what it is: anchor, gasket, setting block ...
        size: as it is ordered.
        count: how much of it.
        unit: "piece" or "m".
        joins: what it is for, in words.
        standard: that it follows, "" for none.
        grade: its strength, "" for none.
    """

    item: str
    size: str
    count: float
    unit: str
    joins: str
    standard: str = ""
    grade: str = ""


def gathered(
    bolt: Bolt,
    length: float,
    grip: float,
    washers: int,
    nut: bool,
    holds: str,
    each: Sequence[tuple[FloatArray, FloatArray, tuple[str, ...]]],
) -> Fasteners:
    """Fasteners of a place, a direction and the names of the parts joined, one each."""
    places = np.array([place for place, _, _ in each]).reshape(-1, 3)
    directions = np.array([direction for _, direction, _ in each]).reshape(-1, 3)
    names = tuple(joins for _, _, joins in each)
    return Fasteners(bolt, length, grip, washers, nut, holds, places, directions, names)


def named(fasteners: Iterable[Fasteners]) -> Iterator[tuple[Fasteners, list[str]]]:
    """Fasteners with a name for each of them: M16x60-0001 ..."""
    taken: dict[str, int] = {}
    for bolts in fasteners:
        if not bolts.count:
            continue
        first = taken.get(bolts.name, 0) + 1
        taken[bolts.name] = first + bolts.count - 1
        yield bolts, [f"{bolts.name}-{first + k:04d}" for k in range(bolts.count)]


def hardware_rows(fasteners: Iterable[Fasteners], supplies: Iterable[Supply]) -> list[list[object]]:
    """The list of what is bought: bolts by size, length and grip, washers, nuts, all else."""
    bolts: dict[tuple[object, ...], int] = {}
    loose: dict[tuple[str, str, str], int] = {}
    grades: dict[tuple[str, str, str], str] = {}
    for each in fasteners:
        key = (each.bolt.name, each.length, round(each.grip, 3), each.holds)
        bolts[key] = bolts.get(key, 0) + each.count
        for item, standard, of_each in (
            ("washer", each.bolt.washers, each.washers),
            ("nut", NUTS, each.nut),
        ):
            if of_each and each.count:
                kind = item, each.bolt.name, standard
                nut = GRADE[: GRADE.index(".")]
                grades[kind] = nut if item == "nut" else each.bolt.washer_grade
                loose[kind] = loose.get(kind, 0) + int(of_each) * each.count
    rows: list[list[object]] = [
        ["bolt", size, f"{length:g}", f"{grip:g}", HEADS, GRADE, count, "piece", holds]
        for (size, length, grip, holds), count in bolts.items()
        if count
    ]
    for (item, size, standard), count in sorted(loose.items(), reverse=True):
        grade = grades[item, size, standard]
        rows.append([item, size, "", "", standard, grade, count, "piece", ""])
    rows += [
        [each.item, each.size, "", "", each.standard, each.grade, *_amount(each), each.joins]
        for each in supplies
        if each.count
    ]
    return rows


def _amount(supply: Supply) -> tuple[str, str]:
    amount = f"{supply.count:.2f}" if supply.unit == "m" else f"{supply.count:g}"
    return amount, supply.unit
