"""Nets sampled from surfaces: on the surface, evenly, to the border, joined, or refused."""

from __future__ import annotations

import tracemalloc

import numpy as np
import pytest

from solver import QuadMesh
from solver.analysis import measures
from solver.errors import InputError
from solver.mesh.border import straight_corners
from solver.mesh.grid import grid_mesh, grid_of
from solver.mesh.intersections import crossing_faces
from solver.mesh.primitives import rectangle
from solver.mesh.sampling import ParametricSurface, sampled

RADIUS = 1.4


def wave(u, v):
    return np.stack([u, v, 0.3 * np.sin(u) * np.cos(v)], axis=1)


def uneven(u, v):
    return wave(4 * u**3, v)


def ring(radius=RADIUS, count=720):
    angle = np.linspace(0, 2 * np.pi, count, endpoint=False)
    return wave(2 + radius * np.cos(angle), 1.5 + radius * np.sin(angle))


def disc(u, v):
    return (u - 2) ** 2 + (v - 1.5) ** 2 < RADIUS**2


WHOLE = ParametricSurface(wave, (0.0, 4.0), (0.0, 3.0))
DISC = ParametricSurface(wave, (0.6, 3.4), (0.1, 2.9), disc, (ring(),))


def test_vertex_numbers_and_both_spacings():
    even = sampled([WHOLE], counts=(9, 7), spacing="parameter").mesh
    u, v = np.meshgrid(np.linspace(0, 4, 9), np.linspace(0, 3, 7), indexing="ij")
    np.testing.assert_allclose(even.vertices, wave(u.ravel(), v.ravel()), atol=1e-14)
    surface = ParametricSurface(uneven, (0.0, 1.0), (0.0, 3.0))
    steps = []
    for spacing in ("parameter", "length"):
        points = sampled([surface], counts=(17, 7), spacing=spacing).mesh.vertices
        lengths = np.linalg.norm(np.diff(points.reshape(17, 7, 3), axis=0), axis=2)
        steps.append(lengths.min() / lengths.max())
    assert steps[0] < 0.01
    assert steps[1] > 0.9


@pytest.mark.parametrize("edge", [0.5, 0.2, 0.11])
def test_edge_length(edge):
    assert sampled([WHOLE], edge=edge).mesh.mean_edge == pytest.approx(edge, rel=0.06)


def test_closed_direction_repeats_nothing():
    def tube(u, v):
        return np.stack([np.cos(u), np.sin(u), v], axis=1)

    mesh = sampled([ParametricSurface(tube, (0, 2 * np.pi), (0, 2))], counts=(12, 5)).mesh
    assert (len(mesh.vertices), len(mesh.faces)) == (60, 48)
    assert grid_of(mesh).closed_u


def test_surfaces_with_other_parameters_meet_vertex_by_vertex():
    def beyond(u, v):
        return wave(4 + 2 * u**1.3, 3 - v)

    surfaces = [WHOLE, ParametricSurface(beyond, (0.0, 1.0), (0.0, 3.0))]
    net = sampled(surfaces, edge=0.25)
    assert net.remarks == ()
    rows = grid_of(net.mesh).numbers.shape
    assert sorted(rows) == [13, 25]
    assert net.mesh.vertices[:, 0].max() == pytest.approx(6.0)
    normals = net.mesh.face_normals[:, 2]
    assert (normals > 0).all() or (normals < 0).all()
    by_counts = sampled(surfaces, counts=(9, 7)).mesh
    assert sorted(grid_of(by_counts).numbers.shape) == [7, 17]


def test_surfaces_that_do_not_meet_are_said():
    far = ParametricSurface(lambda u, v: wave(u + 9, v), (0.0, 4.0), (0.0, 3.0))
    net = sampled([WHOLE, far], edge=0.5)
    assert net.mesh.connectivity.components.max() == 1
    assert "2 separate parts" in net.remarks[0]


@pytest.mark.parametrize("edge", [0.1, 0.2, 0.35])
def test_a_border_is_met(edge):
    mesh = sampled([DISC], edge=edge).mesh
    rim = mesh.vertices[mesh.connectivity.boundary_vertices]
    radii = np.hypot(rim[:, 0] - 2, rim[:, 1] - 1.5)
    np.testing.assert_allclose(radii, RADIUS, atol=1e-4)
    assert not measures.flipped(mesh).any()
    assert measures.edge_ratio(mesh) > 0.3
    assert mesh.connectivity.components.max() == 0


def level(u, v):
    return np.stack([u, v, 0 * u], axis=1)


def star(edge):
    """A level star with seven points, and how many quads of that edge begin inside of it."""

    def reach(angle):
        return 1 + 0.7 * np.cos(7 * angle)

    def inside(u, v):
        return np.hypot(u, v) < reach(np.arctan2(v, u))

    angle = np.linspace(0, 2 * np.pi, 720, endpoint=False)
    line = level(reach(angle) * np.cos(angle), reach(angle) * np.sin(angle))
    ends = (-2.0, 2.0), (-2.0, 2.0)
    whole = sampled([ParametricSurface(level, *ends)], edge=edge).mesh
    centres = whole.vertices[whole.faces].mean(axis=1)
    return ParametricSurface(level, *ends, inside, (line,)), int(inside(*centres[:, :2].T).sum())


def test_all_quads_without_room_at_a_border_are_left_out_and_said():
    surface, cells = star(0.2)
    net = sampled([surface], edge=0.2)
    assert (net.mesh.face_area_vectors[:, 2] > 0).all()
    assert measures.flipped(net.mesh).sum() <= straight_corners(net.mesh)
    left_out = cells - len(net.mesh.faces)
    assert left_out > 0
    assert f"{left_out} quads at the border had no room and were left out" in net.remarks[0]
    with pytest.raises(InputError, match="no quad has room inside; take a finer sampling"):
        sampled([star(0.3)[0]], edge=0.3)


def test_a_cut_face_may_be_dropped_instead():
    mesh = sampled([DISC], edge=0.2, outside="drop").mesh
    assert disc(mesh.vertices[:, 0], mesh.vertices[:, 1]).all()
    kept = sampled([ParametricSurface(wave, DISC.u, DISC.v)], edge=0.2).mesh.vertices
    distance = np.abs(mesh.vertices[:, None] - kept[None]).sum(axis=2).min(axis=1)
    assert distance.max() == 0.0


def test_corners_of_a_border_are_kept():
    square = np.array([[1.0, 0.5], [3.0, 0.7], [2.8, 2.6], [0.9, 2.3]])
    sides = [np.linspace(square[k], square[(k + 1) % 4], 60)[:-1] for k in range(4)]
    path = np.concatenate(sides)
    following = np.roll(square, -1, axis=0) - square

    def inside(u, v):
        arms = np.stack([u, v], axis=1)[:, None] - square
        return (following[:, 0] * arms[..., 1] - following[:, 1] * arms[..., 0] > 0).all(axis=1)

    border = wave(path[:, 0], path[:, 1])
    surface = ParametricSurface(wave, (0.9, 3.0), (0.5, 2.6), inside, (border,))
    mesh = sampled([surface], edge=0.15).mesh
    for corner in wave(square[:, 0], square[:, 1]):
        assert np.linalg.norm(mesh.vertices - corner, axis=1).min() < 1e-12


def sphere(u, v):
    return np.stack([np.cos(u) * np.cos(v), np.sin(u) * np.cos(v), np.sin(v)], axis=1)


def eight(u, v):
    return np.stack([np.cos(u), np.sin(2 * u), v], axis=1)


@pytest.mark.parametrize(
    ("surface", "settings", "words"),
    [
        (
            ParametricSurface(sphere, (0, 6.283185307), (-1.5707963268, 1.0)),
            {},
            "shrinks to a point",
        ),
        (ParametricSurface(eight, (0.1, 6.0), (0.0, 1.0)), {"counts": (30, 5)}, "meets itself"),
        (WHOLE, {"counts": (1, 5)}, "at least 2 vertices along u"),
        (WHOLE, {"counts": (5, 5), "edge": 0.2}, "either counts or an edge"),
        (WHOLE, {"counts": None, "edge": -0.2}, "edge: expected a number above 0"),
        (WHOLE, {"counts": None, "edge": 1e-5}, "more than"),
        (WHOLE, {"spacing": "random"}, "length or parameter"),
        (WHOLE, {"outside": "keep"}, "snap or drop"),
        (DISC, {"counts": (3, 3), "outside": "drop"}, "no quad lies inside"),
    ],
)
def test_what_cannot_be_sampled_gets_one_line(surface, settings, words):
    with pytest.raises(InputError, match=words) as caught:
        sampled([surface], **{"counts": (9, 7), **settings})
    assert "\n" not in str(caught.value)


def test_a_part_of_a_face():
    part = ParametricSurface(sphere, (0, 2 * np.pi), (-np.pi / 2, np.pi / 2)).part(
        (0, 1), (0.1, 0.9)
    )
    mesh = sampled([part], counts=(16, 9)).mesh
    assert np.abs(mesh.vertices[:, 2]).max() == pytest.approx(np.sin(0.4 * np.pi))
    with pytest.raises(InputError, match="0 <= first < last <= 1"):
        WHOLE.part((0.5, 0.2), (0, 1))


def test_a_part_of_a_trimmed_face_is_cut_straight():
    part = DISC.part((0, 0.5), (0, 1))
    mesh = sampled([part], edge=0.2).mesh
    rim = mesh.vertices[mesh.connectivity.boundary_vertices]
    on_cut = rim[:, 0] == 2.0
    assert on_cut.sum() > 5
    radii = np.hypot(rim[~on_cut, 0] - 2, rim[~on_cut, 1] - 1.5)
    np.testing.assert_allclose(radii, RADIUS, atol=1e-4)
    assert mesh.vertices[:, 0].max() == 2.0


def test_straight_corners_are_counted():
    corners = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.0, 1.0, 0.0]])
    assert straight_corners(QuadMesh(corners, np.array([[0, 1, 2, 3]]))) == 1
    assert straight_corners(rectangle(3, 3)) == 0


def test_crossing_faces():
    flat = rectangle(4, 4, length=3.0, width=3.0)
    assert len(crossing_faces(flat)) == 0
    upright = flat.vertices[:, [0, 2, 1]] + [0.3, 0.2, 0.0]
    both = QuadMesh(
        np.concatenate([flat.vertices, upright]), np.concatenate([flat.faces, flat.faces + 16])
    )
    pairs = crossing_faces(both)
    assert len(pairs)
    assert ((pairs < 9).sum(axis=1) == 1).all()


def test_crossing_faces_of_a_grid_with_large_and_small_faces_take_little_memory():
    step = np.linspace(0, 1, 100) ** 4
    x, y = np.meshgrid(step, step, indexing="ij")
    mesh = grid_mesh(np.stack([x, y, 0 * x], axis=2))
    tracemalloc.start()
    assert len(crossing_faces(mesh)) == 0
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 40e6


def test_faces_of_all_sizes_that_cross_are_found():
    numbers = np.random.default_rng(5)
    corners = numbers.normal(size=(36, 1, 3)) + 10 ** numbers.uniform(
        -2, 0.5, (36, 1, 1)
    ) * numbers.normal(size=(36, 4, 3))
    mesh = QuadMesh(corners.reshape(-1, 3), np.arange(144).reshape(-1, 4))
    found = crossing_faces(mesh)
    alone = [
        [one, two]
        for one in range(36)
        for two in range(one + 1, 36)
        if len(crossing_faces(QuadMesh(mesh.vertices, mesh.faces[[one, two]])))
    ]
    assert len(alone) > 10
    assert found.tolist() == alone
