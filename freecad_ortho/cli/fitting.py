"""The command ``fit-multinet``: the exact multi-net nearest to a mesh."""

from __future__ import annotations

import argparse
from dataclasses import replace

import numpy as np

from freecad_ortho.cli import options as arguments
from freecad_ortho.cli import reporting, values
from freecad_ortho.sources.primitives import sampling
from solver.multinet import fit_multi_net, multi_net_residual

_SAMPLING = replace(sampling(25, 13), brief="sample the fitted net anew")


def add(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.description = (
        "Says how far a mesh of grid type is from a multi-net, fits a quadric, a curve on it and t "
        "values, and writes the exact multi-net, numbered like the mesh unless sampled anew."
    )
    parser.add_argument("input", metavar="IN.obj")
    values.add_up(parser)
    arguments.add(parser, _SAMPLING, usual="as the mesh")
    values.add_output(parser)
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Fit and write."""
    values.refuse_unwritable(options.output)
    counts: tuple[int, int] | None = arguments.given((_SAMPLING,), options).get("sampling")
    if counts:
        _SAMPLING.check(counts)
    read = reporting.read_net(options)
    before = multi_net_residual(read.near).worst
    fit = fit_multi_net(read.near)
    mesh = fit.mesh
    if counts:
        mesh = fit.net.sampled(*counts, (float(fit.t.min()), float(fit.t.max())))
    with np.errstate(divide="ignore"):
        lengths = 1.0 / np.sqrt(np.abs(fit.quadric.curvatures))
    centre = read.origin.back(fit.quadric.centre)
    words = (
        f"{fit.quadric.kind}, semi-axes {_list(lengths)}, centre {_list(centre)} "
        f"{read.unit}; rectangles off by {before:.1e} of the squared size before; vertices moved "
        f"by at most {fit.deviation:.3g} {read.unit}"
    )
    return values.write(options, mesh, read.unit, words, read.origin)


def _list(numbers: np.ndarray) -> str:
    return ", ".join(f"{number:.6g}" for number in numbers)
