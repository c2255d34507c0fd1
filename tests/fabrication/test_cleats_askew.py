"""Cleats of lamellas in two layers and of tilted ones: each leg on its own plate, along it."""

import math

import numpy as np
import pytest
import shapely

from freecad_ortho.fabrication import Lamellas, build
from freecad_ortho.fabrication.clash import check_clashes
from tests.fabrication.test_tilted_lamellas import net as tilting
from tests.meshes import helicoid

SIZES = {"width": 60.0, "thickness": 4.0, "cleats": True}


@pytest.fixture(scope="module", params=["two layers", "tilted"])
def made(request):
    if request.param == "two layers":
        return build(helicoid(5, 5).scaled(6000.0), [Lamellas(layers=2, **SIZES)])
    return build(tilting(), [Lamellas(position="tilted", **SIZES)])


def cleats_of(made):
    geometry = made.results["lamellas"].geometry
    return [
        (part, geometry.cleats[part.vertices[0]]) for part in made.parts if part.kind == "cleat"
    ]


def test_they_stand_at_all_crossings_of_two_layers_and_at_ends_of_tilted_ones(made):
    settings = made.results["lamellas"].settings
    numbers = made.report()["lamellas"]
    found = {part.vertices[0] for part, _ in cleats_of(made)}
    border = set(np.flatnonzero(made.site.mesh.connectivity.boundary_vertices).tolist())
    if settings.layers == 2:
        assert numbers["cleats"] == numbers["crossings"] == len(found) == 25
        assert not any("weld" in words for words in numbers.get("messages", []))
    else:
        assert found <= border
        assert numbers["cleats"] == 23
        [words] = [words for words in made.report()["messages"] if "are left out" in words]
        assert f"{len(border) - 23} of {len(border)} cleats" in words
    assert not any("nothing holds" in words for words in made.report()["messages"])


def test_nothing_clashes(made):
    found = check_clashes(made.parts)
    assert found.near > len(cleats_of(made))
    assert (found.clashes, found.open) == ((), ())


def test_solids_and_patterns_have_the_volume_of_the_formula(made):
    askew = 0
    for part, cleat in cleats_of(made):
        askew += cleat.askew
        assert part.solid().isValid()
        assert part.solid().Volume() == pytest.approx(part.volume, rel=1e-9)
        assert part.volume == pytest.approx(part.pattern.area * part.thickness, rel=1e-9)
        assert sum(block.volume for block in part.body.pieces()) == pytest.approx(
            part.body.whole.volume, rel=1e-9
        )
        assert part.pattern.outline.min(axis=0) == pytest.approx([0.0, 0.0], abs=1e-9)
    assert askew > 0


def test_patterns_fold_back_onto_their_bolts_and_corners(made):
    for part, cleat in cleats_of(made):
        [fold] = part.pattern.bends
        angle, at, middle = math.radians(fold.angle_deg), fold.points[0, 0], part.thickness / 2

        def folded(flat, part=part, angle=angle, at=at, middle=middle):
            beyond = max(flat[0] - at, 0.0)
            local = [
                min(flat[0], at) + beyond * math.cos(angle),
                flat[1],
                middle + beyond * math.sin(angle),
            ]
            return part.origin + np.array(local) @ part.frame - made.site.shift

        wanted = [
            place + middle * leg.out
            for number, leg in enumerate(cleat.legs)
            for place in cleat.bolts(number)
        ]
        places = [folded(hole.centre) for hole in part.pattern.holes]
        assert np.abs(np.array(places) - np.array(wanted)).max() < 1e-6
        # The ends of both legs, in the middle of the plate, are those of the solid.
        corners = part.origin + part.body.points @ part.frame - made.site.shift
        for flat in part.pattern.outline:
            if min(flat[0], part.length - flat[0]) < 1e-9:
                off = np.linalg.norm(corners - folded(flat), axis=1)
                assert off.min() == pytest.approx(middle, abs=1e-6)


def test_bolts_keep_their_distances_in_cleats_and_lamellas(made):
    hole = made.results["lamellas"].settings.hole
    for part in made.parts:
        if part.pattern is None:
            continue
        openings = [shapely.Polygon(cut) for cut in part.pattern.cutouts]
        plate = shapely.Polygon(part.pattern.outline).difference(shapely.union_all(openings))
        for each in part.pattern.holes:
            assert plate.boundary.distance(shapely.Point(each.centre)) >= 1.2 * hole - 1e-6
        centres = np.array([each.centre for each in part.pattern.holes])
        if part.kind == "cleat":
            for leg in (centres[: len(centres) // 2], centres[len(centres) // 2 :]):
                apart = np.linalg.norm(np.diff(leg, axis=0), axis=1)
                assert (apart >= 2.2 * hole - 1e-9).all()


def test_bolts_pass_the_lamella_and_the_leg(made):
    drilled = {}
    for part in made.parts:
        if getattr(part.body, "drills", ()):
            centres = np.array([drill.centre for drill in part.body.drills])
            drilled[part.name] = part.origin + centres @ part.frame
    counted = 0
    for each in made.fasteners:
        for place, way, names in zip(each.places, each.directions, each.joins, strict=True):
            counted += 1
            for name in names:
                arms = drilled[name] - place
                depth = arms @ way
                off = np.linalg.norm(arms - depth[:, None] * way, axis=1)
                nearest = int(off.argmin())
                assert off[nearest] < (0.25 if name.startswith("L-") else 1e-6)
                assert each.bolt.washer < depth[nearest] < each.grip - each.bolt.washer
    assert counted == sum(len(part.pattern.holes) for part, _ in cleats_of(made))


def test_legs_rise_with_their_lamellas_and_hardly_leave_them(made):
    lamellas = {one.name: one for one in made.results["lamellas"].geometry.lamellas}
    for _, cleat in cleats_of(made):
        for leg in cleat.legs:
            if leg.slope == 0.0:
                continue
            one = lamellas[leg.part]
            station = one.stations[one.vertices.index(cleat.vertex)]
            along = leg.way + leg.slope * cleat.up
            along /= np.linalg.norm(along)
            edges = one.ribbon.strip.along[[station - 1, station]]
            assert np.abs(edges @ along).max() > math.cos(math.radians(1.0))
            assert leg.gap <= 3.0


def test_legs_of_two_layers_are_bolted_to_their_own_one():
    made = build(helicoid(5, 5).scaled(6000.0), [Lamellas(layers=2, **SIZES)])
    lamellas = {one.name: one for one in made.results["lamellas"].geometry.lamellas}
    for _, cleat in cleats_of(made):
        for number, leg in enumerate(cleat.legs):
            one = lamellas[leg.part]
            station = one.stations[one.vertices.index(cleat.vertex)]
            middle = (one.ribbon.lower + one.ribbon.upper) / 2
            arms = cleat.bolts(number) - one.ribbon.strip.points[station]
            ways = one.ribbon.strip.along[[station - 1, station]] @ leg.way
            face = station - 1 + int(np.abs(ways).argmax())
            levels = arms @ one.ribbon.strip.across[0][face]
            # Within the plate, about its middle, where edges are not square to the corner.
            assert np.sign(levels).tolist() == [np.sign(middle)] * len(levels)
            assert abs(levels.mean() - middle) < 8.0
