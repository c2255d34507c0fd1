"""Whole developable sheets, laid flat in one piece or cut along parameter lines."""

from freecad_ortho.fabrication.systems.patches.system import Patches

__all__ = ["Patches"]
