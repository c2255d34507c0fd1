"""Beams: plates along the edges that contain the torsion-free axes."""

from freecad_ortho.fabrication.systems.beams.system import Beams

__all__ = ["Beams"]
