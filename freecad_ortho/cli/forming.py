"""The command ``formfind``: supports, tension and loads in, a shape in equilibrium out."""

from __future__ import annotations

import argparse
import sys

from freecad_ortho.cli import reporting, values
from freecad_ortho.cli.endings import EXIT_NOT_CONVERGED, EXIT_OK
from freecad_ortho.sources.forming import lifted
from solver.analysis.upright import side_remark
from solver.errors import InputError
from solver.formfinding import (
    CableNet,
    Loads,
    Membrane,
    Tension,
    family_densities,
    find_form,
    supported,
)


def add(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.description = (
        "Cable net: one linear solve for force densities (force / length), iterated where loads "
        "follow the shape. Membrane: constant stress (force / length), started from the cable net."
    )
    parser.add_argument("input", metavar="IN.obj")
    values.add_up(parser)
    parser.add_argument("--supports", default="boundary", metavar="boundary|corners|I,J,K")
    parser.add_argument(
        "--lift",
        default="",
        metavar="I,Z[;I,Z...]",
        help="raise supports by Z first, e.g. '0,1.5;20,1.5'",
    )
    parser.add_argument("--kind", default="cables", metavar="cables|membrane")
    parser.add_argument("--density", type=float, default=1.0, metavar="Q", help="of the cables")
    parser.add_argument("--border", type=float, metavar="Q", help="density of the border's cables")
    parser.add_argument("--stress", type=float, default=1.0, metavar="S", help="of the membrane")
    parser.add_argument("--cable", type=float, default=0.0, metavar="F", help="force in its border")
    parser.add_argument("--vertex-load", default="0,0,0", metavar="X,Y,Z", help="at each vertex")
    parser.add_argument("--area-load", default="0,0,0", metavar="X,Y,Z", help="per area of faces")
    parser.add_argument("--beam-load", default="0,0,0", metavar="X,Y,Z", help="per edge length")
    parser.add_argument("--pressure", type=float, default=0.0, metavar="P", help="along normals")
    parser.add_argument("--tolerance", type=float, default=1e-10)
    parser.add_argument("--max-steps", type=int, default=500, metavar="N")
    values.add_output(parser)
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Find the form and write it; exit code 1 where there is no equilibrium."""
    values.refuse_unwritable(options.output)
    if options.kind not in ("cables", "membrane"):
        raise InputError(f"--kind: expected cables or membrane, got '{options.kind}'")
    if options.max_steps < 1 or not options.tolerance > 0:
        raise InputError("--max-steps and --tolerance: expected positive numbers")
    loaded = reporting.load(options)
    mesh = loaded.near
    held = supported(mesh, options.supports)
    mesh = lifted(mesh, held, options.lift, "--lift")
    loads = Loads(
        values.numbers("--vertex-load", options.vertex_load, 3),
        values.numbers("--area-load", options.area_load, 3),
        values.numbers("--beam-load", options.beam_load, 3),
        options.pressure,
    )
    side = side_remark(mesh, loads.vertex, loads.area, loads.beam)
    if side is not None:
        sys.stderr.write(f"note: {side}\n")
    q = options.density
    tension: Tension = CableNet(family_densities(mesh, q, q, options.border))
    if options.kind == "membrane":
        if options.lift:
            mesh = find_form(mesh, held, tension).mesh
        tension = Membrane(options.stress, options.cable)
    found = find_form(
        mesh, held, tension, loads, tolerance=options.tolerance, max_iterations=options.max_steps
    )
    if not found.converged:
        sys.stderr.write(f"not converged: {found.message}\n")
        if found.unbalanced > 1:
            return EXIT_NOT_CONVERGED
    words = f"{found.message}, {found.iterations} solves, unbalanced {found.unbalanced:.1e}"
    values.write(options, found.mesh, loaded.unit, words, loaded.origin)
    return EXIT_OK if found.converged else EXIT_NOT_CONVERGED
