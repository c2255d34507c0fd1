"""Which combination of a structural check is drawn: the one that governs, or any of them."""

from __future__ import annotations

from typing import Any

import numpy as np

from freecad_ortho import convert
from solver.mesh.quadmesh import FloatArray

GOVERNING = "Governing"
# Properties of a check that these are drawn from.
COMBINATIONS_FROM = ("CombinationNames", "AllForcesAlong", "AllDisplacements")


def choices(feature: Any) -> list[str]:
    """What may be drawn."""
    return [GOVERNING, *feature.CombinationNames]


def forces(feature: Any, combination: str, members: int) -> FloatArray | None:
    """(M, 3, 6) forces at start, middle and end of the members, kN and kNm.

    None while results are written.

    Args:
        feature: the structural check.
        combination: one of ``choices``.
        members: how many there are.
    """
    number = _number(feature, combination)
    rows = np.array(feature.ForcesAlong if number is None else feature.AllForcesAlong)
    start = (number or 0) * 18 * members
    found = rows[start : start + 18 * members]
    return found.reshape(-1, 3, 6) if len(found) == 18 * members else None


def displacements(feature: Any, combination: str, nodes: int) -> FloatArray | None:
    """(N, 3) of the nodes, mm; None while results are written."""
    number = _number(feature, combination)
    rows = convert.array(feature.Displacements if number is None else feature.AllDisplacements)
    start = (number or 0) * nodes
    found = rows[start : start + nodes]
    return found if len(found) == nodes else None


def _number(feature: Any, combination: str) -> int | None:
    names = list(feature.CombinationNames)
    return names.index(combination) if combination in names else None
