"""What the workbench needs is known, and is installed where FreeCAD looks for it."""

import subprocess
import sys
from pathlib import Path

import pytest

import freecad_ortho
from freecad_ortho import packages

PYTHON = f"py{sys.version_info.major}{sys.version_info.minor}"


def test_needed_are_those_of_the_metadata_and_all_are_pinned():
    assert {"numpy", "scipy", "cadquery"} <= set(packages.needed())
    pins = (packages.HOME / "requirements.txt").read_text(encoding="utf-8")
    for name in packages.needed():
        assert f"\n{name}==" in pins, name


def test_nothing_is_missing_here_and_a_stranger_is(monkeypatch):
    assert packages.missing() == []
    monkeypatch.setattr(packages, "needed", lambda: ["numpy", "ortho_no_such_package"])
    assert packages.missing() == ["ortho_no_such_package"]


@pytest.mark.parametrize(
    ("freecad", "folder"),
    [((0, 20), "."), ((0, 21), PYTHON), ((1, 0), PYTHON), ((1, 1), PYTHON)],
)
def test_folder_by_version(freecad, folder):
    expected = Path("/home/ada/FreeCAD/AdditionalPythonPackages") / folder
    assert packages.add_on_folder("/home/ada/FreeCAD/", freecad) == expected


def test_interpreters_of_a_bundle_come_first(tmp_path):
    for name in ("python3", "python.exe"):
        (tmp_path / "bin").mkdir(exist_ok=True)
        (tmp_path / "bin" / name).touch()
    found = packages.interpreters(str(tmp_path))
    assert found[:2] == [tmp_path / "bin" / "python3", tmp_path / "bin" / "python.exe"]
    assert all(path.is_file() for path in found)


def test_pip_accepts_the_arguments(tmp_path):
    arguments = packages.pip_arguments(["ortho_no_such_package"], tmp_path / "target")
    command = [sys.executable, *arguments, "--dry-run", "--no-index", "--isolated"]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    # There is no index, so nothing is found; but nothing is wrong with the words.
    assert "No matching distribution found for ortho_no_such_package" in result.stderr
    assert not (tmp_path / "target").exists()


def test_add_on_folder_takes_the_place_of_the_environment(tmp_path, monkeypatch):
    folder = tmp_path / "AdditionalPythonPackages"
    (folder / "cadquery").mkdir(parents=True)
    monkeypatch.setattr(freecad_ortho, "_HOME", tmp_path)
    monkeypatch.setattr(sys, "path", ["system", str(folder)])
    freecad_ortho.use_own_packages(folder)
    assert sys.path == [str(folder), "system"]
    monkeypatch.setattr(sys, "path", ["system"])
    freecad_ortho.use_own_packages(tmp_path / "empty")
    assert sys.path == ["system"]
