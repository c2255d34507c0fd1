"""What smooth theory says about the nets holds for results of the solver, with its order."""

from __future__ import annotations

import functools

import numpy as np
import pytest

from solver import QuadMesh, optimise
from solver.analysis import spheres
from solver.analysis.curvature import gauss_curvature, mean_curvature
from solver.analysis.gauss_image import gauss_image
from tests.conftest import demo_roof, wavy_grid
from tests.meshes import bent_sheet, deformed, helicoid, noisy, scherk, unduloid

COUNTS = (13, 25, 49)


def result(net: str, start: QuadMesh) -> QuadMesh:
    outcome = optimise(start, net)
    assert outcome.report.status == "converged", outcome.report.message
    return outcome.mesh


def root_mean_square(values) -> float:
    return float(np.sqrt(np.nanmean(np.square(values))))


def orders(errors) -> np.ndarray:
    errors = np.array(errors)
    return np.log2(errors[:-1] / errors[1:])


def refined_with_noise(build) -> list[QuadMesh]:
    """Ever finer samplings; the noise is 10 % of an edge on the coarsest and falls with h^2."""
    return [noisy(build(count, count), 0.1 * 12 / (count - 1)) for count in COUNTS]


@pytest.mark.slow
@pytest.mark.parametrize("build", [scherk, helicoid])
def test_asymptotic_results_are_minimal_to_second_order(build):
    starts = refined_with_noise(build)
    meshes = [result("asymptotic", start) for start in starts]
    errors = [root_mean_square(mean_curvature(mesh)) for mesh in meshes]
    assert (orders(errors) > 1.8).all(), errors
    assert np.nanmax(np.abs(mean_curvature(meshes[-1]))) < 1e-3
    assert np.nanmax(np.abs(mean_curvature(starts[-1]))) > 1
    assert np.nanmin(gauss_curvature(meshes[-1])) < -0.9


@pytest.mark.slow
def test_cmc_results_have_the_mean_curvature_of_their_spheres_to_second_order():
    starts = refined_with_noise(unduloid)
    meshes = [result("cmc", start) for start in starts]
    misses = [mean_curvature(mesh) - 1 / spheres.common_radius(mesh) for mesh in meshes]
    errors = [root_mean_square(miss) for miss in misses]
    assert (orders(errors) > 1.8).all(), errors
    assert np.nanmax(np.abs(misses[-1])) < 2e-3
    assert abs(spheres.common_radius(meshes[-1])) == pytest.approx(1.0, abs=5e-3)


def middle(values, count) -> np.ndarray:
    """Values of the vertices in the middle half of a count x count grid."""
    margin = (count - 1) // 4
    return np.reshape(values, (count, count))[margin:-margin, margin:-margin]


@functools.cache
def developable(net: str, count: int) -> tuple[QuadMesh, QuadMesh]:
    """Start and result of a bent sheet, bulged so that it is far from developable."""
    start = deformed(bent_sheet(count, count), seed=2)
    return start, result(net, start)


@pytest.mark.slow
@pytest.mark.parametrize("net", ["geodesic", "dog"])
def test_geodesic_results_become_developable(net):
    gauss, areas = [], []
    for count in COUNTS:
        start, mesh = developable(net, count)
        gauss.append(root_mean_square(middle(gauss_curvature(mesh), count)))
        areas.append(np.abs(middle(gauss_image(mesh), count)).sum())
    # First order at least: the free boundary of a geodesic net leaves second order to the middle.
    assert (orders(gauss)[:1] > 1.0).all() and (orders(gauss) > 0.6).all(), gauss
    assert (orders(areas) > 0.5).all(), areas
    assert gauss[-1] < 0.1 * root_mean_square(middle(gauss_curvature(start), count))
    assert areas[-1] < 0.1 * np.abs(middle(gauss_image(start), count)).sum()
    # Developable, not flat.
    assert np.abs(middle(mean_curvature(mesh), count)).max() > 0.3


@pytest.mark.slow
def test_gauss_image_of_chebyshev_results_vanishes_to_second_order():
    areas = []
    for count in COUNTS:
        start, mesh = developable("chebyshev", count)
        areas.append(np.abs(middle(gauss_image(mesh), count)).sum())
    assert (orders(areas) > 1.7).all(), areas
    assert areas[-1] < 0.02 * np.abs(middle(gauss_image(start), count)).sum()
    assert np.abs(middle(mean_curvature(mesh), count)).max() > 0.3


def test_angle_defects_of_chebyshev_results_vanish_exactly():
    """With equal edges and equal diagonals the corner of a face and of its splits sum to pi."""
    start = noisy(bent_sheet())
    mesh = result("chebyshev", start)
    assert np.nanmax(np.abs(gauss_curvature(mesh))) < 1e-10
    assert np.nanmax(np.abs(gauss_curvature(start))) > 1


@pytest.mark.parametrize("build", [demo_roof, lambda: wavy_grid(12, 10)])
def test_circular_results_have_circles(build):
    mesh = result("circular", build())
    corners = mesh.vertices[mesh.faces]
    misses = []
    for points in corners:
        # The circle of three corners, by the plane and the two bisecting planes.
        a, b, c, d = points
        normal = np.cross(b - a, c - a)
        system = np.stack([b - a, c - a, normal / np.linalg.norm(normal)])
        right = [(b @ b - a @ a) / 2, (c @ c - a @ a) / 2, system[2] @ a]
        centre = np.linalg.solve(system, right)
        misses += [np.linalg.norm(d - centre) - np.linalg.norm(a - centre), system[2] @ (d - a)]
    assert np.abs(misses).max() < 1e-10 * mesh.mean_edge


@pytest.mark.parametrize("build", [demo_roof, lambda: wavy_grid(12, 10)])
def test_conical_results_have_cones(build):
    """The planes of the four faces at a vertex touch a cone: their normals lie on a circle."""
    mesh = result("conical", build())
    net = mesh.connectivity
    faces_at = [[] for _ in range(net.vertex_count)]
    for number, face in enumerate(mesh.faces):
        for vertex in face:
            faces_at[vertex].append(number)
    tips = net.stars[:, 0]
    normals = mesh.face_normals[np.array([faces_at[vertex] for vertex in tips])]
    differences = normals[:, 1:] - normals[:, :1]
    volumes = np.abs(np.linalg.det(differences))
    # Degenerate cones are planes: count the volume against the spread of the normals.
    spread = np.linalg.norm(differences, axis=2).max(axis=1)
    assert np.median(spread) > 0.05
    assert (volumes / spread**2).max() < 1e-10
