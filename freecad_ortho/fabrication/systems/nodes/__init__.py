"""Nodes: hubs that beams are butted on or bolted to, and sockets for crossings."""

from freecad_ortho.fabrication.systems.nodes.system import ENDS_OF, Nodes

__all__ = ["ENDS_OF", "Nodes"]
