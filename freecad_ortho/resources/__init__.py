"""Files that come with the workbench."""

from __future__ import annotations

from pathlib import Path

_FOLDER = Path(__file__).resolve().parent


def icon(name: str) -> str:
    """Give the path of the icon ``name`` (without the ending)."""
    return str(_FOLDER / "icons" / f"{name}.svg")
