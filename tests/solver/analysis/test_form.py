"""How much of what was drawn is left, on shapes of which it is known."""

from __future__ import annotations

import numpy as np
import pytest

from solver import InputError, NetOptions, optimise
from solver.analysis import measures
from solver.analysis.form import form_of, off_surface, surface_of
from tests.conftest import shared_mesh, wavy_grid
from tests.meshes import grid, parameters, right_angles


def dome(height: float = 2.0):
    x, y = parameters(11, 9, 10.0, 8.0)
    return grid(x, y, height * np.cos(np.pi * x / 20) * np.cos(np.pi * y / 16))


def test_a_mesh_is_what_was_drawn():
    form = form_of(dome(), dome())
    assert form.off_surface.max < 1e-12 or form.off_surface.max < 0.05
    assert form.border == 0.0
    assert form.area_ratio == form.height_ratio == 1.0
    assert form.zigzag == form.zigzag_start > 0.95


def test_a_raised_and_scaled_mesh_is_off_by_as_much():
    level = grid(*parameters(5, 5, 4.0, 4.0), np.zeros((5, 5)))
    raised = level.with_vertices(level.vertices + [0, 0, 0.3])
    form = form_of(level, raised)
    assert form.off_surface.max == pytest.approx(0.3) and form.off_surface.mean == pytest.approx(
        0.3
    )
    assert form.off_surface.percent == pytest.approx(30 / np.hypot(4, 4))
    assert form.border == pytest.approx(0.3) and form.height_ratio == 1.0
    wide = level.with_vertices(level.vertices * [2, 1, 1])
    assert form_of(level, wide).area_ratio == pytest.approx(2.0)
    steep = form_of(dome(), dome().with_vertices(dome().vertices * [1, 1, 0.5]))
    assert steep.height_ratio == pytest.approx(0.5)


def test_of_many_faces_the_corners_are_looked_at_alone(monkeypatch):
    monkeypatch.setattr("solver.analysis.form._MOST", 16)
    level = grid(*parameters(5, 5, 4.0, 4.0), np.zeros((5, 5)))
    heights = np.linspace(0.1, 0.4, 25)
    raised = level.with_vertices(level.vertices + heights[:, None] * [0, 0, 1])
    found = off_surface(raised, surface_of(level))
    np.testing.assert_allclose(found, heights[level.faces], rtol=1e-12)


def test_faces_are_looked_at_between_their_corners():
    """A face whose corners lie on a cylinder leaves it in its middle."""
    coarse = grid(*parameters(3, 2, 2.0, 1.0), np.array([[0.0, 0.0], [1.0, 1.0], [0.0, 0.0]]))
    x, y = parameters(201, 2, 2.0, 1.0)
    fine = surface_of(grid(x, y, 1 - x**2))
    distances = off_surface(coarse, fine)
    assert distances.shape == (2, 25) and distances.max() > 0.1
    corners = np.linalg.norm(coarse.vertices - fine.closest(coarse.vertices)[0], axis=1)
    assert corners.max() < 1e-4


def test_zigzag_lines_are_told_from_even_ones():
    x, y = parameters(12, 12, 11.0, 11.0)
    assert measures.smoothness(grid(x, y, 0.05 * (x**2 - y**2))) > 0.99
    waves = 0.1 * (-1.0) ** np.arange(12)
    assert measures.smoothness(grid(x, y, waves[:, None] + 0 * x)) < -0.9
    assert measures.smoothness(grid(x, y, 0 * x)) == 1.0


@pytest.mark.parametrize(
    ("name", "net", "diagonal"),
    [("complete01", "asymptotic", True), ("complete01", "principal", False)],
)
def test_nets_of_irregular_meshes_stay_as_they_were_drawn(name, net, diagonal):
    """Right angles at singular vertices would crease the surface; elsewhere they are exact."""
    start = shared_mesh(name)
    outcome = optimise(start, net, options=NetOptions(diagonal=diagonal))
    form = outcome.report.form
    assert outcome.report.status == "converged", outcome.report.message
    assert form.zigzag >= form.zigzag_start - 0.05
    assert 0.95 <= form.area_ratio <= 1.05 and form.off_surface.percent < 0.5
    assert right_angles(outcome.mesh, diagonal).max() < 1e-10
    left_out = outcome.report.exempt_faces
    assert left_out > 0 and any(str(left_out) in remark for remark in outcome.report.remarks)
    if net == "principal":
        asked = optimise(start, net, options=NetOptions(singular="include")).report
        assert asked.exempt_faces == 0
        assert asked.form.off_surface.max > form.off_surface.max


@pytest.mark.parametrize(
    ("name", "net"), [("helical-minimal", "asymptotic"), ("quad_dome", "stress")]
)
def test_surfaces_that_would_shrink_are_led_by_faces_that_keep_their_shape(name, net):
    report = optimise(shared_mesh(name), net).report
    assert report.status == "converged", report.message
    assert 0.95 <= report.form.area_ratio <= 1.05
    assert report.form.zigzag >= 0.8


@pytest.mark.parametrize(
    ("name", "net", "diagonal", "even", "off"),
    [
        # Without being led on: corners of 51 to 128 degrees, 3.4 % off.
        ("wein99_diag", "cmc", True, 0.85, 2.5),
        # 120.4 degrees, 2.7 %; 131 degrees, 1.2 %.
        ("quad_dome", "stress", False, 0.8, 2.8),
        ("6-sub-lifted", "stress", False, 0.9, 1.0),
        # Area 0.93, evenness 0.43, 3.3 %. Opposite a corner of 120 degrees is one of 60.
        ("6-sub-lifted", "circular", False, 0.6, 1.5),
    ],
)
def test_nets_are_led_on_until_corners_are_upright_and_the_start_is_whole(
    name, net, diagonal, even, off
):
    options = NetOptions(diagonal=True) if diagonal else None
    outcome = optimise(shared_mesh(name), net, options=options)
    report, form = outcome.report, outcome.report.form
    assert report.status == "converged" and max(r.max for r in report.residuals.values()) < 1e-12
    assert 0.95 <= form.area_ratio <= 1.05 and form.zigzag >= even
    assert form.off_surface.percent < off
    assert measures.slant(outcome.mesh) <= 30.5


def test_a_circular_dome_with_many_irregular_vertices_keeps_its_area():
    """Four of its 57 vertices have three faces, about which circular faces cannot be even."""
    form = optimise(shared_mesh("quad_dome"), "circular").report.form
    # Without being led on: 0.63 and 9.4 %.
    assert form.area_ratio > 0.85 and form.off_surface.percent < 5


def test_within_is_a_wish_with_a_verdict():
    start = wavy_grid(9, 8)
    loose = optimise(start, "principal", within=100.0).report
    tight = optimise(start, "principal", within=1e-9).report
    assert loose.is_within and not tight.is_within
    assert tight.as_dict()["is_within"] is False
    assert tight.as_dict()["off_surface"]["max"] == tight.form.off_surface.max
    for wrong in (0.0, -1.0, float("nan")):
        with pytest.raises(InputError, match=r"within: expected a (finite )?number"):
            optimise(start, "principal", within=wrong)


def test_planar_nets_stay_on_the_surface_that_was_drawn():
    """A saddle whose lines run across its curvature: flat faces need not move it."""
    x, y = parameters(21, 21, 10.0, 10.0)
    start = grid(x, y, 0.04 * (x**2 - y**2) + 0.02 * x * y)
    planar, principal = (optimise(start, net).report for net in ("planar", "principal"))
    assert planar.status == "converged", planar.message
    assert planar.form.off_surface.percent < 0.3
    assert planar.form.off_surface.max < 0.5 * principal.form.off_surface.max
    assert 0.95 <= planar.form.area_ratio <= 1.05 and planar.form.zigzag > 0.9


@pytest.mark.parametrize("net", ["geodesic", "dog", "chebyshev", "geodesic-chebyshev"])
@pytest.mark.parametrize("curved", [1, -1], ids=["dome", "saddle"])
def test_sheets_of_doubly_curved_starts_bend_without_crease_lines(net, curved):
    x, y = parameters(15, 13, 3.0, 2.6)
    report = optimise(grid(x, y, 0.12 * (x**2 + curved * y**2)), net).report
    assert report.status == "converged", report.message
    # Measured: 0.97 and more.
    assert report.form.zigzag > 0.9
    assert 0.95 <= report.form.area_ratio <= 1.05
