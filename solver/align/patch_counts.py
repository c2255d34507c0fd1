"""How many quads there are along each side of faces that meet, so that all of them fit.

Source: Tam, Armstrong (1993), Finite element mesh control by integer programming.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.optimize import Bounds, LinearConstraint, milp
from scipy.sparse import coo_array, csr_array

from solver.align.facets import FlatFaces

# Lengths that differ by a smaller part of the longest are alike.
_ALIKE = 1e-5
# A length just between two numbers gets the smaller one, on both sides of a symmetric roof.
_DOWN = 1e-4
# Seconds for the numbers along sides; a roof of two hundred faces takes one.
_LONGEST = 20.0

# A sum of numbers: which -> how often.
_Sum = dict[int, float]


def counts_along(
    facets: FlatFaces, edge: float, even: Sequence[int] = ()
) -> tuple[list[int], list[list[int]]] | None:
    """Whole numbers of quads for which ``sum (n - l)^2 / (l + 1)`` over chains is least.

    There l is a chain's length over that of an edge. Chains that are alike have as many, where that
    fits, so that a symmetric roof gets a symmetric net. Opposite sides of a grid have as many; side
    i of another face as many as ways i - 1 and i + 1 from its sides to its middle together.

    Args:
        facets: the faces.
        edge: wanted edge length.
        even: chains that have an even number.

    Returns:
        the number along each chain, and on each way of each face, none of grids; None where no
        numbers fit.
    """
    wanted = [chain.length / edge * (1 - _DOWN) for chain in facets.chains]
    chains = len(wanted)
    equal, starts, total = _fitting(facets, 2 * chains)
    equal += [{number: 1.0, total + k: -2.0} for k, number in enumerate(even)]
    total += len(even)
    alike = _alike(facets)
    least: list[_Sum] = []
    right: list[float] = []
    for number, length in enumerate(wanted):
        # The cost of a chain is not below its secants from each number to the next.
        n = np.arange(1, int(3 * length) + 4)
        cost = (n - length) ** 2 / (length + 1)
        for k, slope in enumerate(np.diff(cost).tolist()):
            least.append({chains + number: 1.0, number: -slope})
            right.append(cost[k] - slope * n[k])
    whole = np.ones(total)
    whole[chains : 2 * chains] = 0
    # What HiGHS simplifies beforehand saves nothing here, and it writes a line of its own then.
    for same in (alike, []) if alike else ([],):
        fitting = _matrix([*equal, *same], total)
        solved = milp(
            1.0 - whole,
            integrality=whole,
            bounds=Bounds(whole, np.inf),
            constraints=[
                LinearConstraint(fitting, 0.0, 0.0),
                LinearConstraint(_matrix(least, total), np.array(right), np.inf),
            ],
            options={"time_limit": _LONGEST, "mip_rel_gap": 0.0, "presolve": False},
        )
        if solved.x is not None:
            break
    else:
        return None
    found = np.round(solved.x).astype(int).tolist()
    ways = [
        found[start : start + len(sides)] if len(sides) != 4 else []
        for sides, start in zip(facets.sides, starts, strict=True)
    ]
    return found[:chains], ways


def _fitting(facets: FlatFaces, first: int) -> tuple[list[_Sum], list[int], int]:
    """Sums that are zero where faces fit; the first way of each face, and how many numbers."""
    equal: list[_Sum] = []
    starts, total = [], first
    for sides in facets.sides:
        starts.append(total)
        sums = [{number: 1.0 for number, _ in side} for side in sides]
        if len(sides) == 4:
            pairs = [(sums[0], list(sums[2])), (sums[1], list(sums[3]))]
        else:
            ways = list(range(total, total + len(sides)))
            total += len(sides)
            pairs = [(one, [ways[k - 1], ways[k + 1 - len(ways)]]) for k, one in enumerate(sums)]
        for one, others in pairs:
            row = dict(one)
            for column in others:
                row[column] = row.get(column, 0.0) - 1.0
            equal.append(row)
    return equal, starts, total


def _alike(facets: FlatFaces) -> list[_Sum]:
    """Differences of chains that are as long as each other, between faces as large."""
    lengths = np.array([chain.length for chain in facets.chains])
    around: list[list[int]] = [[] for _ in lengths]
    for sides in facets.sides:
        own = [number for side in sides for number, _ in side]
        size = round(float(lengths[own].sum() / lengths.max()) / _ALIKE)
        for number in own:
            around[number].append(size)
    found: dict[tuple[int, ...], int] = {}
    equal: list[_Sum] = []
    for number, sizes in enumerate(around):
        key = (round(float(lengths[number] / lengths.max()) / _ALIKE), *sorted(sizes))
        if found.setdefault(key, number) != number:
            equal.append({found[key]: 1.0, number: -1.0})
    return equal


def _matrix(rows: list[_Sum], columns: int) -> csr_array:
    row = np.repeat(np.arange(len(rows)), [len(each) for each in rows])
    column = [key for each in rows for key in each]
    values = [value for each in rows for value in each.values()]
    return csr_array(coo_array((values, (row, column)), shape=(len(rows), columns)))
