"""The Python packages that the workbench needs: what is said and offered when some are missing.

Imports none of them.
"""

from __future__ import annotations

from pathlib import Path

import FreeCAD

import freecad_ortho
from freecad_ortho import packages, preferences

translate = FreeCAD.Qt.translate

# One offer a session; the command stays in the menu.
_offered = False


def say_unusable(error: ImportError) -> None:
    """Say why there are no commands: a package is missing, too old, or hidden by another."""
    reason = freecad_ortho.shadowing_module() or f"Ortho: {error}"
    FreeCAD.Console.PrintError(reason + "\n")


def offer_missing() -> None:
    """Say which packages are missing and offer, once a session, to install them."""
    global _offered
    names = packages.missing()
    if not names:
        return
    FreeCAD.Console.PrintWarning(
        translate("Ortho", "Ortho: these Python packages are missing: {}").format(", ".join(names))
        + "\n"
    )
    if not _offered and preferences.asks_for_packages():
        _offered = True
        show_installer(names)


def show_installer(names: list[str]) -> None:
    """Open the window that installs packages; FreeCAD stays usable beside it."""
    from freecad_ortho.panels.installer import Installer

    Installer(names, add_on_folder()).show()


def add_on_folder() -> Path:
    """Folder where this FreeCAD keeps packages for its add-ons."""
    version = (int(FreeCAD.Version()[0]), int(FreeCAD.Version()[1]))
    return packages.add_on_folder(FreeCAD.getUserAppDataDir(), version)
