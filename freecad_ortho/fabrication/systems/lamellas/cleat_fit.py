"""How legs of cleats lie on their lamellas: how far off them, and whether there is room."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping

import numpy as np

from freecad_ortho.fabrication.cleat import Cleat
from freecad_ortho.fabrication.systems.lamellas.arm import Arm
from freecad_ortho.fabrication.systems.lamellas.laps import placed_near
from freecad_ortho.fabrication.systems.lamellas.settings import LamellaSettings
from solver.mesh.quadmesh import FloatArray, unit_rows

# Between a leg and what crosses next, in thicknesses of the lamellas.
_ROOM = 3.0
# Most that a bend below a leg askew may lift it off its lamella, mm, and places along both sides
# of it at which that is looked for.
LIFTED, _PLACES = 1.0, np.linspace(0.0, 1.0, 9)
# How far a lamella may come through the plane of such a leg, mm: less than what clashes.
_TOUCHING = 1e-2
# Widths of slots, mm, by the lamella that has them and the vertex.
Slots = Mapping[tuple[str, int], float]


def twist_gap(
    arm: Arm, point: FloatArray, out: FloatArray, ends: FloatArray, up: FloatArray
) -> float:
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


def off_leg(arm: Arm, cleat: Cleat, number: int) -> float:
    """How far the lamella comes through the plane of a leg, mm, as it twists and bends below it."""
    leg, ribbon = cleat.legs[number], arm.lamella.ribbon
    flat = arm.pattern(_corners(cleat, number, _PLACES * cleat.sizes.reach))
    middle, half = placed_near(ribbon, arm.station, flat)
    return float(((middle - cleat.corner) @ leg.out + np.abs(half @ leg.out)).max())


def _corners(cleat: Cleat, number: int, along: FloatArray) -> FloatArray:
    """(2 N, 3) of both sides of a leg, so far from the corner, where it lies on its plate."""
    # Of two layers each leg stands out beyond its plate, beside the other one.
    half = cleat.sizes.height / 2 - cleat.sizes.lift
    leg = cleat.legs[number]
    middle = leg.side * cleat.sizes.lift
    return np.array(
        [
            cleat.corner + away * leg.way + (middle + up + cleat.rise(number, away)) * cleat.up
            for away in along.tolist()
            for up in (-half, half)
        ]
    )


def off_middle(pair: tuple[Arm, Arm], cleat: Cleat) -> float:
    """How far the legs are off the middles of the lamellas along the corner, mm.

    Where an edge is not square to the corner, a leg comes nearer to one side of its lamella.
    """
    levels = []
    for number, arm in enumerate(pair):
        ribbon, face = arm.lamella.ribbon, arm.face
        sides = _corners(cleat, number, np.array([0.0, cleat.sizes.reach]))
        ends = (sides[::2] + sides[1::2]) / 2
        flat = arm.pattern(ends) - ribbon.strip.flat_points[face]
        level = flat @ ribbon.flat_across[face] - (ribbon.lower + ribbon.upper) / 2
        upright = float(ribbon.strip.across[0][face] @ cleat.up)
        levels.append(np.copysign(1.0, upright) * level)
    both = np.concatenate(levels)
    return float(both.min() + both.max()) / 2


def fits(
    pair: tuple[Arm, Arm],
    cleat: Cleat,
    wanted: Collection[int],
    slots: Slots,
    settings: LamellaSettings,
) -> bool:
    """Whether both legs lie on plane faces, clear of bend lines, edges and what crosses next.

    Where that shall have a cleat too, there is room for both.
    """
    sizes = cleat.sizes
    for number, arm in enumerate(pair):
        ribbon, face = arm.lamella.ribbon, arm.face
        strip, sign = ribbon.strip, 1.0 if arm.ahead else -1.0
        flat = arm.pattern(_corners(cleat, number, np.array([0.0, cleat.fold, sizes.reach])))
        level = (flat - strip.flat_points[face]) @ ribbon.flat_across[face]
        if level.min() < ribbon.lower or level.max() > ribbon.upper:
            return False
        mitre = ribbon.thickness * abs(math.tan(float(strip.bends[arm.station]) / 2))
        if cleat.askew:
            if off_leg(arm, cleat, number) > _TOUCHING:
                return False
        elif (sign * ribbon.ahead(arm.station, flat)).min() < mitre:
            return False
        steps = sign * unit_rows(np.diff(strip.flat_points[face : face + 2], axis=0))[0]
        far = float(((flat - strip.flat_points[arm.station]) @ steps).max())
        reach = max(sizes.reach, far - sizes.plate / 2)
        taken = reach if arm.towards in wanted else _ROOM * sizes.plate
        taken = max(taken, slots.get((arm.lamella.name, arm.towards), 0.0) / 2)
        if reach + taken + sizes.plate + settings.clearance > strip.lengths[face]:
            return False
    return True
