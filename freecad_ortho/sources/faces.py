"""CAD faces as a source; what a face is comes as plain functions."""

from __future__ import annotations

from collections.abc import Sequence

from freecad_ortho.sources.primitives import sampling as sampling_option
from freecad_ortho.sources.source import Made, Source
from solver.mesh.sampling import ParametricSurface, sampled
from solver.option import Option, Range


def _sampled(
    surfaces: Sequence[ParametricSurface],
    unit: str,
    sampling: tuple[int, int],
    edge: float,
    spacing: str,
    outside: str,
    u_part: tuple[float, float],
    v_part: tuple[float, float],
) -> Made:
    chosen = [surface.part(u_part, v_part) for surface in surfaces]
    made = sampled(
        chosen,
        counts=None if edge else sampling,
        edge=edge or None,
        spacing=spacing,
        outside=outside,
    )
    return Made(made.mesh, made.remarks)


FACES = Source(
    "faces",
    "CAD faces sampled along their own parameter lines",
    (
        sampling_option(13, 13),
        Option("edge", 0.0, "length", "Edges are about this long, whatever the sampling",
               absent="by the sampling"),
        Option("spacing", "length",
               "choice", "Lines stand at even distances, or at equal steps of the parameters",
               ("length", "parameter")),
        Option("outside", "snap", "choice",
               "Quads that the border cuts are set onto it, or left out",
               ("snap", "drop")),
        Option("u_part", (0.0, 1.0), "number", "The net covers this part of the range of u",
               within=Range(0.0, 1.0)),
        Option("v_part", (0.0, 1.0), "number", "The net covers this part of the range of v",
               within=Range(0.0, 1.0)),
    ),
    _sampled,
    "faces",
)  # fmt: skip
