"""The lightest section that passes."""

import csv

import pytest

from freecad_ortho import api
from freecad_ortho.fabrication.profiles import profile
from freecad_ortho.structural.sizing import LISTS, sections_of
from freecad_ortho.structural.strength import rules_for
from solver.errors import InputError
from solver.mesh.primitives import primitive

SETTINGS = {"unit": "m", "material": "S355", "snow": 1.0}


@pytest.fixture(scope="module")
def dome():
    mesh = primitive("translational", 7, 5)
    return mesh.with_vertices(2.0 * mesh.vertices)


def test_the_first_that_passes_from_the_lightest_on(dome, tmp_path):
    found = api.size_structure(dome, "tube:100x60x5+tube:20x20x2+tube:40x40x3", **SETTINGS)
    names = [one.section for one in found.tries]
    assert names == ["tube:20x20x2", "tube:40x40x3"] and found.check.passed
    assert [one.passed for one in found.tries] == [False, True]
    lighter = api.check_structure(dome, section="tube:20x20x2", **SETTINGS)
    assert not lighter.passed
    assert found.verdict.startswith("tube:40x40x3 is the lightest that passes (")
    written = api.write_structural_check(found, tmp_path)
    assert written[-1].name == "sizing.csv"
    with written[-1].open(encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    assert [row["passed"] for row in rows] == ["no", "yes"]
    assert float(rows[0]["utilisation"]) == pytest.approx(lighter.utilisation.max(), abs=1e-4)
    api.write_structural_check(lighter, tmp_path)
    assert not written[-1].exists()


def test_second_order_is_for_what_holds_by_the_first(dome):
    flat = dome.with_vertices(dome.vertices * [1.0, 1.0, 0.1])
    names = "tube:20x20x2+tube:60x40x4"
    found = api.size_structure(flat, names, second_order=True, imperfection=10.0, **SETTINGS)
    assert [one.passed for one in found.tries] == [False, True]
    assert 1 < found.check.factor < 10 and found.check.model.design.second_order
    assert any(one.carried == 1.0 for one in found.check.strength)


def test_where_none_passes_it_says_so(dome):
    found = api.size_structure(dome, "plate:3x30", **SETTINGS)
    assert not found.check.passed and found.verdict.startswith("None of 1 sections passes.")


@pytest.mark.parametrize("name", LISTS)
def test_lists_hold_sections_that_have_rules(name):
    names = sections_of(name)
    sections = [profile(one) for one in names]
    masses = [section.area for section in sections]
    assert masses == sorted(masses) and len(names) == len(LISTS[name])
    for section in sections:
        rules_for(section, section.material)


def test_too_many_and_unknown_sections_are_refused():
    with pytest.raises(InputError, match="sections: 21 are too many; name 20 at most"):
        sections_of("+".join(["IPE200"] * 21))
    with pytest.raises(InputError, match="section"):
        sections_of("logs")
