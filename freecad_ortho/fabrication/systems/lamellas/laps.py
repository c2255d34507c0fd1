"""How much room a lamella takes in the slot of another one."""

from __future__ import annotations

import numpy as np

from freecad_ortho.fabrication.systems.lamellas.axis import Lamella
from freecad_ortho.fabrication.systems.lamellas.ribbon import FLAT, Ribbon
from solver.mesh.quadmesh import FloatArray, unit_rows

# Points along and across the floor of a slot at which another lamella is held against it, from the
# axis to the mouth, and across there; how far to both sides, in parts of what it takes.
_ON_FLOOR, _UP, _ACROSS, _AROUND = 33, 13, 151, 2.5
# Rounds in which it is found out in which faces of two lamellas these meet.
_ROUNDS = 3


def floors_overlap(one: tuple[Lamella, int], two: tuple[Lamella, int], upward: int) -> float:
    """How far the floor of one's slot reaches into the other beyond the other's floor, mm.

    With both floors at the axes, and where both plates are. ``upward`` is 1 where the slot opens
    upwards, -1 where it opens downwards.
    """
    (lamella, station), (other, other_station) = one, two
    direction = flat_axis(lamella, station, other, other_station, upward)
    across = np.array([direction[1], -direction[0]])
    strip, theirs = lamella.ribbon.strip, other.ribbon.strip
    normal = theirs.normals[other_station]
    sine = np.linalg.norm(np.cross(strip.normals[station], normal))
    steps = other.ribbon.thickness / sine * np.linspace(-1, 1, _ON_FLOOR)[:, None]
    flat = strip.flat_points[station] + steps * across
    if lamella.twisted:
        edges = np.diff(strip.flat_points[station - 1 : station + 2], axis=0)
        before, after = unit_rows(edges)
        flat = strip.flat_points[station] + steps * np.where(steps < 0, before, after)
    middle, side = placed_near(lamella.ribbon, station, flat)
    points = np.concatenate([middle + share * side for share in np.linspace(-1, 1, _ON_FLOOR)])
    arms = points - theirs.points[other_station]
    inside = np.abs(arms @ normal) <= other.ribbon.thickness / 2
    their_direction = flat_axis(other, other_station, lamella, station, -upward)
    heights = _heights(other, other_station, their_direction, arms)
    return float((upward * heights[inside]).max(initial=0.0))


def _heights(lamella: Lamella, station: int, direction: FloatArray, arms: FloatArray) -> FloatArray:
    """(N,) heights above a slot's floor through a station, of points (N, 3) from there."""
    ribbon, strip = lamella.ribbon, lamella.ribbon.strip
    found = []
    for face in (station - 1, station):
        along, across = strip.along[face], strip.across[0 if face == station else 1][face]
        flat_across = ribbon.flat_across[face]
        flat_along = np.array([flat_across[1], -flat_across[0]])
        if lamella.twisted:
            found.append(arms @ across)
            continue
        flat = (arms @ along)[:, None] * flat_along + (arms @ across)[:, None] * flat_across
        found.append(flat @ direction)
    behind = arms @ strip.along[station] < 0
    return np.asarray(np.where(behind, *found))


def flat_axis(
    lamella: Lamella, station: int, other: Lamella, other_station: int, sign: float
) -> FloatArray:
    """(2,) direction of the line in which the two plates meet, upwards in the pattern.

    ``sign`` is 1 for where they meet above the axis, -1 for below it.
    """
    strip = lamella.ribbon.strip
    ruling: FloatArray = strip.flat_rulings[station]
    if lamella.twisted:
        return ruling
    normal, theirs = _normals(lamella, station, other, other_station, sign)
    line, up = np.cross(normal, theirs), strip.rulings[station]
    flat_ahead = np.array([ruling[1], -ruling[0]])
    flat = (line @ up) * ruling + (line @ np.cross(up, normal)) * flat_ahead
    return np.asarray(flat / np.linalg.norm(flat) * (1.0 if flat @ ruling > 0 else -1.0))


def _normals(
    lamella: Lamella, station: int, other: Lamella, other_station: int, sign: float
) -> tuple[FloatArray, FloatArray]:
    """(3,) normals of both plates where they meet.

    Where a lamella bends, that is in the face after its bend line or in the one before.
    """
    up = lamella.ribbon.strip.rulings[station]
    first, second = _normal(lamella, station, None), _normal(other, other_station, None)
    for _ in range(_ROUNDS):
        line = np.cross(first, second)
        line *= sign * (1 if line @ up > 0 else -1)
        first, second = _normal(lamella, station, line), _normal(other, other_station, line)
    return first, second


def _normal(lamella: Lamella, station: int, towards: FloatArray | None) -> FloatArray:
    """(3,) normal of the face that lies in a direction from a station; of both without one."""
    ribbon = lamella.ribbon
    mean = ribbon.strip.normals[station]
    if lamella.twisted or towards is None:
        return np.asarray(mean)
    start, end = ribbon.face_normals
    ahead = towards @ np.cross(ribbon.strip.rulings[station], mean)
    return np.asarray(start[station] if ahead > 0 else end[station - 1])


def half_width(
    lamella: Lamella,
    station: int,
    other: Lamella,
    other_station: int,
    axis: FloatArray,
    reach: float,
) -> float:
    """Largest distance of the other plate from the slot's axis, where it passes this plate.

    Measured in this plate's plane at the crossing, at the axis and at the mouth, on all four lines
    in which the sides of the two plates meet: thickness over the sine of the crossing angle, what
    a skew crossing adds, and what the other plate bends and twists on its way.
    """
    strip, theirs = lamella.ribbon.strip, other.ribbon.strip
    sign = float(np.sign(reach))
    normal, their_normal = _normals(lamella, station, other, other_station, sign)
    up = strip.rulings[station]
    ahead = np.cross(up, normal)
    ruling = strip.flat_rulings[station]
    flat_ahead = np.array([ruling[1], -ruling[0]])
    away = np.array([axis[1], -axis[0]])
    their_axis = flat_axis(other, other_station, lamella, station, sign)
    slope = their_normal @ normal
    run = lamella.ribbon.thickness / 2 / np.sqrt(1 - slope**2)
    skew = other.ribbon.thickness / 2 * abs(slope) / np.sqrt(1 - slope**2)
    across = np.array([their_axis[1], -their_axis[0]])
    heights = np.array([0.0, 0.5, 1.0]) * reach
    line = theirs.flat_points[other_station] + heights[:, None] * their_axis
    # Where the other plate leans, its axis leaves this plane: start from where it meets it.
    (middle, _), (ahead_of, _) = (
        placed_near(other.ribbon, other_station, points) for points in (line, line + run * across)
    )
    off = (middle - strip.points[station]) @ normal
    met = -run * off / ((ahead_of - middle) @ normal)
    offsets = np.array([-1, 0, 1])[:, None] * (run + skew) + met
    flat = (line + offsets[..., None] * across).reshape(-1, 2)
    middle, half = placed_near(other.ribbon, other_station, flat)
    worst = 0.0
    for side in (-1, 1):
        arms = middle + side * half - strip.points[station]
        inside = np.abs(arms @ normal) <= run * 1.5 + skew
        local = (arms @ ahead)[:, None] * flat_ahead + (arms @ up)[:, None] * ruling
        if inside.any():
            worst = max(worst, float(np.abs(local[inside] @ away).max()))
    if max(abs(strip.bends[station]), abs(theirs.bends[other_station])) <= FLAT:
        return worst
    width = float(run + skew)
    points, step = _both_sides(other, other_station, their_axis, reach, met, width)
    return max(worst, _beside_bend(lamella, station, points - strip.points[station], axis, step))


def _both_sides(
    lamella: Lamella,
    station: int,
    axis: FloatArray,
    reach: float,
    met: FloatArray,
    width: float,
) -> tuple[FloatArray, float]:
    """(N, 3) points on both sides of a plate around a line in its pattern, and their distance, mm.

    Args:
        lamella: of which plate.
        station: where the line begins.
        axis: (2,) unit direction of the line, upwards.
        reach: its length, mm; negative for downwards.
        met: (3,) how far beside its start, middle and end the points are centred, mm.
        width: that the plate takes across the line there, mm.
    """
    shares = np.linspace(0, 1, _UP)
    line = lamella.ribbon.strip.flat_points[station] + (shares * reach)[:, None] * axis
    aside = np.linspace(-_AROUND, _AROUND, _ACROSS)[:, None] * width
    offsets = aside + np.interp(shares, [0, 0.5, 1], met)
    flat = line + offsets[..., None] * [axis[1], -axis[0]]
    middle, half = placed_near(lamella.ribbon, station, flat.reshape(-1, 2))
    return np.concatenate([middle - half, middle + half]), float(aside[1, 0] - aside[0, 0])


def _beside_bend(
    lamella: Lamella, station: int, arms: FloatArray, axis: FloatArray, step: float
) -> float:
    """Largest distance from a slot's axis of points inside either face of a lamella that bends.

    Args:
        lamella: whose plate bends at the station.
        station: that the slot is at.
        arms: (N, 3) points of the other plate from there.
        axis: (2,) of the slot in the pattern.
        step: distance of these points from each other, mm.
    """
    strip, half = lamella.ribbon.strip, lamella.ribbon.thickness / 2
    up, ruling = strip.rulings[station], strip.flat_rulings[station]
    start, end = lamella.ribbon.face_normals
    mitre = half * abs(np.tan(strip.bends[station] / 2))
    worst = 0.0
    for side, normal in ((-1, end[station - 1]), (1, start[station])):
        ahead, high = arms @ np.cross(up, normal), arms @ up
        inside = (np.abs(arms @ normal) <= half + step) & (side * ahead >= -mitre)
        flat = ahead[:, None] * [ruling[1], -ruling[0]] + high[:, None] * ruling
        away = np.abs(flat[inside] @ [axis[1], -axis[0]])
        worst = max(worst, float(away.max(initial=0.0)))
    return worst


def placed_near(ribbon: Ribbon, station: int, flat: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Points of the pattern around a station in space, each with the face that it lies in.

    Returns:
        (N, 3) points in the middle of the plate and (N, 3) from there to its upper side.
    """
    middle, half = ribbon.placed(station, flat)
    behind = ribbon.ahead(station, flat) < 0
    middle[behind], half[behind] = ribbon.placed(station - 1, flat[behind])
    return middle, half
