"""Louvres: plates on the midpoints of the sides of every face."""

from freecad_ortho.fabrication.systems.louvres.system import Louvres

__all__ = ["Louvres"]
