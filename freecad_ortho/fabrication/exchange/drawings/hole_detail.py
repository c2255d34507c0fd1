"""Nodes that are drilled, a page for each type: where their holes are, as the lists say it."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from freecad_ortho.fabrication.ball_body import Ball
from freecad_ortho.fabrication.drawing_form import DrawingForm, scale_for
from freecad_ortho.fabrication.drilled import DrilledBody
from freecad_ortho.fabrication.exchange.drawings.page import Page, room_of
from freecad_ortho.fabrication.exchange.drawings.pen import MIDDLE, SMALL, TEXT, THICK, THIN, Pen
from freecad_ortho.fabrication.exchange.drawings.view import View, millimetres
from freecad_ortho.fabrication.part import Part, some_names
from freecad_ortho.fabrication.production import Production
from freecad_ortho.fabrication.systems.nodes.hollow import HollowPrism
from freecad_ortho.fabrication.systems.system import Table
from solver.mesh.quadmesh import FloatArray

_LISTS = ("hub-holes.csv", "ball-holes.csv")
# Of a row of the table, of what stands around a view, and of what is between faces, mm on paper.
_ROW, _AROUND, _BETWEEN = 4.6, 22.0, 17.0
_CHAIN = (4.0, 1.0, 0.6, 1.0)
# Names of equal nodes that a page has; the report has all.
_NAMES = 12
_DEGREE, _DIAMETER = "\N{DEGREE SIGN}", "\N{LATIN CAPITAL LETTER O WITH STROKE}"
_Rows = list[tuple[object, ...]]


def hole_pages(production: Production, form: DrawingForm) -> list[Page]:
    """One page a type of hubs and balls, the most frequent first; none where none is drilled."""
    parts = {part.name: part for part in production.structure.parts}
    found: list[Page] = []
    for table in _tables(production):
        by_name: dict[str, _Rows] = {}
        for row in table.rows:
            by_name.setdefault(str(row[0]), []).append(row)
        groups = [
            group for group in production.groups.shapes.get("node", []) if group[0] in by_name
        ]
        for group in sorted(groups, key=lambda group: (-len(group), group[0])):
            rows = by_name[group[0]]
            found.append(_page(form, parts[group[0]], group, table.columns, rows))
    return found


def _tables(production: Production) -> list[Table]:
    results = production.structure.results.values()
    return [table for result in results for table in result.tables if table.name in _LISTS]


def _page(
    form: DrawingForm, part: Part, group: Sequence[str], columns: Sequence[str], rows: _Rows
) -> Page:
    """The page of a node that stands for its group."""
    body = part.body.whole if isinstance(part.body, DrilledBody) else part.body
    kind = "Ball" if isinstance(body, Ball) else "Hub"
    alike = f", {len(group)} alike" if len(group) > 1 else ""
    notes = [
        f"{part.material.name}, {part.mass:.2f} kg; {part.note}",
        "azimuths counter-clockwise seen from above, along the axis, from the first beam on; "
        f"plates and beams are those of {part.name}",
    ]
    if len(group) > 1:
        notes.append(f"alike: {some_names(group, _NAMES)}")
    low, high = room_of(form, len(notes))
    below = _ROW * (len(rows) + 2)
    room = np.array([(high - low)[0] / 2, (high - low)[1] - below]) - 2 * _AROUND
    size = (float(room[0]), float(room[1]))
    if isinstance(body, Ball):
        scale = scale_for(2 * body.radius, 2 * body.radius, size)
        views = _ball(body, columns, rows, scale)
    else:
        assert isinstance(body, HollowPrism)
        faces = _faces(body, columns, rows)
        wide = 2 * float(np.linalg.norm(body.outer, axis=1).max())
        scale = scale_for(wide, wide, size)
        strip = max(size[0] + 2 * _AROUND - _BETWEEN * (len(faces) + 1), 10.0)
        across = sum(width for _, width, _ in faces)
        scale = max(scale, scale_for(across, body.high - body.low, (strip, size[1])))
        views = _hub(body, faces, columns, rows, scale)

    def draw(pen: Pen, corner: FloatArray, far: FloatArray) -> None:
        floor = corner + [0.0, below]
        middle = (floor + far) / 2
        quarter = np.array([(far - corner)[0] / 4, 0.0])
        for show, at in zip(views, (middle - quarter, middle + quarter), strict=True):
            show(pen, at)
        _table(pen, corner, columns[1:], rows, float((far - corner)[0]))

    return Page(
        f"{kind.upper()}-{part.name}",
        f"{kind} {part.name}{alike}",
        f"1:{scale}",
        draw,
        tuple(notes),
    )


_Show = Callable[[Pen, FloatArray], None]


def _table(pen: Pen, corner: FloatArray, columns: Sequence[str], rows: _Rows, wide: float) -> None:
    """The rows of the list, numbered as in the views."""
    heads = ["hole", *columns] if "hole" not in columns else list(columns)
    lines = [
        [*([str(number)] if "hole" not in columns else []), *map(str, row[1:])]
        for number, row in enumerate(rows, start=1)
    ]
    step = min(wide / len(heads), 42.0)
    top = corner[1] + _ROW * (len(rows) + 0.4)
    for k, words in enumerate(heads):
        at = corner + [k * step, 0.0]
        pen.text(words, (at[0], top), SMALL, anchor="start", room=step - 2.0)
        for number, line in enumerate(lines, start=1):
            place = at[0], top - _ROW * number
            pen.text(line[k], place, TEXT, anchor="start", room=step - 2.0)
    ruled = [top + y for y in (_ROW * 0.75, -1.2)]
    pen.lines([np.array([[corner[0], y], [corner[0] + step * len(heads), y]]) for y in ruled], THIN)


def _by_azimuth(columns: Sequence[str], rows: _Rows) -> dict[float, list[int]]:
    """Numbers of rows, from 0, by their azimuth."""
    at, found = columns.index("azimuth_deg"), dict[float, list[int]]()
    for number, row in enumerate(rows):
        found.setdefault(float(str(row[at])), []).append(number)
    return found


def _rays(pen: Pen, at: FloatArray, found: dict[float, list[int]], reach: float) -> None:
    """From the axis through holes, each with their numbers and azimuth."""
    for azimuth, numbers in found.items():
        out = _way(azimuth)
        pen.lines([np.array([at, at + (reach + 4.0) * out])], THIN, dash=_CHAIN)
        anchor = "start" if out[0] > 0.3 else "end" if out[0] < -0.3 else "middle"
        named = ", ".join(str(number + 1) for number in numbers)
        words = f"{named}: {azimuth:.2f}{_DEGREE}"
        pen.text(words, at + (reach + 5.5) * out - [0.0, TEXT / 2], TEXT, anchor=anchor)
    below = at - [0.0, reach + 14.0]
    pen.text("seen from above, along the axis", below, SMALL)


def _way(azimuth: float) -> FloatArray:
    return np.array([np.cos(np.radians(azimuth)), np.sin(np.radians(azimuth))])


def _faces(
    body: HollowPrism, columns: Sequence[str], rows: _Rows
) -> list[tuple[float, float, list[int]]]:
    """Azimuth and width, mm, of each face that is drilled, and the numbers of its rows."""
    sides = body.outer - np.roll(body.outer, 1, axis=0)
    widths = np.linalg.norm(sides, axis=1)
    normals = np.column_stack([sides[:, 1], -sides[:, 0]]) / widths[:, None]
    found = []
    for azimuth, numbers in _by_azimuth(columns, rows).items():
        side = int((normals @ _way(azimuth)).argmax())
        found.append((azimuth, float(widths[side]), numbers))
    return found


def _hub(
    body: HollowPrism,
    faces: Sequence[tuple[float, float, list[int]]],
    columns: Sequence[str],
    rows: _Rows,
    scale: int,
) -> tuple[_Show, _Show]:
    """Along its axis, and its drilled faces beside each other, seen from outside."""
    reach = float(np.linalg.norm(body.outer, axis=1).max()) / scale

    def plan(pen: Pen, at: FloatArray) -> None:
        view = View(scale, np.zeros(2), at)
        pen.lines([view(body.outer), view(body.inner)], THICK, closed=True)
        _rays(pen, at, _by_azimuth(columns, rows), reach)
        face = float(str(rows[0][columns.index("face_mm")]))
        pen.dimension(at, at + face / scale * _way(faces[0][0]), 4.0, millimetres(face))

    def side(pen: Pen, at: FloatArray) -> None:
        height = (body.high - body.low) / scale
        total = sum(width for _, width, _ in faces) / scale + _BETWEEN * (len(faces) - 1)
        corner = at - [total / 2 - _BETWEEN / 3, height / 2]
        level, size = columns.index("from_lower_mm"), columns.index("hole_mm")
        for azimuth, width, numbers in faces:
            box = np.array([[0, 0], [width / scale, 0], [width / scale, height], [0, height]])
            pen.lines([corner + box], THICK, closed=True)
            heights = [float(str(rows[number][level])) for number in numbers]
            for step, (number, up) in enumerate(zip(numbers, heights, strict=True)):
                place = corner + [width / scale / 2, up / scale]
                pen.circle(place, float(str(rows[number][size])) / scale / 2, MIDDLE)
                away = 4.0 + 5.0 * step
                pen.dimension(corner, corner + [0.0, up / scale], away, millimetres(up))
                pen.text(str(number + 1), place + [0.0, -SMALL / 2], SMALL)
            pen.text(f"{azimuth:.2f}{_DEGREE}", corner + [width / scale / 2, -5.0], SMALL)
            corner = corner + [width / scale + _BETWEEN, 0.0]
        right = corner - [_BETWEEN, 0.0]
        words = millimetres(body.high - body.low)
        pen.dimension(right, right + [0.0, height], -5.0, words)
        pen.text(
            "drilled faces seen from outside, the axis upwards",
            at - [0.0, height / 2 + 11.0],
            SMALL,
        )

    return plan, side


def _ball(body: Ball, columns: Sequence[str], rows: _Rows, scale: int) -> tuple[_Show, _Show]:
    """Along its axis, and a section through one of its holes."""
    radius = body.radius / scale

    def plan(pen: Pen, at: FloatArray) -> None:
        pen.circle(at, radius, THICK)
        _rays(pen, at, _by_azimuth(columns, rows), radius)

    def section(pen: Pen, at: FloatArray) -> None:
        seat, half = body.seat / scale, body.hole / 2 / scale
        rim = float(np.sqrt(max(radius**2 - seat**2, 0.0)))
        turn = np.arctan2(rim, seat)
        angles = np.linspace(turn, 2 * np.pi - turn, 73)
        ring = at + radius * np.column_stack([np.cos(angles), np.sin(angles)])
        end = seat - body.depth / scale
        hole = at + np.array([[seat, half], [end, half], [end, -half], [seat, -half]])
        pen.lines([np.concatenate([ring, ring[:1]]), hole], THICK)
        pen.lines([at + np.array([[-radius - 4.0, 0.0], [radius + 6.0, 0.0]])], THIN, dash=_CHAIN)
        pen.dimension(at, at + [seat, 0.0], -radius - 5.0, millimetres(body.seat))
        start = at + [end, half]
        pen.dimension(
            start, start + [body.depth / scale, 0.0], radius - half + 5.0, millimetres(body.depth)
        )
        thread, drill = (str(rows[0][columns.index(name)]) for name in ("thread", "drill_mm"))
        words = f"{thread}, drilled {_DIAMETER}{drill}"
        pen.text(words, at + [seat + 8.0, 2.0], TEXT, anchor="start")
        pen.text("section through a hole; seats are square to it", at - [0.0, radius + 14.0], SMALL)

    return plan, section
