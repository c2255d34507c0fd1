"""A page to be printed for the site: pictures of what stands and what comes, and the nodes."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape

import numpy as np

from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.report.lists import table
from freecad_ortho.fabrication.report.page import STYLE
from freecad_ortho.fabrication.report.pictures import (
    BAD,
    CORNER,
    GOOD,
    INK,
    hulls_of,
    view_frame,
)
from freecad_ortho.words import counted
from solver.mesh.quadmesh import FloatArray

# Of pictures, in their own units; height of names in them; room for names beside a node.
_WIDE, _NAME, _SKETCH = 800.0, 13.0, 62.0
# Width of a letter of a name, parts of its height.
_LETTER = 0.6
# Longer lists stand in columns.
_ROWS = 12
# A picture has no more new parts, nor has a structure more pictures.
_PARTS, _PICTURES = 24, 60
_KINDS = ("stands", "comes", "later")
_STYLE = f"""
.steps figure {{ margin: 0 0 1.5rem; }} .steps svg {{ max-height: 15cm; }}
.stands {{ fill: #e8ebee; stroke: {INK}; stroke-width: .5; }}
.comes {{ fill: {GOOD}; stroke: {INK}; stroke-width: .8; }}
.later {{ fill: none; stroke: #dde2e6; stroke-width: .5; }}
.steps text {{ font: {_NAME}px sans-serif; text-anchor: middle; fill: {BAD}; }}
.many {{ columns: 3 15rem; }} .many table {{ width: 100%; margin: 0; }}
.book {{ display: flex; flex-wrap: wrap; gap: .5rem; }}
.book figure {{ margin: 0; width: 11.5rem; }} .book text {{ font: 8px sans-serif; fill: {INK}; }}
"""


@dataclass(frozen=True, eq=False)
class NodeArm:
    """What leads away from a node.

    Attributes:
        towards: name of the node at its other end.
        parts: names of the parts along it, each with which of its ends is here.
        turn_deg: from the first arm on, counter-clockwise seen from the tip of the node's axis.
    """

    towards: str
    parts: str
    turn_deg: float


def assembly_page(
    order: Sequence[Part],
    stages: Sequence[int],
    held: Sequence[Sequence[str]],
    book: Sequence[tuple[str, Sequence[NodeArm]]],
    project: str,
) -> str:
    """The page as HTML; pictures are part of it.

    Args:
        order: all parts in the order in which they are put up.
        stages: for each the number of what it is put up with, such as a ring.
        held: for each the names of the parts that stand already and meet it.
        book: names of nodes, and what leads away from each.
        project: its name, the heading.
    """
    title = escape(f"Assembly: {project}" if project else "Assembly")
    steps = _steps(order, stages, held)
    sketches = "".join(_sketch(name, arms) for name, arms in book)
    return (
        f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{title}</title>'
        f"<style>{STYLE}{_STYLE}</style></head>\n<body><h1>{title}</h1>"
        f'<div class="steps">{steps}</div><h2>Node book</h2><p>Each node is seen from the tip of '
        f'its axis, its first edge to the right.</p><div class="book">{sketches}</div>'
        "</body></html>\n"
    )


def pictures_of(stages: Sequence[int]) -> list[tuple[int, int]]:
    """First step of each picture and the one after its last: parts of one stage, not too many."""
    most = max(_PARTS, -(-len(stages) // _PICTURES))
    found, start = [], 0
    for number in range(1, len(stages) + 1):
        ends = number == len(stages) or stages[number] != stages[start]
        if ends or number - start == most:
            found.append((start, number))
            start = number
    return found


def _steps(order: Sequence[Part], stages: Sequence[int], held: Sequence[Sequence[str]]) -> str:
    """A picture for some parts at a time, above a list of them."""
    shapes, middles, behind, size = _shapes(order)
    drawn = [
        f'<svg width="0" height="0"><defs>{"".join(shapes)}</defs></svg>',
    ]
    placed = 0.0
    for start, end in pictures_of(stages):
        uses = "".join(
            f'<use href="#s{k}" class="{_KINDS[int(k >= start) + int(k >= end)]}"/>'
            for k in (*(k for k in behind if k >= end), *(k for k in behind if k < end))
        )
        shown = _apart(range(start, end), middles, order)
        names = "".join(
            f'<text x="{middles[k][0]:.1f}" y="{middles[k][1]:.1f}">{escape(order[k].name)}</text>'
            for k in shown
        )
        left_out = end - start - len(shown)
        more = f" Names of {left_out} that have no room are in the list." if left_out else ""
        mass = sum(part.mass for part in order[start:end])
        placed += mass
        rows = [
            [str(k + 1), order[k].name, order[k].kind, " ".join(held[k]), f"{order[k].mass:.1f}"]
            for k in range(start, end)
        ]
        words = f"Steps {start + 1} to {end}" if end - start > 1 else f"Step {end}"
        drawn.append(
            f"<figure><h2>{words}: {counted(end - start, 'part')}, {mass:,.1f} kg</h2>"
            f'<svg xmlns="http://www.w3.org/2000/svg" role="img" aria-label="{words}" '
            f'viewBox="-24 -24 {size[0] + 48:.0f} {size[1] + 48:.0f}">{uses}{names}</svg>'
            "<figcaption>blue: what comes; grey: what stands; pale: what comes later. Then "
            f"{placed:,.1f} kg stand.{more}</figcaption></figure>"
            f'<div class="{"many" if len(rows) > _ROWS else "few"}">'
            f"{table(['step', 'name', 'kind', 'stands on', 'mass, kg'], rows)}</div>"
        )
    return "".join(drawn)


def _apart(numbers: Sequence[int], middles: FloatArray, order: Sequence[Part]) -> list[int]:
    """Those of some parts whose names do not cover those before them."""
    found: list[int] = []
    boxes = np.empty((0, 4))
    for k in numbers:
        half = np.array([_LETTER * _NAME * len(order[k].name), _NAME]) / 2
        low, high = middles[k] - half, middles[k] + half
        if not ((low < boxes[:, 2:]) & (boxes[:, :2] < high)).all(axis=1).any():
            found.append(k)
            boxes = np.concatenate([boxes, [[*low, *high]]])
    return found


def _shapes(order: Sequence[Part]) -> tuple[list[str], FloatArray, list[int], FloatArray]:
    """Of each part its outline from a corner, its middle; all from behind; the picture's size."""
    frame = view_frame(CORNER)
    base = order[0].origin
    seen, owners = [], []
    for number, part in enumerate(order):
        for piece in part.body.pieces():
            seen.append((part.origin - base + piece.corners @ part.frame) @ frame.T)
            owners.append(number)
    hulls = hulls_of([points[:, :2] for points in seen])
    corners = np.concatenate(hulls)
    low, high = corners.min(axis=0), corners.max(axis=0)
    scale = _WIDE / max(float((high - low).max()), 1e-9)
    paths: dict[int, list[str]] = defaultdict(list)
    depths: dict[int, list[float]] = defaultdict(list)
    places: dict[int, list[FloatArray]] = defaultdict(list)
    for hull, points, owner in zip(hulls, seen, owners, strict=True):
        flat = (hull - [low[0], high[1]]) * [scale, -scale]
        paths[owner].append("M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in flat.tolist()) + "Z")
        depths[owner].append(float(points[:, 2].mean()))
        places[owner].append(flat.mean(axis=0))
    numbers = range(len(order))
    shapes = [f'<path id="s{k}" d="{"".join(paths[k])}"/>' for k in numbers]
    middles = np.array([np.mean(places[k], axis=0) for k in numbers])
    behind = sorted(numbers, key=lambda k: float(np.mean(depths[k])))
    return shapes, middles, behind, (high - low) * scale


def _sketch(name: str, arms: Sequence[NodeArm]) -> str:
    """A node from the tip of its axis."""
    drawn = []
    for arm in arms:
        turn = np.radians(arm.turn_deg)
        x, y = float(np.cos(turn)), -float(np.sin(turn))
        anchor = "start" if x > 0.3 else "end" if x < -0.3 else "middle"
        drawn.append(
            f'<path d="M{8 * x:.1f} {8 * y:.1f}L{34 * x:.1f} {34 * y:.1f}" stroke="{INK}" '
            'stroke-width="2"/>'
        )
        for row, words in enumerate((arm.parts, f"to {arm.towards}")):
            drawn.append(
                f'<text x="{38 * x:.1f}" y="{42 * y + 9 * row:.1f}" text-anchor="{anchor}">'
                f"{escape(words)}</text>"
            )
    reach = _SKETCH
    return (
        f'<figure><svg viewBox="{-1.6 * reach:.0f} {-reach:.0f} {3.2 * reach:.0f} {2 * reach:.0f}" '
        f'role="img" aria-label="{name}"><circle r="8" fill="none" stroke="{INK}"/>'
        f"{''.join(drawn)}</svg><figcaption><b>{escape(name)}</b></figcaption></figure>"
    )
