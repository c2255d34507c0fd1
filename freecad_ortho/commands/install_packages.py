"""The command Install missing packages."""

from __future__ import annotations

import FreeCAD

from freecad_ortho import packages
from freecad_ortho.commands import requirements
from freecad_ortho.resources import icon

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class InstallPackages:
    """Open the window that installs what is missing; works where numpy is missing too."""

    def GetResources(self) -> dict[str, str]:
        """Text and icon."""
        return {
            "Pixmap": icon("packages"),
            "MenuText": QT_TRANSLATE_NOOP("Ortho_InstallPackages", "Install missing packages"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "Ortho_InstallPackages",
                "Install the Python packages that the workbench needs and FreeCAD does not find",
            ),
        }

    def IsActive(self) -> bool:
        """Where something is missing."""
        return bool(packages.missing())

    def Activated(self) -> None:
        """Open the window."""
        requirements.show_installer(packages.missing())
