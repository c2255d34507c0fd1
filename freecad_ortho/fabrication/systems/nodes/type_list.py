"""The list of node types: what is made how often, by the angles of the beams."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from freecad_ortho.fabrication.systems.nodes.hubs import gaps_after
from freecad_ortho.fabrication.systems.nodes.stars import Star
from freecad_ortho.fabrication.systems.system import Table
from solver.offset.axes import Axes

_COLUMNS = (
    *("type", "count", "diameter_mm", "height_mm", "plate_mm", "beams"),
    *("angles_deg", "slopes_deg", "nodes"),
)


class NodeSize(NamedTuple):
    """The beams of a node, and how large it is; mm.

    Attributes:
        star: its beams.
        diameter: across it.
        height: along its axis.
        plate: thickness of its walls or plates.
    """

    star: Star
    diameter: float
    height: float
    plate: float


def node_types(nodes: Mapping[str, NodeSize], groups: Sequence[Sequence[str]], axes: Axes) -> Table:
    """One row a type, named after the first of its nodes; the most frequent first.

    Args:
        nodes: by their names.
        groups: names of equal ones.
        axes: at the vertices.
    """
    rows = []
    for group in sorted(groups, key=lambda group: (-len(group), group[0])):
        star, *sizes = nodes[group[0]]
        rises = star.arms @ axes.directions[star.vertex]
        slopes = np.degrees(np.arcsin(np.clip(rises, -1, 1)))
        rows.append(
            (
                *(group[0], len(group), *(round(size, 3) for size in sizes), len(star.turn)),
                " ".join(f"{angle:.2f}" for angle in np.degrees(gaps_after(star.turn))),
                " ".join(f"{slope:.2f}" for slope in slopes),
                " ".join(group),
            )
        )
    return Table("node-types.csv", _COLUMNS, tuple(rows))
