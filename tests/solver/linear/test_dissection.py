"""Nested dissection: the parts of a graph, their order, and the separators between them."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.sparse import coo_array, csc_array

from solver.linear.dissection import dissect


def graph_of(links, count):
    ends = np.array(links, dtype=np.int64).reshape(-1, 2)
    both = np.concatenate([ends, ends[:, ::-1], np.stack([np.arange(count)] * 2, axis=1)])
    matrix = coo_array((np.ones(len(both)), (both[:, 0], both[:, 1])), shape=(count, count))
    return csc_array(matrix)


def grid(side):
    """A square grid of nodes, linked to their right and upper neighbours."""
    number = np.arange(side * side).reshape(side, side)
    across = np.stack([number[:, :-1], number[:, 1:]], axis=2).reshape(-1, 2)
    up = np.stack([number[:-1], number[1:]], axis=2).reshape(-1, 2)
    points = np.stack([number.ravel() % side, number.ravel() // side, 0 * number.ravel()], axis=1)
    return graph_of(np.concatenate([across, up]), side * side), points.astype(float)


def parts_of(dissection):
    part = np.empty(len(dissection.order), dtype=np.int64)
    for k, (begin, end) in enumerate(
        zip(dissection.begins[:-1], dissection.begins[1:], strict=True)
    ):
        part[dissection.order[begin:end]] = k
    return part


def parts_met(graph, dissection):
    """Later parts that each part meets once all before it are eliminated, the nearest its parent.

    Checks that parts are numbered so that each follows directly on the tree of those below it.
    """
    part = parts_of(dissection)
    assert (np.diff(dissection.begins) > 0).all()
    count = len(dissection.begins) - 1
    above = [set() for _ in range(count)]
    ends = graph.tocoo()
    for a, b in zip(part[ends.row], part[ends.col], strict=True):
        if a < b:
            above[a].add(b)
    first = list(range(count))
    for k in range(count):
        if above[k]:
            parent = min(above[k])
            above[parent] |= above[k] - {parent}
            first[parent] = min(first[parent], first[k])
    trees = sorted((first[k], -k) for k in range(count))
    ends_of_trees = []
    for begin, minus in trees:
        while ends_of_trees and ends_of_trees[-1] < begin:
            ends_of_trees.pop()
        # Trees lie within each other or apart.
        assert not ends_of_trees or -minus <= ends_of_trees[-1]
        ends_of_trees.append(-minus)
    return [len(met) for met in above]


@pytest.mark.parametrize("side", [5, 30, 60])
def test_a_grid_is_halved_by_lines_of_nodes(side):
    graph, points = grid(side)
    dissection = dissect(graph, points, np.full(side * side, 3))
    assert sorted(dissection.order) == list(range(side * side))
    if side > 10:
        # The last part is the first separator, one line of nodes right through the grid.
        top = dissection.order[dissection.begins[-2] :]
        assert len(top) == side
        assert np.ptp(points[top], axis=0).min(initial=np.inf, where=[True, True, False]) == 0
    # A part meets the few separators around it, not all that come later.
    assert max(parts_met(graph, dissection)) <= 5


def test_parts_that_are_not_linked_need_no_separator():
    graph, points = grid(9)
    pair = csc_array(np.kron(np.eye(2), graph.toarray()))
    places = np.concatenate([points, points + [100.0, 0, 0]])
    dissection = dissect(pair, places, np.full(162, 1))
    assert np.diff(dissection.begins).tolist() == [81, 81]


def test_points_in_one_place_are_no_obstacle():
    graph, points = grid(20)
    dissection = dissect(graph, 0 * points, np.full(400, 3))
    assert sorted(dissection.order) == list(range(400))


def test_nodes_without_unknowns_cost_nothing():
    graph, points = grid(31)
    weights = np.where(points[:, 0] == 15, 0, 3)
    dissection = dissect(graph, points, weights)
    # The line of nodes without unknowns comes last and separates already.
    assert set(np.flatnonzero(weights == 0)) <= set(dissection.order[dissection.begins[-2] :])
    assert len(dissection.order) - dissection.begins[-2] == 31


def test_one_node_that_meets_all_ends_at_the_top():
    graph, points = grid(30)
    all_of_them = np.stack([np.full(900, 900), np.arange(900)], axis=1)
    linked = graph_of(np.concatenate([np.argwhere(np.triu(graph.toarray(), 1)), all_of_them]), 901)
    dissection = dissect(linked, np.vstack([points, [[14.5, 14.5, 0]]]), np.full(901, 3))
    top = dissection.order[dissection.begins[-2] :]
    assert 900 in top and len(top) == 31


def test_the_same_graph_gives_the_same_order():
    graph, points = grid(40)
    runs = [dissect(graph, points, np.full(1600, 3)) for _ in range(2)]
    assert np.array_equal(runs[0].order, runs[1].order)


def test_an_empty_graph():
    dissection = dissect(csc_array((0, 0)), np.zeros((0, 3)), np.zeros(0, dtype=np.int64))
    assert len(dissection.order) == 0
