"""The check as a whole, and its files."""

import csv
import json

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.structural.files import FILES
from freecad_ortho.structural.numbers import check_numbers
from freecad_ortho.structural.words import assumptions, warnings
from solver.errors import InputError
from solver.mesh.primitives import primitive


@pytest.fixture(scope="module")
def dome():
    mesh = primitive("translational", 7, 5)
    return mesh.with_vertices(2.0 * mesh.vertices)


@pytest.fixture(scope="module")
def checked(dome):
    return api.check_structure(dome, unit="m", material="S355", snow=1.5, panels=0.4, wind="0.6@x")


def test_reactions_carry_the_loads(checked):
    assert checked.balance < 1e-9
    for case, found in zip(checked.model.cases, checked.cases, strict=True):
        total = case.loads.total(checked.model.frame)
        pushed = found.reactions[:, :3].sum(axis=0)
        assert np.abs(total + pushed).max() < 1e-9 * np.abs(case.loads.spread).sum() * 1e3


def test_supports_carry_what_comes_to_them(checked):
    down, up, sideways = checked.largest_reactions
    reactions = np.stack([one.response.reactions for one in checked.strength])
    assert up == reactions[:, :, 2].max() > 0 and down >= 0
    assert sideways == pytest.approx(np.linalg.norm(reactions[:, :, :2], axis=2).max())


def test_a_stout_dome_passes_and_says_so(checked):
    assert checked.passed and checked.verdict.startswith("Passes this check (first order)")
    assert 0 < checked.utilisation.max() < 0.2 and checked.factor > 10


def test_the_unit_of_the_net_does_not_matter(dome, checked):
    other = api.check_structure(
        dome.scaled(1000.0), material="S355", snow=1.5, panels=0.4, wind="0.6@x"
    )
    assert other.utilisation == pytest.approx(checked.utilisation, rel=1e-6)


def test_far_from_the_origin_it_is_the_same(dome, checked):
    away = dome.with_vertices(dome.vertices + [3.5e6, 5.4e6, 0.0])
    other = api.check_structure(away, unit="m", material="S355", snow=1.5, panels=0.4, wind="0.6@x")
    assert other.utilisation == pytest.approx(checked.utilisation, rel=1e-3)


def test_a_plate_of_beams_bends_and_a_dome_hardly(dome, checked):
    flat = dome.with_vertices(dome.vertices * [1.0, 1.0, 1e-6])
    level = api.check_structure(flat, unit="m", material="S355", snow=1.5)
    assert [one.bent for one in level.strength] == pytest.approx([1.0] * 3, abs=1e-6)
    assert max(one.bent for one in checked.strength) < 0.5


def test_what_is_too_weak_does_not_pass(dome):
    found = api.check_structure(dome, unit="m", section="plate:3x30", material="S235", snow=20.0)
    assert not found.passed
    assert "members are used beyond 100 %" in found.verdict
    assert "\n" not in found.verdict


def test_second_order_is_asked_for_and_done(dome):
    """A flat shell of flat bars: it buckles at less than ten times its load."""
    flat = dome.with_vertices(dome.vertices * [1.0, 1.0, 0.1])
    settings = {"unit": "m", "section": "tube:40x40x3", "material": "S355", "snow": 1.0}
    first = api.check_structure(flat, **settings)
    assert 1 < first.factor < 10 and "only balance in the deformed shape" in first.verdict
    growth = 1 / (1 - 1 / first.factor)
    assert f"by up to about {growth:.1f} times" in " ".join(warnings(first))
    second = api.check_structure(flat, second_order=True, imperfection=20.0, **settings)
    assert second.imperfection == 20.0
    assert second.utilisation.max() > 1.1 * first.utilisation.max()
    assert "deformed shape (second order)" not in second.verdict
    carried = [one.carried for one in second.strength]
    assert any(part is not None for part in carried)
    assert [one.bent for one in second.strength] == [one.bent for one in first.strength]


def test_the_forces_that_are_listed_are_those_that_govern(dome):
    """Put into the rules again they use each member up as far as it is said to be."""
    flat = dome.with_vertices(dome.vertices * [1.0, 1.0, 0.1])
    settings = {"unit": "m", "section": "tube:40x40x3", "material": "S355", "snow": 1.0}
    first = api.check_structure(flat, **settings)
    second = api.check_structure(flat, second_order=True, imperfection=20.0, **settings)
    assert not first.governed_deformed.any() and second.governed_deformed.any()
    for found in (first, second):
        model, (group,) = found.model, found.model.groups
        lengths, forces = model.frame.lengths, found.governing_forces[None]
        by = np.array([one.section for one in found.strength])
        section = by[found.governing, np.arange(by.shape[1])] == found.utilisation
        again = group.rules.section(forces, False)[0]
        assert again[section] == pytest.approx(found.utilisation[section])
        again = group.rules.member(forces, lengths, False)
        assert again[~section] == pytest.approx(found.utilisation[~section])
        assert 0 < section.sum() < len(section)


@pytest.mark.parametrize(
    ("settings", "said"),
    [
        ({"joints": "hinged"}, "a mechanism: node.* freely"),
        ({"supports": "3,4"}, "a mechanism: nodes .* freely"),
        ({"supports": "boundary:sliding"}, "a mechanism: nodes .* freely"),
    ],
)
def test_a_mechanism_is_one_line(dome, settings, said):
    with pytest.raises(InputError, match=said) as found:
        api.check_structure(dome, unit="m", snow=1.0, **settings)
    assert "\n" not in str(found.value)


def test_files_say_what_was_found(checked, tmp_path):
    written = api.write_structural_check(checked, tmp_path, "dome")
    assert [path.name for path in written] == [*FILES, "model.inp"]
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted((*FILES, "model.inp"))
    with (tmp_path / "members.csv").open(encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    assert len(rows) == len(checked.model.frame.members)
    member = int(np.argmax(checked.utilisation))
    assert float(rows[member]["utilisation"]) == pytest.approx(
        checked.utilisation[member], abs=1e-4
    )
    by = checked.strength[checked.governing[member]]
    thrust = by.response.forces_at(checked.model.frame, 0.5)[member, 0]
    assert float(rows[member]["N_kN_middle"]) == pytest.approx(thrust / 1000, abs=1e-4)
    governing = [float(rows[member][f"{name}_governing"]) for name in ("N_kN", "My_kNm", "Mz_kNm")]
    expected = checked.governing_forces[member, [0, 4, 5]] / [1e3, 1e6, 1e6]
    assert governing == pytest.approx(expected, abs=1e-4)
    numbers = json.loads((tmp_path / "check.json").read_text(encoding="utf-8"))
    assert numbers["verdict"]["passed"] and numbers["not_checked"]
    given = {row["name"]: row for row in numbers["load_cases"]}
    for case in checked.model.cases:
        total = case.loads.total(checked.model.frame) / 1e3
        assert given[case.name]["sum_kN"] == pytest.approx(total)
    assert given["snow"]["given"] == "1.5 kN/m2 of plan"
    assert "pinned where nothing else is said, 20 nodes" in " ".join(numbers["assumptions"])
    model = json.loads((tmp_path / "model.json").read_text(encoding="utf-8"))
    assert len(model["nodes"]) == 35 and len(model["members"]) == len(rows)
    assert [case["name"] for case in model["load_cases"]] == [
        "self-weight", "panels", "snow", "wind 0.6@x"
    ]  # fmt: skip
    page = (tmp_path / "check.html").read_text(encoding="utf-8")
    assert f"{checked.deflection_limit:.1f} mm (1/200 of " in page
    assert checked.verdict in page and "Not checked" in page and page.count("<svg") == 10


def test_a_load_that_no_combination_takes_is_remarked_on(dome, tmp_path):
    path = tmp_path / "own.json"
    row = {"name": "mine", "kind": "strength", "factors": {"self-weight": 1.35}}
    path.write_text(json.dumps({"combinations": [row]}), encoding="utf-8")
    found = api.check_structure(dome, unit="m", snow=1.0, panels=0.4, combinations=path)
    missing = [words for words in warnings(found) if "is in no combination" in words]
    assert [words.split("'")[1] for words in missing] == ["panels", "snow"]
    assert "displacements are not checked" in found.verdict


def test_what_the_loads_leave_out_is_said(dome, checked):
    flat = dome.with_vertices(dome.vertices * [1.0, 1.0, 0.1])
    settings = {"unit": "m", "section": "tube:40x40x3", "material": "S355", "panels": 0.4}
    one_way = "Wind blows one way only"
    said = " ".join(warnings(checked))
    assert "on one half (--snow-side)" in said and one_way in said
    assert "near the first" not in said
    winds = ["0.6@x", "0.6@-x"]
    found = api.check_structure(
        flat, snow=1.0, snow_side="x", wind=winds, second_order=True, **settings
    )
    said = " ".join(warnings(found))
    assert "snow-side" not in said and one_way not in said and "There is no wind" not in said
    one, two = found.first_to_buckle.buckling.factors[:2]
    assert (f"next buckling factor, {two:.2f}, is near" in said) == (two < 1.2 * one)
    assert "There is no wind." in warnings(api.check_structure(dome, snow=1.0, unit="m"))
    assert warnings(api.check_structure(dome, unit="m", panels=0.4))[-1].startswith(
        "There is no snow, no wind"
    )


def test_the_combinations_that_were_written_are_read_again(dome, checked, tmp_path):
    api.write_structural_check(checked, tmp_path)
    again = api.check_structure(
        dome,
        unit="m",
        material="S355",
        snow=1.5,
        panels=0.4,
        wind="0.6@x",
        combinations=tmp_path / "combinations.json",
    )
    assert [one.combination for one in again.found] == [one.combination for one in checked.found]
    assert again.utilisation == pytest.approx(checked.utilisation, rel=1e-12)


def test_the_file_of_calculix_carries_the_whole_load(checked, tmp_path):
    api.write_structural_check(checked, tmp_path)
    text = (tmp_path / "model.inp").read_text(encoding="utf-8")
    steps = text.split("*STEP")[1:]
    assert len(steps) == len(checked.model.cases)
    for case, step in zip(checked.model.cases, steps, strict=True):
        lines = step.split("OP=NEW\n")[1].split("*")[0].strip().splitlines()
        loads = np.array([[float(word) for word in line.split(",")] for line in lines])
        total = [loads[loads[:, 1] == k, 2].sum() for k in (1, 2, 3)]
        assert total == pytest.approx(case.loads.total(checked.model.frame), rel=1e-6, abs=1e-3)


def test_a_model_that_calculix_has_not_leaves_no_file_of_it(dome, checked, tmp_path):
    api.write_structural_check(checked, tmp_path)
    rolled = api.check_structure(dome, unit="m", section="IPE80", material="S235", snow=1.0)
    names = [path.name for path in api.write_structural_check(rolled, tmp_path)]
    assert "model.inp" not in names and not (tmp_path / "model.inp").exists()


def test_the_fabrication_report_tells_the_check_of_its_net(dome, checked, tmp_path):
    panels = api.fabricate(dome, "panels", unit="m")
    api.write_structural_check(checked, tmp_path / "check")
    for check in (checked, tmp_path / "check" / "check.json"):
        api.write_fabrication(panels, tmp_path / "files", check=check)
        page = (tmp_path / "files" / "report.html").read_text(encoding="utf-8")
        assert checked.verdict in page and "Not checked:" in page
        assert page.count("as drawn</td>") == 5
        report = json.loads((tmp_path / "files" / "report.json").read_text(encoding="utf-8"))
        assert report["structural_check"]["verdict"]["words"] == checked.verdict
        assert "Bolts of the nodes" not in page
    hubs = api.fabricate(dome, "beams+nodes", unit="m", node="bolted", section="tube:100x60x5")
    api.write_fabrication(hubs, tmp_path / "files", check=checked)
    page = (tmp_path / "files" / "report.html").read_text(encoding="utf-8")
    pull = report["structural_check"]["largest_end_forces"]["tension_kN"]
    assert "Bolts of the nodes, 2 an end, bear 90.4 kN each in tension and" in page
    assert f"Members pull with {pull:.3g} kN at most" in page
    other = api.fabricate(primitive("translational", 4, 4), "panels", unit="m", panel_thickness=5)
    with pytest.raises(InputError, match="check: is of a net with 58 edges, and this one has 24"):
        api.write_fabrication(other, tmp_path / "other", check=checked)
    with pytest.raises(InputError, match=r"report.json is no check.json"):
        api.write_fabrication(panels, tmp_path, check=tmp_path / "files" / "report.json")


def test_panels_stiffen_where_they_are_told_to(dome, checked):
    settings = {"unit": "m", "material": "S355", "snow": 1.5, "panels": 0.4, "wind": "0.6@x"}
    stiff = api.check_structure(dome, panel_shear=5.0, **settings)
    assert stiff.factor > 1.2 * checked.factor and stiff.deflection < checked.deflection
    assert stiff.balance < 1e-9 and stiff.panel_shear > 0 == checked.panel_shear
    assert "G t = 5 kN/mm" in " ".join(assumptions(stiff))
    flat = dome.with_vertices(dome.vertices * [1.0, 1.0, 0.1])
    weak = {"unit": "m", "section": "tube:40x40x3", "material": "S355", "snow": 1.0}
    second = api.check_structure(flat, second_order=True, panel_shear=2.0, **weak)
    assert all(one.carried == 1.0 for one in second.strength if one.carried is not None)
    with pytest.raises(InputError, match="panel shear: expected 0 or more"):
        api.check_structure(dome, panel_shear=-1.0, **settings)


def test_what_only_wrong_units_come_to_is_asked_for(dome):
    found = api.check_structure(dome, unit="m", snow=1e9, modes=1)
    assert "beyond 100,000 % (are the units of net and loads right?)" in found.verdict
    assert check_numbers(found)["governing_members"][0]["used"] == "> 100,000 %"
