"""Drop-down buttons that hold several commands, submenus in the menu."""

from __future__ import annotations

import FreeCAD

from freecad_ortho.commands.command import Command

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class CommandGroup(Command):
    """A button with a list of commands.

    Attributes:
        members: names of the commands' classes.
    """

    members: tuple[str, ...]

    def GetCommands(self) -> tuple[str, ...]:
        """FreeCAD's names of the commands; FreeCAD asks for them once."""
        return tuple(f"Ortho_{name}" for name in self.members)

    def GetDefaultCommand(self) -> int:
        """Which command the button starts with."""
        return 0

    def IsActive(self) -> bool:
        """Always: each command says for itself whether it can be used."""
        return True


class NewNet(CommandGroup):
    """Nets from numbers, faces, triangles and equilibrium."""

    members = ("Primitive", "EllipticNet", "FaceNet", "AlignedNet", "QuadsFromMesh", "FormNet")
    icon = "primitive"
    text = QT_TRANSLATE_NOOP("Ortho_NewNet", "New net")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_NewNet", "A net from numbers, CAD faces, triangles or form-finding"
    )


class ChangeNet(CommandGroup):
    """Nets from other nets."""

    members = ("Derived", "Refine", "Transform", "Offset", "Weld")
    icon = "derived"
    text = QT_TRANSLATE_NOOP("Ortho_ChangeNet", "Net from nets")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_ChangeNet", "Derive, subdivide, transform or weld nets into a new one that follows"
    )
