"""The different flat patterns of a structure, equal parts once with their number."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, replace

from freecad_ortho.fabrication.nesting.sheet import drawing_name
from freecad_ortho.fabrication.pattern import FlatPattern
from freecad_ortho.fabrication.production import Production


@dataclass(frozen=True, eq=False)
class DifferentPattern:
    """A flat pattern and how often it is cut.

    Attributes:
        name: of the first of the parts that are cut from it.
        pattern: theirs; where it stands for several, without the texts that tell them apart.
        count: of these parts.
        file_name: says what to cut them from, ``P0001-steel-12mm-4x.dxf``.
    """

    name: str
    pattern: FlatPattern
    count: int
    file_name: str


def different_patterns(production: Production) -> tuple[DifferentPattern, ...]:
    """Every flat pattern once, in the order of the parts."""
    equal_to = production.groups.equal_to
    patterns = production.named_patterns
    counts = Counter(equal_to.get(name, name) for name in patterns)
    result = []
    for part in production.structure.parts:
        if (count := counts.get(part.name, 0)) == 0:
            continue
        pattern = patterns[part.name]
        if count > 1:
            lines = tuple(mark for mark in pattern.marks if not mark.text)
            pattern = replace(pattern, marks=lines)
        file_name = drawing_name(part.name, part.material.name, part.thickness, f"{count}x")
        result.append(DifferentPattern(part.name, pattern, count, file_name))
    return tuple(result)
