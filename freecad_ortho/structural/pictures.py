"""Pictures of a checked frame as SVG text: members in colours, and shapes they move to."""

from __future__ import annotations

from html import escape

import numpy as np

from freecad_ortho.fabrication.report.pictures import INK, view_frame
from solver.frame.model import Frame
from solver.mesh.quadmesh import FloatArray

# Colours from nothing to all, and beyond.
_STOPS = ((44, 123, 182), (123, 190, 205), (232, 222, 140), (240, 160, 85), (205, 50, 60))
_BEYOND = "#7a0f3c"
_WIDTH, _LEGEND = 800.0, 60.0


def frame_picture(
    frame: Frame,
    values: FloatArray,
    largest: float,
    unit: str,
    eye: tuple[float, float, float],
    words: str,
    moved: FloatArray | None = None,
) -> str:
    """Draw members in parallel projection, coloured by a value, with a legend.

    Args:
        frame: of members.
        values: (M,) of the members, what the colours say.
        largest: value of the last colour; what is beyond has a colour of its own.
        unit: of the values.
        eye: direction towards the viewer.
        words: what the picture shows.
        moved: (N, 3) how far nodes are drawn from where they are; the frame itself is thin then.
    """
    turn = view_frame(eye)
    base = (frame.nodes - frame.nodes[frame.members[0, 0]]) @ turn.T
    shown = base if moved is None else base + moved @ turn.T
    used = np.unique(frame.members)
    corners = np.concatenate([base[used], shown[used]])[:, :2]
    low, high = corners.min(axis=0), corners.max(axis=0)
    scale = _WIDTH / max(float((high - low).max()), 1e-9)
    size = (high - low) * scale
    at = [(points[:, :2] - [low[0], high[1]]) * [scale, -scale] for points in (base, shown)]
    lines = []
    if moved is not None:
        lines.append(f'<path d="{_lines(at[0], frame)}" fill="none" stroke="#b8c0c8"/>')
    depth = shown[frame.members].mean(axis=1)[:, 2]
    for member in np.argsort(depth, kind="stable").tolist():
        (x, y), (u, v) = (at[1][node] for node in frame.members[member])
        colour = _colour(float(values[member]) / largest if largest else 0.0)
        lines.append(
            f'<path d="M{x:.1f} {y:.1f}L{u:.1f} {v:.1f}" stroke="{colour}" stroke-width="3.2" '
            f'stroke-linecap="round"><title>member {member}: {values[member]:.3g} {unit}</title>'
            "</path>"
        )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" role="img" aria-label="{escape(words)}" '
        f'viewBox="-6 -6 {size[0] + 12:.0f} {size[1] + _LEGEND + 12:.0f}">{"".join(lines)}'
        f"{_legend(size, largest, unit, bool((values > largest).any()))}</svg>"
    )


def _lines(at: FloatArray, frame: Frame) -> str:
    ends = at[frame.members].tolist()
    return "".join(f"M{x:.1f} {y:.1f}L{u:.1f} {v:.1f}" for (x, y), (u, v) in ends)


def _legend(size: FloatArray, largest: float, unit: str, beyond: bool) -> str:
    top, steps = float(size[1]) + 16, 20
    width = 300.0 / steps
    boxes = [
        f'<rect x="{k * width:.1f}" y="{top:.1f}" width="{width + 0.5:.1f}" height="14" '
        f'fill="{_colour((k + 0.5) / steps)}"/>'
        for k in range(steps)
    ]
    text = f'font-family="sans-serif" font-size="20" fill="{INK}"'
    words = [
        f'<text x="0" y="{top + 36:.1f}" {text}>0</text>',
        f'<text x="300" y="{top + 36:.1f}" {text} text-anchor="end">{largest:.3g} {unit}</text>',
    ]
    if beyond:
        boxes.append(
            f'<rect x="312" y="{top:.1f}" width="14" height="14" fill="{_BEYOND}"/>'
            f'<text x="334" y="{top + 14:.1f}" {text}>beyond</text>'
        )
    return "".join([*boxes, *words])


def _colour(part: float) -> str:
    if part > 1 + 1e-9:
        return _BEYOND
    along = min(max(part, 0.0), 1.0) * (len(_STOPS) - 1)
    first = min(int(along), len(_STOPS) - 2)
    one, two = np.array(_STOPS[first]), np.array(_STOPS[first + 1])
    red, green, blue = np.round(one + (along - first) * (two - one)).astype(int).tolist()
    return f"#{red:02x}{green:02x}{blue:02x}"
