"""The choice ``--origin`` on the command line: what coordinates in files are measured from."""

from __future__ import annotations

import json

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.__main__ import main
from tests.conftest import wavy_grid

OFFSET = np.array([500123.25, 5412345.5, 412.0])
LOCAL = np.array([500100.0, 5412300.0, 0.0])


@pytest.fixture
def far(tmp_path):
    path = tmp_path / "far.obj"
    api.write_mesh(path, wavy_grid(9, 8).with_vertices(wavy_grid(9, 8).vertices + OFFSET), "m")
    return path


def result(arguments, out):
    assert main([*map(str, arguments), "-o", str(out)]) == 0
    return api.read_mesh(out).mesh.vertices


def test_optimise_writes_where_it_is_told_and_says_so(far, tmp_path, capsys):
    report = tmp_path / "r.json"
    places = {}
    for choice, point in (("keep", [0, 0, 0]), ("local", LOCAL), ("-7,1.5,2", [-7, 1.5, 2])):
        words = ["optimise", far, "--origin", choice, "--report", report]
        places[choice] = result(words, tmp_path / "out.obj") + point
        data = json.loads(report.read_text())
        assert data["origin"] == LOCAL.tolist() and data["file_origin"] == list(point)
        said = capsys.readouterr()
        assert "far from the origin: all work is done about 500100, 5412300, 0 m" in said.err
        assert ("coordinates about" in said.out) == (choice != "keep")
    for vertices in places.values():
        assert np.abs(vertices - places["local"]).max() <= 1e-8
    near = api.optimise(wavy_grid(9, 8)).mesh.vertices
    assert np.abs(places["keep"] - OFFSET - near).max() <= 1e-8
    # About the local origin a file has every digit of the net.
    assert api.check(api.read_mesh(tmp_path / "out.obj").mesh)["advice"]["already"]
    local = result(["optimise", far, "--origin", "local"], tmp_path / "local.obj")
    mesh = wavy_grid(9, 8).with_vertices(local)
    assert api.check(mesh)["measures"]["planarity"]["max"] <= 1e-12


@pytest.mark.parametrize(
    "words",
    ["subdivide", "diagonal", "convert", "trim --rings 1", "formfind", "offset --distance 200"]
    + ["orient --reverse", "weld", "mirror --point 500123.25,0,0 --alone", "transform --scale 1"],
)
def test_sources_keep_the_place_or_leave_it(far, tmp_path, words):
    name, *options = words.split()
    kept = result([name, far, *options], tmp_path / "kept.obj")
    near = result([name, far, *options, "--origin", "local"], tmp_path / "near.obj")
    assert np.abs(kept - near - LOCAL).max() <= 2e-9
    assert np.abs(near[:, :2]).max() < 100


def test_a_choice_that_is_none_is_refused_in_one_line(far, tmp_path, capsys):
    with pytest.raises(SystemExit) as ended:
        main(["optimise", str(far), "-o", str(tmp_path / "n.obj"), "--origin", "here"])
    assert ended.value.code == 2
    assert "expected keep, local or X,Y,Z, got 'here'" in capsys.readouterr().err
