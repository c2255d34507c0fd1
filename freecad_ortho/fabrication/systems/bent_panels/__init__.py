"""Rows of faces between two parameter lines as single bent plates."""

from freecad_ortho.fabrication.systems.bent_panels.system import BentPanels

__all__ = ["BentPanels"]
