"""The system of edge beams along the border of a surface or of a net."""

from freecad_ortho.fabrication.systems.edge_beam.sections import edge_section_beside
from freecad_ortho.fabrication.systems.edge_beam.system import EdgeBeam

__all__ = ["EdgeBeam", "edge_section_beside"]
