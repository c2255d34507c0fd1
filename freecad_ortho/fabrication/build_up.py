"""Build-ups of glass as the trade writes them: what lies on what, how thick, how heavy, how large.

``8+1.52+8`` is laminated, ``44.2`` two panes of 4 mm with two films, ``6/16/44.2`` an insulating
unit. The first layer is the outermost.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

from solver.errors import InputError

# Float glass: density, kg/m3 (EN 572-1).
GLASS_DENSITY = 2500.0
# Characteristic bending strengths of glass, MPa: annealed (EN 572-1, EN 16612), heat strengthened
# (EN 1863-1) and thermally toughened (EN 12150-1); all for short loads.
STRENGTHS = {"glass": 45.0, "strengthened-glass": 70.0, "toughened-glass": 120.0}
# Nominal thicknesses that stand in abbreviations such as 44.2, and the range of EN 572-2, mm.
_NOMINAL = r"10|12|15|19|[2-9]"
_THINNEST, _THICKEST = 2.0, 25.0
# A film of polyvinyl butyral, mm; as many of them as the digit after the point of 44.2 says.
_FILM = 0.38
# What the letters after a thickness stand for, and densities of interlayers, kg/m3: polyvinyl
# butyral 1070, ionoplast 950, ethylene vinyl acetate 950 (makers' data).
_PANES = {"s": "strengthened-glass", "t": "toughened-glass"}
_INTERLAYERS = {"": ("PVB", 1070.0), "pvb": ("PVB", 1070.0), "sg": ("ionoplast", 950.0)}
_INTERLAYERS["eva"] = ("EVA", 950.0)
# Gases weigh less than 0.1 kg/m2.
_GASES = {"": "cavity", "air": "air", "ar": "argon", "kr": "krypton"}
_LAYER = re.compile(r"(\d{1,3}(?:\.\d{1,2})?)([a-z]*)(?:@(\d{1,4}(?:\.\d{1,2})?))?")
_SHORT = re.compile(rf"({_NOMINAL})({_NOMINAL})\.(\d)([a-z]*)(@[\d.]+)?")
_WAYS = "write glass:8, glass:8+1.52+8, glass:44.2 or glass:6/16/44.2"

PANE, INTERLAYER, CAVITY = "pane", "interlayer", "cavity"


@dataclass(frozen=True)
class MaterialLayer:
    """One layer of a build-up.

    Attributes:
        kind: ``pane``, ``interlayer`` or ``cavity``.
        of: what it is made of: of a pane one of ``STRENGTHS``.
        thickness: mm.
        density: kg/m3.
        step: how far its edges stand back from the outline of the whole, mm.
    """

    kind: str
    of: str
    thickness: float
    density: float
    step: float = 0.0

    @property
    def weight(self) -> float:
        """Mass of a square metre, kg."""
        return self.thickness * self.density / 1000


def pane(thickness: float, of: str = "glass") -> MaterialLayer:
    """A pane of glass."""
    return MaterialLayer(PANE, of, thickness, GLASS_DENSITY)


def cavity(thickness: float, gas: str = "") -> MaterialLayer:
    """The space between two panes."""
    return MaterialLayer(CAVITY, _GASES[gas], thickness, 0.0)


def layers_of(text: str, glass: str = "glass") -> tuple[MaterialLayer, ...]:
    """Read a build-up, from the outermost layer to the innermost.

    Panes, laminated or not, and the cavities between them are separated by ``/``. The plies and
    interlayers of a laminated pane are separated by ``+``, or shortened: ``44.2`` is two panes of
    4 mm and two films of 0.38 mm. ``s`` and ``t`` after a thickness is strengthened and toughened
    glass; ``sg`` or ``eva`` after that of an interlayer, ``ar``, ``kr`` or ``air`` after that of a
    cavity what it is. ``@20`` after it sets a pane's edges back by 20 mm.

    Args:
        text: without blanks, in small letters.
        glass: of panes without a letter, one of ``STRENGTHS``.

    Raises:
        InputError: what is no build-up.
    """
    found: list[MaterialLayer] = []
    for number, item in enumerate(text.split("/")):
        found += _cavity(item, text) if number % 2 else _laminate(item, text, glass)
    if text.count("/") % 2:
        raise _wrong(text, "ends with a cavity")
    if not math.isclose(min(layer.step for layer in found), 0.0):
        raise _wrong(text, "has every layer set back; leave the largest one without @")
    return _reaching(found)


def density_of(layers: Sequence[MaterialLayer]) -> float:
    """Mass by the whole volume of layers of one size, kg/m3."""
    return sum(layer.thickness * layer.density for layer in layers) / thickness_of(layers)


def thickness_of(layers: Sequence[MaterialLayer]) -> float:
    """Of all layers, mm."""
    return sum(layer.thickness for layer in layers)


def panes_of(layers: Sequence[MaterialLayer]) -> tuple[MaterialLayer, ...]:
    """The panes among layers."""
    return tuple(layer for layer in layers if layer.kind == PANE)


def _laminate(item: str, text: str, glass: str) -> list[MaterialLayer]:
    """The plies of one pane, with what is between them."""
    short = _SHORT.fullmatch(item)
    if short is not None:
        one, other, films, word, step = short.groups()
        if films == "0":
            raise _wrong(text, f"has no film in {item}")
        item = f"{one}{word}{step or ''}+{int(films) * _FILM:g}+{other}{word}{step or ''}"
    plies: list[MaterialLayer] = []
    for number, ply in enumerate(item.split("+")):
        plies.append(_interlayer(ply, text) if number % 2 else _pane(ply, text, glass))
    if item.count("+") % 2:
        raise _wrong(text, f"ends a pane with an interlayer, {item}")
    return plies


def _pane(item: str, text: str, glass: str) -> MaterialLayer:
    thickness, word, step = _read(item, text, ("", *_PANES))
    if not _THINNEST <= thickness <= _THICKEST:
        raise _wrong(
            text,
            f"has a pane of {thickness:g} mm, float glass is {_THINNEST:g} to {_THICKEST:g} mm",
        )
    return replace(pane(thickness, _PANES.get(word, glass)), step=step)


def _interlayer(item: str, text: str) -> MaterialLayer:
    thickness, word, _ = _read(item, text, tuple(_INTERLAYERS), steps=False)
    return MaterialLayer(INTERLAYER, _INTERLAYERS[word][0], thickness, _INTERLAYERS[word][1])


def _cavity(item: str, text: str) -> list[MaterialLayer]:
    thickness, word, _ = _read(item, text, tuple(_GASES), steps=False)
    return [cavity(thickness, word)]


def _read(
    item: str, text: str, words: Sequence[str], steps: bool = True
) -> tuple[float, str, float]:
    """Thickness, word and step of one layer."""
    match = _LAYER.fullmatch(item)
    if match is None:
        raise _wrong(text, f"has a layer '{item}', which is no thickness in mm")
    thickness, word, step = float(match[1]), match[2], match[3]
    if not thickness > 0:
        raise _wrong(text, f"has a layer of {thickness:g} mm")
    if word not in words:
        raise _wrong(text, f"has '{word}' in {item}, where {', '.join(filter(None, words))} may be")
    if step is not None and not steps:
        raise _wrong(text, f"sets {item} back; what lies between panes follows them")
    return thickness, word, float(step or 0.0)


def _reaching(layers: Sequence[MaterialLayer]) -> tuple[MaterialLayer, ...]:
    """The layers, what lies between two panes as large as the smaller of both."""
    made = list(layers)
    for number in range(1, len(made), 2):
        step = max(made[number - 1].step, made[number + 1].step)
        made[number] = replace(made[number], step=step)
    return tuple(made)


def _wrong(text: str, what: str) -> InputError:
    return InputError(f"material: glass '{text}' {what}; {_WAYS}")
