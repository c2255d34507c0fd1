"""A system of one's own is known by its entry: on the command line, in files and in messages."""

from __future__ import annotations

import json

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.__main__ import main
from freecad_ortho.fabrication.systems import SYSTEMS
from solver.errors import InputError
from tests.own_system import Tags


@pytest.fixture
def own():
    SYSTEMS[Tags.name] = Tags
    yield Tags
    del SYSTEMS[Tags.name]


def test_it_is_built_from_its_options(own, roof):
    structure = api.fabricate(roof, "tags", tag_size=150, thickness=5)
    assert len(structure.parts) == len(roof.faces)
    for part in structure.parts:
        middle = np.asarray(part.points).mean(axis=0)
        face = roof.vertices[roof.faces[part.face]].mean(axis=0)
        assert np.linalg.norm(middle - face) == pytest.approx(2.5, abs=1e-6)
        assert part.solid().Volume() == pytest.approx(150 * 150 * 5, rel=1e-9)
    assert structure.report()["tags"]["tag_size_mm"] == 150


def test_what_it_has_not_is_refused_by_naming_what_there_is(own, roof):
    with pytest.raises(InputError, match=r"^tag_size: beams has no such size, it is of tags"):
        api.fabricate(roof, "beams", tag_size=150)
    with pytest.raises(InputError, match="tag size"):
        api.fabricate(roof, "tags", tag_size=-1)


def test_the_command_line_knows_it_and_its_option(own, roof, tmp_path, capsys):
    api.write_mesh(tmp_path / "roof.obj", roof, "mm")
    with pytest.raises(SystemExit):
        main(["fabricate", "--help"])
    said = capsys.readouterr().out
    assert "tags" in said and "--tag-size" in said
    command = ["fabricate", str(tmp_path / "roof.obj"), "--system", "tags", "--tag-size", "80"]
    assert main([*command, "-o", str(tmp_path / "files")]) == 0
    report = json.loads((tmp_path / "files" / "report.json").read_text(encoding="utf-8"))
    assert report["counts"]["tags"] == len(roof.faces) and report["tags"]["tag_size_mm"] == 80
