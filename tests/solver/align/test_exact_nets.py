"""Surfaces that carry an exact net, given as triangles: the net that is found lies on them."""

from __future__ import annotations

import pytest

from tests.design_surfaces import EXACT, net_on_patch

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
