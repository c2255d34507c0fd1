"""Nets that follow a border which is a line of curvature, or none."""

from __future__ import annotations

import pytest

from solver import Constraints, NetOptions, optimise
from solver.align.align import aligned
from solver.analysis import measures
from solver.nets.constraints import BoundaryGlide
from tests.design_surfaces import barrel, plane, saddle, triangles


@pytest.fixture(scope="module")
def on_saddle():
    surface = triangles(saddle, 31, 21)
    return surface, aligned(*surface, edge=2.5, border="follow")


def degrees(made):
    """What is said of the border's angle to the lines of curvature."""
    (said,) = [remark for remark in made.remarks if "degrees to the lines" in remark]
    return int(said.split(" degrees")[0].split()[-1])


def test_a_border_across_the_lines_of_curvature_is_said(on_saddle):
    # Of the plan, whose sides run at atan(4 / 30) and atan(3 / 20), and of a surface that twists.
    assert 3 <= degrees(on_saddle[1]) <= 9
    turned = degrees(aligned(*triangles(barrel, 31, 21), edge=2.5, border="follow"))
    assert 12 <= turned <= 24


def test_nothing_is_said_of_a_border_along_them():
    points, faces = triangles(plane, 31, 21)
    points = points - [6, 4, 0]
    points[:, 2] = 0.02 * points[:, 0] ** 2 - 0.03 * points[:, 1] ** 2
    assert aligned(points, faces, edge=1.5, border="follow").remarks == ()


def test_a_planar_net_with_a_gap_keeps_it(on_saddle):
    surface, made = on_saddle
    exact = optimise(made.mesh, "principal", constraints=Constraints(close_to=surface))
    held = optimise(
        made.mesh,
        "planar",
        constraints=Constraints(close_to=surface, glide=(BoundaryGlide(),)),
        options=NetOptions(flatness=0.02),
    )
    assert exact.report.form.border > 0.1
    assert held.report.form.border < 1e-6
    assert held.report.status == "converged"
    assert measures.diagonal_distances(held.mesh).max() <= 0.02 + 1e-9
