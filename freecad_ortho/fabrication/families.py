"""Which parts are equal: groups of the same length, the same flat pattern, the same node.

Every member of a group is within the tolerance of the group's first member, so groups do not creep.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.spatial import cKDTree

from freecad_ortho.fabrication.nodes import Node
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.pattern import FlatPattern
from solver.mesh.quadmesh import FloatArray

TOLERANCE_MM = 1.0
TOLERANCE_DEG = 0.1


@dataclass(frozen=True)
class Families:
    """Names in groups; those without an equal are groups of one.

    Attributes:
        lengths: for each kind of part, groups of equal length.
        shapes: for each kind of part, groups of congruent flat patterns of one thickness.
        nodes: groups of nodes where beams meet under the same angles.
    """

    lengths: dict[str, list[list[str]]]
    shapes: dict[str, list[list[str]]]
    nodes: list[list[str]]

    @property
    def equal_to(self) -> dict[str, str]:
        """The first member of the group of each part and node."""
        groups = [*self.nodes, *(group for kind in self.shapes.values() for group in kind)]
        return {name: group[0] for group in groups for name in group}

    def report(self) -> dict[str, Any]:
        """How many different ones there are, and the groups of more than one."""

        def counted(groups: list[list[str]]) -> dict[str, Any]:
            equal = sorted((group for group in groups if len(group) > 1), key=len, reverse=True)
            return {"different": len(groups), "groups": equal}

        return {
            "tolerance_mm": TOLERANCE_MM,
            "tolerance_deg": TOLERANCE_DEG,
            "lengths": {kind: counted(groups) for kind, groups in self.lengths.items()},
            "shapes": {kind: counted(groups) for kind, groups in self.shapes.items()},
            "nodes": counted(self.nodes),
        }


def families(parts: Sequence[Part], nodes: Sequence[Node]) -> Families:
    """Group equal parts and nodes, within 1 mm and 0.1 degrees."""
    kinds = {kind: [p for p in parts if p.kind == kind] for kind in _kinds(parts)}
    lengths, shapes = {}, {}
    for kind, some in kinds.items():
        names = [part.name for part in some]
        lengths[kind] = _named(names, _groups(np.array([[part.length] for part in some]), 1.0))
        if all(part.pattern is not None for part in some):
            shapes[kind] = _named(names, _shape_groups(some))
    return Families(lengths, shapes, _named([node.name for node in nodes], _node_groups(nodes)))


def congruent(one: FlatPattern, other: FlatPattern, tolerance: float = TOLERANCE_MM) -> bool:
    """Tell whether a pattern can be laid on another, turned but not flipped.

    Corners and hole centres then lie within the tolerance (mm) of each other.
    """
    if len(one.outline) != len(other.outline) or len(one.cutouts) != len(other.cutouts):
        return False
    z, w = _centred(one.outline), _centred(other.outline)
    count = len(z)
    shifted = w[(np.arange(count)[:, None] + np.arange(count)) % count]
    turn = shifted @ z.conj()
    turn /= np.maximum(np.abs(turn), np.finfo(float).tiny)
    miss = np.abs(shifted - turn[:, None] * z).max(axis=1)
    fitting = turn[miss <= tolerance]
    return any(_same_openings(one, other, each, tolerance) for each in fitting)


def _same_openings(one: FlatPattern, other: FlatPattern, turn: complex, tolerance: float) -> bool:
    first, second = _openings(one), _openings(other)
    if len(first) != len(second):
        return False
    if not len(first):
        return True
    apart = np.abs(turn * first[:, 0][:, None] - second[:, 0][None])
    unlike = np.abs(first[:, 1][:, None] - second[:, 1][None])
    fits = (apart <= tolerance) & (unlike <= tolerance)
    return bool(fits.any(axis=0).all() and fits.any(axis=1).all())


def _openings(pattern: FlatPattern) -> Any:
    """(K, 2) complex: centre from the outline's mean corner, and size, of holes and cutouts."""
    middle = pattern.outline.mean(axis=0)
    rows = [(hole.centre - middle, hole.diameter) for hole in pattern.holes]
    rows += [
        (cut.mean(axis=0) - middle, float(np.linalg.norm(np.ptp(cut, axis=0))))
        for cut in pattern.cutouts
    ]
    return np.array([(complex(*centre), size) for centre, size in rows]).reshape(-1, 2)


def _centred(outline: FloatArray) -> Any:
    arms = outline - outline.mean(axis=0)
    return arms[:, 0] + 1j * arms[:, 1]


def _shape_groups(parts: Sequence[Part]) -> list[list[int]]:
    """Groups of numbers of parts whose patterns are congruent.

    The descriptor moves by at most twice the distance that corners move, so a ball of twice the
    tolerance holds every pattern that can be congruent.
    """
    rows = []
    for part in parts:
        outline = part.pattern.outline  # type: ignore[union-attr]
        reach = np.linalg.norm(outline - outline.mean(axis=0), axis=1)
        side = np.linalg.norm(np.roll(outline, -1, axis=0) - outline, axis=1)
        rows.append(
            [
                *(reach.min(), reach.mean(), reach.max()),
                *(side.min(), side.mean(), side.max()),
                1e3 * part.thickness,
            ]
        )
    return _groups(
        np.array(rows),
        2 * TOLERANCE_MM,
        lambda i, j: congruent(parts[i].pattern, parts[j].pattern),  # type: ignore[arg-type]
    )


def _node_groups(nodes: Sequence[Node]) -> list[list[int]]:
    rows = [
        [1e3 * len(n.angles_deg), *(f(n.angles_deg, default=0) for f in (min, max))]
        + [f(n.slopes_deg, default=0) for f in (min, max)]
        for n in nodes
    ]

    def same(i: int, j: int) -> bool:
        one = np.array([nodes[i].angles_deg, nodes[i].slopes_deg])
        other = np.array([nodes[j].angles_deg, nodes[j].slopes_deg])
        turns = (np.roll(one, shift, axis=1) for shift in range(max(one.shape[1], 1)))
        return any((np.abs(turn - other) <= TOLERANCE_DEG).all() for turn in turns)

    return _groups(np.array(rows, dtype=float).reshape(-1, 5), TOLERANCE_DEG, same)


def _groups(
    rows: FloatArray, reach: float, same: Callable[[int, int], bool] | None = None
) -> list[list[int]]:
    """Groups of rows: the first free row leads all free ones within reach that are the same."""
    if not len(rows):
        return []
    tree = cKDTree(rows)
    free = np.ones(len(rows), dtype=bool)
    groups = []
    for leader in range(len(rows)):
        if not free[leader]:
            continue
        near = np.array(tree.query_ball_point(rows[leader], reach, p=np.inf))
        others = np.sort(near[free[near] & (near > leader)]).tolist()
        group = [leader] + [k for k in others if same is None or same(leader, k)]
        free[group] = False
        groups.append(group)
    return groups


def _kinds(parts: Iterable[Part]) -> list[str]:
    return list(dict.fromkeys(part.kind for part in parts))


def _named(names: Sequence[str], groups: list[list[int]]) -> list[list[str]]:
    return [[names[number] for number in group] for group in groups]
