"""Lying lamellas above others: how far one layer is off the other."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from freecad_ortho.fabrication.systems.lamellas.axis import Lamella
from freecad_ortho.fabrication.systems.lamellas.crossings import Crossing
from freecad_ortho.fabrication.systems.lamellas.laps import placed_near
from freecad_ortho.fabrication.systems.lamellas.ribbon import Ribbon
from freecad_ortho.fabrication.systems.lamellas.settings import LamellaSettings
from solver.mesh.quadmesh import FloatArray, unit_rows

# Places at which two plates are compared, along and across where they cross.
_GRID = np.linspace(-1.0, 1.0, 9)
# Rounds in which a place is moved to where the other plate's edge is, how far it may then be beyond
# it, as a share of its half width, and the least sine of a crossing at which places are sought.
_ROUNDS, _BEYOND, _LEAST_SINE = 4, 1e-3, 0.2
# Places along an edge and a bend line.
_ALONG = np.linspace(-1.0, 1.0, 41)
# Share of what is missing that is added to it, as plates are compared square to each other and not
# the way they are moved, and what a clearance is rounded up to, mm.
_SPARE, _ROUNDED = 0.03, 0.1


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
    points = _side(lamella, station, _places(one, other), -up)
    level, height = _seen_from(beside, there, points)
    inside = np.abs(level) <= beside.ribbon.width / 2 * (1 + _BEYOND)
    above = math.copysign(1.0, up @ beside.ribbon.strip.normals[there])
    return float((above * height[inside] - beside.ribbon.thickness / 2).min(initial=np.inf))


def _places(one: tuple[Lamella, int], other: tuple[Lamella, int]) -> FloatArray:
    """(N, 2) places in the first one's pattern where it is above or below the other plate.

    Those of its bend line, and in each of its two faces a grid up to the edges of both plates: what
    they share has its corners where these cross.
    """
    (lamella, station), (beside, there) = one, other
    ribbon, strip = lamella.ribbon, lamella.ribbon.strip
    bend = ribbon.width / 2 * ribbon.stretch[station] * _ALONG[:, None]
    found = [strip.flat_points[station] + bend * strip.flat_rulings[station]]
    levels, theirs = (
        grid.reshape(-1)
        for grid in np.meshgrid(*(each.ribbon.width / 2 * _GRID for each in (lamella, beside)))
    )
    for face in (station - 1, station):
        across = ribbon.flat_across[face]
        along = np.array([across[1], -across[0]])
        sine = float(strip.along[face] @ beside.ribbon.strip.rulings[there])
        sine = math.copysign(max(abs(sine), _LEAST_SINE), sine)
        run, length = np.zeros(len(levels)), strip.lengths[face]
        for _ in range(_ROUNDS):
            off = levels * _spread(ribbon, face, run + (station - face) * length)
            flat = strip.flat_points[station] + run[:, None] * along + off[:, None] * across
            level, _ = _seen_from(beside, there, ribbon.placed(face, flat)[0])
            run += (theirs - level) / sine
        here = (ribbon.ahead(station, flat) < 0) == (face < station)
        found.append(flat[here])
    return np.concatenate(found)


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
    """(N,) levels of points (N, 3) near a station across a lamella, and heights off its plate.

    On the edges levels are those of the ribbon. Plates are taken to go on beyond their ends.
    """
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
        level[here] = np.einsum("nk,nk->n", arms[here], across) / _spread(ribbon, face, x)
        height[here] = np.einsum("nk,nk->n", arms[here], normal)
    return level, height


def _spread(ribbon: Ribbon, face: int, along: FloatArray) -> FloatArray:
    """(N,) how far off the axis, square to it, edges are per unit of level, mm along a face.

    Edges run straight from bend line to bend line, so that they are not quite parallel to an axis
    that turns in the pattern.
    """
    strip = ribbon.strip
    rulings = strip.flat_rulings[face : face + 2] @ ribbon.flat_across[face]
    start, end = ribbon.stretch[face : face + 2] * rulings
    return np.asarray(start + (end - start) * along / strip.lengths[face])
