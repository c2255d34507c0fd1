"""Results as tables; forces in kN and kNm, lengths and displacements in mm."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from freecad_ortho.structural.check import StructuralCheck
from freecad_ortho.structural.sizing import Try
from solver.mesh.quadmesh import FloatArray

_AT = (("start", 0.0), ("middle", 0.5), ("end", 1.0))
_NAMES = ("N_kN", "Vy_kN", "Vz_kN", "T_kNm", "My_kNm", "Mz_kNm")
_MOVES = ("ux_mm", "uy_mm", "uz_mm", "rx_mrad", "ry_mrad", "rz_mrad")
_PUSHES = ("Fx_kN", "Fy_kN", "Fz_kN", "Mx_kNm", "My_kNm", "Mz_kNm")
# From N and Nmm.
_KILO = np.array([1e-3, 1e-3, 1e-3, 1e-6, 1e-6, 1e-6])
_MILLI = np.array([1.0, 1.0, 1.0, 1e3, 1e3, 1e3])

Row = tuple[Any, ...]


def members(check: StructuralCheck) -> tuple[tuple[str, ...], Iterator[Row]]:
    """Every member with its utilisation and, in the combination that governs it, its forces.

    First those that govern, then those of first order at both ends and in the middle.
    """
    named = ("member", "first_node", "second_node", "family", "section_name", "length_mm")
    used = ("utilisation", "section", "member_buckling", "governing", "shape")
    places = (f"{name}_{place}" for place in ("governing", *dict(_AT)) for name in _NAMES)
    return (*named, *used, *places), _members(check)


def _members(check: StructuralCheck) -> Iterator[Row]:
    frame, found = check.model.bare, check.strength
    ends = np.asarray(check.model.mesh.connectivity.edges)
    sections = [group.profile.name for group in check.model.groups]
    of_group = check.model.section_numbers.tolist()
    whole = check.model.frame
    forces = [[one.response.forces_at(whole, part) for _, part in _AT] for one in found]
    for member, ((one, two), length) in enumerate(zip(ends, frame.lengths, strict=True)):
        number = int(check.governing[member])
        by = found[number]
        values = (check.governing_forces, *forces[number])
        row = np.concatenate([each[member] * _KILO for each in values])
        shape = "deformed" if check.governed_deformed[member] else "drawn"
        yield (
            *(member, int(one), int(two), check.model.families[member]),
            *(sections[of_group[member]], f"{length:.1f}"),
            *(f"{check.utilisation[member]:.4f}", f"{by.section[member]:.4f}"),
            *(f"{by.member[member]:.4f}", by.combination.name, shape, *_shown(row)),
        )


def forces(check: StructuralCheck) -> tuple[tuple[str, ...], Iterator[Row]]:
    """Forces of every member in every combination for strength, at both ends and the middle."""
    return ("combination", "member", "at", *_NAMES), _forces(check)


def _forces(check: StructuralCheck) -> Iterator[Row]:
    for one in check.strength:
        for place, part in _AT:
            values = one.response.forces_at(check.model.frame, part) * _KILO
            for member, row in enumerate(values[: len(check.model.families)]):
                yield (one.combination.name, member, place, *_shown(row))


def displacements(check: StructuralCheck) -> tuple[tuple[str, ...], Iterator[Row]]:
    """Displacements and rotations of every node in every combination for service."""
    return ("combination", "node", *_MOVES), _displacements(check)


def _displacements(check: StructuralCheck) -> Iterator[Row]:
    used = np.flatnonzero(check.model.mesh.connectivity.referenced)
    for one in check.service:
        for node in used.tolist():
            row = one.response.displacements[node] * _MILLI
            yield (one.combination.name, node, *_shown(row))


def reactions(check: StructuralCheck) -> tuple[tuple[str, ...], Iterator[Row]]:
    """What supports push and turn the frame by, in every combination."""
    return ("combination", "node", *_PUSHES), _reactions(check)


def _reactions(check: StructuralCheck) -> Iterator[Row]:
    supports = check.model.supports
    held = np.flatnonzero((supports.fixed | (supports.springs > 0)).any(axis=1))
    for one in check.found:
        for node in held.tolist():
            row = one.response.reactions[node] * _KILO
            yield (one.combination.name, node, *_shown(row))


def buckling(check: StructuralCheck) -> tuple[tuple[str, ...], Iterator[Row]]:
    """Factors of the buckling modes of every combination for strength."""
    return ("combination", "mode", "factor"), _buckling(check)


def _buckling(check: StructuralCheck) -> Iterator[Row]:
    for one in check.strength:
        factors = [] if one.buckling is None else one.buckling.factors.tolist()
        for number, factor in enumerate(factors, 1):
            yield (one.combination.name, number, f"{factor:.4f}")


def sizing(tries: Sequence[Try]) -> tuple[tuple[str, ...], Iterator[Row]]:
    """Sections that were tried, the lightest first."""
    columns = ("section", "mass_kg", "utilisation", "buckling_factor", "displacement_mm", "passed")
    return columns, _sizing(tries)


def _sizing(tries: Sequence[Try]) -> Iterator[Row]:
    for one in tries:
        factor = "" if one.factor is None else f"{one.factor:.3f}"
        numbers = (f"{one.mass:.1f}", f"{one.utilisation:.4f}", factor, f"{one.displacement:.2f}")
        yield (one.section, *numbers, "yes" if one.passed else "no")


def _shown(row: FloatArray) -> list[str]:
    # Adding zero takes the sign off what is rounded to nothing.
    return [f"{value + 0.0:.4f}" for value in np.round(row, 4).tolist()]


TABLES = {
    "members.csv": members,
    "forces.csv": forces,
    "displacements.csv": displacements,
    "reactions.csv": reactions,
    "buckling.csv": buckling,
}
