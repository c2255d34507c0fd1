"""The command ``faces``: a net sampled from faces of a STEP file."""

from __future__ import annotations

import argparse
import sys

from freecad_ortho.cli import values
from freecad_ortho.step_faces import net_from_step
from freecad_ortho.units import millimetres_per


def add(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.description = (
        "CAD faces sampled along their own parameter lines, joined where they meet; needs cadquery."
    )
    parser.add_argument("input", metavar="IN.step")
    parser.add_argument("--faces", metavar="I,J,K", help="numbers from 1 (default: all)")
    parser.add_argument("--sampling", metavar="MxN", help="vertices along u and v")
    parser.add_argument("--edge", type=float, metavar="L", help="wanted edge length instead")
    parser.add_argument("--spacing", default="length", metavar="length|parameter")
    parser.add_argument(
        "--outside", default="snap", metavar="snap|drop", help="what becomes of quads a border cuts"
    )
    parser.add_argument("--u-part", default="0,1", metavar="A,B", help="part of the range of u")
    parser.add_argument("--v-part", default="0,1", metavar="A,B", help="part of the range of v")
    values.add_output(parser)
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Sample and write, in the unit asked for, else mm."""
    values.refuse_unwritable(options.output)
    unit = options.unit or "mm"
    scale = millimetres_per(unit)
    numbers = values.whole_numbers("--faces", options.faces) if options.faces else ()
    first, last = values.numbers("--u-part", options.u_part, 2)
    low, high = values.numbers("--v-part", options.v_part, 2)
    net = net_from_step(
        options.input,
        numbers,
        counts=values.sampling(options.sampling) if options.sampling else None,
        edge=None if options.edge is None else options.edge * scale,
        spacing=options.spacing,
        outside=options.outside,
        u_part=(first, last),
        v_part=(low, high),
    )
    for remark in net.remarks:
        sys.stderr.write(f"{remark}\n")
    return values.write(options, net.mesh.scaled(1.0 / scale), unit)
