"""Lamellas: developable strips along the parameter lines."""

from freecad_ortho.fabrication.systems.lamellas.system import Lamellas

__all__ = ["Lamellas"]
