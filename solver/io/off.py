"""OFF files with quads kept as quads."""

from __future__ import annotations

import os

import numpy as np

from solver.errors import InputError
from solver.io.atomic import write_text
from solver.io.obj import UNIT_COMMENT, ObjData
from solver.io.reading import read_text
from solver.io.units import unit_in
from solver.mesh.quadmesh import QuadMesh


def read_off(path: str | os.PathLike[str]) -> ObjData:
    """Read vertices and faces; colours at the end of lines and normals (NOFF) are passed over.

    Raises:
        InputError: no such file, or a line that cannot be understood.
    """
    name, unit, unit_line = os.fspath(path), None, 0
    lines: list[tuple[int, list[str]]] = []
    for number, line in enumerate(read_text(path).splitlines(), start=1):
        named = unit_in(line)
        unit, unit_line = (named, number) if named else (unit, unit_line)
        words = line.split("#")[0].split()
        if words:
            lines.append((number, words))
    if not lines or not lines[0][1][0].upper().endswith("OFF"):
        raise InputError(f"{name}: expected an OFF file, its first word is not OFF; export again")
    head = lines[0][1][1:]
    body = lines[1:]
    if not head and body:
        head, body = body[0][1], body[1:]
    counts = _numbers(head, int, name, lines[0][0], 2)
    vertex_count, face_count = counts[0], counts[1]
    if min(counts) < 0 or len(body) < vertex_count + face_count:
        raise InputError(
            f"{name}: expected {vertex_count} vertices and {face_count} faces, got {len(body)} "
            "lines; the file is cut off, export again"
        )
    rows = [_numbers(words, float, name, at, 3)[:3] for at, words in body[:vertex_count]]
    polygons = []
    quads = body[vertex_count : vertex_count + face_count]
    for at, words in quads:
        corners = _numbers(words[:1], int, name, at, 1)[0]
        polygons.append(_numbers(words[1 : 1 + corners], int, name, at, corners))
    if not rows or not polygons:
        raise InputError(f"{name}: has no vertices or no faces; export the mesh's faces")
    numbers = [at for at, _ in quads]
    return ObjData(np.array(rows, dtype=np.float64), polygons, unit, unit_line, numbers)


def _numbers(words: list[str], kind: type, name: str, line: int, least: int) -> list:  # type: ignore[type-arg]
    try:
        values = [kind(word) for word in words]
    except ValueError:
        values = []
    if len(values) < least or least < 0:
        raise InputError(
            f"{name}, line {line}: expected {max(least, 1)} numbers, got '{' '.join(words)[:40]}'; "
            "mend the line or export again"
        )
    return values


def write_off(path: str | os.PathLike[str], mesh: QuadMesh, unit: str | None = None) -> None:
    """Write a mesh with every digit, whole or not at all.

    Raises:
        OutputError: the folder is missing or cannot be written.
    """
    head = ["OFF"] + ([] if unit is None else [UNIT_COMMENT + unit])
    head.append(f"{len(mesh.vertices)} {len(mesh.faces)} {len(mesh.connectivity.edges)}")
    points = ["{!r} {!r} {!r}".format(*row) for row in mesh.vertices.tolist()]
    quads = ["4 {} {} {} {}".format(*row) for row in mesh.faces.tolist()]
    write_text(path, "\n".join(head + points + quads) + "\n")
