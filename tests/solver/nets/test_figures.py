"""Figures 6, 7, 10 and 13 of the paper in numbers; the scripts that make them are examples."""

from __future__ import annotations

import functools
import re
import subprocess
import sys

import numpy as np
import pytest

from examples.developable_sheets import NETS, developed, doubly_curved_sheet
from examples.moebius_of_principal_net import deviation, image, principal_net
from examples.multi_net_regulariser import WEIGHT, orthogonal, rise, rough_roof, roughness
from examples.smooth_and_doubly_curved import PICTURES, double_curvature, picture
from scripts.docs_regularisers import NOISE, PANELS, made
from solver.analysis import measures
from solver.analysis.curvature import mean_curvature
from solver.analysis.gauss_image import gauss_image_area
from tests.conftest import ROOT


@pytest.mark.parametrize(
    ("example", "number", "tolerance"),
    [
        ("multi_net_regulariser", 96, 1),
        ("smooth_and_doubly_curved", 0.96, 0.03),
        ("moebius_of_principal_net", 7.4e-4, 0.2e-4),
        ("developable_sheets", 2.8, 1),
    ],
)
def test_an_example_prints_its_number(example, number, tolerance):
    command = [sys.executable, "-m", f"examples.{example}"]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=100)
    assert run.returncode == 0, run.stderr
    printed = re.findall(r"\d[\d.]*(?:e-\d+)?", run.stdout)
    assert len(printed) == 1
    assert float(printed[0]) == pytest.approx(number, abs=tolerance)


@functools.cache
def regularised(fairness: float, multi: float):
    return orthogonal(rough_roof()[1], fairness, multi)


def test_figure_6_multi_net_keeps_what_fairness_loses():
    roof, start = rough_roof()
    alone, multi, fair = regularised(0, 0), regularised(0, WEIGHT), regularised(WEIGHT, 0)
    assert all(measures.orthogonality(mesh).max() < 1e-10 for mesh in (alone, multi, fair))
    # Orthogonality alone crumples and folds the mesh.
    assert roughness(alone) > 3 * roughness(start)
    assert measures.flipped(alone).any()
    # Multi-nets smooth the noise and keep the roof.
    assert roughness(multi) < 0.7 * roughness(start)
    assert not measures.flipped(multi).any()
    assert rise(multi) == pytest.approx(rise(roof), rel=0.03)
    # Fairness makes it a plane: smoother than the roof ever was, and no roof any more.
    assert roughness(fair) < 0.01 * roughness(roof)
    assert rise(fair) < 0.05 * rise(roof)


def test_figure_7_both_energies_are_smooth_and_doubly_curved():
    roof, _ = rough_roof()
    curved = {name: double_curvature(picture(name)) / double_curvature(roof) for name in PICTURES}
    rough = {name: roughness(picture(name)) / roughness(roof) for name in PICTURES}
    assert curved["b"] > 0.95 and rough["b"] > 2
    assert abs(curved["c"]) < 0.01 and rough["c"] < 0.01
    assert 0.9 < curved["d"] < 1 and 0.7 < rough["d"] < 1
    # The same little fairness without multi-nets keeps a little less.
    little = regularised(PICTURES["d"][0], 0)
    assert double_curvature(little) / double_curvature(roof) < curved["d"]


def test_figures_6_and_7_on_the_command_line_with_the_weight_of_the_paper(tmp_path):
    roof, start = rough_roof(NOISE)
    seen = {}
    for name in ("6 b", "6 c", "6 d", "7 d"):
        (weights,) = (told for title, told in PANELS.items() if title.startswith(name))
        mesh = made(weights, start, tmp_path)
        kept = rise(mesh) / rise(roof), double_curvature(mesh) / double_curvature(roof)
        seen[name] = (roughness(mesh) / roughness(roof), *kept)
    rough, rises, curved = ({k: v[j] for k, v in seen.items()} for j in range(3))
    # Alone it is not smooth; multi-nets are smoother and keep the shape; fairness loses it.
    assert rough["6 b"] > 4 and rough["6 c"] < 0.6 * rough["6 b"] and rough["6 d"] < 1
    assert min(rises["6 c"], rises["7 d"]) > 0.97 and rises["6 d"] < 0.92
    # A little of it beside multi-nets is smooth and as doubly curved as the roof.
    assert rough["7 d"] < 1.3 and curved["7 d"] > 0.98 > 0.9 > curved["6 d"]


def test_figure_10_a_moebius_image_is_principal_to_second_order():
    deviations = []
    for samples in (15, 29):
        mesh = principal_net(samples)
        assert deviation(mesh) <= 1e-10
        assert not measures.flipped(image(mesh)).any()
        deviations.append(deviation(image(mesh)))
    assert deviations[1] < 1e-3
    assert np.log2(deviations[0] / deviations[1]) > 1.7
    # The map is not a mere motion: edges of one length become edges of many.
    stretch = image(mesh).edge_lengths / mesh.edge_lengths
    assert stretch.max() / stretch.min() > 1.5


@pytest.mark.parametrize("net", NETS)
def test_figure_13_sheets_lose_their_gauss_image(net):
    start, mesh = doubly_curved_sheet(), developed(net)
    corners = start.connectivity.corners
    assert corners.sum() == 4
    assert (mesh.vertices[corners] == start.vertices[corners]).all()
    assert gauss_image_area(mesh) < 0.1 * gauss_image_area(start)
    assert not measures.flipped(mesh).any()
    # Bent all the same, in one direction only.
    assert np.nanmedian(np.abs(mean_curvature(mesh))) > 0.08
    assert np.nanmedian(np.abs(mean_curvature(start))) > 0.5
    if net != "dog":
        assert measures.orthogonality(mesh).max() <= 1e-10
