"""The command line as scripts use it: exit codes, files, one line for every mistake."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import time
from types import SimpleNamespace

import pytest

from freecad_ortho import api
from freecad_ortho.__main__ import main
from freecad_ortho.cli import reporting
from freecad_ortho.cli.optimising import _kinds
from freecad_ortho.fabrication import FILES
from tests.conftest import ROOT, wavy_grid


@pytest.fixture
def mesh_file(tmp_path):
    path = tmp_path / "wave.obj"
    api.write_mesh(path, wavy_grid(9, 8).scaled(1000.0))
    return path


def one_line(capsys) -> str:
    text = capsys.readouterr().err.strip()
    assert text.count("\n") == 0, text
    assert "Traceback" not in text
    return text


def test_optimise_writes_mesh_and_report(mesh_file, tmp_path, capsys):
    out, report = tmp_path / "net.obj", tmp_path / "net.json"
    code = main(
        ["optimise", str(mesh_file), "--net", "principal", "-o", str(out), "--unit", "mm"]
        + ["--report", str(report)]
    )
    assert code == 0
    assert capsys.readouterr().err == ""
    data = json.loads(report.read_text())
    wanted = {
        "net",
        "status",
        "message",
        "vertices",
        "faces",
        "variables",
        "constraints",
        "iterations",
        "seconds",
        "seconds_per_iteration",
        "solve_seconds_per_iteration",
        "residuals",
        "edge_ratio",
        "moved",
    }
    assert wanted <= data.keys()
    assert data["status"] == "converged"
    assert set(data["moved"]) == {"max", "mean"}
    assert set(data["residuals"]) == {"orthogonality", "planarity"}
    before, after = api.read_mesh(mesh_file), api.read_mesh(out)
    assert (before.mesh.faces == after.mesh.faces).all()
    assert after.unit == "mm"
    assert api.check(after.mesh)["measures"]["planarity"]["max"] <= 1e-10


def test_not_converged_still_writes_the_best_mesh(mesh_file, tmp_path, capsys):
    out = tmp_path / "net.obj"
    code = main(["optimise", str(mesh_file), "-o", str(out), "--max-steps", "3"])
    assert code == 1
    assert out.is_file()
    assert "more than 3 steps" in capsys.readouterr().err


def test_verbose_prints_a_line_a_step(mesh_file, tmp_path, capsys):
    main(["optimise", str(mesh_file), "-o", str(tmp_path / "n.obj"), "-v"])
    text = capsys.readouterr().err
    assert all(f"step {k}:" in text for k in range(1, 6))
    # The share that is done grows as the residual falls, on a scale of its logarithm.
    done = [int(share) for share in re.findall(r"^ *(\d+) % step", text, re.MULTILINE)]
    assert done[0] == 0 and 0 < min(done[1:]) <= max(done) and done[-1] == 100


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["optimise", "absent.obj", "-o", "out.obj"], "no such file"),
        (["optimise", "MESH", "-o", "out.obj", "--net", "wiggly"], "net: expected "),
        (["optimise", "MESH", "-o", "out.obj", "--fix", "9999"], "fix: vertex 9999"),
        (["optimise", "MESH", "-o", "absent/out.obj"], "does not exist"),
        (["optimise", "MESH", "-o", "out.obj", "--report", "absent/r.json"], "does not exist"),
        (["optimise", "MESH", "-o", "out.obj", "--report", "out.obj"], "is to hold two files"),
        (["fabricate", "MESH", "-o", "out", "--height", "-1"], "height: expected a number above 0"),
        (
            ["fabricate", "MESH", "-o", "out", "--thickness", "nan"],
            "--thickness: expected a finite number, got 'nan'",
        ),
        (["fabricate", "MESH", "-o", "out", "--thickness", "5000"], "does not fit B0"),
        (["fabricate", "MESH", "-o", "out", "--system", "walls"], "system: expected "),
        (
            ["fabricate", "MESH", "-o", "out", "--offset", "left"],
            "--offset: expected above, centre",
        ),
        (["check", "absent.obj"], "no such file"),
    ],
)
def test_bad_input_is_one_line_and_writes_nothing(
    mesh_file, tmp_path, capsys, monkeypatch, arguments, words
):
    monkeypatch.chdir(tmp_path)
    before = sorted(os.listdir(tmp_path))
    code = main([str(mesh_file) if word == "MESH" else word for word in arguments])
    assert code == 2
    assert words in one_line(capsys)
    assert sorted(os.listdir(tmp_path)) == before


@pytest.mark.parametrize("arguments", [[], ["optimise"], ["optimise", "a.obj", "--unit", "parsec"]])
def test_bad_arguments_are_one_line(arguments, capsys):
    with pytest.raises(SystemExit) as caught:
        main(arguments)
    assert caught.value.code == 2
    assert one_line(capsys).startswith("error:")


def test_check_prints_a_table_and_json(mesh_file, capsys):
    assert main(["check", str(mesh_file)]) == 0
    assert "orthogonality" in capsys.readouterr().out
    assert main(["check", str(mesh_file), "--json", "--unit", "cm"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert data["unit"] == "cm"
    assert data["faces"] == 56


def test_fabricate_writes_all_files(mesh_file, tmp_path, capsys):
    net, out = tmp_path / "net.obj", tmp_path / "out"
    assert main(["optimise", str(mesh_file), "-o", str(net)]) == 0
    assert main(["fabricate", str(net), "-o", str(out), "--system", "beams+panels"]) == 0
    assert {path.name for path in out.iterdir()} == set(FILES)
    assert "127 beams, 56 panels" in capsys.readouterr().out


def test_interrupt_writes_what_there_is(tmp_path):
    start, out = tmp_path / "wave.obj", tmp_path / "net.obj"
    api.write_mesh(start, wavy_grid(120, 120))
    command = [sys.executable, "-m", "freecad_ortho", "optimise", str(start), "-o", str(out), "-v"]
    run = subprocess.Popen(
        command, cwd=ROOT, stderr=subprocess.PIPE, text=True, preexec_fn=listen_to_ctrl_c
    )
    for line in run.stderr:
        if "step 2:" in line:
            run.send_signal(signal.SIGINT)
            break
    rest = run.stderr.read()
    assert run.wait(timeout=60) == 1
    assert "stopped" in rest
    assert "Traceback" not in rest
    assert api.read_mesh(out).mesh.vertices.shape == (14400, 3)


def listen_to_ctrl_c():
    """A shell that starts the tests in the background makes all its children deaf to Ctrl-C."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


def interrupted(arguments, seconds, cwd, sent=signal.SIGINT):
    """Run the command line, break it off after a while; give its exit code and what it said."""
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    command = [sys.executable, "-m", "freecad_ortho", *arguments]
    run = subprocess.Popen(
        command,
        cwd=cwd,
        env=environment,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=listen_to_ctrl_c,
    )
    time.sleep(seconds)
    run.send_signal(sent)
    _, said = run.communicate(timeout=60)
    return run.returncode, said


@pytest.fixture(scope="module")
def large_file(tmp_path_factory):
    """A planar grid of 3,960 beams, for which fabrication takes many times what is waited here."""
    path = tmp_path_factory.mktemp("large") / "grid.obj"
    api.write_mesh(path, wavy_grid(45, 45, height=0.0).scaled(1000.0))
    return path


# While packages load, while solids are made and while files are written, more or less.
@pytest.mark.parametrize(
    ("seconds", "sent"),
    [(0.4, signal.SIGINT), (0.9, signal.SIGINT), (1.5, signal.SIGINT), (1.5, signal.SIGTERM)],
)
def test_interrupted_fabrication_leaves_no_trace(large_file, tmp_path, seconds, sent):
    (tmp_path / "parts.csv").write_text("old")
    code, said = interrupted(["fabricate", str(large_file), "-o", "."], seconds, tmp_path, sent)
    assert said == "stopped; nothing was written\n"
    assert code == 1
    assert os.listdir(tmp_path) == ["parts.csv"]
    assert (tmp_path / "parts.csv").read_text() == "old"


def test_results_take_the_place_of_ordinary_files_only(mesh_file, tmp_path, capsys):
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    both = str(tmp_path / "both")
    for arguments, words in (
        (["-o", str(pipe)], "is not an ordinary file"),
        (["-o", str(tmp_path / "n.obj"), "--report", str(pipe)], "is not an ordinary file"),
        (["-o", both, "--report", both], "name two files"),
        (["-o", str(tmp_path)], "is a folder"),
    ):
        assert main(["optimise", str(mesh_file), *arguments]) == 2
        assert words in one_line(capsys)
    assert sorted(os.listdir(tmp_path)) == ["pipe", "wave.obj"]


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="needs a device that is always full")
@pytest.mark.parametrize("json", [[], ["--json"]])
def test_output_that_nobody_takes_is_no_traceback(mesh_file, json):
    command = [sys.executable, "-m", "freecad_ortho", "check", str(mesh_file), *json]
    with open("/dev/full", "w") as full:
        run = subprocess.run(
            command, cwd=ROOT, stdout=full, stderr=subprocess.PIPE, text=True, check=False
        )
    assert run.returncode == 2
    assert run.stderr.startswith(
        "error: the output: cannot be written (No space left on device); free"
    )
    assert run.stderr.count("\n") == 1
    reader, writer = os.pipe()
    os.close(reader)
    run = subprocess.run(
        command, cwd=ROOT, stdout=writer, stderr=subprocess.PIPE, text=True, check=False
    )
    os.close(writer)
    assert (run.returncode, run.stderr) == (0, "")


def test_fabricating_names_the_package_that_is_missing(mesh_file, tmp_path, capsys, monkeypatch):
    monkeypatch.setitem(sys.modules, "cadquery", None)
    assert main(["fabricate", str(mesh_file), "-o", str(tmp_path / "out")]) == 2
    assert "'cadquery' is missing" in one_line(capsys)
    assert not (tmp_path / "out").exists()


def test_one_panel_is_one(tmp_path, capsys):
    path = tmp_path / "one.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")
    assert main(["fabricate", str(path), "--unit", "m", "-o", str(tmp_path / "out")]) == 0
    assert capsys.readouterr().out.startswith("4 beams, 1 panel, ")


def grid_text(face=lambda *corners: " ".join(map(str, corners)), scale=1.0, shift=0.0, tail=""):
    """An OBJ file of 5 x 5 vertices, 16 quads; ``face`` writes the corners of one."""
    points = wavy_grid(5, 5).vertices * scale + shift
    lines = [f"v {x!r} {y!r} {z!r}{tail}" for x, y, z in points.tolist()]
    faces = [
        [5 * i + j + 1, 5 * i + j + 6, 5 * i + j + 7, 5 * i + j + 2]
        for i in range(4)
        for j in range(4)
    ]
    return "\n".join([*lines, *(f"f {face(*corners)}" for corners in faces)]) + "\n"


@pytest.mark.parametrize(
    "text",
    [
        grid_text().replace("\n", "\r\n"),
        grid_text().replace("\n", "\r"),
        grid_text(face=lambda *corners: " ".join(str(corner - 26) for corner in corners)),
        grid_text(face=lambda a, b, c, d: f"{a}/1/1 {b}//2 {c}/3 {d}"),
        grid_text(face=lambda a, b, c, d: f"{a} {b} \\\n{c} {d}"),
        grid_text(tail=" 0.1 0.2 0.3"),
        grid_text(scale=1e-6),
        grid_text(scale=1e9),
        grid_text(scale=1e3, shift=1e7),
        "g part\nusemtl steel\nvn 0 0 1\nvt 0 0\n" + grid_text() + "l 1 2\np 3\n",
    ],
    ids="windows mac counted-back textures continued colours tiny huge far groups".split(),
)
def test_odd_files_optimise(tmp_path, capsys, text):
    path, out = tmp_path / "odd ü file.obj", tmp_path / "net ß.obj"
    path.write_bytes(text.encode())
    assert main(["optimise", str(path), "-o", str(out)]) == 0, capsys.readouterr().err
    assert api.check(api.read_mesh(out).mesh)["measures"]["planarity"]["max"] <= 1e-10
    assert main(["check", str(path), "--json"]) == 0


@pytest.mark.parametrize("name", ["c.stl", "c.dxf", "c.xyz"])
@pytest.mark.parametrize("command", ["convert", "optimise"])
def test_unknown_ending_of_the_output_is_refused_first(mesh_file, tmp_path, capsys, command, name):
    assert main([command, str(mesh_file), "-o", str(tmp_path / name)]) == 2
    assert "expected a name that ends in .obj, .ply, .off, .json, got" in one_line(capsys)
    assert [path.name for path in tmp_path.iterdir()] == [mesh_file.name]


def test_size_that_no_chosen_system_has_is_refused(mesh_file, tmp_path, capsys):
    words = ["fabricate", str(mesh_file), "--system", "panels", "-o", str(tmp_path / "files")]
    assert main([*words, "--height", "60", "--gap", "12"]) == 2
    refusal = (
        "error: height: panels has no such size, it is of edge-beam, beams, nodes, arches, "
        "feet; leave it out"
    )
    assert one_line(capsys) == refusal
    assert not (tmp_path / "files").exists()
    # Stock is the workshop's as well.
    assert main([*words, "--stock", "6000", "--gap", "12"]) == 0
    messages = json.loads((tmp_path / "files" / "report.json").read_text())["messages"]
    assert capsys.readouterr().err.splitlines() == [f"note: {message}" for message in messages]


def test_help_and_errors_name_the_command_as_it_is_typed(capsys):
    with pytest.raises(SystemExit):
        main(["optimise"])
    assert one_line(capsys).endswith("; see python -m freecad_ortho optimise --help")


def test_file_and_line_of_a_mistake_are_named(mesh_file, tmp_path, capsys):
    text = mesh_file.read_text().splitlines()
    bad = tmp_path / "bad.obj"
    for line, words in [
        ("f 1 2 5000 3", f"face 56 (line {len(text) + 1}) names vertex 4999"),
        ("f 1 2 3", f"face 56 (line {len(text) + 1}) has 3; make quads of them first ('quads'"),
        ("# Units: yards", f", line {len(text) + 1}: the unit 'yards' is not known"),
    ]:
        bad.write_text("\n".join([*text, line]))
        assert main(["weld", str(mesh_file), str(bad), "-o", str(tmp_path / "out.obj")]) == 2
        said = one_line(capsys)
        assert str(bad) in said and words in said
    assert api.read_mesh(bad, "m").unit == "m"


def test_small_mesh_without_unit_is_remarked(mesh_file, tmp_path):
    plain = api.read_mesh(mesh_file)
    assert plain.remarks == ()
    small = tmp_path / "small.obj"
    api.write_mesh(small, plain.mesh.scaled(1e-3))
    (remark,) = api.read_mesh(small).remarks
    assert "taken as mm" in remark and "--unit m" in remark
    assert api.read_mesh(small, "m").remarks == ()
    api.write_mesh(small, plain.mesh.scaled(1e-3), "m")
    assert api.read_mesh(small).remarks == ()


def test_verbose_says_each_message_once(capsys):
    with reporting.Progress(True) as say:
        for done, words in ((0.1, "parts"), (0.2, "parts"), (0.3, "files"), (0.4, "files")):
            say(done, words)
    assert capsys.readouterr().err == " 10 % parts\n 30 % files\n"


def test_a_terminal_has_a_bar_that_fills_and_goes(capsys, monkeypatch):
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    with reporting.Progress(False) as say:
        for done in (-1.0, 0.1, 0.5, 2.0):
            say(done, "parts")
    *bars, last = capsys.readouterr().err.split("\r\033[K")[1:]
    assert bars == [f"[{'#' * full}{'.' * (30 - full)}] parts" for full in (0, 3, 15, 30)]
    assert last == ""


def test_numbers_of_eight_kinds_are_told_and_that_there_are_more():
    counts = tuple(range(20, 11, -1))
    found = SimpleNamespace(
        of="edges", alike=0.001, largest_miss=0.0004, counts=counts, kinds=9, kinds_before=40
    )
    found.is_reached = True
    words = _kinds(SimpleNamespace(net="planar"), found, "m")
    assert "of each 20, 19, 18, 17, 16, 15, 14, 13, ...;" in words
