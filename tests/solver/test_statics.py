"""Loads of a level grid by hand: each vertex carries its share of what meets there."""

from __future__ import annotations

import numpy as np
import pytest

from solver import QuadMesh
from solver.statics import VerticalLoads
from tests.conftest import grid_faces


def test_loads_of_a_grid_are_those_by_hand():
    """Faces of 2 by 3: the middle vertex, the middles of the sides and the corners."""
    x, y = np.meshgrid(2.0 * np.arange(3), 3.0 * np.arange(3), indexing="ij")
    points = np.stack([x, y, 0 * x], axis=2).reshape(-1, 3)
    net = QuadMesh(points, grid_faces(3, 3)).connectivity
    corner, along, across, middle = 0, 1, 3, 4

    def loads(**settings):
        found = VerticalLoads(net, **settings).at(points.ravel())
        return found[[corner, along, across, middle]].tolist(), found.sum()

    assert loads(per_vertex=5.0) == ([5.0, 5.0, 5.0, 5.0], 45.0)
    assert loads(per_area=2.0) == (pytest.approx([3.0, 6.0, 6.0, 12.0]), pytest.approx(2 * 24))
    # Half of every edge that ends there; all edges are 30 long.
    assert loads(per_length=4.0) == (pytest.approx([10.0, 16.0, 14.0, 20.0]), pytest.approx(4 * 30))
    both = loads(per_vertex=1.0, per_length=4.0, scale=0.5)
    assert both == (pytest.approx([5.5, 8.5, 7.5, 10.5]), pytest.approx(0.5 * (9 + 120)))
