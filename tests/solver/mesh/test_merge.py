"""Vertices made one."""

from __future__ import annotations

import numpy as np

from solver.mesh.merge import merged


def test_groups_are_numbered_by_their_first_vertex():
    kept, number = merged(np.array([[5, 1], [4, 2], [1, 3]]), 6)
    assert kept.tolist() == [0, 1, 2]
    assert number.tolist() == [0, 1, 2, 1, 2, 1]


def test_nothing_to_merge_changes_nothing():
    kept, number = merged(np.zeros((0, 2), dtype=np.int64), 3)
    assert kept.tolist() == number.tolist() == [0, 1, 2]
