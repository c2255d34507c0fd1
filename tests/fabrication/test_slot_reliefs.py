"""Round reliefs in the corners of slots: a cutter reaches them, and what crosses passes."""

import numpy as np
import pytest
import shapely

from freecad_ortho import api
from solver.errors import InputError

CUTTER = 5.0


def lamellas(mesh, **values):
    return api.fabricate(mesh, "lamellas", width=100.0, thickness=8.0, **values)


def test_a_cutter_cuts_every_slot_and_its_corners(roof):
    sharp, round_ones = lamellas(roof), lamellas(roof, cutter=CUTTER)
    for before, after in zip(sharp.parts, round_ones.parts, strict=True):
        whole, milled = (shapely.Polygon(part.pattern.outline) for part in (before, after))
        slots = sum(1 for mark in before.pattern.marks if not mark.text)
        assert milled.is_valid
        # What crosses still passes: reliefs take away only.
        assert milled.difference(whole).area < 1e-6
        # A dog bone at a right angle takes half a disc less half a square over its diagonal.
        each = np.pi * CUTTER**2 / 8 - CUTTER**2 / 4
        removed = whole.area - milled.area
        assert removed == pytest.approx(2 * slots * each, rel=0.03)
        # Opened by the cutter's radius the slots' corners are gone: it has been everywhere in them.
        air = milled.envelope.buffer(20).difference(milled)
        reached = air.buffer(-CUTTER / 2 + 0.03).buffer(CUTTER / 2)
        assert air.difference(reached.buffer(0.03)).area < 0.02 * slots
        np.testing.assert_array_equal(before.body.points, after.body.points)


@pytest.mark.parametrize(
    "cutter, words",
    [
        (8.0, r"cutter: 8 mm leave no floor in a slot .* mm wide of L-.*; take at most .* mm"),
        (-1.0, "cutter: expected"),
    ],
)
def test_cutters_that_do_not_fit_are_refused(roof, cutter, words):
    with pytest.raises(InputError, match=words) as caught:
        lamellas(roof, cutter=cutter)
    assert "\n" not in str(caught.value)
