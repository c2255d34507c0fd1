"""Triangles round the crown of a dome."""

import numpy as np
import pytest

from solver.align.align import aligned
from solver.mesh.poles import triangles_round_poles
from solver.mesh.sampling import ParametricSurface
from solver.mesh.triangles import sound_triangles

RADIUS = 12.0


def ball(first, last, around=(0.0, 2 * np.pi), swapped=False):
    """A part of a ball between two latitudes, its outer side shown."""

    def evaluate(u, v):
        u, v = (v, -u) if swapped else (u, v)
        return RADIUS * np.stack([np.cos(v) * np.cos(u), np.cos(v) * np.sin(u), np.sin(v)], axis=1)

    if swapped:
        return ParametricSurface(evaluate, (-last, -first), around, name="ball")
    return ParametricSurface(evaluate, around, (first, last), name="ball")


def areas(points, triangles):
    one, two = (points[triangles[:, k]] - points[triangles[:, 0]] for k in (1, 2))
    return 0.5 * np.cross(one, two)


@pytest.mark.parametrize("swapped", [False, True])
@pytest.mark.parametrize("around", [(0.0, 2 * np.pi), (0.0, 1.2)])
def test_rings_are_even_whole_and_show_the_outer_side(swapped, around):
    points, triangles = triangles_round_poles(ball(0.7, np.pi / 2, around, swapped), 0.5)
    np.testing.assert_allclose(np.linalg.norm(points, axis=1), RADIUS, rtol=1e-12)
    across = areas(points, triangles)
    assert (np.einsum("ij,ij->i", across, points[triangles[:, 0]]) > 0).all()
    wanted = (around[1] - around[0]) * RADIUS**2 * (1 - np.sin(0.7))
    assert np.linalg.norm(across, axis=1).sum() == pytest.approx(wanted, rel=0.01)
    sides = np.linalg.norm(points[triangles] - points[np.roll(triangles, 1, axis=1)], axis=2)
    assert 0.2 < sides.min()
    assert sides.max() < 1.0
    assert len(sound_triangles(points, triangles)[1]) == len(triangles)


def test_a_whole_ball_has_no_border():
    _, triangles = triangles_round_poles(ball(-np.pi / 2, np.pi / 2), 2.0)
    sides = np.sort(np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    assert (np.unique(sides, axis=0, return_counts=True)[1] == 2).all()


def test_others_are_left_to_quads():
    assert triangles_round_poles(ball(0.2, 1.2), 1.0) is None


def test_a_dome_drawn_as_one_face_gets_a_net():
    made = aligned(*triangles_round_poles(ball(0.73, np.pi / 2), 0.5), edge=2.0)
    assert made.mesh.connectivity.face_valence[made.irregular].tolist() == [3] * 4
    assert any("round" in remark for remark in made.remarks)
