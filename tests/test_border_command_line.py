"""The border of a surface, along the command line: kept from file to file, and parts cut at it."""

from __future__ import annotations

import json

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.__main__ import main
from tests.conftest import wavy_grid

OCTAGON = [(0.5, 0.2), (0.8, 0.2), (1.1, 0.5), (1.1, 0.8), (0.8, 1.1), (0.5, 1.1), (0.2, 0.8)]


@pytest.fixture
def net(tmp_path):
    """A net in m, and a curve on it."""
    path, mesh = tmp_path / "net.json", wavy_grid(9, 8, height=0.0)
    span = np.ptp(mesh.vertices, axis=0)[:2] / 1.3
    curve = np.column_stack([mesh.vertices[:, :2].min(axis=0) + OCTAGON * span, np.zeros(7)])
    api.write_mesh(path, mesh, "m", [curve])
    return path, curve


def border_of(path):
    return [np.array(line) for line in json.loads(path.read_text()).get("border", [])]


@pytest.mark.parametrize(
    "command",
    [
        ["optimise", "--net", "principal"],
        ["subdivide"],
        ["orient", "--reverse"],
        ["convert"],
        ["optimise", "--net", "principal", "--origin", "local"],
    ],
    ids=" ".join,
)
def test_what_stays_on_the_surface_keeps_its_border(net, tmp_path, command, capsys):
    path, curve = net
    out = tmp_path / "out.json"
    assert main([command[0], str(path), *command[1:], "-o", str(out)]) == 0
    (line,) = border_of(out)
    assert np.array_equal(line, curve)
    assert "border" not in capsys.readouterr().err
    assert main([command[0], str(path), *command[1:], "-o", str(tmp_path / "out.obj")]) == 0
    assert "border is kept in a .json file only" in capsys.readouterr().err


def test_what_leaves_the_surface_leaves_its_border(net, tmp_path, capsys):
    out = tmp_path / "out.json"
    assert main(["transform", str(net[0]), "--turn", "0,0,90", "-o", str(out)]) == 0
    assert border_of(out) == []
    assert "the border of the surface stays behind" in capsys.readouterr().err


def test_a_border_far_from_the_origin_keeps_its_place(net, tmp_path):
    path, curve = net
    loaded = api.read_mesh(path)
    far = np.array([4.5e5, 5.2e6, 300.0])
    api.write_mesh(path, loaded.mesh.with_vertices(loaded.mesh.vertices + far), "m", [curve + far])
    out = tmp_path / "out.json"
    assert main(["convert", str(path), "-o", str(out), "--origin", "local"]) == 0
    moved = api.read_mesh(out)
    assert np.abs(moved.mesh.vertices).max() < 1e5
    step = moved.mesh.vertices[0] - loaded.mesh.vertices[0]
    assert np.allclose(moved.border[0] - curve, step, atol=1e-9)


def test_a_file_whose_y_points_up_turns_its_border_too(net):
    path, curve = net
    turned = api.read_mesh(path, up="y").border[0]
    assert np.allclose(turned, np.stack([curve[:, 0], -curve[:, 2], curve[:, 1]], axis=1))


def parts_of(folder):
    lines = (folder / "parts.csv").read_text(encoding="utf-8").splitlines()
    return [line for line in lines if line.startswith("P")]


def test_parts_are_trimmed_along_the_border_of_the_net(net, tmp_path, capsys):
    path, curve = net
    settings = ["--system", "panels", "--thickness", "4", "--gap", "2", "--least-width", "5"]
    counts = []
    for more in ([], ["--untrimmed"], ["--trim-along", str(path)], ["--trim-along", "curve"]):
        if more[-1:] == ["curve"]:
            more = ["--trim-along", str(tmp_path / "curve.xyz")]
            np.savetxt(tmp_path / "curve.xyz", 0.95 * curve + 0.05 * curve.mean(axis=0))
        out = tmp_path / f"files{len(counts)}"
        assert main(["fabricate", str(path), *settings, *more, "-o", str(out)]) == 0
        report = json.loads((out / "report.json").read_text())
        counts.append((len(parts_of(out)), report["panels"]["area_mm2"]))
    assert counts[0][0] < counts[1][0] == 56
    assert counts[2] == counts[0]
    assert counts[3][1] < counts[0][1] < counts[1][1]
    capsys.readouterr()


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--trim-along", "NET.obj"], "expected 3 numbers"),
        (["--trim-along", "plain.json"], "plain.json: has no border"),
        (["--trim-along", "curve.xyz", "--untrimmed"], "not allowed with"),
        (["--trim-along", "far.xyz"], "from the net near face"),
        (["--trim-along", "two.xyz"], "three points or more"),
    ],
)
def test_what_is_no_border_is_refused_in_one_line(net, tmp_path, options, words, capsys):
    path, curve = net
    loaded = api.read_mesh(path)
    api.write_mesh(tmp_path / "plain.json", loaded.mesh, "m")
    (tmp_path / "NET.obj").write_text("v 1 2\nv 3 4\n")
    np.savetxt(tmp_path / "far.xyz", curve + 100)
    np.savetxt(tmp_path / "two.xyz", curve[:2])
    np.savetxt(tmp_path / "curve.xyz", curve)
    named = [str(tmp_path / word) if "." in word else word for word in options]
    try:
        code = main(["fabricate", str(path), "--system", "panels", *named, "-o", str(tmp_path)])
    except SystemExit as ended:
        code = ended.code
    assert code == 2
    said = capsys.readouterr().err.strip()
    assert words in said
    assert said.count("\n") == 0


@pytest.mark.parametrize("border", ["[[1, 2, 3]]", "5", '[[["a", 0, 0]]]', "[[[0, 0, 0], [1, 1]]]"])
def test_a_border_that_is_none_is_refused_with_its_file(tmp_path, border, capsys):
    path = tmp_path / "net.json"
    path.write_text(
        '{"unit": "m", "vertices": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "faces": [[0,1,2,3]], '
        f'"border": {border}}}'
    )
    assert main(["check", str(path)]) == 2
    said = capsys.readouterr().err.strip()
    assert "net.json: border: expected closed polylines" in said
    assert said.count("\n") == 0
