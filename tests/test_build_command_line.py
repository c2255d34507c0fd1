"""The command ``build``: from a surface to files in one go, and on from where it ended."""

from __future__ import annotations

import json
import re
import shutil
import signal
import subprocess
import sys

import pytest

from freecad_ortho.__main__ import main
from freecad_ortho.fabrication import FILES
from solver import read_mesh
from solver.analysis import measures
from solver.analysis.form import off_surface
from solver.mesh.closest import TriangleSurface
from tests.conftest import ROOT
from tests.design_surfaces import saddle, saddle_face, triangles

NETS = {"aligned.json", "aligned.obj", "net.json", "net.obj"}
PANELS = ["--system", "panels", "--panel-thickness", "8"]


@pytest.fixture(scope="module")
def surface_file(tmp_path_factory):
    points, faces = triangles(saddle, 41, 31)
    path = tmp_path_factory.mktemp("build") / "saddle.obj"
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in points.tolist()]
    lines += ["f " + " ".join(str(k + 1) for k in face) for face in faces.tolist()]
    path.write_text("# unit: m\n" + "\n".join(lines) + "\n")
    return path


@pytest.fixture(scope="module")
def built_once(surface_file, tmp_path_factory):
    folder = tmp_path_factory.mktemp("built") / "out"
    assert build(surface_file, folder) == 0
    return folder


@pytest.fixture
def built(built_once, tmp_path):
    """A folder of a whole build, to be changed, with a file that is nobody's."""
    folder = tmp_path / "out"
    shutil.copytree(built_once, folder)
    (folder / "mine.txt").write_text("mine")
    return folder


def build(surface, folder, *more):
    return main(["build", str(surface), "--edge", "3", *PANELS, "-o", str(folder), *more])


def told(folder):
    return json.loads((folder / "report.json").read_text())


def held(folder):
    return {path.name: path.stat().st_mtime_ns for path in folder.iterdir()}


def test_a_surface_becomes_a_net_and_its_parts(built_once, surface_file):
    assert held(built_once).keys() == {*NETS, *FILES}
    net = read_mesh(built_once / "net.json")
    assert max(measures.planarity(net).max(), measures.orthogonality(net).max()) < 1e-10
    # The net overhangs: it is held against the surface as its formula goes on.
    around = triangles(lambda u, v: saddle(1.4 * u - 0.2, 1.4 * v - 0.2), 225, 169)
    inner = ~net.connectivity.boundary_vertices[net.faces].any(axis=1)
    assert off_surface(net, TriangleSurface(*around))[inner].max() < 0.15
    assert (net.faces == read_mesh(built_once / "net.obj").faces).all()
    borders = [
        json.loads((built_once / f"{name}.json").read_text())["border"]
        for name in ("aligned", "net")
    ]
    assert borders[0] == borders[1]
    assert len(borders[0][0]) == 2 * (41 + 31) - 4


def test_one_report_tells_of_every_stage(built_once):
    report = told(built_once)
    stages = report["build"]["stages"]
    assert list(stages) == ["align", "optimise", "fabricate"]
    assert all(stage["seconds"] > 0 for stage in stages.values())
    faces = len(read_mesh(built_once / "net.json").faces)
    assert stages["align"]["numbers"]["faces"] == faces
    assert stages["align"]["settings"] == {"edge": "3"}
    assert stages["optimise"]["numbers"]["residuals"]["planarity"]["max"] < 1e-10
    found = {entry["measure"]: entry for entry in stages["optimise"]["form"]}
    assert all(entry["met"] for entry in found.values())
    assert found["off the surface"]["value"] == pytest.approx(
        stages["optimise"]["numbers"]["off_surface"]["max"]
    )
    # One face may lie beyond the border as a whole.
    panels = report["counts"]["panels"]
    assert faces - 1 <= panels <= faces
    assert f"{panels} panels" in stages["fabricate"]["words"]
    assert report["systems"] == ["panels"]
    page = (built_once / "report.html").read_text()
    way = page.index("The way to it")
    assert way < page.index("Parts in groups")
    assert f"{faces} quads, 0 irregular vertices" in page[way:]
    assert "edge 3" in page[way:]


def test_what_is_there_is_not_made_again(built, surface_file, capsys):
    before = held(built)
    assert build(surface_file, built) == 0
    said = capsys.readouterr()
    assert re.findall(r"(\w+): as before", said.out) == ["align", "optimise", "fabricate"]
    assert "..." not in said.out
    assert said.err == ""
    assert held(built) == before


def test_other_parts_are_made_of_the_same_net(built, surface_file, capsys):
    before = held(built)
    assert build(surface_file, built, "--gap", "12") == 0
    said = capsys.readouterr().out
    assert re.findall(r"(\w+): as before", said) == ["align", "optimise"]
    assert re.findall(r"(\w+) \.\.\.", said) == ["fabricate"]
    after = held(built)
    assert all(after[name] == before[name] for name in (*NETS, "mine.txt"))
    assert after["parts.csv"] != before["parts.csv"]
    assert told(built)["build"]["stages"]["fabricate"]["settings"]["gap"] == "12"


def test_a_file_that_was_changed_or_is_missing_is_made_again(built, surface_file, capsys):
    (built / "aligned.obj").unlink()
    (built / "net.obj").write_text("mine now")
    assert build(surface_file, built) == 0
    said = capsys.readouterr().out
    assert re.findall(r"(\w+) \.\.\.", said) == ["align", "optimise"]
    assert "fabricate: as before" in said
    assert told(built)["systems"] == ["panels"]
    assert len(read_mesh(built / "net.obj").faces) == len(read_mesh(built / "aligned.obj").faces)


def test_a_net_whose_form_does_not_hold_is_not_built(built, surface_file, capsys):
    strict = ("--within", "1mm")
    assert build(surface_file, built, *strict) == 1
    said = capsys.readouterr()
    assert "align: as before" in said.out
    line = next(text for text in said.err.splitlines() if text.startswith("form: "))
    assert re.search(r"mm off the surface at most, at face \d+ near \(.*\), where 1 mm are", line)
    assert "; try: " in line
    # Parts of the net before would be mistaken for parts of this one.
    assert held(built).keys() == {*NETS, "report.json", "mine.txt"}
    assert "systems" not in told(built)
    assert build(surface_file, built, *strict) == 1
    assert "optimise: as before" in capsys.readouterr().out
    assert build(surface_file, built, *strict, "--go-on") == 0
    assert held(built).keys() == {*NETS, *FILES, "mine.txt"}
    assert "off the surface" in (built / "report.html").read_text()
    assert "fails" in (built / "report.html").read_text()


def test_a_net_that_is_not_exact_is_not_built(surface_file, tmp_path, capsys):
    assert build(surface_file, tmp_path / "out", "--max-steps", "2") == 1
    said = capsys.readouterr().err
    assert "form: the net is not exact" in said
    assert "more than 2 steps" in said
    assert held(tmp_path / "out").keys() == {*NETS, "report.json"}


def test_again_makes_everything_anew(built, surface_file, capsys):
    before = held(built)
    assert build(surface_file, built, "--again") == 0
    assert "as before" not in capsys.readouterr().out
    after = held(built)
    assert all(after[name] != before[name] for name in (*NETS, *FILES))


def test_another_surface_of_the_same_name_is_noticed(built, surface_file, tmp_path, capsys):
    other = tmp_path / surface_file.name
    other.write_text(surface_file.read_text().replace("# unit: m\n", "# unit: m\n\n"))
    assert build(other, built, "--max-steps", "2") == 1
    assert "as before" not in capsys.readouterr().out


def test_ctrl_c_keeps_what_is_done_and_the_next_run_goes_on(surface_file, tmp_path, capsys):
    out = tmp_path / "out"
    words = ["build", str(surface_file), "--edge", "0.6", *PANELS, "-o", str(out), "-v"]
    run = subprocess.Popen(
        [sys.executable, "-m", "freecad_ortho", *words],
        cwd=ROOT,
        stderr=subprocess.PIPE,
        text=True,
        # A shell that starts the tests in the background makes all its children deaf to Ctrl-C.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
    )
    for line in run.stderr:
        if "step 1:" in line:
            run.send_signal(signal.SIGINT)
            break
    rest = run.stderr.read()
    assert run.wait(timeout=60) == 1
    assert rest.splitlines()[-1].startswith("stopped; finished stages are kept")
    assert held(out).keys() == {"aligned.json", "aligned.obj", "report.json"}
    assert main([*words, "--max-steps", "1"]) == 1
    assert "align: as before" in capsys.readouterr().out


def test_faces_of_a_step_file(tmp_path, capsys):
    cadquery = pytest.importorskip("cadquery")
    face = saddle_face(cadquery)
    step, out = tmp_path / "saddle.step", tmp_path / "out"
    floor = cadquery.Workplane().box(1000, 1000, 1000).val()
    both = cadquery.Compound.makeCompound([face, floor])
    cadquery.exporters.export(cadquery.Workplane(both), str(step))
    assert build(step, out, "--unit", "m", "--faces", "1") == 0
    assert "form: no folded faces" in capsys.readouterr().out
    net = read_mesh(out / "net.json")
    assert net.mean_edge == pytest.approx(3.0, rel=0.1)
    numbers = told(out)["build"]["stages"]["optimise"]["numbers"]
    assert numbers["off_surface"]["percent"] < 0.5


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--net", "geodesic"], "a surface has no lines for geodesic nets"),
        (["--net", "wiggly"], "net: expected "),
        (["--radius", "3"], "--radius: only cmc nets have it"),
        (["--system", "walls"], "system: expected "),
        (["--height", "200"], "height"),
        (["--sheet", "large"], "sheet: expected WxH"),
        (["--lines", "a"], "--lines"),
        (["--edge", "500"], "leaves room for"),
        (["--within", "never"], "--within"),
    ],
)
def test_bad_options_are_one_line_and_leave_nothing(surface_file, tmp_path, capsys, options, words):
    out = tmp_path / "new" / "out"
    assert main(["build", str(surface_file), *PANELS, "-o", str(out), *options]) == 2
    said = capsys.readouterr().err.splitlines()
    assert len(said) == 1
    assert words in said[0]
    assert not (tmp_path / "new").exists()


def test_it_is_told_how_many_share_the_work(capsys):
    with pytest.raises(SystemExit, match="0"):
        main(["build", "--help"])
    assert "--workers" in capsys.readouterr().out


def test_a_missing_surface_and_a_file_in_the_way_are_one_line(surface_file, tmp_path, capsys):
    assert build(tmp_path / "none.step", tmp_path / "out") == 2
    assert "no such file" in capsys.readouterr().err
    (tmp_path / "file").write_text("mine")
    assert build(surface_file, tmp_path / "file") == 2
    assert "cannot be written" in capsys.readouterr().err
    assert (tmp_path / "file").read_text() == "mine"
