"""Nodes: hubs that beams are butted on, and sockets for crossings."""

from freecad_ortho.fabrication.systems.nodes.system import Nodes

__all__ = ["Nodes"]
