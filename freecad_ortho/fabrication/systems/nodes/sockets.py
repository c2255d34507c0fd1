"""Sockets: discs under a crossing with a slot for every plate, to be printed.

A disc carries a pillar between each plate and the next; the plates stand in the slots that are left
between the pillars.
"""

from __future__ import annotations

import itertools

import numpy as np

from freecad_ortho.fabrication.bodies import Divided, Prism
from freecad_ortho.fabrication.systems.nodes.hubs import gaps_after
from solver.mesh.quadmesh import FloatArray

_STEP = np.radians(15.0)  # of the facets of the rim


def least_radius(angles: FloatArray, half: float) -> float:
    """Radius at which the smallest pillar vanishes, mm; ``half`` of a slot's width."""
    gaps = gaps_after(angles)
    sharp = gaps[gaps < np.pi]
    return float(half / np.sin(sharp / 2).min()) if len(sharp) else half


def socket(angles: FloatArray, radius: float, half: float, levels: FloatArray) -> Divided:
    """The socket of one node.

    Args:
        angles: (K,) directions of the plates around the axis, counter-clockwise, radians.
        radius: of the disc, mm.
        half: half the width of the slots, mm; less than ``radius`` allows, see ``least_radius``.
        levels: (3,) heights of the disc's underside, of its upper side and of the pillars, mm.
    """
    points: list[list[float]] = []
    loops: list[tuple[int, ...]] = []

    def add(place: FloatArray, *at: int) -> tuple[int, ...]:
        for level in at:
            points.append([*place.tolist(), float(levels[level])])
        return tuple(range(len(points) - len(at), len(points)))

    mouths, pillars = [], []
    turn = float(np.arcsin(half / radius))
    for angle, gap in zip(angles.tolist(), gaps_after(angles).tolist(), strict=True):
        mouths.append([add(_polar(radius, angle + side * turn), 0, 1, 2) for side in (-1, 1)])
        first, last = angle + turn, angle + gap - turn
        steps = max(int(np.ceil((last - first) / _STEP)), 1)
        rim = [
            add(_polar(radius, first + (last - first) * k / steps), 0, 2) for k in range(1, steps)
        ]
        inner = [add(place, 1, 2) for place in _inner(angle, gap, half)]
        pillars.append((rim, inner))
    under, floor, tops = [], [], []
    for k, (rim, inner) in enumerate(pillars):
        (right, left), (following, _) = mouths[k], mouths[(k + 1) % len(mouths)]
        loops.append((right[0], left[0], left[1], right[1]))
        outer = [(left[0], left[2]), *rim, (following[0], following[2])]
        for number, (one, two) in enumerate(itertools.pairwise(outer)):
            begins = (left[1],) if number == 0 else ()
            ends = (following[1],) if number == len(outer) - 2 else ()
            loops.append((one[0], two[0], *ends, two[1], one[1], *begins))
        recess = [following[1:], *reversed(inner), left[1:]]
        for one, two in itertools.pairwise(recess):
            loops.append((one[0], two[0], two[1], one[1]))
        tops.append((*(up for _, up in outer), *(up for _, up in reversed(inner))))
        under.extend([right[0], left[0], *(low for low, _ in rim)])
        floor.extend([right[1], left[1], *(low for low, _ in inner)])
    loops.extend([*tops, tuple(reversed(under)), tuple(floor)])
    corners = np.array(points)
    blocks = [Prism(corners[under, :2], float(levels[0]), float(levels[1]))]
    for loop in tops:
        rings = _convex(corners[list(loop), :2], len(pillars) == 1)
        blocks.extend(Prism(one, float(levels[1]), float(levels[2])) for one in rings)
    pieces = tuple(piece for block in blocks for piece in block.pieces())
    return Divided(corners, tuple(loops), pieces)


def _convex(ring: FloatArray, alone: bool) -> list[FloatArray]:
    """Convex polygons that fill that of a pillar: its rim, then one inner corner, alone two."""
    if alone:
        # Around a single plate: on its left, behind it and on its right.
        rim, (right, left) = ring[:-2], ring[-2:]
        one, two = (len(rim) - 1) // 3, 2 * (len(rim) - 1) // 3
        behind = np.vstack([left, rim[one : two + 1], right])
        return [np.vstack([left, rim[: one + 1]]), behind, np.vstack([right, rim[two:]])]
    if not _turns_inwards(ring):
        return [ring]
    # Around more than half of the disc a pillar is two blocks.
    middle = (len(ring) - 1) // 2
    return [np.vstack([ring[-1:], ring[: middle + 1]]), ring[middle:]]


def _turns_inwards(ring: FloatArray) -> bool:
    """Tell whether a counter-clockwise polygon (N, 2) turns inwards at its last corner."""
    before, after = ring[-1] - ring[-2], ring[0] - ring[-1]
    return bool(before[0] * after[1] - before[1] * after[0] < 0)


def _polar(radius: float, angle: float) -> FloatArray:
    return radius * np.array([np.cos(angle), np.sin(angle)])


def _inner(angle: float, gap: float, half: float) -> list[FloatArray]:
    """Inner corners of the pillar between two directions, from the first to the second."""
    if gap < 1.8 * np.pi:
        return [_polar(half / np.sin(gap / 2), angle + gap / 2)]
    return [_polar(half, angle + np.pi / 2), _polar(half, angle + gap - np.pi / 2)]
