"""Panels: flat plates in the faces."""

from freecad_ortho.fabrication.systems.panels.system import Panels

__all__ = ["Panels"]
