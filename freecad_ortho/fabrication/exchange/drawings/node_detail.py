"""A typical node: from the tip of its axis and from its side, with angles and what meets there."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Any

import numpy as np

from freecad_ortho.fabrication.drawing_form import DrawingForm, scale_for
from freecad_ortho.fabrication.exchange.drawings.page import Page, room_of
from freecad_ortho.fabrication.exchange.drawings.pen import THICK, THIN, Pen
from freecad_ortho.fabrication.exchange.drawings.view import View
from freecad_ortho.fabrication.exchange.outlines import seen_lines
from freecad_ortho.fabrication.nodes import Node
from freecad_ortho.fabrication.part import Part, part_names
from freecad_ortho.fabrication.production import Production
from freecad_ortho.words import counted
from solver.mesh.quadmesh import FloatArray, unit_rows

# Of the shortest edge what is shown of it, and at most so much, mm.
_SHOWN, _AT_MOST = 0.4, 700.0
# What names and angles take around a view on paper, mm.
_AROUND = 16.0
_CHAIN = (4.0, 1.0, 0.6, 1.0)


def typical_node(production: Production) -> Node | None:
    """A node of the largest group of equal ones within the net, the most central of several.

    As many edges meet at it as at most nodes there: an irregular one is not typical. None where no
    edges meet.
    """
    site = production.structure.site
    border = site.mesh.connectivity.boundary_vertices
    nodes = [node for node in production.nodes if node.neighbours]
    inner = [node for node in nodes if not border[node.vertex]] or nodes
    if not inner:
        return None
    sizes = {name: len(group) for group in production.groups.nodes for name in group}
    meeting = Counter(len(node.neighbours) for node in inner)
    usual = max(meeting, key=lambda count: (meeting[count], count))
    middle = np.mean([node.point for node in nodes], axis=0)
    return min(
        inner,
        key=lambda node: (
            len(node.neighbours) != usual,
            -sizes.get(node.name, 1),
            round(float(np.linalg.norm(node.point - middle)), 3),
            node.vertex,
        ),
    )


def node_page(production: Production, form: DrawingForm) -> list[Page]:
    """Its page; none where no edges meet."""
    node = typical_node(production)
    if node is None:
        return []
    points = production.structure.site.mesh.vertices
    arms = points[list(node.neighbours)] - points[node.vertex]
    reach = min(_SHOWN * float(np.linalg.norm(arms, axis=1).min()), _AT_MOST)
    plan = _frame(node.axis, arms[0])
    side = np.array([plan[0], plan[2], -plan[1]])
    shapes = _shapes(production, node, reach)
    base = points[node.vertex] + production.structure.site.shift
    views = [
        [line - frame[:2] @ base for line in seen_lines(shapes, frame)] for frame in (plan, side)
    ]
    notes = _notes(production, node)
    low, high = room_of(form, len(notes))
    wide = bool(np.ptp([low, high], axis=0)[0] >= np.ptp([low, high], axis=0)[1])
    room = (high - low) / ([2.0, 1.0] if wide else [1.0, 2.0]) - 2 * _AROUND
    scale = scale_for(2 * reach, 2 * reach, (float(room[0]), float(room[1])))

    def draw(pen: Pen, low: FloatArray, high: FloatArray) -> None:
        step = (high - low) * ([0.25, 0.0] if wide else [0.0, -0.25])
        middle = (low + high) / 2
        _plan(pen, View(scale, np.zeros(2), middle - step), views[0], production, node, plan, reach)
        _side(pen, View(scale, np.zeros(2), middle + step), views[1], node, reach)

    alike = next((len(g) for g in production.groups.nodes if node.name in g), 1)
    title = f"Typical node {node.name}" + (f", {alike} alike" if alike > 1 else "")
    return [Page(f"NODE-{node.name}", title, f"1:{scale}", draw, notes)]


def _frame(axis: FloatArray, arm: FloatArray) -> FloatArray:
    """Rows along an edge, across it, and along the axis, towards the eye."""
    right = unit_rows((arm - arm @ axis * axis)[None])[0]
    return np.stack([right, np.cross(axis, right), axis])


def _shapes(production: Production, node: Node, reach: float) -> list[Any]:
    """What of the solids of the parts at a node is near it."""
    import cadquery

    around = cadquery.Solid.makeCylinder(
        *(reach, 2 * reach, cadquery.Vector(*(node.point - reach * node.axis).tolist())),
        cadquery.Vector(*node.axis.tolist()),
    )
    parts = [part for part in production.structure.parts if node.vertex in part.vertices]
    cut = [part.solid().intersect(around) for part in parts if _is_near(part, node, reach)]
    return [shape.wrapped for shape in cut]


def _is_near(part: Part, node: Node, reach: float) -> bool:
    box = part.points
    gap = np.maximum(box.min(axis=0) - node.point, node.point - box.max(axis=0))
    return bool(np.linalg.norm(np.maximum(gap, 0.0)) < reach)


def _plan(
    pen: Pen,
    view: View,
    lines: Sequence[FloatArray],
    production: Production,
    node: Node,
    frame: FloatArray,
    reach: float,
) -> None:
    """Seen along the axis: angles from edge to edge, and where edges lead."""
    pen.lines([view(line) for line in lines], THICK)
    points = production.structure.site.mesh.vertices
    arms = (points[list(node.neighbours)] - points[node.vertex]) @ frame[:2].T
    turns = np.degrees(np.arctan2(arms[:, 1], arms[:, 0]))
    names = part_names("N", len(points))
    far = reach / view.scale
    for turn, other, angle in zip(turns.tolist(), node.neighbours, node.angles_deg, strict=True):
        out = np.array([np.cos(np.radians(turn)), np.sin(np.radians(turn))])
        pen.lines([np.array([view.at, view.at + (far + 5.0) * out])], THIN, dash=_CHAIN)
        anchor = "start" if out[0] > 0.3 else "end" if out[0] < -0.3 else "middle"
        pen.text(f"to {names[other]}", view.at + (far + 6.5) * out - [0.0, 1.2], anchor=anchor)
        pen.angle(view.at, turn, angle, 0.7 * far, f"{angle:.2f}\N{DEGREE SIGN}")
    pen.text(f"{node.name} seen along its axis", view.at - [0.0, far + 13.0])


def _side(pen: Pen, view: View, lines: Sequence[FloatArray], node: Node, reach: float) -> None:
    """Seen from the side, the first edge to the right: its slope, and the axis upright."""
    pen.lines([view(line) for line in lines], THICK)
    far = reach / view.scale
    pen.lines([view.at + np.array([[0.0, -far], [0.0, far + 4.0]])], THIN, dash=_CHAIN)
    pen.text("axis", view.at + [0.0, far + 5.5])
    slope = node.slopes_deg[0]
    out = np.array([np.cos(np.radians(slope)), np.sin(np.radians(slope))])
    pen.lines([np.array([view.at, view.at + (far + 4.0) * out])], THIN, dash=_CHAIN)
    pen.lines([np.array([view.at, view.at + [far + 4.0, 0.0]])], THIN)
    words = f"{slope:.2f}\N{DEGREE SIGN}"
    if abs(slope) >= 2.0:
        pen.angle(view.at, 0.0, slope, 0.85 * far, words)
    else:
        pen.text(words, view.at + [far + 5.0, 0.0], anchor="start")
    pen.text("seen from the side, the first edge to the right", view.at - [0.0, far + 13.0])


def _notes(production: Production, node: Node) -> tuple[str, ...]:
    """Where it is, and what meets there."""
    structure = production.structure
    point = structure.place.points(node.point)
    axis = structure.place.directions(node.axis)
    names = part_names("N", len(structure.site.mesh.vertices))
    kinds = {part.name: part for part in structure.parts}
    rows = [
        "at "
        + ", ".join(f"{value:.1f}" for value in point.tolist())
        + "; axis "
        + ", ".join(f"{round(value, 6) + 0.0:.6f}" for value in axis.tolist())
    ]
    for number, other in enumerate(node.neighbours):
        along = [
            name
            for name in node.parts
            if other in kinds[name].vertices and kinds[name].face is None
        ]
        rows.append(
            f"{number + 1}: to {names[other]}, angle to the next {node.angles_deg[number]:.2f}, "
            f"slope {node.slopes_deg[number]:.2f}" + (f", {' '.join(along)}" if along else "")
        )
    more = [
        name for name in node.parts if kinds[name].face is None and len(kinds[name].vertices) < 2
    ]
    faces = [name for name in node.parts if kinds[name].face is not None]
    rest = [*more, *faces]
    if rest:
        rows.append(f"also {counted(len(rest), 'part')}: {' '.join(rest)}")
    return tuple(rows)
