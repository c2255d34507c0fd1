"""Flat patterns on sheets of one size, nothing lost and nothing doubled."""

from freecad_ortho.fabrication.nesting.nest import nest
from freecad_ortho.fabrication.nesting.sheet import Placement, Sheet

__all__ = ["Placement", "Sheet", "nest"]
