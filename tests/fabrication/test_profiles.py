"""Sections of the catalogue against the tables of their standards, and what is refused."""

import math

import numpy as np
import pytest

from freecad_ortho.fabrication import MATERIALS, Beams
from freecad_ortho.fabrication.exchange.ifc_profiles import profile_definition
from freecad_ortho.fabrication.profiles import SERIES, names, polygon, profile, shapes
from freecad_ortho.fabrication.profiles.rolled import HEA, HEB, HEM, IPE, UPE
from solver.errors import InputError

# Size, area in cm2, second moments of area about y and z in cm4.
TABLES = {
    "IPE": """
        80 7.64 80.1 8.49; 100 10.3 171 15.9; 120 13.2 318 27.7; 140 16.4 541 44.9;
        160 20.1 869 68.3; 180 23.9 1317 101; 200 28.5 1943 142; 220 33.4 2772 205;
        240 39.1 3892 284; 270 45.9 5790 420; 300 53.8 8356 604; 330 62.6 11770 788;
        360 72.7 16270 1043; 400 84.5 23130 1318; 450 98.8 33740 1676; 500 116 48200 2142;
        550 134 67120 2668; 600 156 92080 3387""",
    "HEA": """
        100 21.2 349 134; 120 25.3 606 231; 140 31.4 1033 389; 160 38.8 1673 616;
        180 45.3 2510 925; 200 53.8 3692 1336; 220 64.3 5410 1955; 240 76.8 7763 2769;
        260 86.8 10450 3668; 280 97.3 13670 4763; 300 112.5 18260 6310; 320 124.4 22930 6985;
        340 133.5 27690 7436; 360 142.8 33090 7887; 400 159 45070 8564; 450 178 63720 9465;
        500 197.5 86970 10370; 550 211.8 111900 10820; 600 226.5 141200 11270;
        650 241.6 175200 11720; 700 260.5 215300 12180; 800 285.8 303400 12640;
        900 320.5 422100 13550; 1000 346.8 553800 14000""",
    "HEB": """
        100 26.0 450 167; 120 34.0 864 318; 140 43.0 1509 550; 160 54.3 2492 889;
        180 65.3 3831 1363; 200 78.1 5696 2003; 220 91.0 8091 2843; 240 106 11260 3923;
        260 118.4 14920 5135; 280 131.4 19270 6595; 300 149.1 25170 8563; 320 161.3 30820 9239;
        340 170.9 36660 9690; 360 180.6 43190 10140; 400 197.8 57680 10820; 450 218 79890 11720;
        500 238.6 107200 12620; 550 254.1 136700 13080; 600 270 171000 13530;
        650 286.3 210600 13980; 700 306.4 256900 14440; 800 334.2 359100 14900;
        900 371.3 494100 15820; 1000 400 644700 16280""",
    "HEM": """
        100 53.2 1143 399; 120 66.4 2018 703; 140 80.6 3291 1144; 160 97.1 5098 1759;
        180 113.3 7483 2580; 200 131.3 10640 3651; 220 149.4 14600 5012; 240 199.6 24290 8153;
        260 219.6 31310 10450; 280 240.2 39550 13160; 300 303.1 59200 19400;
        320 312 68130 19710; 340 315.8 76370 19710; 360 318.8 84870 19520;
        400 325.8 104100 19340; 450 335.4 131500 19340; 500 344.3 161900 19150;
        550 354.4 198000 19160; 600 363.7 237400 18980; 650 373.7 281700 18980;
        700 383 329300 18800; 800 404.3 442600 18630; 900 423.6 570400 18450;
        1000 444.2 722300 18460""",
    "UPE": """
        80 10.1 107 25.5; 100 12.5 207 38.3; 120 15.4 364 55.5; 140 18.4 600 78.8;
        160 21.7 911 107; 180 25.1 1353 144; 200 29.0 1909 187; 220 33.9 2682 246;
        240 38.5 3599 311; 270 44.8 5255 401; 300 56.6 7823 538; 330 67.8 11008 682;
        360 77.9 14825 844; 400 91.9 20981 1045""",
}  # fmt: skip
ROLLED = {"IPE": IPE, "HEA": HEA, "HEB": HEB, "HEM": HEM, "UPE": UPE}


@pytest.mark.parametrize("family", TABLES)
def test_rolled_sections_have_the_values_of_their_tables(family):
    rows = [row.split() for row in TABLES[family].split(";")]
    assert [row[0] for row in rows] == list(ROLLED[family])
    for size, *values in rows:
        made = profile(f"{family}{size}")
        found = [made.area / 100, made.inertia_y / 1e4, made.inertia_z / 1e4]
        # Tables are rounded to three digits.
        assert found == pytest.approx(list(map(float, values)), rel=5.1e-3), size
        assert made.torsion > 0 and made.modulus_y > made.modulus_z


@pytest.mark.parametrize(
    ("name", "torsion", "shear"),
    [("IPE200", 6.98, 14.0), ("HEA200", 20.98, 18.08), ("HEB160", 31.24, 17.59),
     ("HEM100", 68.21, 18.04), ("IPE600", 165.4, 83.78)],
)  # fmt: skip
def test_torsion_and_shear_of_i_sections_are_those_of_the_tables(name, torsion, shear):
    made = profile(name)
    assert made.torsion / 1e4 == pytest.approx(torsion, rel=2e-3)
    assert made.shear_area_z / 100 == pytest.approx(shear, rel=2e-3)


@pytest.mark.parametrize(
    ("name", "area", "inertia_y", "inertia_z", "torsion"),
    [
        ("tube:100x60x5", 14.7, 189, 83.6, 188),
        ("tube:60x5", 10.7, 53.3, 53.3, 86.4),
        ("shs:100x100x5", 18.7, 279, 279, 439),
        ("rhs:200x100x8", 44.8, 2234, 739, 1804),
        ("chs:88.9x5", 13.2, 116, 116, 233),
        ("chs:114.3x6.3", 21.4, 313, 313, 625),
    ],
)
def test_hot_finished_tubes_have_the_values_of_en_10210_2(
    name, area, inertia_y, inertia_z, torsion
):
    made = profile(name)
    found = [made.area / 100, made.inertia_y / 1e4, made.inertia_z / 1e4, made.torsion / 1e4]
    assert found == pytest.approx([area, inertia_y, inertia_z, torsion], rel=5e-3)


def test_rectangles_are_as_their_formulas_have_them():
    made = profile("GL24h:80x200")
    assert (made.width, made.height, made.material) == (80, 200, "GL24h")
    assert made.area == pytest.approx(16000, rel=1e-14)
    assert made.inertia_y == pytest.approx(80 * 200**3 / 12, rel=1e-14)
    assert made.modulus_z == pytest.approx(200 * 80**2 / 6, rel=1e-14)
    # Timoshenko and Goodier, table of section 93: 0.249 for 2.5, 0.1406 for a square.
    assert made.torsion == pytest.approx(0.249 * 200 * 80**3, rel=2e-3)
    assert profile("plate:100x100").torsion == pytest.approx(0.1406e8, rel=1e-3)
    thin = profile("plate:1x500")
    assert thin.torsion == pytest.approx(500 / 3, rel=2e-3)
    assert made.mass_per_metre(MATERIALS["GL24h"]) == pytest.approx(0.016 * 420)


def test_unsymmetric_sections_are_about_their_centroid():
    upe = profile("UPE200")
    # 2.56 cm from the back of the web, says the table.
    assert upe.centroid[0] + upe.width / 2 == pytest.approx(25.6, rel=5e-3)
    assert (upe.inertia_yz, upe.wall) == (0.0, 6.0)
    assert upe.modulus_z == pytest.approx(34.4e3, rel=5e-3)
    half = profile("tee:IPE200")
    assert half.area == pytest.approx(profile("IPE200").area / 2, rel=1e-12)
    assert half.centroid[1] > 20
    leg = polygon("angle", [[0, 0], [60, 0], [60, 5], [5, 5], [5, 60], [0, 60]])
    assert leg.inertia_yz < -0.5 * leg.inertia_y
    assert leg.torsion == pytest.approx(115 * 5**3 / 3, rel=0.1)


def test_a_polygon_is_what_it_encloses(tmp_path):
    file = tmp_path / "mullion.txt"
    file.write_text("# outline\n0 0\n60 0\n60 100\n0, 100\n\n# chamber\n5 5\n5 95\n55 95\n55 5\n")
    text = "polygon:0,0 60,0 60,100 0,100 | 5,5 55,5 55,95 5,95"
    for made in (profile(f"polygon:{file}"), profile(text)):
        sharp = profile("tube:100x60x5").less_round()
        assert made.area == pytest.approx(1500, rel=1e-12)
        assert made.inertia_z == pytest.approx(sharp.inertia_z, rel=1e-12)
        assert made.torsion == pytest.approx(profile("alu:100x60x5").torsion, rel=0.02)
    assert profile(f"polygon:{file}").name == "polygon:mullion"


def test_roundings_may_be_left_out():
    tube, round_tube = profile("tube:100x60x5"), profile("chs:88.9x5")
    assert tube.less_round().area == pytest.approx(1500, rel=1e-12)
    assert tube.area == pytest.approx(1500 - (4 - math.pi) * (7.5**2 - 5**2), rel=1e-12)
    assert round_tube.less_round().area == round_tube.area
    assert round_tube.perimeter == pytest.approx(math.pi * 88.9, rel=1e-12)
    assert tube.perimeter == pytest.approx(320 - (8 - 2 * math.pi) * 7.5, rel=1e-12)


@pytest.mark.parametrize(
    ("text", "name"),
    [("heb 160", "HEB160"), ("HE 160 B", "HEB160"), ("he-160-b", "HEB160"), ("ipe200", "IPE200"),
     ("gl24H: 80 x 200", "GL24h:80x200"), ("SHS:60x5.0", "tube:60x5"),
     ("TEE:HE 200 A", "tee:HEA200")],
)  # fmt: skip
def test_names_are_read_as_people_write_them(text, name):
    assert profile(text).name == name


@pytest.mark.parametrize("name", names())
def test_every_family_is_named_with_a_material_that_there_is(name):
    made = profile(name)
    assert made.name == name
    assert {made.material, *made.materials} <= set(MATERIALS)
    assert not made.materials or made.material in made.materials
    low, high = made.box
    assert np.allclose(low, -high)
    assert made.series not in SERIES or SERIES[made.series].standard == made.standard


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("HEB165", "section: there is no HEB165; take one of HEB 100, 120"),
        ("XYZ", "expected a rolled section as IPE200, HEB160 or UPE160"),
        ("box:10x10", "there is no series 'box'; take one of tube, chs"),
        ("tube:100x60x", "tube expects height x width x wall in mm, as tube:100x60x5, got"),
        ("tube:100", "tube expects height x width x wall"),
        ("GL24h:80x200x3", "GL24h expects width x height in mm, as GL24h:80x200"),
        ("tube:100x60x30", "walls of 30 mm leave no hollow in 60 mm"),
        ("chs:88.9x0", "section wall: expected a number above 0 mm"),
        ("plate:0x100", "section width: expected a number above 0 mm"),
        ("tee:UPE200", "expected a rolled section"),
        ("polygon:/nowhere/at all.txt", "cannot be read (No such file or directory)"),
        ("polygon:", "section: the polygon has no points"),
        ("polygon:0,0 10,0", "expected a polygon of at least three points"),
        ("polygon:0,0 10,0 10", "expected two numbers a point"),
        ("polygon:0,0 10,10 10,0 0,10", "crosses or touches itself"),
        ("polygon:0,0 9,0 9,9 | 0,0 20,0 20,20", "leave nothing of it"),
    ],
)  # fmt: skip
def test_what_is_no_section_is_refused(text, words):
    with pytest.raises(InputError) as caught:
        profile(text)
    assert words in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("section", "area"),
    [
        ("plate", 10 * 160),
        ("hollow", 160 * 60 - 140 * 40 - (4 - math.pi) * (15**2 - 10**2)),
        ("I", 2 * 60 * 9 + 10 * 142),
        ("T", 60 * 9 + 10 * 151),
        ("HEB160", profile("HEB160").area),
    ],
)
def test_beams_name_the_section_that_statics_take_for_theirs(section, area):
    beams = Beams(160, 10, section=section, section_width=60.0, flange_thickness=9.0)
    found = profile(beams.profile_name)
    assert found.area == pytest.approx(area)
    assert found.height == pytest.approx(160)
    if section == "I":
        assert found.inertia_y == pytest.approx((60 * 160**3 - 50 * 142**3) / 12)


@pytest.mark.parametrize("name", ["tube:100x100x5", "chs:88.9x5", "GL24h:80x80", "HEB160"])
def test_what_is_symmetric_has_no_product_moment(name):
    """Not even the last digits of a sum, which would turn axes of equal second moments."""
    assert profile(name).inertia_yz == 0.0


def test_a_section_of_a_standard_is_no_rectangle_for_having_one_outline():
    """IFC would show a hat as a bar, and a hat with a hole as a tube."""

    def made(*attributes):
        return attributes

    hat = np.array([[0, 0], [90, 0], [90, 4], [70, 60], [20, 60], [0, 4]], dtype=float)
    hole = np.array([[30, 10], [60, 10], [55, 50], [35, 50]], dtype=float)
    words = {"name": "hat:1", "series": "hat", "material": "steel", "materials": ("steel",)}
    for rings in ([hat], [hat, hole]):
        section = shapes.polygon(rings, standard="EN 10162", **words)
        assert not section.rectangular
        assert profile_definition(made, section) is None
    assert profile_definition(made, profile("GL24h:80x200"))[0] == "IfcRectangleProfileDef"
    assert profile_definition(made, profile("tube:100x60x5"))[0] == "IfcRectangleHollowProfileDef"
