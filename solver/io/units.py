"""Words for units of length as people and programs write them into files."""

from __future__ import annotations

import re

_WORDS = {
    "mm": ("mm", "millimetre", "millimetres", "millimeter", "millimeters"),
    "cm": ("cm", "centimetre", "centimetres", "centimeter", "centimeters"),
    "m": ("m", "metre", "metres", "meter", "meters"),
    "in": ("in", "inch", "inches"),
    "ft": ("ft", "foot", "feet"),
}
_NAMES = {word: name for name, words in _WORDS.items() for word in words}
_COMMENT = re.compile(r"\s*(?:#+|comment\b)\s*(?:file\s+)?units?\s*[:=]\s*(\S+)", re.IGNORECASE)


def unit_named(word: str) -> str:
    """The short name (mm, cm, m, in, ft) of a unit in any spelling; other words as they are."""
    return _NAMES.get(word.strip().lower().rstrip(".;,"), word.strip())


def unit_in(comment: str) -> str | None:
    """The unit that a comment such as ``# Units: inches`` names, or None."""
    found = _COMMENT.match(comment)
    return unit_named(found.group(1)) if found else None
