"""The command ``align``: a net along a design surface's lines of curvature."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Callable
from typing import Any

from freecad_ortho.cli import options as arguments
from freecad_ortho.cli import reporting, values
from freecad_ortho.curve_files import read_curves
from freecad_ortho.mesh_files import upright
from freecad_ortho.sources.aligning import ALIGNED
from freecad_ortho.sources.source import singular
from freecad_ortho.surface_files import Found, SurfaceFile
from solver.align.crosses import Singular
from solver.io.atomic import write_text

# Strokes are files here.
_SETTINGS = tuple(option for option in ALIGNED.options if option.kind != "polylines")

Waiting = Callable[[str], None]


def add(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.description = (
        "Quads along the lines that an exact net has on a surface: curvature lines for principal "
        "and developable, lines at 45 degrees to them for asymptotic and cmc, along the "
        "asymptotic directions for asymptotic-angle and webs. The net overhangs the border by up "
        "to a face, unless it follows it; optimise it with --close-to the same surface."
    )
    parser.add_argument("input", metavar="SURFACE.stl|obj|ply|off|glb|step")
    values.add_up(parser)
    arguments.add(parser, ALIGNED.option("net"))
    add_settings(parser)
    parser.add_argument("--report", metavar="R.json", help="border, singular vertices, remarks")
    parser.add_argument(
        "--save-singularities",
        metavar="FILE",
        help="write where other than four lines meet, as --singularities reads it",
    )
    values.add_output(parser)
    parser.add_argument("-v", "--verbose", action="store_true", help="say what is being done")
    parser.set_defaults(run=run)


def add_settings(group: argparse._ActionsContainer) -> None:
    """Options that say how a net lies on its surface."""
    for option in _SETTINGS:
        if option.name != "net":
            arguments.add(group, option)
    group.add_argument(
        "--stroke",
        action="append",
        default=[],
        metavar="FILE",
        help="points of a curve along which the net runs, or a 3DM file of curves; may be repeated",
    )
    group.add_argument("--faces", metavar="I,J,K", help="of a STEP file, from 1 (default: all)")


def run(options: argparse.Namespace) -> int:
    """Align and write."""
    values.refuse_unwritable(options.output, options.report, options.save_singularities)
    found = align(options)
    code = values.write(
        options, found.net.mesh, found.unit, found.words, found.origin, found.net.border
    )
    about = values.origin_of(options, found.origin)
    if options.report:
        write_text(options.report, json.dumps(found.numbers(about), indent=2) + "\n")
    if options.save_singularities:
        rows = [" ".join(f"{x!r}" for x in row) for row in found.singularities(about)]
        head = f"# x y z in {found.unit}, lines that meet there\n"
        write_text(options.save_singularities, head + "".join(f"{row}\n" for row in rows))
    return code


def align(options: argparse.Namespace) -> Found:
    """Align as the options say; what is out of the ordinary is said on stderr."""
    numbers = values.whole_numbers("--faces", options.faces) if options.faces else ()
    with reporting.Progress(options.verbose) as progress:
        surface = SurfaceFile.read(options.input, options.unit, options.up, numbers)
        told = _told(options, surface.unit)
        strokes = [
            line for path in options.stroke for line in read_curves(path, surface.unit, options.up)
        ]
        found = surface.aligned(**told, strokes=strokes, waiting=_follower(progress))
    for remark in found.net.remarks:
        sys.stderr.write(f"note: {remark}\n")
    return found


def _follower(progress: reporting.Progress) -> Waiting:
    """Turn the names of steps into how far the work is; each is said once."""
    said: set[str] = set()

    def follow(step: str) -> None:
        if step not in said:
            said.add(step)
            progress(ALIGNED.stages.index(step) / len(ALIGNED.stages), step)

    return follow


def _told(options: argparse.Namespace, unit: str) -> dict[str, Any]:
    """Settings by name, those that were not given as they usually are."""
    usual = {option.name: option.default for option in _SETTINGS}
    told = usual | arguments.given(_SETTINGS, options, unit, bare=unit)
    if told["singularities"] is not None:
        given = singular("--singularities", told["singularities"])
        told["singularities"] = Singular(upright(given.places, options.up), given.valences)
    return told
