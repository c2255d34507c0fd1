"""What can be made of glass: verdicts on angles, sides, sizes, masses and holes."""

from dataclasses import replace

import numpy as np
import pytest

from freecad_ortho.fabrication import Hole, Panels, build, material
from freecad_ortho.fabrication.limits import Limits, verdict
from freecad_ortho.fabrication.plate_limits import smallest_box
from tests.meshes import grid

GLASS = material("toughened-glass")


def panel(width, height, lean=0.0, made_of=GLASS, thickness=10.0):
    """The verdict's part: one face of this size, sheared, less half a gap all around."""
    x, y = np.meshgrid([0.0, width], [0.0, height])
    net = grid(x + lean * y, y, 0 * x)
    (part,) = build(net, [Panels(thickness, 8)], material=made_of).parts
    return part


@pytest.mark.parametrize(
    ("part", "words"),
    [
        (panel(2008, 1008), "ok"),
        (panel(2008, 1008, lean=2.0), "has 26.6 degrees, toughened-glass needs 30"),
        (panel(6508, 2008), "it is 6500 x 2000 mm, toughened-glass at most 6000 x 2800 mm"),
        (panel(3008, 3008), "it is 3000 x 3000 mm, toughened-glass at most 6000 x 2800 mm"),
        (panel(258, 258), "it is 250 x 250 mm, toughened-glass at least 300 x 200 mm"),
        (panel(3008, 258), "it is 3000 x 250 mm, toughened-glass at most 10 times as long as wide"),
        (
            panel(5008, 2008, made_of=material("glass:12/16/88.4"), thickness=45.52),
            "weighs 716 kg, glass:12/16/88.4 at most 500 kg",
        ),
        (panel(258, 258, made_of=material("steel")), "ok"),
    ],
    ids=["fits", "angle", "long", "wide", "small", "narrow", "heavy", "steel"],
)
def test_a_panel_that_cannot_be_made_says_why(part, words):
    found = verdict(part, Limits())
    assert found == words if words == "ok" else words in found


def test_a_pattern_has_to_be_straight_unless_it_is_cut_curved():
    part = panel(2008, 1008)
    bent = replace(part, measures=replace(part.measures, straightness_mm=5.0))
    assert verdict(bent, Limits()) == "straightness 5 mm exceeds 1 mm"
    assert verdict(replace(bent, curved=True), Limits()) == "ok"


def test_the_strictest_of_several_panes_counts():
    part = panel(6008, 3008, made_of=material("glass:8/16/8t"), thickness=32.0)
    assert "at most 6000 x 2800 mm" in verdict(part, Limits())
    whole = panel(6008, 3008, made_of=material("glass:8"), thickness=8.0)
    assert verdict(whole, Limits()) == "ok"


@pytest.mark.parametrize(
    ("hole", "words"),
    [
        (Hole(np.array([500.0, 500.0]), 20.0), "ok"),
        (Hole(np.array([500.0, 500.0]), 9.0), "is 9 mm wide, toughened-glass needs 10 mm"),
        (
            Hole(np.array([500.0, 29.0]), 20.0),
            "its hole at 500, 29 mm of its pattern is 19.0 mm from an edge, toughened-glass needs "
            "20 mm",
        ),
        (
            Hole(np.array([45.0, 45.0]), 20.0),
            "is 53.6 mm from a corner, toughened-glass needs 60 mm",
        ),
    ],
)
def test_holes_keep_from_edges_and_corners(hole, words):
    part = panel(2008, 1008)
    drilled = replace(part, pattern=replace(part.pattern, holes=(hole,)))
    found = verdict(drilled, Limits())
    assert found == words if words == "ok" else words in found


def test_a_short_side_is_named_and_a_curved_one_is_none():
    part = panel(2008, 1008)
    short = np.array([[0, 0], [2000, 0], [2000, 1000], [10, 1000], [0, 988]], dtype=float)
    cut = replace(part, pattern=replace(part.pattern, outline=short))
    assert "is 15.6 mm long, toughened-glass needs 20 mm" in verdict(cut, Limits())
    angle = np.linspace(0, np.pi, 90)
    arc = np.column_stack([1000 + 1000 * np.cos(angle), 800 + 200 * np.sin(angle)])
    curved = np.concatenate([[[0.0, 0.0], [2000.0, 0.0]], arc])
    bent = replace(part, pattern=replace(part.pattern, outline=curved))
    assert verdict(bent, Limits()) == "ok"


def test_the_box_is_the_smallest_one_however_a_plate_is_turned():
    turn = np.radians(17)
    rotation = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
    corners = np.array([[0, 0], [900, 0], [900, 400], [0, 400]]) @ rotation
    assert smallest_box(corners) == pytest.approx((900, 400))
