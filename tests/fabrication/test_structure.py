"""Systems by name, chosen lines, materials, limits and verdicts; parts that travel."""

import json
import pickle
from dataclasses import replace

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.fabrication import (
    MATERIALS,
    SYSTEMS,
    Beams,
    Limits,
    Measures,
    Panels,
    Selection,
    build,
    material,
    systems_of,
)
from freecad_ortho.fabrication.limits import verdict
from freecad_ortho.fabrication.production import produce
from freecad_ortho.fabrication.systems.beams.options import ENDS
from solver.errors import InputError
from solver.mesh.quadmesh import QuadMesh
from tests.conftest import grid_faces


def test_systems_come_in_the_order_of_building_with_their_defaults():
    assert systems_of("panels+beams", {"thickness": 9.0}) == [
        Beams(200.0, 9.0, "centre"),
        Panels(9.0, 8.0, "centre"),
    ]
    assert systems_of("beams+panels", {"panel_thickness": 5.0, "offset": "above"}) == [
        Beams(200.0, 20.0, "above"),
        Panels(5.0, 8.0, "above"),
    ]


@pytest.mark.parametrize(
    ("names", "values", "words"),
    [
        ("", {}, "system: expected edge-beam, beams, nodes"),
        ("beams+beams", {}, "system: expected "),
        ("walls", {}, "got 'walls'"),
        ("beams", {"colour": 1}, "colour: no system has such a size"),
        (
            "panels",
            {"height": 999.0},
            "height: panels has no such size, it is of edge-beam, beams, nodes",
        ),
        ("nodes+panels", {"tilt": 9.0}, r"tilt: nodes\+panels has no such size, it is of louvres"),
    ],
)
def test_bad_systems_are_one_line(names, values, words):
    with pytest.raises(InputError, match=words) as caught:
        systems_of(names, values)
    assert "\n" not in str(caught.value)


def test_chosen_lines_keep_their_names(roof):
    whole = build(roof, [Beams(200, 12)])
    names = {part.name: part for part in whole.parts}
    for family, lines in (("u", None), ("v", (0, 3)), ("both", (1,))):
        some = build(roof, [Beams(200, 12)], selection=Selection(family, lines)).parts
        expected = [
            part.name
            for part in whole.parts
            if family in ("both", part.family) and (lines is None or part.line in lines)
        ]
        assert [part.name for part in some] == expected
        assert 0 < len(some) < len(names)
        assert all(np.array_equal(part.points, names[part.name].points) for part in some)


def test_lines_that_are_not_there_are_refused(roof):
    with pytest.raises(InputError, match="lines: the net has 7 u and 10 v lines"):
        api.fabricate(roof, "beams", family="u", lines=[77])
    with pytest.raises(InputError, match="family: expected u, v or both, got 'w'"):
        api.fabricate(roof, "beams", family="w")
    with pytest.raises(InputError, match=r"counted from 0, and no 10, 99; choose"):
        api.fabricate(roof, "beams", lines=[9, 99, 0, 10])
    with pytest.raises(InputError, match="lines: expected numbers from 0 on"):
        api.fabricate(roof, "beams", lines=[])


def test_unknown_material_is_refused(roof):
    with pytest.raises(InputError, match=r"material: expected steel.*got 'gold'"):
        api.fabricate(roof, material="gold")


@pytest.mark.parametrize("name", MATERIALS)
def test_least_radius_is_where_the_stress_reaches_the_limit(name):
    chosen = material(name)
    radius = chosen.least_radius(8.0)
    assert chosen.bending_stress(8.0, radius) == pytest.approx(chosen.bending_limit)
    assert chosen.bending_stress(8.0, 2 * radius) == pytest.approx(chosen.bending_limit / 2)
    assert chosen.mass(1e9) == chosen.density


def test_bending_stress_of_steel():
    assert material("steel").bending_stress(5.0, 2000.0) == pytest.approx(262.5)


def test_verdict_says_what_exceeds_which_limit(structure):
    part = structure.parts[0]
    assert verdict(part, Limits()) == "ok"
    worse = replace(part, measures=Measures(gap_mm=0.8, twist_deg=2.0, stress_MPa=900.0))
    worse = replace(worse, measures=replace(worse.measures, min_bend_radius_mm=1400.0))
    words = verdict(worse, Limits(gap_mm=0.5, twist_deg=None))
    assert words == (
        "gap 0.8 mm exceeds 0.5 mm; bending stress 900 MPa exceeds 355 MPa of steel: bent to "
        "1400 mm, needs 3549 mm"
    )
    assert "twist 2 degrees exceeds 1 degrees" in verdict(worse, Limits())
    with pytest.raises(InputError, match="limit of gap: expected a number above 0 mm, got -1"):
        Limits(gap_mm=-1)


def test_stress_passes_up_to_the_limit_of_its_material(structure):
    part = structure.parts[0]
    limit = part.material.bending_limit

    def said(stress):
        return verdict(
            replace(part, measures=Measures(stress_MPa=stress, min_bend_radius_mm=1400.0)), Limits()
        )

    assert said(0.99 * limit) == "ok"
    assert f"bending stress {1.01 * limit:.3g} MPa exceeds {limit:g} MPa" in said(1.01 * limit)


def test_report_counts_who_passes(twisted):
    structure = build(twisted, [Beams(200, 12)], limits=Limits(twist_deg=0.1))
    found = structure.report()["verdict"]
    over = [part.name for part in structure.parts if part.measures.twist_deg > 0.1]
    assert set(found["failed"]) >= set(over) != set()
    assert found["passed"] == len(structure.parts) - len(found["failed"])


def test_parts_travel_without_their_solids(structure):
    part = structure.parts[0]
    part.solid()
    again = pickle.loads(pickle.dumps(part))
    assert "_solid" not in vars(again)
    assert np.array_equal(again.points, part.points)
    assert again.solid().Volume() == pytest.approx(part.volume, rel=1e-9)
    assert part.body.volume == pytest.approx(part.volume, rel=1e-9)


def plane_grid(columns):
    """A row of level squares of 1 m."""
    x, y = np.meshgrid(np.arange(columns), np.arange(2), indexing="ij")
    points = np.stack([x, y, 0 * x], axis=-1).reshape(-1, 3)
    return QuadMesh(1000.0 * points, grid_faces(columns, 2))


@pytest.mark.parametrize("name", SYSTEMS)
def test_reports_of_level_nets_hold_no_number_that_json_has_not(name):
    thin = any(option.name == "thickness" for option in SYSTEMS[name].options)
    structure = build(plane_grid(4), systems_of(name, {"thickness": 8.0} if thin else {}))
    assert json.loads(json.dumps(produce(structure).report(), allow_nan=False))["systems"] == [name]


@pytest.mark.parametrize("ends", ENDS)
def test_a_net_without_inner_edges_has_no_inner_beams(ends):
    sizes = {"ends": ends, "no_boundary_beams": True}
    if ends == "cone":
        sizes["section"] = "chs:88.9x5"
    with pytest.raises(InputError, match="beams: nothing to build on this net"):
        build(plane_grid(2), systems_of("beams", sizes))
    with pytest.raises(InputError, match="nodes: nothing to build on this net"):
        build(plane_grid(2), systems_of("nodes", {"no_boundary_beams": True}))


def test_limits_are_made_of_their_options():
    given = {"limit_gap": 0.5, "limit_twist": 0.0, "limit_lean": 12.0}
    assert Limits.of(given) == Limits(gap_mm=0.5, twist_deg=None, lean_deg=12.0)
    usual = {option.name: option.default for option in Limits.options}
    assert Limits.of(usual) == Limits()
    with pytest.raises(InputError, match="limit of twist: expected a number above 0"):
        Limits.of({"limit_twist": -1.0})
