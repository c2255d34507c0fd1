"""The flat plate along a plane line, with a slot at each plate that it crosses."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from freecad_ortho.fabrication.bodies import Divided, Polyhedron, prism_sides
from freecad_ortho.fabrication.systems.arches.planes import LinePlane
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray, unit_rows

if TYPE_CHECKING:
    import shapely

# Least angle between plates that cross, and between a slot and the line, degrees.
_LEAST = 20.0
# Corners nearer than this are one, mm.
_SAME = 1e-6


@dataclass(frozen=True, eq=False)
class PlateCrossing:
    """Where another plate crosses, seen from one of the two.

    Attributes:
        other: name of the other plate.
        along: (3,) unit direction in which both planes meet, out of the surface.
        half: half the width of the slot, mm.
        floor: height of its floor above the vertex, in that direction, mm.
        above: whether it opens upwards.
        cut: what is cut: a "slot", the "whole" height, or "none".
    """

    other: str
    along: FloatArray
    half: float
    floor: float
    above: bool
    cut: str = "slot"


@dataclass(frozen=True, eq=False)
class ArchPlate:
    """A plate, or a piece of one, in coordinates along the chord of its line, up, across.

    Attributes:
        frame: (3, 3) these directions, one a row.
        nodes: places of its vertices on the line.
        line: (K, 2) these vertices, from the first of the line.
        outline: (N, 2) counter-clockwise.
        body: from the middle half the thickness to both sides.
        slots: (S, 2) directions of the slots, to their mouths.
    """

    frame: FloatArray
    nodes: range
    line: FloatArray
    outline: FloatArray
    body: Divided
    slots: FloatArray


def crossing(
    mine: LinePlane,
    its: LinePlane,
    name: str,
    thickness: float,
    clearance: float,
    middle: float,
    cut: str = "slot",
) -> PlateCrossing:
    """The slot of a plate for another one; that of family u opens upwards.

    Args:
        mine: plane of the plate.
        its: plane of the other.
        name: of the other.
        thickness: of both, mm.
        clearance: in the width and depth of the slot, mm.
        middle: of both plates above the line, mm.
        cut: what is cut of the plate.

    Raises:
        InputError: planes that meet at too small an angle.
    """
    cosine = float(mine.normal @ its.normal)
    meeting = np.cross(mine.normal, its.normal)
    sine = float(np.linalg.norm(meeting))
    above = mine.line.family == "u"
    pair = f"lines {mine.line.number} of {mine.line.family} and {its.line.number} of "
    pair += its.line.family
    if sine < np.sin(np.radians(_LEAST)):
        raise InputError(
            f"arches: the planes of {pair} meet at {np.degrees(np.arcsin(sine)):.0f} degrees, "
            f"plates with slots need {_LEAST:g}; take lines of one family"
        )
    along = meeting / sine * (1.0 if meeting @ (mine.up + its.up) >= 0 else -1.0)
    half = (thickness + clearance + thickness * abs(cosine)) / 2 / sine
    floor = middle - clearance / 2 * (1 if above else -1)
    return PlateCrossing(name, along, half, floor, above, cut)


def arch_plates(
    plane: LinePlane,
    levels: tuple[float, float],
    thickness: float,
    overhang: float,
    crossings: Mapping[int, PlateCrossing],
) -> list[ArchPlate]:
    """Work out the plate along a line, or its pieces where others run through it.

    Args:
        plane: of its line.
        levels: lower and upper side above the line, square to it, mm.
        thickness: mm.
        overhang: beyond the first and last vertex, mm.
        crossings: by the place of the vertex on the line, counted from 0.

    Raises:
        InputError: slots that run along the line or into one another.
    """
    import shapely

    across = plane.normal
    frame = np.stack([np.cross(plane.up, across), plane.up, across])
    line = (plane.points - plane.points[0]) @ frame[:2].T
    low, high = _band(line, levels, overhang)
    slots = {
        node: _Slot.of(line[node], frame[:2] @ each.along, each)
        for node, each in crossings.items()
        if each.cut != "none"
    }
    _refuse_flat_slots(plane, line, slots)
    reach = 4 * float(np.ptp(levels)) + 4 * float(np.abs(levels).max())
    whole = shapely.Polygon(np.concatenate([low, high[::-1]]))
    cut = shapely.union_all([slot.polygon(reach) for slot in slots.values()])
    left = shapely.get_parts(whole.difference(cut)) if whole.is_valid else []
    shapely.prepare(left)
    filling = [_pieces(low[k : k + 2], high[k : k + 2], slots, k) for k in range(len(line) - 1)]
    made = []
    for nodes in _runs(len(line), [node for node, slot in slots.items() if slot.whole]):
        half = len(nodes) // 2
        middle = (low + high)[nodes[half - 1] : nodes[half] + 1].mean(axis=0) / 2
        around = [part for part in left if shapely.contains_xy(part, *middle)]
        if len(around) != 1 or len(around[0].interiors):
            raise InputError(_too_high(plane))
        # A cut that leans from the mitre leaves some of it beyond its vertex.
        beside = filling[max(nodes[0] - 1, 0) : nodes[-1] + 1]
        outline, body = _body(around[0], [one for each in beside for one in each], thickness)
        own = [slots[node].mouth for node in nodes if node in slots and not slots[node].whole]
        made.append(ArchPlate(frame, nodes, line[nodes], outline, body, np.reshape(own, (-1, 2))))
    if len(left) > 1 and not any(slot.whole for slot in slots.values()):
        raise InputError(_too_high(plane))
    return made


def _too_high(plane: LinePlane) -> str:
    return (
        f"arches: slots cut line {plane.line.number} of {plane.line.family} apart, or its plate is "
        "higher than the line is curved; take lower or thinner plates"
    )


def _runs(count: int, cuts: Sequence[int]) -> list[range]:
    """The vertices of the pieces of a line that is cut at some of them."""
    ends = sorted({0, count - 1, *cuts})
    return [range(one, two + 1) for one, two in itertools.pairwise(ends)]


def _body(
    shape: shapely.Polygon, pieces: Sequence[FloatArray], thickness: float
) -> tuple[FloatArray, Divided]:
    """Outline of a plate, and its body of those convex pieces that lie in it."""
    import shapely

    outline = _tidy(np.asarray(shapely.geometry.polygon.orient(shape).exterior.coords)[:-1])
    own = [piece for piece in pieces if shapely.contains_xy(shape, *piece.mean(axis=0))]
    count = len(outline)
    levels = np.repeat([-thickness / 2, thickness / 2], count)
    corners = np.column_stack([np.tile(outline, (2, 1)), levels])
    blocks = tuple(_slab(piece, thickness) for piece in own)
    return outline, Divided(corners, prism_sides(count), blocks)


@dataclass(frozen=True, eq=False)
class _Slot:
    """A slot in the plane of its plate: beside a line, beyond a floor square to it."""

    foot: FloatArray
    mouth: FloatArray
    half: float
    whole: bool

    @classmethod
    def of(cls, vertex: FloatArray, along: FloatArray, crossing: PlateCrossing) -> _Slot:
        mouth = along / np.linalg.norm(along) * (1 if crossing.above else -1)
        foot = vertex + crossing.floor * along
        return cls(foot, mouth, crossing.half, crossing.cut == "whole")

    @property
    def right(self) -> FloatArray:
        """(2,) to the end of the line, square to the slot."""
        side = np.array([self.mouth[1], -self.mouth[0]])
        return np.asarray(side if side[0] > 0 else -side)

    def polygon(self, reach: float) -> shapely.Polygon:
        """The slot, as deep as the plate and more."""
        import shapely

        aside, out = self.half * self.right, reach * self.mouth
        base = self.foot - out if self.whole else self.foot
        out = 2 * out if self.whole else out
        return shapely.Polygon([base - aside, base + aside, base + aside + out, base - aside + out])

    def around(self, piece: FloatArray) -> Iterator[FloatArray]:
        """What it leaves of a convex piece, in convex pieces."""
        yield _clipped(piece, self.foot + self.half * self.right, self.right)
        yield _clipped(piece, self.foot - self.half * self.right, -self.right)
        if self.whole:
            return
        within = _clipped(piece, self.foot + self.half * self.right, -self.right)
        within = _clipped(within, self.foot - self.half * self.right, self.right)
        yield _clipped(within, self.foot, -self.mouth)


def _band(
    line: FloatArray, levels: tuple[float, float], overhang: float
) -> tuple[FloatArray, FloatArray]:
    """(K, 2) lower and upper side of a plate, mitred at the vertices, longer by the overhang."""
    steps = unit_rows(np.diff(line, axis=0))
    line = line.copy()
    line[0] -= overhang * steps[0]
    line[-1] += overhang * steps[-1]
    rise = np.column_stack([-steps[:, 1], steps[:, 0]])
    one, two = rise[[0, *range(len(rise))]], rise[[*range(len(rise)), -1]]
    mitre = (one + two) / (1 + np.einsum("ij,ij->i", one, two))[:, None]
    return line + levels[0] * mitre, line + levels[1] * mitre


def _refuse_flat_slots(plane: LinePlane, line: FloatArray, slots: Mapping[int, _Slot]) -> None:
    steps = unit_rows(np.diff(line, axis=0))
    for node, slot in slots.items():
        beside = steps[[max(node - 1, 0), min(node, len(steps) - 1)]]
        slant = float(np.abs(beside[:, 0] * slot.mouth[1] - beside[:, 1] * slot.mouth[0]).min())
        if slant < np.sin(np.radians(_LEAST)):
            vertex = int(plane.line.vertices[node])
            raise InputError(
                f"arches: at vertex {vertex} the slot in line {plane.line.number} of "
                f"{plane.line.family} would run along the plate, as the planes lean together; "
                "take lines of one family"
            )


def _pieces(
    low: FloatArray, high: FloatArray, slots: Mapping[int, _Slot], first: int
) -> list[FloatArray]:
    """Convex pieces that fill a plate between a vertex and the next, (2, 2) each, less slots."""
    left = [np.stack([low[0], low[1], high[1], high[0]])]
    for node in (first, first + 1):
        if node in slots:
            left = [cut for piece in left for cut in slots[node].around(piece) if len(cut)]
    return left


def _clipped(piece: FloatArray, point: FloatArray, normal: FloatArray) -> FloatArray:
    """What of a convex polygon (N, 2) lies on the side of a line to which its normal points."""
    if not len(piece):
        return piece
    height = (piece - point) @ normal
    found: list[FloatArray] = []
    for k in range(len(piece)):
        ahead = (k + 1) % len(piece)
        if height[k] >= 0:
            found.append(piece[k])
        if height[k] * height[ahead] < 0:
            share = height[k] / (height[k] - height[ahead])
            found.append(piece[k] + share * (piece[ahead] - piece[k]))
    kept = _tidy(np.array(found)) if len(found) > 2 else np.zeros((0, 2))
    return kept if len(kept) > 2 else np.zeros((0, 2))


def _tidy(ring: FloatArray) -> FloatArray:
    """A polygon without corners that repeat the one before."""
    return np.asarray(ring[np.linalg.norm(ring - np.roll(ring, 1, axis=0), axis=1) > _SAME])


def _slab(piece: FloatArray, thickness: float) -> Polyhedron:
    levels = np.repeat([-thickness / 2, thickness / 2], len(piece))
    return Polyhedron(np.column_stack([np.tile(piece, (2, 1)), levels]), prism_sides(len(piece)))


def worst_turn_deg(slots: Sequence[FloatArray]) -> float:
    """Largest angle between the slots of one plate, degrees."""
    worst = 1.0
    for each in slots:
        if len(each) > 1:
            worst = min(worst, float((each @ each.T).min()))
    return float(np.degrees(np.arccos(np.clip(worst, -1.0, 1.0))))
