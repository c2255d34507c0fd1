"""The command offset: what it keeps, and what it refuses."""

from __future__ import annotations

import json

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.__main__ import main
from solver.mesh.primitives import primitive
from tests.test_sources_command_line import call


def test_offset_says_what_it_keeps(tmp_path, capsys):
    path, report = tmp_path / "dome.obj", tmp_path / "offset.json"
    dome = primitive("sphere", 9, 7, radius=8, angles=(0, 150))
    api.write_mesh(path, dome, "m")
    words = ["offset", str(path), "--distance", "150", "--kind", "face", "--report", str(report)]
    found = call(tmp_path, *words)
    assert found.unit == "m"
    apart = np.einsum(
        "fk,fck->fc", dome.face_normals, (found.mesh.vertices - dome.vertices)[dome.faces]
    )
    np.testing.assert_allclose(apart, 0.15, rtol=1e-8)
    assert "in mm: face distance 150 everywhere" in capsys.readouterr().out
    numbers = json.loads(report.read_text())
    assert numbers["miss_max_mm"] <= 1e-6
    assert len(numbers["distances_mm"]) == len(dome.faces)


@pytest.mark.parametrize(
    "words, expected",
    [
        (["--distance", "nan"], "--distance: expected a finite number"),
        (["--distance", "0"], "distance: expected a number other than 0"),
        (["--distance", "-90000"], "folds the offset mesh at edge"),
        (["--distance", "1", "--kind", "corner"], "--kind: expected parallel, vertex"),
        (["--distance", "1", "--report", "OUT"], "is to hold two files"),
        (["--distance", "1", "--report", "/absent/r.json"], "/absent: does not exist"),
    ],
)
def test_bad_offsets_are_one_line(tmp_path, capsys, words, expected):
    path, out = tmp_path / "dome.obj", tmp_path / "out.obj"
    api.write_mesh(path, primitive("sphere", 9, 7, radius=8, angles=(0, 150)), "m")
    words = [str(out) if word == "OUT" else word for word in words]
    assert main(["offset", str(path), *words, "-o", str(out)]) == 2
    error = capsys.readouterr().err
    assert expected in error and error.count("\n") == 1
    assert not out.exists()
