"""Materials: build-ups of glass, one material a system, masses and limits of each part's own."""

import csv
import json
import re

import pytest

from freecad_ortho import api
from freecad_ortho.fabrication import (
    MATERIALS,
    Beams,
    Panels,
    Patches,
    Workshop,
    build,
    material,
    materials_of,
    write,
)
from freecad_ortho.fabrication.material import metal_for
from freecad_ortho.fabrication.production import produce
from freecad_ortho.fabrication.stock import stock_list
from solver.errors import InputError
from tests.fabrication.test_patches import cylinder

STEEL_AND_GLASS = {"beams": MATERIALS["steel"], "panels": MATERIALS["toughened-glass"]}


@pytest.fixture(scope="module")
def mixed(roof):
    return build(roof, [Beams(200, 12), Panels(12, 15)], material=STEEL_AND_GLASS)


@pytest.mark.parametrize(
    ("name", "joined_by"),
    [
        ("aluminium", "aluminium"),
        ("stainless", "stainless"),
        ("timber", "steel"),
        ("glass", "steel"),
        ("glass:6/16/6", "steel"),
    ],
)
def test_what_joins_is_of_metal(name, joined_by):
    assert metal_for(material(name)).name == joined_by


@pytest.mark.parametrize(
    ("text", "beams", "panels"),
    [
        ("steel", "steel", "steel"),
        ("panels=glass", "steel", "glass"),
        ("timber,panels=glass", "timber", "glass"),
        (" panels = glass , timber ", "timber", "glass"),
    ],
)
def test_a_text_names_the_material_of_each_system(text, beams, panels):
    found = materials_of(text, ["beams", "panels"])
    assert {system: one.name for system, one in found.items()} == {
        "beams": beams,
        "panels": panels,
    }


def test_the_density_is_of_what_has_no_material_for_it_alone():
    found = materials_of("timber,panels=glass", ["beams", "panels"], 500.0)
    assert (found["beams"].density, found["panels"].density) == (500.0, 2500.0)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("steel,glass", "'steel' and 'glass' are both for everything; name the system of one"),
        ("nodes=steel", "expected beams, panels before '=', each once, got 'nodes=steel'"),
        ("panels=glass,panels=steel", "each once, got 'panels=steel'"),
        ("panels=gold", "expected steel, .*got 'gold'"),
        ("insulating-glass-6-16", "no unit of pane, cavity, pane"),
        ("insulating-glass-6-0-6", "layer: expected a number above 0 mm"),
    ],
)
def test_materials_that_cannot_be_are_refused(text, words):
    with pytest.raises(InputError, match=words):
        materials_of(text, ["beams", "panels"])


def test_an_insulating_unit_weighs_what_its_panes_do():
    unit = material("insulating-glass-8-16-4")
    assert [layer.thickness for layer in unit.layers] == [8.0, 16.0, 4.0]
    assert [layer.kind for layer in unit.layers] == ["pane", "cavity", "pane"]
    assert unit.thickness == 28.0
    # One square metre: 12 mm of glass, 30 kg.
    assert unit.mass(1e6 * unit.thickness) == pytest.approx(30.0)
    # The thicker pane breaks first.
    assert unit.least_radius(28.0) == material("glass").least_radius(8.0)


def test_panels_of_a_build_up_are_as_thick_as_it_is(roof):
    structure = api.fabricate(roof, "beams+panels", material="panels=insulating-glass-6-16-6")
    assert {part.thickness for part in structure.results["panels"].parts} == {28.0}
    assert {part.thickness for part in structure.results["beams"].parts} == {20.0}
    with pytest.raises(InputError, match=r"panels: .* is 28 mm thick and P0000 20 mm; set a"):
        api.fabricate(
            roof, "panels", material="panels=insulating-glass-6-16-6", panel_thickness=20.0
        )


def test_each_part_weighs_what_its_own_material_does(mixed):
    for name, density in (("beams", 7850.0), ("panels", 2500.0)):
        result = mixed.results[name]
        assert result.report["mass_kg"] == pytest.approx(
            1e-9 * density * sum(part.volume for part in result.parts)
        )
    report = mixed.report()
    assert list(report["materials"]) == ["steel", "toughened-glass"]
    masses = [entry["mass_kg"] for entry in report["materials"].values()]
    assert report["mass_kg"] == pytest.approx(sum(masses))
    assert report["materials"]["toughened-glass"]["parts"] == len(mixed.results["panels"].parts)


def test_limits_are_those_of_each_parts_material():
    # Bent to about 2 m: 12 mm of glass carry 210 MPa, of steel 630.
    words = build(cylinder(), [Patches(6)], material=material("glass")).verdicts[0]
    assert "exceeds 45 MPa of glass" in words
    assert (
        "exceeds 70 MPa"
        in build(cylinder(), [Patches(6)], material=material("strengthened-glass")).verdicts[0]
    )


def test_sheets_bars_and_lists_keep_materials_apart(mixed, tmp_path):
    write(mixed, tmp_path, workshop=Workshop(sheet=(6000, 3000)))
    made_of = {part.name: part.material.name for part in mixed.parts}
    report = json.loads((tmp_path / "report.json").read_text())
    seen = set()
    for sheet in report["sheets"]["sheets"]:
        assert {made_of[name] for name in sheet["parts"]} == {sheet["material"]}
        assert sheet["material"] in sheet["file"]
        seen.add(sheet["material"])
    assert seen == {"steel", "toughened-glass"}
    with (tmp_path / "parts.csv").open() as stream:
        rows = list(csv.DictReader(stream))
    assert {row["name"]: row["material"] for row in rows} == made_of
    # All are cut from sheets; without sheets the beams are sawn from bars of their own material.
    with (tmp_path / "stock.csv").open() as stream:
        assert list(csv.DictReader(stream)) == []
    assert {bar.material for bar in stock_list(mixed.parts, Workshop()).bars} == {"steel"}
    page = (tmp_path / "report.html").read_text()
    steel, glass = (f"{entry['mass_kg']:,.1f}" for entry in report["materials"].values())
    assert f"{steel} kg of steel and {glass} kg of toughened-glass" in page


def test_nobody_cuts_insulating_units_from_sheets(roof):
    structure = build(roof, [Panels(28, 15)], material=material("insulating-glass-6-16-6"))
    production = produce(structure, Workshop(sheet=(6000, 3000)))
    assert not production.sheets
    assert any("ordered to size" in words for words in production.messages)


def test_grades_bear_what_their_names_say_and_the_stronger_ones_are_stiffer():
    """S355 yields at 355 MPa, C24 and GL24h break in bending at 24 MPa."""
    for family in ("S", "C", "GL"):
        grades = [name for name in MATERIALS if re.fullmatch(rf"{family}\d+h?", name)]
        made = sorted((MATERIALS[name] for name in grades), key=lambda each: each.bending_limit)
        assert len(made) > 1
        for each in made:
            assert each.bending_limit == int(re.search(r"\d+", each.name)[0])
        assert made == sorted(made, key=lambda each: (each.youngs_modulus, each.bending_limit))
        assert made == sorted(made, key=lambda each: (each.density, each.bending_limit))
