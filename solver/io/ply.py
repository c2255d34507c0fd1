"""PLY files, ascii and binary, with quads kept as quads."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

import numpy as np

from solver.errors import InputError
from solver.io.atomic import write_text
from solver.io.obj import ObjData
from solver.io.reading import Decimals, read_bytes, whole
from solver.io.units import unit_in
from solver.mesh.quadmesh import FloatArray, QuadMesh

_TYPES = {
    **dict.fromkeys(("char", "int8"), "i1"),
    **dict.fromkeys(("uchar", "uint8"), "u1"),
    **dict.fromkeys(("short", "int16"), "i2"),
    **dict.fromkeys(("ushort", "uint16"), "u2"),
    **dict.fromkeys(("int", "int32"), "i4"),
    **dict.fromkeys(("uint", "uint32"), "u4"),
    **dict.fromkeys(("float", "float32"), "f4"),
    **dict.fromkeys(("double", "float64"), "f8"),
}
_END = re.compile(rb"^end_header[ \t]*(?:\r\n|\n|\r)", re.MULTILINE)
_ORDERS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}


@dataclass
class _Element:
    """One section of the file: a name, a count, and properties (name, type, count type or '')."""

    name: str
    count: int
    properties: list[tuple[str, str, str]] = field(default_factory=list)


def read_ply(path: str | os.PathLike[str]) -> ObjData:
    """Read vertices and faces; colours, normals and other elements are passed over.

    The unit is that of a header line ``comment unit: mm``.

    Raises:
        InputError: no such file, or not a PLY file with vertices and faces.
    """
    name = os.fspath(path)
    content = read_bytes(path)
    order, elements, unit, start = _header(content, name)
    decimal = Decimals()
    try:
        if order == "":
            vertices, polygons = _ascii(content[start:], elements, decimal)
        else:
            vertices, polygons = _binary(content, start, order, elements)
    except (ValueError, OverflowError, IndexError, StopIteration, KeyError):
        raise InputError(
            f"{name}: the data do not match the header (cut off or damaged); export again"
        ) from None
    if not len(vertices) or not polygons:
        raise InputError(f"{name}: has no vertices or no faces; export the mesh's faces")
    return ObjData(vertices, polygons, unit, remarks=decimal.remarks(name))


def _header(content: bytes, name: str) -> tuple[str, list[_Element], str | None, int]:
    mark = _END.search(content)
    if not content.startswith(b"ply") or mark is None:
        raise InputError(f"{name}: expected a PLY file, its header is missing; export again")
    order, unit = None, None
    elements: list[_Element] = []
    for line in content[: mark.start()].decode("latin-1").splitlines():
        words = line.split()
        try:
            if words[:1] == ["format"]:
                order = _ORDERS[words[1]]
            elif words[:1] == ["comment"]:
                unit = unit_in(line) or unit
            elif words[:1] == ["element"]:
                elements.append(_Element(words[1], _count(whole(words[2]))))
            elif words[:2] == ["property", "list"]:
                elements[-1].properties.append((words[4], _TYPES[words[3]], _TYPES[words[2]]))
            elif words[:1] == ["property"]:
                elements[-1].properties.append((words[2], _TYPES[words[1]], ""))
        except (KeyError, IndexError, ValueError):
            raise InputError(f"{name}: header line '{line[:40]}' is not understood") from None
    if order is None:
        raise InputError(f"{name}: expected a format line in the header; export again")
    return order, elements, unit, mark.end()


def _count(number: float) -> int:
    """A number of things.

    Raises:
        ValueError, OverflowError: it is none.
    """
    if number < 0 or number != int(number):
        raise ValueError
    return int(number)


def _ascii(
    body: bytes, elements: list[_Element], decimal: Decimals
) -> tuple[FloatArray, list[list[int]]]:
    words = iter(body.decode("latin-1").split())

    def take(count: int, kind: str) -> list[float]:
        return [decimal(next(words)) for _ in range(count)]

    return _elements(elements, take)


def _elements(
    elements: list[_Element], take: Callable[[int, str], list[float]]
) -> tuple[FloatArray, list[list[int]]]:
    """Walk through all elements value by value; ``take`` gives the next values of a type."""
    vertices: list[list[float]] = []
    polygons: list[list[int]] = []
    for element in elements:
        # An element without properties takes no room, however many there are said to be.
        for _ in range(element.count if element.properties else 0):
            row: dict[str, list[float]] = {}
            for name, kind, counted in element.properties:
                count = _count(take(1, counted)[0]) if counted else 1
                row[name] = take(count, kind)
            if element.name == "vertex":
                vertices.append([row[axis][0] for axis in "xyz"])
            elif element.name == "face":
                corners = row["vertex_indices"] if "vertex_indices" in row else row["vertex_index"]
                polygons.append([int(corner) for corner in corners])
    return np.array(vertices, dtype=np.float64).reshape(-1, 3), polygons


def _binary(
    content: bytes, start: int, order: str, elements: list[_Element]
) -> tuple[FloatArray, list[list[int]]]:
    place = start

    def take(count: int, kind: str) -> list[float]:
        nonlocal place
        values = np.frombuffer(content, order + kind, count, place)
        place += values.nbytes
        return list(values.tolist())

    return _elements(elements, take)


def write_ply(path: str | os.PathLike[str], mesh: QuadMesh, unit: str | None = None) -> None:
    """Write an ascii PLY file with every digit, whole or not at all.

    Raises:
        OutputError: the folder is missing or cannot be written.
    """
    write_text(path, "\n".join(_lines(mesh, unit)) + "\n")


def _lines(mesh: QuadMesh, unit: str | None) -> Iterator[str]:
    yield from ("ply", "format ascii 1.0")
    if unit is not None:
        yield f"comment unit: {unit}"
    yield f"element vertex {len(mesh.vertices)}"
    yield from (f"property double {axis}" for axis in "xyz")
    yield f"element face {mesh.connectivity.face_count}"
    yield from ("property list uchar int vertex_indices", "end_header")
    yield from ("{!r} {!r} {!r}".format(*row) for row in mesh.vertices.tolist())
    yield from (" ".join(map(str, [len(row), *row])) for row in mesh.connectivity.polygons)
