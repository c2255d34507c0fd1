"""Where lamellas are joined by cleats: at their last crossings, and above feet."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from freecad_ortho.fabrication.cleat import Cleat, Leg, corner_of
from freecad_ortho.fabrication.part import part_names
from freecad_ortho.fabrication.systems.lamellas.axis import Lamella
from freecad_ortho.fabrication.systems.lamellas.cleat_sizes import sizes_of
from freecad_ortho.fabrication.systems.lamellas.crossings import Crossing
from freecad_ortho.fabrication.systems.lamellas.settings import LamellaSettings
from freecad_ortho.fabrication.systems.lamellas.splices import Joint, square_end
from solver.mesh.quadmesh import FloatArray, unit_rows

# Between a leg and what crosses next, in thicknesses of the lamellas.
_ROOM = 3.0
# Ways to place the bolts of a leg, see ``sizes_of``.
_WAYS = 3
# Most that one leg may lean to another, as the cosine of their angle.
_FLAT = 0.94
# Rounds in which the places of the legs and their distances from twisted plates come to agree.
_ROUNDS = 4


@dataclass(frozen=True, eq=False)
class Arm:
    """A lamella as it leaves a vertex, which is ``ahead`` or behind along it."""

    lamella: Lamella
    station: int
    ahead: bool

    @property
    def face(self) -> int:
        """Number of the ribbon's face along it."""
        return self.station if self.ahead else self.station - 1

    @property
    def towards(self) -> int:
        """The vertex that it comes to next."""
        place = self.lamella.stations.index(self.station)
        return self.lamella.vertices[place + (1 if self.ahead else -1)]

    @property
    def way(self) -> FloatArray:
        """(3,) unit vector along its edge, from the vertex."""
        along = self.lamella.ribbon.strip.along[self.face]
        return np.asarray(along if self.ahead else -along)

    def at(self, distance: float) -> tuple[FloatArray, FloatArray]:
        """Point of the axis so far from the vertex, mm, and normal of the plate there."""
        strip, face = self.lamella.ribbon.strip, self.face
        place = distance if self.ahead else float(strip.lengths[face]) - distance
        point, up = square_end(strip, Joint(face, place))
        return point, np.cross(strip.along[face], up)

    def place(self, distance: float) -> float:
        """Number of the face, and the share of its length, so far from the vertex."""
        share = distance / float(self.lamella.ribbon.strip.lengths[self.face])
        return self.station + (share if self.ahead else -share)

    def pattern(self, points: FloatArray) -> FloatArray:
        """(N, 2) where points (N, 3) beside the face are in the pattern."""
        ribbon, face = self.lamella.ribbon, self.face
        strip = ribbon.strip
        arms = points - strip.points[face]
        x = arms @ strip.along[face]
        angle = (strip.twists[face] * x / strip.lengths[face])[:, None]
        up = np.cos(angle) * strip.across[0][face] + np.sin(angle) * ribbon.sides[face]
        across = ribbon.flat_across[face]
        forwards = np.array([across[1], -across[0]])
        y = np.einsum("nk,nk->n", arms, up)
        return np.asarray(strip.flat_points[face] + x[:, None] * forwards + y[:, None] * across)


def ends_of(lamellas: Sequence[Lamella]) -> set[int]:
    """The last vertices of those that are not closed."""
    return {lamella.vertices[k] for lamella in lamellas if not lamella.closed for k in (0, -1)}


def around(
    lamellas: Sequence[Lamella], vertices: Collection[int], settings: LamellaSettings
) -> dict[int, FloatArray]:
    """By each of the vertices (N, 3) corners of the lamellas there, within the reach of a cap."""
    reach = 2.0 * sizes_of(settings, math.radians(60.0)).beside
    found: dict[int, list[FloatArray]] = {}
    for lamella in lamellas:
        strip, ribbon = lamella.ribbon.strip, lamella.ribbon
        for vertex, station in zip(lamella.vertices, lamella.stations, strict=True):
            if vertex not in vertices:
                continue
            for face, sign in ((station, 1.0), (station - 1, -1.0)):
                if not 0 <= face < len(strip.lengths):
                    continue
                away = min(reach, float(strip.lengths[face]))
                up = unit_rows(strip.across[0 if sign > 0 else 1][face][None])[0]
                aside = ribbon.thickness / 2 * np.cross(strip.along[face], up)
                found.setdefault(vertex, []).extend(
                    strip.points[station] + along * sign * strip.along[face] + level * up + off
                    for along in (0.0, away)
                    for level in (ribbon.lower, ribbon.upper)
                    for off in (aside, -aside)
                )
    return {vertex: np.array(points) for vertex, points in found.items()}


def cleats_of(
    lamellas: Sequence[Lamella],
    met: Sequence[Sequence[Crossing]],
    wanted: Collection[int],
    settings: LamellaSettings,
    count: int,
) -> tuple[dict[int, Cleat], list[Lamella], list[str]]:
    """Cleats by their vertices, the lamellas with holes for them, and where there was no room.

    Args:
        lamellas: pieces, without holes for cleats.
        met: their crossings.
        wanted: vertices that shall have one.
        settings: of the lamellas.
        count: of the vertices of the net.
    """
    at_vertex: dict[int, list[tuple[int, int]]] = {}
    for index, row in enumerate(met):
        for crossing in row:
            at_vertex.setdefault(crossing.vertex, []).append((index, crossing.station))
    names, found, left_out = part_names("C", count), dict[int, Cleat](), list[str]()
    drilled: dict[int, list[tuple[int, FloatArray]]] = {}
    legs: dict[int, list[float]] = {}
    for vertex in sorted(wanted):
        there = at_vertex.get(vertex, [])
        if len(there) != 2:
            continue
        pairs = _arms(lamellas, there)
        pairs = [pair for pair in pairs for _ in range(_WAYS)]
        made = [
            _cleat(pair, vertex, names[vertex], settings, spread=k % _WAYS)
            for k, pair in enumerate(pairs)
        ]
        fitting = [
            k
            for k, each in enumerate(made)
            if each is not None and _fits(pairs[k], each, wanted, settings.clearance)
        ]
        best = max(fitting, key=lambda k: (-(k % _WAYS), round(_angle(made[k]), 6)), default=None)
        if best is None:
            left_out.append(names[vertex])
            continue
        cleat = made[best]
        assert cleat is not None
        found[vertex] = cleat
        for leg, ((index, _), arm) in enumerate(zip(there, pairs[best], strict=True)):
            drilled.setdefault(index, []).append((arm.face, arm.pattern(cleat.bolts(leg))))
            legs.setdefault(index, []).append(arm.place(cleat.sizes.reach))
    bored = [
        replace(
            lamella,
            bolts=(*lamella.bolts, *drilled.get(index, [])),
            legs=tuple(legs.get(index, [])),
        )
        for index, lamella in enumerate(lamellas)
    ]
    return found, bored, left_out


def _angle(cleat: Cleat | None) -> float:
    return 0.0 if cleat is None else cleat.angle


def _arms(lamellas: Sequence[Lamella], there: Sequence[tuple[int, int]]) -> list[tuple[Arm, Arm]]:
    """Pairs of arms of two lamellas at a vertex, each to the next vertex of its own."""
    sides = []
    for index, station in there:
        lamella = lamellas[index]
        known = set(lamella.stations)
        ways = [ahead for ahead in (True, False) if station + (1 if ahead else -1) in known]
        sides.append([Arm(lamella, station, ahead) for ahead in ways])
    return [(one, two) for one, two in product(*sides)]


def _cleat(
    pair: tuple[Arm, Arm],
    vertex: int,
    name: str,
    settings: LamellaSettings,
    *,
    spread: int,
) -> Cleat | None:
    """The cleat between two arms; None where they are nearly in line.

    Its bolts are ``spread`` as in ``sizes_of``.
    """
    cosine = float(pair[0].way @ pair[1].way)
    if abs(cosine) > _FLAT:
        return None
    sizes = sizes_of(settings, math.acos(cosine), spread=spread)
    seen, outs = [], []
    for arm, other in (pair, pair[::-1]):
        length = float(arm.lamella.ribbon.strip.lengths[arm.face])
        point, normal = arm.at(min(sizes.reach / 2, length / 2))
        seen.append(point)
        outs.append(np.copysign(1.0, float(normal @ other.way)) * normal)
    vertex_point = pair[0].lamella.ribbon.strip.points[pair[0].station]
    # How far twisted plates leave their planes depends on where the legs are, and these on that.
    legs = [Leg(arm.lamella.name, arm.way, out, 0.0) for arm, out in zip(pair, outs, strict=True)]
    for _ in range(_ROUNDS):
        lifts = [settings.thickness / 2 + leg.gap for leg in legs]
        points = [point + lift * out for point, lift, out in zip(seen, lifts, outs, strict=True)]
        corner, up = corner_of((points[0], points[1]), (outs[0], outs[1]), vertex_point)
        for k, (arm, point, out) in enumerate(zip(pair, seen, outs, strict=True)):
            way = np.cross(up, out)
            way = np.copysign(1.0, float(way @ arm.way)) * way
            ends = np.array([corner, corner + sizes.reach * way])
            legs[k] = replace(legs[k], way=way, gap=_gap(arm, point, out, ends, up))
    # The first leg, the way into the corner and the line turn like x, y and z.
    if float(np.cross(legs[0].way, legs[0].out) @ up) < 0:
        up = -up
    made = Cleat(name, vertex, corner, up, (legs[0], legs[1]), sizes)
    return replace(made, corner=corner - _off_middle(pair, made) * up)


def _gap(arm: Arm, point: FloatArray, out: FloatArray, ends: FloatArray, up: FloatArray) -> float:
    """Most that a twisted plate leaves the plane at a point of its axis beside a leg, mm.

    Args:
        arm: of the plate.
        point: (3,) of the axis.
        out: (3,) unit normal of the plate there.
        ends: (2, 3) of the leg, on a line square to ``up``.
        up: (3,) unit vector along the corner.
    """
    ribbon, face = arm.lamella.ribbon, arm.face
    along = ribbon.strip.along[face]
    across = np.cross(out, along)
    across = np.copysign(1.0, float(across @ ribbon.strip.across[0][face])) * across
    most = 0.0
    for level in (ribbon.lower, ribbon.upper):
        # Where the edge is not square to the corner, its sides are further on than its middle.
        steps = (level - (ends - point) @ across) / float(across @ up)
        places = (ends + steps[:, None] * up - point) @ along
        turns = ribbon.strip.twists[face] / ribbon.strip.lengths[face] * places
        most = max(most, float(np.abs(level * np.sin(turns)).max()))
    return most


def _off_middle(pair: tuple[Arm, Arm], cleat: Cleat) -> float:
    """How far the legs are off the middles of the lamellas along the corner, mm.

    Where an edge is not square to the corner, a leg comes nearer to one side of its lamella.
    """
    levels = []
    for leg, arm in zip(cleat.legs, pair, strict=True):
        ribbon, face = arm.lamella.ribbon, arm.face
        ends = cleat.corner + np.array([[0.0], [cleat.sizes.reach]]) * leg.way
        flat = arm.pattern(ends) - ribbon.strip.flat_points[face]
        level = flat @ ribbon.flat_across[face] - (ribbon.lower + ribbon.upper) / 2
        upright = float(ribbon.strip.across[0][face] @ cleat.up)
        levels.append(np.copysign(1.0, upright) * level)
    both = np.concatenate(levels)
    return float(both.min() + both.max()) / 2


def _fits(pair: tuple[Arm, Arm], cleat: Cleat, wanted: Collection[int], clearance: float) -> bool:
    """Whether both legs lie on plane faces, clear of bend lines, edges and what crosses next.

    Where that shall have a cleat too, there is room for both.
    """
    sizes = cleat.sizes
    for leg, arm in zip(cleat.legs, pair, strict=True):
        ribbon, face = arm.lamella.ribbon, arm.face
        strip = ribbon.strip
        taken = sizes.reach if arm.towards in wanted else _ROOM * sizes.plate
        if sizes.reach + taken + sizes.plate + clearance > strip.lengths[face]:
            return False
        ends = [
            cleat.corner + along * leg.way + up * cleat.up
            for along in (0.0, sizes.reach)
            for up in (-sizes.height / 2, sizes.height / 2)
        ]
        flat = arm.pattern(np.array(ends))
        level = (flat - strip.flat_points[face]) @ ribbon.flat_across[face]
        if level.min() < ribbon.lower or level.max() > ribbon.upper:
            return False
        mitre = ribbon.thickness * abs(math.tan(float(strip.bends[arm.station]) / 2))
        sign = 1.0 if arm.ahead else -1.0
        if (sign * ribbon.ahead(arm.station, flat)).min() < mitre:
            return False
    return True
