"""The geometry that beams and panels promise: axes, mitres, levels, gaps, names, error lines."""

import math
import re

import numpy as np
import pytest

from freecad_ortho.fabrication import Beams, Panels, build, material
from freecad_ortho.fabrication.part import part_names
from solver.errors import InputError
from solver.mesh.grid import grid_mesh
from solver.mesh.mirror import reversed_orientation
from solver.mesh.quadmesh import QuadMesh, unit_rows

BEAMS = Beams(200, 30)


@pytest.mark.parametrize(
    ("offset", "low", "high"), [("above", 0, 200), ("centre", -100, 100), ("below", -200, 0)]
)
def test_beams_contain_both_axes_at_their_levels(roof, offset, low, high):
    structure = build(roof, [Beams(200, 12, offset)])
    offsets = structure.axes.offsets
    for part, (start, end) in zip(structure.parts, roof.connectivity.edges, strict=True):
        for level, on_start, on_end in ((low, 0, 3), (high, 6, 9)):
            tips = part.points[[on_start, on_end]]
            expected = (roof.vertices + level * offsets)[[start, end]]
            assert np.abs(tips - expected).max() <= 1e-6
        assert part.width == pytest.approx(200, rel=0.05)


def test_sides_are_planar_and_half_a_thickness_away(skewed):
    for part in build(skewed, [BEAMS, Panels(20, 15)]).parts:
        for loop in part.body.loops:
            points = part.points[list(loop)]
            assert np.linalg.svd(points - points.mean(axis=0))[1][-1] <= 1e-8
        if part.kind == "beam":
            assert np.allclose(
                np.abs(part.body.corners[:, 2]).reshape(2, 6), [0, 15, 15, 0, 15, 15]
            )


def test_neighbours_meet_in_the_plane_that_bisects_them(roof):
    structure = build(roof, [BEAMS])
    edges, axes = roof.connectivity.edges, structure.axes.directions
    inside = np.flatnonzero(~roof.connectivity.boundary_vertices)
    for vertex in inside[::7]:
        axis = axes[vertex]
        touching = np.flatnonzero((edges == vertex).any(axis=1))
        away = roof.vertices[edges[touching].sum(axis=1) - vertex] - roof.vertices[vertex]
        flat = unit_rows(away - np.outer(away @ axis, axis))
        cross = np.cross(axis, flat[0])
        order = np.argsort(np.arctan2(flat @ cross, flat @ flat[0]))
        for one, other in zip(order, np.roll(order, -1), strict=True):
            bisector = unit_rows((flat[one] + flat[other])[None])[0]
            plane = np.cross(axis, bisector)
            for number in (one, other):
                arms = structure.parts[touching[number]].points - roof.vertices[vertex]
                near = np.abs(arms @ plane) <= 1e-7
                assert near.sum() == 4
                assert (arms[near] @ bisector).min() >= -1e-7
                side = math.copysign(1, flat[number] @ plane)
                assert (side * (arms @ plane)).min() >= -1e-7


def test_boundary_is_cut_square():
    x, y = np.meshgrid(np.arange(4.0), np.arange(3.0), indexing="ij")
    number = np.arange(12).reshape(4, 3)
    faces = np.stack([number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]], axis=-1)
    flat = QuadMesh(1000 * np.stack([x, y, 0 * x], axis=-1).reshape(-1, 3), faces.reshape(-1, 4))
    structure = build(flat, [BEAMS])
    rim = flat.connectivity.boundary_edges
    right, left = np.split(structure.results["beams"].geometry.setback, 2, axis=1)
    inside_is_left = flat.connectivity.edge_faces[rim, :1] >= 0
    assert np.where(inside_is_left, right[rim], left[rim]) == pytest.approx(0, abs=1e-9)
    assert np.where(inside_is_left, left[rim], right[rim]) == pytest.approx(15)
    assert structure.results["beams"].geometry.setback[~rim] == pytest.approx(15)


def test_sharp_outer_side_is_mitred():
    """At the inner corner of an arrow head the outer side is the narrow one."""
    points = [[0, 0, 0], [3, -1, 0], [1, 0, 0], [3, 1, 0], [9, 9, 9]]
    arrow = QuadMesh(1000 * np.array(points), [[0, 1, 2, 3]])
    geometry = build(arrow, [Beams(100, 20)]).results["beams"].geometry
    edge = arrow.connectivity.edges.tolist().index([1, 2])
    right_end, left_end = geometry.setback[edge][1:3]
    assert right_end == pytest.approx(20)
    assert left_end == 0


def test_twisted_beams_are_reported(twisted):
    structure = build(twisted, [Beams(200, 12)])
    report = structure.report()["beams"]
    assert report["twist_max_deg"] == pytest.approx(
        max(part.measures.twist_deg for part in structure.parts)
    )
    assert report["twist_max_deg"] == pytest.approx(
        math.degrees(math.asin(structure.axes.twist.max()))
    )
    tip = max(
        np.abs(
            (twisted.vertices[vertex] + 100 * structure.axes.offsets[vertex] - part.origin)
            @ part.frame[2]
        )
        for part in structure.parts
        for vertex in part.vertices
    )
    assert report["twist_max_mm"] == pytest.approx(tip, rel=1e-6)
    assert "optimise the mesh" in structure.report()["messages"][0]


def inset_area(points, distance):
    """Area of a planar convex polygon less a strip along its sides: A - p d + d^2 sum cot."""
    side = np.roll(points, -1, axis=0) - points
    area = 0.5 * np.linalg.norm(np.cross(points[2] - points[0], points[3] - points[1]))
    along = unit_rows(side)
    turn = np.arccos(np.clip((along * np.roll(along, 1, axis=0)).sum(axis=1), -1, 1))
    return (
        area - distance * np.linalg.norm(side, axis=1).sum() + distance**2 * np.tan(turn / 2).sum()
    )


def test_panels_are_faces_less_half_the_gap(roof):
    structure = build(roof, [Panels(8, 30)])
    assert "sides_shrunk_more" in structure.report()["panels"]
    for part in structure.parts:
        expected = inset_area(roof.vertices[roof.faces[part.face]], 15.0)
        assert part.area == pytest.approx(expected, rel=1e-9)
        assert part.volume == pytest.approx(8 * expected, rel=1e-9)


@pytest.mark.parametrize(
    ("offset", "low", "high"), [("above", 0, 20), ("centre", -10, 10), ("below", -20, 0)]
)
def test_panels_lie_at_their_levels(roof, offset, low, high):
    structure = build(roof, [Panels(20, 15, offset)])
    for part in structure.parts:
        normal = roof.face_normals[part.face]
        level = (part.points - roof.vertices[roof.faces[part.face, 0]]) @ normal
        assert np.allclose(level, [low] * 4 + [high] * 4, atol=1e-7)


@pytest.mark.parametrize("offset", ["above", "centre", "below"])
def test_gap_never_falls_below_half(dodecahedron, roof, offset):
    for mesh in (dodecahedron, roof):
        structure = build(mesh, [Panels(60, 10, offset)])
        assert structure.report()["panels"]["clear_gap_min_mm"] >= 5 - 1e-9
        parts = structure.parts
        left, right = mesh.connectivity.edge_faces[~mesh.connectivity.boundary_edges].T
        for one, other in list(zip(left, right, strict=True))[::9]:
            assert parts[one].solid().distance(parts[other].solid()) >= 4


def test_panels_lie_on_the_beams(roof):
    structure = build(roof, [BEAMS, Panels(20, 15)])
    beams = structure.parts[: len(roof.connectivity.edges)]
    panels = structure.parts[len(beams) :]
    lifts = structure.results["panels"].geometry.lift
    for panel in panels:
        normal = panel.frame[2]
        foot = panel.points[:4].mean(axis=0)
        plane = roof.vertices + 100 * structure.axes.offsets
        level = (plane[list(panel.vertices)] - foot) @ normal
        assert np.allclose(level, -lifts[panel.face], atol=1e-6)
        for edge in roof.connectivity.face_edges[panel.face]:
            centre = plane[list(panel.vertices)].mean(axis=0)
            beam = beams[edge]
            side = (centre - beam.origin) @ beam.frame[2]
            top = beam.points[6:][beam.body.corners[6:, 2] * side >= 0]
            assert ((top - foot) @ normal).max() <= 1e-6
    assert 0 < lifts.max() <= 15


def test_panels_under_the_beams_are_said(roof):
    def said(mesh, *systems):
        words = build(mesh, systems).report()["messages"]
        return [word for word in words if "under the beams" in word]

    panels = Panels(20, 15)
    lying = roof.with_vertices(roof.vertices[:, [2, 0, 1]])
    (words,) = said(reversed_orientation(lying), BEAMS, panels)
    assert "turn it over" in words
    assert not said(lying, BEAMS, panels)
    assert not said(reversed_orientation(lying), panels)
    # Neither side of a wall is up.
    assert not said(roof, BEAMS, panels) + said(reversed_orientation(roof), BEAMS, panels)


def test_names_follow_the_numbers(structure, roof):
    beams = [part for part in structure.parts if part.kind == "beam"]
    panels = [part for part in structure.parts if part.kind == "panel"]
    assert [part.vertices for part in beams] == [tuple(row) for row in roof.connectivity.edges]
    assert [part.name for part in beams] == [f"B{k:04d}" for k in range(len(beams))]
    assert [part.name for part in panels] == [f"P{k:04d}" for k in range(len(panels))]
    assert [part.face for part in panels] == list(range(len(roof.faces)))
    assert {len(name) for name in part_names("B", 10000)} == {5}
    assert {len(name) for name in part_names("B", 10001)} == {6}


def test_masses_follow_the_density(roof):
    light = build(roof, [BEAMS], material=material("timber", density=500))
    for part in light.parts:
        assert part.mass == pytest.approx(part.volume * 500e-9)
    assert light.report()["mass_kg"] == pytest.approx(sum(part.mass for part in light.parts))


@pytest.mark.parametrize("value", [0, -1.0, math.nan, math.inf, None, "12"])
@pytest.mark.parametrize(
    ("name", "make"),
    [
        ("height", lambda value: Beams(value, 12)),
        ("thickness", lambda value: Beams(200, value)),
        ("panel thickness", lambda value: Panels(value, 10)),
        ("gap", lambda value: Panels(12, value)),
    ],
)
def test_sizes_must_be_positive(name, make, value):
    with pytest.raises(InputError, match=rf"^{name}: expected .*{value}") as caught:
        make(value)
    assert "\n" not in str(caught.value)


def test_unknown_offset_no_system_bad_density(roof):
    with pytest.raises(InputError, match="offset: expected above, centre or below"):
        Beams(200, 12, "middle")
    for systems in ([], [BEAMS, BEAMS]):
        with pytest.raises(InputError, match="system: expected different systems"):
            build(roof, systems)
    with pytest.raises(InputError, match=r"density: expected .* got -1"):
        material("steel", density=-1)


@pytest.mark.parametrize(
    ("settings", "limit"),
    [
        (lambda size: [Beams(200, size)], r"beam thickness.*take at most ([\d.]+) mm"),
        (lambda size: [Beams(size, 12)], r"beam height.*take less than ([\d.]+) mm"),
        (lambda size: [Panels(12, size)], r"gap.*take a gap below ([\d.]+) mm"),
    ],
)
def test_sizes_that_do_not_fit_name_the_place_and_the_limit(roof, settings, limit):
    with pytest.raises(InputError, match=limit) as caught:
        build(roof, settings(30000.0))
    assert re.search(r"(edge \d+|face \d+|B\d+ between N\d+ and N\d+)", str(caught.value))
    largest = float(re.search(limit, str(caught.value))[1])
    build(roof, settings(0.98 * largest))
    with pytest.raises(InputError):
        build(roof, settings(1.02 * largest))


@pytest.mark.parametrize(("offset", "times"), [("below", 1), ("centre", 2)])
def test_beams_of_a_tube_end_at_its_axis(offset, times):
    turn, along = np.meshgrid(np.arange(12) * np.pi / 6, np.arange(3.0), indexing="ij")
    points = np.stack([np.cos(turn), np.sin(turn), along], axis=2)
    with pytest.raises(InputError) as caught:
        build(grid_mesh(5000.0 * points, closed_u=True), [Beams(30000, 12, offset)])
    limit = float(re.search(r"take less than ([\d.]+) mm", str(caught.value))[1])
    # The height is that of all beams on average: 36 around lean by 15 degrees, 24 along do not.
    lean = (36 * math.cos(math.radians(15)) + 24) / 60
    assert limit == pytest.approx(times * 5000 * lean, rel=2e-3)


def test_edge_without_length_is_named(roof):
    vertices = roof.vertices.copy()
    vertices[1] = vertices[0]
    with pytest.raises(InputError, match=r"edges: 1 have no length.*vertices 0 and 1"):
        build(roof.with_vertices(vertices), [BEAMS])


def test_plates_thinner_than_the_kernel_can_tell_are_refused():
    for settings in (
        lambda: Beams(1e-6, 12),
        lambda: Beams(200, 1e-9),
        lambda: Panels(1e-6, 10),
        lambda: Panels(12, 1e-6),
    ):
        with pytest.raises(InputError, match=r"at least 0\.001 mm.*check the unit"):
            settings()


def test_edges_of_kilometres_are_refused(roof):
    with pytest.raises(InputError, match=r"edge \d+ .* km long; check the unit"):
        build(roof.scaled(1e4), [Beams(200, 12)])
