"""Combinations of load cases: those of EN 1990, and tables of one's own."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from freecad_ortho.structural.model import IMPOSED, PERMANENT, SNOW, WIND, Case
from solver.errors import InputError

# Partial factors of EN 1990, table A1.2(B), equation 6.10.
_PERMANENT, _FAVOURABLE, _VARIABLE = 1.35, 1.0, 1.5
# Factors of what goes with a leading load: EN 1990, table A1.1 (snow below 1000 m, imposed loads
# of categories A and B).
COMPANION = {SNOW: 0.5, WIND: 0.6, IMPOSED: 0.7}
STRENGTH, SERVICE = "strength", "service"


@dataclass(frozen=True)
class Combination:
    """Load cases with their factors.

    Attributes:
        name: as in the tables.
        kind: strength, for forces and buckling, or service, for displacements.
        factors: of the cases by their names.
    """

    name: str
    kind: str
    factors: Mapping[str, float]

    def permanent(self, cases: Sequence[Case]) -> bool:
        """Whether no load of it ever goes away."""
        kinds = {case.name: case.kind for case in cases}
        return all(kinds[name] == PERMANENT for name in self.factors)


def usual(cases: Sequence[Case]) -> tuple[Combination, ...]:
    """Combinations of EN 1990, 6.4.3.2 (6.10) and 6.5.3 (characteristic).

    Every variable load leads once, with the others and, where the weight helps against it, alone.
    Of cases of one kind, such as winds, one acts at a time.
    """
    always = [case.name for case in cases if case.kind == PERMANENT]
    changing = [case for case in cases if case.kind != PERMANENT]
    found = []
    for kind, heavy, light, lead in (
        (STRENGTH, _PERMANENT, _FAVOURABLE, _VARIABLE),
        (SERVICE, 1.0, 1.0, 1.0),
    ):
        if always:
            found.append(_named(kind, dict.fromkeys(always, heavy)))
        for leader in changing:
            others = [case for case in changing if case.kind != leader.kind]
            first: dict[str, Case] = {}
            for case in others:
                first.setdefault(case.kind, case)
            for companion in _choices(others):
                factors = dict.fromkeys(always, heavy) | {leader.name: lead}
                factors |= {case.name: lead * COMPANION[case.kind] for case in companion}
                found.append(_named(kind, factors))
            if always and light < heavy:
                found.append(_named(kind, dict.fromkeys(always, light) | {leader.name: lead}))
    return tuple(found)


def _choices(cases: Sequence[Case]) -> list[list[Case]]:
    """One case of every kind, in all ways."""
    choices: list[list[Case]] = [[]]
    for kind in dict.fromkeys(case.kind for case in cases):
        same = [case for case in cases if case.kind == kind]
        choices = [[*chosen, case] for chosen in choices for case in same]
    return choices


def _named(kind: str, factors: Mapping[str, float]) -> Combination:
    words = " + ".join(f"{factor:g} {name}" for name, factor in factors.items())
    return Combination(f"{kind}: {words}", kind, factors)


def combinations_of(
    given: str | os.PathLike[str] | Sequence[str] | None, cases: Sequence[Case]
) -> tuple[Combination, ...]:
    """The combinations that are asked for.

    Args:
        given: a JSON file; or lines as ``strength: 1.35 self-weight + 1.5 snow``; those of EN 1990
            where there are none.
        cases: that there are.

    Raises:
        InputError: a file or a line that says no combination.
    """
    if isinstance(given, (str, os.PathLike)):
        return read_combinations(given, cases)
    return tuple(_of_line(line, cases) for line in given) if given else usual(cases)


def _of_line(line: str, cases: Sequence[Case]) -> Combination:
    kind, colon, sum_ = (word.strip() for word in line.partition(":"))
    pairs = [part.strip().partition(" ") for part in sum_.split(" + ")]
    try:
        factors = {name.strip(): float(number) for number, _, name in pairs}
    except ValueError:
        factors = {}
    if not colon or not factors or len(factors) < len(pairs):
        raise InputError(
            "combinations: expected lines as 'strength: 1.35 self-weight + 1.5 snow', got "
            f"'{line[:60]}'"
        )
    row = {"name": line.strip(), "kind": kind, "factors": factors}
    return _read("combinations", row, [case.name for case in cases])


def read_combinations(
    path: str | os.PathLike[str], cases: Sequence[Case]
) -> tuple[Combination, ...]:
    """Combinations from a JSON file as ``combinations.json``, which every check writes.

    Args:
        path: of the file.
        cases: that there are.

    Raises:
        InputError: a file that cannot be read, or holds no such table.
    """
    try:
        data = json.loads(Path(path).read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise InputError(
            f"{os.fspath(path)}: is no JSON file that can be read ({error}); start from the "
            "combinations.json of a check"
        ) from error
    rows = data.get("combinations") if isinstance(data, dict) else None
    if not isinstance(rows, list) or not rows:
        raise InputError(f"{os.fspath(path)}: expected a list 'combinations' with one at least")
    return tuple(_read(os.fspath(path), row, [case.name for case in cases]) for row in rows)


def _read(path: str, row: Any, cases: Sequence[str]) -> Combination:
    whole = isinstance(row, dict) and isinstance(row.get("factors"), dict) and row["factors"]
    name = row.get("name") if isinstance(row, dict) else None
    if not whole or not isinstance(name, str) or row.get("kind") not in (STRENGTH, SERVICE):
        raise InputError(
            f"{path}: expected combinations with name, kind ({STRENGTH} or {SERVICE}) and factors, "
            f"got {json.dumps(row)[:60]}"
        )
    for case, factor in row["factors"].items():
        if case not in cases:
            raise InputError(f"{path}: '{name}' has no load case '{case}'; there are "
                             f"{', '.join(cases)}")  # fmt: skip
        number = isinstance(factor, (int, float)) and not isinstance(factor, bool)
        if not number or abs(factor) > 1e6:
            raise InputError(f"{path}: '{name}' expects a number for '{case}', got {factor!r}")
    return Combination(name, row["kind"], row["factors"])
