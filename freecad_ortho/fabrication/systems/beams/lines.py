"""Beams that run through along parameter lines: their chains, crossings and half laps."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from freecad_ortho.fabrication.folded import Chain, NodeSlot
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.beams.border import BorderEnds
from freecad_ortho.fabrication.systems.beams.frames import Around
from freecad_ortho.fabrication.systems.beams.geometry import BeamGeometry
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.lines import ParameterLine
from solver.mesh.quadmesh import FloatArray

# Twist of a plate, mm, above which folds do not lie in the axes.
_FLAT_MM = 1e-3


@dataclass(frozen=True, eq=False)
class Crossings:
    """Half laps at the vertices where lines cross.

    Attributes:
        width: (2E,) half the slot in each half-edge's plate, square to the axis, mm; 0 for none.
        below: (2E,) true where the slot opens downwards.
        clearance: around the plate in the slot, mm.
        present: (2E,) true where the half-edge's plate has a slot.
        tongue: (2E,) how far a plate that ends there reaches behind the axis, flush with the outer
            side of the plate that it ends on, mm.
    """

    width: FloatArray
    below: BoolArray
    clearance: float
    present: BoolArray
    tongue: FloatArray


def line_name(line: ParameterLine) -> str:
    """Name of the beam along a line: ``B-U000`` for line 0 of u, ``B-000`` without families."""
    return f"B-{line.family.upper()}{line.number:03d}"


def line_runs(
    line: ParameterLine, built: BoolArray, broken: BoolArray, ends: IntArray
) -> list[ParameterLine]:
    """What is left of a line, piece by piece.

    Args:
        line: the line.
        built: (E,) true for edges that have beams.
        broken: (E, 2) true where these are broken off at their starts and ends.
        ends: (E, 2) vertices of the edges.
    """
    edges, starts = line.edges, line.vertices[: len(line.edges)]
    turned = (ends[edges, 0] != starts).astype(int)
    before = ~built[edges] | broken[edges, turned]
    after = ~built[edges] | broken[edges, 1 - turned]
    vertices = line.vertices
    if line.closed:
        gaps = np.flatnonzero(before | np.roll(after, 1))
        if not len(gaps):
            return [line]
        edges, before, after = (np.roll(some, -int(gaps[0])) for some in (edges, before, after))
        vertices = np.roll(vertices, -int(gaps[0]))
        vertices = np.append(vertices, vertices[0])
    breaks = np.flatnonzero(before[1:] | after[:-1]) + 1
    bounds = zip(np.r_[0, breaks].tolist(), np.r_[breaks, len(edges)].tolist(), strict=True)
    return [
        replace(line, vertices=vertices[low : high + 1], edges=edges[low:high], closed=False)
        for low, high in bounds
        if built[edges[low]]
    ]


def chosen_runs(
    site: Site, along: BoolArray, broken: BoolArray | None
) -> tuple[ParameterLine, ...]:
    """The stretches of the chosen lines, see ``line_runs``; whole lines for None."""
    ends = site.mesh.connectivity.edges
    if broken is None:
        return tuple(line for line in site.chosen_lines if along[line.edges].all())
    return tuple(run for line in site.chosen_lines for run in line_runs(line, along, broken, ends))


def half_laps(site: Site, around: Around, thickness: float, clearance: float) -> Crossings:
    """Work out the slots at all vertices where a line runs through another or ends on it.

    At a crossing the u line has its slot above; where the net has no families, the line with the
    smaller number.
    """
    net = site.mesh.connectivity
    rank = np.zeros(len(net.edges), dtype=np.int64)
    for number, line in enumerate(site.lines.all):
        rank[line.edges] = number
    rank = np.concatenate([rank, rank])
    built = np.flatnonzero(around.left >= 0)
    least = np.full(net.vertex_count, len(rank))
    most = np.full(net.vertex_count, -1)
    np.minimum.at(least, around.vertex[built], rank[built])
    np.maximum.at(most, around.vertex[built], rank[built])
    crossed = site.lines.passed & (least < most)

    beside = np.zeros(len(rank))
    other = around.left[built]
    crosses = (rank[built] != rank[other]) & crossed[around.vertex[built]]
    one, two, angle = built[crosses], other[crosses], around.angle[built][crosses]
    reach = (thickness + clearance + thickness * np.abs(np.cos(angle))) / 2 / np.sin(angle)
    flush = thickness * (1 - np.abs(np.cos(angle))) / 2 / np.sin(angle)
    tongue = np.full(len(rank), thickness / 2)
    for half_edges in (one, two):
        np.maximum.at(beside, half_edges, reach)
        np.minimum.at(tongue, half_edges, flush)
    return Crossings(beside, rank == most[around.vertex], clearance, beside > 0, tongue)


def chain(
    site: Site,
    geometry: BeamGeometry,
    line: ParameterLine,
    half: float,
    laps: Crossings | None,
    border: BorderEnds | None = None,
) -> Chain:
    """The plates along a line, in its direction.

    Raises:
        InputError: slots that meet, or plates that are not plane.
    """
    net, count = site.mesh.connectivity, len(site.mesh.connectivity.edges)
    nodes = np.append(line.vertices, line.vertices[0]) if line.closed else line.vertices
    edges = line.edges
    ahead = net.edges[edges, 0] == nodes[:-1]
    _refuse_twist(site, geometry, edges)
    frame = geometry.frame[edges] * np.where(ahead, 1.0, -1.0)[:, None, None] ** [[1], [0], [1]]
    leaving, arriving = np.where(ahead, edges, edges + count), np.where(ahead, edges + count, edges)
    slots: list[NodeSlot | None] = [None] * len(nodes)
    if laps is not None:
        middle = sum(geometry.levels) / 2
        for node, vertex in enumerate(nodes.tolist()):
            before = arriving[node - 1] if node > 0 or line.closed else -1
            after = leaving[node % len(edges)] if node < len(edges) or line.closed else -1
            here = max(before, after)
            if laps.present[here]:
                above = not laps.below[here]
                rise = middle * float(np.linalg.norm(site.axes.offsets[vertex]))
                floor = rise - laps.clearance / 2 * (1 if above else -1)
                widths = [float(laps.width[one]) if one >= 0 else 0.0 for one in (before, after)]
                slots[node] = NodeSlot(above, floor, *widths)
        _refuse_slots(site, geometry, edges, leaving, arriving, laps)
    vertices, offsets = site.mesh.vertices[nodes], site.axes.offsets[nodes]
    tongues = [0.0, 0.0]
    if laps is not None:
        tongues = [float(laps.tongue[leaving[0]]), float(laps.tongue[arriving[-1]])]
    if border is not None and not line.closed:
        for end in (0, -1):
            found = border.end_of(site, int(edges[end]), int(nodes[end]))
            if found is not None:
                vertices[end], offsets[end] = found
                slots[end], tongues[end] = None, 0.0
    slope = geometry.cuts.slope[edges[[0, -1]]]
    first = (slope[0, 0], slope[0, 3]) if ahead[0] else (slope[0, 2], slope[0, 1])
    last = (slope[1, 1], slope[1, 2]) if ahead[-1] else (slope[1, 3], slope[1, 0])
    return Chain(
        vertices=vertices,
        offsets=offsets,
        frame=frame,
        levels=geometry.levels,
        half=half,
        slots=tuple(slots),
        ends=None if line.closed else (first, last),
        tongues=(tongues[0], tongues[1]),
    )


def _refuse_twist(site: Site, geometry: BeamGeometry, edges: IntArray) -> None:
    twist = geometry.twist_mm[edges]
    if twist.max() > _FLAT_MM:
        edge = int(edges[twist.argmax()])
        first, second = site.mesh.connectivity.edges[edge]
        raise InputError(
            f"beams: at edge {edge} (vertices {first} and {second}) the axes leave the plate by "
            f"{twist.max():.3g} mm, folded beams allow {_FLAT_MM:g} mm; optimise the mesh to a "
            "principal net first, or take mitred ends"
        )


def _refuse_slots(
    site: Site,
    geometry: BeamGeometry,
    edges: IntArray,
    leaving: IntArray,
    arriving: IntArray,
    laps: Crossings,
) -> None:
    height = float(geometry.height.min())
    if laps.clearance >= height:
        raise InputError(
            f"clearance: {laps.clearance:g} mm makes slots deeper than the beams, which are down "
            f"to {height:.1f} mm high; take less"
        )
    slant = np.hypot(1.0, geometry.slopes[edges]).max(axis=1)
    needed = (laps.width[leaving] + laps.width[arriving]) * slant
    room = np.diff(geometry.outline[edges][:, :, 0].reshape(-1, 2, 2), axis=2)
    room = np.abs(room).min(axis=(1, 2))
    wrong = needed >= 0.95 * room
    if wrong.any():
        worst = int(np.argmax(needed / room))
        first, second = site.mesh.connectivity.edges[edges[worst]]
        raise InputError(
            f"beams: the slots at vertices {first} and {second} take {needed[worst]:.1f} of the "
            f"{room[worst]:.1f} mm between them; take thinner beams or less clearance"
        )
