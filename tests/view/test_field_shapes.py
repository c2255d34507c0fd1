"""Crosses, singular points and strokes as they are drawn."""

from __future__ import annotations

import numpy as np

from freecad_ortho.view.field_shapes import crosses, singular_points, stroke_lines
from solver.align.crosses import Crosses, Singular


def field(certainty):
    """A flat field along x and y at 40 x 40 places, 0.1 apart."""
    x, y = np.meshgrid(0.1 * np.arange(40), 0.1 * np.arange(40))
    places = np.stack([x.ravel(), y.ravel(), 0 * x.ravel()], axis=1)
    directions = np.broadcast_to(np.eye(3)[:2], (len(places), 2, 3))
    return Crosses(places, directions, np.full(len(places), certainty))


def test_about_one_cross_for_each_face():
    first, second = crosses(field(1.0), edge=0.5)
    assert len(first.ends) == len(second.ends) == 64
    along = first.ends[:, 1] - first.ends[:, 0]
    np.testing.assert_allclose(along, np.broadcast_to([0.35, 0.0, 0.0], along.shape), atol=1e-12)
    middle = first.ends.mean(axis=1)
    np.testing.assert_allclose(middle, second.ends.mean(axis=1))
    apart = np.linalg.norm(middle[:, None] - middle[None], axis=2) + np.eye(64)
    assert apart.min() > 0.27


def test_colours_fade_with_certainty():
    greys = [
        np.ptp(crosses(field(certainty), edge=0.5)[0].colour) for certainty in (0.01, 0.3, 0.9)
    ]
    assert greys[0] < 0.05
    assert greys[0] < greys[1] < greys[2]
    mixed = field(1.0)
    mixed.certainty[:800] = 0.0
    assert len(crosses(mixed, edge=0.5)) == 4


def test_singular_points_have_a_colour_for_each_number_of_lines():
    places = np.arange(12.0).reshape(4, 3)
    three, five = singular_points(Singular(places, np.array([3, 5, 3, 3])))
    assert (len(three.places), len(five.places)) == (3, 1)
    assert three.colour != five.colour
    assert singular_points(Singular(places[:0], np.zeros(0, dtype=int))) == []


def test_strokes_are_lines():
    curve = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0]])
    (lines,) = stroke_lines([curve, curve + 5])
    np.testing.assert_array_equal(lines.ends[:2], [[[0, 0, 0], [1, 0, 0]], [[1, 0, 0], [1, 1, 0]]])
    assert len(lines.ends) == 4
    assert stroke_lines([]) == []
