"""Files that come with the workbench."""

from __future__ import annotations

from pathlib import Path

_FOLDER = Path(__file__).resolve().parent
ICONS = str(_FOLDER / "icons")
TRANSLATIONS = str(_FOLDER / "translations")


def icon(name: str) -> str:
    """Give the path of the icon ``name`` (without the ending)."""
    return str(_FOLDER / "icons" / f"{name}.svg")


def form(name: str) -> str:
    """Give the path of the Qt form ``name`` (without the ending)."""
    return str(_FOLDER / f"{name}.ui")
