"""Sections of beams by the names that one orders, with the numbers that statics and lists need."""

from freecad_ortho.fabrication.profiles.catalogue import SERIES, names, polygon, profile
from freecad_ortho.fabrication.profiles.profile import Profile, Ring

__all__ = ["SERIES", "Profile", "Ring", "names", "polygon", "profile"]
