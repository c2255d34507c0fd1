"""Nets that are their own mirror images on surfaces that are."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial import cKDTree

from solver.align.align import aligned
from solver.align.crosses import Singular
from solver.align.symmetry import (
    Mirror,
    _doubled,
    coordinate_planes,
    mirrors_of,
    symmetric_surface,
)
from solver.align.triangle_mesh import one_surface
from solver.analysis import measures
from solver.errors import InputError
from tests.design_surfaces import barrel, dome, plane, triangles, without

# Of the surfaces, 30 m wide, in metres.
EDGE = 2.0
ROUNDING = 1e-9
X, Y = (Mirror(np.eye(3)[k], np.zeros(3)) for k in (0, 1))


def misses(points, mirror):
    """The largest distance of a mirror image from the nearest of the points (N, 3)."""
    return cKDTree(points).query(mirror.images(points))[0].max()


def turned(points, degrees):
    """Points turned about the z axis."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return points @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])


@pytest.fixture(scope="module")
def on_dome():
    """The triangles are not symmetric: all their diagonals run one way."""
    points, faces = triangles(dome, 40, 28)
    return aligned(points, faces, edge=EDGE, symmetry="auto")


def test_net_field_and_singular_vertices_are_their_mirror_images(on_dome):
    net = on_dome.mesh
    for mirror in (X, Y):
        for points in (
            net.vertices,
            net.vertices[net.faces].mean(axis=1),
            net.vertices[net.connectivity.edges].mean(axis=1),
            on_dome.field.places,
            on_dome.singular.places,
        ):
            assert misses(points, mirror) < ROUNDING
    valences = net.connectivity.face_valence[on_dome.irregular]
    assert sorted(valences) == sorted(on_dome.singular.valences) == [3, 3, 5, 5]
    assert misses(net.vertices[on_dome.irregular], X) < ROUNDING
    assert coordinate_planes(net) == "xy"
    assert coordinate_planes(net.with_vertices(net.vertices + [1e-3, 0, 0])) == "y"
    assert "the net is symmetric in x = " in on_dome.remarks[0]
    assert " and y = " in on_dome.remarks[0]


def test_it_is_a_sound_net_on_the_whole_surface(on_dome):
    net = on_dome.mesh
    assert not measures.flipped(net).any()
    assert len(net.connectivity.boundary_loops) == 1
    assert net.mean_edge == pytest.approx(EDGE, rel=0.1)
    away = ~np.isin(net.faces, on_dome.irregular).any(axis=1)
    assert measures.orthogonality(net)[away].mean() < 1e-2
    assert measures.planarity(net)[away].mean() < 2e-3
    (line,) = on_dome.border
    assert misses(line, X) < ROUNDING
    # All of it is covered.
    assert np.abs(line).max(axis=0)[:2] == pytest.approx([15, 10])
    assert (np.abs(net.vertices).max(axis=0)[:2] > [15, 10]).all()


def test_without_it_a_net_is_not(on_dome):
    points, faces = triangles(dome, 40, 28)
    plain = aligned(points, faces, edge=EDGE).mesh
    assert misses(plain.vertices, X) > 1e-4


def test_a_plane_that_is_no_plane_of_coordinates_is_found():
    points, faces = triangles(dome, 31, 21)
    surface = one_surface(turned(points, 25.0) + [7, 3, 1], faces)
    said = []
    found = mirrors_of(surface, "auto", EDGE, said)
    normals = np.abs(turned(np.eye(3)[:2], 25.0) @ np.array([m.normal for m in found]).T)
    np.testing.assert_allclose(np.sort(normals.ravel()), [0, 0, 1, 1], atol=1e-4)
    assert "across (" in said[0]
    whole = symmetric_surface(surface, found)
    assert misses(whole.points, found[0]) < ROUNDING
    assert whole.areas.sum() == pytest.approx(surface.areas.sum(), rel=1e-3)
    assert whole.areas.min() > 0


def test_strokes_and_singular_vertices_are_mirrored_too():
    points, faces = triangles(dome, 31, 21)
    height = dome(np.array([0.6]), np.array([0.6]))[2][0]
    given = Singular(np.array([[3.0, 2.0, height]]), np.array([3]))
    net = aligned(points, faces, edge=EDGE, singularities=given, symmetry="x,y")
    assert net.mesh.connectivity.face_valence[net.irregular].tolist() == [3] * 4
    assert misses(net.mesh.vertices, X) < ROUNDING


def test_a_net_that_follows_its_border_is_symmetric():
    points, faces = triangles(dome, 31, 21)
    net = aligned(points, faces, edge=EDGE, border="follow", symmetry="y")
    assert misses(net.mesh.vertices, Y) < ROUNDING
    assert np.abs(net.mesh.vertices[:, 0]).max() == pytest.approx(15.0)


def test_diagonals_may_lie_in_the_planes_all_along():
    """As those of asymptotic lines do, which cross them at 45 degrees."""
    points, faces = triangles(plane, 31, 25)
    points = (points - [6, 4, 0]) * 1.5
    points[:, 2] = 0.05 * (points[:, 0] ** 2 - points[:, 1] ** 2)
    net = aligned(points, faces, edge=1.5, net="asymptotic", symmetry="auto").mesh
    assert misses(net.vertices, X) < ROUNDING
    assert misses(net.vertices[net.faces].mean(axis=1), Y) < ROUNDING
    assert net.connectivity.regular[~net.connectivity.boundary_vertices].all()
    ends = net.vertices[net.connectivity.edges]
    assert not (np.abs(ends[..., 0]) < 0.1).all(axis=1).any()


def test_quarters_of_a_turn_leave_a_net_with_diagonal_planes_as_it_is():
    def star(u, v):
        x, y = 24 * u - 12, 24 * v - 12
        return x, y, 5 - 0.014 * (x**2 + y**2) + 1e-4 * x**2 * y**2

    points, faces = triangles(star, 41, 41)
    made = aligned(points, faces, edge=1.5, symmetry="x,y,xy")
    net = made.mesh
    centre = np.append((points.max(axis=0) + points.min(axis=0))[:2] / 2, 0)
    for of_net in (net.vertices, net.vertices[net.faces].mean(axis=1), made.singular.places):
        about = of_net - centre
        assert cKDTree(about).query(turned(about, 90))[0].max() < ROUNDING
    # Without the diagonals they are not found by themselves.
    other = aligned(points, faces, edge=1.5, symmetry="x,y").mesh.vertices - centre
    assert cKDTree(other).query(turned(other, 90))[0].max() > 1e-3
    points, faces = triangles(dome, 40, 28)
    with pytest.raises(
        InputError, match=r"mirrored in the plane across .* the surface is .* off itself near"
    ):
        aligned(points, faces, edge=EDGE, symmetry="x,y,xy")


def test_what_is_not_symmetric_is_said():
    points, faces = triangles(barrel, 31, 21)
    with pytest.raises(
        InputError, match=r"mirrored in the plane x = .* the surface is .* off itself near"
    ):
        aligned(points, faces, edge=EDGE, symmetry="x")
    with pytest.raises(InputError, match="symmetry: expected none, auto, x, y, z"):
        aligned(points, faces, edge=EDGE, symmetry="w")
    said = []
    assert mirrors_of(one_surface(points, faces), "auto", EDGE, said) == ()
    assert "no plane of symmetry" in said[0]


def test_an_opening_on_one_side_is_no_symmetry():
    open_ = without(*triangles(dome, 31, 21), lambda c: np.abs(c[:, :2] - [5, 0]).max(axis=1) < 2)
    found = mirrors_of(one_surface(*open_), "auto", EDGE, [])
    assert [str(mirror)[:4] for mirror in found] == ["y = "]


@pytest.mark.parametrize("size", [1e-3, 1.0, 1e5])
def test_corners_as_good_as_in_the_plane_serve_both_sides(size):
    mirror = Mirror(np.array([1.0, 0.0, 0.0]), np.zeros(3))
    points = size * np.array([(1e-11, 0, 0), (0, 1, 0), (1, 0, 0)])
    both, triangles = _doubled(points, np.array([[0, 1, 2]]), mirror)
    assert len(both) == 4 and not both[:2, 0].any()
    assert triangles.tolist() == [[0, 1, 2], [3, 1, 0]]
