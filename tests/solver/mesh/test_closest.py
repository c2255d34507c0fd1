"""Closest points: against brute force, on edges and corners, degenerate input, in any order."""

from __future__ import annotations

import time

import numpy as np
import pytest

from solver import InputError
from solver.mesh.closest import Polyline, TriangleSurface
from tests.conftest import wavy_grid


def on_segment(point, start, end):
    side = end - start
    length = side @ side
    t = 0.0 if length == 0 else min(1.0, max(0.0, (point - start) @ side / length))
    return start + t * side


def on_triangle(point, a, b, c):
    """Closest point by solving for the foot and by all three sides: slow and plain."""
    feet = [on_segment(point, a, b), on_segment(point, b, c), on_segment(point, c, a)]
    system = np.stack([b - a, c - a], axis=1)
    if np.linalg.matrix_rank(system) == 2:
        u, v = np.linalg.lstsq(system, point - a, rcond=None)[0]
        if u > 0 and v > 0 and u + v < 1:
            feet.append(a + u * (b - a) + v * (c - a))
    return min(feet, key=lambda foot: np.linalg.norm(point - foot))


def distance_by_brute_force(point, corners):
    return min(np.linalg.norm(point - on_triangle(point, *triangle)) for triangle in corners)


def triangle_soup(rng, count=60):
    """Triangles of very different sizes, some of them segments or single points."""
    size = 10.0 ** rng.uniform(-3, 0.5, (count, 1, 1))
    corners = rng.normal(size=(count, 1, 3)) + size * rng.normal(size=(count, 3, 3))
    corners[::10, 2] = corners[::10, 1]
    corners[5::10] = corners[5::10, :1]
    corners[7::10, 2] = 0.5 * (corners[7::10, 0] + corners[7::10, 1])
    return corners


def surface_of(corners):
    return TriangleSurface(corners.reshape(-1, 3), np.arange(corners.size // 3).reshape(-1, 3))


def cube():
    """Unit cube with outward triangles."""
    vertices = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
    quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    triangles = [[q[0], q[k], q[k + 1]] for q in quads for k in (1, 2)]
    return TriangleSurface(vertices, triangles)


@pytest.mark.parametrize("spread", [0.01, 1.0, 30.0])
def test_feet_are_nearest_of_all_triangles(spread):
    rng = np.random.default_rng(7)
    corners = triangle_soup(rng)
    points = np.concatenate(
        [corners[:, 0] + spread * rng.normal(size=(60, 3)), spread * rng.normal(size=(140, 3))]
    )
    feet, normals = surface_of(corners).closest(points)
    distances = [distance_by_brute_force(point, corners) for point in points]
    assert np.allclose(np.linalg.norm(points - feet, axis=1), distances, rtol=1e-12, atol=1e-14)
    assert max(distance_by_brute_force(foot, corners) for foot in feet) < 1e-12
    assert np.allclose(np.linalg.norm(normals, axis=1), 1.0)


def test_the_nearest_middle_is_not_the_nearest_triangle():
    large = [[-50.0, -50.0, 0.0], [50.0, -50.0, 0.0], [0.0, 90.0, 0.0]]
    small = [[5.0, 5.0, 1.0], [5.1, 5.0, 1.0], [5.0, 5.1, 1.0]]
    surface = surface_of(np.array([large, small]))
    feet, normals = surface.closest([[5.0, 5.0, 0.2], [5.01, 5.01, 0.9]])
    assert np.allclose(feet, [[5.0, 5.0, 0.0], [5.01, 5.01, 1.0]], rtol=0, atol=1e-14)
    assert np.allclose(normals, [[0, 0, 1], [0, 0, 1]])


def test_faces_edges_and_corners_of_a_cube():
    outside = [[0.3, 0.4, 1.5], [0.5, 1.3, 1.4], [1.1, 1.2, 1.3], [0.3, 0.4, 0.8]]
    feet, normals = cube().closest(outside)
    assert np.allclose(feet, [[0.3, 0.4, 1], [0.5, 1, 1], [1, 1, 1], [0.3, 0.4, 1]], atol=1e-15)
    assert np.allclose(normals[:2], [[0, 0, 1], [0, 0.6, 0.8]], rtol=0, atol=1e-14)
    assert np.allclose(normals[2], np.array([1, 2, 3]) / np.sqrt(14), rtol=0, atol=1e-14)
    # Seen from within, the normal still points outwards.
    assert np.allclose(normals[3], [0, 0, 1])


def test_points_on_edges_and_corners_have_the_mean_normal():
    feet, normals = cube().closest([[0.3, 1.0, 1.0], [1.0, 1.0, 1.0], [0.0, 0.0, 0.7]])
    assert (feet == [[0.3, 1.0, 1.0], [1.0, 1.0, 1.0], [0.0, 0.0, 0.7]]).all()
    assert np.allclose(normals[0], np.array([0, 1, 1]) / np.sqrt(2), rtol=0, atol=1e-12)
    # By angles the corner has no preference, however its three squares are split.
    assert np.allclose(normals[1], np.ones(3) / np.sqrt(3), rtol=0, atol=1e-12)
    assert np.allclose(normals[2], np.array([-1, -1, 0]) / np.sqrt(2), rtol=0, atol=1e-12)


def test_beyond_the_border_the_normal_leads_back():
    surface = surface_of(np.array([[[0.0, 0, 0], [1, 0, 0], [0, 1, 0]]]))
    points = np.array([[0.5, -2.0, 0.0], [-3.0, -4.0, 0.0], [0.2, -1e-4, 1e-4]])
    feet, normals = surface.closest(points)
    assert np.allclose(feet, [[0.5, 0, 0], [0, 0, 0], [0.2, 0, 0]], rtol=0, atol=1e-15)
    away = (points - feet) / np.linalg.norm(points - feet, axis=1, keepdims=True)
    assert np.allclose(np.abs(np.einsum("ij,ij->i", away, normals)), 1.0)
    assert normals[2, 2] > 0


@pytest.mark.parametrize("together", [True, False])
def test_beyond_the_border_the_surface_keeps_its_normal_and_a_way_out(together):
    vertices = np.array([[0.0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]])
    triangles = np.array([[0, 1, 2], [0, 2, 3]])
    if not together:
        vertices, triangles = vertices[triangles].reshape(-1, 3), np.arange(6).reshape(2, 3)
    # Beside a side, beside a corner, over the surface, over the diagonal inside, on the border.
    points = [[1, -3, 0.5], [-3, -4, 1], [1.2, 0.5, 0.7], [1, 1, 0.3], [2, 1, 0.0]]
    feet, normals, outwards = TriangleSurface(vertices, triangles).beside(points)
    np.testing.assert_allclose(feet[:2], [[1, 0, 0], [0, 0, 0]], atol=1e-15)
    np.testing.assert_allclose(normals, np.tile([0.0, 0, 1], (5, 1)), atol=1e-15)
    ways = [[0, -1, 0], [-0.6, -0.8, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0]]
    np.testing.assert_allclose(outwards, ways, atol=1e-12)


def test_gradient_of_the_distance_is_the_normal():
    rng = np.random.default_rng(3)
    mesh = wavy_grid(8, 7)
    surface = TriangleSurface.from_quads(mesh)
    points = mesh.vertices[rng.integers(0, 56, 80)] + 0.4 * rng.normal(size=(80, 3))
    feet, normals = surface.closest(points)
    step = 1e-6
    slopes = []
    for axis in np.eye(3):
        ahead, behind = (points + s * step * axis for s in (1, -1))
        distances = [np.linalg.norm(p - surface.closest(p)[0], axis=1) for p in (ahead, behind)]
        slopes.append((distances[0] - distances[1]) / (2 * step))
    gradient = np.stack(slopes, axis=1)
    side = np.sign(np.einsum("ij,ij->i", points - feet, normals))[:, None]
    # A few points lie where two feet are equally near: there is no gradient there.
    smooth = np.linalg.norm(gradient, axis=1) > 1 - 1e-6
    assert smooth.mean() > 0.9
    assert np.allclose(gradient[smooth], (side * normals)[smooth], rtol=0, atol=1e-5)


def test_vertices_of_a_quad_mesh_are_their_own_feet():
    mesh = wavy_grid(9, 6)
    surface = TriangleSurface.from_quads(mesh)
    feet, normals = surface.closest(mesh.vertices)
    assert (feet == mesh.vertices).all()
    assert np.einsum("ij,ij->i", normals, mesh.vertex_normals).min() > 0.9
    assert len(surface.triangles) == 2 * len(mesh.faces)


def test_quads_are_split_along_their_shorter_diagonal():
    mesh = wavy_grid(5, 5)
    surface = TriangleSurface.from_quads(mesh)
    a, b, c, d = (mesh.vertices[mesh.faces[:, k]] for k in range(4))
    shorter = np.linalg.norm(c - a, axis=1) <= np.linalg.norm(d - b, axis=1)
    middles = np.where(shorter[:, None], a + c, b + d) / 2
    other = np.where(shorter[:, None], b + d, a + c) / 2
    assert np.allclose(surface.closest(middles)[0], middles, rtol=0, atol=1e-14)
    assert np.linalg.norm(surface.closest(other)[0] - other, axis=1).min() > 1e-6


def test_answers_do_not_depend_on_the_company():
    rng = np.random.default_rng(11)
    surface = TriangleSurface.from_quads(wavy_grid(20, 20))
    points = rng.uniform(-30, 50, (300, 3))
    together = surface.closest(points)
    alone = [surface.closest(point[None]) for point in points]
    for k in range(2):
        assert (together[k] == np.concatenate([answer[k] for answer in alone])).all()


def test_all_triangles_equally_near_fits_into_memory(monkeypatch):
    monkeypatch.setattr("solver.mesh.box_tree._PAIRS", 2_000)
    polar, turn = np.meshgrid(np.linspace(0.1, 3.0, 40), np.linspace(0, 6.2, 40), indexing="ij")
    points = np.stack(
        [np.sin(polar) * np.cos(turn), np.sin(polar) * np.sin(turn), np.cos(polar)], axis=2
    )
    corner = np.arange(1600).reshape(40, 40)
    triangles = np.stack([corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:]], axis=2)
    surface = TriangleSurface(points.reshape(-1, 3), triangles.reshape(-1, 3))
    centres = 1e-9 * np.random.default_rng(0).normal(size=(50, 3))
    feet, _ = surface.closest(centres)
    corners = surface.vertices[surface.triangles]
    expected = [distance_by_brute_force(point, corners) for point in centres[:3]]
    assert np.allclose(np.linalg.norm(centres - feet, axis=1)[:3], expected, rtol=1e-12)


def test_a_hundred_thousand_triangles_in_seconds():
    mesh = wavy_grid(225, 225)
    rng = np.random.default_rng(5)
    begin = time.perf_counter()
    surface = TriangleSurface.from_quads(mesh)
    lifted = mesh.vertices + 1e-3 * mesh.vertex_normals * rng.normal(size=(len(mesh.vertices), 1))
    feet, _ = surface.closest(lifted)
    assert time.perf_counter() - begin < 20
    assert np.linalg.norm(feet - lifted, axis=1).max() < 1e-2


def test_units_do_not_matter():
    rng = np.random.default_rng(2)
    corners = triangle_soup(rng)
    points = rng.normal(size=(100, 3))
    feet, normals = surface_of(corners).closest(points)
    for factor in (2.0**-40, 2.0**40):
        scaled = surface_of(corners * factor).closest(points * factor)
        assert (scaled[0] == feet * factor).all()
        assert np.allclose(scaled[1], normals, rtol=0, atol=1e-12)


def test_no_points_give_no_feet():
    feet, normals = cube().closest(np.zeros((0, 3)))
    assert feet.shape == normals.shape == (0, 3)
    feet, tangents = Polyline([[0, 0, 0], [1, 0, 0]]).closest(np.zeros((0, 3)))
    assert feet.shape == tangents.shape == (0, 3)


@pytest.mark.parametrize("closed", [False, True])
def test_polyline_against_brute_force(closed):
    rng = np.random.default_rng(13)
    path = rng.normal(size=(40, 3)).cumsum(axis=0)
    ends = np.roll(path, -1, axis=0)
    segments = list(zip(path, ends, strict=True))[: 40 if closed else 39]
    points = path[rng.integers(0, 40, 200)] + 2 * rng.normal(size=(200, 3))
    feet, tangents = Polyline(path, closed).closest(points)
    for point, foot, tangent in zip(points, feet, tangents, strict=True):
        options = [on_segment(point, *segment) for segment in segments]
        best = min(np.linalg.norm(point - option) for option in options)
        assert np.isclose(np.linalg.norm(point - foot), best, rtol=1e-12)
        length = np.linalg.norm(tangent)
        assert np.isclose(length, 1.0) or (not closed and length == 0)
        if not (foot == path).all(axis=1).any():
            assert abs((point - foot) @ tangent) < 1e-12


def test_tangents_at_corners_and_ends():
    line = Polyline([[0, 0, 0], [1, 0, 0], [1, 1, 0]])
    points = [[1.5, -0.5, 0], [-1, 0, 0], [0, 0, 0], [1, 3, 0], [0, 0.2, 0], [1, 0, 0]]
    feet, tangents = line.closest(points)
    diagonal = [np.sqrt(0.5), np.sqrt(0.5), 0]
    assert (feet == [[1, 0, 0], [0, 0, 0], [0, 0, 0], [1, 1, 0], [0, 0, 0], [1, 0, 0]]).all()
    expected = [diagonal, [0, 0, 0], [1, 0, 0], [0, 0, 0], [1, 0, 0], diagonal]
    assert np.allclose(tangents, expected, rtol=0, atol=1e-15)


def test_a_closed_polyline_has_no_ends():
    square = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    for path in (square, np.concatenate([square, square[:1]]), np.repeat(square, 2, axis=0)):
        feet, tangents = Polyline(path, closed=True).closest([[-0.5, 0.5, 0], [-1, -1, 0]])
        assert np.allclose(feet, [[0, 0.5, 0], [0, 0, 0]])
        assert np.allclose(tangents, [[0, -1, 0], [np.sqrt(0.5), -np.sqrt(0.5), 0]])


def test_a_polyline_that_turns_back_keeps_a_tangent():
    feet, tangents = Polyline([[0, 0, 0], [1, 0, 0], [0, 0, 0]]).closest([[2, 0, 0]])
    assert (feet == [[1, 0, 0]]).all()
    assert np.allclose(np.abs(tangents), [[1, 0, 0]])


@pytest.mark.parametrize(
    ("vertices", "triangles", "words"),
    [
        ([[0, 0, 0]], np.zeros((0, 3), dtype=int), "triangles: expected shape"),
        ([[0, 0, 0]], [[0, 0, 1]], "numbered 0 to 0, got 0 to 1"),
        ([[0, 0, 0]], [[0, 0, -1]], "numbered 0 to 0, got -1 to 0"),
        ([[0, 0]], [[0, 0, 0]], "vertices: expected shape"),
        ([[0, 0, np.nan]], [[0, 0, 0]], "vertices: some coordinates are NaN"),
    ],
)
def test_bad_surfaces_are_refused(vertices, triangles, words):
    with pytest.raises(InputError, match=words):
        TriangleSurface(vertices, triangles)


@pytest.mark.parametrize(
    ("points", "words"),
    [
        ([[0, 0, 0]], "two different points or more, got 1"),
        ([[1, 1, 1], [1, 1, 1]], "two different points or more, got 1"),
        ([0, 0, 0], "polyline: expected shape"),
        ([[0, 0, 0], [0, np.inf, 0]], "polyline: some coordinates"),
    ],
)
def test_bad_polylines_are_refused(points, words):
    with pytest.raises(InputError, match=words):
        Polyline(points)


def test_a_surface_in_another_unit_answers_as_one_that_is_made_there():
    mesh, rng = wavy_grid(9, 8), np.random.default_rng(4)
    surface = TriangleSurface.from_quads(mesh)
    centre, scale = np.array([1.0, -2.0, 0.5]), 0.3
    moved = surface.scaled(centre, scale)
    anew = TriangleSurface((surface.vertices - centre) / scale, surface.triangles)
    assert moved.vertices.tobytes() == anew.vertices.tobytes()
    # Over the surface and beyond its border, where it has to know which sides are on that.
    low, high = anew.vertices.min(axis=0) - 1.0, anew.vertices.max(axis=0) + 1.0
    points = rng.uniform(low, high, (300, 3))
    for mine, other in zip(moved.beside(points), anew.beside(points), strict=True):
        np.testing.assert_allclose(mine, other, atol=1e-12)
    assert np.abs(moved.beside(points)[2]).max() > 0
    # The first one is as it was.
    assert np.abs(surface.closest(mesh.vertices)[0] - mesh.vertices).max() < 1e-12
