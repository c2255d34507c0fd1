"""The workbench: from freeform quad meshes to buildings."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path

__version__ = "0.1.0"


def shadowing_module() -> str | None:
    """Say in one line which foreign module stands in the place of our ``solver``, if any.

    The add-on's folder lies on Python's path among others, so a stranger's ``solver`` can be found
    first. Nothing is imported to find out.
    """
    home = Path(__file__).resolve().parents[1]
    found = find_spec("solver")
    if found is None:
        return f"Ortho: the package 'solver' is missing beside {home}; install the add-on again"
    origin = Path(found.origin).resolve() if found.origin else None
    if origin is not None and origin.parents[1] == home:
        return None
    return (
        f"Ortho: Python finds another module named 'solver' at {origin or found.name} before the "
        f"one in {home}; remove or rename it, then start FreeCAD again"
    )
