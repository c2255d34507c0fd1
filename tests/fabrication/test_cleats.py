"""Cleats and feet of lamellas: in the corners of last crossings, bolted, clear of all else."""

import math

import numpy as np
import pytest

from freecad_ortho.fabrication import build
from freecad_ortho.fabrication.bezier import blend
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.cleat import corner_of
from freecad_ortho.fabrication.exchange.ifc_facts import class_of
from freecad_ortho.fabrication.limits import OK
from freecad_ortho.fabrication.material import MATERIALS
from freecad_ortho.fabrication.systems import Feet, Lamellas
from freecad_ortho.fabrication.systems.lamellas.cleat_sizes import sizes_of
from solver.errors import InputError
from tests.fabrication.test_lamellas import flat_grid, helicoid

SIZES = {"width": 60.0, "thickness": 4.0, "strip": "twisted"}


@pytest.fixture(scope="module")
def net():
    return helicoid(5, 5).scaled(6000.0)


@pytest.fixture(scope="module")
def standing(net):
    """Twisted lamellas with cleats on feet at the corners."""
    return build(net, [Lamellas(cleats=True, **SIZES), Feet(foot_height=900.0)])


def of_kind(structure, kind):
    return [part for part in structure.parts if part.kind == kind]


def test_every_last_crossing_has_a_cleat(net, standing):
    boundary = np.flatnonzero(net.connectivity.boundary_vertices)
    cleats = of_kind(standing, "cleat")
    assert [part.vertices[0] for part in cleats] == boundary.tolist()
    assert standing.report()["lamellas"]["cleats"] == len(boundary)
    # At corners, where edges are far from square to the fold, legs have one bolt.
    single = [part for part in cleats if len(part.pattern.holes) == 2]
    assert 0 < len(single) < len(cleats)
    [words] = [word for word in standing.report()["messages"] if "one bolt" in word]
    assert f"{len(single)} of {len(cleats)} cleats" in words
    assert single[0].name in words
    assert set(standing.verdicts) == {OK}


def test_nothing_clashes(standing):
    found = check_clashes(standing.parts)
    assert found.near > len(of_kind(standing, "cleat"))
    assert (found.clashes, found.open) == ((), ())


def test_solids_have_the_volume_of_the_formula(standing):
    for part in (*of_kind(standing, "cleat")[::3], *of_kind(standing, "fin")):
        holes = sum(np.pi / 4 * hole.diameter**2 for hole in part.pattern.holes)
        assert part.solid().isValid()
        assert part.solid().Volume() == pytest.approx(part.volume, rel=1e-9)
        if part.kind == "cleat":
            # The middle of a sharp fold keeps area times thickness.
            assert part.volume == pytest.approx(part.pattern.area * part.thickness, rel=1e-9)
        else:
            whole = part.body.whole.volume
            assert part.volume == pytest.approx(whole - holes * part.thickness, rel=1e-9)


def test_patterns_of_cleats_fold_back_onto_their_bolts(standing):
    geometry = standing.results["lamellas"].geometry
    for part in of_kind(standing, "cleat"):
        cleat = geometry.cleats[part.vertices[0]]
        [fold] = part.pattern.bends
        angle, at = math.radians(fold.angle_deg), fold.points[0, 0]
        middle = part.thickness / 2
        places = []
        for hole in part.pattern.holes:
            x, y = hole.centre
            beyond = max(x - at, 0.0)
            flat = [min(x, at) + beyond * math.cos(angle), y, middle + beyond * math.sin(angle)]
            places.append(part.origin + np.array(flat) @ part.frame - standing.site.shift)
        wanted = [
            place + middle * leg.out
            for number, leg in enumerate(cleat.legs)
            for place in cleat.bolts(number)
        ]
        assert np.abs(np.array(places) - np.array(wanted)).max() < 1e-6


def test_twisted_plates_stay_between_leg_and_fin(net):
    """Also below the leg, where the fin goes on, and where edges are not square to the corner."""
    made = build(net, [Lamellas(80.0, 12.0, cleats=True, strip="twisted")])
    shares, lamellas = np.linspace(0.0, 1.0, 401), {part.name: part for part in made.parts}
    for cleat in made.results["lamellas"].geometry.cleats.values():
        for leg in cleat.legs:
            part = lamellas[leg.part]
            sheets = part.body.whole.sheets
            rails = [rail for each in sheets if each.rails is not None for rail in each.rails]
            edges = np.concatenate([blend(len(rail), shares) @ rail for rail in rails])
            arms = part.origin + edges @ part.frame - made.site.shift - cleat.corner
            along = arms @ leg.way
            beside = (along > 0) & (along < cleat.sizes.reach) & (np.abs(arms @ cleat.up) < 80.0)
            off = arms[beside] @ leg.out
            assert len(off) > 10
            assert -(cleat.sizes.plate + 2 * leg.gap) - 1e-6 < off.min() < off.max() < 1e-6
            # No further off than it takes.
            assert off.max() > -2 * leg.gap - 1e-6


def test_bolts_go_through_fin_lamella_and_leg(standing):
    drilled = {}
    for part in standing.parts:
        if getattr(part.body, "drills", ()):
            centres = np.array([drill.centre for drill in part.body.drills])
            drilled[part.name] = part.origin + centres @ part.frame
    counted = 0
    for each in standing.fasteners:
        for place, way, names in zip(each.places, each.directions, each.joins, strict=True):
            counted += 1
            depths = []
            for name in names:
                arms = drilled[name] - place
                depth = arms @ way
                off = np.linalg.norm(arms - depth[:, None] * way, axis=1)
                # Between two edges a lamella leans a little off the plane of the leg.
                assert off.min() < (0.2 if name.startswith("L-") else 1e-6)
                depths.append(depth[int(off.argmin())])
            assert each.bolt.washer < depths[0] < depths[-1] < each.grip - each.bolt.washer
            assert depths == sorted(depths)
    holes = sum(len(part.pattern.holes) for part in of_kind(standing, "cleat"))
    assert counted == holes
    fins = [part.name for part in of_kind(standing, "fin")]
    joined = {names[0] for each in standing.fasteners for names in each.joins if len(names) == 3}
    assert joined == set(fins)
    assert len(fins) == 8


def test_each_kind_has_a_class_of_ifc(standing):
    found = {part.kind: class_of(part)[:2] for part in standing.parts}
    assert found["cleat"] == ("IfcDiscreteAccessory", "BRACKET")
    assert found["fin"] == ("IfcPlate", "SHEET")
    assert "IfcBuildingElementProxy" not in {name for name, _ in found.values()}


def test_fins_stand_on_their_caps(standing):
    caps = {part.name[:6]: part for part in standing.parts if part.name.endswith("cap")}
    for fin in of_kind(standing, "fin"):
        cap = caps[fin.name[:6]]
        corners = (fin.origin + fin.body.points @ fin.frame - cap.origin) @ cap.frame.T
        assert corners[:, 2].min() == pytest.approx(cap.thickness, abs=1e-9)
        on_it = corners[np.abs(corners[:, 2] - cap.thickness) < 1e-6]
        assert len(on_it) == 4
        assert on_it[:, :2].min() > 9.9
        assert on_it[:, :2].max() < cap.length - 9.9


@pytest.mark.parametrize("angle", [50.0, 70.0, 90.0, 120.0])
def test_bolts_keep_their_distances_at_any_angle(angle):
    settings = Lamellas(60.0, 4.0)
    sizes = sizes_of(settings, math.radians(angle))
    assert sizes.bolt.name == "M8"
    assert sizes.reach - sizes.back >= 1.2 * 9
    assert sizes.height / 2 - max(sizes.levels) >= 1.2 * 9
    # From the slot that the other lamella passes, and for a wrench in both corners.
    assert sizes.back - (4.0 / 2 + 1.0) / math.sin(math.radians(angle)) >= 1.2 * 9
    for corner in (angle, 180.0 - angle):
        sine, cosine = math.sin(math.radians(corner)), math.cos(math.radians(corner))
        free = sizes.back * sine - sizes.thickness * cosine - sizes.thickness
        assert free >= sizes.bolt.wrench


def test_cleats_beside_thick_wood_are_as_thick_as_their_bolts(net):
    """Of steel, with washers that wood takes; above feet steel lies under heads and nuts alike.

    These are so thick that the corners in which legs begin are far off the axes: fins have to stand
    off what the twist makes of plates there.
    """
    sizes = {"width": 100.0, "thickness": 30.0, "hole": 11.0, "strip": "twisted"}
    made = build(
        net.scaled(1.2), [Lamellas(cleats=True, **sizes), Feet()], material=MATERIALS["plywood"]
    )
    cleats = of_kind(made, "cleat")
    assert {part.material.name for part in cleats} == {"steel"}
    assert {part.thickness for part in (*cleats, *of_kind(made, "fin"))} == {10.0}
    found = check_clashes(made.parts)
    assert (found.clashes, found.open) == ((), ())
    washers = {each.holds: each.bolt.washers for each in made.fasteners}
    assert washers["lamellas and cleats"] == "DIN 440 R"
    assert washers["feet, lamellas and cleats"] == "EN ISO 7089"
    for each in made.fasteners:
        stand = 10.0 if each.holds.startswith("feet") else 0.0
        assert each.grip >= 30.0 + 10.0 + stand + 2 * each.bolt.washer
    # Of the lamellas' own metal they are as thick as these.
    assert sizes_of(Lamellas(120.0, 21.0, hole=11.0), math.pi / 2).thickness == 25.0


def test_planes_cross_in_the_corner():
    rng = np.random.default_rng(3)
    normals = rng.normal(size=(2, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    points, near = rng.normal(size=(2, 3)), rng.normal(size=3)
    corner, along = corner_of((points[0], points[1]), (normals[0], normals[1]), near)
    assert np.abs(((corner - points) * normals).sum(axis=1)).max() < 1e-12
    assert abs((corner - near) @ along) < 1e-12


def test_splices_keep_clear_of_cleats(net):
    # Along the border every crossing has one: splices need longer edges there.
    made = build(net, [Lamellas(cleats=True, stock=5000.0, **SIZES)])
    assert made.report()["lamellas"]["splices"] > 0
    found = check_clashes(made.parts)
    assert (found.clashes, found.open) == ((), ())
    short = flat_grid().scaled(0.4)
    without = Lamellas(60, 4, stock=400.0)
    assert build(short, [without]).report()["lamellas"]["splices"] > 0
    with pytest.raises(InputError, match=r"stock: L-\w000 .* plane edges of 1\d\d mm"):
        build(short, [Lamellas(60, 4, stock=400.0, cleats=True)])


def test_wood_has_cleats_of_steel(net):
    made = build(net, [Lamellas(cleats=True, **SIZES)], material=MATERIALS["plywood"])
    assert {part.material.name for part in of_kind(made, "cleat")} == {"steel"}
    aluminium = build(net, [Lamellas(cleats=True, **SIZES)], material=MATERIALS["aluminium"])
    assert {part.material.name for part in of_kind(aluminium, "cleat")} == {"aluminium"}


def test_cleats_without_room_are_left_out_and_named():
    made = build(flat_grid().scaled(0.08), [Lamellas(60, 4, cleats=True)])
    report = made.report()
    assert report["lamellas"]["cleats"] == 0
    [words] = [word for word in report["messages"] if "cleats are left out" in word]
    assert "C0000" in words
    with pytest.raises(InputError, match="foot at: at vertex 0 no two lamellas"):
        build(flat_grid().scaled(0.08), [Lamellas(60, 4), Feet()])


@pytest.mark.parametrize("spare", [-0.5, 0.5])
def test_between_two_cleats_there_is_room_for_both(spare):
    lamellas = Lamellas(60, 4, cleats=True)
    sizes = sizes_of(lamellas, math.pi / 2)
    edge = 2 * sizes.reach + sizes.plate + lamellas.clearance + spare
    made = build(flat_grid(2, 2).scaled(edge / 400), [lamellas])
    assert (made.report()["lamellas"]["cleats"] > 0) == (spare > 0)


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"layers": 2, "feet": "corners"}, "cleats: feet carry lamellas that stand in one layer"),
        ({"position": "tilted", "feet": "corners"}, "take position standing and layers 1"),
        ({"layers": 2, "position": "lying"}, "lying lamellas are held by a bolt at every crossing"),
        ({"smooth": True}, "smooth: legs of cleats lie on faceted lamellas"),
        ({"width": 20.0}, r"hole: cleats with holes of 9 mm need lamellas at least 21.6 mm wide"),
    ],
)
def test_what_cannot_have_cleats_says_so(values, words):
    with pytest.raises(InputError, match=words):
        Lamellas(cleats=True, **values)
