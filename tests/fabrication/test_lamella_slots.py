"""Slots of lamellas beside bend lines."""

import math

import numpy as np
import pytest

from freecad_ortho.fabrication.systems.lamellas.crossings import clear_of_bend
from freecad_ortho.fabrication.systems.lamellas.outline import Slot
from freecad_ortho.fabrication.systems.lamellas.ribbon import Ribbon
from solver.unroll.strip import Strip


@pytest.mark.parametrize("bend_deg", [5.0, 20.0, 40.0])
@pytest.mark.parametrize("lean", [0.0, 0.05, 0.1])
def test_slots_are_widened_just_until_their_corners_are_beyond_the_mitre(bend_deg, lean):
    """Two plane faces of a plate 8 mm thick, the bend line leaning to the slot's upper corner."""
    bend = math.radians(bend_deg)
    ruling = np.array([lean, 0.0, 1.0]) / math.hypot(lean, 1.0)
    before = np.array([1.0, 0.0, 0.0])
    after = ruling[0] * ruling + np.cos(bend) * (before - ruling[0] * ruling)
    after += np.sin(bend) * np.cross(ruling, before)
    upright = np.cross(np.cross(after, ruling), after)
    points = 400.0 * np.array([-before, 0 * before, after])
    rulings = np.array([[0, 0, 1.0], ruling, upright / np.linalg.norm(upright)])
    ribbon = Ribbon(Strip(points, rulings), -60.0, 60.0, 8.0)
    given = Slot(1, np.array([0.0, 1.0]), -0.5, 10.0, True)
    mitre = 8 * math.tan(bend / 2) + 0.01
    # Distances of the lower and upper corners of either side from the bend line.
    places = np.array([[-1, -0.5], [1, -0.5], [-1, 60], [1, 60]])
    turn = np.array([1.0, -lean]) / math.hypot(lean, 1.0)
    wanted = next(
        width
        for width in 10 + 0.5 * mitre * np.arange(100)
        if np.abs(places * [width / 2, 1] @ turn).min() > mitre
    )
    assert clear_of_bend(ribbon, given, "L-U000", "L-V000").width == pytest.approx(wanted)
