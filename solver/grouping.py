"""Parts in groups, as terms that draw them to the shapes of their groups."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from solver.analysis.kinds import EDGES, NODES, spokes
from solver.analysis.rows import rows_along
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.terms.base import Term
from solver.terms.repetition import SameAngles, SameLengths
from solver.tuning import Tuning

Groups = SameLengths | SameAngles


def groups_of(terms: Sequence[Term]) -> list[Groups]:
    """Those of the terms that are groups."""
    return [term for term in terms if isinstance(term, SameLengths | SameAngles)]


def in_rows(mesh: QuadMesh, x: FloatArray, of: str, family: int, most: int | None) -> list[Groups]:
    """The parts grouped by rows along a family of lines.

    Args:
        mesh: the mesh.
        x: flat vector of the shape that is grouped.
        of: panels, edges or nodes.
        family: of the lines.
        most: how many groups there may be. Where there are fewer rows, these are cut into pieces.
    """
    count = len(np.unique(rows_along(mesh, of, family)))
    rows = rows_along(mesh, of, family, max(1, (most or 0) // count))
    found = []
    for numbers, term in ungrouped(mesh, of):
        kind = np.unique(rows[numbers], return_inverse=True)[1].reshape(-1)
        shapes = np.zeros((int(kind.max()) + 1, term.shapes.shape[1]))
        turn = np.zeros(len(kind), dtype=np.int64)
        settled = replace(term, shapes=shapes, kind=kind, turn=turn, settled=True)
        found.append(settled.follow(x))
    return found


def merged(terms: Sequence[Groups], number: int, x: FloatArray) -> list[Groups]:
    """The same in so many groups at most: those that are most alike become one."""
    shares = _shares([len(term.groups) for term in terms], number)
    return [_merged(term, share).follow(x) for term, share in zip(terms, shares, strict=True)]


def near_ones(mesh: QuadMesh, x: FloatArray, of: str, number: int, rounds: int) -> list[Groups]:
    """The parts in so many groups of those that are alike already, by so many rounds of k-means."""
    rng, blank, found = np.random.default_rng(0), ungrouped(mesh, of), []
    shares = _shares([len(numbers) for numbers, _ in blank], number)
    for (_, term), share in zip(blank, shares, strict=True):
        term = replace(term, shapes=_seeds(term, x, share, rng))
        for _ in range(rounds):
            before, term = term.shapes, term.follow(x)
            if np.array_equal(before, term.shapes):
                break
        found.append(term)
    return found


def stressed(term: Groups, x: FloatArray, tuning: Tuning) -> Groups:
    """The same with more weight on parts that are far from their shapes."""
    placed = term.sorted(x)
    miss = np.abs(placed.values(x) - placed.wanted).max(axis=1)
    share = np.clip(miss / max(float(miss.max()), 1e-300), tuning.least_stress, 1.0)
    stress = share ** (tuning.stress_power / 2 - 1)
    return replace(placed, stress=stress / np.sqrt((stress**2).mean()))


def unstressed(term: Groups) -> Groups:
    """The same without more weight on some."""
    return replace(term, stress=np.ones(len(term.groups)))


def ungrouped(mesh: QuadMesh, of: str) -> list[tuple[IntArray, Groups]]:
    """Numbers of parts, and they in no groups yet; nodes with different numbers of edges apart."""
    if of == NODES:
        found: list[tuple[IntArray, Groups]] = []
        for hubs in spokes(mesh):
            groups = np.column_stack([hubs.vertices, hubs.neighbours])
            count = hubs.neighbours.shape[1]
            turns = _around(count) if hubs.closed else _around(count)[:1]
            shapes = np.zeros((1, count * (count - 1) // 2))
            found.append((hubs.vertices, SameAngles(groups, turns, shapes, np.ones(len(groups)))))
        return found
    if of == EDGES:
        edges = mesh.connectivity.edges
        lengths = SameLengths(edges, np.array([[0, 1]]), np.zeros((1, 1)), np.ones(len(edges)))
        return [(np.arange(len(edges)), lengths)]
    panels = SameLengths(mesh.faces, _around(4), np.zeros((1, 6)), np.ones(len(mesh.faces)))
    return [(np.arange(len(mesh.faces)), panels)]


def _shares(sizes: Sequence[int], number: int) -> list[int]:
    """How many of so many groups each make of parts has."""
    return [max(1, round(number * size / sum(sizes))) for size in sizes]


def _around(count: int) -> IntArray:
    return (np.arange(count)[:, None] + np.arange(count)) % count


def _seeds(term: Groups, x: FloatArray, number: int, rng: np.random.Generator) -> FloatArray:
    """Values of so many parts that are far from each other.

    Source: Arthur, Vassilvitskii (2007), k-means++: the advantages of careful seeding.
    """
    values = term.values(x)
    turned, chosen = values[:, term.orders], [int(rng.integers(len(values)))]
    away = np.full(len(values), np.inf)
    while len(chosen) < number:
        last = ((turned - values[chosen[-1]]) ** 2).sum(axis=2).min(axis=1)
        away = np.minimum(away, last)
        if away.max() <= 1e-24:
            break
        chosen.append(int(rng.choice(len(values), p=away / away.sum())))
    return np.asarray(values[chosen])


def _merged(term: Groups, number: int) -> Groups:
    """The same with no more groups than that: two that are most alike become one, again and again.

    Source: Ward (1963), Hierarchical grouping to optimize an objective function.
    """
    assert term.kind is not None
    shapes, orders = term.shapes.copy(), term.orders
    weight = np.bincount(term.kind, minlength=len(shapes)).astype(float)
    group, turn = np.arange(len(shapes)), np.zeros(len(shapes), dtype=np.int64)
    left = list(range(len(shapes)))
    while len(left) > number:
        turned = shapes[left][:, orders]
        away = ((turned[:, :, None] - shapes[left]) ** 2).sum(axis=3)
        # Groups without parts cost nothing.
        sums = np.maximum(weight[left][:, None] + weight[left], 1.0)
        both = weight[left][:, None] * weight[left] / sums
        cost = away * both[:, None, :]
        cost[np.arange(len(left)), :, np.arange(len(left))] = np.inf
        i, t, j = np.unravel_index(int(np.argmin(cost)), cost.shape)
        one, other = left[int(i)], left[int(j)]
        parts = np.array([weight[one], weight[other]]) / max(weight[one] + weight[other], 1.0)
        shapes[other] = parts[0] * shapes[one][orders[t]] + parts[1] * shapes[other]
        weight[other] += weight[one]
        joined = group == one
        group[joined], turn[joined] = other, (turn[joined] + t) % len(orders)
        left.remove(one)
    place = np.searchsorted(left, group)
    return replace(term, shapes=shapes[left], kind=place[term.kind], turn=turn[term.kind])
