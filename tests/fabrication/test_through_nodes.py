"""Beams that run through in pieces, fins on them, cover plates on webs and splices."""

from collections import Counter

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.fabrication.bolts import bolt_of
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.limits import OK
from freecad_ortho.fabrication.step import read_step, write_step
from freecad_ortho.fabrication.systems.beams.fins import fin_cut
from solver.errors import InputError
from solver.mesh.quadmesh import QuadMesh
from tests.fabrication.test_beam_sections_and_ends import assert_closed, turned
from tests.fabrication.test_star_nodes import holes_of


@pytest.fixture(scope="module")
def joined(roof):
    """Plates of family u run through, panels on them."""
    return api.fabricate(
        roof, "beams+nodes+panels", node="through", thickness=24.0, panel_thickness=3
    )


def tube(rows=9, columns=6):
    """Rings of family v about a straight tube, in mm."""
    along, angle = np.meshgrid(
        1200.0 * np.arange(columns), 2 * np.pi * np.arange(rows) / rows, indexing="ij"
    )
    points = np.stack([along, 2000 * np.cos(angle), 2000 * np.sin(angle)], axis=-1)
    faces = []
    for i in range(columns - 1):
        for j in range(rows):
            k = (j + 1) % rows
            faces.append([i * rows + j, i * rows + k, (i + 1) * rows + k, (i + 1) * rows + j])
    return QuadMesh(points.reshape(-1, 3), np.array(faces))


def test_nothing_clashes_and_all_verdicts_are_ok(joined):
    found = check_clashes(joined.parts)
    assert found.near > len(joined.parts)
    assert (found.clashes, found.open) == ((), ())
    assert set(joined.verdicts) == {OK}
    report = joined.report()["nodes"]
    kinds = Counter(part.kind for part in joined.parts)
    assert kinds["cover-plate"] == 2 * (report["arms"] + report["splices"])
    assert report["bolts"] == 2 * kinds["cover-plate"]
    assert 0 < report["weld_gap_mm"] < 1.5


@pytest.mark.parametrize("ends", ["spliced-u", "spliced-v"])
def test_skewed_nets_and_closed_rings_do_not_clash(skewed, ends):
    for mesh in (skewed, tube()):
        made = api.fabricate(mesh, "beams+nodes", node="through", ends=ends, splice_every=3)
        found = check_clashes(made.parts)
        assert (found.clashes, found.open) == ((), ())
        assert made.report()["nodes"]["splices"] > 0
        assert not any(part.assembly for part in made.parts)


def test_pieces_have_so_many_nodes_and_joints_are_staggered(roof):
    made = api.fabricate(roof, "beams+nodes", node="through", splice_every=3)
    runs = [part for part in made.parts if part.name.startswith("B-U")]
    assert max(len(part.vertices) for part in runs) == 3
    seams = {}
    for part in runs:
        seams.setdefault(part.line, []).append(len(part.vertices))
    # Every vertex once, and joints of neighbours not in one row.
    assert all(sum(counts) == 10 for counts in seams.values()) or all(
        sum(counts) == 7 for counts in seams.values()
    )
    assert seams[0] != seams[1] and seams[0] == seams[2]
    whole = api.fabricate(roof, "beams+nodes", node="through", splice_every=0)
    assert whole.report()["nodes"]["splices"] == 0
    assert len([part for part in whole.parts if part.name.startswith("B-U")]) == len(seams)


def test_solids_are_valid_with_the_volume_of_the_formula(joined, tmp_path):
    parts = [part for part in joined.parts if part.kind != "panel"]
    runs = [part for part in parts if part.name.startswith("B-U")]
    parts = [*runs[:3], *parts[::40]]
    assert any(part.name.startswith("B-U") and part.pattern.holes for part in parts)
    for part in parts:
        assert_closed(part.body.whole if part.pattern.holes else part.body)
        bored = sum(np.pi / 4 * hole.diameter**2 for hole in part.pattern.holes)
        whole = part.body.whole if part.pattern.holes else part.body
        assert part.volume == pytest.approx(whole.volume - bored * part.thickness, rel=1e-12)
    write_step(tmp_path / "through.step", parts)
    for (_, shape), part in zip(read_step(tmp_path / "through.step"), parts, strict=True):
        assert shape.isValid()
        assert shape.Volume() == pytest.approx(part.volume, rel=1e-9)


def test_holes_of_every_joint_are_in_line(joined):
    assert_in_line(joined)


def assert_in_line(joined):
    """Each bolt passes a hole of each of the three plates that it joins."""
    parts = {part.name: part for part in joined.parts}
    [bolts] = joined.results["nodes"].fasteners
    assert bolts.count == joined.report()["nodes"]["bolts"]
    for place, way, names in zip(bolts.places, bolts.directions, bolts.joins, strict=True):
        for name in names:
            apart = holes_of(parts[name]) - place
            beside = np.linalg.norm(apart - np.outer(apart @ way, way), axis=1)
            assert beside[np.abs(apart @ way) < 60].min() < 1e-6


def test_patterns_fold_back_with_their_holes(joined, roof):
    assert_fold_back(joined, roof)


def assert_fold_back(joined, mesh):
    """Folded along its bend lines a pattern meets its vertices and its drilled solid."""
    for part in joined.parts:
        if part.kind != "beam" or not part.pattern.bends:
            continue
        pattern, frame = part.pattern, part.frame
        assert pattern.seen == "right"
        first = pattern.axis[1] - pattern.axis[0]
        turn = np.array([first, [-first[1], first[0]]]) / np.linalg.norm(first)

        def in_space(point, pattern=pattern, turn=turn, frame=frame, part=part):
            return part.origin + (turn @ (point - pattern.axis[0])) @ frame[:2]

        places = []
        for number, bend in enumerate([*pattern.bends, None]):
            places += [in_space(hole.centre) for hole in _between(pattern, number)]
            if bend is None:
                break
            assert (
                np.linalg.norm(mesh.vertices - in_space(pattern.axis[number + 1]), axis=1).min()
                < 1e-6
            )
            here, tip = in_space(bend.points[0]), in_space(bend.points[1])
            in_space = turned(in_space, here, tip - here, bend.angle_deg)
        if pattern.holes:
            apart = np.linalg.norm(np.array(places)[:, None] - holes_of(part), axis=2)
            assert len(places) == len(pattern.holes)
            assert apart.min(axis=1).max() < 1e-6


def _between(pattern, number):
    """Holes of a pattern on the plate of a number: nearest to the axis there."""
    steps = np.diff(pattern.axis, axis=0)
    for hole in pattern.holes:
        arm = hole.centre - pattern.axis[:-1]
        share = np.einsum("sk,sk->s", arm, steps) / np.einsum("sk,sk->s", steps, steps)
        beside = np.linalg.norm(arm - np.clip(share, 0, 1)[:, None] * steps, axis=1)
        if int(beside.argmin()) == number:
            yield hole


def test_holes_keep_the_distances_of_the_rules(joined):
    bolt = bolt_of("M16")
    for part in joined.parts:
        if part.kind == "panel" or not part.pattern.holes:
            continue
        outline = part.pattern.outline
        ends = np.roll(outline, -1, axis=0)
        places = np.array([hole.centre for hole in part.pattern.holes])
        side = ends - outline
        arm = places[:, None] - outline
        share = np.clip(np.einsum("hsk,sk->hs", arm, side) / (side**2).sum(axis=1), 0, 1)
        margins = np.linalg.norm(arm - share[..., None] * side, axis=2)
        assert margins.min() >= bolt.edge - 1e-9
        apart = np.linalg.norm(places[:, None] - places, axis=2)
        assert apart[apart > 0].min() >= bolt.spacing - 1e-9


@pytest.mark.parametrize("left, right", [(90, 90), (80, 95), (95, 100), (70, 180), (110, 180)])
def test_fins_touch_what_runs_through(left, right):
    """Their end is nowhere within the sides of the beams, and touches them somewhere."""
    half, angles = 10.0, np.radians([left, right])
    middle, slope = fin_cut(half, *angles)
    side = np.linspace(-half, half, 40001)
    own = middle + slope * side
    lines = [
        (half + side * sign * np.cos(angle)) / np.sin(angle)
        for angle, sign in zip(angles, (1, -1), strict=True)
        if angle < np.pi
    ]
    taken = np.max(lines, axis=0) if left + right <= 180 else np.min(lines, axis=0)
    assert (own - taken).min() == pytest.approx(0, abs=1e-4)
    assert (own - taken).min() > -1e-9


@pytest.mark.parametrize(
    "values, words",
    [
        ({"section": "I"}, "ends: only plates can be folded and spliced, got section I"),
        ({"ends": "mitred"}, "nodes: the beams are mitred and leave no room for hubs; set ends"),
        ({"height": 70}, "bolts: the lowest web is .* 2 of M12, the smallest, take 61.2 mm"),
        ({"splice_every": -1}, "splice every: expected a whole number, 0 to 1,000, got -1"),
    ],
)
def test_what_does_not_fit_is_one_line(roof, values, words):
    with pytest.raises(InputError, match=words):
        api.fabricate(roof, "beams+nodes", node="through", **values)


def test_fins_that_are_too_short_are_said(roof):
    made = api.fabricate(roof, "beams+nodes", node="through", hub_diameter=150.0)
    words = [words for words in made.verdicts if words != OK]
    assert "cannot be put in and tightened beside the beam that runs through" in words[0]


def three_rhombi(count=3):
    """Three rhombi in one plane around an inner vertex of three faces, edges of 1.5 m."""
    numbers, points, faces = {}, [], []
    ways = np.array([[np.cos(turn), np.sin(turn), 0.0] for turn in np.radians([0, 120, 240])])
    for k in range(3):
        for i in range(count):
            for j in range(count):
                corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
                places = [1500 * (a * ways[k] + b * ways[k - 2]) for a, b in corners]
                for place in places:
                    key = tuple(np.round(place).astype(int).tolist())
                    if key not in numbers:
                        numbers[key] = len(points)
                        points.append(place)
                keys = [tuple(np.round(place).astype(int).tolist()) for place in places]
                faces.append([numbers[key] for key in keys])
    return QuadMesh(np.array(points), np.array(faces))


@pytest.mark.parametrize("ends", ["spliced-u", "spliced-v"])
def test_at_irregular_vertices_stars_join_lines_that_end_there(dodecahedron, ends, tmp_path):
    for mesh, stars in ((dodecahedron, 8), (three_rhombi(), 1)):
        made = api.fabricate(mesh, "beams+nodes", node="through", ends=ends, splice_every=3)
        found = check_clashes(made.parts)
        assert (found.clashes, found.open) == ((), ())
        assert set(made.verdicts) == {OK}
        report, net = made.report()["nodes"], mesh.connectivity
        assert report["stars"] == stars
        assert f"lines end at {stars} vert" in made.results["nodes"].messages[0]
        # Every beam is held at both of its ends: at irregular vertices all are bolted to arms,
        # inside at regular ones one runs through, and at the boundary one runs through or ends.
        arms = Counter(part.vertices[0] for part in made.parts if part.kind == "node")
        inside = ~net.boundary_vertices
        for vertex in np.flatnonzero(inside).tolist():
            count = int(net.edge_valence[vertex])
            assert arms[vertex] == (count if net.singular[vertex] else count - 2)
        rim = np.flatnonzero(~inside).tolist()
        assert all(int(net.edge_valence[v]) - arms[v] in (1, 2) for v in rim)
        assert_in_line(made)
        assert_fold_back(made, mesh)
        write_step(tmp_path / "irregular.step", made.parts)
        read = read_step(tmp_path / "irregular.step")
        for (_, shape), part in zip(read, made.parts, strict=True):
            assert shape.isValid()
            assert shape.Volume() == pytest.approx(part.volume, rel=1e-9)


def test_a_net_without_lines_that_run_through_is_refused():
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
    faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    with pytest.raises(InputError, match="needs lines that run through vertices, which this net"):
        api.fabricate(QuadMesh(2000 * corners, np.array(faces)), "beams+nodes", node="through")


def test_without_what_runs_through_there_are_no_fins(roof):
    made = api.fabricate(roof, "beams+nodes", node="through", family="u")
    assert made.report()["nodes"]["arms"] == 0 < made.report()["nodes"]["splices"]
    with pytest.raises(InputError, match="nodes: nothing to build"):
        api.fabricate(roof, "beams+nodes", node="through", family="v")


@pytest.mark.parametrize(
    "node, scale, words, change",
    [
        ("through", 0.2, "fins .* with bolts M12 all", {"bolt": "M12"}),
        ("star", 0.4, "arms .* with one M12 a joint all", {"bolt": "M12", "bolts": 1}),
        (
            *("star", 0.36, "a beam thickness of at most 16 mm and one M12 a joint all"),
            {"bolt": "M12", "bolts": 1, "thickness": 16.0},
        ),
        ("star", 0.3, "no smaller sizes help; take bolted hubs", {"node": "bolted"}),
    ],
)
def test_what_a_refusal_of_short_edges_says_helps(roof, node, scale, words, change):
    small = roof.scaled(scale)
    with pytest.raises(InputError, match=rf"B\d+ between N\d+ and N\d+ is on .* {words}"):
        api.fabricate(small, "beams+nodes", node=node)
    made = api.fabricate(small, "beams+nodes", **{"node": node} | change)
    assert len(made.results["nodes"].parts) > 0
