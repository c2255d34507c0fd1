"""Quadrics by their curvature lines, from confocal systems: exact multi-nets."""

from __future__ import annotations

import numpy as np

from solver.errors import InputError
from solver.mesh.grid import grid_mesh
from solver.mesh.primitives.limits import between
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.multinet.elliptic import elliptic_net, refuse_unsorted


def ellipsoid(
    m: int,
    n: int,
    *,
    semi_axes: tuple[float, float, float] = (3.0, 2.0, 1.2),
    clear: float = 0.08,
) -> QuadMesh:
    """Curvature lines of an ellipsoid around its longest axis, closed in u.

    Diagonals are exactly equal in all rectangles (Ivory); faces are planar to second order. The
    curvature lines end at the four umbilics, so the net stops short of the arcs between them.

    Args:
        m: vertices around.
        n: vertices along.
        semi_axes: three different lengths, largest first.
        clear: part of the range of v that is left free at both ends.

    Raises:
        InputError: semi-axes that are not three different decreasing lengths, or a clearance
            outside 0 to 0.5.
    """
    refuse_unsorted(semi_axes)
    first, second, third = semi_axes
    between(0.0, 0.5, clear=clear)
    axes = first**2, second**2, third**2
    # Lines of constant nu run around x, through all four quarters of mu.
    lines = []
    for place in np.linspace(clear - 1, 1 - clear, n):

        def ring(s: FloatArray, place: float = place) -> tuple[FloatArray, FloatArray]:
            return -4 * s, np.full_like(s, place)

        net = elliptic_net(axes, "lambda", ring, unfolded=True, closed=True)
        lines.append(net.points(np.arange(m) / m, np.zeros(1))[:, 0])
    return grid_mesh(np.stack(lines, axis=1), closed_u=True)


def elliptic_paraboloid(
    m: int,
    n: int,
    *,
    first: float = 2.0,
    second: float = 1.0,
    reach: float = 2.0,
    clear: float = 0.02,
) -> QuadMesh:
    """Curvature lines of z = x^2 / (2 first) + y^2 / (2 second) over the quarter x, y > 0.

    Paraboloidal coordinates -first < mu < -second and nu < -first:
    ``x^2 = first (first + mu)(first + nu) / (second - first)`` and so on, z = -(first + second + mu
    + nu) / 2. Diagonals are exactly equal in all rectangles (Ivory's theorem holds for confocal
    paraboloids); faces are planar to second order. Mirror it for the whole bowl.

    Args:
        m: vertices along the lines around the axis.
        n: vertices along the lines that rise.
        first: larger radius of curvature at the vertex.
        second: smaller one.
        reach: how far the net rises, as the length of the parameter nu / first.
        clear: part of the range of mu left free at its ends, where lines meet the umbilic.

    Raises:
        InputError: unless first > second > 0, reach > 0 and 0 <= clear < 0.5.
    """
    if not first > second > 0 or not reach > 0 or not 0 <= clear < 0.5:
        raise InputError(
            "elliptic_paraboloid: expected first > second > 0, reach > 0 and 0 <= clear < 0.5, "
            f"got {first:g}, {second:g}, {reach:g}, {clear:g}"
        )
    place = np.linspace(clear, 1 - clear, m)
    mu = -first + (first - second) * np.sin(0.5 * np.pi * place)[:, None] ** 2
    nu = -first - reach * first * np.linspace(clear, 1.0, n)[None, :] ** 2
    x = np.sqrt(first * (first + mu) * (first + nu) / (second - first))
    y = np.sqrt(second * (second + mu) * (second + nu) / (first - second))
    z = -0.5 * (first + second + mu + nu)
    return grid_mesh(np.stack([x, y, z], axis=2))
