"""The frame and the loads that a net becomes."""

import numpy as np
import pytest

from freecad_ortho.fabrication.profiles import profile
from freecad_ortho.structural.combinations import SERVICE, STRENGTH, read_combinations, usual
from freecad_ortho.structural.design import Design
from freecad_ortho.structural.model import model_of
from solver.errors import InputError
from solver.mesh.primitives import primitive


@pytest.fixture(scope="module")
def dome():
    """Six by four metres, two metres high."""
    mesh = primitive("translational", 7, 5)
    return mesh.with_vertices(2000.0 * mesh.vertices)


def model(mesh, **settings):
    return model_of(mesh, Design.of(settings))


def totals(found):
    return {case.name: case.loads.total(found.frame) for case in found.cases}


def test_loads_are_what_they_are_by_their_areas(dome):
    found = model(dome, snow=1.5, panels=0.4, wind=["0.6@x", "0.5@z"], load="8:1,-2,-5")
    got, area = totals(found), dome.face_area_vectors
    area = area if area[:, 2].sum() > 0 else -area
    section, length = profile("tube:100x60x5"), found.frame.lengths.sum()
    weight = -section.area * length * 1e-9 * 7850 * 9.81
    assert got["self-weight"] == pytest.approx([0, 0, weight])
    assert found.mass == pytest.approx(-weight / 9.81)
    assert got["snow"] == pytest.approx([0, 0, -1.5e-3 * np.abs(area[:, 2]).sum()])
    assert got["panels"] == pytest.approx([0, 0, -0.4e-3 * np.linalg.norm(area, axis=1).sum()])
    # Both sides are pushed along x, and the flanks that the wind passes are not.
    assert got["wind 0.6@x"][0] > 0 and got["wind 0.5@z"][2] > 0
    assert got["point loads"] == pytest.approx([1000, -2000, -5000])
    plan = np.ptp(dome.vertices, axis=0)
    assert -got["snow"][2] == pytest.approx(1.5e-3 * plan[0] * plan[1])


def test_wind_pushes_the_windward_side_and_pulls_the_other(dome):
    found = model(dome, wind="1@x")
    (wind,) = [case for case in found.cases if case.kind == "wind"]
    middle = dome.vertices[found.frame.members].mean(axis=1)
    x = middle[:, 0] - middle[:, 0].mean()
    windward = x < -1500
    assert (wind.loads.spread[windward, 2] < 0).all()
    assert (wind.loads.spread[x > 1500, 2] > 0).all()


def test_snow_on_one_half_is_about_half_of_it(dome):
    got = totals(model(dome, snow=1.0, snow_side="x"))
    assert got["snow on one half"][2] == pytest.approx(0.5 * got["snow"][2])


def test_a_load_of_a_face_goes_to_its_edges():
    square = primitive("rectangle", 2, 2, length=2.0, width=2.0)
    square = square.with_vertices(1000.0 * square.vertices)
    found = model(square, snow=1.0, self_weight=False, supports="corners:fixed")
    assert found.cases[0].loads.spread[:, 2] == pytest.approx(np.full(4, -0.5))


def test_sections_stand_upright_along_the_axes(dome):
    found = model(dome, snow=1.0)
    z = found.frame.axes[:, 2]
    normal = dome.vertex_normals[found.frame.members].mean(axis=1)
    along = np.abs((z * normal).sum(axis=1)) / np.linalg.norm(normal, axis=1)
    assert along.min() > 0.97
    assert set(found.families) == {"u", "v", "border"}


def test_supports_are_where_they_are_said_to_be(dome):
    corners = dome.connectivity.corners
    held = model(dome, snow=1.0, supports="boundary:sliding+corners+17:fixed").supports
    assert (held.fixed[corners] == [1, 1, 1, 0, 0, 0]).all()
    border = dome.connectivity.boundary_vertices & ~corners
    assert (held.fixed[border] == [0, 0, 1, 0, 0, 0]).all()
    assert held.fixed[17].all() and not held.fixed[16].any()
    springs = model(dome, snow=1.0, supports="0,1:springs=1/2/0.5").supports.springs
    assert springs[:2, :3].tolist() == [[1000, 2000, 500]] * 2


def test_combinations_are_those_of_en_1990(dome):
    found = model(dome, snow=1.0, panels=0.3, wind=["0.5@x", "0.5@y"])
    rows = {one.name: one for one in usual(found.cases)}
    lead = "strength: 1.35 self-weight + 1.35 panels + 1.5 snow + 0.9 wind 0.5@y"
    assert lead in rows and rows[lead].kind == STRENGTH
    assert "strength: 1 self-weight + 1 panels + 1.5 wind 0.5@x" in rows
    assert "service: 1 self-weight + 1 panels + 1 wind 0.5@x + 0.5 snow" in rows
    # Winds from two sides never act together.
    winds = [sum("wind" in name for name in one.factors) for one in rows.values()]
    assert max(winds) == 1
    assert [one.permanent(found.cases) for one in rows.values()].count(True) == 2
    assert {one.kind for one in rows.values()} == {STRENGTH, SERVICE}


def test_own_combinations_are_read_and_bad_ones_refused(dome, tmp_path):
    cases = model(dome, snow=1.0).cases
    path = tmp_path / "own.json"
    row = '{"name": "mine", "kind": "strength", "factors": {"snow": 2}}'
    path.write_text(f'{{"combinations": [{row}]}}', encoding="utf-8")
    (mine,) = read_combinations(path, cases)
    assert (mine.name, mine.factors) == ("mine", {"snow": 2})
    for bad, said in (
        (row.replace('"snow"', '"hail"'), "has no load case 'hail'; there are self-weight, snow"),
        (row.replace("strength", "beauty"), "expected combinations with name, kind"),
        (row.replace("2}", '"two"}'), "expects a number for 'snow'"),
        ("", "expected a list 'combinations'"),
    ):
        path.write_text(f'{{"combinations": [{bad}]}}', encoding="utf-8")
        with pytest.raises(InputError, match=said):
            read_combinations(path, cases)
    path.write_text("[", encoding="utf-8")
    with pytest.raises(InputError, match="is no JSON file that can be read"):
        read_combinations(path, cases)


@pytest.mark.parametrize(
    ("settings", "said"),
    [
        ({"self_weight": False}, "loads: there are none"),
        ({"snow": -1}, "snow: expected 0 kN/m2 or more"),
        ({"wind": "0.6"}, "wind: expected a pressure in kN/m2 and where it blows to"),
        ({"wind": "0.6@q"}, "wind: expected a pressure"),
        ({"wind": ["1@x", "1@x"]}, "wind: '1@x' is given twice"),
        ({"load": "3:1,2"}, "load: expected a vertex and a force in kN"),
        ({"load": "300:0,0,1"}, "load: there is no vertex 300 in the net; it has 35"),
        ({"supports": "edges"}, "supports: expected boundary, corners or numbers of vertices"),
        ({"supports": "99"}, "supports: there is no vertex 99 in the net; it has 35"),
        ({"supports": "boundary:glued"}, "supports: expected pinned, fixed, sliding or springs="),
        ({"supports": "1:springs=2"}, "supports: expected springs=X/Y/Z, three stiffnesses"),
        ({"joints": "soft"}, "joints: expected rigid, hinged or a stiffness in kNm/rad"),
        ({"section": "tube:1x1x1"}, "section"),
        ({"pieces": 1}, "pieces: expected a whole number, 2 or more, got 1"),
        ({"modes": 0}, "modes: expected a whole number, 1 or more, got 0"),
        ({"sections": "IPE200"}, "check_structure: has no 'sections'; it has section, "),
    ],
)
def test_what_cannot_be_used_is_refused_in_one_line(dome, settings, said):
    with pytest.raises(InputError, match=said) as found:
        model(dome, **settings)
    assert "\n" not in str(found.value)
