"""The command ``multinet``: an exact orthogonal multi-net from a few numbers and a curve."""

from __future__ import annotations

import argparse

import numpy as np
from scipy.spatial.transform import Rotation

from freecad_ortho.cli import values
from solver.errors import InputError
from solver.io.points import read_points
from solver.mesh.quadmesh import FloatArray
from solver.multinet import MultiNet, Quadric, elliptic_net, multi_net, reflected
from solver.multinet.elliptic import COORDINATES, EllipticSystem
from solver.multinet.formula import formula
from solver.multinet.polyline import Spline
from solver.multinet.presets import PRESETS

_SIGNS = {
    "ellipsoid": (1, 1, 1),
    "one-sheeted": (1, 1, -1),
    "two-sheeted": (1, -1, -1),
}


def add(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.description = (
        "Orthogonal multi-net: equal diagonals in every rectangle of parameter lines. "
        "Vertex (i, j), i along the curve, j along t, is number i*N + j."
    )
    parser.add_argument(
        "--axes",
        required=True,
        metavar="A,B,C",
        help="squares of the semi-axes: a, b, c of x^2/a + y^2/b + z^2/c = 1, a > b > c",
    )
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--moving", metavar="lambda|mu|nu", help="elliptic coordinate that is t")
    what.add_argument(
        "--quadric",
        metavar="|".join(_SIGNS),
        help="quadric of the curve, t = 0 on it; the curve is then a file of points",
    )
    parser.add_argument(
        "--curve",
        default="wave",
        metavar="PRESET|FILE|'FORMULA; FORMULA'",
        help=f"{', '.join(PRESETS)} (default: wave); a file with x,y,z or with values of the two "
        "other coordinates in each line; or two formulas of s from 0 to 1 for these values",
    )
    parser.add_argument("--closed", action="store_true", help="join the ends of a given curve")
    parser.add_argument("--snap", action="store_true", help="move points onto the quadric first")
    parser.add_argument("--range", metavar="T0,T1", help="first and last t")
    parser.add_argument("--sampling", required=True, metavar="MxN", help="M along the curve")
    parser.add_argument("--spacing", default="length", metavar="length|parameter")
    parser.add_argument("--reflect", metavar="x,y,z", help="extend by mirror images, seams merged")
    parser.add_argument("--rotate", metavar="X,Y,Z", help="degrees about x, then y, then z")
    parser.add_argument("--centre", metavar="X,Y,Z", help="centre of the quadric")
    values.add_output(parser)
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Build the net and write it."""
    values.refuse_unwritable(options.output)
    m, n = values.sampling(options.sampling)
    t_range = values.numbers("--range", options.range, 2) if options.range else None
    net = _elliptic(options) if options.moving else _on_quadric(options)
    if t_range is None and net.t_range is None:
        low, high = net.admissible
        raise InputError(f"--range: expected T0,T1 within {low:.6g} to {high:.6g}; add it")
    ends = (t_range[0], t_range[1]) if t_range else None
    mesh = net.sampled(m, n, ends, options.spacing)
    if options.reflect:
        mesh = reflected(mesh, options.reflect.replace(",", ""), net.quadric)
    low, high = net.admissible
    words = f"admissible t from {low:.6g} to {high:.6g}"
    return values.write(options, mesh, options.unit, words)


def _placed(quadric: Quadric, options: argparse.Namespace) -> Quadric:
    angles = values.numbers("--rotate", options.rotate, 3) if options.rotate else (0.0, 0.0, 0.0)
    centre = values.numbers("--centre", options.centre, 3) if options.centre else (0.0, 0.0, 0.0)
    turn = Rotation.from_euler("xyz", angles, degrees=True).as_matrix()
    return Quadric(quadric.curvatures, turn @ quadric.rotation, np.array(centre))


def _elliptic(options: argparse.Namespace) -> MultiNet:
    axes = values.numbers("--axes", options.axes, 3)
    if options.moving not in COORDINATES:
        raise InputError(f"--moving: expected lambda, mu or nu, got '{options.moving}'")
    if options.curve in PRESETS:
        chosen = PRESETS[options.curve]
        net = elliptic_net(axes, options.moving, chosen.curve, unfolded=True, closed=chosen.closed)
    elif ";" in options.curve:
        net = _formulas(axes, options)
    else:
        net = _file(axes, options)
    if not (options.rotate or options.centre):
        return net
    here, there = net.quadric, _placed(net.quadric, options)

    def moved(s: FloatArray) -> FloatArray:
        return there.from_frame(here.to_frame(net.curve(s)))

    return MultiNet(there, moved, net.base, net.closed, net.t_range)


def _formulas(axes: tuple[float, ...], options: argparse.Namespace) -> MultiNet:
    texts = options.curve.split(";")
    if len(texts) != 2:
        raise InputError(f"--curve: expected two formulas separated by ';', got {len(texts)}")
    one, two = (formula(text, ("s", "a", "b", "c")) for text in texts)
    a, b, c = axes

    def curve(s: FloatArray) -> tuple[FloatArray, FloatArray]:
        return one(s=s, a=a, b=b, c=c), two(s=s, a=a, b=b, c=c)

    return elliptic_net(axes, options.moving, curve, closed=options.closed)


def _file(axes: tuple[float, ...], options: argparse.Namespace) -> MultiNet:
    """Curve through the points or the coordinate values of a file."""
    try:
        rows = read_points(options.curve, (2, 3))
    except InputError as error:
        if "no such file" in str(error):
            raise InputError(
                f"--curve: '{options.curve}' is neither a file nor one of {', '.join(PRESETS)}"
            ) from None
        raise
    if rows.shape[1] == 2:
        spline = Spline(rows, options.closed)

        def curve(s: FloatArray) -> tuple[FloatArray, FloatArray]:
            pairs = spline(s)
            return pairs[:, 0], pairs[:, 1]

        return elliptic_net(axes, options.moving, curve, closed=options.closed)
    system = EllipticSystem(*axes)
    found = system.coordinates(rows)
    moving = COORDINATES.index(options.moving)
    net = elliptic_net(axes, options.moving, lambda s: (s, s), closed=options.closed)
    # The points count by their two other coordinates and signs, wherever on the third they lie.
    found[:, moving] = net.base
    signs = np.where(rows < 0, -1.0, 1.0)
    base = system.points(found, signs)
    through = multi_net(net.quadric, base, closed=options.closed)
    return MultiNet(net.quadric, through.curve, net.base, options.closed, net.t_range)


def _on_quadric(options: argparse.Namespace) -> MultiNet:
    if options.quadric not in _SIGNS:
        raise InputError(f"--quadric: expected one of {', '.join(_SIGNS)}, got '{options.quadric}'")
    squares = np.array(values.numbers("--axes", options.axes, 3))
    if not (squares > 0).all():
        raise InputError(f"--axes: expected three positive numbers, got {options.axes}")
    quadric = _placed(Quadric(np.array(_SIGNS[options.quadric]) / squares), options)
    if options.curve in PRESETS:
        raise InputError("--curve: expected a file of points on the quadric; presets need --moving")
    points = read_points(options.curve)
    return multi_net(quadric, points, closed=options.closed, snap=options.snap)
