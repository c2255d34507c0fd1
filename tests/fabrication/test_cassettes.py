"""Metal cassettes: folded sheets, their flat patterns, bend allowance and reliefs."""

import csv
import math

import numpy as np
import pytest

from freecad_ortho.fabrication import Beams, Panels, build, material, write
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.pattern import overlaps_itself, polygon_area
from freecad_ortho.fabrication.systems.panels.cassette import Cassette, Fold
from solver.errors import InputError
from tests.fabrication.test_frames import plane_net
from tests.fabrication.test_trimming import SLANTED

ALUMINIUM = material("aluminium")
FOLD = Fold(40.0, 3.0, 2.0)
OUTLINES = {
    "square": [[0, 0], [1000, 0], [1000, 700], [0, 700]],
    "trapezium": [[0, 0], [1000, 0], [1200, 700], [-100, 650]],
    "acute": [[0, 0], [1000, 0], [1400, 700], [300, 800]],
    "pentagon": [[0, 0], [1000, 0], [1000, 700], [500, 900], [0, 700]],
    "short side": [[60, 0], [1000, 0], [1000, 700], [0, 700], [0, 60]],
}


def test_the_allowance_is_that_of_din_6935():
    """K = (0.65 + log10(r / t) / 2) / 2: 0.325 where the radius is the thickness."""
    assert Fold(40, 2, 2).factor == pytest.approx(0.325)
    assert Fold(40, 20, 2).factor == 0.5
    assert Fold(40, 2, 2).allowance == pytest.approx(math.pi / 2 * 2.65)
    assert Fold(40, 2, 2, 0.44).allowance == pytest.approx(math.pi / 2 * 2.88)


@pytest.mark.parametrize("name", OUTLINES)
def test_solids_are_closed_and_have_the_volume_of_the_formula(name):
    cassette = Cassette(np.array(OUTLINES[name], dtype=float), FOLD)
    assert cassette.fits
    solid = cassette.solid()
    assert solid.isValid()
    assert solid.Volume() == pytest.approx(cassette.volume, rel=1e-9)
    pieces = cassette.pieces()
    assert cassette.volume < sum(piece.volume for piece in pieces) < 1.05 * cassette.volume
    box = solid.BoundingBox()
    low, high = cassette.points.min(axis=0), cassette.points.max(axis=0)
    assert (np.array([box.xmin, box.ymin, box.zmin]) >= low - 1e-5).all()
    assert (np.array([box.xmax, box.ymax, box.zmax]) <= high + 1e-5).all()
    assert (box.zmin, box.zmax) == pytest.approx((low[2], high[2]), abs=1e-5)


def test_a_square_one_by_hand():
    cassette = Cassette(np.array(OUTLINES["square"], dtype=float), FOLD)
    ring = math.pi / 4 * (5**2 - 3**2)
    lengths = 2 * (990 + 690)
    assert cassette.volume == pytest.approx(990 * 690 * 2 + lengths * (ring + 35 * 2))
    outline, bends = cassette.flat()
    reach = FOLD.allowance + 35
    assert np.ptp(outline, axis=0) == pytest.approx([990 + 2 * reach, 690 + 2 * reach])
    # The corners are notched to where the folds begin.
    assert polygon_area(outline) == pytest.approx(990 * 690 + lengths * reach)
    assert {bend.angle_deg for bend in bends} == {-90.0}
    first = bends[0].points
    assert first[:, 1] == pytest.approx(5 - FOLD.allowance / 2)
    assert first[:, 0] == pytest.approx([5, 995])


@pytest.mark.parametrize("name", OUTLINES)
def test_returns_stay_clear_of_each_other_and_patterns_of_themselves(name):
    cassette = Cassette(np.array(OUTLINES[name], dtype=float), FOLD)
    outline, bends = cassette.flat()
    assert not overlaps_itself(outline)
    assert len(bends) == len(cassette.folded)
    # The face is one piece, then there is a fold and its return for each side.
    returns = [piece.solid() for piece in cassette.pieces()[2::2]]
    assert len(returns) == len(bends)
    for number, one in enumerate(returns):
        for other in returns[:number]:
            assert one.distance(other) >= 1.0 - 1e-6


def test_cassettes_on_beams_do_not_clash_and_are_folded_by_their_lists(roof, tmp_path):
    systems = [Beams(200, 30), Panels(2, 12, fold=40.0)]
    made = {"beams": material(), "panels": ALUMINIUM}
    structure = build(roof, systems, material=made)
    assert check_clashes(structure.parts).clashes == ()
    panels = structure.results["panels"].parts
    assert {type(part.body) for part in panels} == {Cassette}
    for part in panels[::11]:
        assert part.solid().isValid()
        assert part.mass == pytest.approx(part.volume * 2700e-9)
        assert part.pattern.outline.min(axis=0) == pytest.approx(0.0, abs=1e-9)
        assert part.pattern.size == pytest.approx([part.length, part.width])
    write(structure.only("panels"), tmp_path)
    with (tmp_path / "bends.csv").open(newline="") as stream:
        rows = [row for row in csv.DictReader(stream) if row["part"] == "P0000"]
    assert [float(row["angle_deg"]) for row in rows] == [-90.0] * 4
    report = structure.report()["panels"]["cassettes"]
    assert (report["folded"], report["flat"]) == (len(panels), [])


def test_at_the_border_long_sides_are_folded():
    structure = build(
        plane_net(8, 9),
        [Beams(200, 30), Panels(2, 12, fold=30.0, least_width=150)],
        material={"beams": material(), "panels": ALUMINIUM},
        border=[SLANTED],
    )
    assert check_clashes(structure.parts).clashes == ()
    for part in structure.results["panels"].parts:
        solid = part.solid()
        assert solid.isValid()
        assert solid.Volume() == pytest.approx(part.volume, rel=1e-9)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"fold": 3.0}, "fold: 3 mm are less than the bend takes, 4 mm"),
        ({"fold": 30.0, "k_factor": 0.7}, "k factor: expected 0 to 0.5"),
        ({"fold": 30.0, "edge": "bevel"}, "cassettes have square edges"),
        ({"fold": 30.0, "frame": "silicone"}, "are not glued on"),
    ],
)
def test_what_cannot_be_folded_is_refused(options, words):
    with pytest.raises(InputError, match=words):
        Panels(2, 8, **options)


def test_glass_is_not_folded():
    with pytest.raises(InputError, match="fold: glass cannot be folded; take steel"):
        build(plane_net(), [Panels(8, 8, fold=40.0)], material=material("glass"))


def test_folds_that_no_side_is_long_enough_for_are_refused():
    with pytest.raises(InputError, match=r"no panel has room for folds 1e.09 mm deep; take less"):
        build(plane_net(), [Panels(2, 8, fold=1e9)], material=ALUMINIUM)
