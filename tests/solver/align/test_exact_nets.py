"""Surfaces that carry an exact net, given as triangles: the net that is found lies on them."""

from __future__ import annotations

import numpy as np
import pytest

from solver import optimise
from solver.align.align import aligned
from solver.analysis.directions import across_asymptotic
from tests.design_surfaces import EXACT, net_on_patch, saddle, triangles

# The others take more than five seconds each.
QUICK = ("Scherk",)


@pytest.mark.parametrize(
    "name",
    [name if name in QUICK else pytest.param(name, marks=pytest.mark.slow) for name in EXACT],
)
def test_the_exact_net_lies_on_its_surface(name):
    made, outcome, found = net_on_patch(name)
    report = outcome.report
    assert not len(made.irregular)
    assert report.status == "converged"
    assert max(spread.max for spread in report.residuals.values()) <= 1e-10
    assert not report.flipped_faces
    assert found.off_surface.percent <= 0.1
    assert found.zigzag > 0.9


def test_a_saddle_gets_lines_along_which_it_does_not_bend():
    points, faces = triangles(saddle, 31, 21)
    made = aligned(points, faces, net="asymptotic-angle", edge=2.0)
    mesh = made.mesh
    assert not len(made.irregular) and mesh.mean_edge == pytest.approx(2.0, rel=0.1)
    assert across_asymptotic(mesh)[0] < 0.01
    # At right angles they would bend: the curvatures of this saddle are as one to four.
    right = aligned(points, faces, net="asymptotic", edge=2.0).mesh
    assert across_asymptotic(right)[0] > 0.1
    at = np.argmin(np.linalg.norm(made.field.places, axis=1))
    one, two = made.field.directions[at]
    slope = np.array([[30.0, 3.0], [-4.0, 20.0]])
    form = np.array([[24.0, 2.0], [2.0, -40.0]])
    form = np.linalg.inv(slope).T @ form @ np.linalg.inv(slope)
    for way in (one, two):
        assert abs(way[:2] @ form @ way[:2]) < 0.03 * np.abs(form).max()
    assert abs(one @ two) > 0.3
    start = optimise(mesh, "asymptotic-angle").report
    assert start.status == "converged" and start.iterations < 25
    assert start.form.off_surface.percent < 2 and start.form.zigzag > 0.9
    assert start.form.height_ratio > 0.9
