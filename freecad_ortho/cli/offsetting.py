"""The command ``offset``: a parallel mesh at a distance, and how constant that distance is."""

from __future__ import annotations

import argparse
import json

from freecad_ortho import api
from freecad_ortho.cli import options as arguments
from freecad_ortho.cli import reporting, values
from freecad_ortho.cli.endings import past_stopping
from freecad_ortho.sources import source
from freecad_ortho.units import millimetres_per
from solver.io.atomic import write_text


def add(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.description = (
        "Edges stay parallel where faces are planar. 'parallel' keeps the distance of the edges as "
        "even as one linear solve can; 'vertex', 'edge' and 'face' keep these distances constant, "
        "exactly on circular nets, nets parallel to a Koebe net, and conical nets."
    )
    parser.add_argument("input", metavar="IN.obj")
    values.add_up(parser)
    for option in source("offset").options:
        arguments.add(parser, option, length="MM")
    parser.add_argument("--report", metavar="R.json", help="write the distances, in mm")
    values.add_output(parser)
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Write the offset mesh and say what its distance is."""
    values.refuse_unwritable(options.output, options.report)
    entry = source("offset")
    told = entry.defaults | arguments.given(entry.options, options)
    read = reporting.read_net(options)
    scale = millimetres_per(read.unit)
    found = api.offset_mesh(read.near.scaled(scale), **told)
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
        past_stopping()
        write_text(options.report, json.dumps(report, indent=2) + "\n")
    mesh, words = found.mesh.scaled(1 / scale), f"in mm: {found.message}"
    return values.write(options, mesh, read.unit, words, read.origin)
