"""Where nets come from, as tables: each source's options and the function that makes its net.

Knows no FreeCAD. Document objects, task panels and document functions are built from these tables.
All lengths are in mm, angles in degrees.
"""

from freecad_ortho.sources.catalogue import GROUPS, SOURCES, source
from freecad_ortho.sources.source import Made, Source

__all__ = ["GROUPS", "SOURCES", "Made", "Source", "source"]
