"""The Python packages that the workbench needs: which are missing and how to install them.

Imports none of them and no FreeCAD, so that it works where everything is missing.
"""

from __future__ import annotations

import sys
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterable
from importlib.util import find_spec
from pathlib import Path

HOME = Path(__file__).resolve().parents[1]
_SPACE = {"p": "https://wiki.freecad.org/Package_Metadata"}


def needed() -> list[str]:
    """Name the packages that the add-on's ``package.xml`` asks for and does not call optional."""
    package = ElementTree.parse(HOME / "package.xml").getroot()
    depends = package.findall("p:depend[@type='python']", _SPACE)
    return [str(item.text) for item in depends if item.get("optional") != "true"]


def missing() -> list[str]:
    """Name those of them that Python does not find."""
    return [name for name in needed() if find_spec(name) is None]


def add_on_folder(user_data: str, freecad: tuple[int, int]) -> Path:
    """Folder that FreeCAD's Addon Manager installs packages into, and where FreeCAD finds them.

    Args:
        user_data: FreeCAD's folder of user data.
        freecad: its version; before 0.21 all Python versions shared one folder.
    """
    folder = Path(user_data) / "AdditionalPythonPackages"
    if freecad < (0, 21):
        return folder
    return folder / f"py{sys.version_info.major}{sys.version_info.minor}"


def interpreters(freecad_home: str) -> list[Path]:
    """Files that may be FreeCAD's own Python, the likeliest first; ``sys.executable`` is FreeCAD.

    Args:
        freecad_home: the folder that FreeCAD is installed in.
    """
    names = (f"python{sys.version_info.major}.{sys.version_info.minor}", "python3", "python")
    roots = [Path(freecad_home), Path(sys.base_prefix)]
    folders = [folder for root in roots for folder in (root / "bin", root)]
    places = [folder / name for folder in folders for name in (*names, "python.exe")]
    return [place for place in dict.fromkeys(places) if place.is_file()]


def pip_arguments(names: Iterable[str], folder: Path) -> list[str]:
    """Arguments for a Python that installs packages in a folder, in the versions that are tested.

    Args:
        names: of the packages.
        folder: made if it is not there; packages of the same name in it are replaced.
    """
    arguments = ["-m", "pip", "install", "--disable-pip-version-check", "--no-input"]
    arguments += ["--upgrade", "--target", str(folder), "--progress-bar", "off"]
    return [*arguments, "--constraint", str(HOME / "requirements.txt"), *names]
