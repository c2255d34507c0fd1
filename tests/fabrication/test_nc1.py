"""Files for steel machines: a reader of its own against the solids of a STEP file."""

import json
from itertools import pairwise

import numpy as np
import pytest
import shapely

from freecad_ortho.fabrication import Beams, Lamellas, Panels, Workshop, build, write
from freecad_ortho.fabrication.exchange.members import Member
from freecad_ortho.fabrication.exchange.nc1_faces import upright_face
from freecad_ortho.fabrication.material import MATERIALS
from freecad_ortho.fabrication.site import Selection
from freecad_ortho.fabrication.step import read_step
from freecad_ortho.fabrication.systems import EdgeBeam
from tests.fabrication.nc1_reader import read_nc1
from tests.fabrication.test_saw_list import planes_across

JOBS = {
    "I": Beams(200, 20, section="IPE200"),
    "T": Beams(200, 20, section="tee:HEB160"),
    "U": Beams(200, 20, section="UPE160"),
    "M": Beams(140, 5, section="hollow", section_width=80),
    "RO": Beams(200, 20, section="chs:88.9x5"),
    "hub": Beams(200, 20, section="HEB160", ends="hub", hub_diameter=260),
    "round": EdgeBeam("round", width=90, wall=4),
    "plates": Beams(200, 20),
}


@pytest.mark.parametrize("lean", [0.5, -0.5])
@pytest.mark.parametrize("right", [0.0, 30.0])
def test_a_wall_leans_the_same_way_at_both_ends_of_a_trapezoid(lean, right):
    """And the other way where both ends are parallel: seen at one, from behind at the other."""
    box = np.array([(-50, -30), (50, -30), (50, 30), (-50, 30)], dtype=float)
    start = np.array([[0.0, 0.0, lean]])
    leans = []
    for slope in (lean, -lean):
        member = Member(box, start, np.array([[1000.0, 0.0, slope]]))
        _, end, _, begin = upright_face("v", member, right, 8.0, (-50.0, 50.0)).bevels
        leans.append((begin, end))
    (begin, parallel), (_, mirrored) = leans
    assert max(angle for angle, _ in begin) == pytest.approx(np.degrees(np.arctan(0.5)))
    assert parallel == begin[::-1] != begin == mirrored


@pytest.fixture(scope="module")
def made(roof, tmp_path_factory):
    """For each job its parts, pieces and solids by name."""
    found = {}
    for name, system in JOBS.items():
        some = Selection() if name == "round" else Selection(family="u", lines=(3,))
        job, folder = build(roof, [system], selection=some), tmp_path_factory.mktemp(name)
        write(job, folder, workshop=Workshop(write="nc1"), project="Dach ü")
        solids = dict(read_step(folder / "structure.step"))
        pieces = {path.stem: read_nc1(path) for path in (folder / "nc1").iterdir()}
        found[name] = job.parts, pieces, solids
    return found


def slopes_of(piece, end):
    """Slopes of the planes of an end, mm along per mm up and per mm to the right (the front)."""
    if not piece.contours:
        turn = dict(start=(0, 2), end=(1, 3))[end]
        return [tuple(-np.tan(np.radians(piece.cuts[k])) for k in turn)]
    (front,) = piece.faces("v")
    rows, left = np.array(front)[:-1], end == "start"
    x, y = rows[[0, 3] if left else [1, 2], :2].T
    up = (x[1] - x[0]) / (y[1] - y[0])
    (flange,) = piece.faces("o")
    flange = np.array(flange)[:-1, :2]
    chosen = flange[[0, 5, 4] if left else [1, 2, 3]]
    # From above y grows to the back.
    return [(up, -(b[0] - a[0]) / (b[1] - a[1])) for a, b in pairwise(chosen)]


@pytest.mark.parametrize("name", ["I", "T", "M", "hub", "round"])
def test_bars_are_rebuilt(made, name):
    parts, pieces, solids = made[name]
    assert set(pieces) == {part.name for part in parts}
    for part in parts:
        piece, solid = pieces[part.name], solids[part.name]
        assert piece.code == {"hub": "I", "round": "RO"}.get(name, name)
        rims = [point for edge in solid.Edges() for point in edge.positions(np.linspace(0, 1, 201))]
        points = np.array([point.toTuple() for point in rims]) @ part.frame.T
        assert piece.length == pytest.approx(np.ptp(points[:, 0]), abs=0.01)
        if name != "round":
            assert (piece.height, piece.width) == pytest.approx(
                np.ptp(points[:, 1:], axis=0), abs=0.01
            )
        if name in ("I", "M"):
            # From below the same flange or wall, mirrored.
            both = [np.array(piece.faces(face)[0])[:-1, :2] for face in ("o", "u")]
            for rows in both:
                across = [0.0, piece.width / 2, piece.width]
                assert sorted(set(rows[:, 1].tolist())) == pytest.approx(across, abs=1e-3)
            above, below = (shapely.Polygon(rows).area for rows in both)
            assert below == pytest.approx(above, rel=0.06)
        for rows in (np.array(rows) for _, _, rows in piece.contours):
            # A side is bevelled by an angle and over a depth, or not at all.
            assert ((np.abs(rows[:, [3, 5]]) > 5e-4) <= (rows[:, [4, 6]] > 0)).all()
            assert ((rows[:, [4, 6]] > 0) <= (rows[:, [4, 6]] > 1.5)).all()
        faces = planes_across(solid, part.frame)
        for end, sign in (("start", -1), ("end", 1)):
            seen = [face for face in faces if sign * face[0] > 0]
            read = slopes_of(piece, end)
            assert len(read) == len(seen)
            for up, right in read:
                normal = sign * np.array([1.0, -up, -right]) / np.sqrt(1 + up**2 + right**2)
                away = min(np.degrees(np.arccos(min(1.0, normal @ face))) for face in seen)
                assert away < 0.01


def test_channels_show_the_back_of_their_web(made):
    parts, pieces, solids = made["U"]
    for part in parts:
        piece = pieces[part.name]
        assert (piece.code, piece.height, piece.width) == ("U", 160.0, 70.0)
        points = np.array([v.toTuple() for v in solids[part.name].Vertices()]) - part.origin
        points = points @ part.frame.T
        # Seen with the web in front x runs the other way, from the part's end.
        (flange,) = piece.faces("o")
        read = np.array(flange)[:-1, :2]
        top = points[np.abs(points[:, 1] - points[:, 1].max()) < 1e-6]
        seen = np.column_stack([points[:, 0].max() - top[:, 0], top[:, 2] - points[:, 2].min()])
        away = np.linalg.norm(read[:, None] - seen[None], axis=2)
        assert max(away.min(axis=0).max(), away.min(axis=1).max()) < 2e-3


def test_round_tubes_are_rolled_out(made):
    parts, pieces, solids = made["RO"]
    for part in parts:
        piece = pieces[part.name]
        (rows,) = piece.faces("v")
        outline = np.array(rows)[:, :2]
        area = shapely.Polygon(outline).area
        skin = sum(
            face.Area()
            for face in solids[part.name].Faces()
            if face.geomType() == "CYLINDER" and face._geomAdaptor().Cylinder().Radius() > 44
        )
        assert np.ptp(outline[:, 1]) == pytest.approx(np.pi * 88.9, abs=0.01)
        assert area == pytest.approx(skin, rel=2e-4)


def test_plates_have_their_outline_and_their_bevels(made):
    parts, pieces, solids = made["plates"]
    for part in parts:
        piece = pieces[part.name]
        # A plate has no flanges and no radius, both its faces are painted, its ends are not sawn.
        assert (piece.code, piece.web) == ("B", 20.0)
        assert (piece.width, piece.flange, piece.radius) == (0.0, 0.0, 0.0)
        assert (piece.mass, piece.paint, piece.cuts) == (20 * 7.85, 2.0, (0.0,) * 4)
        assert piece.length == pytest.approx(part.length, abs=0.01)
        assert piece.height == pytest.approx(part.pattern.size[1], abs=0.01)
        (rows,) = piece.faces("v")
        assert shapely.Polygon(np.array(rows)[:, :2]).area == pytest.approx(part.area, rel=1e-5)
        read = sorted(angle for row in rows[:-1] for angle in (row[3], row[5]) if angle)
        depths = [row[4] + row[6] for row in rows[:-1] if row[3] or row[5]]
        faces = planes_across(solids[part.name], part.frame)
        seen = sorted(abs(np.degrees(np.arcsin(face[2]))) for face in faces)
        np.testing.assert_allclose(read, seen, rtol=0, atol=0.01)
        assert depths == pytest.approx([20.0] * len(depths))


def test_marks_and_holes_of_plates(roof, tmp_path):
    job = build(roof, [Lamellas(60, 4, hole=9)], selection=Selection(family="u", lines=(0, 3)))
    write(job, tmp_path, workshop=Workshop(write="nc1"), project="Dach ü")
    for part in job.parts:
        piece = read_nc1(tmp_path / "nc1" / f"{part.name}.nc1")
        assert piece.words[0] == "Dach u"
        holes = [[*hole.centre.tolist(), hole.diameter] for hole in part.pattern.holes]
        np.testing.assert_allclose([row[1:] for row in piece.holes], holes, rtol=0, atol=1e-3)
        texts = [part.name, *(mark.text for mark in part.pattern.marks if mark.text)]
        assert [mark[2] for mark in piece.marks] == texts
        assert piece.mass * piece.length * piece.height * 1e-6 > part.mass


def test_wood_and_glass_are_for_others(roof, tmp_path):
    systems = [Beams(200, 20), Panels(12, 10)]
    material = {"beams": MATERIALS["GL24h"], "panels": MATERIALS["glass"]}
    some = Selection(family="u", lines=(3,))
    job = build(roof, systems, material=material, selection=some)
    write(job, tmp_path, workshop=Workshop(write="nc1"))
    assert not (tmp_path / "nc1").exists()
    said = json.loads((tmp_path / "report.json").read_text(encoding="utf-8"))["messages"]
    assert [line for line in said if "nc1: nothing to write" in line and "metal" in line]
