"""Can it be put together: one direction in which a slotted part goes onto all parts that stand.

Two families of slotted plates are put together one after the other: the first stands alone, each
plate of the second is pushed onto all that it crosses at once. So each of its slots has to run in
one direction, but for what its play allows and for how far the plate that it takes can lean.
A plate that is thin enough goes on one crossing after another, where each slot has to suit the next
one only: it bends and twists between them, and so turns in its own plane.
Bending and torsion turn a plate out of its own plane only; so slots of plates that are bent into
place are compared in the flat pattern: what they spring to is free, its stress another verdict.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, pairwise

import numpy as np

from freecad_ortho.fabrication.material import Material
from freecad_ortho.fabrication.part import Part
from solver.mesh.quadmesh import FloatArray, unit_rows
from solver.unroll.strip import angle_between

_STEPS = 400
# Angle, radians, that is no divergence but rounding.
_EXACT = 1e-6


@dataclass(frozen=True, eq=False)
class SlotWay:
    """A slot of a part.

    Attributes:
        other: name of the part that it takes.
        direction: (D,) unit vector from its floor to its mouth; in the flat pattern of a plate that
            is bent into place, in space for a rigid part.
        depth: mm.
        play: by how much it is wider than what it takes, mm.
        give: angle by which the part yields there elastically, radians.
        turn: angle by which the part turns elastically in its own plane on the way from the slot
            before, beyond what lifting it off this one takes, radians; None for a rigid part.
    """

    other: str
    direction: FloatArray
    depth: float
    play: float
    give: float = 0.0
    turn: float | None = None

    @property
    def allowed(self) -> float:
        """Angle by which the direction of insertion may differ from the slot's, radians."""
        return math.atan2(self.play, self.depth) + self.give


@dataclass(frozen=True)
class Conflict:
    """Two slots that no direction of insertion suits.

    Attributes:
        first: name of what the one takes.
        second: name of what the other takes.
        diverge_deg: angle between them.
        allowed_deg: what the play and give of both allow.
        count: of slots that miss the best direction, or of flexible parts the one before.
    """

    first: str
    second: str
    diverge_deg: float
    allowed_deg: float
    count: int

    def __str__(self) -> str:
        """In words, for a verdict."""
        return (
            f"slots for {self.first} and {self.second} diverge by {self.diverge_deg:.1f} degrees, "
            f"play and give allow {self.allowed_deg:.1f}"
        )


def lean(material: Material, thickness: float, length: float) -> float:
    """Angle by which a plate may be twisted over a length before it yields, radians.

    For a thin strip tau = G t theta / L, at most the bending limit / sqrt(3) (von Mises).
    """
    return material.bending_limit / math.sqrt(3) * length / (material.shear_modulus * thickness)


def turning(material: Material, thickness: float, length: float, depth: float) -> float:
    """Angle by which a strip turns in its own plane from one slot to the next, radians.

    It is stiff in its plane, but bent by b(s) and twisted by c(s) in turn, as a crank, its end
    turns there by the area that the curve (b, c) encloses, and is otherwise as it was. Bending to
    the least radius R alone makes b = L / R, torsion to the limit alone c = ``lean``; both together
    stay within von Mises' limit where the curve is no longer than the perimeter 1 in these units.
    It encloses at most 1 / (4 pi) of b c. What lifting the end off the depth of its slot takes of
    that is deducted.
    """
    bend = length / material.least_radius(thickness)
    return bend * lean(material, thickness, length) / (4 * math.pi) - math.atan2(depth, length)


def insertion(ways: Sequence[SlotWay]) -> FloatArray:
    """(D,) unit direction of insertion: one that all slots allow, else one that is missed least.

    The first found that misses nothing, else the centre of the smallest ball about the directions,
    less what each allows.

    Source: Badoiu, Clarkson (2003), Smaller core-sets for balls.
    """
    directions = np.array([way.direction for way in ways])
    allowed = np.array([way.allowed for way in ways])
    mean = directions.sum(axis=0)
    lone = np.linalg.norm(mean) <= 1e-9
    best: FloatArray = directions[0] if lone else mean / np.linalg.norm(mean)
    least, here = math.inf, best
    for step in range(1, _STEPS):
        missed = angle_between(here, directions) - allowed
        if missed.max() < least:
            least, best = float(missed.max()), here
        if least <= 0:
            break
        towards = directions[int(missed.argmax())]
        here = unit_rows((here + (towards - here) / (step + 1))[None])[0]
    return best


def conflict(ways: Sequence[SlotWay]) -> Conflict | None:
    """The two slots that diverge most beyond what they allow; None where the part can be put on.

    Args:
        ways: of one part, in their order along it.
    """
    if len(ways) < 2:
        return None
    missed = angle_between(insertion(ways), np.array([way.direction for way in ways]))
    missed = missed - [way.allowed for way in ways]
    if missed.max() <= _EXACT:
        return None
    # Crossing by crossing each slot has to suit the next one alone.
    flexible = all(way.turn is not None for way in ways)
    pairs = list(pairwise(ways) if flexible else combinations(ways, 2))

    def allowed(one: SlotWay, two: SlotWay) -> float:
        return max(one.allowed + two.allowed + (two.turn or 0.0), 0.0)

    beyond = [
        float(angle_between(one.direction, two.direction)) - allowed(one, two) for one, two in pairs
    ]
    worst = int(np.argmax(beyond))
    if flexible and beyond[worst] <= _EXACT:
        return None
    one, two = pairs[worst]
    return Conflict(
        one.other,
        two.other,
        math.degrees(beyond[worst] + allowed(one, two)),
        math.degrees(allowed(one, two)),
        int((np.array(beyond) > _EXACT).sum()) if flexible else int((missed > _EXACT).sum()),
    )


def conflicts(
    ways: Mapping[str, Sequence[SlotWay]], families: Mapping[str, str]
) -> dict[str, Conflict]:
    """Conflicts of the parts that are put on last, by their names.

    Args:
        ways: slots of each part, by its name.
        families: of the parts; those of one family never cross. Where there are two, the one with
            fewer conflicts is put on last.
    """
    found: dict[str, dict[str, Conflict]] = {family: {} for family in families.values()}
    for name, slots in ways.items():
        if (clash := conflict(slots)) is not None:
            found[families[name]][name] = clash
    if set(found) == {"u", "v"}:
        return min(found["v"], found["u"], key=len)
    return {name: clash for each in found.values() for name, clash in each.items()}


def judged(
    parts: Sequence[Part], ways: Mapping[str, Sequence[SlotWay]]
) -> tuple[tuple[Part, ...], list[str]]:
    """Parts with what keeps them from being put together, and a message where something does."""
    families = {part.name: part.family for part in parts if part.name in ways}
    found = conflicts(ways, families)
    if not found:
        return tuple(parts), []
    first = min(found)
    flexible = all(way.turn is not None for way in ways[first])
    message = (
        f"{parts[0].kind}s: {len(found)} of {len(parts)} cannot be pushed on in one direction"
        f"{', nor crossing by crossing' if flexible else ''}, {first} for one: its {found[first]}; "
        "a larger clearance, shorter pieces or a flatter net help"
    )
    return tuple(
        replace(part, assembly=str(found[part.name])) if part.name in found else part
        for part in parts
    ), [message]
