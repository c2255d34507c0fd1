"""Meshes by formula, in mm, and structures made of them once."""

import numpy as np
import pytest

from freecad_ortho.fabrication import Beams, Panels, build
from solver.mesh import grid
from solver.mesh.quadmesh import QuadMesh
from tests.meshes import rhombic_dodecahedron


def grid_faces(rows, columns):
    number = np.arange(rows * columns).reshape(rows, columns)
    corners = number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]
    return np.stack(corners, axis=-1).reshape(-1, 4)


@pytest.fixture(scope="session")
def roof():
    """Meridians and parallels of a wavy surface: planar faces, equal diagonals, normals outside.

    Has ridges and valleys; edges of about 1.2 m.
    """
    height, angle = np.meshgrid(np.linspace(0, 9, 7), np.linspace(0, 2.5, 10), indexing="ij")
    radius = 4.2 + 1.0 * np.sin(0.7 * height)
    points = np.stack([radius * np.cos(angle), radius * np.sin(angle), height], axis=-1)
    return QuadMesh(1000 * points.reshape(-1, 3), grid_faces(7, 10))


@pytest.fixture(scope="session")
def skewed(roof):
    """The roof sheared: still planar faces, no longer orthogonal."""
    shear = np.array([[1, 0.25, 0], [0, 1, 0.2], [0, 0, 1.1]])
    return roof.with_vertices(roof.vertices @ shear)


@pytest.fixture(scope="session")
def dodecahedron():
    """A closed polyhedron with vertices of valence three and four, edges of 1.7 m."""
    mesh = rhombic_dodecahedron()
    return mesh.with_vertices(1000 * mesh.vertices)


@pytest.fixture(scope="session")
def twisted():
    """Straight lines on a hyperbolic paraboloid: no face planar, beams must twist."""
    x, y = np.meshgrid(np.linspace(-1, 1, 6), np.linspace(-1, 1, 6), indexing="ij")
    points = np.stack([y, x, 0.3 * x * y], axis=-1)
    return QuadMesh(3000 * points.reshape(-1, 3), grid_faces(6, 6))


@pytest.fixture(scope="session")
def meshes(roof, skewed, dodecahedron, twisted):
    return {"roof": roof, "skewed": skewed, "dodecahedron": dodecahedron, "twisted": twisted}


@pytest.fixture(scope="session")
def structure(roof):
    """Beams and panels on the roof."""
    return build(roof, [Beams(200, 12), Panels(20, 15)])


@pytest.fixture(scope="session")
def plane():
    """Square faces of 1 m in a plane."""
    x, y = np.meshgrid(np.arange(5.0), np.arange(4.0), indexing="ij")
    points = 1000 * np.stack([x, y, 0 * x], axis=-1).reshape(-1, 3)
    return QuadMesh(points, grid.grid_faces(5, 4))


@pytest.fixture(scope="session")
def sheet():
    """A plane net of squares of 1 m, 7 by 8."""
    x, y = np.meshgrid(np.arange(8), np.arange(9))
    points = np.stack([x, y, 0 * x], axis=-1).reshape(-1, 3)
    return QuadMesh(1000.0 * points, grid_faces(9, 8))


def on_roof(roof, along, across):
    """A closed curve on the roof: rows and columns as fractions of its 6 by 9 faces."""
    angle = np.linspace(0, 2 * np.pi, 240, endpoint=False)
    row = 3 + along * np.sin(angle)
    column = 4.5 + across * np.cos(angle)
    points = roof.vertices.reshape(7, 10, 3)
    i, j = row.astype(int), column.astype(int)
    s, t = (row - i)[:, None], (column - j)[:, None]
    return (
        (1 - s) * (1 - t) * points[i, j]
        + s * (1 - t) * points[i + 1, j]
        + s * t * points[i + 1, j + 1]
        + (1 - s) * t * points[i, j + 1]
    )


@pytest.fixture(scope="session")
def border(roof):
    """An outer border on the roof and an opening in it."""
    return [on_roof(roof, 2.6, 4.1), on_roof(roof, 0.8, 1.3)]
