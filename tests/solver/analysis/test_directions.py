"""How lines lie to the directions of curvature, on surfaces where the answer is a formula."""

from __future__ import annotations

import numpy as np
import pytest

from solver.analysis.directions import asymptotic_share, directions
from solver.mesh.mirror import swapped
from tests.conftest import demo_roof, surface_of_revolution
from tests.meshes import grid, noisy, parameters, scherk, unduloid


def saddle(turned: float = 0.0, rows: int = 13, columns: int = 13, height: float = 1.08):
    """z = c x y over a square, its lines turned by so many degrees from the asymptotic ones."""
    x, y = parameters(rows, columns, 12.0, 12.0 * (columns - 1) / (rows - 1))
    a, b = np.cos(np.radians(turned)), np.sin(np.radians(turned))
    return grid(a * x - b * y, b * x + a * y, height / 36 * (a * x - b * y) * (b * x + a * y))


@pytest.mark.parametrize("turned", [0.0, 10.0, 30.0, 45.0])
def test_lines_turned_on_a_saddle(turned):
    """L = -N = 2 c sin t cos t and M = c cos 2t, so the twist is cos^2 2t."""
    found = directions(saddle(turned, height=0.3))
    assert np.isclose(found.twist, np.cos(np.radians(2 * turned)) ** 2, atol=2e-3)
    assert np.isclose(found.angle, 45 - turned, atol=0.5)


@pytest.mark.parametrize(("turned", "share"), [(0.0, 1.0), (15.0, 1.0), (21.0, 0.0), (45.0, 0.0)])
def test_lines_are_nearly_asymptotic_where_two_thirds_of_the_bending_is_twist(turned, share):
    """cos^2 2t = 2/3 at 17.6 degrees."""
    assert asymptotic_share(saddle(turned, height=0.3)) == pytest.approx(share)


def test_diagonals_lie_half_a_right_angle_further():
    for mesh in (saddle(0.0), unduloid(), scherk()):
        lines, diagonals = directions(mesh), directions(mesh, diagonal=True)
        assert lines.angle == pytest.approx(45, abs=0.1)
        assert diagonals.angle == pytest.approx(0, abs=1.0)
        assert diagonals.twist < 1e-3 < lines.twist


def test_lines_of_curvature_have_no_twist():
    for mesh in (surface_of_revolution(), surface_of_revolution(13, 9)):
        assert directions(mesh).twist < 1e-12
        assert directions(mesh).angle < 0.01


def test_neither_unit_nor_place_nor_noise_matters_much():
    mesh = demo_roof()
    found = directions(mesh)
    turn = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))[0]
    turn[:, 0] *= np.sign(np.linalg.det(turn))
    moved = mesh.with_vertices((mesh.vertices @ turn.T + [10.0, -7.0, 3.0]) * 1e-3)
    assert np.isclose(directions(moved).twist, found.twist, rtol=1e-6)
    assert np.isclose(directions(moved).angle, found.angle, rtol=1e-6)
    assert directions(noisy(scherk(), 0.05)).twist > 0.75


@pytest.mark.parametrize("diagonal", [False, True])
def test_it_does_not_matter_which_family_is_named_first(diagonal):
    for mesh in (noisy(scherk(), 0.3), noisy(demo_roof(), 0.3)):
        one, other = directions(mesh, diagonal), directions(swapped(mesh), diagonal)
        assert one.twist == pytest.approx(other.twist, rel=1e-9)
        assert one.angle == pytest.approx(other.angle, rel=1e-9)


def test_a_plane_has_no_directions():
    x, y = parameters(6, 5, 5.0, 4.0)
    for heights in (np.zeros((6, 5)), 1e-9 * x * y):
        found = directions(grid(x + 0.3 * y, y, heights))
        assert (found.twist, found.angle) == (0.0, 0.0)


def test_a_mesh_without_stars_has_none_either():
    assert directions(grid(*parameters(2, 5, 1.0, 4.0), np.zeros((2, 5)))).twist == 0.0
