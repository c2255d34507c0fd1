"""A beam along a whole parameter line: one plate, folded at the node axes.

Two consecutive plates meet in the axis of their vertex. So the plates unroll into one flat pattern
with a bend line at every axis, and fold back exactly. Around the axis both are mitred on the plane
that bisects them. At a crossing a slot along the axis, from above or from below, takes the plate of
the other family; it ends in a plane square to the axis, so it is a rectangle in the pattern.

The upper sides of two plates, each square to its plate, meet in one line only in the middle. Beside
it the corner is the one that lies deeper inside; the sides there are two triangles each.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import dataclass, field, replace

import numpy as np

from freecad_ortho.fabrication.bodies import Divided, Polyhedron
from freecad_ortho.fabrication.pattern import Bend
from solver.mesh.quadmesh import FloatArray


@dataclass(frozen=True)
class NodeSlot:
    """A slot at a node.

    Attributes:
        above: true where it opens upwards.
        floor: height of its end above the vertex, along the axis, mm.
        before: half its width in the plate before the node, square to the axis, mm.
        after: the same in the plate after it.
    """

    above: bool
    floor: float
    before: float
    after: float


@dataclass(frozen=True, eq=False)
class Chain:
    """The plates along a line, K of them between K + 1 nodes; mm.

    Attributes:
        vertices: (K + 1, 3) of the line; a closed one repeats its first.
        offsets: (K + 1, 3) along the axes, per level.
        frame: (K, 3, 3) rows along each plate, up in it, across it to the right.
        levels: lower and upper level.
        half: half the plates' thickness.
        slots: at each node, None where there is none.
        ends: slopes (right, left) of the mitres at the start and end; for a closed line None.
        tongues: how far the start and end, where slotted, reach behind their axes.
    """

    vertices: FloatArray
    offsets: FloatArray
    frame: FloatArray
    levels: tuple[float, float]
    half: float
    slots: tuple[NodeSlot | None, ...]
    ends: tuple[tuple[float, float], tuple[float, float]] | None
    tongues: tuple[float, float]


@dataclass(frozen=True, eq=False)
class FoldedPlate:
    """The body of a chain and its unrolled middle plane.

    Attributes:
        body: in the coordinates of the first plate: along, up, right from its start.
        outline: (N, 2) counter-clockwise seen from the right.
        axis: (K + 1, 2) the unrolled line.
        middles: (K, 2) the unrolled middles of the plates.
        bends: at the nodes inside.
        height: of the lowest plate, mm.
        sides: (left, right) numbers of the sides of each plate among the body's.
    """

    body: Divided
    outline: FloatArray
    axis: FloatArray
    middles: FloatArray
    bends: tuple[Bend, ...]
    height: float
    sides: tuple[tuple[int, int], ...]


@dataclass(frozen=True)
class _Corner:
    """Points across the plate at one corner of its outline: right, middle (if any), left."""

    right: int
    middle: int | None
    left: int
    place: tuple[float, float]  # in the plane of the plate
    bent: bool = False
    inward: bool = False  # the outline turns inwards here


@dataclass
class _Points:
    """Corner points of the body, each kept once by its key."""

    rows: list[FloatArray] = field(default_factory=list)
    numbers: dict[tuple[object, ...], int] = field(default_factory=dict)

    def add(self, key: tuple[object, ...], point: FloatArray) -> int:
        if key not in self.numbers:
            self.numbers[key] = len(self.rows)
            self.rows.append(point)
        return self.numbers[key]


def folded_plate(chain: Chain) -> FoldedPlate:
    """Compute corners, sides and flat pattern."""
    count = len(chain.frame)
    points, rings = _Points(), []
    loops: list[tuple[int, ...]] = []
    low, high, sides = [], [], []
    for plate in range(count):
        start_low, start_high = (_corners(chain, points, plate, 0, up) for up in (False, True))
        end_low, end_high = (_corners(chain, points, plate, 1, up) for up in (False, True))
        bottom = [*start_low, *reversed(end_low)]
        top = [*end_high, *reversed(start_high)]
        ring = bottom + top
        rings.append((bottom, top))
        sides.append((len(loops) + 1, len(loops)))
        loops.append(tuple(corner.right for corner in ring))
        loops.append(tuple(corner.left for corner in reversed(ring)))
        for chainlet in (bottom, top):
            for one, two in itertools.pairwise(chainlet):
                loops.extend(_strip(one, two))
        if plate == 0:
            loops.extend(_strip(top[-1], bottom[0]))
        if plate == count - 1:
            loops.extend(_strip(bottom[-1], top[0]))
        low.append([corner.place for corner in bottom])
        high.append([corner.place for corner in top])
    origin, frame = chain.vertices[0], chain.frame[0]
    corners = (np.array(points.rows) - origin) @ frame.T
    blocks = [block for bottom, top in rings for block in _blocks(corners, bottom, top)]
    body = Divided(corners, tuple(loops), tuple(blocks))
    return replace(_unrolled(chain, body, low, high), sides=tuple(sides))


def _corners(chain: Chain, points: _Points, plate: int, end: int, up: bool) -> list[_Corner]:
    """Corners of a plate at one of its ends, on its lower or upper side, from the node inwards."""
    node, last = plate + end, len(chain.frame)
    along, rise, right = chain.frame[plate]
    axis = chain.offsets[node] / np.linalg.norm(chain.offsets[node])
    inward = along - (along @ axis) * axis
    inward *= (1.0, -1.0)[end] / np.linalg.norm(inward)
    tip = chain.vertices[node] + chain.levels[up] * chain.offsets[node]
    # From the tip along the side of the plate, per mm square to the axis.
    onward = inward - (inward @ rise) / (axis @ rise) * axis
    outside = node in (0, last)

    def pair(name: str, middle: FloatArray) -> _Corner:
        sides = [
            points.add((node, plate, up, name, hand), middle + sign * chain.half * right)
            for hand, sign in (("right", 1.0), ("left", -1.0))
        ]
        place = _flat(chain, plate, middle)
        return _Corner(sides[0], None, sides[1], place, inward=name == "slot")

    slot = chain.slots[node]
    if slot is not None and slot.above == up:
        base = chain.vertices[node] + slot.floor * axis
        wide = slot.after if end == 0 else slot.before
        if outside and chain.ends is not None:
            floor = pair("tongue", base - chain.tongues[end] * inward)
        else:
            floor = _at_axis(chain, points, plate, node, ("floor",), base, [base, base])
        return [floor, pair("slot", base + wide * inward), pair("side", tip + wide * onward)]
    if outside and slot is not None and chain.ends is not None:
        return [pair("end", tip - chain.tongues[end] * onward)]
    if outside and chain.ends is not None:
        slopes = chain.ends[end]
        sides = [
            points.add((node, up, hand), tip + chain.half * (sign * right + slope * along_in))
            for hand, sign, slope, along_in in (
                ("right", 1.0, slopes[0], (1.0, -1.0)[end] * along),
                ("left", -1.0, slopes[1], (1.0, -1.0)[end] * along),
            )
        ]
        middle = points.add((node, up, "middle"), tip)
        return [_Corner(sides[0], middle, sides[1], _flat(chain, plate, tip))]
    return [_at_axis(chain, points, plate, node, (up,), tip, _inner(chain, node, axis, tip, up))]


def _at_axis(
    chain: Chain,
    points: _Points,
    plate: int,
    node: int,
    key: tuple[object, ...],
    tip: FloatArray,
    base: list[FloatArray],
) -> _Corner:
    """Corner at a fold: on the bisecting plane beside the point ``tip`` of the axis.

    ``base`` are the points of the axis level with the right and left corner. The seam of a closed
    line is a fold whose two sides have their own corners.
    """
    across = _bisector(chain, node)
    seam = plate if node in (0, len(chain.frame)) else -1
    numbers = [
        points.add((node, seam, *key, hand), foot + sign * chain.half * across)
        for hand, sign, foot in (("right", 1.0, base[0]), ("left", -1.0, base[1]))
    ]
    middle = points.add((node, seam, *key, "middle"), tip)
    bent = key != ("floor",)
    return _Corner(numbers[0], middle, numbers[1], _flat(chain, plate, tip), bent)


def _bisector(chain: Chain, node: int) -> FloatArray:
    """(3,) from the axis to the right corner, per half thickness."""
    one, two = chain.frame[node - 1][2], chain.frame[node % len(chain.frame)][2]
    return np.asarray((one + two) / (1 + one @ two))


def _inner(
    chain: Chain, node: int, axis: FloatArray, tip: FloatArray, up: bool
) -> list[FloatArray]:
    """Points of the axis level with the right and left corner: of both plates' the inner one."""
    across = chain.half * _bisector(chain, node)
    rises = chain.frame[[node - 1, node % len(chain.frame)], 1]
    deeper = min if up else max
    return [tip + deeper(-sign * (rises @ across) / (rises @ axis)) * axis for sign in (1.0, -1.0)]


def _blocks(corners: FloatArray, bottom: list[_Corner], top: list[_Corner]) -> Iterator[Polyhedron]:
    """A plate in convex blocks: cut along the axis where a slot begins."""
    low, high = ([_across(corners, corner) for corner in side] for side in (bottom, top))
    slots = [side[k].inward for side, k in ((top, -2), (bottom, 1), (top, 1), (bottom, -2))]
    if slots[0]:
        meeting = _opposite(low[0], low[1], high[-2], high[-3])
        yield _block([low[0], meeting, high[-2], high[-1]])
        low[0], high = meeting, high[:-2]
    if slots[1]:
        meeting = _opposite(high[-1], high[-2], low[1], low[2])
        yield _block([low[0], low[1], meeting, high[-1]])
        high[-1], low = meeting, low[2:]
    if slots[2]:
        meeting = _opposite(low[-1], low[-2], high[1], high[2])
        yield _block([meeting, low[-1], high[0], high[1]])
        low[-1], high = meeting, high[2:]
    if slots[3]:
        meeting = _opposite(high[0], high[1], low[-2], low[-3])
        yield _block([low[-2], low[-1], high[0], meeting])
        high[0], low = meeting, low[:-2]
    yield _block([*low, *high])


def _across(corners: FloatArray, corner: _Corner) -> FloatArray:
    """(3, 3) the right, left and middle point of a corner."""
    right, left = corners[corner.right], corners[corner.left]
    middle = (right + left) / 2 if corner.middle is None else corners[corner.middle]
    return np.stack([right, left, middle])


def _opposite(one: FloatArray, two: FloatArray, slot: FloatArray, side: FloatArray) -> FloatArray:
    """(3, 3) where the side of a slot, prolonged beyond its floor, meets the edge from one to two.

    On the right and left; in the middle halfway between these.
    """
    met = []
    for start, end, floor, tip in zip(one[:2], two[:2], slot[:2], side[:2], strict=True):
        system = np.stack([end - start, tip - floor], axis=1)
        along = np.linalg.lstsq(system, floor - start, rcond=None)[0][0]
        met.append(start + along * (end - start))
    return np.stack([*met, (met[0] + met[1]) / 2])


def _block(ring: list[FloatArray]) -> Polyhedron:
    """A convex block from the corners of its right side; middle points count as corners too."""
    count = len(ring)
    sides = tuple(((k + 1) % count, k, k + count, (k + 1) % count + count) for k in range(count))
    ends = (tuple(range(count)), tuple(reversed(range(count, 2 * count))))
    return Polyhedron(np.stack(ring, axis=1).reshape(-1, 3), (*ends, *sides))


def _strip(one: _Corner, two: _Corner) -> Iterator[tuple[int, ...]]:
    """Sides across the plate between two consecutive corners of its right side."""
    halves = [
        [two.right, one.right, one.middle, two.middle],
        [two.middle, one.middle, one.left, two.left],
    ]
    if one.middle is None or two.middle is None:
        halves = [[two.right, one.right, one.middle, one.left, two.left, two.middle]]
    for half in halves:
        loop = [number for number in half if number is not None]
        if not (one.bent or two.bent):
            yield tuple(loop)
            continue
        # Fan from a middle point, which lies in both plates' upper sides.
        first = next(k for k, number in enumerate(loop) if number in (one.middle, two.middle))
        loop = loop[first:] + loop[:first]
        for second, third in itertools.pairwise(loop[1:]):
            yield loop[0], second, third


def _flat(chain: Chain, plate: int, point: FloatArray) -> tuple[float, float]:
    """Coordinates of a point in the plane of a plate: along and up from its start."""
    arm = point - chain.vertices[plate]
    return float(arm @ chain.frame[plate, 0]), float(arm @ chain.frame[plate, 1])


def _unrolled(
    chain: Chain,
    body: Divided,
    low: list[list[tuple[float, float]]],
    high: list[list[tuple[float, float]]],
) -> FoldedPlate:
    """Lay plate after plate into the plane of the first, axis on axis."""
    count = len(chain.frame)
    axes = chain.offsets / np.linalg.norm(chain.offsets, axis=1)[:, None]
    tips = chain.vertices + np.array(chain.levels)[:, None, None] * chain.offsets
    turn, before, origin = 0.0, 0.0, np.zeros(2)
    line, middles, bends, bottoms, tops, heights = [origin], [], [], [], [], []
    for plate in range(count):
        tilt = [
            float(np.arctan2(*(axes[node] @ chain.frame[plate, :2].T)[::-1]))
            for node in (plate, plate + 1)
        ]
        if plate > 0:
            turn += before - tilt[0]
        before = tilt[1]
        cosine, sine = np.cos(turn), np.sin(turn)
        to_flat = np.array([[cosine, sine], [-sine, cosine]])
        bottoms.append(np.array(low[plate]) @ to_flat + origin)
        tops.append(np.array(high[plate]) @ to_flat + origin)
        ends = (tips[:, plate : plate + 2] - chain.vertices[plate]) @ chain.frame[plate, :2].T
        middles.append(ends.mean(axis=(0, 1)) @ to_flat + origin)
        heights.append(float(np.ptp(ends[..., 1])))
        length = float(np.linalg.norm(chain.vertices[plate + 1] - chain.vertices[plate]))
        origin = origin + length * np.array([cosine, sine])
        line.append(origin)
        if plate < count - 1:
            fold = np.stack([bottoms[-1][-1], tops[-1][0]])
            bends.append(Bend(fold, _fold_deg(chain, plate + 1, axes[plate + 1])))
    outline = np.concatenate([*bottoms, *reversed(tops)])
    distinct = np.linalg.norm(outline - np.roll(outline, 1, axis=0), axis=1) > 1e-9
    return FoldedPlate(
        body, outline[distinct], np.array(line), np.array(middles), tuple(bends), min(heights), ()
    )


def _fold_deg(chain: Chain, node: int, axis: FloatArray) -> float:
    """Angle by which the plate after a node rises towards the right side, degrees."""
    one, two = chain.frame[node - 1, 2], chain.frame[node, 2]
    return float(np.degrees(np.arctan2(-np.cross(one, two) @ axis, one @ two)))
