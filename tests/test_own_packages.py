"""The workbench finds the packages of its own environment, and only those that fit."""

import sys

import freecad_ortho

VERSION = f"{sys.version_info.major}.{sys.version_info.minor}"
OTHER = f"{sys.version_info.major}.{sys.version_info.minor + 1}"


def windows_environment(folder, version):
    packages = folder / "Lib" / "site-packages"
    packages.mkdir(parents=True)
    (folder / "pyvenv.cfg").write_text(f"home = C:\\Python\nversion = {version}.4\n")
    return packages


def test_packages_of_linux_and_mac(tmp_path):
    packages = tmp_path / "lib" / f"python{VERSION}" / "site-packages"
    packages.mkdir(parents=True)
    assert freecad_ortho.packages_in(tmp_path) == packages


def test_packages_of_windows(tmp_path):
    packages = windows_environment(tmp_path, VERSION)
    assert freecad_ortho.packages_in(tmp_path) == packages


def test_packages_of_another_python_are_passed_over(tmp_path):
    (tmp_path / "linux" / "lib" / f"python{OTHER}" / "site-packages").mkdir(parents=True)
    windows_environment(tmp_path / "windows", OTHER)
    for name in ("linux", "windows", "absent"):
        assert freecad_ortho.packages_in(tmp_path / name) is None


def test_own_packages_come_first_and_once(tmp_path, monkeypatch):
    packages = tmp_path / ".venv" / "lib" / f"python{VERSION}" / "site-packages"
    packages.mkdir(parents=True)
    monkeypatch.setattr(freecad_ortho, "_HOME", tmp_path)
    monkeypatch.setattr(sys, "path", ["elsewhere"])
    for _ in range(2):
        freecad_ortho.use_own_packages()
        assert sys.path == [str(packages), "elsewhere"]
