"""How to read a saw list: a member from above and from its right side, with its angles."""

from __future__ import annotations

import math

from freecad_ortho.fabrication.report.pictures import BAD, INK, PAPER

# Of the sketch, in its own units: the member, its width and height, and the angles drawn.
_LENGTH, _ACROSS, _MITRE, _BEVEL = 420.0, 90.0, 25.0, 15.0
_WORDS = (
    "Lay the member on its lower side, its start on your left: you look at its right side, which "
    "has the marks of a plate. Write those of a tube there, from its start on.",
    "<b>Mitre</b>: the saw is turned by it from square. Positive where the cut is further along on "
    "the right side than on the left; the same sense at both ends, so equal mitres are parallel.",
    "<b>Bevel</b>: the blade is tilted by it from the upright. Positive where the cut is further "
    "along at the top than at the bottom; the same sense at both ends.",
    "Where an end has two cuts, mitre 2 and bevel 2 are those of the second: the first takes the "
    "right half (of a flange the upper half of its flat pattern), and both meet in the middle.",
    "<b>Length</b> is from tip to tip, what the bar loses. <b>Longest edge</b> is the longest line "
    "along the member, and where it is, seen from its start: lay the rule there.",
    "Holes: diameter, then along and up from the lower left corner of the flat pattern's box, mm. "
    "What is cut by its flat pattern has no angles here.",
)


def sketch() -> str:
    """The two views and the words, as HTML."""
    plan = _view("seen from above", "left", "right", "mitre", _MITRE)
    side = _view("seen from the right side", "top", "bottom", "bevel", _BEVEL)
    words = "".join(f"<li>{text}</li>" for text in _WORDS)
    return f'<div class="row">{plan}{side}</div><ul>{words}</ul>'


def _view(title: str, above: str, below: str, name: str, angle: float) -> str:
    """A member whose ends are both cut at a positive angle, with the line from which that is."""
    shift = _ACROSS * math.tan(math.radians(angle))
    # From above the right side is below in the picture, from the right side the top is above.
    upper, lower = (0.0, shift) if name == "mitre" else (shift, 0.0)
    x, y = 60.0, 40.0
    corners = ((upper, 0.0), (upper + _LENGTH, 0.0), (lower + _LENGTH, _ACROSS), (lower, _ACROSS))
    points = " ".join(f"{x + a:.1f},{y + b:.1f}" for a, b in corners)
    squares = "".join(
        f'<path d="M{x + a:.1f} {y - 14:.1f}V{y + _ACROSS + 14:.1f}" stroke="{BAD}" '
        'stroke-dasharray="5 4"/>'
        for a in (min(upper, lower), min(upper, lower) + _LENGTH)
    )
    texts = (
        (x + _LENGTH / 2, y - 8, above),
        (x + _LENGTH / 2, y + _ACROSS + 18, below),
        (x + _LENGTH / 2, y + _ACROSS / 2 + 5, "start on the left, end on the right"),
        (x - 22, y + _ACROSS + 30, f"{name} +{angle:g}"),
        (x + _LENGTH + 22, y + _ACROSS + 30, f"{name} +{angle:g}"),
    )
    written = "".join(
        f'<text x="{a:.1f}" y="{b:.1f}" text-anchor="middle" font-size="14" fill="{INK}">'
        f"{text}</text>"
        for a, b, text in texts
    )
    return (
        f'<figure><svg viewBox="0 0 560 180" role="img" aria-label="{title}">'
        f'<polygon points="{points}" fill="{PAPER}" stroke="{INK}" stroke-width="2"/>'
        f"{squares}{written}</svg><figcaption>{title}</figcaption></figure>"
    )
