"""The path of the tool's middle: half a cut outside of the part, and never through a slot."""

import numpy as np
import pytest

from freecad_ortho.fabrication import FlatPattern, Hole
from freecad_ortho.fabrication.kerf import compensated
from freecad_ortho.fabrication.pattern import polygon_area
from solver.errors import InputError


def plate(outline, **more):
    return FlatPattern(np.array(outline, float), (), np.zeros(2), 1.0, **more)


def test_kerf_moves_every_cut_by_half_of_it():
    hole = Hole(np.array([50.0, 50.0]), 10.0)
    square = [[0, 0], [200, 0], [200, 100], [0, 100]]
    cutout = np.array([[120, 30], [160, 30], [160, 70], [120, 70]], float)
    wider = compensated("X", plate(square, cutouts=(cutout,), holes=(hole,)), 2.0)
    assert polygon_area(wider.outline) == pytest.approx(202 * 102)
    assert wider.outline.min(axis=0) == pytest.approx([-1, -1])
    assert abs(polygon_area(wider.cutouts[0])) == pytest.approx(38 * 38)
    assert wider.holes[0].diameter == 8.0
    assert compensated("X", plate(square), 0.0).outline.tolist() == square


def test_kerf_that_closes_something_is_refused():
    slotted = [[0, 0], [49, 0], [49, 60], [51, 60], [51, 0], [100, 0], [100, 100], [0, 100]]
    with pytest.raises(InputError, match="kerf: 3 mm closes a slot of B0006"):
        compensated("B0006", plate(slotted), 3.0)
    with pytest.raises(InputError, match="kerf: 3 mm closes a hole of 2 mm in B0006"):
        compensated("B0006", plate(slotted, holes=(Hole(np.ones(2), 2.0),)), 3.0)
    fine = [[x + (0.9 if x == 49 else -0.9 if x == 51 else 0), y] for x, y in slotted]
    with pytest.raises(InputError, match=r"kerf: 0\.4 mm closes a slot of B0006"):
        compensated("B0006", plate(fine), 0.4)


def test_a_notch_that_ends_in_a_needle_is_no_slot():
    """Only the tip of the needle is lost, and the wider the kerf the more of it."""
    wide = 100 * np.tan(np.radians(7.5))
    notch = [[0, 0], [200 - wide, 0], [200, 100], [200 + wide, 0], [400, 0], [400, 200], [0, 200]]
    for kerf in (0.2, 12.0):
        path = compensated("P0000", plate(notch), kerf).outline
        assert np.ptp(path, axis=0) == pytest.approx([400 + kerf, 200 + kerf])
        assert polygon_area(path) > polygon_area(np.array(notch, float)) + 1000 * kerf / 2
