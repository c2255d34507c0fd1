"""Multi-nets are exact over every rectangle, whatever their source and sampling."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from solver import InputError
from solver.mesh.grid import grid_of
from solver.multinet import (
    EllipticSystem,
    Quadric,
    confocal_conics,
    confocal_parabolas,
    elliptic_net,
    multi_net,
    reflected,
    rotational_net,
)
from solver.multinet.presets import PRESETS

TURN = Rotation.from_rotvec([0.7, -0.4, 1.1]).as_matrix()
CENTRE = np.array([3.0, -7.0, 2.0])
KINDS = {
    "ellipsoid": Quadric.ellipsoid([3.0, 2.0, 1.2], TURN, CENTRE),
    "one-sheeted hyperboloid": Quadric.one_sheeted([2.0, 1.5, 1.0], TURN, CENTRE),
    "two-sheeted hyperboloid": Quadric.two_sheeted([2.0, 1.5, 1.0], TURN, CENTRE),
}
MOVING = ("lambda", "mu", "nu")


def worst_of_all(points: np.ndarray) -> float:
    """Eq. 1 over every rectangle of (M, N, 3) points one by one, over size squared."""
    apart = points[:, :, None, None] - points[None, None]
    squares = np.einsum("ijklx,ijklx->ijkl", apart, apart)
    flat = points.reshape(-1, 3)
    size = np.linalg.norm(np.ptp(flat, axis=0))
    return float(np.abs(squares - squares.transpose(0, 3, 2, 1)).max() / size**2)


def polyline_on(quadric: Quadric, count: int = 9) -> np.ndarray:
    s = np.linspace(0, 1, count)
    if quadric.kind == "ellipsoid":
        frame = np.stack([np.cos(2 * s), np.sin(2 * s), 0.9 * s**2], axis=1)
    elif quadric.kind == "one-sheeted hyperboloid":
        frame = np.stack([2 * np.cos(2 * s), 1.5 * np.sin(2 * s), s**2], axis=1)
    else:
        frame = np.stack([3 + s, s, 0.5 + s**2], axis=1)
    return quadric.project(quadric.from_frame(frame))


@pytest.mark.parametrize("kind", KINDS)
def test_polyline_on_any_quadric_gives_an_exact_net(kind):
    quadric = KINDS[kind]
    points = polyline_on(quadric)
    assert quadric.kind == kind
    assert np.abs(quadric.value(points) - 1).max() < 1e-13
    net = multi_net(quadric, points)
    low, high = net.admissible
    first = 0.8 * low
    last = min(0.8 * high, 6.0)
    coarse = net.mesh(np.linspace(0, 1, len(points)), np.array([first, 0.0, last]))
    np.testing.assert_allclose(coarse.vertices.reshape(-1, 3, 3)[:, 1], points, atol=1e-13)
    for m, n in ((7, 5), (12, 9)):
        mesh = net.sampled(m, n, (first, last))
        assert worst_of_all(mesh.vertices.reshape(m, n, 3)) < 1e-13
    # Every line lies on the confocal quadric S_t^-1 = S^-1 + t.
    t = net.parameters(7, 5, (first, last))[1]
    grid = net.sampled(7, 5, (first, last)).vertices.reshape(7, 5, 3)
    for j, value in enumerate(t):
        confocal = Quadric(1 / (1 / quadric.curvatures + value), quadric.rotation, quadric.centre)
        assert np.abs(confocal.value(grid[:, j]) - 1).max() < 1e-11


@pytest.mark.parametrize("kind", KINDS)
def test_projection_finds_the_nearest_point(kind):
    quadric, rng = KINDS[kind], np.random.default_rng(3)
    start = polyline_on(quadric)
    moved = start + 0.2 * rng.normal(size=start.shape)
    foot = quadric.project(moved)
    assert np.abs(quadric.value(foot) - 1).max() < 1e-12
    normal = quadric.to_frame(foot) * quadric.curvatures @ quadric.rotation.T
    offset = moved - foot
    lengths = np.linalg.norm(normal, axis=1) * np.linalg.norm(offset, axis=1)
    assert (np.linalg.norm(np.cross(normal, offset), axis=1) < 1e-9 * lengths).all()
    for _ in range(200):
        other = quadric.project(foot + 0.05 * rng.normal(size=foot.shape))
        distance = np.linalg.norm(other - moved, axis=1)
        assert (distance >= np.linalg.norm(offset, axis=1) - 1e-12).all()


@pytest.mark.parametrize("name", PRESETS)
def test_presets_run_smoothly_and_closed_ones_return(name):
    chosen = PRESETS[name]
    first, second = chosen.curve(np.linspace(0.0, 1.0, 201))
    # Places from 0 to 1 are one sign of a coordinate; both run 4 of them at most.
    assert (first >= 0.0).all() and (first <= 1.0).all()
    assert max(np.abs(np.diff(first)).max(), np.abs(np.diff(second)).max()) <= 4 / 200 + 1e-9
    assert (first[-1] == pytest.approx(first[0])) == (chosen.closed or name == "arch")
    around = (second[-1] - second[0]) / 4
    assert (around == pytest.approx(round(around), abs=1e-12)) == chosen.closed


@pytest.mark.parametrize("make", [Quadric.ellipsoid, Quadric.one_sheeted, Quadric.two_sheeted])
def test_a_quadric_stands_upright_in_the_origin_unless_told(make):
    quadric = make((3.0, 2.0, 1.5))
    points = np.random.default_rng(7).normal(size=(5, 3))
    np.testing.assert_array_equal(quadric.to_frame(points), points)


@pytest.mark.parametrize(("moving", "name"), list(itertools.product(MOVING, PRESETS)))
def test_every_preset_and_moving_coordinate_is_exact(moving, name):
    chosen = PRESETS[name]
    net = elliptic_net((9, 5, 2), moving, chosen.curve, unfolded=True, closed=chosen.closed)
    fine = net.sampled(14, 11)
    points = fine.vertices.reshape(14, 11, 3)
    assert worst_of_all(points) < 1e-14
    assert worst_of_all(points[::3, ::2]) < 1e-14
    assert worst_of_all(points[[0, 1, 5, 13]][:, [2, 3, 10]]) < 1e-14
    # The same smooth net, sampled anew, passes through the same lines.
    s, t = net.parameters(14, 11)
    np.testing.assert_allclose(net.points(s[[2, 9]], t[[1, 7]]), points[[2, 9]][:, [1, 7]])
    # The moving coordinate is constant along each line of the family.
    values = EllipticSystem(9, 5, 2).coordinates(points)[..., MOVING.index(moving)]
    assert np.abs(values - t).max() < 1e-12 * 9


@pytest.mark.parametrize("moving", MOVING)
def test_equation_three_by_values(moving):
    """The net equals Eq. 3 written out, for a curve given by coordinate values."""

    def curve(s):
        first = {"lambda": -4 + s, "mu": 1 + 3 * s, "nu": 1 + 3 * s}[moving]
        second = {"lambda": -8 + s**2, "mu": -8 + s**2, "nu": -4 + s**2}[moving]
        return first, second

    net = elliptic_net((9, 5, 2), moving, curve)
    s, t = net.parameters(6, 5)
    k = [np.broadcast_to(v, (6, 5)) for v in (curve(s)[0][:, None], curve(s)[1][:, None])]
    k.insert(MOVING.index(moving), np.broadcast_to(t, (6, 5)))
    a, b, c = 9, 5, 2
    expected = [
        np.sqrt((e + k[0]) * (e + k[1]) * (e + k[2]) / ((e - f) * (e - g)))
        for e, f, g in ((a, b, c), (b, a, c), (c, a, b))
    ]
    np.testing.assert_allclose(net.points(s, t), np.stack(expected, axis=2), rtol=1e-12)
    system = EllipticSystem(a, b, c)
    np.testing.assert_allclose(system.points(np.stack(k, axis=2)), np.stack(expected, axis=2))
    np.testing.assert_allclose(
        system.coordinates(net.points(s, t)), np.stack(k, axis=2), atol=1e-12
    )


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ((-2.5, -4.0, -6.0), "lambda: expected -2 <= lambda"),
        ((1.0, -5.5, -6.0), "mu: expected -5 <= mu <= -2, got -5.5"),
        ((1.0, -4.0, -9.5), "nu: expected -9 <= nu <= -5, got -9.5"),
    ],
)
def test_values_that_no_point_has_are_refused(values, words):
    with pytest.raises(InputError, match=words):
        EllipticSystem(9, 5, 2).points(values)


def test_reflection_merges_the_seams():
    chosen = PRESETS["wave"]
    net = elliptic_net((9, 5, 2), "mu", chosen.curve, unfolded=True)
    part = net.sampled(8, 6, (-5, -2))
    whole = reflected(part, "xyz")
    # Both curve ends and both t ends are seams, so the eight parts are one closed tube.
    assert (whole.faces[: len(part.faces)] == part.faces).all()
    np.testing.assert_allclose(whole.vertices[: len(part.vertices)], part.vertices, atol=1e-14)
    assert len(whole.faces) == 8 * len(part.faces)
    assert whole.connectivity.components.max() == 0
    used = np.sort(np.round(whole.vertices, 9), axis=0)
    assert len(np.unique(np.round(whole.vertices, 9), axis=0)) == len(used)
    for axis in range(3):
        flip = np.where(np.arange(3) == axis, -1.0, 1.0)
        images = {tuple(row) for row in np.round(whole.vertices * flip, 9) + 0.0}
        assert images == {tuple(row) for row in np.round(whole.vertices, 9) + 0.0}


def test_a_reflected_grid_is_a_multi_net_as_a_whole():
    chosen = PRESETS["wave"]
    net = elliptic_net((9, 5, 2), "lambda", chosen.curve, unfolded=True)
    half = reflected(net.sampled(8, 6), "x")
    assert half.vertices[:, 0].min() == -half.vertices[:, 0].max()
    assert worst_of_all(grid_of(half).points(half)) < 1e-14
    ring = reflected(half, "y")
    grid = grid_of(ring)
    assert grid.closed_u or grid.closed_v
    assert worst_of_all(grid.points(ring)) < 1e-14


def test_plane_and_rotational_nets_are_exact():
    for angles in ((0, 360), (10, 80)):
        conics = confocal_conics(4.0, 1.0, angles=angles).sampled(12, 7)
        assert worst_of_all(grid_of(conics).points(conics)) < 1e-14
        assert np.abs(conics.vertices[:, 2]).max() == 0
    x, y = conics.vertices[:, 0], conics.vertices[:, 1]
    # Distances to the foci: their sum is constant along ellipses, difference along hyperbolas.
    foci = [np.hypot(x - f, y).reshape(12, 7) for f in (-np.sqrt(3), np.sqrt(3))]
    assert np.ptp(foci[0] + foci[1], axis=0).max() < 1e-13
    assert np.ptp(foci[0] - foci[1], axis=1).max() < 1e-13
    parabolas = confocal_parabolas([0.5, 1, 2, 3.5], [-1, -0.2, 0.4, 2])
    assert worst_of_all(parabolas.vertices.reshape(4, 4, 3)) < 1e-14
    profile = [(3, 0), (2, 1), (2.5, 1.7), (1, 4)]
    for angles in ((0, 360), (-20, 200)):
        assert (
            worst_of_all(rotational_net(profile, 9, angles=angles).vertices.reshape(9, 4, 3))
            < 1e-14
        )


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: elliptic_net((2, 5, 9), "mu", PRESETS["loop"].curve), "a > b > c"),
        (lambda: elliptic_net((9, 5, 2), "rho", PRESETS["loop"].curve), "moving"),
        (lambda: _net().sampled(5, 5, (-3, 1)), "-2 <= T0 < T1 <= inf"),
        (lambda: _net().sampled(5, 5, (1, 0)), "T0 < T1"),
        (lambda: _net().sampled(1, 5), "sampling"),
        (lambda: elliptic_net((9, 5, 2), "lambda", lambda s: (s, s)).sampled(4, 4), "mu: expected"),
        (lambda: Quadric([-1, -1, -1]), "no real points"),
        (lambda: Quadric([1, 1, 1], 2 * np.eye(3)), "orthonormal"),
        (lambda: multi_net(KINDS["ellipsoid"], [[0, 0, 0], [1, 0, 0]]), "off it"),
        (lambda: multi_net(KINDS["ellipsoid"], [[0, 0, 0]]), "at least 2"),
        (lambda: multi_net(Quadric.two_sheeted([1, 1, 1]), [[1, 0, 0], [-1, 0, 0]]), "one sheet"),
        (lambda: reflected(_net().sampled(4, 4), "xq"), "x, y, z"),
        (lambda: rotational_net([(0, 0), (1, 1)], 5), "positive radii"),
        (lambda: confocal_conics(1, 4), "a > b"),
    ],
)
def test_bad_input_is_one_clear_line(call, words):
    with pytest.raises(InputError, match=words) as caught:
        call()
    assert "\n" not in str(caught.value)


def _net():
    return elliptic_net((9, 5, 2), "lambda", PRESETS["wave"].curve, unfolded=True)


def test_the_admissible_range_is_said_and_is_sharp():
    for quadric in KINDS.values():
        net = multi_net(quadric, polyline_on(quadric))
        low, high = net.admissible
        inside = 0.999999 * np.array([low, min(high, 1e3)])
        assert np.isfinite(net.points(np.array([0.0, 1.0]), inside)).all()
        for outside in (1.0001 * low, 1.0001 * high):
            if np.isfinite(outside):
                with pytest.raises(InputError, match="narrow the range"):
                    net.points(np.array([0.0]), np.array([outside]))


@pytest.mark.parametrize("make", [Quadric.ellipsoid, Quadric.one_sheeted, Quadric.two_sheeted])
def test_lines_hit_a_quadric(make):
    turn = Rotation.from_euler("xyz", [20, -40, 70], degrees=True).as_matrix()
    quadric = make((3.0, 2.0, 1.5), turn, (0.5, -1.0, 2.0))
    random = np.random.default_rng(4)
    found = 0
    for _ in range(50):
        origin, direction = random.normal(size=(2, 3)) * [[4.0], [1.0]]
        hits = quadric.hits(origin, direction)
        along = (hits - origin) @ direction / (direction @ direction)
        assert np.allclose(origin + along[:, None] * direction, hits)
        assert (np.diff(along) > 0).all()
        assert np.allclose(quadric.value(hits), 1.0, atol=1e-9)
        found += len(hits)
    assert found >= 10
    away = quadric.from_frame(np.array([0.0, 50.0, 50.0]))
    if make == Quadric.ellipsoid:
        assert len(quadric.hits(away, turn[:, 0])) == 0
