"""The command tolerances: how far nodes land off where beams are cut and drilled with errors."""

from __future__ import annotations

import argparse
import json
import sys

from freecad_ortho import api
from freecad_ortho.cli import options as arguments
from freecad_ortho.cli import reporting, values
from freecad_ortho.cli.endings import EXIT_OK, past_stopping
from freecad_ortho.fabrication.tolerances import Tolerances
from solver.io.atomic import write_text


def add(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    parser.description = (
        "Bolts a grid shell together in many trials, its beams cut and drilled with random errors, "
        "and says how far nodes land off, how far holes miss each other, and what tolerance the "
        "design bears."
    )
    for option in Tolerances.options:
        arguments.add(parser, option, length="MM")
    parser.add_argument(
        "--held",
        metavar="I,J,...",
        help="nodes that stay where they are, from 0 (default: the boundary)",
    )
    parser.add_argument("-o", "--output", metavar="OUT.json", help="write the numbers")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Bolt the shell together and say what came of it."""
    given = arguments.given(Tolerances.options, options)
    Tolerances(**given)
    held = None if options.held is None else values.whole_numbers("--held", options.held)
    read = reporting.read_net(options)
    landed = api.tolerances(read.mesh, unit=read.unit, held=held, **given)
    if options.output is not None:
        text = json.dumps({"file": options.input, **landed.report()}, indent=2)
        past_stopping()
        write_text(options.output, f"{text}\n")
    sys.stdout.write(f"{landed.words()}\n")
    return EXIT_OK
