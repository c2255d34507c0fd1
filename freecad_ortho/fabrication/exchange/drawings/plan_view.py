"""The overview: all parts, the net's lines with their names, and the numbers of nodes.

Where the nodes are too near to each other on paper for their numbers, the overview has the names of
the lines only, and the plan goes on in pieces at a larger scale.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from freecad_ortho.fabrication.drawing_form import SCALES, DrawingForm, scale_for
from freecad_ortho.fabrication.exchange.drawings.page import Page, room_of
from freecad_ortho.fabrication.exchange.drawings.pen import (
    MIDDLE,
    SMALL,
    TEXT,
    THIN,
    Pen,
)
from freecad_ortho.fabrication.exchange.drawings.view import View, box_of, eye, millimetres
from freecad_ortho.fabrication.production import Production
from freecad_ortho.fabrication.report.pictures import silhouettes
from freecad_ortho.fabrication.site import Site
from freecad_ortho.words import counted
from solver.mesh.lines import ParameterLine
from solver.mesh.quadmesh import FloatArray

# Radius of the circle around a line's name, what its leader is long, how often it may be pushed on.
_BUBBLE, _LEADER, _PUSHES = 3.6, 3.5, 6
# What bubbles and dimensions take around the net on paper, mm; bubbles alone; dimensions are there.
_AROUND, _NAMED, _OVERALL = 23.0, 14.0, 20.0
# Edges on paper from which on nodes have their numbers, mm; an edge has the room of five of them.
_NUMBERED = 9.0
_CHAIN = (4.0, 1.0, 0.6, 1.0)


@dataclass(frozen=True, eq=False)
class _Net:
    """The net seen from above or from one side.

    Attributes:
        seen: from where, in words.
        points: (V, 2) vertices, mm.
        outlines: of each part as it is seen, then of its openings, (n, 2); what is behind first.
        lines: names and points (k, 2) of parameter lines, closed ones with their first again.
        closed: for each line, whether it is.
        nodes: names and numbers of the vertices at which parts meet.
        edge: mean length on paper at 1:1, mm.
        box: low and high corner (2,) of the nodes, of a trimmed net of all parts.
        sizes: what that is, in words.
    """

    seen: str
    points: FloatArray
    outlines: list[list[FloatArray]]
    lines: list[tuple[str, FloatArray]]
    closed: list[bool]
    nodes: list[tuple[str, int]]
    edge: float
    box: tuple[FloatArray, FloatArray]
    sizes: str


def plan_view_pages(production: Production, form: DrawingForm) -> list[Page]:
    """The overview and, where it has no room for the nodes' numbers, its pieces."""
    net = _net(production)
    low, high = net.box
    structure = production.structure
    notes: tuple[str, ...] = (
        f"{counted(len(structure.parts), 'part')}, {sum(structure.masses.values()):,.0f} kg",
        f"{counted(len(net.nodes), 'node')}, {counted(len(net.lines), 'line')} of the net",
    )
    room_low, room_high = room_of(form, len(notes) + 2)
    room = room_high - room_low - 2 * _AROUND
    size = high - low
    scale = scale_for(size[0], size[1], (float(room[0]), float(room[1])))
    middle = (low + high) / 2
    if net.edge / scale >= _NUMBERED:
        notes = (*notes, net.sizes)

        def whole(pen: Pen, low: FloatArray, high: FloatArray) -> None:
            view = View(scale, middle, (low + high) / 2)
            _draw(pen, net, view)
            _bubbles(pen, [view(points) for _, points in net.lines], net, all_of_them=True)
            _numbers(pen, net, view)
            _overall(pen, net, view)

        return [Page("PLAN", f"Overview {net.seen}", f"1:{scale}", whole, notes)]
    pieces = _pieces(net, form)
    last = f" to PLAN-{len(pieces)}" if len(pieces) > 1 else ""
    notes = (*notes, net.sizes, f"numbers of nodes: PLAN-1{last}")

    def overview(pen: Pen, low: FloatArray, high: FloatArray) -> None:
        view = View(scale, middle, (low + high) / 2)
        _draw(pen, net, view)
        _bubbles(pen, [view(points) for _, points in net.lines], net, all_of_them=False)
        for number, (corner, far, _) in enumerate(pieces, start=1):
            box = view(np.array([corner, [far[0], corner[1]], far, [corner[0], far[1]]]))
            pen.lines([box], MIDDLE, closed=True, dash=(1.5, 1.0))
            pen.text(f"PLAN-{number}", box[3] + [1.5, -SMALL - 1.5], SMALL, anchor="start")
        _overall(pen, net, view)

    first = Page("PLAN", f"Overview {net.seen}", f"1:{scale}", overview, notes)
    return [first, *(_piece(net, number, *each) for number, each in enumerate(pieces, start=1))]


def _net(production: Production) -> _Net:
    structure = production.structure
    site, place = structure.site, structure.place
    points = place.directions(site.mesh.vertices + site.shift)
    seen, frame = eye(site.mesh.with_vertices(points).face_area_vectors)
    flat = points @ frame.T
    lines, closed = [], []
    for line in site.chosen_lines:
        numbers = line.vertices
        if line.closed:
            numbers = np.append(numbers, numbers[0])
        runs = [flat[numbers][:, :2]] if site.trimming is None else _kept(site, line, flat[:, :2])
        for run in runs:
            lines.append((f"{line.family}{line.number}", run))
            closed.append(line.closed and len(run) == len(numbers))
    built = set(range(len(points))) if site.trimming is None else _within_border(site)
    clouds, owners = [], []
    for number, part in enumerate(structure.parts):
        for piece in part.body.pieces():
            spread = place.directions(part.origin + piece.corners @ part.frame)
            clouds.append(spread @ frame.T)
            owners.append(number)
    depths = np.array([cloud[:, 2].mean() for cloud in clouds])
    depths = np.bincount(owners, depths) / np.bincount(owners)
    outlines = silhouettes([cloud[:, :2] for cloud in clouds], owners)
    behind = np.argsort(depths, kind="stable").tolist()
    nodes = [(node.name, node.vertex) for node in production.nodes if node.vertex in built]
    if site.trimming is None:
        box, sizes = (
            box_of(flat[[vertex for _, vertex in nodes], :2]),
            "overall sizes between nodes",
        )
    else:
        box = box_of(np.concatenate([ring for rings in outlines.values() for ring in rings]))
        sizes = "overall sizes of all parts"
    edges = site.mesh.connectivity.edges[site.chosen_edges]
    across = np.linalg.norm(flat[edges[:, 0], :2] - flat[edges[:, 1], :2], axis=1)
    return _Net(
        seen,
        flat[:, :2],
        [outlines[number] for number in behind],
        lines,
        closed,
        nodes,
        # Half of the edges are longer, seen from here.
        float(np.median(across)),
        box,
        sizes,
    )


def _within_border(site: Site) -> set[int]:
    """Vertices that are within the border along which a net is trimmed."""
    assert site.trimming is not None
    edges = site.mesh.connectivity.edges
    return {
        int(edges[edge, end])
        for edge, spans in site.trimming.spans.items()
        for end in (0, 1)
        if any(span[end] == end for span in spans)
    }


def _kept(site: Site, line: ParameterLine, points: FloatArray) -> list[FloatArray]:
    """The pieces (k, 2) of a line that are within the border."""
    assert site.trimming is not None
    runs: list[list[FloatArray]] = []
    goes_on = False
    for number, edge in enumerate(line.edges.tolist()):
        ends = site.mesh.connectivity.edges[edge]
        spans = site.trimming.spans.get(edge, ())
        if ends[0] != line.vertices[number]:
            ends, spans = ends[::-1], tuple((1 - end, 1 - start) for start, end in spans[::-1])
        one, other = points[ends]
        reached = False
        for start, end in spans:
            if not (goes_on and start == 0.0):
                runs.append([one + start * (other - one)])
            runs[-1].append(one + end * (other - one))
            goes_on, reached = False, end == 1.0
        goes_on = reached
    return [np.array(run) for run in runs]


def _draw(pen: Pen, net: _Net, view: View) -> None:
    """Parts as their outlines, lines of the net as chains."""
    _outlines(pen, net.outlines, view)
    pen.lines([view(points) for _, points in net.lines], THIN, dash=_CHAIN)


def _outlines(pen: Pen, outlines: Sequence[Sequence[FloatArray]], view: View) -> None:
    for rings in outlines:
        pen.lines([view(ring) for ring in rings], THIN, closed=True, fill=0.96, grey=0.6)


def _numbers(pen: Pen, net: _Net, view: View) -> None:
    """A dot at each node, and its name beside it."""
    for name, vertex in net.nodes:
        at = view(net.points[vertex])
        pen.circle(at, 0.4, fill=0.0)
        pen.text(name, at + [0.8, 0.8], SMALL, anchor="start", cleared=True)


def _bubbles(pen: Pen, lines: list[FloatArray], net: _Net, all_of_them: bool) -> None:
    """The name of each line in a circle where it begins and, if there is room, where it ends.

    Args:
        pen: draws.
        lines: (k, 2) of the net's on paper, empty for those that are not there.
        net: has their names.
        all_of_them: even those that have no room near the line.
    """
    taken: list[FloatArray] = []
    for (name, _), closed, points in zip(net.lines, net.closed, lines, strict=True):
        ends = [points] if closed else [points, points[::-1]]
        for number, line in enumerate(ends if len(points) else []):
            _bubble(pen, name, line[:2], taken, needed=all_of_them and number == 0)


def _bubble(pen: Pen, name: str, ends: FloatArray, taken: list[FloatArray], needed: bool) -> None:
    out = ends[0] - ends[1]
    length = float(np.linalg.norm(out))
    out = out / length if length > 1e-9 else np.array([0.0, 1.0])
    # Numbers of nodes stand to their right.
    leader = _LEADER + (6.0 if out[0] > 0.5 else 0.0)
    for push in range(_PUSHES):
        at = ends[0] + (leader + push * 2 * _BUBBLE + _BUBBLE) * out
        free = all(float(np.linalg.norm(at - other)) >= 2 * _BUBBLE for other in taken)
        if free and (needed or push < 2):
            break
    else:
        if not needed:
            return
    taken.append(at)
    pen.lines([np.array([ends[0], at - _BUBBLE * out])], THIN, dash=_CHAIN)
    pen.circle(at, _BUBBLE, MIDDLE, fill=1.0)
    pen.text(name, at - [0.0, TEXT / 2], TEXT, room=1.6 * _BUBBLE)


def _overall(pen: Pen, net: _Net, view: View) -> None:
    """Width and height of all."""
    low, high = net.box
    corner = view(low)
    far = view(high)
    pen.dimension(
        *(corner, np.array([far[0], corner[1]]), -_OVERALL), millimetres(high[0] - low[0])
    )
    pen.dimension(*(corner, np.array([corner[0], far[1]]), _OVERALL), millimetres(high[1] - low[1]))


def _pieces(net: _Net, form: DrawingForm) -> list[tuple[FloatArray, FloatArray, int]]:
    """Corners of the boxes, and the scale, at which nodes have their numbers."""
    scale = next((each for each in reversed(SCALES) if net.edge / each >= _NUMBERED), SCALES[0])
    low, high = room_of(form, 1)
    room = (high - low - 2 * _NAMED) * scale
    numbers = [vertex for _, vertex in net.nodes]
    low, high = net.box
    # Names stand to the right of their nodes.
    high = high + [8.0 * scale, 4.0 * scale]
    low = low - 2.0 * scale
    counts = [max(1, math.ceil(each)) for each in ((high - low) / room).tolist()]
    step = (high - low) / counts
    found = []
    for row, column in product(reversed(range(counts[1])), range(counts[0])):
        corner = low + step * [column, row]
        inside = (net.points[numbers] >= corner) & (net.points[numbers] <= corner + step)
        if inside.all(axis=1).any():
            found.append((corner, corner + step, scale))
    return found


def _piece(net: _Net, number: int, corner: FloatArray, far: FloatArray, scale: int) -> Page:
    """The page of a piece of the plan."""

    def draw(pen: Pen, low: FloatArray, high: FloatArray) -> None:
        view = View(scale, (corner + far) / 2, (low + high) / 2)
        box = view(np.array([corner, far]))
        lines = [_within(view(points), box) for _, points in net.lines]
        with pen.within(*box):
            near = [
                rings
                for rings in net.outlines
                if (rings[0].max(axis=0) >= corner).all() and (rings[0].min(axis=0) <= far).all()
            ]
            _outlines(pen, near, view)
            pen.lines([line for line in lines if len(line)], THIN, dash=_CHAIN)
        rim = np.array([box[0], [box[1][0], box[0][1]], box[1], [box[0][0], box[1][1]]])
        pen.lines([rim], MIDDLE, closed=True, dash=(1.5, 1.0))
        _bubbles(pen, lines, net, all_of_them=True)
        here = [
            (name, vertex)
            for name, vertex in net.nodes
            if ((net.points[vertex] >= corner) & (net.points[vertex] <= far)).all()
        ]
        _numbers(pen, replace(net, nodes=here), view)

    return Page(f"PLAN-{number}", f"Nodes {net.seen}, piece {number}", f"1:{scale}", draw)


def _within(points: FloatArray, box: FloatArray) -> FloatArray:
    """(k, 2) the longest piece of a line within a box (2, 2), none where it is outside."""
    import shapely

    cut = shapely.clip_by_rect(shapely.LineString(points), *box.ravel().tolist())
    pieces = [piece for piece in shapely.get_parts(cut) if piece.length > 0]
    if not pieces:
        return np.empty((0, 2))
    return np.array(max(pieces, key=lambda piece: piece.length).coords)
