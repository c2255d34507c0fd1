"""Multi-nets as sources: from a polyline on a quadric, and in elliptic coordinates."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, TypedDict

import numpy as np
from numpy.typing import ArrayLike

from freecad_ortho.sources.placing import PLACEMENT, Placing, placed
from freecad_ortho.sources.primitives import roots, sampling
from freecad_ortho.sources.source import Made, Source
from solver.mesh.quadmesh import FloatArray
from solver.multinet import MultiNet, Quadric, elliptic_net, multi_net, reflected
from solver.multinet.elliptic import COORDINATES, EllipticSystem, refuse_unsorted
from solver.multinet.formula import formula
from solver.multinet.net import SPACING
from solver.multinet.polyline import Spline
from solver.multinet.presets import PRESETS, preset
from solver.multinet.quadric import SEMI_AXES
from solver.option import Former, Option
from solver.sentence import Measured, Sentence

if TYPE_CHECKING:
    # Of the standard library from Python 3.11 on.
    from typing_extensions import Unpack

QUADRICS = {
    "ellipsoid": (1.0, 1.0, 1.0),
    "one-sheeted hyperboloid": (1.0, 1.0, -1.0),
    "two-sheeted hyperboloid": (1.0, -1.0, -1.0),
}
_FORMULAS = "formulas"
_QUADRIC = Option(
    "quadric", "ellipsoid", "choice", "The polyline lies on this quadric", tuple(QUADRICS),
    written="ellipsoid|one-sheeted|two-sheeted",
)  # fmt: skip
_T_RANGE = Option(
    "t_range", (0.0, 0.0), "area",
    "The net goes from the first to the second t; with 0 and 0 it keeps clear of both ends",
    written="T0,T1", absent="automatic", former=Former("range"),
)  # fmt: skip
_REFLECT = Option(
    "reflect",
    "",
    "text",
    "The net goes on along these axes as its mirror image, as x,y",
    written="x,y,z",
)


def quadric_of(quadric: str, semi_axes: ArrayLike, placement: Placing) -> Quadric:
    """The quadric of a kind, semi-axes in mm, and where it stands.

    Raises:
        InputError: an unknown kind, or semi-axes that are not positive.
    """
    _QUADRIC.check(quadric)
    lengths = np.asarray(semi_axes, dtype=np.float64)
    SEMI_AXES.check(tuple(lengths.tolist()))
    return Quadric(np.array(QUADRICS[quadric]) / lengths**2, *placement)


def first_polyline(quadric: Quadric) -> FloatArray:
    """(4, 3) points of a first polyline on a quadric, in its own frame, clear of its planes."""
    a, b, c = 1.0 / np.sqrt(np.abs(quadric.curvatures))
    share = np.linspace(0.0, 1.0, 4)[:, None]
    start, end = np.array([1.0, -0.5, 0.15]), np.array([0.35, 0.9, 0.6])
    if (quadric.curvatures < 0).sum() == 2:
        start, end = np.array([1.3, -0.7, 0.2]), np.array([1.5, 0.6, 0.8])
    path = (1 - share) * start + share * end + [0, 0, 0.35] * np.sin(np.pi * share)
    return Quadric(quadric.curvatures).project(path * [a, b, c])


def drawn_net(
    quadric: str,
    semi_axes: ArrayLike,
    points: ArrayLike,
    closed: bool,
    placement: Placing,
) -> MultiNet:
    """The multi-net of points near a quadric, given in its own frame in mm.

    Raises:
        InputError: no quadric, or points that make no curve on it.
    """
    base = quadric_of(quadric, semi_axes, placement)
    local = np.asarray(points, dtype=np.float64).reshape(-1, 3)
    if not len(local):
        local = first_polyline(base)
    return multi_net(base, base.from_frame(local), closed=closed, snap=True)


def automatic_range(net: MultiNet) -> tuple[float, float]:
    """Ends of t clear of both flat ends: from half of the smallest to three times its size."""
    low, high = (end - net.base for end in net.admissible)
    return 0.6 * low + net.base, min(-1.5 * low, 0.6 * high) + net.base


def _finished(
    net: MultiNet, unit: str, sampling: tuple[int, int], t_range: tuple[float, float],
    spacing: str, reflect: str,
) -> Made:  # fmt: skip
    ends = (float(t_range[0]), float(t_range[1]))
    if ends == (0.0, 0.0):
        ends = net.t_range or automatic_range(net)
    mesh = net.sampled(*sampling, ends, spacing)
    if reflect.strip():
        mesh = reflected(mesh, reflect.replace(",", "").replace(" ", "").lower(), net.quadric)
    return Made(mesh, (_said_range(ends, net.admissible, unit),))


def _said_range(ends: tuple[float, float], admissible: tuple[float, float], unit: str) -> Sentence:
    """From where to where t goes, and where it could."""
    start, end, low, high = (Measured(t, 2, 4, unit) for t in (*ends, *admissible))
    if np.isfinite(admissible[1]):
        return Sentence("t from {} to {}, admissible from {} to {}", start, end, low, high)
    return Sentence("t from {} to {}, admissible from {} on", start, end, low)


def _drawn(
    unit: str, quadric: str, semi_axes: ArrayLike, points: FloatArray, closed: bool,
    placement: Placing, sampling: tuple[int, int], t_range: tuple[float, float], spacing: str,
    reflect: str,
) -> Made:  # fmt: skip
    net = drawn_net(quadric, semi_axes, points, closed, placement)
    return _finished(net, unit, sampling, t_range, spacing, reflect)


def _elliptic(
    unit: str, semi_axes: tuple[float, float, float], placement: Placing,
    sampling: tuple[int, int], t_range: tuple[float, float], spacing: str, reflect: str,
    **curve: Unpack[Curve],
) -> Made:  # fmt: skip
    refuse_unsorted(semi_axes)
    net = elliptic(tuple(float(length) ** 2 for length in semi_axes), **curve)
    made = _finished(net, unit, sampling, t_range, spacing, reflect)
    return Made(placed(made.mesh, placement), made.remarks)


class Curve(TypedDict):
    """What :func:`elliptic` makes a net of."""

    moving: str
    curve: str
    first_formula: str
    second_formula: str
    points: FloatArray
    coordinates: FloatArray
    closed: bool


def elliptic(
    squares: tuple[float, ...],
    moving: str,
    curve: str,
    first_formula: str,
    second_formula: str,
    points: FloatArray,
    coordinates: FloatArray,
    closed: bool,
) -> MultiNet:
    """The multi-net of a curve in elliptic coordinates.

    Args:
        squares: of the semi-axes.
        moving: the coordinate in the role of t.
        curve: name of a preset, or "formulas".
        first_formula: of s from 0 to 1, where formulas are asked for; the second likewise.
        second_formula: for the second of the coordinates that stay.
        points: (n, 3) points of a curve instead, of which these coordinates count.
        coordinates: (n, 3) values of these two coordinates instead; the third column is nothing.
        closed: a curve that is no preset returns to its start.

    Raises:
        InputError: semi-axes that do not fall, or no such curve.
    """
    if len(points):
        return _through(squares, moving, points, closed)
    if len(coordinates):
        spline = Spline(coordinates[:, :2], closed)
        return elliptic_net(squares, moving, lambda s: tuple(spline(s).T), closed=closed)
    if curve != _FORMULAS:
        chosen = preset(curve)
        return elliptic_net(squares, moving, chosen.curve, unfolded=True, closed=chosen.closed)
    names = dict(zip("abc", squares, strict=True))
    one, two = (formula(text, ("s", "a", "b", "c")) for text in (first_formula, second_formula))
    return elliptic_net(
        squares, moving, lambda s: (one(s=s, **names), two(s=s, **names)), closed=closed
    )


def _through(squares: tuple[float, ...], moving: str, points: FloatArray, closed: bool) -> MultiNet:
    """The net of points that count by their two other coordinates and their signs."""
    system = EllipticSystem(*squares)
    net = elliptic_net(squares, moving, lambda s: (s, s), closed=closed)
    found = system.coordinates(points)
    found[:, COORDINATES.index(moving)] = net.base
    base = system.points(found, np.where(points < 0, -1.0, 1.0))
    through = multi_net(net.quadric, base, closed=closed)
    return MultiNet(net.quadric, through.curve, net.base, closed, net.t_range)


MULTI_NET = Source(
    "multi-net",
    "Orthogonal multi-net of a polyline drawn on a quadric",
    (
        _QUADRIC,
        replace(SEMI_AXES, former=Former("axes", roots)),
        sampling(24, 12),
        _T_RANGE,
        SPACING,
        Option("closed", False, "flag", "The last point is joined with the first",
               brief="join the ends of a given curve"),
        _REFLECT,
        Option("points", (), "points",
               "The polyline goes through these points, in the frame of the quadric",
               brief="points of the curve, in the frame of the quadric"),
        PLACEMENT,
    ),
    _drawn,
)  # fmt: skip

ELLIPTIC_NET = Source(
    "elliptic multi-net",
    "Orthogonal multi-net in elliptic coordinates",
    (
        replace(SEMI_AXES, former=Former("axes", roots),
                meaning="The semi-axes of lambda = 0 are this long, the largest comes first"),
        Option("moving", "lambda", "choice", "This elliptic coordinate has the role of t",
               ("lambda", "mu", "nu")),
        Option("curve", "wave", "choice", "The two other coordinates follow this curve",
               (*PRESETS, _FORMULAS),
               brief="curve of the two other coordinates; also a file of points or coordinates, "
               "or 'FORMULA; FORMULA'"),
        Option("first_formula", "-0.5*(b + c)", "text",
               "The first of them follows this formula of s",
               written="FORMULA"),
        Option("second_formula", "-b - (a - b)*s", "text",
               "The second of them follows this formula of s",
               written="FORMULA"),
        Option("points", (), "points",
               "The curve goes through these points instead, about the centre"),
        Option("coordinates", (), "points", "The two other coordinates have these values instead"),
        Option("closed", False, "flag", "The ends of a curve that is no preset are joined"),
        sampling(24, 12),
        _T_RANGE,
        SPACING,
        _REFLECT,
        PLACEMENT,
    ),
    _elliptic,
)  # fmt: skip
