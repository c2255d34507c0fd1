"""PDF: drawings of a structure for the office, at standard scales, with a title block each."""

from freecad_ortho.fabrication.exchange.drawings.drawings import write_drawings

__all__ = ["write_drawings"]
