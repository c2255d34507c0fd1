"""What kinds of structures there are, and which document objects are structures."""

from __future__ import annotations

from freecad_ortho.fabrication import SYSTEMS
from freecad_ortho.objects import outdated

BEAMS, PANELS, NODES, EDGE_BEAM = "Beams", "Panels", "Nodes", "Edge-beam"
LAMELLAS = "Lamellas"
# The title of a system in documents -> its name in fabrication.
TITLES = {name.capitalize(): name for name in SYSTEMS}
# Systems whose parts may lie on beams that are a structure of their own.
ON_BEAMS = ("panels", "nodes")
# Systems whose parts end at an edge beam that is a structure of its own, or lie on it.
AT_EDGE_BEAM = ("beams", "nodes", "panels", "lamellas")


class BuiltProxy(outdated.Following):
    """Base of the proxy of structures, by which they are known."""


def is_structure(feature: object) -> bool:
    """Tell whether a document object is a structure."""
    return isinstance(getattr(feature, "Proxy", None), BuiltProxy)
