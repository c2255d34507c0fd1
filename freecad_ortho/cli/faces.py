"""The command ``faces``: a net sampled from faces of a STEP file."""

from __future__ import annotations

import argparse
import sys

from freecad_ortho.cli import options as arguments
from freecad_ortho.cli import values
from freecad_ortho.sources.faces import FACES
from freecad_ortho.step_faces import step_surfaces
from freecad_ortho.units import millimetres_per


def add(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.description = (
        "CAD faces sampled along their own parameter lines, joined where they meet; needs cadquery."
    )
    parser.add_argument("input", metavar="IN.step")
    parser.add_argument("--faces", metavar="I,J,K", help="numbers from 1 (default: all)")
    for option in FACES.options:
        arguments.add(parser, option)
    values.add_output(parser)
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Sample and write, in the unit asked for, else mm."""
    values.refuse_unwritable(options.output)
    unit = options.unit or "mm"
    numbers = values.whole_numbers("--faces", options.faces) if options.faces else ()
    told = arguments.given(FACES.options, options, "mm", bare=unit)
    made = FACES.make(told, surfaces=step_surfaces(options.input, numbers))
    for remark in made.remarks:
        sys.stderr.write(f"{remark}\n")
    return values.write(options, made.mesh.scaled(1.0 / millimetres_per(unit)), unit)
