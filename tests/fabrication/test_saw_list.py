"""The saw list, its lengths and angles measured on the solids that a STEP file holds."""

import csv
import re

import numpy as np
import pytest

from freecad_ortho.fabrication import Beams, Lamellas, Panels, Workshop, build, write
from freecad_ortho.fabrication.exchange.members import member_of
from freecad_ortho.fabrication.site import Selection
from freecad_ortho.fabrication.step import read_step
from freecad_ortho.fabrication.systems import EdgeBeam

SOME = Selection(family="u", lines=(3,))
JOBS = {
    "tubes": [Beams(140, 5, section="hollow", section_width=80)],
    "rolled": [Beams(200, 20, section="IPE200")],
    "sharp": [Beams(200, 20, section="GL24h:80x200")],
    "hubs": [Beams(200, 20, section="chs:88.9x5", ends="hub")],
    "welded": [Beams(200, 8, section="I", section_width=90, flange_thickness=10)],
    "edge": [EdgeBeam("tube", section_height=120, width=60, wall=4)],
    "round": [EdgeBeam("round", width=90, wall=4)],
}


@pytest.fixture(scope="module")
def jobs(roof):
    return {
        name: build(roof, systems, selection=Selection() if name in ("edge", "round") else SOME)
        for name, systems in JOBS.items()
    }


@pytest.fixture(scope="module")
def folders(jobs, tmp_path_factory):
    root = tmp_path_factory.mktemp("saw")
    for name, job in jobs.items():
        write(job, root / name, workshop=Workshop(write="saw"), project='=Dach "ü"')
    return root


@pytest.fixture(scope="module")
def solids(folders):
    return {name: dict(read_step(folders / name / "structure.step")) for name in JOBS}


def rows_of(folder):
    with (folder / "saw-list" / "saw-list.csv").open(encoding="utf-8", newline="") as stream:
        return {row["name"]: row for row in csv.DictReader(stream)}


def planes_across(shape, frame):
    """Outward normals of the plane faces that are not along the first row of a frame, in it."""
    found = []
    for face in shape.Faces():
        if face.geomType() != "PLANE":
            continue
        normal = frame @ np.array(face.normalAt(face.Center()).toTuple())
        if abs(normal[0]) > 1e-6 and not any(np.allclose(normal, n, atol=1e-6) for n in found):
            found.append(normal)
    return found


def longest_along(shape, frame):
    """Longest distance of two vertices that are one behind the other."""
    points = np.array([vertex.toTuple() for vertex in shape.Vertices()]) @ frame.T
    beside = np.linalg.norm(points[:, None, 1:] - points[None, :, 1:], axis=2)
    away = np.abs(points[:, None, 0] - points[None, :, 0])
    return float(away[beside < 1e-6].max())


def angles_of(normal):
    """Mitre and bevel of a plane, from the line in which it meets the table, and from its tilt."""
    upright = np.array([0.0, 1.0, 0.0])
    trace = np.cross(normal, upright)
    mitre = np.degrees(np.arctan(trace[0] / trace[2]))
    ahead = normal if normal[0] > 0 else -normal
    return mitre, -np.degrees(np.arcsin(ahead[1]))


@pytest.mark.parametrize("name", JOBS)
def test_angles_are_those_of_the_solids(jobs, folders, solids, name):
    rows = rows_of(folders / name)
    assert set(rows) == {part.name for part in jobs[name].parts}
    for part in jobs[name].parts:
        row, faces = rows[part.name], planes_across(solids[name][part.name], part.frame)
        for end, sign in (("start", -1), ("end", 1)):
            seen = sorted(np.round(angles_of(f), 3).tolist() for f in faces if sign * f[0] > 0)
            listed = sorted(
                [float(row[f"{end}_mitre{k}_deg"]) + 0.0, float(row[f"{end}_bevel{k}_deg"]) + 0.0]
                for k in ("", "_2")
                if row[f"{end}_mitre{k}_deg"]
            )
            np.testing.assert_allclose(listed, seen, rtol=0, atol=1.1e-3)


def test_the_cuts_of_tubes_in_words_are_those_of_the_solids(jobs, solids):
    for part in jobs["tubes"].parts:
        sides = {}
        for face in solids["tubes"][part.name].Faces():
            normal = part.frame @ np.array(face.normalAt(face.Center()).toTuple())
            if abs(normal[0]) > 1e-6:
                aside = float(part.frame[2] @ np.array(face.Center().toTuple()))
                slopes = np.degrees(np.arctan(normal[1:] / normal[0]))
                sides.setdefault("end" if normal[0] > 0 else "start", []).append((aside, *slopes))
        for end, elevation, right, left in re.findall(
            r"(start|end): elevation (\S+), plan right (\S+) left (\S+) deg", part.note
        ):
            # In the beam's frame the third direction is to the right.
            first, last = min(sides[end]), max(sides[end])
            way = 1.0 if end == "end" else -1.0
            assert float(elevation) == pytest.approx(-first[1], abs=0.006)
            assert float(right) == pytest.approx(way * last[2], abs=0.006)
            assert float(left) == pytest.approx(-way * first[2], abs=0.006)
        assert part.note.count("elevation") == 2


@pytest.mark.parametrize("name", [name for name in JOBS if name not in ("hubs", "round", "rolled")])
def test_the_longest_edge_is_that_of_the_solid(jobs, folders, solids, name):
    rows = rows_of(folders / name)
    for part in jobs[name].parts:
        seen = longest_along(solids[name][part.name], part.frame)
        assert float(rows[part.name]["longest_edge_mm"]) == pytest.approx(seen, abs=0.006)
        box = np.ptp(part.body.points[:, 0])
        assert float(rows[part.name]["length_mm"]) == pytest.approx(box, abs=0.006)


def test_round_tubes_are_longest_somewhere_round_them(jobs):
    for part in jobs["round"].parts:
        member = member_of(part)
        # Independently: the plane's slopes are a rotation of the longest line about the axis.
        arm = member.ends[0, 1:] - member.starts[0, 1:]
        centre = (member.low + member.high) / 2
        middle = member.end_at(centre[None]) - member.start_at(centre[None])
        expected = middle[0] + 45 * np.linalg.norm(arm)
        assert member.longest[0] == pytest.approx(expected, abs=5e-3)


def test_bent_lamellas_are_cut_by_their_patterns_and_holes_are_listed(roof, tmp_path):
    job = build(roof, [Lamellas(60, 4, hole=9)], selection=SOME)
    write(job, tmp_path, workshop=Workshop(write="saw"))
    rows = rows_of(tmp_path)
    with (tmp_path / "stock.csv").open(encoding="utf-8", newline="") as stream:
        sawn = [name for row in csv.DictReader(stream) for name in row["parts"].split()]
    assert sorted(rows) == sorted(sawn)
    for part in job.parts:
        if part.name in rows:
            assert rows[part.name]["cut_by"] == "flat pattern"
            holes = rows[part.name]["holes"].split("; ") if part.pattern.holes else []
            assert [float(hole.split()[0]) for hole in holes] == [9] * len(part.pattern.holes)


def test_the_page_says_how_to_read_it_and_has_every_bar(jobs, folders):
    page = (folders / "rolled" / "saw-list" / "saw-list.html").read_text(encoding="utf-8")
    assert "=Dach &quot;ü&quot;" in page
    assert page.count("<polygon") == 2
    for word in ("Mitre", "Bevel", "Longest edge", "IPE200, "):
        assert word in page
    for part in jobs["rolled"].parts:
        assert f"<td>{part.name}</td>" in page


def test_panels_are_on_no_saw_list_and_a_later_run_removes_it(roof, tmp_path):
    job = build(roof, [Panels(12, 10)], selection=Selection())
    write(job, tmp_path, workshop=Workshop(write="saw"))
    assert rows_of(tmp_path) == {}
    write(job, tmp_path)
    assert not (tmp_path / "saw-list").exists()
