"""English words that depend on a number. Imports nothing."""

from __future__ import annotations

# Ends of nouns that take -es.
_HISSING = ("s", "x", "z", "ch", "sh")
_IRREGULAR = {"foot": "feet"}


def plural(noun: str) -> str:
    """``quads``, ``patches``, ``feet``; of nouns that follow no rule only parts are known."""
    if noun in _IRREGULAR:
        return _IRREGULAR[noun]
    return f"{noun}es" if noun.endswith(_HISSING) else f"{noun}s"


def counted(number: int, noun: str, many: str = "") -> str:
    """``1 quad``, ``2 quads``; ``many`` is the plural of a noun that follows no rule."""
    return f"{number} {noun if number == 1 else many or plural(noun)}"
