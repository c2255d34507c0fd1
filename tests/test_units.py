"""Units of length: each by what it is defined as."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.units import MILLIMETRES, millimetres_per
from solver.errors import InputError
from tests.conftest import wavy_grid


def test_units_are_what_they_are_defined_as():
    assert millimetres_per("in") == 25.4
    assert millimetres_per("ft") == pytest.approx(12 * 25.4, rel=1e-15)
    assert millimetres_per("m") == 100 * millimetres_per("cm") == 1000 * millimetres_per("mm")
    assert set(MILLIMETRES) == {"mm", "cm", "m", "in", "ft"}
    with pytest.raises(InputError, match="unit: expected mm, cm, m, in or ft, got 'yd'"):
        millimetres_per("yd")


@pytest.mark.parametrize("unit", MILLIMETRES)
def test_parts_have_the_size_that_the_unit_says(unit):
    """A metre of edge is a metre of beam, whatever unit it is written in."""
    flat = wavy_grid(3, 3, shear=0.0, height=0.0).scaled(1000.0)
    same = flat.scaled({"mm": 1, "cm": 0.1, "m": 1e-3, "in": 1 / 25.4, "ft": 1 / 304.8}[unit])
    found, expected = (
        np.array([part.pattern.size for part in api.fabricate(mesh, "beams", unit=one).parts])
        for mesh, one in ((same, unit), (flat, "mm"))
    )
    assert np.allclose(found, expected, rtol=1e-9)
    assert expected.max() > 900.0
