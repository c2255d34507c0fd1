"""The command ``align``: a net along a design surface's lines of curvature."""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

import numpy as np

from freecad_ortho.cli import options as arguments
from freecad_ortho.cli import values
from freecad_ortho.mesh_files import DEFAULT_UNIT, upright
from freecad_ortho.sources.aligning import ALIGNED, aligned_on, edge_for
from freecad_ortho.step_faces import step_surfaces
from freecad_ortho.triangles import read_triangles
from freecad_ortho.units import millimetres_per
from freecad_ortho.words import counted
from solver.align.align import Aligned, aligned
from solver.io.atomic import write_text
from solver.io.json_mesh import write_json
from solver.io.points import read_points
from solver.mesh.local_origin import LocalOrigin
from solver.mesh.quadmesh import FloatArray

_STEP = (".step", ".stp")


def add(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.description = (
        "Quads along the lines that an exact net has on a surface: curvature lines for principal "
        "and developable, lines at 45 degrees to them for asymptotic and cmc. The net overhangs "
        "the border by up to a face; optimise it with --close-to the same surface."
    )
    parser.add_argument("input", metavar="SURFACE.stl|obj|ply|off|glb|step")
    values.add_up(parser)
    for option in ALIGNED.options:
        arguments.add(parser, option)
    parser.add_argument(
        "--stroke",
        action="append",
        default=[],
        metavar="FILE",
        help="points of a curve along which the net runs; may be repeated",
    )
    parser.add_argument("--faces", metavar="I,J,K", help="of a STEP file, from 1 (default: all)")
    parser.add_argument("--report", metavar="R.json", help="border, singular vertices, remarks")
    values.add_output(parser)
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Align and write."""
    values.refuse_unwritable(options.output, options.report)
    made, unit, origin = (_on_step if _is_step(options.input) else _on_triangles)(options)
    for remark in made.remarks:
        sys.stderr.write(f"note: {remark}\n")
    words = f"{counted(len(made.irregular), 'irregular vertex', 'irregular vertices')}, "
    words += f"mean edge {made.mesh.mean_edge:.4g} {unit}"
    code = values.write(options, made.mesh, unit, words, origin)
    shift = values.origin_of(options, origin).shift
    border = [(line + origin.shift - shift).tolist() for line in made.border]
    if Path(options.output).suffix.lower() == ".json":
        back = LocalOrigin(origin.shift - shift).back_mesh(made.mesh)
        write_json(options.output, back, unit, border)
    elif options.report is None:
        sys.stderr.write("note: the border is kept in a .json file or a --report only\n")
    if options.report:
        places = made.mesh.vertices[made.irregular] + origin.shift - shift
        found = {
            "unit": unit,
            "faces": len(made.mesh.faces),
            "irregular_vertices": made.irregular.tolist(),
            "irregular_places": places.tolist(),
            "mean_edge": made.mesh.mean_edge,
            "border": border,
            "remarks": list(made.remarks),
        }
        write_text(options.report, json.dumps(found, indent=2) + "\n")
    return code


def _is_step(path: str) -> bool:
    return Path(path).suffix.lower() in _STEP


def _on_step(options: argparse.Namespace) -> tuple[Aligned, str, LocalOrigin]:
    unit = options.unit or "mm"
    numbers = values.whole_numbers("--faces", options.faces) if options.faces else ()
    told = ALIGNED.defaults | arguments.given(ALIGNED.options, options, "mm", bare=unit)
    scale = 1.0 / millimetres_per(unit)
    strokes = [stroke / scale for stroke in _strokes(options)]
    made = aligned_on(step_surfaces(options.input, numbers), **told, strokes=strokes)
    return made.scaled(scale), unit, LocalOrigin(np.zeros(3))


def _on_triangles(options: argparse.Namespace) -> tuple[Aligned, str, LocalOrigin]:
    vertices, triangles, named = read_triangles(options.input, options.up)
    unit = options.unit or named or DEFAULT_UNIT
    told = ALIGNED.defaults | arguments.given(ALIGNED.options, options, unit)
    origin = LocalOrigin.of(vertices)
    near = origin.near(vertices)
    one, two = (near[triangles[:, k]] - near[triangles[:, 0]] for k in (1, 2))
    area = 0.5 * float(np.linalg.norm(np.cross(one, two), axis=1).sum())
    told["edge"] = told["edge"] or edge_for(area, told["ratio"])
    strokes = [origin.near(stroke) for stroke in _strokes(options)]
    return aligned(near, triangles, **told, strokes=strokes), unit, origin


def _strokes(options: argparse.Namespace) -> list[FloatArray]:
    """Points of the curves, in the unit of the surface."""
    return [upright(read_points(path), options.up) for path in options.stroke]
