"""Diagrams of forces as SVG text: ordinates across the members, with numbers at the extremes."""

from __future__ import annotations

import math
from html import escape

import numpy as np

from freecad_ortho.fabrication.report.pictures import INK, view_frame
from freecad_ortho.structural.diagrams import UNITS, Diagram, across, fitting
from solver.frame.model import Frame
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import FloatArray

POSITIVE, NEGATIVE = "#b21f29", "#214f99"
_WIDTH, _LEGEND = 800.0, 52.0
# The least ordinate worth drawing, pixels.
_LEAST = 0.3
_TEXT = f'font-family="sans-serif" font-size="18" fill="{INK}"'


def diagram_picture(
    frame: Frame, force: str, values: FloatArray, eye: tuple[float, float, float], words: str
) -> str:
    """Draw a force along all members in parallel projection.

    Args:
        frame: of members.
        force: one of ``FORCES``.
        values: (M, 3) of it at start, middle and end of the members, kN or kNm.
        eye: direction towards the viewer.
        words: what the picture shows.
    """
    turn, diagram = view_frame(eye), Diagram.through(values)
    flat = (frame.nodes - frame.nodes[frame.members[0, 0]]) @ turn.T
    base = diagram.along(*(flat[frame.members[:, k]] for k in (0, 1)))[:, :, :2]
    side = (across(force, frame.axes) @ turn.T)[:, None, :2]
    size = fitting(diagram, frame.nodes[frame.members])
    tips = base + size * diagram.values[:, :, None] * side
    corners = np.concatenate([base.reshape(-1, 2), tips.reshape(-1, 2)])
    low, high = corners.min(axis=0), corners.max(axis=0)
    scale = _WIDTH / max(float((high - low).max()), 1e-9)
    base, tips = ((points - [low[0], high[1]]) * [scale, -scale] for points in (base, tips))
    ends = "".join(
        f"M{x:.1f} {y:.1f}L{u:.1f} {v:.1f}" for (x, y), (u, v) in base[:, [0, -1]].tolist()
    )
    shapes = [f'<path d="{ends}" fill="none" stroke="#98a2ac" stroke-width="0.8"/>']
    for colour, clipped in (
        (POSITIVE, np.maximum(diagram.values, 0.0)),
        (NEGATIVE, np.minimum(diagram.values, 0.0)),
    ):
        drawn = np.abs(clipped).max(axis=1) * size * scale > _LEAST
        tip = base + (scale * size * clipped)[:, :, None] * side * [1.0, -1.0]
        path = "".join(map(_areas, base[drawn], tip[drawn], clipped[drawn] != 0.0))
        shapes.append(
            f'<path d="{path}" fill="{colour}" fill-opacity="0.45" stroke="{colour}" '
            'stroke-width="0.6"/>'
        )
    unit = UNITS[force]
    shapes += [_label(tips[at], f"{diagram.values[at]:.3g} {unit}") for at in diagram.extremes()]
    width, height = (high - low) * scale
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" role="img" aria-label="{escape(words)}" '
        f'viewBox="-6 -26 {width + 12:.0f} {height + _LEGEND + 26:.0f}">{"".join(shapes)}'
        f"{_scale(height, diagram.largest, size * scale, unit)}</svg>"
    )


def _areas(base: FloatArray, tip: FloatArray, there: BoolArray) -> str:
    """Each stretch of a member where there is something: over the tips and back."""
    changes = np.flatnonzero(np.diff(np.concatenate([[False], there, [False]]).astype(int)))
    found = []
    for one, two in changes.reshape(-1, 2).tolist():
        first, last = max(one - 1, 0), min(two, len(base) - 1)
        points = np.concatenate(
            [base[first : first + 1], tip[first : last + 1], base[last : last + 1]]
        )
        # What is drawn twice once.
        words = dict.fromkeys(f"{x:.1f} {y:.1f}" for x, y in points.tolist())
        found.append(f"M{'L'.join(words)}Z")
    return "".join(found)


def _label(at: FloatArray, words: str) -> str:
    x, y = at.tolist()
    side = "end" if x > 0.8 * _WIDTH else "start"
    return (
        f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{INK}"/>'
        f'<text x="{x + (-7 if side == "end" else 7):.1f}" y="{y - 6:.1f}" {_TEXT} '
        f'text-anchor="{side}" font-weight="bold" stroke="#fff" stroke-width="4" '
        f'paint-order="stroke">{words}</text>'
    )


def _scale(height: float, largest: float, pixels: float, unit: str) -> str:
    """A bar as long as an ordinate that is seen from the side."""
    if not largest:
        return f'<text x="0" y="{height + 30:.0f}" {_TEXT}>nothing</text>'
    power = 10.0 ** math.floor(math.log10(largest))
    round_one = max(part * power for part in (1, 2, 5) if part * power <= largest)
    x, y = round_one * pixels, height + 26
    boxes = "".join(
        f'<rect x="{left}" y="{y - 12:.1f}" width="14" height="14" fill="{colour}" '
        f'fill-opacity="0.6"/><text x="{left + 20}" y="{y + 2:.1f}" {_TEXT}>{words}</text>'
        for left, colour, words in ((330, POSITIVE, "positive"), (450, NEGATIVE, "negative"))
    )
    return (
        f'<path d="M0 {y - 6:.1f}v8M0 {y - 2:.1f}h{x:.1f}m0 -4v8" stroke="{INK}" fill="none" '
        f'stroke-width="2"/><text x="{x + 8:.1f}" y="{y + 4:.1f}" {_TEXT}>{round_one:g} {unit}'
        f"</text>{boxes}"
    )
