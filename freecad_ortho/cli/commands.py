"""The commands of the command line, their options, and how they end."""

from __future__ import annotations

import argparse
import json
import os
import sys
from collections.abc import Sequence

from freecad_ortho import api
from freecad_ortho.cli import (
    building,
    fabricating,
    net_options,
    optimising,
    reporting,
    sources,
    standing,
    tolerating,
    values,
)
from freecad_ortho.cli import options as arguments
from freecad_ortho.cli.endings import EXIT_BAD_INPUT, EXIT_NOT_CONVERGED, EXIT_OK
from freecad_ortho.units import MILLIMETRES, millimetres_per
from solver.analysis.build_score import SECTIONS, build_score
from solver.errors import OrthoError, cannot_be_written
from solver.nets import NETS


def run(arguments: Sequence[str] | None = None) -> int:
    """Run one command; return its exit code."""
    options = _parser().parse_args(arguments)
    try:
        code = int(options.run(options))
        sys.stdout.flush()
        return code
    except OrthoError as error:
        sys.stderr.write(f"error: {error}\n")
    except BrokenPipeError:
        # Whoever read the output has seen enough; the interpreter must not try to write the rest.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return EXIT_OK
    except OSError as error:
        said = cannot_be_written(error.filename or "the output", error, "check the path")
        sys.stderr.write(f"error: {said}\n")
        if error.filename is not None:
            return EXIT_BAD_INPUT
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return EXIT_BAD_INPUT


class _Parser(argparse.ArgumentParser):
    """Says what is wrong with the arguments in one line."""

    def error(self, message: str) -> None:  # type: ignore[override]
        self.exit(EXIT_BAD_INPUT, f"error: {message}; see {self.prog} --help\n")


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(
        prog="python -m freecad_ortho",
        description="Optimise quad meshes and turn them into parts that a workshop can cut.",
    )
    commands = parser.add_subparsers(dest="command", required=True, parser_class=_Parser)
    _add_optimise(commands.add_parser("optimise", help="make a mesh a net, e.g. principal"))
    fabricate = commands.add_parser("fabricate", help="parts of a net: STEP, DXF, CSV, report")
    _add_input(fabricate)
    fabricating.add(fabricate)
    building.add(
        commands.add_parser("build", help="a design surface to parts: all stages in one command")
    )
    _add_check(commands.add_parser("check", help="measure a mesh against every net"))
    stand = commands.add_parser("stand", help="a structural check of the grid shell on a net")
    _add_input(stand)
    standing.add(stand)
    tolerances = commands.add_parser("tolerances", help="what errors of the workshop make of a net")
    _add_input(tolerances)
    tolerating.add(tolerances)
    sources.add(commands)
    return parser


def _add_optimise(parser: argparse.ArgumentParser) -> None:
    _add_input(parser)
    names = ", ".join(NETS)
    parser.add_argument("--net", default="principal", help=f"{names} (default: principal)")
    parser.add_argument(
        "-o", "--output", required=True, metavar="OUT.obj", help="the net; its name says the format"
    )
    parser.add_argument("--report", metavar="R.json", help="write the numbers of the run")
    values.add_origin(parser)
    net_options.add(parser)
    net_options.add_close_to(parser)
    parser.add_argument("-v", "--verbose", action="store_true", help="one line a step")
    parser.set_defaults(run=_optimise)


def _add_check(parser: argparse.ArgumentParser) -> None:
    _add_input(parser)
    parser.add_argument("--json", action="store_true", help="numbers for other programs")
    parser.add_argument(
        "--build", action="store_true", help="how easily a grid shell on it is built, as freeGrid"
    )
    arguments.add(parser, SECTIONS)
    parser.set_defaults(run=_check)


def _add_input(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("input", metavar="IN.obj")
    parser.add_argument(
        "--unit",
        choices=tuple(MILLIMETRES),
        help="unit of the coordinates (default: what the file says, else mm)",
    )
    values.add_up(parser)


def _optimise(options: argparse.Namespace) -> int:
    return EXIT_OK if optimising.run(options) else EXIT_NOT_CONVERGED


def _check(options: argparse.Namespace) -> int:
    read = reporting.read_net(options, mixed=True)
    result = {"file": options.input, "unit": read.unit, **api.check(read.mesh)}
    if options.build:
        counts = arguments.given((SECTIONS,), options)
        score = build_score(read.mesh, millimetres_per(read.unit), **counts)
        result["build"] = score.as_dict()
    text = json.dumps(result, indent=2) if options.json else reporting.check_table(result)
    sys.stdout.write(text + "\n")
    return EXIT_OK
