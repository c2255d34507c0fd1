"""Smaller STEP files: geometry that is written many times is kept once.

The kernel's writer repeats points, directions, lines, units and styles wherever they are used. They
have no identity in STEP, so equal ones may be one entity that many refer to. Vertices, edges and
faces keep theirs: solids share none. Nor do shapes share the placement that they stand on: readers
built on OpenCASCADE go through all that refers to it for each of them, so that the time would grow
with the square of their number.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

# Whatever these refer to comes before them.
_SHARED = (
    *(b"CARTESIAN_POINT", b"DIRECTION", b"VECTOR", b"LINE"),
    *(b"AXIS2_PLACEMENT_3D", b"PLANE", b"SI_UNIT", b"UNCERTAINTY_MEASURE_WITH_UNIT"),
    *(b"PRODUCT_CONTEXT", b"PRODUCT_DEFINITION_CONTEXT"),
)
# How things look. Whatever these refer to, other than themselves, comes before them.
_STYLES = (
    *(b"COLOUR_RGB", b"FILL_AREA_STYLE_COLOUR", b"FILL_AREA_STYLE", b"SURFACE_STYLE_FILL_AREA"),
    *(b"SURFACE_SIDE_STYLE", b"SURFACE_STYLE_USAGE", b"DRAUGHTING_PRE_DEFINED_CURVE_FONT"),
    *(b"CURVE_STYLE", b"PRESENTATION_STYLE_ASSIGNMENT"),
)
_PLACED, _STANDS = b"AXIS2_PLACEMENT_3D", b"SHAPE_REPRESENTATION"
_JOINED = b"REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION("
_STYLED, _LOOK = b"STYLED_ITEM", b"MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION"
_BEGIN, _END = b"DATA;\n", b"ENDSEC;\nEND-ISO-10303-21;"
_ENTITY = re.compile(rb"#(\d+) = ((?:'[^']*'|[^';])*);\s*")
_TOKEN = re.compile(rb"'[^']*'|#(\d+)")
_KIND = re.compile(rb"\(?\s*(\w+)")
_BREAK = re.compile(rb"\n\s*")
_BLANK = re.compile(rb"('[^']*')|\s+")
_POWER = re.compile(rb"-0\.(?=[,)])|-?\d+\.\d*E[+-]\d+")


def compacted(text: bytes) -> bytes:
    """Return a STEP file with shared geometry, its entities numbered anew from 1.

    Args:
        text: as the CAD kernel writes it.
    """
    begin = text.index(_BEGIN) + len(_BEGIN)
    end = text.index(_END, begin)
    entities = {int(found[1]): _packed(found[2]) for found in _ENTITY.finditer(text, begin, end)}
    kinds: dict[bytes, list[int]] = {kind: [] for kind in (*_SHARED, *_STYLES, _STYLED, _LOOK)}
    for number, body in entities.items():
        kind = _kind(body)
        if kind in kinds:
            kinds[kind].append(number)
    same = _same(entities, {kind: kinds[kind] for kind in (*_SHARED, *_STYLES)})
    entities = _with_own_placements(entities, same)
    looks = _in_order(entities, kinds, same)
    last = set(looks)
    left = [number for number in entities if number not in same and number not in last] + looks
    new = {number: b"#%d" % place for place, number in enumerate(left, start=1)}
    new.update((number, new[first]) for number, first in same.items())
    lines = (b"%s=%s;\n" % (new[number], _renamed(entities[number], new)) for number in left)
    return b"".join(_whole(text, begin, end, lines))


def _packed(body: bytes) -> bytes:
    """On one line; entities of several types without blanks between these."""
    body = _BREAK.sub(b"", body)
    return _BLANK.sub(lambda found: found[1] or b"", body) if body.startswith(b"(") else body


def _kind(body: bytes) -> bytes:
    """Name of an entity's type; of the several names of a unit the one that says which."""
    if b"SI_UNIT(" in body:
        return b"SI_UNIT"
    found = _KIND.match(body)
    return found[1] if found else b""


def _same(entities: dict[int, bytes], kinds: dict[bytes, list[int]]) -> dict[int, int]:
    """For each entity that repeats another the number of the first; references are replaced."""
    same: dict[int, int] = {}
    replaced: dict[int, bytes] = {}
    for numbers in kinds.values():
        first: dict[bytes, int] = {}
        for number in numbers:
            body = _renamed(_POWER.sub(_plain, entities[number]), replaced)
            entities[number] = body
            kept = first.setdefault(body, number)
            if kept != number:
                same[number] = kept
                replaced[number] = b"#%d" % kept
    return same


def _with_own_placements(entities: dict[int, bytes], same: dict[int, int]) -> dict[int, bytes]:
    """All entities, and before each shape a copy of each placement that an earlier one has.

    What moves a component from its own placement to that in the assembly then names the copy.
    """
    taken: dict[int, int] = {}
    copies: dict[int, dict[int, bytes]] = {}
    found: dict[int, bytes] = {}
    free = max(entities, default=0)
    for number, body in entities.items():
        if _kind(body).endswith(_STANDS) and not _kind(body).startswith(b"CONTEXT"):
            own: dict[int, bytes] = {}
            for item in _references(body):
                first = same.get(item, item)
                if _kind(entities[first]) == _PLACED and taken.setdefault(first, number) != number:
                    free += 1
                    found[free] = entities[first]
                    own[item] = own[first] = b"#%d" % free
            copies[number], body = own, _renamed(body, own)
        found[number] = body
    for body in entities.values():
        if _JOINED in body:
            shape, whole, move = _references(body)
            ends = zip(_references(entities[move]), (shape, whole), strict=True)
            start, end = (copies[of].get(same.get(k, k), b"#%d" % k) for k, of in ends)
            found[move] = re.sub(rb"#\d+,#\d+", start + b"," + end, entities[move])
    return found


def _references(body: bytes) -> list[int]:
    return [int(number) for number in _TOKEN.findall(body) if number]


def _in_order(
    entities: dict[int, bytes], kinds: dict[bytes, list[int]], same: dict[int, int]
) -> list[int]:
    """Entities that say how things look, in the order of what looks so.

    The kernel writes them by where its shapes lie in memory, another way in each run.
    """
    looks = {number for kind in (*_STYLES, _STYLED, _LOOK) for number in kinds[kind]}
    refers = {number: [same.get(k, k) for k in _references(entities[number])] for number in looks}

    def things(number: int) -> list[int]:
        near = refers[number]
        return [k for k in near if k not in looks] + [
            thing for k in near if k in looks for thing in things(k)
        ]

    # Each after what refers to it: a dictionary keeps the place of what it has already.
    order: dict[int, None] = {}
    for head in sorted(kinds[_LOOK], key=things):
        waiting = [head]
        while waiting:
            number = waiting.pop()
            if number not in order:
                order[number] = None
                waiting += [k for k in reversed(refers[number]) if k in looks]
    return list(order)


def _plain(found: re.Match[bytes]) -> bytes:
    """A number without a power of ten, to the 13 digits that the kernel writes."""
    value = float(found[0])
    text = f"{value:.13g}"
    if "e" in text:
        text = f"{value:.13f}".rstrip("0")
    if "." not in text:
        text += "."
    return b"0." if text in ("-0.", "0.") else text.encode()


def _renamed(body: bytes, names: dict[int, bytes]) -> bytes:
    """The body with its references replaced by those of these names."""

    def name(found: re.Match[bytes]) -> bytes:
        return found[0] if found[1] is None else names.get(int(found[1]), found[0])

    return _TOKEN.sub(name, body) if b"#" in body else body


def _whole(text: bytes, begin: int, end: int, lines: Iterator[bytes]) -> Iterator[bytes]:
    yield text[:begin]
    yield from lines
    yield text[end:]
