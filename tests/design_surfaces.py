"""Surfaces by formula, as triangles: what nets are aligned on in tests and tables."""

import numpy as np
from scipy.spatial import Delaunay

from solver import Constraints, optimise
from solver.align.align import aligned
from solver.align.reach import reaching
from solver.analysis.form import form_of
from solver.mesh.closest import TriangleSurface
from solver.mesh.primitives import primitive


def triangles(formula, nu=61, nv=37):
    """Points (V, 3) and triangles (T, 3) of a formula on the unit square."""
    u, v = np.meshgrid(np.linspace(0, 1, nu), np.linspace(0, 1, nv), indexing="ij")
    points = np.stack(np.broadcast_arrays(*formula(u, v)), axis=-1).reshape(-1, 3)
    k = np.arange(nu * nv).reshape(nu, nv)
    quads = np.stack([k[:-1, :-1], k[1:, :-1], k[1:, 1:], k[:-1, 1:]], axis=-1).reshape(-1, 4)
    return points, np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def barrel(u, v):
    """Curved in both directions, more in one; its parameters are no lines of curvature."""
    w = v - 0.5
    height = 5 * np.cos(np.pi * w) * (1 + 0.4 * np.sin(2 * u))
    return 30 * u + 4 * w, 18 * w * (1 + 0.25 * u), height


def saddle(u, v):
    """Bent both ways everywhere."""
    u, v = u - 0.5, v - 0.5
    return 30 * u + 3 * v, 20 * v - 4 * u, 12 * u**2 - 20 * v**2 + 2 * u * v


def saddle_face(cadquery):
    """The saddle as a face of a CAD model, in mm."""
    u, v = np.meshgrid(np.linspace(0, 1, 21), np.linspace(0, 1, 15), indexing="ij")
    rows = 1000 * np.stack(saddle(u, v), axis=-1)
    points = [[cadquery.Vector(*place) for place in row] for row in rows.tolist()]
    return cadquery.Face.makeSplineApprox(points, tol=0.01)


def dome(u, v):
    """A dome over a rectangle, with umbilics."""
    u, v = u - 0.5, v - 0.5
    return 30 * u, 20 * v, 6 * np.cos(0.9 * np.pi * u) * np.cos(0.9 * np.pi * v)


def catenoid(u, v):
    """A minimal surface along its lines of curvature."""
    height, angle = 6 * (u - 0.5), 1.2 * np.pi * v
    radius = 5 * np.cosh(height / 5)
    return radius * np.cos(angle), radius * np.sin(angle), height


def hall(u, v):
    """Three vaults beside each other, with creases between them where v is a third or two."""
    across = np.where((v > 0) & (3 * v % 1 == 0), 1.0, 3 * v % 1)
    return 30 * u, 24 * v, 3 * np.sin(np.pi * across) * (1 - 0.4 * u) + 1.5 * u**2


def plane(u, v):
    """Flat."""
    return 12 * u, 8 * v, 0 * u


def cap(u, v):
    """A part of a sphere of radius 10."""
    x, y = 8 * (u - 0.5), 8 * (v - 0.5)
    return x, y, np.sqrt(100 - x**2 - y**2)


def without(points, faces, inside):
    """The triangles whose centres are not in a region, with the points that they use."""
    kept = faces[~inside(points[faces].mean(axis=1))]
    used, numbers = np.unique(kept, return_inverse=True)
    return points[used], numbers.reshape(-1, 3)


def random_surface(seed, noisy=True):
    """A roof of waves and bumps over a rectangle, of irregular triangles.

    Four in ten have an opening, four in ten noise of a thousandth of the size in every coordinate,
    unless it is left out. Slivers are left out, which leaves notches and slits.

    Returns:
        Points (V, 3), 20 to 45 m by 15 to 30, and triangles (T, 3), 0.2 to 0.5 m wide.
    """
    dice = np.random.default_rng(seed)
    size = np.array([dice.uniform(20, 45), dice.uniform(15, 30)])
    places, corners = _irregular(dice, size, dice.uniform(0.2, 0.5))
    x, y = places.T
    z = np.zeros(len(x))
    for _ in range(dice.integers(1, 4)):
        turn, length = dice.uniform(0, np.pi), dice.uniform(0.7, 2.5) * size[0]
        rise, shift = dice.uniform(0.5, 2.5), dice.uniform(0, 6)
        z += rise * np.sin(2 * np.pi * (x * np.cos(turn) + y * np.sin(turn)) / length + shift)
    for _ in range(dice.integers(0, 3)):
        middle, width = dice.uniform(0.2, 0.8, 2) * size, dice.uniform(5, 10)
        z += dice.uniform(-3, 3) * np.exp(-((places - middle) ** 2).sum(axis=1) / width**2)
    if dice.random() < 0.4:
        middle, radius = dice.uniform(0.3, 0.7, 2) * size, dice.uniform(2, 4)
        apart = np.linalg.norm(places[corners].mean(axis=1) - middle, axis=1)
        corners = corners[apart > radius]
    points = np.column_stack([x, y, z])
    if dice.random() < 0.4:
        noise = 1e-3 * np.linalg.norm(np.ptp(points, axis=0)) if noisy else 0.0
        points += dice.normal(size=points.shape) * noise
    one, two = (places[corners[:, k]] - places[corners[:, 0]] for k in (1, 2))
    corners = corners[np.abs(one[:, 0] * two[:, 1] - one[:, 1] * two[:, 0]) > 1e-4]
    used, numbers = np.unique(corners, return_inverse=True)
    return points[used], numbers.reshape(-1, 3)


def _irregular(dice, size, step):
    """Points of a rectangle and triangles of them, as even as two rounds of averages make them."""
    inner = dice.uniform(0, 1, (int(size.prod() / step**2), 2)) * size
    counts = (size / step).astype(int)
    x, y = (np.linspace(0, size[k], counts[k]) for k in (0, 1))
    rim = [np.column_stack(np.broadcast_arrays(x, side)) for side in (0.0, size[1])]
    rim += [np.column_stack(np.broadcast_arrays(side, y)) for side in (0.0, size[0])]
    places = np.unique(np.concatenate([inner, *rim]).round(6), axis=0)
    free = ((places > 1e-6) & (places < size - 1e-6)).all(axis=1)
    for _ in range(2):
        corners = Delaunay(places).simplices
        sums, counts = np.zeros_like(places), np.zeros(len(places))
        for k in range(3):
            for other in (k + 1, k + 2):
                np.add.at(sums, corners[:, k], places[corners[:, other % 3]])
                np.add.at(counts, corners[:, k], 1)
        places = np.where(free[:, None], sums / counts[:, None], places)
    return places, Delaunay(places).simplices


# Roofs of flat faces: corners and triangles, m; the second has two wings and a valley.
HIP = (
    [(0, 0, 0), (24, 0, 0), (24, 12, 0), (0, 12, 0), (6, 6, 3.5), (18, 6, 3.5)],
    [(0, 1, 5), (0, 5, 4), (1, 2, 5), (2, 3, 4), (2, 4, 5), (3, 0, 4)],
)
BENT = (
    [(0, 0, 0), (20, 0, 0), (20, 8, 0), (8, 8, 0), (8, 20, 0), (0, 20, 0)]
    + [(4, 4, 2.5), (20, 4, 2.5), (4, 20, 2.5)],
    [(0, 1, 7), (0, 7, 6), (2, 3, 6), (2, 6, 7), (3, 4, 8), (3, 8, 6), (5, 0, 6), (5, 6, 8)],
)
GABLE = (
    [(0, 0, 0), (20, 0, 0), (20, 10, 0), (0, 10, 0), (0, 5, 3), (20, 5, 3)],
    [(0, 1, 5), (0, 5, 4), (2, 3, 4), (2, 4, 5)],
)
# A lower wing that runs into a slope, in which there is a window besides.
WING = (
    [(0, 0, 0), (8, 0, 0), (16, 0, 0), (24, 0, 0), (24, 5, 3), (24, 10, 0), (0, 10, 0), (0, 5, 3)]
    + [(12, 4, 2.4), (8, -8, 0), (16, -8, 0), (12, -8, 2.4)]
    + [(3, 1, 0.6), (5, 1, 0.6), (5, 3, 1.8), (3, 3, 1.8)],
    [(0, 1, 13), (0, 13, 12), (1, 8, 14), (1, 14, 13), (8, 7, 15), (8, 15, 14), (7, 0, 12)]
    + [(7, 12, 15), (2, 3, 4), (2, 4, 8), (7, 8, 4), (4, 5, 6), (4, 6, 7), (1, 9, 11)]
    + [(1, 11, 8), (10, 2, 8), (10, 8, 11)],
)


def sheet(roof):
    """Points (V, 3) and triangles (T, 3) of such a roof."""
    return np.array(roof[0], dtype=float), np.array(roof[1])


def groined(n=41, half=6.0, radius=7.5):
    """Two barrels over a square, the higher one everywhere, diagonals along their groins."""
    x, y = (c.ravel() for c in np.meshgrid(*2 * [np.linspace(-half, half, n)], indexing="ij"))
    points = np.column_stack([x, y, np.sqrt(radius**2 - np.minimum(x**2, y**2))])
    k = np.arange(n * n).reshape(n, n)
    a, b, c, d = (q.ravel() for q in (k[:-1, :-1], k[1:, :-1], k[1:, 1:], k[:-1, 1:]))
    up = points[[a, b, c, d], 0].mean(axis=0) * points[[a, b, c, d], 1].mean(axis=0) > 0
    one = np.where(up[:, None], np.stack([a, b, c], 1), np.stack([a, b, d], 1))
    two = np.where(up[:, None], np.stack([a, c, d], 1), np.stack([b, c, d], 1))
    return points, np.concatenate([one, two])


# Surfaces that carry exact nets: primitive, its parameters, lines on it, net, faces.
EXACT = {
    "Enneper": ("enneper", {"lines": "principal"}, "asymptotic", "asymptotic", 400),
    "Scherk": ("scherk", {"lines": "principal"}, "asymptotic", "asymptotic", 300),
    "catenoid": ("catenoid", {"angles": (0, 200)}, "asymptotic", "asymptotic", 600),
    "helicoid": ("helicoid", {"lines": "principal"}, "asymptotic", "asymptotic", 600),
    "unduloid": ("unduloid", {}, "cmc", "cmc", 1200),
    "cone": ("cone", {"angles": (0, 200)}, "developable", "principal", 600),
    "tangent developable": ("tangent-developable", {}, "developable", "principal", 600),
}


def exact_patch(name, nu=81, nv=61, whole=False):
    """Points (V, 3) and triangles (T, 3) of one of ``EXACT``, without seams unless it is whole."""
    kind, parameters, *_ = EXACT[name]
    mesh = primitive(kind, nu, nv, **parameters)
    points, quads = mesh.vertices, mesh.faces
    faces = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    # A surface of revolution is halved.
    round_ = kind == "unduloid" and not whole
    return without(points, faces, lambda at: at[:, 1] < 0) if round_ else (points, faces)


def net_on_patch(name):
    """Align a net on one of ``EXACT`` and optimise it near to it.

    Returns:
        The aligned net, what became of it, and its form against a finer surface.
    """
    _, _, lines, net, count = EXACT[name]
    points, faces = exact_patch(name)
    one, two = (points[faces[:, k]] - points[faces[:, 0]] for k in (1, 2))
    area = np.linalg.norm(np.cross(one, two), axis=1).sum() / 2
    made = aligned(points, faces, net=lines, edge=float(np.sqrt(area / count)))
    outcome = optimise(made.mesh, net, constraints=Constraints(close_to=(points, faces)))
    surface = TriangleSurface(*reaching(made.mesh, *exact_patch(name, 161, 121, whole=True)))
    return made, outcome, form_of(made.mesh, outcome.mesh, surface)
