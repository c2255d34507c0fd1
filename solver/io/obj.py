"""Wavefront OBJ files with quads kept as quads.

Reading gives plain arrays and remarks; whether they make a usable mesh is decided by
:func:`solver.mesh.intake.quad_mesh`.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from solver.errors import InputError
from solver.io.atomic import write_text
from solver.io.reading import Decimals, read_text, whole
from solver.io.units import unit_in
from solver.mesh.quadmesh import FloatArray, QuadMesh

UNIT_COMMENT = "# unit: "


@dataclass(frozen=True)
class ObjData:
    """Contents of an OBJ file.

    Attributes:
        vertices: (V, 3) coordinates as written.
        polygons: one list of vertex numbers (from 0) a face, any length.
        unit: mm, cm, m, in or ft where the file names one, another word that it names, or None.
        unit_line: line of the file that names it, 0 where that is not known.
        lines: line of the file of each face, empty where that is not known.
        remarks: what is to be said about how it was read, in plain words.
        border: closed polylines (N, 3) along which parts on the mesh are trimmed.
    """

    vertices: FloatArray
    polygons: list[list[int]]
    unit: str | None
    unit_line: int = 0
    lines: Sequence[int] = ()
    remarks: tuple[str, ...] = ()
    border: tuple[FloatArray, ...] = ()


def read_obj(path: str | os.PathLike[str]) -> ObjData:
    """Read vertices and faces of an OBJ file; normals, textures and groups are passed over.

    Raises:
        InputError: no such file, not readable as text, or a line that cannot be understood.
    """
    name, decimal = os.fspath(path), Decimals()
    vertices: list[list[float]] = []
    polygons: list[list[int]] = []
    lines: list[int] = []
    unit, unit_line = None, 0
    for number, line in _lines(read_text(path)):
        words = line.split()
        if words[0].startswith("#"):
            named = unit_in(line)
            unit, unit_line = (named, number) if named else (unit, unit_line)
        elif words[0] == "v":
            vertices.append(_coordinates(words, decimal, name, number))
        elif words[0] == "f":
            polygons.append(_corners(words, len(vertices), name, number))
            lines.append(number)
    if not vertices:
        raise InputError(f"{name}: no vertex lines ('v x y z'); give an OBJ file with a quad mesh")
    if not polygons:
        raise InputError(f"{name}: has vertices but no faces ('f' lines); export the mesh's faces")
    return ObjData(np.array(vertices), polygons, unit, unit_line, lines, decimal.remarks(name))


def write_obj(path: str | os.PathLike[str], mesh: QuadMesh, unit: str | None = None) -> None:
    """Write a mesh with every digit that a float64 has, whole or not at all.

    Raises:
        OutputError: the folder is missing or cannot be written.
    """
    net = mesh.connectivity
    kind = "faces" if net.mixed else "quads"
    head = [f"# {len(mesh.vertices)} vertices, {net.face_count} {kind}"]
    if unit is not None:
        head.append(UNIT_COMMENT + unit)
    points = ["v {!r} {!r} {!r}".format(*row) for row in mesh.vertices.tolist()]
    faces = ["f " + " ".join(str(corner + 1) for corner in row) for row in net.polygons]
    write_text(path, "\n".join(head + points + faces) + "\n")


def _lines(text: str) -> Iterator[tuple[int, str]]:
    """Number and text of each vertex, face and comment; what is begun may go on in the next line.

    Comments go first: a backslash at the end of one, or of a name, continues nothing.
    """
    begun, first = "", 0
    for number, line in enumerate(text.split("\n"), start=1):
        if line.lstrip().startswith("#"):
            yield number, line
            continue
        data = begun + line.partition("#")[0].rstrip()
        first = first if begun else number
        begun = ""
        if data.split(maxsplit=1)[:1] not in (["v"], ["f"]):
            continue
        if data.endswith("\\"):
            begun = data[:-1] + " "
        else:
            yield first, data
    if begun:
        yield first, begun


def _coordinates(words: list[str], decimal: Decimals, name: str, number: int) -> list[float]:
    try:
        # Weights and colours may follow; what is no number at all belongs to another line.
        x, y, z, *_ = (decimal(word) for word in words[1:])
    except ValueError:
        raise InputError(
            f"{name}, line {number}: expected 'v x y z', got '{' '.join(words)[:40]}'; "
            "mend the line or export again"
        ) from None
    return [x, y, z]


def _corners(words: list[str], vertices_so_far: int, name: str, number: int) -> list[int]:
    corners = []
    for word in words[1:]:
        try:
            index = whole(word.split("/", 1)[0])
        except ValueError:
            index = 0
        if index == 0:
            raise InputError(
                f"{name}, line {number}: '{word[:20]}' is not a vertex number (they start at 1); "
                "mend the line or export again"
            )
        if index < -vertices_so_far:
            raise InputError(
                f"{name}, line {number}: '{word[:20]}' counts back beyond the first vertex "
                f"({vertices_so_far} so far); mend the line or export again"
            )
        corners.append(index - 1 if index > 0 else vertices_so_far + index)
    return corners
