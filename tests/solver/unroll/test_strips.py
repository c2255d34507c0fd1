"""Strips along polylines: exact patterns, exact refolding, and what they measure."""

import numpy as np
import pytest

from solver.errors import InputError
from solver.mesh.quadmesh import unit_rows
from solver.unroll.axes import arc_turns, strip_axes
from solver.unroll.corner import Corners
from solver.unroll.measures import fitted_circle, straightness, strip_measures
from solver.unroll.planes import developable_strip
from solver.unroll.strip import Strip
from solver.unroll.twisted import twisted_strip
from tests.meshes import helicoid, scherk

RADIUS = 7.0


def wild(seed=0, count=12):
    """A crooked polyline and directions near z."""
    random = np.random.default_rng(seed)
    points = np.cumsum([1, 0, 0] + 0.3 * random.normal(size=(count, 3)), axis=0)
    return points, unit_rows([0, 0, 1.0] + 0.2 * random.normal(size=(count, 3)))


def on_sphere(count=14):
    """A crooked polyline on a sphere about the origin, and the directions to its centre."""
    s = np.linspace(0, 1.4, count)
    points = np.stack([np.cos(s), np.sin(s), 0.3 * np.sin(3 * s)], axis=1)
    points = RADIUS * unit_rows(points)
    return points, -unit_rows(points)


def helix(count=25, pitch=0.7):
    """Points of a helix on a cylinder, its principal normals and binormals."""
    s = np.linspace(0, 4, count)
    points = np.stack([np.cos(s), np.sin(s), pitch * s], axis=1)
    inward = np.stack([-np.cos(s), -np.sin(s), 0 * s], axis=1)
    tangent = unit_rows(np.stack([-np.sin(s), np.cos(s), pitch + 0 * s], axis=1))
    return points, inward, np.cross(tangent, inward)


def as_pairs(strip):
    return np.stack([strip.points, strip.rulings], axis=1)


@pytest.mark.parametrize("share", [0.0, 0.5, -0.3])
def test_rulings_make_the_pattern_turn_exactly_as_wanted(share):
    points, normals = wild()
    along = unit_rows(np.diff(points, axis=0))
    corners = Corners(along[:-1], along[1:], normals[1:-1])
    turns = share * 2 * corners.half_turn
    strip = twisted_strip(points, normals, turns)
    assert np.abs(strip.turns[1:-1] - turns).max() <= 1e-14


def test_planes_along_two_edges_only():
    points, normals = wild(count=3)
    strip = developable_strip(points, normals, np.zeros(1))
    assert abs(strip.turns[1]) <= 1e-14
    assert np.abs(strip.twists).max() <= 1e-12


@pytest.mark.parametrize("share", [None, 0.0, 0.4])
def test_planes_make_the_pattern_turn_exactly_and_do_not_twist(share):
    points, _, upright = helix()
    upright = unit_rows(upright + 0.1 * np.random.default_rng(3).normal(size=upright.shape))
    along = unit_rows(np.diff(points, axis=0))
    corners = Corners(along[:-1], along[1:], upright[1:-1])
    turns = None if share is None else share * 2 * corners.half_turn
    strip = developable_strip(points, upright, turns)
    if turns is not None:
        assert np.abs(strip.turns[1:-1] - turns).max() <= 1e-13
    assert np.abs(strip.twists).max() <= 1e-12
    measured = strip_measures(strip, 0.1, upright)
    assert measured.gap <= 1e-12


@pytest.mark.parametrize("make", [developable_strip, twisted_strip])
@pytest.mark.parametrize("seed", [0, 1, 2])
def test_the_pattern_folds_back_into_the_strip(make, seed):
    points, normals = wild(seed)
    strip = make(1000 * points, normals)
    assert np.abs(strip.refolded() - as_pairs(strip)).max() <= 1e-9
    lengths = np.linalg.norm(np.diff(strip.flat_points, axis=0), axis=1)
    assert lengths == pytest.approx(strip.lengths, rel=1e-12)
    bent = strip.bends.copy()
    bent[3] += 1e-3
    object.__setattr__(strip, "bends", bent)
    assert np.abs(strip.refolded() - as_pairs(strip)).max() > 0.1


def test_the_gap_is_that_of_the_outer_edges():
    """Rulings apart by t on an edge of length a end a sqrt(1 + (t w / a)^2) apart in space."""
    points = np.array([[0.0, 0, 0], [2, 0, 0], [5, 0, 0]])
    angles = np.array([0.0, 0.2, 0.2])
    rulings = np.stack([0 * angles, -np.sin(angles), np.cos(angles)], axis=1)
    measured = strip_measures(Strip(points, rulings), 0.8, rulings)
    assert measured.gap == pytest.approx(np.hypot(2, 2 * 0.4 * np.sin(0.1)) - 2, rel=1e-9)


def test_normals_of_a_sphere_make_a_cone_that_unrolls_to_an_arc_of_its_radius():
    points, inward = on_sphere()
    for strip in (
        developable_strip(points, inward, arc_turns(points, RADIUS)),
        twisted_strip(points, inward, arc_turns(points, RADIUS)),
    ):
        assert strip.rulings[1:-1] == pytest.approx(inward[1:-1], abs=1e-7)
        measured = strip_measures(strip, 0.5, inward)
        assert measured.radius == pytest.approx(RADIUS, rel=1e-12)
        assert measured.radius_spread <= 1e-12
        assert measured.gap <= 1e-12
        assert measured.admissible_width == pytest.approx(2 * RADIUS, rel=1e-2)


def test_the_arc_turns_to_the_side_of_the_centre():
    points, inward = on_sphere()
    turned = twisted_strip(points, -inward, arc_turns(points, -RADIUS))
    assert (turned.turns[1:-1] < 0).all()
    assert (twisted_strip(points, inward, arc_turns(points, RADIUS)).turns[1:-1] > 0).all()


def test_a_lying_strip_along_a_helix_is_its_cylinder():
    points, inward, binormal = helix()
    strip = developable_strip(points, binormal)
    measured = strip_measures(strip, 0.2, binormal)
    assert measured.straightness <= 1e-13 * measured.length
    assert abs(strip.normals[5] @ inward[5]) > 0.99
    # rulings of the cylinder are its generators
    assert np.abs(strip.rulings[1:-1, 2]).min() > 0.999
    assert measured.smallest_bend_radius == pytest.approx(1.0, rel=0.02)


# By symmetry the helix of a helicoid unrolls straight along the normals too.
@pytest.mark.parametrize(("mesh", "along_normals"), [(scherk(), 1e-5), (helicoid(), 0.0)])
def test_asymptotic_lines_unroll_straight(mesh, along_normals):
    axes = strip_axes(mesh, np.inf)
    line = np.arange(15) + 15 * 3 if len(mesh.vertices) == 225 else np.arange(17) * 13 + 2
    points, normals = mesh.vertices[line], axes[line]
    strip = twisted_strip(points, normals, arc_turns(points, np.inf))
    measured = strip_measures(strip, 0.05, normals)
    assert measured.straightness <= 1e-13
    assert measured.lean_deg <= 3.0
    assert straightness(twisted_strip(points, normals).flat_points) >= along_normals


def test_star_spheres_give_the_axes_of_a_net_on_a_sphere():
    mesh = scherk()
    mesh = mesh.with_vertices(5 * unit_rows(mesh.vertices + [0, 0, 4.0]))
    inner = mesh.connectivity.stars[:, 0]
    radial = unit_rows(mesh.vertices[inner])
    sign = np.sign(np.einsum("ij,ij->i", radial, mesh.vertex_normals[inner]))[0]
    found = strip_axes(mesh, -sign * 5.0)[inner]
    assert np.abs(found - sign * radial).max() <= 1e-12


def test_a_closed_strip_has_the_same_ruling_at_both_ends():
    s = np.linspace(0, 2 * np.pi, 13)
    points = np.stack([np.cos(s), np.sin(s), 0.2 * np.sin(2 * s)], axis=1)
    points[-1] = points[0]
    normals = unit_rows(points)
    for strip in (
        developable_strip(points, normals, closed=True),
        twisted_strip(points, normals, closed=True),
    ):
        assert strip.rulings[0] == pytest.approx(strip.rulings[-1], abs=1e-12)


def test_rulings_that_meet_are_found_with_the_width_that_would_do():
    points = np.array([[0, 0, 0], [1, 0, 0], [2, 0, 0.0]])
    lean = np.array([[0.1, 0, 1], [-0.1, 0, 1], [-0.1, 0, 1]])
    width, edge = Strip(points, unit_rows(lean)).admissible_width()
    assert (width, edge) == (pytest.approx(10.0), 0)
    assert Strip(points, np.tile([0, 0, 1.0], (3, 1))).admissible_width()[0] == np.inf


@pytest.mark.parametrize("seed", range(4))
def test_a_strip_and_its_mirror_image_get_rulings_as_far_apart(seed):
    """Where those nearest to the normals meet, planes on both sides of these are tried."""
    points, normals = wild(seed, 8)
    near = developable_strip(points, normals, np.zeros(6)).admissible_width()[0]
    mirror = np.array([1.0, -1.0, 1.0])
    one, other = (
        developable_strip(points * by, normals * by, np.zeros(6), width=3 * near)
        for by in (1.0, mirror)
    )
    assert one.admissible_width()[0] > near
    assert one.admissible_width()[0] == pytest.approx(other.admissible_width()[0])


@pytest.mark.parametrize("seed", [6, 7])
def test_planes_that_lean_in_turn_make_room_where_rulings_meet(seed):
    points, normals = wild(seed, 8)
    near = developable_strip(points, normals, np.zeros(6)).admissible_width()[0]
    wide = developable_strip(points, normals, np.zeros(6), width=1.25 * near)
    assert wide.admissible_width()[0] >= 1.25 * near


def test_collinear_points_leave_the_planes_alone():
    points = np.stack([np.arange(6.0), np.zeros(6), np.zeros(6)], axis=1)
    normals = unit_rows(np.stack([0 * points[:, 0], 0.02 * points[:, 0], 1 + 0 * points[:, 0]], 1))
    strip = developable_strip(points, normals, np.zeros(4))
    assert np.abs(strip.twists).max() <= 1e-12
    assert np.abs(strip.bends).max() <= 1e-12
    assert straightness(strip.flat_points) <= 1e-12
    twisted = twisted_strip(points, normals, np.zeros(4))
    assert np.einsum("ij,ij->i", twisted.rulings, normals).min() > 1 - 1e-12


def test_circles_are_fitted_from_flat_to_round():
    for radius, angle, near in ((1.0, 3.0, 1e-14), (1e3, 1e-2, 1e-10), (5e6, 1e-5, 1e-5)):
        s = np.linspace(-angle, angle, 9)
        points = radius * np.stack([np.sin(s), 1 - np.cos(s)], axis=1) + [3.0, -2.0]
        found, spread = fitted_circle(points)
        assert found == pytest.approx(radius, rel=near)
        assert spread <= 1e-9
    assert fitted_circle(np.array([[0, 0], [1, 0], [2, 0.0]]))[0] == np.inf


def test_bad_strips_are_refused():
    points, normals = wild()
    with pytest.raises(InputError, match="edge 3 has no length"):
        repeated = points.copy()
        repeated[4] = repeated[3]
        twisted_strip(repeated, normals)
    with pytest.raises(InputError, match="at least 2 points"):
        Strip(points[:1], normals[:1])
    with pytest.raises(InputError, match="ruling at point 0 lies along the axis"):
        Strip(points[:2], unit_rows(points[1:2] - points[:1]).repeat(2, axis=0))
    with pytest.raises(InputError, match="more than half the longest edge"):
        arc_turns(points, 0.1)


def test_straightness_is_the_same_wherever_the_points_are():
    points = np.array([[0.0, 1.0], [1.0, -1.0], [2.0, -1.0], [3.0, 1.0]])
    for away in ([0.0, 0.0], [10.0, 7.0]):
        assert straightness(points + away) == pytest.approx(1.0, rel=1e-12)
