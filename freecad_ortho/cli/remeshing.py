"""The command ``quads``: a triangle mesh remeshed to quads."""

from __future__ import annotations

import argparse
import sys

from freecad_ortho.cli import options as options_of
from freecad_ortho.cli import values
from freecad_ortho.mesh_files import DEFAULT_UNIT
from freecad_ortho.triangles import read_triangles
from freecad_ortho.units import millimetres_per
from solver.mesh.local_origin import LocalOrigin
from solver.mesh.remesh import OPTIONS, quads_from_triangles


def add(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.description = (
        "Quads with few irregular vertices, on the surface and with border and corners kept; needs "
        "the library pyQuadriFlow."
    )
    parser.add_argument("input", metavar="IN.stl|obj|ply|off|glb")
    values.add_up(parser)
    for option in OPTIONS:
        options_of.add(parser, option)
    values.add_output(parser)
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Remesh and write."""
    values.refuse_unwritable(options.output)
    vertices, triangles, unit = read_triangles(options.input, options.up)
    unit = options.unit or unit or DEFAULT_UNIT
    millimetres_per(unit)
    origin = LocalOrigin.of(vertices)
    made = quads_from_triangles(
        origin.near(vertices), triangles, **options_of.given(OPTIONS, options, unit)
    )
    for remark in made.remarks:
        sys.stderr.write(f"note: {remark}\n")
    words = (
        f"{len(made.irregular)} irregular vertices, mean edge {made.mesh.mean_edge:.4g} {unit}, "
        f"border within {made.border_gap:.2g} {unit}"
    )
    return values.write(options, made.mesh, unit, words, origin)
