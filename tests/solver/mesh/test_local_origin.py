"""A round point near far meshes: exact to take off and to put back, nothing near the origin."""

from __future__ import annotations

import numpy as np
import pytest

from solver.mesh.local_origin import LocalOrigin
from tests.conftest import wavy_grid


@pytest.mark.parametrize("scale", [1e-3, 1.0, 304.8])
@pytest.mark.parametrize("offset", [(0, 0, 0), (5e3, -4e3, 3e3), (0, 0, 9e3)])
def test_a_mesh_up_to_a_thousand_sizes_away_is_left_alone(scale, offset):
    mesh = wavy_grid(9, 8).with_vertices(scale * (wavy_grid(9, 8).vertices + offset))
    origin = LocalOrigin.of_mesh(mesh)
    assert not origin.far
    assert origin.near_mesh(mesh) is mesh and origin.back_mesh(mesh) is mesh


@pytest.mark.parametrize("offset", [(500123.25, 5412345.5, 412.0), (-1e7, 1e7, 0.1), (0, 0, 3e9)])
def test_there_and_back_keeps_every_bit(offset):
    start = wavy_grid(9, 8)
    far = start.with_vertices(start.vertices + np.array(offset) + 1 / 3)
    origin = LocalOrigin.of_mesh(far)
    near = origin.near_mesh(far)
    assert (
        near.vertices.astype(np.longdouble).tolist()
        == (far.vertices.astype(np.longdouble) - origin.shift.astype(np.longdouble)).tolist()
    )
    assert origin.back_mesh(near).vertices.tobytes() == far.vertices.tobytes()


def test_the_point_is_round_and_only_along_axes_that_are_far():
    start = wavy_grid(9, 8)
    far = start.with_vertices(start.vertices + [500123.25, 5412345.5, 412.0])
    assert LocalOrigin.of_mesh(far).shift.tolist() == [500100.0, 5412300.0, 0.0]
    assert LocalOrigin.of(1000 * far.vertices).shift.tolist() == [500100e3, 5412300e3, 0.0]
    assert LocalOrigin.of(far.vertices).scaled(10).shift.tolist() == [5001000.0, 54123000.0, 0.0]


def test_vertices_without_faces_do_not_count():
    start = wavy_grid(4, 4)
    points = np.vstack([start.vertices + [1e7, 0, 0], [[0, 0, 0]]])
    from solver import QuadMesh

    assert LocalOrigin.of_mesh(QuadMesh(points, start.faces)).shift[0] == 1e7


def test_points_without_size_stay():
    assert not LocalOrigin.of(np.full((3, 3), 1e9)).far
    assert not LocalOrigin.of(np.zeros((0, 3))).far
