"""Folded plates along lines that are cut between nodes and joined again by cover plates."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from freecad_ortho.fabrication.drilled import Drill, DrilledWalls
from freecad_ortho.fabrication.folded import Chain, FoldedPlate
from freecad_ortho.fabrication.pattern import FlatPattern, Hole
from freecad_ortho.fabrication.ruled import RuledBody
from freecad_ortho.fabrication.ruled_sides import Bore
from freecad_ortho.fabrication.systems.beams.fins import FinPlates
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.lines import ParameterLine
from solver.mesh.quadmesh import FloatArray


@dataclass(frozen=True, eq=False)
class Stretch:
    """A piece of a line between two joints or ends.

    Attributes:
        chain: its plates.
        vertices: of its nodes, in the order of the chain's; -1 at joints.
        edges: of its plates.
        joined: whether there is a joint at its start and at its end.
    """

    chain: Chain
    vertices: IntArray
    edges: IntArray
    joined: tuple[bool, bool]


def joints(line: ParameterLine, every: int, room: BoolArray) -> list[int]:
    """Numbers of the plates of a line in whose middle there is a joint, after so many nodes each.

    In every second line joints lie in the middle between those of its neighbours. Where an edge has
    no room, ``room`` (E,), the next one that has takes the joint.
    """
    if every == 0:
        return []
    count = len(line.edges)
    found: list[int] = []
    wanted = every - 1 if line.number % 2 == 0 else every - 1 - every // 2
    for place in range(count):
        if place >= wanted and room[line.edges[place]]:
            found.append(place)
            wanted = place + every
    return found


def stretches(chain: Chain, line: ParameterLine, cuts: Sequence[int], gap: float) -> list[Stretch]:
    """Cut the plates of a line in the middle of some, a gap wide; mm."""
    count = len(chain.frame)
    nodes = np.append(line.vertices, line.vertices[0]) if line.closed else line.vertices
    bounds: list[tuple[int | None, int | None]]
    if not cuts:
        return [Stretch(chain, line.vertices, line.edges, (False, False))]
    if line.closed:
        after = [*cuts[1:], cuts[0] + count]
        bounds = list(zip(cuts, after, strict=True))
    else:
        bounds = list(zip([None, *cuts], [*cuts, None], strict=True))
    return [_stretch(chain, nodes, line.edges, first, last, gap) for first, last in bounds]


def _stretch(
    chain: Chain, nodes: IntArray, edges: IntArray, first: int | None, last: int | None, gap: float
) -> Stretch:
    """From the middle of one plate to that of another, or to an end of the chain."""
    count = len(chain.frame)
    begin, end = first or 0, count - 1 if last is None else last
    plates = np.arange(begin, end + 1) % count
    # The node at the start of each plate but the first, and at both ends where there is no joint.
    inner = [int(plate) for plate in plates[1:]]
    if first is None:
        inner.insert(0, 0)
    if last is None:
        inner.append(count)
    vertices, offsets = chain.vertices[inner], chain.offsets[inner]
    numbers = nodes[inner]
    slopes = chain.ends or ((0.0, 0.0), (0.0, 0.0))
    if first is not None:
        point, up = _middle(chain, int(plates[0]), gap / 2)
        vertices, offsets = np.vstack([point, vertices]), np.vstack([up, offsets])
        numbers, slopes = np.append(-1, numbers), ((0.0, 0.0), slopes[1])
    if last is not None:
        point, up = _middle(chain, int(plates[-1]), -gap / 2)
        vertices, offsets = np.vstack([vertices, point]), np.vstack([offsets, up])
        numbers, slopes = np.append(numbers, -1), (slopes[0], (0.0, 0.0))
    piece = replace(
        chain,
        vertices=vertices,
        offsets=offsets,
        frame=chain.frame[plates],
        slots=(None,) * len(vertices),
        ends=slopes,
        tongues=(0.0, 0.0),
    )
    return Stretch(piece, numbers, edges[plates], (first is not None, last is not None))


def _middle(chain: Chain, plate: int, ahead: float) -> tuple[FloatArray, FloatArray]:
    """Point on the edge of a plate that far beyond its middle, and the offset square to it."""
    along, up, _ = chain.frame[plate]
    start, end = chain.vertices[plate], chain.vertices[plate + 1]
    point = (start + end) / 2 + ahead * along
    return point, (chain.offsets[plate] @ up) * up


def shortened(stretch: Stretch, taken: tuple[float, float]) -> Stretch:
    """The same, its ends so far before their nodes, mm; less than 0 for beyond them."""
    chain = stretch.chain
    vertices = chain.vertices.copy()
    for end, sign in ((0, 1.0), (-1, -1.0)):
        vertices[end] += sign * taken[end] * chain.frame[end, 0]
    return replace(stretch, chain=replace(chain, vertices=vertices))


def bolt_holes(stretch: Stretch, covers: FinPlates) -> list[tuple[int, FloatArray]]:
    """The holes of splices: number of the plate, and place along it and up from its start, mm."""
    chain, found = stretch.chain, []
    for end, joined in enumerate(stretch.joined):
        if not joined:
            continue
        plate = end * (len(chain.frame) - 1)
        length = float(np.linalg.norm(chain.vertices[plate + 1] - chain.vertices[plate]))
        middle = sum(chain.levels) / 2 * float(chain.offsets[end * -1] @ chain.frame[plate, 1])
        away = covers.back - covers.clearance / 2
        along = length - away if end else away
        found += [(plate, np.array([along, middle + up])) for up in covers.heights]
    return found


def drilled_chain(
    stretch: Stretch, plate: FoldedPlate, holes: Sequence[tuple[int, FloatArray]], diameter: float
) -> DrilledWalls:
    """The body of folded plates with holes square through some of them."""
    chain, whole = stretch.chain, plate.body
    drills, bores = [], []
    for number, (along, up) in holes:
        frame = chain.frame[number]
        place = chain.vertices[number] - chain.vertices[0] + along * frame[0] + up * frame[1]
        centre, right = place @ chain.frame[0].T, frame[2] @ chain.frame[0].T
        drills.append(Drill(centre, right, diameter, 2 * chain.half))
        lift = chain.half * right
        bores.append(Bore(centre - lift, centre + lift, diameter, plate.sides[number]))
    return DrilledWalls(
        whole, RuledBody(whole.corners, whole.loops, bores=tuple(bores)), tuple(drills)
    )


def drilled_pattern(
    pattern: FlatPattern, holes: Sequence[tuple[int, FloatArray]], diameter: float
) -> FlatPattern:
    """The unrolled plate with the same holes."""
    axis = pattern.axis
    assert axis is not None
    made = []
    for number, (along, up) in holes:
        ahead = axis[number + 1] - axis[number]
        ahead = ahead / np.linalg.norm(ahead)
        made.append(
            Hole(axis[number] + along * ahead + up * np.array([-ahead[1], ahead[0]]), diameter)
        )
    return replace(pattern, holes=tuple(made))
