"""The command stand: a net becomes a frame, loads go on it, and what it comes to is written."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Any

from freecad_ortho import api
from freecad_ortho.cli import options as arguments
from freecad_ortho.cli import reporting, values
from freecad_ortho.cli.endings import EXIT_NOT_CONVERGED, EXIT_OK, past_stopping
from freecad_ortho.structural.check import StructuralCheck
from freecad_ortho.structural.design import Design
from freecad_ortho.structural.sizing import Sizing
from freecad_ortho.structural.sizing_groups import GROUPINGS
from freecad_ortho.structural.words import warnings


def add(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    parser.description = (
        "A design check of the grid shell on a net: members on its edges as a frame in space, "
        "loads in kN and m. Exit code 1 where it does not pass. What is not checked is in the "
        "report."
    )
    values.allow_negative_lists(parser)
    for option in Design.options:
        arguments.add(parser, option, length="MM")
    parser.add_argument(
        "--self-weight", action="store_true", default=None, help="weight of members, as by default"
    )
    parser.add_argument(
        "--wind",
        action="append",
        metavar="Q@x|y|z|X,Y,Z",
        help="pressure in kN/m2 and where it blows to, on each face along its normal, by how far "
        "it faces the wind: pushed on the windward side, pulled on the other; a case each, may be "
        "repeated",
    )
    parser.add_argument(
        "--load",
        action="append",
        metavar="I:FX,FY,FZ",
        help="force on a vertex, kN; may be repeated",
    )
    parser.add_argument(
        "--combinations",
        metavar="FILE",
        help="combinations.json of an earlier check, edited (default: those of EN 1990)",
    )
    parser.add_argument(
        "--lightest-of",
        metavar="tubes|plates|glulam|NAME+NAME...",
        help="find the lightest section that passes, instead of --section",
    )
    parser.add_argument(
        "--groups",
        default="all",
        metavar="|".join(GROUPINGS),
        help="with --lightest-of: what has a section of its own, families (u, v, border) or "
        "three bands of members by how far they are used (default: all the same)",
    )
    parser.add_argument("-o", "--output", required=True, metavar="DIR", help="folder of the files")
    parser.add_argument("-v", "--verbose", action="store_true", help="say what is being done")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Check and write; what the check comes to is the last line and the exit code."""
    settings = _settings(options)
    Design.of(settings)
    read = reporting.read_net(options)
    common = {"unit": read.unit, "combinations": options.combinations, **settings}
    found: StructuralCheck | Sizing
    with reporting.Progress(options.verbose) as progress:
        if options.lightest_of is None:
            found = check = api.check_structure(read.mesh, progress=progress, **common)
        else:
            common.pop("section", None)
            found = api.size_structure(
                read.mesh, options.lightest_of, groups=options.groups, progress=progress, **common
            )
            check = found.check
    past_stopping()
    api.write_structural_check(found, options.output, Path(options.input).stem)
    for words in warnings(check):
        sys.stderr.write(f"note: {words}\n")
    sys.stdout.write(f"{found.verdict} Files are in {options.output}\n")
    return EXIT_OK if check.passed else EXIT_NOT_CONVERGED


def _settings(options: argparse.Namespace) -> Any:
    told = arguments.given(Design.options, options)
    for name in ("wind", "load"):
        if getattr(options, name):
            told[name] = tuple(getattr(options, name))
    return told
