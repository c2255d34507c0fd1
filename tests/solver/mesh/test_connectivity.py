"""Connectivity of grids, an irregular vertex and a closed torus, against counts known by hand."""

from __future__ import annotations

import numpy as np
import pytest

from solver.errors import InputError
from solver.mesh.connectivity import Connectivity
from tests.conftest import grid_faces


def star_of(valence: int) -> Connectivity:
    """Valence quads around vertex 0: vertex 2k+1 is a neighbour, 2k+2 the opposite corner."""
    ring = 2 * valence
    faces = [[0, 1 + 2 * k, 2 + 2 * k, 1 + (2 * k + 2) % ring] for k in range(valence)]
    return Connectivity(np.array(faces), ring + 1)


def torus(rows: int, columns: int) -> Connectivity:
    i, j = np.divmod(np.arange(rows * columns), columns)

    def number(a, b):
        return (a % rows) * columns + b % columns

    faces = np.stack([number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)], 1)
    return Connectivity(faces, rows * columns)


def test_grid_counts():
    rows, columns = 5, 7
    net = Connectivity(grid_faces(rows, columns), rows * columns)
    assert len(net.edges) == rows * (columns - 1) + columns * (rows - 1)
    assert net.boundary_edges.sum() == 2 * (rows - 1) + 2 * (columns - 1)
    assert net.corners.sum() == 4
    assert set(np.flatnonzero(net.corners)) == {0, columns - 1, (rows - 1) * columns, 34}
    # Every parameter line of n vertices has n - 2 triples; boundary lines count too.
    assert len(net.line_triples) == rows * (columns - 2) + columns * (rows - 2)
    assert len(net.face_pairs) == (~net.boundary_edges).sum()
    assert len(net.stars) == (rows - 2) * (columns - 2)
    assert net.components.max() == 0


def test_boundary_loops_run_around_the_faces():
    (loop,) = Connectivity(grid_faces(3, 4), 12).boundary_loops
    assert sorted(loop) == [0, 1, 2, 3, 4, 7, 8, 9, 10, 11]
    assert set(np.abs(np.diff(loop, append=loop[0])).tolist()) == {1, 4}


def test_boundary_loops_that_touch_do_not_cross():
    one, two = Connectivity(np.array([[0, 1, 2, 3], [2, 4, 5, 6]]), 7).boundary_loops
    assert (one.tolist(), two.tolist()) == ([0, 1, 2, 3], [2, 4, 5, 6])


def test_triples_are_collinear_on_a_grid():
    columns = 6
    net = Connectivity(grid_faces(5, columns), 30)
    left, centre, right = (np.stack(np.divmod(net.line_triples[:, k], columns)) for k in range(3))
    assert (left + right == 2 * centre).all()


def test_face_pairs_are_one_by_two_rectangles():
    columns = 6
    net = Connectivity(grid_faces(5, columns), 30)
    a, c, b, d = (np.stack(np.divmod(net.face_pairs[:, k], columns)) for k in range(4))
    assert (a + c == b + d).all()
    assert (np.sort(np.abs(a - c), axis=0) == [[1], [2]]).all()


@pytest.mark.parametrize(("rows", "columns"), [(1, 1), (2, 2), (3, 3), (1, 3), (2, 4)])
def test_rectangles_are_all_rectangles_of_their_size(rows, columns):
    net = Connectivity(grid_faces(6, 8), 48)
    found = net.rectangles(rows, columns)
    ways = {(rows, columns), (columns, rows)}
    assert len(found) == sum(max(0, 5 - a + 1) * max(0, 7 - b + 1) for a, b in ways)
    place = np.stack(np.divmod(found, 8), axis=2)
    assert (place[:, 0] + place[:, 2] == place[:, 1] + place[:, 3]).all()
    sides = np.abs(place[:, 1] - place[:, 0]).sum(axis=1)
    assert (sides == rows).all()
    assert len({frozenset(row) for row in found.tolist()}) == len(found)


def test_edge_families_of_a_grid_are_two_and_run_straight():
    net = Connectivity(grid_faces(5, 7), 35)
    assert net.edge_families.max() == 1
    along = np.abs(np.diff(net.edges, axis=1)[:, 0]) == 7
    assert len(set(net.edge_families[along])) == 1
    assert len(set(net.edge_families[~along])) == 1


def test_an_odd_irregular_vertex_joins_the_families():
    assert star_of(3).edge_families.max() == 0
    assert star_of(4).edge_families.max() == 1


def test_stars_are_cyclic_and_diagonals_lie_between():
    columns = 5
    net = Connectivity(grid_faces(5, columns), 25)
    for star, diagonal in zip(net.stars, net.diagonal_stars, strict=True):
        centre = np.array(divmod(star[0], columns))
        spokes = np.array([divmod(v, columns) for v in star[1:]]) - centre
        corners = np.array([divmod(v, columns) for v in diagonal[1:]]) - centre
        turns = (
            spokes[:, 0] * np.roll(spokes, -1, 0)[:, 1]
            - spokes[:, 1] * np.roll(spokes, -1, 0)[:, 0]
        )
        assert (turns == turns[0]).all() and abs(turns[0]) == 1
        assert (corners == spokes + np.roll(spokes, -1, axis=0)).all()


@pytest.mark.parametrize("valence", [3, 5, 6])
def test_no_line_passes_an_irregular_vertex(valence):
    net = star_of(valence)
    assert not net.boundary_vertices[0]
    assert not net.regular[0]
    assert 0 not in net.line_triples[:, 1]
    assert len(net.face_pairs) == valence


def test_closed_torus_has_no_boundary():
    net = torus(5, 6)
    assert not net.boundary_edges.any()
    assert len(net.stars) == 30
    assert len(net.line_triples) == 60
    assert (net.twins >= 0).all()


def test_edge_faces_lie_on_their_side():
    net = Connectivity(grid_faces(3, 3), 9)
    for (start, end), (left, right) in zip(net.edges, net.edge_faces, strict=True):
        for face, pair in ((left, (start, end)), (right, (end, start))):
            if face >= 0:
                loop = net.faces[face].tolist()
                assert (loop.index(pair[0]) + 1) % 4 == loop.index(pair[1])


@pytest.mark.parametrize(
    ("faces", "words"),
    [
        ([[0, 1, 2, 9]], "numbered 0 to 7"),
        ([[0, 1, 2, -1]], "numbered 0 to 7"),
        ([[0, 1, 2, 1]], "repeat a vertex"),
        ([[0, 1, 2, 3], [0, 1, 5, 4]], "used twice in the same direction"),
        ([[0, 1, 2]], "shape"),
    ],
)
def test_bad_faces_are_refused_in_one_line(faces, words):
    with pytest.raises(InputError, match=words) as caught:
        Connectivity(np.array(faces), 8)
    assert "\n" not in str(caught.value)
