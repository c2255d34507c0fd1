"""What the border of a surface leaves of a net that overhangs it."""

from freecad_ortho.fabrication.trimming.trimming import Trimming

__all__ = ["Trimming"]
