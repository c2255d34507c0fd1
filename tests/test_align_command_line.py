"""The command ``align``: triangles and CAD faces in, a net on them out."""

from __future__ import annotations

import json

import numpy as np
import pytest

from freecad_ortho.__main__ import main
from solver import read_mesh
from solver.analysis import measures
from solver.mesh.closest import TriangleSurface
from tests.design_surfaces import saddle, saddle_face, triangles


@pytest.fixture(scope="module")
def surface_file(tmp_path_factory):
    points, faces = triangles(saddle, 41, 31)
    path = tmp_path_factory.mktemp("align") / "saddle.obj"
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in points.tolist()]
    lines += ["f " + " ".join(str(k + 1) for k in face) for face in faces.tolist()]
    path.write_text("# unit: m\n" + "\n".join(lines) + "\n")
    return path


def test_a_net_with_its_border_and_report(surface_file, tmp_path, capsys):
    out, report = tmp_path / "net.json", tmp_path / "report.json"
    code = main(
        ["align", str(surface_file), "--edge", "2.5", "-o", str(out), "--report", str(report)]
    )
    said = capsys.readouterr()
    assert code == 0
    assert "0 irregular vertices, mean edge 2." in said.out
    assert said.err == ""
    mesh, told = read_mesh(out), json.loads(report.read_text())
    assert told["faces"] == len(mesh.faces)
    assert told["unit"] == "m"
    assert json.loads(out.read_text())["border"] == told["border"]
    assert len(told["border"][0]) == 2 * (41 + 31) - 4
    assert measures.orthogonality(mesh).mean() < 1e-2


def test_a_net_that_follows_the_border_needs_no_trimming(surface_file, tmp_path, capsys):
    out = tmp_path / "net.json"
    words = ["--edge", "2.5", "--border", "follow", "-o", str(out)]
    assert main(["align", str(surface_file), *words]) == 0
    assert "0 irregular vertices" in capsys.readouterr().out
    assert not json.loads(out.read_text()).get("border")
    mesh, surface = read_mesh(out), triangles(saddle, 41, 31)[0]
    assert mesh.vertices.min(axis=0)[:2] == pytest.approx(surface.min(axis=0)[:2])


def test_lengths_have_units_and_a_net_may_be_coarse(surface_file, tmp_path, capsys):
    out = tmp_path / "net.obj"
    assert main(["align", str(surface_file), "--edge", "2500mm", "-o", str(out)]) == 0
    assert "border is kept in a .json file" in capsys.readouterr().err
    assert read_mesh(out).mean_edge == pytest.approx(2.5, rel=0.05)


def test_without_an_edge_length_there_are_about_600_faces(surface_file, tmp_path):
    out = tmp_path / "net.obj"
    assert main(["align", str(surface_file), "-o", str(out)]) == 0
    assert 550 < len(read_mesh(out).faces) < 750


def test_a_stroke_comes_from_a_file(surface_file, tmp_path, capsys):
    stroke, plain, led = (tmp_path / name for name in ("wall.xyz", "plain.obj", "led.obj"))
    x = np.linspace(-7, 7, 30)
    u, v = (x - 0.075 * x) / 30.6, (0.5 * x + x * 2 / 15) / 20.4
    np.savetxt(stroke, np.stack([x, 0.5 * x, 12 * u**2 - 20 * v**2 + 2 * u * v], axis=1))
    options = ["align", str(surface_file), "--edge", "2.5"]
    assert main([*options, "-o", str(plain)]) == 0
    assert main([*options, "--stroke", str(stroke), "-o", str(led)]) == 0
    with_stroke, without = read_mesh(led), read_mesh(plain)
    shapes = with_stroke.vertices.shape, without.vertices.shape
    assert shapes[0] != shapes[1] or not np.allclose(with_stroke.vertices, without.vertices)
    capsys.readouterr()
    assert main([*options, "--stroke", str(tmp_path / "none.xyz"), "-o", str(led)]) == 2
    assert "none.xyz" in capsys.readouterr().err


def test_singularities_are_written_edited_and_read(surface_file, tmp_path, capsys):
    saved, none, moved = (tmp_path / name for name in ("saved.txt", "none.obj", "moved.obj"))
    options = ["align", str(surface_file), "--edge", "2.5"]
    given = tmp_path / "given.txt"
    given.write_text("# x y z, lines\n-6, 3, -0.1, 3\n5 -2 0.2 5\n")
    words = ["--singularities", str(given), "--save-singularities", str(saved)]
    report = tmp_path / "report.json"
    assert main([*options, *words, "--report", str(report), "-o", str(none)]) == 0
    assert "2 irregular vertices" in capsys.readouterr().out
    rows = np.loadtxt(saved)
    assert sorted(rows[:, 3].tolist()) == [3, 5]
    assert rows[rows[:, 3] == 3, :2] == pytest.approx(np.array([[-6, 3]]), abs=0.8)
    assert json.loads(report.read_text())["singularities"] == rows.tolist()
    # What is written is what was there: it gives the same net again.
    assert main([*options, "--singularities", str(saved), "-o", str(moved)]) == 0
    assert moved.read_bytes() == none.read_bytes()
    capsys.readouterr()
    given.write_text("5 -2 0.2 4\n")
    assert main([*options, *words, "-o", str(none)]) == 2
    assert "expected 3, 5 or 6 lines" in capsys.readouterr().err
    given.write_text("5 -2 0.2\n")
    assert main([*options, *words, "-o", str(none)]) == 2
    assert "expected 4 numbers a line" in capsys.readouterr().err


def test_faces_of_a_step_file(tmp_path, capsys):
    cadquery = pytest.importorskip("cadquery")
    face = saddle_face(cadquery)
    step, out = tmp_path / "saddle.step", tmp_path / "net.json"
    cadquery.exporters.export(cadquery.Workplane(face), str(step))
    assert main(["align", str(step), "--edge", "2.5", "--unit", "m", "-o", str(out)]) == 0
    assert "mean edge 2." in capsys.readouterr().out
    mesh = read_mesh(out)
    feet, _ = TriangleSurface(*triangles(saddle, 161, 121)).closest(mesh.vertices)
    far = np.linalg.norm(mesh.vertices - feet, axis=1)
    # Inside they are on the face itself, of which these triangles miss 1 mm.
    inner = ~mesh.connectivity.boundary_vertices
    assert np.median(far[inner]) < 2e-3
    assert far.max() < 1.5 * 2.5


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--edge", "500"], "leaves room for"),
        (["--edge", "2.5", "--net", "snet"], "snet"),
        (["--edge", "2.5", "--ratio=-1"], "ratio"),
        (["--edge", "inf"], "edge"),
        (["--edge", "2.5", "--singularities", "nowhere.txt"], "nowhere.txt"),
    ],
)
def test_bad_options_are_said_in_a_line(surface_file, tmp_path, capsys, options, words):
    out = tmp_path / "net.obj"
    try:
        code = main(["align", str(surface_file), *options, "-o", str(out)])
    except SystemExit as ended:
        code = ended.code
    said = capsys.readouterr().err
    assert code == 2
    assert said.count("\n") == 1
    assert words in said
    assert not out.exists()


def test_nothing_is_written_where_there_is_no_surface(tmp_path, capsys):
    out = tmp_path / "net.obj"
    assert main(["align", str(tmp_path / "none.stl"), "-o", str(out)]) == 2
    assert "no such file" in capsys.readouterr().err
    assert not out.exists()
