"""What bolts bear: values of EN 1993-1-8, table 3.4, worked out by hand."""

import math
from html import unescape

import pytest

from freecad_ortho import api
from freecad_ortho.fabrication import build
from freecad_ortho.fabrication.bolt_strength import AREAS, Clamped, bolts_used
from freecad_ortho.fabrication.bolts import BOLTS, bolt_in, bolt_of
from freecad_ortho.fabrication.cleat import CleatSizes
from freecad_ortho.fabrication.cleat_strength import cleat_report, cleats_used
from freecad_ortho.fabrication.material import MATERIALS
from freecad_ortho.fabrication.report.check_section import check_section
from freecad_ortho.fabrication.systems import Lamellas
from tests.fabrication.test_lamellas import helicoid

STEEL = MATERIALS["steel"]


@pytest.mark.parametrize(
    "name, tension, shear",
    [("M12", 48.6, 32.4), ("M16", 90.4, 60.3), ("M20", 141.1, 94.1), ("M30", 323.1, 215.4)],
)
def test_tension_and_shear_are_those_of_tables(name, tension, shear):
    """Grade 8.8, thread in the shear plane: tables of design aids."""
    bolt = bolt_of(name)
    row = Clamped(bolt, 1, 60.0, 60.0, 10 * bolt.hole, None, STEEL).row()
    assert row[:2] == (tension, shear)
    assert Clamped(bolt, 2, 60.0, 60.0, 10 * bolt.hole, None, STEEL).row()[1] == pytest.approx(
        2 * shear, abs=0.11
    )
    assert set(AREAS) == {round(each.diameter) for each in BOLTS.values()}


def test_bearing_by_hand():
    """M16 in 20 mm of S235, 21.6 mm from the edges, then with another 40.4 mm away."""
    bolt = bolt_of("M16")
    # ab = 21.6 / 54 = 0.4, k1 = 2.8 x 1.2 - 1.7 = 1.66.
    alone = Clamped(bolt, 1, 20.0, 20.0, 21.6, None, STEEL)
    assert alone.bearing == pytest.approx(1.66 * 0.4 * 360 * 16 * 20 / 1.25, rel=1e-12)
    # Bolts nearer than 3.75 holes: ab = 40.4 / 54 - 1 / 4 = 0.498; k1 = 1.4 x 40.4 / 18 - 1.7.
    close = Clamped(bolt, 1, 20.0, 20.0, 100.0, 40.4, STEEL)
    assert close.bearing == pytest.approx(
        (1.4 * 40.4 / 18 - 1.7) * (40.4 / 54 - 0.25) * 360 * 16 * 20 / 1.25, rel=1e-12
    )
    # Far from everything 2.5 fu d t / gM2.
    free = Clamped(bolt, 1, 20.0, 20.0, 500.0, None, STEEL)
    assert free.bearing == pytest.approx(2.5 * 360 * 16 * 20 / 1.25, rel=1e-12)


def test_thin_plates_are_punched_and_other_materials_have_no_bearing():
    bolt = bolt_of("M16")
    mean = (bolt.flats + bolt.corners) / 2
    thin = Clamped(bolt, 1, 4.0, 4.0, 100.0, None, STEEL)
    assert thin.tension == pytest.approx(0.6 * 3.141592653589793 * mean * 4 * 360 / 1.25, rel=1e-12)
    other = Clamped(bolt, 1, 4.0, 4.0, 100.0, None, MATERIALS["aluminium"])
    assert other.row() == (90.4, 60.3, "")


def test_lists_and_reports_have_them(roof):
    cases = [("bolted", {}, 60.3), ("star", {}, 120.6), ("ball", {"section": "chs:88.9x5"}, "")]
    for node, values, shear in cases:
        made = api.fabricate(roof, "beams+nodes", node=node, **values)
        bolts = next(t for t in made.results["nodes"].tables if t.name == "bolts.csv")
        [said] = [dict(zip(bolts.columns, row, strict=True)) for row in bolts.rows]
        assert said["shear_kN"] == shear
        assert made.report()["nodes"]["bolt_tension_kN"] == said["tension_kN"] > 60


def test_a_low_beam_has_one_bolt_where_two_have_no_room(roof):
    """What two M16 take above each other is 83.6 mm; one takes 43.2 mm."""
    made = api.fabricate(roof, "beams+nodes", node="bolted", section="tube:80x60x5")
    plates = [part for part in made.parts if part.kind == "end-plate"]
    single = [part for part in plates if len(part.pattern.holes) == 1]
    assert single
    report = made.report()
    assert report["nodes"]["bolts"] == sum(len(part.pattern.holes) for part in plates)
    [words] = [words for words in report["messages"] if "without room for two bolts" in words]
    assert words.startswith(f"nodes: {len(single)} end plates")
    for part in single:
        [hole] = part.pattern.holes
        high = part.pattern.size[1]
        assert min(hole.centre[1], high - hole.centre[1]) >= bolt_of("M16").edge - 1e-9


def test_how_far_bolts_are_used_by_the_forces_of_a_check():
    """By hand: two bolts of 90.4 kN, 40 kN of tension and 20 kN of shear."""
    forces = {"tension_kN": 40.0, "compression_kN": 60.0, "shear_kN": 20.0, "moment_kNm": 1.5}
    hub = {
        "kind": "bolted",
        "bolts_an_end": 2,
        "bolt_tension_kN": 90.4,
        "bolt_shear_kN": 60.3,
        "bolt_bearing_kN": 50.0,
    }
    used = 100 * (40 / (1.4 * 2 * 90.4) + 20 / (2 * 50.0))
    assert f"used to {used:.0f} %" in bolts_used(hub, forces)
    star = {**hub, "kind": "star", "bolt_shear_kN": 120.6, "bolt_bearing_kN": 61.2}
    used = 100 * (60**2 + 20**2) ** 0.5 / (2 * 61.2)
    assert f"used to {used:.0f} %" in bolts_used(star, forces)
    ball = {"kind": "ball", "bolts_an_end": 1, "bolt_tension_kN": 90.4}
    words = bolts_used(ball, forces)
    assert "used to 44 %" in words
    assert "The shear and moments there, 1.5 kNm at most, are not counted" in words


@pytest.fixture(scope="module")
def net_of_cleats():
    sizes = {"width": 80.0, "thickness": 6.0, "strip": "twisted", "hole": 11.0}
    return build(helicoid(4, 4).scaled(6000.0), [Lamellas(cleats=True, **sizes)])


def cleat(levels, plate=8.0):
    """M10 in holes of 11 mm, 40 mm from the corner, in legs of 8 mm."""
    bolt = bolt_in(11.0)
    return CleatSizes(bolt, 11.0, 8.0, 100.0, levels, 40.0, 54.0, plate)


def test_bolts_of_cleats_by_hand():
    """Two M10 8.8 (58 mm2), 60 mm apart and 14 mm from the end of the leg, in 6 mm of S355."""
    found = cleat_report([cleat((-30.0, 30.0), 6.0)], MATERIALS["S355"])
    # ab = 14 / 33, k1 = min(2.8 x 14 / 11 - 1.7, 1.4 x 60 / 11 - 1.7, 2.5).
    bearing = (2.8 * 14 / 11 - 1.7) * 14 / 33 * 490 * 10 * 6 / 1.25
    assert found["cleat_bolt_shear_kN"] == pytest.approx(0.6 * 800 * 58 / 1.25 / 1e3, abs=0.05)
    assert found["cleat_bolt_bearing_kN"] == pytest.approx(bearing / 1e3, abs=0.05)
    forces = {"tension_kN": 2.0, "compression_kN": 3.0, "shear_kN": 4.0, "moment_kNm": 0.5}
    least = min(found["cleat_bolt_shear_kN"], found["cleat_bolt_bearing_kN"])
    own = math.hypot(4 / 2, 3 / 2 + 4 * 40 / 60) / least
    tension = 0.9 * 800 * 58 / 1.25 / 1e3
    other = math.hypot(4 / 2, 4 * 40 / 60) / least + 3 / (1.4 * 2 * tension)
    words = cleats_used(found, forces)
    assert f"used to {100 * max(own, other):.0f} % (with the moment" in words
    assert "0.5 kNm at most, and fins of feet are not checked" in words
    # A plate 100 mm high and 8 mm thick of S355, its bolts 40 mm from the corner.
    bends = 355 * 100 * 8**2 / 4 / 40 / 1e3
    assert found["cleat_leg_bends_kN"] == pytest.approx(bends, abs=0.005)
    assert f"pulled by {bends:g} kN" in words
    assert f"used to {100 * 3 / bends:.0f} % then" in words
    wood = cleat_report([cleat((-30.0, 30.0), 21.0)], MATERIALS["plywood"])
    assert wood["cleat_leg_bends_kN"] == pytest.approx(bends * 235 / 355, abs=0.005)


def test_cleats_with_the_fewest_bolts_count_and_wood_is_said_not_to_be_checked():
    found = cleat_report([cleat((-30.0, 30.0)), cleat((0.0,))], MATERIALS["timber"])
    assert (found["cleat_bolts_a_leg"], found["cleat_bolt_bearing_kN"]) == (1, None)
    forces = {"tension_kN": 2.0, "compression_kN": 3.0, "shear_kN": 4.0, "moment_kNm": 0.5}
    words = cleats_used(found, forces)
    assert "as they are not of steel" in words
    shear, tension = found["cleat_bolt_shear_kN"], found["cleat_bolt_tension_kN"]
    used = max(5 / shear, 4 / shear + 3 / 1.4 / tension)
    assert f"{100 * used:.0f} % (one bolt takes no moment)" in words


def test_cleats_are_in_the_report_and_beside_a_check(net_of_cleats):
    """The section of a check says how far they are used; without cleats there is no word."""
    report = net_of_cleats.report()["lamellas"]
    assert report["cleat_bolt"] == "M10"
    forces = {"tension_kN": 2.0, "compression_kN": 3.0, "shear_kN": 4.0, "moment_kNm": 0.5}
    check = {
        "largest_end_forces": forces,
        "verdict": {"passed": True, "words": "stands"},
        "section": "plate:8x100",
        "material": "S355",
        "governing_members": [],
        "members": 40,
        "warnings": [],
        "not_checked": [],
    }
    assert cleats_used(report, forces) in unescape(check_section(check, None, report))
    assert "cleats" not in check_section(check, None, {"cleats": 0})
