"""Overlays lie where the geometry says."""

import numpy as np
import pytest

from freecad_ortho.view import overlay_shapes
from freecad_ortho.view.overlay_shapes import OVERLAYS, Balls, Lines, Points
from solver.analysis.spheres import star_curvatures
from solver.mesh.lines import ParameterLines
from tests.conftest import surface_of_revolution, wavy_grid


@pytest.mark.parametrize("name", OVERLAYS)
def test_every_overlay_draws_finite_things(name):
    for shape in OVERLAYS[name][0](wavy_grid(7, 6).scaled(1500.0)):
        arrays = [value for value in vars(shape).values() if isinstance(value, np.ndarray)]
        assert arrays and all(np.isfinite(array).all() for array in arrays)
        assert len(arrays[0]) or name == "IrregularVertices"


def test_diagonals_are_equal_and_medial_lines_perpendicular_on_an_orthogonal_net():
    mesh = surface_of_revolution()
    (diagonals,) = overlay_shapes.diagonals(mesh)
    length = np.linalg.norm(diagonals.ends[:, 1] - diagonals.ends[:, 0], axis=1)
    one, two = length.reshape(2, -1)
    np.testing.assert_allclose(one, two, rtol=1e-12)
    (medial,) = overlay_shapes.medial_lines(mesh)
    one, two = (medial.ends[:, 1] - medial.ends[:, 0]).reshape(2, -1, 3)
    np.testing.assert_allclose(np.einsum("ij,ij->i", one, two), 0.0, atol=1e-12)


def test_parameter_lines_are_all_edges_in_two_colours():
    mesh = wavy_grid(5, 4)
    one, two = overlay_shapes.parameter_lines(mesh)
    assert {len(one.ends), len(two.ends)} == {15, 16}
    assert one.colour != two.colour


def test_rulings_of_neighbours_lie_in_a_plane_with_their_edge():
    mesh = wavy_grid(6, 5)
    first, _ = overlay_shapes.rulings(mesh)
    of_u = ParameterLines(mesh.connectivity).of_family("u")
    line = first.ends[: len(of_u[0].vertices)]
    np.testing.assert_allclose(line.mean(axis=1), mesh.vertices[of_u[0].vertices], atol=1e-12)
    along = np.diff(line.mean(axis=1), axis=0)
    direction = line[:, 1] - line[:, 0]
    volume = np.einsum("ij,ij->i", np.cross(direction[:-1], direction[1:]), along)
    np.testing.assert_allclose(volume, 0.0, atol=1e-10)


def test_caps_lie_on_the_spheres_of_their_stars():
    mesh = wavy_grid(5, 5)
    (caps,) = overlay_shapes.star_spheres(mesh)
    curvatures, normals = star_curvatures(mesh)
    centres = mesh.vertices[mesh.connectivity.stars[:, 0]] + normals / curvatures[:, None]
    rims = caps.ends.reshape(-1, 3)[: len(centres) * 64].reshape(len(centres), 64, 3)
    distance = np.linalg.norm(rims - centres[:, None], axis=2)
    np.testing.assert_allclose(distance, np.abs(1 / curvatures)[:, None] * np.ones(64), rtol=1e-9)


def test_gauss_image_of_a_cylinder_is_a_curve():
    mesh = wavy_grid(9, 9, shear=0.0)
    x, y = mesh.vertices[:, :2].T
    bent = mesh.with_vertices(np.stack([x, y, np.sin(x)], axis=1))
    ball, _, points = overlay_shapes.gauss_image(bent)
    assert isinstance(ball, Balls) and isinstance(points, Points)
    away = points.places - ball.centres[0]
    np.testing.assert_allclose(away[:, 1], 0.0, atol=1e-12)
    assert np.ptp(away[:, 0]) > 1.0


def test_forces_of_a_hanging_square_are_tension():
    flat = wavy_grid(9, 9, height=0.0, shear=0.0)
    x, y = (flat.vertices - flat.vertices.mean(axis=0))[:, :2].T
    hanging = flat.with_vertices(np.stack([x, y, 0.25 * (x**2 + y**2)], axis=1))
    shapes = overlay_shapes.forces(hanging)
    assert shapes and all(isinstance(shape, Lines) and shape.colour[0] > 0.6 for shape in shapes)
