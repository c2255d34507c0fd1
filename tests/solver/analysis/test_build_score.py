"""Measures of buildability against shells where they are known by hand."""

from itertools import permutations

import numpy as np
import pytest

from examples.benchmark_shells import SHELLS, shell
from solver import InputError, QuadMesh
from solver.analysis.build_score import build_score, flatness_of_faces, joint_kinds
from solver.analysis.kinds import laid, spokes
from tests.conftest import grid_faces, wavy_grid


def squares(rows=4, columns=5, side=2.0):
    i, j = np.meshgrid(np.arange(rows) * side, np.arange(columns) * 1.0 * side, indexing="ij")
    points = np.stack([i, j, 0 * i], axis=2).reshape(-1, 3)
    return QuadMesh(points, grid_faces(rows, columns))


def test_a_floor_of_squares_is_the_easiest_to_build():
    found = build_score(squares(), 1000.0, 2)
    assert (found.planarity, found.lengths) == pytest.approx((1.0, 1.0), abs=1e-12)
    # Inside, along the border, at the corners.
    assert (found.joints, found.joint_kinds, found.sections) == (20, 3, 2)
    assert (found.length_kinds, found.panel_kinds) == (1, 1)
    assert found.length_range == pytest.approx((2000, 2000))
    assert found.area_range == pytest.approx((4, 4))


def test_flatness_of_one_bent_face():
    """Corners of a square of 2 m, two of them lifted by 0.2 m: 0.1 m off the plane each."""
    points = np.array([[0, 0, 0.2], [2, 0, 0], [2, 2, 0.2], [0, 2, 0]])
    side = np.hypot(2, 0.2)
    expected = 0.1 / (2 * side)
    found = flatness_of_faces(QuadMesh(points, np.array([[0, 1, 2, 3]])))
    assert found == pytest.approx([expected])


def test_lengths_are_judged_by_their_deviation():
    mesh = squares(2, 3)
    points = mesh.vertices * [1.5, 1, 1]
    lengths = np.array([3.0] * 3 + [2.0] * 4)
    found = build_score(mesh.with_vertices(points), 1000.0)
    assert found.lengths == pytest.approx(1 + lengths.std(ddof=1) / lengths.mean())
    assert found.length_kinds == 2 and found.panel_kinds == 1


def test_kinds_of_joints_are_those_of_all_orders():
    """Farthest first, with every order of the edges, as the benchmark says it."""
    mesh, expected = wavy_grid(5, 5, shear=0.1), 0
    by_count = {}
    for hubs in spokes(mesh):
        arms = mesh.vertices[hubs.neighbours] - mesh.vertices[hubs.vertices][:, None]
        arms /= np.linalg.norm(arms, axis=2, keepdims=True)
        by_count.setdefault(arms.shape[1], []).extend(arms)
    for count, joints in by_count.items():
        joints, orders = np.array(joints), list(permutations(range(count)))
        nearest, leader, number = np.full(len(joints), np.inf), 0, 0
        while number == 0 or nearest.max() > 0.05:
            shape = np.broadcast_to(joints[leader], joints.shape)
            away = [
                np.sqrt(((laid(joints[:, order], shape) - shape) ** 2).sum(axis=2).mean(axis=1))
                for order in orders
            ]
            nearest, number = np.minimum(nearest, np.min(away, axis=0)), number + 1
            leader = int(np.argmax(nearest))
        expected += number
    assert joint_kinds(mesh, 0.05) == expected


@pytest.mark.parametrize("name", SHELLS)
def test_shells_of_the_benchmark(name):
    mesh = shell(name)
    found = build_score(mesh, 1000.0)
    assert np.ptp(mesh.vertices[:, 0]) == pytest.approx(30)
    assert found.joints == 17**2 and found.joint_kinds > 3
    # A translational surface has flat faces; the dome is none.
    assert (found.planarity == pytest.approx(1, abs=1e-12)) == (name != "dome")


@pytest.mark.parametrize(
    ("millimetres", "sections", "words"),
    [
        (1000.0, 0, "sections: expected a whole number, 1 or more, got 0"),
        (1.0, 1, "mind the unit of the mesh"),
    ],
)
def test_what_cannot_be_scored_is_refused(millimetres, sections, words):
    with pytest.raises(InputError, match=words):
        build_score(squares(), millimetres, sections)
