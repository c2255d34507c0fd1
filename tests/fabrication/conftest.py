"""Meshes by formula, in mm, and structures made of them once."""

import numpy as np
import pytest

from freecad_ortho.fabrication import Beams, Panels, build
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
