"""The command ``formfind``: supports, tension and loads in, a shape in equilibrium out."""

from __future__ import annotations

import argparse
import sys
from dataclasses import replace

from freecad_ortho.cli import options as arguments
from freecad_ortho.cli import reporting, values
from freecad_ortho.cli.endings import EXIT_NOT_CONVERGED, EXIT_OK
from freecad_ortho.sources.forming import FORM, found
from solver.nets.settings import STEPS, WEIGHTS

# What ends the iteration.
_ENDS = (WEIGHTS["tolerance"], replace(STEPS, default=500, brief="largest number of linear solves"))


def add(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.description = (
        "Cable net: one linear solve for force densities (force / length), iterated where loads "
        "follow the shape. Membrane: constant stress (force / length), started from the cable net."
    )
    parser.add_argument("input", metavar="IN.obj")
    values.add_up(parser)
    for option in FORM.options:
        arguments.add(parser, option)
    for option in _ENDS:
        arguments.add(parser, option)
    values.add_output(parser)
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Find the form and write it; exit code 1 where there is no equilibrium."""
    values.refuse_unwritable(options.output)
    ends = {option.name: option.default for option in _ENDS} | arguments.given(_ENDS, options)
    for option in _ENDS:
        option.check(ends[option.name])
    told = arguments.given(FORM.options, options)
    read = reporting.read_net(options)
    form, remarks = found(
        read.near,
        **(FORM.defaults | told),
        tolerance=ends["tolerance"],
        max_iterations=ends["max_steps"],
    )
    for remark in remarks:
        sys.stderr.write(f"note: {remark}\n")
    if not form.converged:
        sys.stderr.write(f"not converged: {form.message}\n")
        if form.unbalanced > 1:
            return EXIT_NOT_CONVERGED
    words = f"{form.message}, {form.iterations} solves, unbalanced {form.unbalanced:.1e}"
    values.write(options, form.mesh, read.unit, words, read.origin)
    return EXIT_OK if form.converged else EXIT_NOT_CONVERGED
