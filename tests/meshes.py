"""Start meshes by formula: known smooth nets, and the same with noise; all seeded."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.special import ellipeinc, ellipj

from solver import QuadMesh
from tests.conftest import grid_faces

FloatArray = NDArray[np.float64]

# Mean curvature of the unduloid, and its narrowest and widest radius: they sum to 1 / H.
UNDULOID_CURVATURE = 1.0
_NARROW, _WIDE = 0.3, 0.7


def right_angles(mesh: QuadMesh, diagonal: bool = False) -> FloatArray:
    """(n,) relative difference of the diagonals where a net asks for right angles.

    Of all faces that touch no inner irregular vertex, or of the quads of the four neighbours of
    regular inner vertices, none of which is an irregular inner vertex.
    """
    net = mesh.connectivity
    irregular = ~net.boundary_vertices & (net.edge_valence != 4)
    quads = net.stars[:, 1:] if diagonal else mesh.faces
    a, b, c, d = mesh.vertices[quads[~irregular[quads].any(axis=1)]].transpose(1, 0, 2)
    first, second = np.linalg.norm(c - a, axis=1), np.linalg.norm(d - b, axis=1)
    return np.asarray(np.abs(first - second) / (0.5 * (first + second)))


def noisy(mesh: QuadMesh, amount: float = 0.1, seed: int = 0) -> QuadMesh:
    """Every vertex moved by its own Gaussian vector of RMS length ``amount`` mean edges."""
    moves = np.random.default_rng(seed).normal(size=mesh.vertices.shape)
    return mesh.with_vertices(mesh.vertices + amount * mesh.mean_edge / np.sqrt(3) * moves)


def parameters(
    rows: int, columns: int, width: float, height: float
) -> tuple[FloatArray, FloatArray]:
    """Two (rows, columns) arrays over a rectangle around zero."""
    return np.meshgrid(
        np.linspace(-width / 2, width / 2, rows),
        np.linspace(-height / 2, height / 2, columns),
        indexing="ij",
    )


def grid(x: FloatArray, y: FloatArray, z: FloatArray) -> QuadMesh:
    """Mesh of three arrays of one (rows, columns) shape."""
    points = np.stack(np.broadcast_arrays(x, y, z), axis=-1)
    return QuadMesh(points.reshape(-1, 3), grid_faces(*points.shape[:2]))


def bent_sheet(
    rows: int = 16, columns: int = 13, size: float = 3.0, turned: float = 0.5
) -> QuadMesh:
    """A plane square grid bent over a catenary, its lines ``turned`` radians from the rulings.

    Smooth limit: orthogonal, geodesic and Chebyshev, K = 0.
    """
    s, t = parameters(rows, columns, size, size * (columns - 1) / (rows - 1))
    along = s * np.cos(turned) - t * np.sin(turned)
    across = s * np.sin(turned) + t * np.cos(turned)
    return grid(np.arcsinh(along), across, np.sqrt(1 + along**2))


def scherk(rows: int = 15, columns: int = 15, size: float = 2.0) -> QuadMesh:
    """Asymptotic lines of Scherk's minimal surface z = log(cos x / cos y)."""
    u, v = parameters(rows, columns, size, size)
    a, b = u + v, u - v
    return grid(
        2 * np.arctan(np.tanh(a / 2)),
        2 * np.arctan(np.tanh(b / 2)),
        np.log(np.cosh(b) / np.cosh(a)),
    )


def helicoid(rows: int = 17, columns: int = 13, turn: float = 2.0, reach: float = 1.5) -> QuadMesh:
    """Rulings and helices of a helicoid, its asymptotic lines, in a conformal sampling."""
    u, v = parameters(rows, columns, turn, reach)
    return grid(np.sinh(v) * np.cos(u), np.sinh(v) * np.sin(u), u)


def constant_ratio(
    rows: int = 15, columns: int = 15, ratio: float = 0.5, size: float = 1.6
) -> QuadMesh:
    """Asymptotic lines of the surface of revolution of which k1 = -ratio k2, k2 of the parallels.

    With the slope of the normal n, k2 = n / r and k1 = dn / dr, so that n = r^-ratio for a waist of
    one. In the conformal parameter u, r = cosh(ratio u)^(1 / ratio); the lines are those of
    turn +- sqrt(ratio) u, and meet at an angle g with tan(g / 2)^2 = ratio about the meridian.
    """
    p, q = parameters(rows, columns, size, size * (columns - 1) / (rows - 1))
    u, turn = p + q, np.sqrt(ratio) * (p - q)
    radius = np.cosh(ratio * u) ** (1 / ratio)
    heights = np.linspace(0.0, float(np.abs(u).max()), 20_001)
    slope = np.cosh(ratio * heights) ** (1 / ratio - 1)
    steps = 0.5 * (slope[1:] + slope[:-1]) * (heights[1] - heights[0])
    height = np.interp(np.abs(u), heights, np.append(0.0, np.cumsum(steps))) * np.sign(u)
    return grid(radius * np.cos(turn), radius * np.sin(turn), height)


def freeform_roof(rows: int = 26, columns: int = 22, size: float = 20.0) -> QuadMesh:
    """A dome over a rectangle with a slow wave in it, along no particular lines."""
    x, y = parameters(rows, columns, size, size * (columns - 1) / (rows - 1))
    return grid(x, y, 0.3 * np.sin(0.5 * x + 0.2 * y) - 0.02 * x**2 - 0.015 * y**2)


def freeform_saddle(rows: int = 20, columns: int = 18, size: float = 20.0) -> QuadMesh:
    """A hyperbolic paraboloid over a rectangle with a slow wave in it."""
    x, y = parameters(rows, columns, size, size * (columns - 1) / (rows - 1))
    return grid(x, y, 0.03 * x * y + 0.3 * np.sin(0.4 * x))


def small_circles(
    rows: int = 13, columns: int = 13, radius: float = 50.0, low: float = 15.0, high: float = 35.0
) -> QuadMesh:
    """Two families of equal small circles on the unit sphere: pseudo-geodesics of one tilt.

    A circle of angular ``radius`` degrees bends towards its centre, at 90 - radius degrees to the
    normal of the sphere. Those of centres on the equator at longitudes a and b meet where
    cos(latitude) = cos(radius) / cos(b - a over 2); that half difference runs from ``low`` to
    ``high``.
    """
    reach = np.radians(high - low)
    i, j = np.meshgrid(np.linspace(0, 1, rows), np.linspace(0, 1, columns), indexing="ij")
    a, b = i * reach, j * reach + np.radians(2 * low + (high - low))
    latitude = np.arccos(np.cos(np.radians(radius)) / np.cos((b - a) / 2))
    turn = (a + b) / 2
    return grid(np.cos(latitude) * np.cos(turn), np.cos(latitude) * np.sin(turn), np.sin(latitude))


def unduloid_points(along: FloatArray, turn: FloatArray) -> FloatArray:
    """(..., 3) points of an unduloid in conformal coordinates along its principal lines.

    The radius r follows r'^2 = H^2 (wide^2 - r^2) (r^2 - narrow^2), a Jacobi function dn.
    """
    curvature, modulus = UNDULOID_CURVATURE, 1 - (_NARROW / _WIDE) ** 2
    _, _, dn, amplitude = ellipj(curvature * _WIDE * along, modulus)
    constant = curvature * _NARROW * _WIDE
    height = _WIDE * ellipeinc(amplitude, modulus) + constant * along
    return np.stack([_WIDE * dn * np.cos(turn), _WIDE * dn * np.sin(turn), height], axis=-1)


def unduloid(rows: int = 15, columns: int = 15, size: float = 2.0) -> QuadMesh:
    """Lines at 45 degrees to the principal directions of an unduloid: a smooth CMC net.

    Both normal curvatures along them are H = 1: the star spheres have radius 1 in the limit.
    """
    u, v = parameters(rows, columns, size, size)
    points = unduloid_points((u + v) / np.sqrt(2), (u - v) / np.sqrt(2))
    return grid(*np.moveaxis(points, -1, 0))


def hanging_net(rows: int = 13, columns: int = 11, sag: float = 0.2) -> QuadMesh:
    """A level square net that sags like a parabola between its supported borders."""
    x, y = parameters(rows, columns, 2.0, 2.0 * (columns - 1) / (rows - 1))
    return grid(x, y, -sag * (1 - x**2) * (1 - (y / y.max()) ** 2))


START_MESHES = {
    "bent sheet": bent_sheet,
    "scherk": scherk,
    "helicoid": helicoid,
    "unduloid": unduloid,
}


def deformed(mesh: QuadMesh, amount: float = 0.03, seed: int = 0) -> QuadMesh:
    """The mesh after four slow waves in random directions, ``amount`` of its size.

    One smooth map of space, whatever the sampling: meshes of one surface stay so.
    """
    random = np.random.default_rng(seed)
    centre = mesh.vertices.mean(axis=0)
    size = np.linalg.norm(mesh.vertices - centre, axis=1).max()
    places, moves = (mesh.vertices - centre) / size, np.zeros_like(mesh.vertices)
    for _ in range(4):
        direction, wave = random.normal(size=(2, 3))
        moves += direction * np.sin(2 * places @ wave + random.uniform(0, 6))[:, None]
    return mesh.with_vertices(mesh.vertices + 0.5 * amount * size * moves)


def rhombic_dodecahedron() -> QuadMesh:
    """Closed, valences three and four, all edges at the same distance from the centre."""
    cube = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    tips = np.concatenate([2 * np.eye(3), -2 * np.eye(3)])
    points = np.concatenate([cube, tips]).astype(float)
    faces = []
    for first in range(6):
        for second in range(first + 1, 6):
            if tips[first] @ tips[second] == 0:
                shared = np.flatnonzero((cube @ tips[first] > 0) & (cube @ tips[second] > 0))
                face = [8 + first, shared[0], 8 + second, shared[1]]
                a, b, c, d = points[face]
                if np.cross(c - a, d - b) @ a < 0:
                    face.reverse()
                faces.append(face)
    return QuadMesh(points, faces)
