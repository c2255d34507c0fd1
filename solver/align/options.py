"""What may be asked of a net on a surface: each declared once, with what it may be."""

from __future__ import annotations

from solver.align.guides import TURNED
from solver.align.membrane import STANDS_ON
from solver.align.symmetry import SYMMETRIES
from solver.option import Option, Range

OPTIONS: dict[str, Option] = {
    option.name: option
    for option in (
        Option(
            "net",
            "principal",
            "choice",
            "The net is to become this one; asymptotic and cmc lines run at 45 degrees to "
            "curvature, those of asymptotic-angle where the surface does not bend, stress lines as "
            "a shell carries its weight",
            tuple(TURNED),
        ),
        Option("edge", None, "length", "Edges are about this long"),
        Option(
            "ratio",
            1.0,
            "number",
            "Edges of the other family of lines are so many times as long",
            within=Range(0.05, 20.0),
        ),
        Option(
            "border",
            "trim",
            "choice",
            "At the border the net overhangs the surface, to be trimmed, or bends to follow it",
            ("trim", "follow"),
            title="At the border",
        ),
        Option(
            "stands_on",
            "boundary",
            "choice",
            "Stress nets: the shell whose stresses the lines follow stands on this",
            STANDS_ON,
        ),
        Option(
            "symmetry",
            "none",
            "choice",
            "The net is its own mirror image in these planes: auto for those that the surface has, "
            "or those across an axis, through the middle of the surface",
            SYMMETRIES,
        ),
    )
}
