"""Arches: plates cut flat along lines that lie in planes."""

from freecad_ortho.fabrication.systems.arches.system import Arches

__all__ = ["Arches"]
