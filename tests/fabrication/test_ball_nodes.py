"""Ball nodes: sizes by rule, tubes that meet in the middle of balls, holes for their bolts."""

from collections import Counter

import numpy as np
import pytest
from OCP.BRepGProp import BRepGProp
from OCP.GProp import GProp_GProps

from freecad_ortho import api
from freecad_ortho.fabrication.ball_body import Ball
from freecad_ortho.fabrication.bolts import BOLTS
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.step import read_step, write_step
from freecad_ortho.fabrication.stock import different_tubes
from freecad_ortho.fabrication.systems.beams.balls import BallJoints
from freecad_ortho.fabrication.turned import TurnedBody
from solver.errors import InputError
from tests.fabrication.test_beam_sections_and_ends import assert_closed

TUBE = "chs:88.9x5"


@pytest.fixture(scope="module")
def joined(roof):
    """Round tubes on balls under panels."""
    return api.fabricate(roof, "beams+nodes+panels", node="ball", section=TUBE)


def of_kind(made, kind):
    return [part for part in made.parts if part.kind == kind]


def volume_of(shape):
    """Of round faces with openings the kernel's usual integration is off by some millionths."""
    found = GProp_GProps()
    BRepGProp.VolumeProperties_s(shape.wrapped, found, 1e-10, False, False)
    return found.Mass()


@pytest.mark.parametrize("name", ["roof", "skewed", "dodecahedron", "twisted"])
def test_nothing_clashes_with_default_sizes(meshes, joined, name):
    made = joined
    if name != "roof":
        made = api.fabricate(meshes[name], "beams+nodes+panels", node="ball", section=TUBE)
    found = check_clashes(made.parts)
    assert found.near > len(of_kind(made, "beam"))
    assert (found.clashes, found.open) == ((), ())


def test_polyhedra_for_the_clash_check_hold_balls_and_cones_closely():
    (held,) = Ball(50.0, np.array([[1.0, 0.0, 0.0]]), 45.0, 20.0, 30.0).pieces()
    corners = np.asarray(held.corners)
    # Planes 30 degrees apart touch it all around; one of them is the seat.
    assert np.linalg.norm(corners, axis=1).max() < 50.0 * 1.1
    assert corners.max(axis=0) == pytest.approx([45.0, 50.0, 50.0], rel=0.04)
    assert corners.min(axis=0) == pytest.approx([-50.0, -50.0, -50.0], rel=0.04)
    cone = TurnedBody(np.array([[0.0, 30.0], [40.0, 20.0]]), np.array([[0.0, 5.0], [40.0, 5.0]]))
    for station, radius in cone.outer:
        ring = cone.points[cone.points[:, 2] == station][:, :2]
        # The middles of its sides touch the circle.
        middles = (ring + np.roll(ring, -1, axis=0)) / 2
        np.testing.assert_allclose(np.linalg.norm(middles, axis=1), radius, rtol=1e-12)


@pytest.mark.parametrize("offset", ["above", "below"])
def test_axes_of_tubes_meet_in_the_middle_of_balls(roof, joined, offset):
    """To the last digit, whatever the heights of the net."""
    for made in (
        joined,
        api.fabricate(roof, "beams+nodes", node="ball", section=TUBE, offset=offset),
    ):
        balls = {part.vertices[0]: part.origin for part in of_kind(made, "node")}
        for tube in of_kind(made, "beam"):
            for vertex in tube.vertices:
                away = balls[vertex] - tube.origin
                assert np.linalg.norm(away - (away @ tube.frame[0]) * tube.frame[0]) < 1e-8


def test_tube_cone_sleeve_and_ball_stand_end_to_end(joined):
    tubes = {part.name: part for part in of_kind(joined, "beam")}
    parts = {part.name: part for part in joined.parts}
    balls = {part.vertices[0]: part for part in of_kind(joined, "node")}
    cones = of_kind(joined, "cone")
    assert len(cones) == len(of_kind(joined, "sleeve")) == 2 * len(tubes)
    for cone in cones:
        [vertex], sleeve = cone.vertices, parts[cone.name + "-sleeve"]
        ball, out = balls[vertex], cone.frame[2]
        places = [
            ball.origin + ball.body.seat * out,
            sleeve.origin,
            cone.origin - sleeve.length * out,
        ]
        np.testing.assert_allclose(places[1:], places[:1] * 2, rtol=0, atol=1e-8)
        tube = tubes[cone.name.split("-")[0]]
        ends = tube.points @ out
        assert ends.min() == pytest.approx((cone.origin + cone.length * out) @ out, abs=1e-8)
        ways = ball.body.ways @ ball.frame
        np.testing.assert_allclose((ways @ out).max(), 1.0, rtol=0, atol=1e-12)


def test_solids_are_valid_with_the_volume_of_the_formula(joined, tmp_path):
    parts = [
        part for kind in ("node", "cone", "sleeve", "beam") for part in of_kind(joined, kind)[::40]
    ]
    write_step(tmp_path / "ball.step", parts)
    for (_, shape), part in zip(read_step(tmp_path / "ball.step"), parts, strict=True):
        assert volume_of(part.solid()) == pytest.approx(part.volume, rel=1e-10)
        assert shape.isValid()
        # Where spheres are trimmed by circles the kernel reads its own curves to so much.
        assert shape.Volume() == pytest.approx(part.volume, rel=1e-5)
    for part in parts:
        if part.kind == "node":
            [hull] = part.body.pieces()
            assert_closed(hull)
            assert part.volume < hull.volume < 4 / 3 * np.pi * (1.06 * part.body.radius) ** 3


def test_balls_are_as_large_as_the_rule_asks_for():
    """After JGJ 7-2010, 5.3: holes do not meet, nor do sleeves, and 5 mm less would not do."""
    for bolt in BOLTS.values():
        angle = np.radians([35.0, 60.0, 90.0, 120.0])
        joints = BallJoints(bolt, 219.1, 8.0, angle)
        seats = joints.needed(angle)
        diameter, thread = bolt.diameter, joints.thread / bolt.diameter
        assert thread >= 1.1 - 1e-9
        assert joints.corners >= 1.8 * diameter
        arms = diameter / np.sin(angle) + diameter / np.tan(angle) + 2 * 1.1 * diameter
        holes = np.hypot(arms, 1.8 * diameter)
        sleeves = np.hypot(
            1.8 * diameter / np.sin(angle) + 1.8 * diameter / np.tan(angle), 1.8 * diameter
        )
        sizes = joints.diameters(seats)
        assert (sizes >= np.maximum(holes, sleeves) - 1e-9).all()
        # Neighbours do not touch: of holes, sleeves and tubes the tightest sets the size.
        half = np.tan(angle / 2)
        rooms = [
            (seats - joints.depth) * half - bolt.drill / 2,
            seats * half - joints.corners / 2,
            (seats + joints.setback) * half - joints.tube / 2,
        ]
        assert np.min(rooms) > 1.0
        assert (np.diff(seats) <= 1e-9).all()


def test_holes_are_listed_as_they_are_drilled(joined):
    balls = {part.name: part for part in of_kind(joined, "node")}
    tables = {table.name: table for table in joined.results["nodes"].tables}
    holes = tables["ball-holes.csv"]
    assert len(holes.rows) == 2 * len(of_kind(joined, "beam"))
    for row in holes.rows:
        said = dict(zip(holes.columns, row, strict=True))
        ball: Ball = balls[said["ball"]].body
        turn, lift = np.radians([said["azimuth_deg"], said["elevation_deg"]])
        way = [np.cos(lift) * np.cos(turn), np.cos(lift) * np.sin(turn), np.sin(lift)]
        np.testing.assert_allclose(ball.ways[said["hole"] - 1], way, rtol=0, atol=2e-5)
        assert said["seat_mm"] == pytest.approx(ball.seat, abs=1e-3)
        assert said["depth_mm"] == ball.depth > tables["bolts.csv"].rows[0][6]
    assert tables["bolts.csv"].rows[0][4] == len(holes.rows)
    report = joined.report()["nodes"]
    assert sum(row[1] for row in tables["node-types.csv"].rows) == len(joined.mesh.vertices)
    assert 1 < report["different"] < len(joined.mesh.vertices)


def test_what_is_turned_is_listed_with_all_that_a_turner_needs(joined):
    """The volumes of cone and sleeve follow from their rows alone."""
    [table] = [each for each in joined.results["nodes"].tables if each.name == "turned-parts.csv"]
    cone, sleeve, *balls = (dict(zip(table.columns, row, strict=True)) for row in table.rows)
    parts = {kind: of_kind(joined, kind) for kind in ("cone", "sleeve", "node")}
    assert (cone["kind"], cone["from"]) == ("cone", "round bar 90")
    assert cone["count"] == sleeve["count"] == len(parts["cone"]) == len(parts["sleeve"])

    def frustum(first, last, length):
        return np.pi / 12 * length * (first**2 + first * last + last**2)

    behind = cone["length_mm"] - cone["end_mm"]
    volume = frustum(cone["small_end_mm"], cone["diameter_mm"], cone["length_mm"])
    volume -= frustum(cone["hole_mm"], cone["hole_mm"], cone["end_mm"])
    volume -= frustum(cone["opening_small_mm"], cone["opening_mm"], behind)
    assert parts["cone"][0].volume == pytest.approx(volume, rel=1e-5)
    flats = float(sleeve["from"].removeprefix("hexagon bar "))
    area = np.sqrt(3) / 2 * flats**2 - np.pi / 4 * sleeve["hole_mm"] ** 2
    assert parts["sleeve"][0].volume == pytest.approx(area * sleeve["length_mm"], rel=1e-6)
    assert {ball["diameter_mm"]: ball["count"] for ball in balls} == Counter(
        part.width for part in parts["node"]
    )


def test_tubes_are_sawn_square(joined):
    """And they alone from bars: cones and sleeves are turned, and counted with the bolts."""
    tubes = [part.name for group in different_tubes(joined.parts) for part in group]
    assert sorted(tubes) == [part.name for part in of_kind(joined, "beam")]
    assert {part.note for part in of_kind(joined, "beam")} == {
        f"{TUBE}; start: square; end: square"
    }


@pytest.mark.parametrize(
    "values, words",
    [
        ({"section": "tube:100x60x5"}, "ends: cones .* are those of round tubes, got section tube"),
        ({}, "ends: cones .* are those of round tubes, got section plate; take one such as chs"),
        ({"section": TUBE, "hub_diameter": 60}, "hub: at N.* two beams meet .* need a ball of"),
        ({"section": "chs:33.7x3"}, "bolts: the cone of a tube 33.7 x 3 mm has no room"),
        ({"section": TUBE, "bolt": "M30"}, "beam ends|bolts: "),
    ],
)
def test_what_does_not_fit_is_one_line(roof, values, words):
    mesh = roof.scaled(0.3) if "bolt" in values else roof
    with pytest.raises(InputError, match=words) as caught:
        api.fabricate(mesh, "beams+nodes", node="ball", **values)
    assert "\n" not in str(caught.value)
