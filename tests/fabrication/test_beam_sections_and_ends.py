"""Beams of every section with every end: closed, valid, of the right volume, and never in clash."""

import functools
import itertools
import re
from collections import Counter, defaultdict

import numpy as np
import pytest
import shapely

from freecad_ortho import api
from freecad_ortho.fabrication import Beams, build
from freecad_ortho.fabrication.site import Selection
from solver import optimise
from solver.errors import InputError
from solver.mesh.lines import ParameterLines
from solver.mesh.quadmesh import QuadMesh
from tests.conftest import shared_mesh
from tests.fabrication.conftest import grid_faces

KINDS = {
    "hollow": {"section": "hollow"},
    "I": {"section": "I", "flange_thickness": 9.0},
    "T": {"section": "T"},
    "hub": {"ends": "hub"},
    "I on hub": {"ends": "hub", "section": "I"},
    "lapped": {"ends": "lapped"},
    "through u": {"ends": "through-u"},
    "through v, hollow": {"ends": "through-v", "section": "hollow"},
    "coped u": {"ends": "coped-u"},
    "coped v, I": {"ends": "coped-v", "section": "I"},
    "no boundary": {"ends": "through-u", "boundary_beams": False},
}


def beams(height=160, thickness=10, **more):
    return Beams(height, thickness, **{"section_width": 60.0, "hub_diameter": 120.0, **more})


def assert_closed(*bodies):
    """Every edge once in each direction, every side plane."""
    sides = defaultdict(list)
    for body in bodies:
        edges = Counter(
            pair for loop in body.loops for pair in zip(loop, loop[1:] + loop[:1], strict=True)
        )
        assert all(count == 1 and edges[b, a] == 1 for (a, b), count in list(edges.items()))
        for loop in body.loops:
            sides[len(loop)].append(body.corners[list(loop)])
    for some in sides.values():
        some = np.array(some)
        middle = some.mean(axis=1, keepdims=True)
        assert np.linalg.svd(some - middle, compute_uv=False)[:, -1].max() <= 1e-6


def near_pairs(parts):
    at = defaultdict(list)
    for number, part in enumerate(parts):
        for vertex in part.vertices:
            at[vertex].append(number)
    pairs = {pair for some in at.values() for pair in itertools.combinations(sorted(some), 2)}
    return sorted(pairs)


def assert_no_clash(parts, step=1):
    for one, two in near_pairs(parts)[::step]:
        shared = parts[one].solid().intersect(parts[two].solid()).Volume()
        limit = 1e-6 * min(parts[one].volume, parts[two].volume)
        assert shared <= limit, (parts[one].name, parts[two].name)


def assert_sound(structure, solids=7, pairs=9):
    assert_closed(*(part.body for part in structure.parts))
    for part in structure.parts[::solids]:
        solid = part.solid()
        assert solid.isValid()
        assert solid.Volume() == pytest.approx(part.volume, rel=1e-9)
    assert_no_clash(structure.parts, pairs)


@pytest.mark.parametrize("kind", KINDS.values(), ids=KINDS)
@pytest.mark.parametrize("name", ["roof", "skewed"])
def test_parts_are_sound(meshes, name, kind):
    assert_sound(build(meshes[name], [beams(**kind)]), 11, 23)


def test_a_clash_would_be_found(roof):
    parts = build(roof, [beams()]).parts
    thick = build(roof, [beams(thickness=14, offset="below")]).parts
    one, two = near_pairs(parts)[0]
    with pytest.raises(AssertionError):
        assert_no_clash([thick[one], parts[one]])
    assert_no_clash([parts[one], parts[two]])


@pytest.mark.parametrize("kind", ["hub", "lapped"])
def test_closed_net_with_odd_valences(dodecahedron, kind):
    assert_sound(build(dodecahedron, [beams(ends=kind, clearance=2)]), 1, 1)


def test_patterns_lie_as_the_parts_do_that_are_cut_by_them(skewed):
    for part in build(skewed, [beams(section="I", flange_thickness=9.0)]).parts:
        points = np.asarray(part.body.points)[:, :2]
        for end in (np.min, np.max):
            np.testing.assert_allclose(end(part.pattern.outline, axis=0), end(points, axis=0))


def prism_volume(geometry, low, high, half):
    """Volume between two heights: length less slopes of the axes, less the four mitre wedges."""
    start, end = geometry.slopes.T
    length = geometry.lengths - geometry.cuts.middle.sum(axis=1)
    length = length + (end - start) * (low + high) / 2
    wedges = geometry.cuts.slope.sum(axis=1) * half**2 / 2
    return (high - low) * (2 * half * length - wedges)


def test_volumes_by_formula(skewed):
    geometry = build(skewed, [beams()]).results["beams"].geometry
    low, high = geometry.up(0), geometry.up(1)
    for ends in ("mitred", "hub"):
        made = build(skewed, [beams(section="hollow", ends=ends)])
        geometry = made.results["beams"].geometry
        expected = prism_volume(geometry, low, high, 30)
        expected -= prism_volume(geometry, low + 10, high - 10, 20)
        assert [part.volume for part in made.parts] == pytest.approx(expected, rel=1e-9)
    made = build(skewed, [beams(section="I", flange_thickness=9.0)])
    geometry = made.results["beams"].geometry
    webs = [part.volume for part in made.parts if part.name.endswith("-web")]
    assert webs == pytest.approx(prism_volume(geometry, low + 9, high - 9, 5), rel=1e-9)
    tops = np.array([part.volume for part in made.parts if part.name.endswith("-top")])
    along_axes = prism_volume(geometry, high - 9, high, 30)
    shorter = 9**2 / 2 * np.abs(geometry.slopes).sum(axis=1) * 60
    assert tops == pytest.approx(along_axes - shorter, rel=1e-9)
    for part in made.parts:
        if not part.name.endswith("-web"):
            assert part.volume == pytest.approx(part.pattern.area * part.thickness, rel=1e-9)


def test_flat_grid_of_laps_is_plates_less_slots():
    """Square cells of 1 m: area and volume of every beam in closed form."""
    x, y = np.meshgrid(1000.0 * np.arange(4), 1000.0 * np.arange(5), indexing="ij")
    flat = QuadMesh(np.stack([x, y, 0 * x], axis=-1).reshape(-1, 3), grid_faces(4, 5)[:, ::-1])
    made = build(flat, [Beams(200, 10, ends="lapped", clearance=2)])
    slot = (10 + 2) * (100 + 1)
    for part in made.parts:
        cells = len(part.vertices) - 1
        rim = set(part.vertices) <= set(np.flatnonzero(flat.connectivity.boundary_vertices))
        if rim:  # mitred at the corners, slots at the inner nodes
            expected = 1000 * cells * 200 - (cells - 1) * slot
        else:  # tongues of half a thickness behind the outer axes, each with half a slot
            expected = (1000 * cells + 10) * 200 - (cells - 1) * slot - 2 * (5 + 6) * 101
        assert part.pattern.area == pytest.approx(expected, rel=1e-12)
        if not rim:
            assert part.volume == pytest.approx(10 * expected, rel=1e-12)
    assert_no_clash(made.parts)


@pytest.mark.parametrize("ends", ["lapped", "through-u"])
def test_patterns_fold_back(roof, ends):
    """From the first plate on, turned about each bend line, the axis meets every vertex."""
    made = build(roof, [beams(ends=ends)])
    lines = {(line.family, line.number): line for line in ParameterLines(roof.connectivity).all}
    folded = [part for part in made.parts if part.name.startswith("B-")]
    assert folded
    for part in folded:
        vertices = lines[part.family, part.line].vertices
        assert part.vertices == tuple(vertices)
        pattern, frame = part.pattern, part.frame
        first = pattern.axis[1] - pattern.axis[0]
        turn = np.array([first, [-first[1], first[0]]]) / np.linalg.norm(first)

        def in_space(point, pattern=pattern, turn=turn, frame=frame, part=part):
            return part.origin + (turn @ (point - pattern.axis[0])) @ frame[:2]

        for number, vertex in enumerate(vertices):
            assert np.abs(in_space(pattern.axis[number]) - roof.vertices[vertex]).max() <= 1e-6
            if 0 < number < len(vertices) - 1:
                bend = pattern.bends[number - 1]
                here, tip = in_space(bend.points[0]), in_space(bend.points[1])
                in_space = turned(in_space, here, tip - here, bend.angle_deg)


def turned(before, here, direction, angle_deg):
    """The map followed by a turn that raises what lies ahead towards the viewer."""
    unit = direction / np.linalg.norm(direction)
    angle = -np.radians(angle_deg)

    def after(point):
        arm = before(point) - here
        across = np.cross(unit, arm)
        along = unit * (unit @ arm)
        return here + along + np.cos(angle) * (arm - along) + np.sin(angle) * across

    return after


@pytest.mark.parametrize("kind", ["lapped", "through-u", "through-v"])
@pytest.mark.parametrize("rim", [True, False])
def test_plates_along_level_lines_are_boxes_less_their_slots(kind, rim):
    i, j = np.meshgrid(1000.0 * np.arange(4), 800.0 * np.arange(5), indexing="ij")
    mesh = QuadMesh(np.stack([i, j, 0 * i], axis=-1).reshape(-1, 3), grid_faces(4, 5))
    made = build(mesh, [beams(ends=kind, boundary_beams=rim)])
    folded = [part for part in made.parts if part.pattern.axis is not None]
    assert len(folded) >= 2
    for part in folded:
        # On both sides, or in the middle of an end.
        assert set(np.round(part.body.corners[:, 2], 9).tolist()) <= {-5.0, 0.0, 5.0}
        # Those of the rim of laps are mitred at the corners of the net.
        if kind != "lapped" or not mesh.connectivity.boundary_vertices[list(part.vertices)].all():
            assert part.volume == pytest.approx(part.area * 10)


def test_hub_ends_keep_their_distance(skewed):
    made = build(skewed, [beams(ends="hub", hub_diameter=150, clearance=3)])
    axes = made.axes.directions
    for part in made.parts[::5]:
        for vertex in part.vertices:
            arms = part.points - skewed.vertices[vertex]
            flat = arms - np.outer(arms @ axes[vertex], axes[vertex])
            along = skewed.vertices[sum(part.vertices) - vertex] - skewed.vertices[vertex]
            along -= (along @ axes[vertex]) * axes[vertex]
            assert (flat @ along).min() / np.linalg.norm(along) == pytest.approx(78)


@pytest.mark.parametrize("angle", [90.0, 60.0])
def test_coped_ends_lie_along_the_sides_of_what_runs_through(angle):
    turn = np.radians(angle)
    i, j = np.meshgrid(1000.0 * np.arange(4), 800.0 * np.arange(4), indexing="ij")
    points = np.stack([i + j * np.cos(turn), j * np.sin(turn), 0 * i], axis=-1).reshape(-1, 3)
    mesh = QuadMesh(points, grid_faces(4, 4))
    made = build(mesh, [beams(ends="coped-u", section="hollow", clearance=2)])
    runs = ParameterLines(mesh.connectivity).edge_family == 0
    along = next(part for part in made.parts if runs[int(part.name[1:])])
    side = np.array([-along.frame[0, 1], along.frame[0, 0], 0.0])
    for part in made.parts:
        if runs[int(part.name[1:])]:
            continue
        # Its ends are 30 and 2 mm from the lines through their axes, at every corner.
        rows = (part.points @ side).min(), (part.points @ side).max()
        axes = sorted(float(mesh.vertices[vertex] @ side) for vertex in part.vertices)
        assert rows[0] - axes[0] == pytest.approx(32)
        assert axes[1] - rows[1] == pytest.approx(32)
        ends = np.minimum(
            np.abs(part.points @ side - rows[0]), np.abs(part.points @ side - rows[1])
        )
        assert ends.max() == pytest.approx(0, abs=1e-6)
        assert f"right {90 - angle:.2f} left {angle - 90:.2f}" in part.note.replace("-0.00", "0.00")


def test_boundary_beams_can_be_left_out(roof):
    whole, inner = build(roof, [beams()]), build(roof, [beams(boundary_beams=False)])
    rim = set(np.flatnonzero(roof.connectivity.boundary_edges))
    names = [part.name for edge, part in enumerate(whole.parts) if edge not in rim]
    assert [part.name for part in inner.parts] == names


def test_chosen_lines_are_built_as_in_the_whole(roof):
    whole = {part.name: part for part in build(roof, [beams(ends="lapped")]).parts}
    some = build(roof, [beams(ends="lapped")], selection=Selection("v", (2, 4))).parts
    assert [part.name for part in some] == ["B-V002", "B-V004"]
    assert all(np.array_equal(part.points, whole[part.name].points) for part in some)


@pytest.mark.parametrize(
    "values, words",
    [
        (
            {"section": "U"},
            "section: expected plate, hollow, I, T or one of the catalogue",
        ),
        ({"ends": "glued"}, "ends: expected mitred, hub,"),
        ({"ends": "lapped", "section": "I"}, "only plates can be lapped"),
        ({"section": "hollow", "section_width": 20}, "section width: expected more than 20 mm"),
        ({"section": "I", "flange_thickness": 90}, "filled by the section's 180 mm"),
        ({"ends": "hub", "hub_diameter": 4}, "hub: at vertex .* take a hub .* larger"),
        ({"ends": "hub", "hub_diameter": 3000}, "beam ends: B.* hub diameter of at most"),
        ({"ends": "lapped", "clearance": 170}, "slots deeper than the beams|the slots at"),
        ({"ends": "lapped", "clearance": -1}, "clearance: expected 0 mm or more"),
        ({"ends": "lapped", "thickness": 1150}, "beam"),
        ({"thickness": 900}, "beam thickness: 900 mm does not fit B"),
        ({"height": 90000}, "beam height: 90000 mm does not fit edge"),
    ],
)
def test_sizes_that_do_not_fit_are_one_line(roof, values, words):
    with pytest.raises(InputError, match=words) as caught:
        build(roof, [beams(**values)])
    assert "\n" not in str(caught.value)


def test_the_hub_that_a_refusal_names_is_the_largest_that_fits(roof):
    with pytest.raises(InputError, match="hub diameter of at most 888 mm all have room"):
        build(roof, [beams(ends="hub", hub_diameter=3000.0)])
    assert build(roof, [beams(ends="hub", hub_diameter=888.0)]).parts
    with pytest.raises(InputError, match="what stands at its ends takes"):
        build(roof, [beams(ends="hub", hub_diameter=889.0)])


def test_nets_that_do_not_fit_are_one_line(twisted, dodecahedron):
    with pytest.raises(InputError, match=r"leave the plate by .* mm, .* principal net first"):
        build(twisted, [beams(ends="lapped")])
    with pytest.raises(InputError, match="needs a net with two families of lines"):
        build(dodecahedron, [beams(ends="through-u")])


def test_options_reach_the_command(roof):
    made = api.fabricate(roof, "beams", section="hollow", section_width=80, no_boundary_beams=True)
    assert {part.kind for part in made.parts} == {"beam"}
    assert made.parts[0].pattern is None
    assert made.parts[0].note.startswith("tube ")


@pytest.fixture(scope="module")
def exact():
    """Nets of the authors' meshes with edges of a metre, each made once."""

    @functools.cache
    def made(name):
        start = shared_mesh(name)
        return optimise(start.scaled(1000 / start.mean_edge), net="principal").mesh

    return made


@pytest.mark.shared
@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS.values(), ids=KINDS)
@pytest.mark.parametrize("name", ["heart", "conical1", "botanic-garden-bubble-0"])
def test_nets_of_the_authors(exact, name, kind):
    mesh = exact(name)
    if kind.get("ends", "").startswith(("through", "coped")) and name.startswith("botanic"):
        with pytest.raises(InputError, match="two families"):
            build(mesh, [beams(120, **kind)])
        return
    assert_sound(build(mesh, [beams(120, **{"section_width": 50.0, **kind})]), 41, 97)


def vault(half):
    """Square faces of 1 m, of which rows meet at twice an angle (degrees)."""
    turn = 2 * np.radians(half) * np.arange(-1.5, 2.0)
    across, along = np.meshgrid(turn, 1000.0 * np.arange(4), indexing="ij")
    radius = 500 / np.sin(np.radians(half))
    points = np.stack([radius * np.sin(across), along, radius * np.cos(across)], axis=-1)
    return QuadMesh(points.reshape(-1, 3), grid_faces(4, 4))


def test_slots_along_leaning_axes_take_more_of_an_edge():
    """Slots 802 mm wide take 830 or 926 mm of edges that lean by 15 or 30 degrees."""
    wide = Beams(100, 800, ends="lapped", clearance=2)
    build(vault(15), [wide])
    with pytest.raises(InputError, match="slots at vertices") as caught:
        build(vault(30), [wide])
    taken, room = map(float, re.findall(r"\d+\.\d", str(caught.value)))
    assert 802 / np.cos(np.radians(30)) < taken < room


def winding(turn):
    """A wall along a ramp around a tower: plane faces, edges of about 1 m."""
    angle, height = np.meshgrid(np.linspace(0, turn, 24), np.arange(3.0), indexing="ij")
    points = np.stack([4 * np.cos(angle), 4 * np.sin(angle), height + 0.7 * angle], axis=-1)
    return QuadMesh(1000 * points.reshape(-1, 3), grid_faces(24, 3))


def test_folded_plates_whose_pattern_overlaps_itself_are_refused():
    made = build(winding(5.5), [beams(ends="lapped")])
    for part in made.parts:
        assert shapely.Polygon(part.pattern.outline).is_valid
    with pytest.raises(InputError, match=r"B-[UV]000 overlaps itself; take mitred or hub ends"):
        build(winding(9.0), [beams(ends="lapped")])
