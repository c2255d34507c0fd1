"""OFF files with quads kept as quads."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from solver.errors import InputError
from solver.io.atomic import write_text
from solver.io.obj import UNIT_COMMENT, ObjData
from solver.io.reading import Decimals, read_text, whole
from solver.io.units import unit_in
from solver.mesh.quadmesh import QuadMesh

# What stands before OFF says what follows the coordinates of a vertex; the first count may follow
# without a blank.
_HEAD = re.compile(r"(ST)?(C)?(N)?(4)?(n)?(?i:OFF)(\d*)")
# Numbers that a vertex may have more for each of the first three: texture, colours, normal.
_MORE = ((2,), (4, 3), (3,))


class _Mismatch(Exception):
    """The numbers do not fit the counts when they are read in this way."""


@dataclass(frozen=True)
class _Words:
    """The words after the header, and the line (from 1) that each stands in."""

    name: str
    words: list[str]
    lines: list[int]

    def refused(self, line: int, wanted: str) -> InputError:
        """The error for a line that holds something else."""
        words = [word for word, at in zip(self.words, self.lines, strict=True) if at == line]
        return InputError(
            f"{self.name}, line {line}: expected {wanted}, got '{' '.join(words)[:40]}'; "
            "mend the line or export again"
        )

    def whole(self, place: int) -> int:
        """The whole number at a place, at least 0.

        Raises:
            _Mismatch: something else is there, or nothing.
        """
        try:
            number = whole(self.words[place])
        except (ValueError, IndexError):
            raise _Mismatch from None
        if number < 0:
            raise _Mismatch
        return number

    def next_line(self, place: int) -> int:
        """The place where the line after that of a word begins."""
        line = self.lines[place]
        while place < len(self.words) and self.lines[place] == line:
            place += 1
        return place


def read_off(path: str | os.PathLike[str]) -> ObjData:
    """Read vertices and faces, whatever stands in one line; colours and normals are passed over.

    Raises:
        InputError: no such file, numbers that do not fit the counts, or more than three dimensions.
    """
    name, unit, unit_line = os.fspath(path), None, 0
    words: list[str] = []
    lines: list[int] = []
    for number, line in enumerate(read_text(path).split("\n"), start=1):
        named = unit_in(line)
        unit, unit_line = (named, number) if named else (unit, unit_line)
        found = line.split("#")[0].split()
        words += found
        lines += [number] * len(found)
    head = _HEAD.fullmatch(words[0]) if words else None
    if head is None:
        raise InputError(f"{name}: expected an OFF file, its first word is not OFF; export again")
    if head[4] or head[5] or words[1:2] == ["BINARY"]:
        what = "binary" if words[1:2] == ["BINARY"] else "of other than three dimensions"
        raise InputError(f"{name}: is an OFF file {what}; export as plain OFF, PLY or OBJ")
    kept = 0 if head[6] else 1
    rest = _Words(name, [head[6], *words[1:]][kept:], lines[kept:])
    decimal = Decimals()
    vertices, polygons, numbers = _body(rest, decimal, (bool(head[k]) for k in (1, 2, 3)))
    remarks = decimal.remarks(name)
    return ObjData(np.array(vertices), polygons, unit, unit_line, numbers, remarks)


def _body(
    rest: _Words, decimal: Decimals, more: Iterator[bool]
) -> tuple[list[list[float]], list[list[int]], list[int]]:
    """Vertices, faces, and the line of each face.

    What belongs together is told by the counts: of the ways to read a file, the first in which its
    numbers are used up exactly. The number of edges may be missing, colours may stand at the end of
    lines.
    """
    vertex_count, face_count = _counts(rest)
    strides = [3]
    for asked, sizes in zip(more, _MORE, strict=True):
        strides = [s + size for s in strides for size in (sizes if asked else (0,))]
    # Two counts that stand alone in their line are probably all there are.
    alone = rest.lines[0] == rest.lines[1] < rest.lines[2]
    for start in (2, 3) if alone else (3,):
        for stride in dict.fromkeys([*_width(rest, start, vertex_count), *strides]):
            first = start + stride * vertex_count
            for by_lines in (False, True):
                try:
                    polygons, numbers = _faces(rest, first, face_count, by_lines)
                except _Mismatch:
                    continue
                return _vertices(rest, decimal, start, stride, vertex_count), polygons, numbers
    raise _odd(rest, vertex_count, face_count)


def _counts(rest: _Words) -> tuple[int, int]:
    """How many vertices and faces there are to be."""
    try:
        vertex_count, face_count = rest.whole(0), rest.whole(1)
    except _Mismatch:
        line = rest.lines[0] if rest.lines else 1
        raise rest.refused(line, "2 numbers, of vertices and faces") from None
    if not (vertex_count and face_count):
        raise InputError(f"{rest.name}: has no vertices or no faces; export the mesh's faces")
    if 2 + 3 * vertex_count + face_count > len(rest.words):
        raise _odd(rest, vertex_count, face_count)
    return vertex_count, face_count


def _odd(rest: _Words, vertex_count: int, face_count: int) -> InputError:
    """The error for numbers that do not fit the counts; names the line where that can be told."""
    start = {line: place for place, line in reversed(list(enumerate(rest.lines)))}
    rows = [(line, place) for line, place in reversed(start.items()) if line > rest.lines[1]]
    if len(rows) == vertex_count + face_count:
        for number, (line, place) in enumerate(rows):
            words = rest.words[place : rest.next_line(place)]
            if number < vertex_count and not _is_point(words):
                return rest.refused(line, "3 numbers or more")
            if number >= vertex_count and not _is_face(words):
                return rest.refused(line, "a number of corners, 3 or more, and their vertices")
    return InputError(
        f"{rest.name}: its {len(rest.words)} numbers are not those of {vertex_count} vertices and "
        f"{face_count} faces; the file is cut off or holds other data, export again"
    )


def _is_point(words: list[str]) -> bool:
    decimal = Decimals()
    try:
        return len([decimal(word) for word in words]) >= 3
    except ValueError:
        return False


def _is_face(words: list[str]) -> bool:
    try:
        corners = whole(words[0])
        numbers = [whole(word) for word in words[1 : 1 + corners]]
    except ValueError:
        return False
    return len(numbers) == corners >= 3 and min(numbers) >= 0


def _width(rest: _Words, start: int, count: int) -> list[int]:
    """How many numbers each vertex has where each stands in a line of its own."""
    if rest.lines[start : start + 1] in ([], [rest.lines[start - 1]]):
        return []
    width = rest.next_line(start) - start
    lines = rest.lines[start : start + width * count]
    rows = np.array(lines[: len(lines) - len(lines) % width]).reshape(-1, width)
    alike = len(rows) == count and (rows == rows[:, :1]).all() and (np.diff(rows[:, 0]) > 0).all()
    return [width] if alike and width >= 3 else []


def _vertices(
    rest: _Words, decimal: Decimals, start: int, stride: int, count: int
) -> list[list[float]]:
    """The first three numbers of each vertex."""
    rows = []
    for first in range(start, start + stride * count, stride):
        row = []
        for place in range(first, first + 3):
            try:
                row.append(decimal(rest.words[place]))
            except ValueError:
                raise rest.refused(rest.lines[place], "3 numbers") from None
        rows.append(row)
    return rows


def _faces(
    rest: _Words, place: int, count: int, by_lines: bool
) -> tuple[list[list[int]], list[int]]:
    """The corners of each face and the line where it begins; ``by_lines``: colours follow them.

    Raises:
        _Mismatch: the numbers are not used up exactly.
    """
    polygons, numbers = [], []
    for _ in range(count):
        corners = rest.whole(place)
        end = place + 1 + corners
        if corners < 3 or end > len(rest.words):
            raise _Mismatch
        polygons.append([rest.whole(k) for k in range(place + 1, end)])
        numbers.append(rest.lines[place])
        place = rest.next_line(end - 1) if by_lines else end
    if place != len(rest.words):
        raise _Mismatch
    return polygons, numbers


def write_off(path: str | os.PathLike[str], mesh: QuadMesh, unit: str | None = None) -> None:
    """Write a mesh with every digit, whole or not at all.

    Raises:
        OutputError: the folder is missing or cannot be written.
    """
    head = ["OFF"] + ([] if unit is None else [UNIT_COMMENT + unit])
    head.append(
        f"{len(mesh.vertices)} {mesh.connectivity.face_count} {len(mesh.connectivity.edges)}"
    )
    points = ["{!r} {!r} {!r}".format(*row) for row in mesh.vertices.tolist()]
    faces = [" ".join(map(str, [len(row), *row])) for row in mesh.connectivity.polygons]
    write_text(path, "\n".join(head + points + faces) + "\n")
