"""The Python packages that the workbench needs; imports none of them."""

from __future__ import annotations

from importlib.util import find_spec

import FreeCAD

import freecad_ortho

_FOR_FABRICATION = ("cadquery", "ezdxf")
_REMEDY = "run scripts/setup.sh in the add-on's folder, or install it for FreeCAD's Python"


def say_unusable(error: ImportError) -> None:
    """Say why there are no commands: a package is missing, too old, or hidden by another."""
    reason = freecad_ortho.shadowing_module() or f"Ortho: {error}; {_REMEDY}"
    FreeCAD.Console.PrintError(reason + "\n")


def say_missing() -> None:
    """Say which packages are missing that only a part of the commands needs."""
    for name in _FOR_FABRICATION:
        if find_spec(name) is None:
            FreeCAD.Console.PrintWarning(
                f"Ortho: beams, panels and their files need the Python package '{name}'; "
                f"{_REMEDY}\n"
            )
