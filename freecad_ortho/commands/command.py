"""What the commands share; their texts stand in their own files, where translators find them."""

from __future__ import annotations

from freecad_ortho.resources import icon
from freecad_ortho.window import context


class Command:
    """A command that is available whenever no task panel is open.

    Attributes:
        icon: name of its picture in ``resources/icons``.
        text: in the menu, marked for translation.
        tip: one sentence, marked for translation.
        shortcut: keys one after the other, for what is used often.
    """

    icon: str
    text: str
    tip: str
    shortcut: str = ""

    @property
    def identifier(self) -> str:
        """FreeCAD's name of it, which is also the context of its words."""
        return f"Ortho_{type(self).__name__.removesuffix('Command')}"

    def GetResources(self) -> dict[str, str]:
        """Text, icon and keys; What's This says the same sentence as the tooltip."""
        texts = {"MenuText": self.text, "ToolTip": self.tip, "WhatsThis": self.tip}
        return {"Pixmap": icon(self.icon), "Accel": self.shortcut, **texts}

    def IsActive(self) -> bool:
        """Tell whether the command can be used now."""
        return context.nothing_open()


class NetCommand(Command):
    """A command that needs a net, and to know which one."""

    def IsActive(self) -> bool:
        """Tell whether it is clear which net is meant."""
        return super().IsActive() and context.current_net() is not None
