"""Triangles that are no surface are refused, with the place."""

import pytest

from solver import InputError
from solver.mesh.triangles import sound_triangles

SQUARE = [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]]


def test_vertices_at_one_place_are_merged_and_what_has_no_area_is_dropped():
    points, triangles = sound_triangles(
        [*SQUARE, [0, 0, 0], [2, 2, 0]], [[0, 1, 2], [4, 5, 3], [0, 1, 1]]
    )
    assert (len(points), len(triangles), triangles.max()) == (4, 2, 3)


def test_a_third_triangle_at_an_edge_is_refused_with_its_place():
    fin = [*SQUARE, [1, 1, 3]]
    with pytest.raises(InputError, match=r"share an edge, 1 times, near \(1, 1, 0\).*separate"):
        sound_triangles(fin, [[0, 1, 2], [0, 2, 3], [0, 2, 4]])


def test_loose_triangles_are_refused():
    points = [[x + 5 * k, y, 0] for k in range(4) for x, y in ((0, 0), (1, 0), (0, 1))]
    with pytest.raises(InputError, match=r"a soup of loose triangles.*join vertices"):
        sound_triangles(points, [[3 * k, 3 * k + 1, 3 * k + 2] for k in range(4)])
