"""The parts list and the report as text files."""

from __future__ import annotations

import csv
import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from freecad_ortho.fabrication.part import Part

# The height is the width under the name that readers of the first beams and panels know.
_SIZES = ("length", "width", "width", "thickness", "area", "volume", "mass")
_MEASURES = (
    "gap_mm",
    "twist_deg",
    "straightness_mm",
    "radius_mm",
    "radius_spread_mm",
    "min_bend_radius_mm",
    "stress_MPa",
    "lean_deg",
    "torsion_deg_per_m",
)
COLUMNS = (
    "name",
    "kind",
    "family",
    "line",
    "length_mm",
    "width_mm",
    "height_mm",
    "thickness_mm",
    "area_mm2",
    "volume_mm3",
    "mass_kg",
    *_MEASURES,
    "vertices",
    "face",
    "verdict",
)


def write_parts(path: Path, parts: Sequence[Part], verdicts: Sequence[str]) -> None:
    """Write one row a part.

    Length and width are those of the flat pattern's box (a beam: of its plate), the area is one
    face of the plate. Vertices, faces and lines are counted from 0 in the order of the mesh file;
    vertices are separated by spaces; what has no meaning for a part is empty.

    Raises:
        OSError: the file cannot be written.
    """
    with path.open("w", encoding="utf-8", newline="") as stream:
        table = csv.writer(stream, lineterminator="\n")
        table.writerow(COLUMNS)
        for part, verdict in zip(parts, verdicts, strict=True):
            table.writerow(
                [
                    part.name,
                    part.kind,
                    part.family,
                    "" if part.line is None else part.line,
                    *(f"{getattr(part, size):.6f}" for size in _SIZES),
                    *(_number(getattr(part.measures, name)) for name in _MEASURES),
                    " ".join(map(str, part.vertices)),
                    "" if part.face is None else part.face,
                    verdict,
                ]
            )


def write_report(path: Path, report: dict[str, Any]) -> None:
    """Write the report as JSON.

    Raises:
        OSError: the file cannot be written.
    """
    path.write_text(json.dumps(report, indent=2) + "\n", encoding="utf-8")


def _number(value: float | None) -> str:
    return "" if value is None else f"{value:.6g}"
