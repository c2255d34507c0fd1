"""What slots leave of lamellas that cross in one layer: their net sections."""

from __future__ import annotations

import numpy as np

from freecad_ortho.fabrication.profiles import Profile, profile
from freecad_ortho.structural.groups import Group
from freecad_ortho.structural.model import Model
from freecad_ortho.structural.stances import BEAMS, LYING
from freecad_ortho.structural.strength import rules_for
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import FloatArray


def slotted_ends(model: Model) -> BoolArray:
    """(M, 2) ends of members in a slot: at the inner vertices of lamellas in one layer.

    Slots pass half way through each of the two that cross, and lamellas end at the border.
    """
    design, count = model.design, len(model.families)
    if design.position in (BEAMS, LYING) or design.layers or design.slots == 1:
        return np.zeros((count, 2), dtype=bool)
    net = model.mesh.connectivity
    return np.asarray(~net.boundary_vertices[net.edges])


def net_profile(group: Group, left: float) -> Profile | None:
    """The rectangle that a slot leaves of another one; None of other sections.

    Args:
        group: members.
        left: part of their height.
    """
    whole = group.profile
    if len(whole.rings) != 1 or len(whole.rings[0].corners) != 4:
        return None
    return profile(f"{whole.series}:{whole.width:g}x{left * whole.height:g}")


def at_slots(model: Model, forces: FloatArray, first: int, permanent: bool) -> FloatArray:
    """(K, M) how far net sections are used up, 1 for wholly; 0 where there is no slot.

    What is left lies beside the middle of the lamella, so that N bends it as well, about its own
    middle; the slot opens to the side for which that is worse. Nothing is carried across a slot.

    Args:
        model: what is checked.
        forces: (K, M, 6) in sections along the members, N and Nmm.
        first: how many of the K are of first order, from start to end of the members; the others
            are those of the deformed shape, to either side, from start to end as well.
        permanent: whether no load ever goes away.
    """
    found, ends = np.zeros(forces.shape[:2]), slotted_ends(model)
    half = (len(forces) - first) // 2
    starts = [0] if not half else [0, first, first + half]
    rows = [(row, 0) for row in starts]
    rows += [(row - 1, 1) for row in (*starts[1:], len(forces))]
    for group in model.groups:
        net = net_profile(group, model.design.slots)
        if net is None or not ends[group.members].any():
            continue
        rules = rules_for(net, group.material.name)
        aside = 0.5 * (group.profile.height - net.height)
        for row, end in rows:
            own = group.members & ends[:, end]
            shifted = forces[row, own]
            shifted[:, 4] = np.abs(shifted[:, 4]) + aside * np.abs(shifted[:, 0])
            found[row, own] = rules.section(shifted[None], permanent)[0]
    return found
