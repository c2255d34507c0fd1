"""The lightest section that passes."""

import csv

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.fabrication.profiles import profile
from freecad_ortho.structural.sizing import LISTS, sections_of
from freecad_ortho.structural.strength import rules_for
from solver.errors import InputError
from solver.mesh.primitives import primitive

SMALL = "tube:20x20x2+tube:30x30x2+tube:40x40x3+tube:50x50x3+tube:60x60x4"
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


def test_families_have_sections_of_their_own_and_weigh_less(dome, tmp_path):

    settings = {**SETTINGS, "snow": 3.0}
    whole = api.size_structure(dome, SMALL, **settings)
    found = api.size_structure(dome, SMALL, groups="families", **settings)
    assert found.check.passed and len(found.tries) <= 20
    assert found.check.model.mass < whole.check.model.mass
    assert {group.name for group in found.check.model.groups} <= {"", "border", "u", "v"}
    assert len(found.check.model.groups) > 1 and "the lightest found" in found.verdict
    # Its text is a section like any other.
    passing = [one for one in found.tries if one.passed and one.mass == found.check.model.mass]
    again = api.check_structure(dome, section=passing[-1].section, **settings)
    assert again.utilisation == pytest.approx(found.check.utilisation)
    written = api.write_structural_check(found, tmp_path)
    with written[-1].open(encoding="utf-8") as stream:
        assert len(list(csv.DictReader(stream))) == len(found.tries)


def test_bands_gather_members_by_how_far_they_are_used(dome):
    settings = {**SETTINGS, "snow": 3.0}
    found = api.size_structure(dome, SMALL, groups="bands", **settings)
    assert found.check.passed
    used = api.check_structure(dome, section="tube:20x20x2", **settings).utilisation
    bands = np.array(found.check.model.families)
    most = [used[bands == f"band {k}"] for k in (1, 2, 3)]
    assert most[0].max() <= most[1].min() and most[1].max() <= most[2].min()
    assert [len(one) for one in most] == pytest.approx([len(used) / 3] * 3, abs=1)


def test_groups_that_there_are_not_are_refused(dome):
    with pytest.raises(InputError, match="groups: expected all, families or bands, got 'rows'"):
        api.size_structure(dome, "tubes", groups="rows", **SETTINGS)
    for section, said in (
        (
            "tube:100x60x5,roof=tube:40x40x3",
            "there is no group 'roof' of members; there are border",
        ),
        ("border=tube:40x40x3", "members of '.*' have none; give one for all first"),
        ("tube:40x40x3,u=tube:50x50x3,u=tube:60x60x3", "'u' has two; give each group one"),
    ):
        with pytest.raises(InputError, match=said):
            api.check_structure(dome, section=section, **SETTINGS)
