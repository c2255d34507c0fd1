"""How drawings are written: with blocks or without, in which version, with which letters."""

from __future__ import annotations

from dataclasses import dataclass

from solver.option import one_of

LAYOUTS = ("blocks", "flat", "parts")
# By what the user calls them and what the library does.
VERSIONS = {"r2010": "R2010", "r12": "R12"}
TEXTS = ("text", "strokes", "none")


@dataclass(frozen=True)
class DxfForm:
    """How drawings are written.

    Args:
        layout: "blocks": one block a part; "flat": no blocks, for readers that know none; "parts":
            the same in one file a part.
        version: of DXF, one of ``VERSIONS``.
        text: "text", its single "strokes", or "none".

    Raises:
        InputError: an unknown word.
    """

    layout: str = "blocks"
    version: str = "r2010"
    text: str = "text"

    def __post_init__(self) -> None:
        for name, word, words in (
            ("dxf", self.layout, LAYOUTS),
            ("dxf version", self.version, VERSIONS),
            ("dxf text", self.text, TEXTS),
        ):
            one_of(name, word, words)
