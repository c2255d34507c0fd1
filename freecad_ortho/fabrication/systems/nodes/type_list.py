"""The list of node types: what is made how often, by the angles of the beams."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.systems.nodes.hubs import gaps_after
from freecad_ortho.fabrication.systems.nodes.stars import Star
from freecad_ortho.fabrication.systems.system import Table

_COLUMNS = (
    *("type", "count", "diameter_mm", "height_mm", "wall_mm", "beams"),
    *("angles_deg", "slopes_deg", "nodes"),
)


def node_types(
    hubs: Sequence[Part], around: Sequence[Star], groups: Sequence[Sequence[str]]
) -> Table:
    """One row a type, named after the first of its nodes; the most frequent first.

    Args:
        hubs: of all nodes.
        around: the beams of each.
        groups: names of equal ones.
    """
    named = {hub.name: (hub, star) for hub, star in zip(hubs, around, strict=True)}
    rows = []
    for group in sorted(groups, key=lambda group: (-len(group), group[0])):
        hub, star = named[group[0]]
        slopes = np.degrees(np.arcsin(np.clip(star.arms @ hub.frame[2], -1, 1)))
        rows.append(
            (
                *(group[0], len(group), round(hub.width, 3), round(hub.length, 3)),
                *(round(hub.thickness, 3), len(star.turn)),
                " ".join(f"{angle:.2f}" for angle in np.degrees(gaps_after(star.turn))),
                " ".join(f"{slope:.2f}" for slope in slopes),
                " ".join(group),
            )
        )
    return Table("node-types.csv", _COLUMNS, tuple(rows))
