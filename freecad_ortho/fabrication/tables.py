"""The lists of parts, nodes, stock and bends, and the report, as text files."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from freecad_ortho.fabrication.fasteners import COLUMNS as HARDWARE_COLUMNS
from freecad_ortho.fabrication.fasteners import hardware_rows
from freecad_ortho.fabrication.nodes import Node
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.pattern import Bend, Bevel, FlatPattern
from freecad_ortho.fabrication.place import Place
from freecad_ortho.fabrication.production import Production
from freecad_ortho.fabrication.stock import Bar

_LENGTHS, _AMOUNTS = ("length", "width", "section_height", "thickness"), ("area", "volume", "mass")
_MEASURES = (
    "gap_mm",
    "twist_deg",
    "straightness_mm",
    "radius_mm",
    "radius_spread_mm",
    "min_bend_radius_mm",
    "stress_MPa",
    "shear_MPa",
    "combined_MPa",
    "lean_deg",
    "torsion_deg_per_m",
    "bearing_mm",
    "misfit_mm",
    "warp_mm",
    "cold_MPa",
    "bend_use_percent",
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
    "section",
    "material",
    "area_mm2",
    "volume_mm3",
    "mass_kg",
    *_MEASURES,
    "vertices",
    "face",
    "equal_to",
    "seen_from",
    "bevels",
    "bevel_max_deg",
    "cut_from",
    "note",
    "verdict",
)
NODE_COLUMNS = (
    *("name", "vertex", "x_mm", "y_mm", "z_mm", "axis_x", "axis_y", "axis_z"),
    *("parts", "neighbours", "angles_deg", "slopes_deg", "equal_to"),
)
BEND_COLUMNS = (
    *("part", "bend", "x1_mm", "y1_mm", "x2_mm", "y2_mm", "angle_deg"),
    *("axis_x_mm", "axis_y_mm", "twist_deg"),
)
BEVEL_COLUMNS = ("part", "bevel", "x1_mm", "y1_mm", "x2_mm", "y2_mm", "angle_deg", "line_on")
STOCK_COLUMNS = (
    *("name", "kind", "material", "section", "width_mm", "width_min_mm", "thickness_mm"),
    *("length_mm", "parts", "used_mm", "left_mm", "rest"),
)


Table = tuple[Sequence[str], list[list[object]]]


def parts_table(
    parts: Sequence[Part],
    verdicts: Sequence[str],
    equal_to: Mapping[str, str],
    places: Mapping[str, str],
) -> Table:
    """One row a part.

    Length and width are those of the flat pattern's box (a beam: of its plate), the height that of
    the section, the area is one face of the plate. Vertices, faces and lines are counted from 0 in
    the order of the mesh file; vertices are separated by spaces; what has no meaning for a part is
    empty.

    Args:
        parts: in the order of the rows.
        verdicts: one a part.
        equal_to: the first of the parts that are cut alike, by the names of the parts.
        places: the sheet or bar that it is cut from, by the names of the parts.
    """
    rows: list[list[object]] = [
        [
            part.name,
            part.kind,
            part.family,
            "" if part.line is None else part.line,
            *(f"{getattr(part, size):.6f}" for size in _LENGTHS),
            part.section,
            part.material.name,
            *(f"{getattr(part, amount):.6f}" for amount in _AMOUNTS),
            *(_number(getattr(part.measures, name)) for name in _MEASURES),
            " ".join(map(str, part.vertices)),
            "" if part.face is None else part.face,
            equal_to.get(part.name, ""),
            *_bevel_cells(part.pattern),
            places.get(part.name, ""),
            part.note,
            verdict,
        ]
        for part, verdict in zip(parts, verdicts, strict=True)
    ]
    return COLUMNS, rows


def nodes_table(nodes: Sequence[Node], equal_to: Mapping[str, str], place: Place) -> Table:
    """One row a node: place in mm, axis, parts, angles and slopes of its edges in degrees.

    Args:
        nodes: in the order of the rows.
        equal_to: the first of the nodes that are alike, by the names of the nodes.
        place: puts points and axes where they stand in the files.
    """
    rows: list[list[object]] = [
        [
            node.name,
            node.vertex,
            *(f"{value:.6f}" for value in place.points(node.point)),
            *(f"{value:.9f}" for value in place.directions(node.axis)),
            " ".join(node.parts),
            " ".join(map(str, node.neighbours)),
            " ".join(f"{angle:.4f}" for angle in node.angles_deg),
            " ".join(f"{slope:.4f}" for slope in node.slopes_deg),
            equal_to.get(node.name, ""),
        ]
        for node in nodes
    ]
    return NODE_COLUMNS, rows


def stock_table(bars: Sequence[Bar]) -> Table:
    """One row a bar: its section and length, the parts sawn from it, what is left over; mm."""
    rows: list[list[object]] = [
        [
            bar.name,
            bar.kind,
            bar.material,
            bar.section,
            *(f"{size:.6f}" for size in (*bar.widths[::-1], bar.thickness, bar.length)),
            " ".join(bar.parts),
            f"{bar.used:.6f}",
            f"{bar.left:.6f}",
            "kept" if bar.usable else "scrap",
        ]
        for bar in bars
    ]
    return STOCK_COLUMNS, rows


def lists(production: Production) -> dict[str, Table]:
    """The lists of a structure, by the names of their files without endings.

    That of hardware is there where something is bought.
    """
    structure, equal_to = production.structure, production.groups.equal_to
    hardware = hardware_rows(structure.fasteners, structure.supplies)
    return {
        "parts": parts_table(structure.parts, production.verdicts, equal_to, production.places),
        "nodes": nodes_table(production.nodes, equal_to, structure.place),
        "stock": stock_table(production.bars),
        **({"hardware": (HARDWARE_COLUMNS, hardware)} if hardware else {}),
    }


def write_bends(path: Path, patterns: Mapping[str, FlatPattern]) -> None:
    """Write one row a bend line: its ends in the flat pattern, mm, and its angle in degrees.

    Where the part has an axis, its place on the line follows, and the twist from there to the next
    line: enough digits to fold the pattern back.

    Args:
        path: file to write.
        patterns: by the names of their parts.

    Raises:
        OSError: the file cannot be written.
    """
    rows = (
        [
            name,
            number,
            *_line_and_angle(bend, 9),
            *(("", "") if bend.axis is None else (f"{x:.6f}" for x in bend.axis)),
            f"{bend.twist_deg:.9f}",
        ]
        for name, pattern in patterns.items()
        for number, bend in enumerate(pattern.bends)
    )
    write_table(path, BEND_COLUMNS, rows)


def write_bevels(path: Path, patterns: Mapping[str, FlatPattern]) -> None:
    """Write one row a bevelled side: its inner line in the flat pattern, mm, and its angle.

    Args:
        path: file to write.
        patterns: by the names of their parts.

    Raises:
        OSError: the file cannot be written.
    """
    rows = (
        [name, number, *_line_and_angle(bevel), "far side" if bevel.hidden else "side seen"]
        for name, pattern in patterns.items()
        for number, bevel in enumerate(pattern.bevels)
    )
    write_table(path, BEVEL_COLUMNS, rows)


def _line_and_angle(line: Bend | Bevel, digits: int = 6) -> list[str]:
    return [*(f"{x:.6f}" for x in line.points.ravel()), f"{line.angle_deg:.{digits}f}"]


def _bevel_cells(pattern: FlatPattern | None) -> list[str]:
    """The side that is seen, the number of bevels and the largest angle."""
    if pattern is None:
        return ["", "", ""]
    worst = max((bevel.angle_deg for bevel in pattern.bevels), key=abs, default=None)
    return [pattern.seen, str(len(pattern.bevels)), _number(worst)]


def write_table(path: Path, columns: Sequence[str], rows: Iterable[Sequence[object]]) -> None:
    """Write a table with a line of names above it.

    Raises:
        OSError: the file cannot be written.
    """
    with path.open("w", encoding="utf-8", newline="") as stream:
        table = csv.writer(stream, lineterminator="\n")
        table.writerow(columns)
        table.writerows(rows)


def write_report(path: Path, report: dict[str, Any]) -> None:
    """Write the report as JSON.

    Raises:
        ValueError: a number in it is not finite; JSON has no such numbers.
        OSError: the file cannot be written.
    """
    path.write_text(json.dumps(report, indent=2, allow_nan=False) + "\n", encoding="utf-8")


def _number(value: float | None) -> str:
    return "" if value is None else f"{value:.6g}"
