"""Fabrication files written where an earlier run has left its own."""

import json
import os

import pytest

from freecad_ortho.fabrication import (
    FILES,
    Beams,
    Panels,
    Workshop,
    build,
    write,
)
from freecad_ortho.fabrication.material import MATERIALS
from freecad_ortho.fabrication.step import read_step
from freecad_ortho.fabrication.systems import Nodes
from solver.errors import InputError, OutputError


@pytest.fixture(scope="module")
def small(dodecahedron):
    return build(dodecahedron, [Beams(200, 12)])


@pytest.fixture(scope="module")
def lapped(roof):
    return build(roof, [Beams(200, 12, ends="lapped"), Nodes("socket", 120, thickness=12)])


def everything_in(folder):
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file())


def test_files_that_only_an_earlier_run_wrote_go_and_others_stay(lapped, small, tmp_path):
    nested = write(lapped, tmp_path, workshop=Workshop(sheet=(12000, 4000)))
    names = [str(path.relative_to(tmp_path)) for path in nested]
    assert everything_in(tmp_path) == sorted(names)
    assert json.loads((tmp_path / "report.json").read_text())["files"] == names
    assert (
        "bends.csv" in names
        and "sheets/sheet-001-steel-12mm.dxf" in names
        and "joints/N0000.stl" in names
    )
    for name in ("mine.csv", "sheets/mine.dxf"):
        (tmp_path / name).write_text("kept")
    write(small, tmp_path)
    assert everything_in(tmp_path) == sorted([*FILES, "mine.csv", "sheets/mine.dxf"])
    assert (tmp_path / "sheets" / "mine.dxf").read_text() == "kept"
    assert not (tmp_path / "joints").exists()


def test_solids_in_a_file_for_each_system_and_back(dodecahedron, tmp_path):
    materials = {"beams": MATERIALS["steel"], "panels": MATERIALS["toughened-glass"]}
    structure = build(dodecahedron, [Beams(200, 12), Panels(20, 15)], material=materials)
    systems = ["structure-beams-steel.step", "structure-panels-toughened-glass.step"]
    for workshop, there, gone in (
        (Workshop(step="systems"), systems, ["structure.step"]),
        (Workshop(), ["structure.step"], systems),
        (Workshop(step="systems"), systems, ["structure.step"]),
    ):
        names = [
            str(path.relative_to(tmp_path))
            for path in write(structure, tmp_path, workshop=workshop)
        ]
        assert everything_in(tmp_path) == sorted(names)
        assert set(there) <= set(names) and not set(gone) & set(names)
    for result, file in zip(structure.results.values(), systems, strict=True):
        read = [part for part, _ in read_step(tmp_path / file)]
        assert read == [part.name for part in result.parts]
    with pytest.raises(InputError, match="step: expected one, systems or in-place, got 'parts'"):
        Workshop(step="parts")


def test_files_of_an_earlier_run_stay_when_the_new_one_fails(lapped, small, tmp_path, monkeypatch):
    write(lapped, tmp_path, workshop=Workshop(sheet=(12000, 4000)))
    before = {name: (tmp_path / name).read_bytes() for name in everything_in(tmp_path)}

    def fail(source, target):
        if target == tmp_path / "stock.csv" and source.parent.name == "new":
            raise OSError(13, "Permission denied")
        return moved(source, target)

    moved = os.replace
    monkeypatch.setattr("solver.io.atomic.os.replace", fail)
    with pytest.raises(OutputError, match="Permission denied"):
        write(small, tmp_path)
    assert {name: (tmp_path / name).read_bytes() for name in everything_in(tmp_path)} == before


@pytest.mark.parametrize(
    "report",
    [
        '{"files": ["mine.csv"]}',
        '{"systems": [], "files": ["../mine.csv", "notes/mine.csv", "mine.txt", 3]}',
        '{"systems": [], "files": 3}',
        "no report at all",
    ],
)
def test_a_report_of_something_else_removes_nothing(small, tmp_path, report):
    folder = tmp_path / "out"
    kept = [
        tmp_path / "mine.csv",
        *(folder / n for n in ("mine.csv", "notes/mine.csv", "mine.txt")),
    ]
    for path in kept:
        path.parent.mkdir(exist_ok=True)
        path.write_text("kept")
    (folder / "report.json").write_text(report)
    write(small, folder)
    assert [path.read_text() for path in kept] == ["kept"] * len(kept)


@pytest.mark.parametrize("name", ["joints", "sheets"])
def test_a_file_in_the_place_of_a_folder_is_said(small, tmp_path, name):
    (tmp_path / name).write_text("mine")
    with pytest.raises(OutputError, match=f"{name}: is a file; remove it"):
        write(small, tmp_path)
    assert everything_in(tmp_path) == [name]


def test_a_folder_in_the_place_of_a_list_is_said_and_kept(lapped, tmp_path):
    (tmp_path / "bends.csv").mkdir()
    (tmp_path / "bends.csv" / "mine.txt").write_text("kept")
    with pytest.raises(OutputError, match=r"bends\.csv: is a folder; remove it"):
        write(lapped, tmp_path)
    assert everything_in(tmp_path) == ["bends.csv/mine.txt"]
