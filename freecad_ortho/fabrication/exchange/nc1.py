"""NC1: a file a part for machines that saw, drill and cut steel.

Source: Deutscher Stahlbau-Verband (1998), Standard description for steel structure pieces for the
numerical controls, 7th edition. Lengths in mm. Faces are seen from outside with x to the right and
are measured from the lower left: v from the front, o from above, u from below; h as v, through the
part.
Angles of the header turn counter-clockwise from square, those of the web in v, of flanges in u.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Callable
from pathlib import Path

from freecad_ortho.fabrication.exchange.nc1_bars import Nc1Bar, bar_of
from freecad_ortho.fabrication.exchange.nc1_faces import (
    Contour,
    Nc1Mark,
    plate_contours,
    plate_marks,
)
from freecad_ortho.fabrication.nesting.sheet import file_words
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.production import Production
from freecad_ortho.fabrication.trades import is_metal

# Fields and texts are no longer; the standard has it so.
_FIELD, _TEXT = 80, 40
# Of sheets, m2/m2: both faces.
_BOTH_FACES = 2.0


def write_nc1(
    path: Path, production: Production, project: str, say: Callable[[float], None]
) -> None:
    """Write a file for every part of metal that is a bar or has a flat pattern.

    Args:
        path: folder to make.
        production: of the structure.
        project: its name, the order in the files.
        say: called with the fraction done; may raise to stop.

    Raises:
        OSError: a file cannot be written.
    """
    path.mkdir()
    parts = production.structure.parts
    for number, part in enumerate(parts):
        if number % 16 == 0:
            say(number / len(parts))
        text = _file(part, production, project) if is_metal(part.material) else None
        if text is not None:
            (path / f"{file_words(part.name)}.nc1").write_text(text, encoding="ascii", newline="\n")


def _file(part: Part, production: Production, project: str) -> str | None:
    """The text of a part's file, None where it is neither a bar nor a plate."""
    bar = bar_of(part)
    if bar is not None:
        return "\n".join(
            [*_head(part, project, bar), *_blocks(bar.contours), *_name(part, bar), "EN\n"]
        )
    if part.pattern is None:
        return None
    pattern = production.named_patterns[part.name]
    length, width = pattern.size.tolist()
    weight = part.material.mass(1e6 * part.thickness)
    sheet = Nc1Bar(
        f"PL{part.thickness:g}x{width:.1f}",
        "B",
        length,
        (width, 0.0, 0.0, part.thickness, 0.0),
        (weight, _BOTH_FACES),
        (0.0, 0.0, 0.0, 0.0),
    )
    lines = [*_head(part, project, sheet), *_blocks(plate_contours(part, pattern))]
    if pattern.holes:
        lines += ["BO", *(_hole(hole.centre.tolist(), hole.diameter) for hole in pattern.holes)]
    return "\n".join([*lines, *_marks(plate_marks(part.name, pattern)), "EN\n"])


def _head(part: Part, project: str, bar: Nc1Bar) -> list[str]:
    """The block ST: what the part is and how its ends are cut."""
    texts = (project, part.name, f"{part.family}{part.line}" if part.family else "", part.name)
    found = [*texts, part.material.name, "1", bar.name, bar.code]
    sizes = [f"{value:.3f}" for value in (bar.length, *bar.sizes, *bar.per_metre, *bar.cuts)]
    infos = (part.kind, "", "", "")
    return [
        "ST",
        *(f"  {_plain(text)[:_FIELD]}" for text in found),
        *(f"  {size:>12}" for size in sizes),
        *(f"  {_plain(text)[:_FIELD]}" for text in infos),
    ]


def _blocks(contours: tuple[Contour, ...]) -> list[str]:
    """A block AK or IK a contour, closed, each point with how the side that follows is bevelled."""
    lines = []
    for contour in contours:
        lines.append("IK" if contour.inner else "AK")
        rows = list(zip(contour.points.tolist(), contour.bevels, strict=True))
        for number, ((x, y), couples) in enumerate([*rows, (rows[0][0], ((0.0, 0.0),) * 2)]):
            values = [value for couple in couples for value in couple]
            words = "".join(f"{value:>10.3f}" for value in (0.0, *values))
            lines.append(f"  {contour.face if number == 0 else ' '}{x:>12.3f}u{y:>12.3f}{words}")
    return lines


def _hole(centre: list[float], diameter: float) -> str:
    return f"  v{centre[0]:>12.3f}u{centre[1]:>12.3f}{diameter:>10.2f}{0:>10.2f}"


def _name(part: Part, bar: Nc1Bar) -> list[str]:
    """The name in the middle of the front."""
    height = min(10, max(1, int(bar.sizes[0] / 3)))
    return _marks((Nc1Mark(part.name, bar.length / 2, bar.sizes[0] / 2, 0.0, height),))


def _marks(marks: tuple[Nc1Mark, ...]) -> list[str]:
    lines = ["SI"] if marks else []
    for mark in marks:
        place = f"  v{mark.x:>12.3f}u{mark.y:>12.3f}{mark.angle_deg:>10.2f}{mark.height:>5d} "
        lines.append(place + _plain(mark.text)[:_TEXT])
    return lines


def _plain(text: str) -> str:
    """A text in ASCII on one line, umlauts without their dots."""
    plain = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode("ascii")
    return " ".join(plain.split())
