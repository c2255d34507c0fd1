"""Support feet: base plates with anchor bolts, and what stands between them and the net."""

from freecad_ortho.fabrication.systems.feet.system import Feet

__all__ = ["Feet"]
