"""Borders before and after a surface was meshed anew."""

from __future__ import annotations

import numpy as np
import pytest

from solver.mesh.openings import Loops
from solver.mesh.primitives import primitive


def test_every_corner_of_a_border_is_a_sample():
    mesh = primitive("rectangle", 5, 4, length=8.0, width=6.0)
    loops = Loops.of(mesh.vertices, mesh.faces)
    corners = mesh.vertices[mesh.connectivity.boundary_vertices]
    assert loops.samples.shape == (3 * len(corners), 3)
    apart = np.linalg.norm(corners[:, None] - loops.samples, axis=2)
    assert apart.min(axis=1).max() == 0


def test_a_corner_that_is_cut_off_is_as_far_as_it_stood_out():
    mesh = primitive("rectangle", 5, 4, length=8.0, width=6.0)
    plain = Loops.of(mesh.vertices, mesh.faces)
    for corner in np.flatnonzero(mesh.connectivity.corners):
        points = mesh.vertices.copy()
        points[corner] += [0.3 * np.sign(points[corner, 0]), 0.4 * np.sign(points[corner, 1]), 0]
        pointed = Loops.of(points, mesh.faces)
        assert pointed.gaps(plain).max() == pytest.approx(0.5)
