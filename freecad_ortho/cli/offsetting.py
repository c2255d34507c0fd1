"""The command ``offset``: a parallel mesh at a distance, and how constant that distance is."""

from __future__ import annotations

import argparse
import json
import math

from freecad_ortho import api
from freecad_ortho.cli import reporting, values
from freecad_ortho.units import millimetres_per
from solver.errors import InputError
from solver.io.atomic import write_text
from solver.offset.offset_mesh import KINDS


def add(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.description = (
        "Edges stay parallel where faces are planar. 'parallel' keeps the distance of the edges as "
        "even as one linear solve can; 'vertex', 'edge' and 'face' keep these distances constant, "
        "exactly on circular nets, nets parallel to a Koebe net, and conical nets."
    )
    parser.add_argument("input", metavar="IN.obj")
    values.add_up(parser)
    parser.add_argument(
        "--distance", type=float, required=True, metavar="MM", help="along the normals, or negative"
    )
    parser.add_argument("--kind", default="parallel", metavar="|".join(KINDS))
    parser.add_argument("--report", metavar="R.json", help="write the distances, in mm")
    values.add_output(parser)
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Write the offset mesh and say what its distance is."""
    values.refuse_unwritable(options.output, options.report)
    if not math.isfinite(options.distance):
        raise InputError(f"--distance: expected a finite number of mm, got {options.distance}")
    loaded = reporting.load(options)
    scale = millimetres_per(loaded.unit)
    found = api.offset_mesh(loaded.near.scaled(scale), options.distance, options.kind)
    if options.report:
        report = {
            "kind": found.kind,
            "distance_mm": found.distance,
            "message": found.message,
            "miss_max_mm": float(found.miss.max()),
            "miss_mean_mm": float(found.miss.mean()),
            "askew_max_deg": float(found.askew_deg.max()),
            "lean_max_deg": float(found.lean_deg.max()),
            "length_ratio_min": float(found.length_ratio.min()),
            "distances_mm": found.distances.tolist(),
        }
        write_text(options.report, json.dumps(report, indent=2) + "\n")
    mesh, words = found.mesh.scaled(1 / scale), f"in mm: {found.message}"
    return values.write(options, mesh, loaded.unit, words, loaded.origin)
