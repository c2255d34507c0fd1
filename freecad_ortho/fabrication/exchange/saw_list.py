"""The saw list: every bar with its lengths, the angles of its ends, marks and holes.

Angles are those that a mitre saw is set to: the member lies on its lower side, the saw is turned by
the mitre and its blade tilted by the bevel.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from html import escape
from pathlib import Path

import numpy as np

from freecad_ortho.fabrication.exchange.members import Member, bevel_deg, member_of, mitre_deg
from freecad_ortho.fabrication.exchange.saw_sketch import sketch
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.pattern import FlatPattern
from freecad_ortho.fabrication.production import Production
from freecad_ortho.fabrication.report.lists import table
from freecad_ortho.fabrication.report.page import STYLE
from freecad_ortho.fabrication.round_tube import RoundTube
from freecad_ortho.fabrication.stock import Bar
from freecad_ortho.fabrication.tables import write_table
from freecad_ortho.words import counted
from solver.mesh.quadmesh import FloatArray

_ANGLES = tuple(
    f"{end}_{angle}{number}_deg"
    for end in ("start", "end")
    for number in ("", "_2")
    for angle in ("mitre", "bevel")
)
COLUMNS = (
    *("name", "kind", "material", "stock", "bar", "length_mm", "longest_edge_mm", "longest_at"),
    *(*_ANGLES, "holes", "marks", "mass_kg", "cut_by"),
)
_PAGE = ("name", "bar", "length_mm", "longest_edge_mm", "longest_at", *_ANGLES, "holes", "marks")


def write_saw_list(
    path: Path, production: Production, project: str, say: Callable[[float], None]
) -> None:
    """Write ``saw-list.csv`` and a page to be printed that says how to read its angles.

    Args:
        path: folder to make.
        production: of the structure.
        project: its name, the heading of the page.
        say: called with the fraction done; may raise to stop.

    Raises:
        OSError: a file cannot be written.
    """
    parts, rows = production.structure.parts, []
    bars = {name: bar for bar in production.bars for name in bar.parts}
    nodes = {node.vertex: node.name for node in production.nodes}
    for number, part in enumerate(parts):
        if number % 64 == 0:
            say(number / len(parts))
        row = _row(part, bars.get(part.name), nodes)
        if row is not None:
            rows.append(row)
    path.mkdir()
    write_table(path / "saw-list.csv", COLUMNS, rows)
    (path / "saw-list.html").write_text(_page(rows, project), encoding="utf-8")


def _row(part: Part, bar: Bar | None, nodes: Mapping[int, str]) -> list[str] | None:
    """The line of a part, None where it is no bar; nodes have their names by their vertices."""
    member = member_of(part)
    if bar is None and (member is None or part.pattern is not None):
        return None
    return [
        *(part.name, part.kind, part.material.name, bar.section if bar else _stock(part)),
        *(bar.name if bar else "", f"{_length(part, member):.2f}"),
        *_cuts(member),
        _holes(part.pattern),
        _marks(part, nodes),
        f"{part.mass:.2f}",
        "saw" if member is not None else "flat pattern",
    ]


def _length(part: Part, member: Member | None) -> float:
    """From tip to tip, mm."""
    if member is None:
        return part.length
    low, high = member.reach
    return high - low


def _stock(part: Part) -> str:
    """What a tube is sawn from that is on no bar of the list."""
    if part.section:
        return part.section
    if isinstance(part.body, RoundTube):
        return f"round tube {part.body.diameter:g} x {part.body.wall:g}"
    return f"tube {part.width:.0f} x {part.section_width or 0.0:g} x {part.thickness:g}"


def _cuts(member: Member | None) -> list[str]:
    """Longest edge, where it is, and the angles of both ends."""
    if member is None:
        return ["", ""] + [""] * len(_ANGLES)
    length, place = member.longest
    cells = [f"{length:.2f}", _place(member, place)]
    for planes in (member.starts, member.ends):
        for number in (0, 1):
            plane = planes[number] if number < len(planes) else None
            # No angle is minus nothing.
            cells += [
                "" if plane is None else f"{round(angle(plane), 3) + 0.0:.3f}" for angle in _SAWN
            ]
    return cells


_SAWN: tuple[Callable[[FloatArray], float], ...] = (mitre_deg, bevel_deg)


def _place(member: Member, place: FloatArray) -> str:
    """Where in the section a point is, in words."""
    low, high = member.low, member.high
    middle, half = (low + high) / 2, (high - low) / 2
    # What is within a thousandth of the middle is there.
    side = np.where(np.abs(place - middle) <= 1e-3 * half, 0, np.sign(place - middle)).astype(int)
    up, right = ("middle", "upper", "lower")[side[0]], ("middle", "right", "left")[side[1]]
    return up if up == right else f"{up} {right}"


def _holes(pattern: FlatPattern | None) -> str:
    """Diameter and place of each hole, from the lower left corner of the flat pattern's box."""
    holes = () if pattern is None else pattern.holes
    return "; ".join(
        f"{hole.diameter:g} at {hole.centre[0]:.1f} {hole.centre[1]:.1f}" for hole in holes
    )


def _marks(part: Part, nodes: Mapping[int, str]) -> str:
    """What to write on it: its name, then what it meets from its start on."""
    if part.pattern is not None:
        texts = [(float(mark.points[0, 0]), mark.text) for mark in part.pattern.marks if mark.text]
        return "; ".join([part.name, *(text for _, text in sorted(texts))])
    return "; ".join([part.name, *(nodes[vertex] for vertex in part.vertices)])


def _page(rows: list[list[str]], project: str) -> str:
    """The list by stock, below what its angles are."""
    title = escape(f"Saw list: {project}" if project else "Saw list")
    places = [COLUMNS.index(name) for name in _PAGE]
    head = [
        name.replace("_mm", ", mm").replace("_deg", ", deg").replace("_", " ") for name in _PAGE
    ]
    groups: dict[tuple[str, str], list[list[str]]] = {}
    for row in rows:
        groups.setdefault((row[3], row[2]), []).append(row)
    body = []
    for (stock, material), some in groups.items():
        body.append(f"<h2>{escape(stock)}, {escape(material)}: {counted(len(some), 'part')}</h2>")
        body.append(table(head, [[row[place] for place in places] for row in some]))
    return (
        f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{title}</title>'
        f"<style>{STYLE} body {{ max-width: none; }}</style></head>\n"
        f"<body><h1>{title}</h1>{sketch()}{''.join(body)}</body></html>\n"
    )
