"""The workbench: from freeform quad meshes to buildings."""

from __future__ import annotations

import sys
from importlib.util import find_spec
from pathlib import Path

__version__ = "0.2.0"

_HOME = Path(__file__).resolve().parents[1]


def use_own_packages(add_on_folder: Path | None = None) -> None:
    """Put the packages of the project's own ``.venv`` first on Python's path, if it fits.

    ``scripts/setup.sh`` makes that environment for FreeCAD's Python. FreeCAD with a window empties
    PYTHONPATH when it starts, so it has to be found from here.

    Args:
        add_on_folder: where FreeCAD installs packages for add-ons; takes the place of ``.venv``
            when cadquery is in there. FreeCAD has it last on the path, behind older packages of
            the system that newer ones cannot work with.
    """
    packages = packages_in(_HOME / ".venv")
    if packages is None and add_on_folder is not None and (add_on_folder / "cadquery").is_dir():
        packages = add_on_folder
        sys.path[:] = [path for path in sys.path if path != str(packages)]
    if packages is not None and str(packages) not in sys.path:
        sys.path.insert(0, str(packages))


def packages_in(environment: Path) -> Path | None:
    """Give the packages folder of a virtual environment, None where it does not fit this Python.

    An environment of another Python version has another folder name, or on Windows, where the name
    is always the same, another version in its settings.
    """
    version = f"{sys.version_info.major}.{sys.version_info.minor}"
    packages = environment / "lib" / f"python{version}" / "site-packages"
    if packages.is_dir():
        return packages
    packages, settings = environment / "Lib" / "site-packages", environment / "pyvenv.cfg"
    if packages.is_dir() and settings.is_file():
        lines = settings.read_text(encoding="utf-8", errors="replace").splitlines()
        values = [line.partition("=")[2].strip() for line in lines if line.startswith("version")]
        if any(value.startswith(version + ".") for value in values):
            return packages
    return None


def shadowing_module() -> str | None:
    """Say in one line which foreign module stands in the place of our ``solver``, if any.

    The add-on's folder lies on Python's path among others, so a stranger's ``solver`` can be found
    first. Nothing is imported to find out.
    """
    found = find_spec("solver")
    if found is None:
        return f"Ortho: the package 'solver' is missing beside {_HOME}; install the add-on again"
    origin = Path(found.origin).resolve() if found.origin else None
    if origin is not None and origin.parents[1] == _HOME:
        return None
    return (
        f"Ortho: Python finds another module named 'solver' at {origin or found.name} before the "
        f"one in {_HOME}; remove or rename it, then start FreeCAD again"
    )
