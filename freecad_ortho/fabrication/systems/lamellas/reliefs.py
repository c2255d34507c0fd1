"""Round reliefs in the corners of slots, for cutters that leave no sharp ones.

A relief is a circle of the cutter that passes through the corner, its middle on the bisector within
the slot: a dog bone. So what is pushed into the slot reaches its floor over its full width.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from freecad_ortho.fabrication.sizes import rounded_down
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray

# By how much straight pieces may leave the circle, mm.
_CHORD = 0.02


def relieved(
    outline: FloatArray, floors: Sequence[FloatArray], cutter: float, name: str
) -> FloatArray:
    """(N, 2) an outline with reliefs in both corners of the floor of each slot, mm.

    Args:
        outline: (M, 2) with those corners among its own.
        floors: (2, 2) each.
        cutter: its diameter, mm.
        name: of the part, for the message.

    Raises:
        InputError: a cutter too large for a slot.
    """
    arcs: dict[int, FloatArray] = {}
    for floor in floors:
        width = float(np.linalg.norm(floor[1] - floor[0]))
        for corner in floor:
            number = int(np.linalg.norm(outline - corner, axis=1).argmin())
            before, after = outline[number - 1], outline[(number + 1) % len(outline)]
            arcs[number] = _relief(before, outline[number], after, cutter, (width, name))
    pieces = [arcs.get(number, point[None]) for number, point in enumerate(outline)]
    return np.concatenate(pieces)


def _relief(
    before: FloatArray,
    corner: FloatArray,
    after: FloatArray,
    cutter: float,
    slot: tuple[float, str],
) -> FloatArray:
    """(N, 2) an arc in place of a corner, from the side before it to the side after it."""
    arms = [before - corner, after - corner]
    lengths = [float(np.linalg.norm(arm)) for arm in arms]
    units = [arm / length for arm, length in zip(arms, lengths, strict=True)]
    half = float(np.arccos(np.clip(units[0] @ units[1], -1, 1))) / 2
    width, name = slot
    # Both corners of a floor share it.
    room = min(width / 2, *lengths)
    if cutter * np.cos(half) > room:
        raise InputError(
            f"cutter: {cutter:g} mm leave no floor in a slot {width:.1f} mm wide of {name}; take "
            f"at most {rounded_down(float(room / np.cos(half)))} mm, or a larger clearance"
        )
    bisector = (units[0] + units[1]) / np.linalg.norm(units[0] + units[1])
    centre = corner + cutter / 2 * bisector
    x, y = corner - centre
    sweep = np.pi - 2 * half
    step = 2 * np.arccos(1 - min(2 * _CHORD / cutter, 0.5))
    count = max(int(np.ceil(sweep / step)), 2)
    turn = float(np.sign(units[0][0] * units[1][1] - units[0][1] * units[1][0]))
    # The corner is one of the points, in the middle.
    angles = -turn * sweep * np.arange(-count, count + 1) / count
    cosine, sine = np.cos(angles), np.sin(angles)
    return np.asarray(centre + np.stack([cosine * x - sine * y, sine * x + cosine * y], axis=1))
