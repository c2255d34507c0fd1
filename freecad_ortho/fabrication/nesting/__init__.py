"""Flat patterns on sheets of one size, nothing lost and nothing doubled."""

from freecad_ortho.fabrication.nesting.nest import Nesting, nest, too_large_words
from freecad_ortho.fabrication.nesting.sheet import Placement, Sheet

__all__ = ["Nesting", "Placement", "Sheet", "nest", "too_large_words"]
