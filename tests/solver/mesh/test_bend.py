"""Sheets that are bent in one direction only."""

from __future__ import annotations

import numpy as np
import pytest

from solver import QuadMesh, optimise
from solver.mesh.bend import central_directions, doubly_curved, unbent
from solver.mesh.grid import grid_mesh
from tests.conftest import grid_faces


def paraboloid(along_x: float, along_y: float, side: int = 9) -> QuadMesh:
    """The graph of (along_x x^2 + along_y y^2) / 2 over a square."""
    x, y = np.meshgrid(*[np.linspace(-1, 1, side)] * 2, indexing="ij")
    z = 0.5 * (along_x * x**2 + along_y * y**2)
    return QuadMesh(np.stack([x, y, z], axis=2).reshape(-1, 3), grid_faces(side, side))


def ring() -> QuadMesh:
    """A short tube: the plane that fits it best is square to its axis."""
    angle = np.linspace(0, 2 * np.pi, 8, endpoint=False)[::-1]
    height, angle = np.meshgrid(np.linspace(0, 0.5, 4), angle, indexing="ij")
    points = np.stack([4 * np.cos(angle), 4 * np.sin(angle), height], axis=2)
    return grid_mesh(points, False, True)


def test_curvature_in_one_direction_is_taken_out():
    dome = paraboloid(0.4, 0.2)
    heights = unbent(dome, np.array([3.0, 0.0, 0.0])).vertices[:, 2]
    left = heights - 0.1 * dome.vertices[:, 1] ** 2
    assert np.ptp(left) <= 1e-14


@pytest.mark.parametrize(
    ("curvatures", "doubly"), [((0.4, 0.2), True), ((0.4, -0.2), True), ((0.4, 0.1), False)]
)
def test_sheets_bent_both_ways_are_told(curvatures, doubly):
    assert doubly_curved(paraboloid(*curvatures)) is doubly


def test_central_directions_lie_in_the_sheet():
    diagonal, medial = central_directions(paraboloid(0.2, 0.1, 10))
    assert np.abs(diagonal) == pytest.approx([0.5**0.5, 0.5**0.5, 0.0], abs=1e-12)
    assert np.abs(medial) == pytest.approx([1.0, 0.0, 0.0], abs=1e-12)


def test_directions_upright_on_the_best_plane_are_left_out():
    mesh = ring()
    (direction,) = central_directions(mesh)
    assert np.isfinite(unbent(mesh, direction).vertices).all()


def test_a_short_tube_is_optimised():
    assert optimise(ring(), "geodesic").report.status == "converged"
