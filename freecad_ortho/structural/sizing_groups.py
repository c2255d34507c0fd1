"""Sections of a list for groups of members, until the shell passes and none can be lighter."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from freecad_ortho.fabrication.profiles import profile
from freecad_ortho.structural.bending import strain_energies
from freecad_ortho.structural.check import STATIONS, Progress, StructuralCheck
from freecad_ortho.structural.groups import written
from freecad_ortho.structural.sizing import MOST, Sizing, Try, tried
from solver.option import one_of

ALL, FAMILIES, BANDS = "all", "families", "bands"
GROUPINGS = (ALL, FAMILIES, BANDS)
# Bands of utilisation, and how much stronger a group becomes at once.
_BANDS, _LEAP = 3, 2.5


def bands_of(check: StructuralCheck) -> tuple[str, ...]:
    """Band of each member: a third of them that is used least, one between, one used most."""
    used = check.utilisation
    limits = np.quantile(used, np.arange(1, _BANDS) / _BANDS)
    return tuple(f"band {k + 1}" for k in np.searchsorted(limits, used, side="left").tolist())


def by_groups(
    names: Sequence[str],
    words: Sequence[str],
    check: Callable[[str], StructuralCheck],
    progress: Progress | None = None,
) -> Sizing:
    """Give each group its section, in twenty checks at most.

    All begin with the lightest. Where members of groups are used beyond what they have, these
    groups become stronger; where it is stability or displacements that fail, the group that is
    strained most by its mass does. What then passes is made lighter group by group, the one that
    saves most first, as long as it still passes.

    Args:
        names: of the sections, the lightest first.
        words: (M,) the group of each member.
        check: with sections of groups, as ``a,border=b``.
        progress: called with a fraction and words; may raise to stop.
    """
    at = dict.fromkeys(sorted(set(words)), 0)
    tries: list[Try] = []

    def with_sections(chosen: dict[str, int]) -> StructuralCheck:
        text = written({group: names[k] for group, k in chosen.items()})
        if progress is not None:
            progress(len(tries) / MOST, text)
        found = check(text)
        tries.append(tried(text, found))
        return found

    found = with_sections(at)
    while not found.passed and len(tries) < MOST:
        larger = _larger(found, words, at, names)
        if larger is None:
            break
        at, found = larger, with_sections(larger)
    kept: set[str] = set()
    while found.passed and len(tries) < MOST:
        saved = {group: _saved(found, words, group, names[k - 1]) for group, k in at.items() if k}
        saved = {group: mass for group, mass in saved.items() if group not in kept}
        if not saved:
            break
        group = max(saved, key=lambda one: saved[one])
        lighter = {**at, group: at[group] - 1}
        other = with_sections(lighter)
        if other.passed:
            at, found = lighter, other
        else:
            kept.add(group)
    return Sizing(tuple(tries), found)


def _larger(
    found: StructuralCheck, words: Sequence[str], at: dict[str, int], names: Sequence[str]
) -> dict[str, int] | None:
    """Stronger sections where they are needed; None where no group can have one."""
    groups, last = np.array(words), len(names) - 1
    used = {group: float(found.utilisation[groups == group].max()) for group in at}
    over = [group for group in at if used[group] > 1 and at[group] < last]
    if over:
        return {**at, **{group: _stronger(names, at[group], used[group]) for group in over}}
    able = [group for group in at if at[group] < last]
    if not able:
        return None
    strained = _strained(found, groups)
    most = max(able, key=lambda group: strained[group])
    return {**at, most: at[most] + 1}


def _stronger(names: Sequence[str], at: int, used: float) -> int:
    """The first section after one that is stronger by as much as it was used, or by a leap."""
    own, wanted = profile(names[at]), min(used, _LEAP)
    for k in range(at + 1, len(names)):
        other = profile(names[k])
        gain = min(
            other.area / own.area,
            other.modulus_y / own.modulus_y,
            other.modulus_z / own.modulus_z,
        )
        if gain >= wanted:
            return k
    return len(names) - 1


def _strained(found: StructuralCheck, groups: np.ndarray) -> dict[str, float]:
    """Strain energy of groups by their mass under what fails: displacements, or buckling."""
    moves = found.deflection > found.deflection_limit
    worst = max(found.service, key=lambda one: float(one.displacement.max())) if moves else None
    by = worst or found.first_to_buckle or found.strength[0]
    whole, frame = found.model.frame, found.model.bare
    forces = np.stack([by.response.forces_at(whole, part) for part in STATIONS])
    forces = forces[:, : len(groups)]
    energy = strain_energies(found.model, forces).sum(axis=1)
    volume = frame.stiffness.area * frame.lengths
    return {
        group: float(energy[groups == group].sum() / volume[groups == group].sum())
        for group in set(groups.tolist())
    }


def _saved(found: StructuralCheck, words: Sequence[str], group: str, name: str) -> float:
    """Volume that a lighter section of a group saves, mm3."""
    own = np.array(words) == group
    frame = found.model.bare
    return float(((frame.stiffness.area - profile(name).area) * frame.lengths)[own].sum())


def refuse_unknown_grouping(word: str) -> None:
    """Refuse a way to group members that there is not.

    Raises:
        InputError: naming those that there are.
    """
    one_of("groups", word, GROUPINGS)
