"""Lying lamellas above others: how far one layer is off the other."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from freecad_ortho.fabrication.systems.lamellas.axis import Lamella
from freecad_ortho.fabrication.systems.lamellas.crossings import Crossing
from freecad_ortho.fabrication.systems.lamellas.laps import placed_near
from freecad_ortho.fabrication.systems.lamellas.settings import LamellaSettings
from solver.mesh.quadmesh import FloatArray, unit_rows

# Places at which two plates are compared, along and across where they cross.
_GRID = np.linspace(-1.0, 1.0, 9)
# The same along an edge.
_ALONG = np.linspace(-1.0, 1.0, 41)
# Share of what is missing that is added to it, as plates are compared along one direction, and what
# a clearance is rounded up to, mm.
_SPARE, _ROUNDED = 0.1, 0.1


def too_near(
    lamellas: Sequence[Lamella], met: Sequence[Sequence[Crossing]], settings: LamellaSettings
) -> tuple[int, float]:
    """Number of crossings at which the layers touch, and the least clearance that works, mm."""
    by_name = {lamella.name: lamella for lamella in lamellas}
    count, needed = 0, settings.clearance
    for lamella, row in zip(lamellas, met, strict=True):
        for crossing in row:
            other = by_name[crossing.other]
            if lamella.family != "u":
                continue
            there = other.stations[other.vertices.index(crossing.vertex)]
            gap = gap_between((lamella, crossing.station), (other, there))
            if gap < 0:
                count += 1
                needed = max(needed, settings.clearance - (1 + _SPARE) * gap)
    return count, math.ceil(needed / _ROUNDED) * _ROUNDED if count else needed


def gap_between(upper: tuple[Lamella, int], lower: tuple[Lamella, int]) -> float:
    """Least distance of two plates where they cross, below 0 where they share space."""
    places = [lamella.ribbon.strip.points[station] for lamella, station in (upper, lower)]
    up = unit_rows((places[0] - places[1])[None])[0]
    return min(_gap_at(upper, lower, up), _gap_at(lower, upper, -up))


def _gap_at(one: tuple[Lamella, int], other: tuple[Lamella, int], up: FloatArray) -> float:
    """The same at places of the first plate, which lies ``up`` from the other."""
    (lamella, station), (beside, there) = one, other
    ribbon = lamella.ribbon
    sine = np.linalg.norm(
        np.cross(ribbon.strip.rulings[station], beside.ribbon.strip.rulings[there])
    )
    reach = ribbon.width / 2 / max(float(sine), 0.2)
    ruling = ribbon.strip.flat_rulings[station]
    along, across = np.meshgrid(reach * _GRID, ribbon.width / 2 * _GRID)
    flat = ribbon.strip.flat_points[station] + (
        along.reshape(-1, 1) * np.array([ruling[1], -ruling[0]]) + across.reshape(-1, 1) * ruling
    )
    inner = _side(lamella, station, flat, -up)
    strip = beside.ribbon.strip
    arms = inner - strip.points[there]
    normal, upright = strip.normals[there], strip.rulings[there]
    level, ahead = arms @ upright, arms @ np.cross(upright, normal)
    beyond = strip.flat_rulings[there]
    place = strip.flat_points[there] + (
        ahead[:, None] * np.array([beyond[1], -beyond[0]]) + level[:, None] * beyond
    )
    inside = np.abs(level) <= beside.ribbon.width / 2 * (1 + 1e-9)
    outer = _side(beside, there, place[inside], up)
    return float(((inner[inside] - outer) @ up).min(initial=np.inf))


def _side(lamella: Lamella, station: int, flat: FloatArray, towards: FloatArray) -> FloatArray:
    """Points (N, 2) of the pattern on the side of the plate that looks ``towards``."""
    middle, half = placed_near(lamella.ribbon, station, flat)
    return np.asarray(middle + np.where(half @ towards < 0, -1.0, 1.0)[:, None] * half)


def gap_above_edge(upper: tuple[Lamella, int], lower: tuple[Lamella, int]) -> float:
    """Least distance of a lying plate from the upper edge of a standing one that it crosses, mm.

    Along the lying plate's normal; below 0 where they share space.
    """
    (lamella, station), (beside, there) = upper, lower
    strip, ribbon = beside.ribbon.strip, beside.ribbon
    sine = np.linalg.norm(np.cross(lamella.ribbon.strip.along[station], strip.along[there]))
    reach = (lamella.ribbon.width / 2 + ribbon.thickness) / max(float(sine), 0.2)
    edge = ribbon.edge(ribbon.upper)[there - 1 : there + 2]
    ways = unit_rows(np.diff(edge, axis=0))
    steps = reach * _ALONG[:, None]
    flat = edge[1] + np.where(steps < 0, steps * ways[0], steps * ways[1])
    middle, half = placed_near(ribbon, there, flat)
    points = np.concatenate([middle + half, middle - half])
    above = float(
        (lamella.ribbon.strip.points[station] - strip.points[there])
        @ (lamella.ribbon.strip.normals[station])
    )
    level, height = _seen_from(lamella, station, points)
    inside = np.abs(level) <= lamella.ribbon.width / 2 * (1 + 1e-9)
    gaps = -np.copysign(1.0, above) * height[inside] - lamella.ribbon.thickness / 2
    return float(gaps.min(initial=np.inf))


def _seen_from(lamella: Lamella, station: int, points: FloatArray) -> tuple[FloatArray, FloatArray]:
    """(N,) levels across a lamella of points (N, 3) near a station, and heights off its plate."""
    ribbon, strip = lamella.ribbon, lamella.ribbon.strip
    arms = points - strip.points[station]
    ahead = arms @ np.cross(strip.rulings[station], strip.normals[station])
    level, height = np.empty(len(points)), np.empty(len(points))
    for face, here in ((station - 1, ahead < 0), (station, ahead >= 0)):
        x = (points[here] - strip.points[face]) @ strip.along[face]
        turn = (strip.twists[face] * x / strip.lengths[face])[:, None]
        up, side = strip.across[0][face], ribbon.sides[face]
        across = np.cos(turn) * up + np.sin(turn) * side
        normal = np.cos(turn) * side - np.sin(turn) * up
        level[here] = np.einsum("nk,nk->n", arms[here], across)
        height[here] = np.einsum("nk,nk->n", arms[here], normal)
    return level, height
