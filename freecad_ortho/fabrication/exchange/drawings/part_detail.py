"""A typical part of each kind: its flat pattern, or its views, with dimensions."""

from __future__ import annotations

from collections import defaultdict
from itertools import pairwise

import numpy as np

from freecad_ortho.fabrication.drawing_form import DrawingForm, scale_for
from freecad_ortho.fabrication.exchange.drawings.page import Page, room_of
from freecad_ortho.fabrication.exchange.drawings.pen import (
    LEAST,
    MIDDLE,
    SMALL,
    TEXT,
    THICK,
    THIN,
    Pen,
)
from freecad_ortho.fabrication.exchange.drawings.view import View, box_of, millimetres
from freecad_ortho.fabrication.exchange.members import bevel_deg, member_of, mitre_deg
from freecad_ortho.fabrication.exchange.outlines import seen_lines
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.pattern import FlatPattern
from freecad_ortho.fabrication.production import Production
from freecad_ortho.words import counted
from solver.mesh.quadmesh import FloatArray

# What dimensions take around a view on paper, mm, and how far the first and the overall ones are.
_AROUND, _FIRST, _OVERALL = 26.0, 9.0, 18.0
# Outlines of more corners have no length at each side; as little of a side, mm on paper, neither.
_CORNERS, _LEAST = 8, 9.0
# Holes whose places are told, so many.
_HOLES = 12
# Between views of one part, mm on paper.
_BETWEEN = 30.0
_CHAIN, _BEND = (4.0, 1.0, 0.6, 1.0), (2.0, 0.6, 0.3, 0.6)
# From the right side, from above and against its x axis: rows to the right, up, towards the eye.
_VIEWS = {
    "from its right side": np.eye(3),
    "from above": np.array([[1.0, 0, 0], [0, 0, -1.0], [0, 1.0, 0]]),
    "from its end": np.array([[0, 0, -1.0], [0, 1.0, 0], [1.0, 0, 0]]),
}


def typical_parts(production: Production) -> list[tuple[Part, int]]:
    """Of each kind one of the largest group of equal parts, the middle one by length of several.

    Returns:
        The parts, each with the number of parts in its group.
    """
    parts = {part.name: part for part in production.structure.parts}
    found = []
    for groups in production.groups.shapes.values():
        largest = max(len(group) for group in groups)
        firsts = [parts[group[0]] for group in groups if len(group) == largest]
        firsts.sort(key=lambda part: (round(part.length, 3), part.name))
        found.append((firsts[len(firsts) // 2], largest))
    return found


def part_page(production: Production, form: DrawingForm, part: Part, alike: int) -> Page:
    """The page of a part that stands for so many equal ones."""
    title = f"Typical {part.kind} {part.name}" + (f", {alike} alike" if alike > 1 else "")
    notes = _notes(production, part)
    number = f"PART-{part.name}"
    if part.pattern is not None:
        return _plate(number, title, form, part, part.pattern, notes)
    return _views(number, title, form, part, notes)


def _notes(production: Production, part: Part) -> tuple[str, ...]:
    """What it is made of and cut from."""
    place = production.places.get(part.name, "")
    sizes = [f"{part.material.name}", part.section, f"{part.mass:.2f} kg"]
    if part.pattern is not None:
        sizes.insert(1, f"thickness {part.thickness:g}")
    rows = [", ".join(filter(None, sizes)) + (f", from {place}" if place else "")]
    if part.pattern is not None:
        rows.append(f"flat pattern seen from: {part.pattern.seen}" if part.pattern.seen else "")
        rows += _holes(part.pattern)
        if part.pattern.bends:
            angles = ", ".join(f"{bend.angle_deg:.2f}" for bend in part.pattern.bends[:_HOLES])
            rows.append(f"bends, degrees, from the left: {angles}")
    member = member_of(part)
    if member is not None:
        for name, planes in (("start", member.starts), ("end", member.ends)):
            cuts = " and ".join(
                f"mitre {_deg(mitre_deg(plane))}, bevel {_deg(bevel_deg(plane))}"
                for plane in planes
            )
            rows.append(f"{name}: {cuts} degrees from square")
    if part.note:
        rows.append(part.note)
    return tuple(filter(None, rows))


def _deg(value: float) -> str:
    """An angle without a sign where it is zero."""
    return f"{value + 0.0 if abs(value) >= 0.005 else 0.0:.2f}"


def _holes(pattern: FlatPattern) -> list[str]:
    """Diameters and places of holes, from the lower left corner of the pattern's box."""
    by_size: dict[float, list[str]] = defaultdict(list)
    for hole in pattern.holes[:_HOLES]:
        x, y = hole.centre.tolist()
        by_size[hole.diameter].append(f"{x:.1f} {y:.1f}")
    more = f" ... of {len(pattern.holes)}" if len(pattern.holes) > _HOLES else ""
    return [
        f"{counted(len(places), 'hole')} \N{LATIN CAPITAL LETTER O WITH STROKE}{size:g} at "
        f"{', '.join(places)}{more}"
        for size, places in by_size.items()
    ]


def _plate(
    number: str,
    title: str,
    form: DrawingForm,
    part: Part,
    pattern: FlatPattern,
    notes: tuple[str, ...],
) -> Page:
    low, high = box_of(pattern.outline)
    room_low, room_high = room_of(form, len(notes))
    room = room_high - room_low - 2 * _AROUND
    width, height = (high - low).tolist()
    scale = scale_for(width, height, (float(room[0]), float(room[1])))

    def draw(pen: Pen, corner: FloatArray, far: FloatArray) -> None:
        view = View(scale, (low + high) / 2, (corner + far) / 2)
        _pattern(pen, view, pattern)
        size = min(TEXT, pattern.label_size / scale)
        if size >= LEAST:
            pen.text(part.name, view(pattern.label) - [0.0, size / 2], size)
        outline = view(pattern.outline)
        if len(outline) <= _CORNERS:
            _sides(pen, outline, pattern.outline, high - low)
        box = view(np.array([low, high]))
        right, above = np.array([box[1, 0], box[0, 1]]), np.array([box[0, 0], box[1, 1]])
        pen.dimension(box[0], right, -_OVERALL, millimetres(width))
        pen.dimension(box[0], above, _OVERALL, millimetres(height))

    return Page(number, title, f"1:{scale}", draw, notes)


def _pattern(pen: Pen, view: View, pattern: FlatPattern) -> None:
    """Its outline, openings, holes, bends, bevels and marks."""
    cut = [pattern.outline, *pattern.cutouts]
    pen.lines([view(line) for line in cut], THICK, closed=True)
    for hole in pattern.holes:
        at, radius = view(hole.centre), hole.diameter / 2 / view.scale
        pen.circle(at, radius, MIDDLE)
        reach = radius + 1.0
        cross = [at + reach * np.array([step, [-x for x in step]]) for step in ([1, 0], [0, 1])]
        pen.lines(cross, THIN, dash=_CHAIN)
    for bend in pattern.bends:
        pen.lines([view(bend.points)], THIN, dash=_BEND)
    for bevel in pattern.bevels:
        ends = view(bevel.points)
        pen.lines([ends], THIN, dash=(1.5, 1.0) if bevel.hidden else ())
    for mark in pattern.marks:
        if not mark.text:
            pen.lines([view(mark.points)], THIN)
        elif mark.size / view.scale >= 0.8:
            pen.text(mark.text, view(mark.points[0]), mark.size / view.scale * 0.7, mark.angle)
    if pattern.axis is not None:
        pen.lines([view(pattern.axis)], THIN, dash=_CHAIN)


def _sides(pen: Pen, outline: FloatArray, corners: FloatArray, box: FloatArray) -> None:
    """The length of each side, outside of it; counter-clockwise, outside is to the right.

    Those that are as long as the box have the dimension of that.
    """
    for (one, two), (start, end) in zip(
        pairwise([*outline, outline[0]]), pairwise([*corners, corners[0]]), strict=True
    ):
        if (np.abs(np.abs(end - start) - box) < 1e-6).any():
            continue
        if np.linalg.norm(two - one) >= _LEAST:
            pen.dimension(one, two, -_FIRST, millimetres(float(np.linalg.norm(end - start))))


def _views(number: str, title: str, form: DrawingForm, part: Part, notes: tuple[str, ...]) -> Page:
    """Views of the solid in the part's own coordinates, below and beside each other."""
    from OCP.TopLoc import TopLoc_Location

    shape = part.solid().wrapped.Located(TopLoc_Location())
    views = {name: seen_lines([shape], frame) for name, frame in _VIEWS.items()}
    boxes = {name: box_of(np.concatenate(lines)) for name, lines in views.items()}
    sizes = {name: high - low for name, (low, high) in boxes.items()}
    side, above, end = _VIEWS
    room_low, room_high = room_of(form, len(notes))
    room = room_high - room_low - 2 * _AROUND - _BETWEEN
    wide = sizes[side][0] + sizes[end][0]
    tall = sizes[side][1] + sizes[above][1]
    scale = scale_for(float(wide), float(tall), (float(room[0]), float(room[1])))

    def draw(pen: Pen, corner: FloatArray, far: FloatArray) -> None:
        taken = np.array([wide, tall]) / scale + _BETWEEN
        low = (corner + far - taken) / 2
        places = {
            side: low + [0.0, sizes[above][1] / scale + _BETWEEN],
            above: low,
            end: low + [sizes[side][0] / scale, sizes[above][1] / scale] + _BETWEEN * np.ones(2),
        }
        for name, lines in views.items():
            view = View(scale, boxes[name][0], places[name])
            pen.lines([view(line) for line in lines], THICK)
            _around(pen, view, boxes[name], name)

    return Page(number, title, f"1:{scale}", draw, notes)


def _around(pen: Pen, view: View, box: tuple[FloatArray, FloatArray], name: str) -> None:
    """Overall dimensions of a view, and what it is below them."""
    low, high = box
    corner, far = view(low), view(high)
    size = high - low
    pen.dimension(corner, np.array([far[0], corner[1]]), -_FIRST, millimetres(size[0]))
    pen.dimension(corner, np.array([corner[0], far[1]]), _FIRST, millimetres(size[1]))
    pen.text(name, ((corner[0] + far[0]) / 2, corner[1] - _FIRST - 5.5), SMALL)
