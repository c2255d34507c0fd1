"""The parts list and the report as text files."""

from __future__ import annotations

import csv
import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from freecad_ortho.fabrication.part import Part

COLUMNS = (
    "name",
    "kind",
    "length_mm",
    "height_mm",
    "thickness_mm",
    "area_mm2",
    "volume_mm3",
    "mass_kg",
    "twist_deg",
    "vertices",
    "face",
)


def write_parts(path: Path, parts: Sequence[Part]) -> None:
    """Write one row a part.

    Length and height are those of the flat pattern's box (a beam: of its plate), the area is one
    face of the plate. Vertices and faces are counted from 0 in the order of the mesh file; vertices
    are separated by spaces, the face is empty for beams.

    Raises:
        OSError: the file cannot be written.
    """
    with path.open("w", encoding="utf-8", newline="") as stream:
        table = csv.writer(stream, lineterminator="\n")
        table.writerow(COLUMNS)
        for part in parts:
            sizes = (part.length, part.height, part.thickness, part.area, part.volume, part.mass)
            table.writerow(
                [
                    part.name,
                    part.kind,
                    *(f"{size:.6f}" for size in sizes),
                    f"{part.twist_deg:.3g}",
                    " ".join(map(str, part.vertices)),
                    "" if part.face is None else part.face,
                ]
            )


def write_report(path: Path, report: dict[str, Any]) -> None:
    """Write the report as JSON.

    Raises:
        OSError: the file cannot be written.
    """
    path.write_text(json.dumps(report, indent=2) + "\n", encoding="utf-8")
