"""Measures against surfaces whose properties are known exactly."""

from __future__ import annotations

import numpy as np
import pytest

from solver import QuadMesh
from solver.analysis import measures
from solver.analysis.check import check
from solver.analysis.spheres import (
    cmc,
    common_radius,
    least_squares,
    star_centres,
    star_curvatures,
)
from tests.conftest import grid_faces, surface_of_revolution, wavy_grid
from tests.meshes import grid, parameters


def sphere_patch(radius: float, count: int = 9, width: float = 0.8) -> QuadMesh:
    angles = np.linspace(-width / 2, width / 2, count)
    u, v = np.meshgrid(angles, angles, indexing="ij")
    points = np.stack([np.cos(v) * np.cos(u), np.cos(v) * np.sin(u), np.sin(v)], axis=2)
    return QuadMesh(radius * points.reshape(-1, 3), grid_faces(count, count))


def single(corners) -> QuadMesh:
    return QuadMesh(np.array(corners, dtype=float), [[0, 1, 2, 3]])


def test_orthogonality_of_a_known_quad():
    # Diagonals of length 2 and 1: difference 1 over mean 1.5.
    kite = single([[-1, 0, 0], [0, -0.5, 0], [1, 0, 0], [0, 0.5, 0]])
    assert measures.orthogonality(kite)[0] == pytest.approx(1 / 1.5, rel=1e-14)


def test_planarity_of_a_known_quad():
    # Diagonals of length 2 crossing at a distance of 0.1.
    skew = single([[-1, 0, 0.1], [0, -1, 0], [1, 0, 0.1], [0, 1, 0]])
    assert measures.planarity(skew)[0] == pytest.approx(0.1 / 2, rel=1e-14)
    assert measures.four_in_plane(skew)[0] == pytest.approx(0.05, rel=1e-14)


def test_medial_lines_of_a_known_quad():
    # They run along the middles of opposite sides: 60 degrees apart in this parallelogram.
    slanted = single([[0, 0, 0], [2, 0, 0], [2.5, np.sqrt(0.75), 0], [0.5, np.sqrt(0.75), 0]])
    assert measures.medial_angle(slanted)[0] == pytest.approx(np.pi / 6, rel=1e-14)
    assert measures.medial_angle(slanted, np.pi / 3)[0] == pytest.approx(0.0, abs=1e-14)


def test_isosceles_trapezoids_are_principal_and_circular():
    barrel = surface_of_revolution()
    assert measures.orthogonality(barrel).max() < 1e-14
    assert measures.planarity(barrel).max() < 1e-14
    assert measures.circular(barrel).max() < 1e-14
    assert measures.conical(barrel).max() < 1e-13


def test_translational_grid_of_rhombi_is_chebyshev():
    i, j = np.meshgrid(np.arange(6.0), np.arange(5.0), indexing="ij")
    points = np.stack([i + 0.5 * j, np.sqrt(0.75) * j, 0 * i], axis=2).reshape(-1, 3)
    mesh = QuadMesh(points, grid_faces(6, 5))
    assert measures.chebyshev(mesh).max() < 1e-14
    assert measures.geodesic(mesh).max() < 1e-14
    # Angles of 60 and 120 degrees alternate: the two sums differ by 120 degrees.
    assert measures.conical(mesh) == pytest.approx(2 * np.pi / 3, rel=1e-14)


def test_helicoid_grid_is_asymptotic():
    s, t = np.meshgrid(np.linspace(-1, 1, 9), np.linspace(-1, 1, 9), indexing="ij")
    points = np.stack([s * np.cos(t), s * np.sin(t), t], axis=2).reshape(-1, 3)
    mesh = QuadMesh(points, grid_faces(9, 9))
    # Rulings and helices are asymptotic lines; every star is planar by symmetry of the motion.
    assert measures.asymptotic(mesh).max() < 1e-14
    assert measures.asymptotic(wavy_grid(9, 9)).max() > 1e-2


def test_a_star_of_a_saddle_is_off_its_plane_by_its_height():
    x, y = 2.0 * np.mgrid[-1:2, -1:2]
    saddle = QuadMesh(
        np.stack([x, y, 0.3 * (x**2 - y**2) / 4], axis=2).reshape(-1, 3), grid_faces(3, 3)
    )
    assert saddle.mean_edge == pytest.approx(np.hypot(2, 0.3), rel=1e-14)
    assert measures.asymptotic(saddle) == pytest.approx(0.3 / np.hypot(2, 0.3), rel=1e-12)


@pytest.mark.parametrize("radius", [0.3, 40.0])
def test_sphere_has_its_radius(radius):
    mesh = sphere_patch(radius)
    assert cmc(mesh).max() < 1e-13
    assert abs(common_radius(mesh)) == pytest.approx(radius, rel=1e-12)
    curvature, normal = star_curvatures(mesh)
    centre = mesh.vertices[mesh.connectivity.stars[:, 0]] + normal / curvature[:, None]
    assert np.abs(centre).max() < 1e-12 * radius
    assert cmc(mesh, radius=2 * radius).max() > 1e-4


def test_folded_faces_are_found():
    mesh = wavy_grid(6, 6)
    assert not measures.flipped(mesh).any()
    folded = mesh.vertices.copy()
    folded[14] = folded[14] + 3.0 * (folded[21] - folded[14])
    assert measures.flipped(mesh.with_vertices(folded)).any()


def test_check_names_the_worst_place_and_is_scale_free():
    mesh = wavy_grid(7, 6)
    bent = mesh.vertices.copy()
    bent[0] += [0, 0, 0.8]
    result = check(mesh.with_vertices(bent))
    assert result["measures"]["planarity"]["where"] == "face"
    assert result["measures"]["planarity"]["worst"] == 0
    scaled = check(mesh.with_vertices(bent).scaled(1000.0))
    for name, entry in result["measures"].items():
        assert scaled["measures"][name]["max"] == pytest.approx(entry["max"], rel=1e-9)
        assert scaled["measures"][name]["worst"] == entry["worst"]


@pytest.mark.parametrize(("rows", "columns"), [(12, 9), (80, 70)])
def test_check_says_whether_a_mesh_is_a_multi_net(rows, columns):
    # By Ivory's theorem confocal conics are one: every rectangle of them is orthogonal.
    u, v = np.meshgrid(np.linspace(0.4, 1.6, rows), np.linspace(0.2, 1.2, columns), indexing="ij")
    points = np.stack([np.cosh(u) * np.cos(v), np.sinh(u) * np.sin(v), 0 * u], axis=2)
    mesh = QuadMesh(points.reshape(-1, 3), grid_faces(rows, columns))
    found = check(mesh)["multi_net"]
    assert found["is_multi_net"] and found["worst"] < 1e-14 and not found["at_least"]
    lifted = mesh.vertices.copy()
    lifted[0] += [0, 0, 0.1]
    found = check(mesh.with_vertices(lifted))["multi_net"]
    assert not found["is_multi_net"] and 0 in found["corners"]
    # The corner is 0.1 higher above the vertex opposite to it, and nowhere else.
    size = np.linalg.norm(np.ptp(lifted, axis=0))
    assert found["worst"] == pytest.approx(0.1**2 / size**2, rel=1e-9)
    assert found["at_least"] == (rows > 65)
    three = QuadMesh(
        [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 1, 1], [0, 0, 1], [1, 0, 1]],
        [[0, 1, 2, 3], [0, 3, 4, 5], [0, 5, 6, 1]],
    )
    assert check(three)["multi_net"] is None


def test_many_small_least_squares_are_those_of_the_pseudo_inverse():
    random = np.random.default_rng(1)
    system, right = random.normal(size=(50, 5, 3)), random.normal(size=(50, 5))
    system[:, :, 1] *= 1e-3
    system[25:, :, 2] = 0.0
    expected = np.einsum("sij,sj->si", np.linalg.pinv(system), right)
    assert np.allclose(least_squares(system, right), expected, rtol=1e-9, atol=1e-11)


@pytest.mark.parametrize("radius", [2.0, -3.0, 30.0])
def test_no_centre_near_that_of_a_star_fits_its_points_better(radius):
    """Where the sum of squares is least, its slope is zero."""
    mesh = wavy_grid(7, 6)
    centres = star_centres(mesh, radius)
    spokes = measures.star_spokes(mesh)
    away = centres[:, None] - np.concatenate([np.zeros_like(spokes[:, :1]), spokes], axis=1)
    distance = np.linalg.norm(away, axis=2, keepdims=True)
    slope = ((distance - abs(radius)) * away / distance).sum(axis=1)
    assert np.abs(distance - abs(radius)).max() > 1e-3 * mesh.mean_edge
    assert np.abs(slope).max() < 1e-9 * mesh.mean_edge


def test_check_of_a_mesh_without_interior_vertices():
    strip = QuadMesh(
        np.array([[i, j, 0.1 * i * j] for i in range(4) for j in range(2)]), grid_faces(4, 2)
    )
    result = check(strip)
    assert result["measures"]["asymptotic"] == {
        "max": 0.0,
        "mean": 0.0,
        "worst": None,
        "where": "vertex",
        "exempt": 0,
    }


def test_a_mesh_without_stars_has_no_curvatures():
    curvatures, normals = star_curvatures(single([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]))
    assert (curvatures.shape, normals.shape) == ((0,), (0, 3))


def test_slant_is_the_angle_of_the_worst_corner_from_upright():
    x, y = parameters(3, 3, 2.0, 2.0)
    assert measures.slant(grid(x, y, 0 * x)) == pytest.approx(0.0, abs=1e-6)
    assert measures.slant(grid(x + y, y, 0 * x)) == pytest.approx(45.0)
