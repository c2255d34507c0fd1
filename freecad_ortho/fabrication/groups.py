"""What is alike in a structure: parts of one length, equal parts, nodes with the same angles."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import chain
from typing import Any

import numpy as np

from freecad_ortho.fabrication.equal import TOLERANCE_MM, equal_groups, grouped
from freecad_ortho.fabrication.nodes import Node
from freecad_ortho.fabrication.part import Part

TOLERANCE_DEG = 0.1


@dataclass(frozen=True)
class Groups:
    """Names in groups; those without an equal are groups of one.

    Attributes:
        lengths: for each kind of part, groups of equal length.
        shapes: for each kind of part, groups of equal ones.
        nodes: groups of vertices where edges meet under the same angles.
        tolerance: within which parts are equal, mm.
    """

    lengths: dict[str, list[list[str]]]
    shapes: dict[str, list[list[str]]]
    nodes: list[list[str]]
    tolerance: float = TOLERANCE_MM

    @property
    def equal_to(self) -> dict[str, str]:
        """The first of the parts that each is equal to, of the nodes where these are no parts."""
        return {**_firsts(self.nodes), **_firsts(chain.from_iterable(self.shapes.values()))}

    def report(self) -> dict[str, Any]:
        """How many different ones there are, and the groups of more than one."""

        def counted(groups: list[list[str]]) -> dict[str, Any]:
            equal = sorted((group for group in groups if len(group) > 1), key=len, reverse=True)
            return {"different": len(groups), "groups": equal}

        return {
            "tolerance_mm": self.tolerance,
            "tolerance_deg": TOLERANCE_DEG,
            "lengths": {kind: counted(groups) for kind, groups in self.lengths.items()},
            "shapes": {kind: counted(groups) for kind, groups in self.shapes.items()},
            "nodes": counted(self.nodes),
        }


def groups_of(
    parts: Sequence[Part], nodes: Sequence[Node], tolerance: float = TOLERANCE_MM
) -> Groups:
    """Group parts within a tolerance in mm, and nodes within 0.1 degrees."""
    kinds = {kind: [p for p in parts if p.kind == kind] for kind in _kinds(parts)}
    lengths, shapes = {}, {}
    for kind, some in kinds.items():
        names = [part.name for part in some]
        rows = np.array([[part.length] for part in some])
        lengths[kind] = _named(names, grouped(rows, tolerance))
        shapes[kind] = _named(names, equal_groups(some, tolerance))
    joints = _named([node.name for node in nodes], _node_groups(nodes))
    return Groups(lengths, shapes, joints, tolerance)


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

    return grouped(np.array(rows, dtype=float).reshape(-1, 5), TOLERANCE_DEG, same)


def _firsts(groups: Iterable[list[str]]) -> dict[str, str]:
    return {name: group[0] for group in groups for name in group}


def _kinds(parts: Iterable[Part]) -> list[str]:
    return list(dict.fromkeys(part.kind for part in parts))


def _named(names: Sequence[str], groups: list[list[int]]) -> list[list[str]]:
    return [[names[number] for number in group] for group in groups]
