"""Wavefront OBJ files with quads kept as quads.

Reading gives plain arrays and remarks; whether they make a usable mesh is decided by
:func:`solver.io.intake.quad_mesh`.
"""

from __future__ import annotations

import os
from dataclasses import dataclass

import numpy as np

from solver.errors import InputError
from solver.io.atomic import write_text
from solver.io.reading import read_text
from solver.mesh.quadmesh import FloatArray, QuadMesh

UNIT_COMMENT = "# unit: "


@dataclass(frozen=True)
class ObjData:
    """Contents of an OBJ file.

    Attributes:
        vertices: (V, 3) coordinates as written.
        polygons: one list of vertex numbers (from 0) a face, any length.
        unit: the unit named in a ``# unit: mm`` comment, or None.
    """

    vertices: FloatArray
    polygons: list[list[int]]
    unit: str | None


def read_obj(path: str | os.PathLike[str]) -> ObjData:
    """Read vertices and faces of an OBJ file; normals, textures and groups are passed over.

    Raises:
        InputError: no such file, not readable as text, or a line that cannot be understood.
    """
    name = os.fspath(path)
    vertices: list[list[float]] = []
    polygons: list[list[int]] = []
    unit = None
    for number, line in enumerate(read_text(path).replace("\\\n", " ").splitlines(), start=1):
        words = line.split()
        if not words:
            continue
        if line.startswith(UNIT_COMMENT):
            unit = line[len(UNIT_COMMENT) :].strip()
        elif words[0] == "v":
            vertices.append(_coordinates(words, name, number))
        elif words[0] == "f":
            polygons.append(_corners(words, len(vertices), name, number))
    if not vertices:
        raise InputError(f"{name}: no vertex lines ('v x y z'); give an OBJ file with a quad mesh")
    if not polygons:
        raise InputError(f"{name}: has vertices but no faces ('f' lines); export the mesh's faces")
    return ObjData(np.array(vertices), polygons, unit)


def write_obj(path: str | os.PathLike[str], mesh: QuadMesh, unit: str | None = None) -> None:
    """Write a mesh with every digit that a float64 has, whole or not at all.

    Raises:
        OutputError: the folder is missing or cannot be written.
    """
    head = [f"# {len(mesh.vertices)} vertices, {len(mesh.faces)} quads"]
    if unit is not None:
        head.append(UNIT_COMMENT + unit)
    points = ["v {!r} {!r} {!r}".format(*row) for row in mesh.vertices.tolist()]
    quads = ["f {} {} {} {}".format(*row) for row in (mesh.faces + 1).tolist()]
    write_text(path, "\n".join(head + points + quads) + "\n")


def _coordinates(words: list[str], name: str, number: int) -> list[float]:
    try:
        x, y, z = (float(word) for word in words[1:4])
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
            index = int(word.split("/", 1)[0])
        except ValueError:
            index = 0
        if index == 0:
            raise InputError(
                f"{name}, line {number}: '{word[:20]}' is not a vertex number (they start at 1); "
                "mend the line or export again"
            )
        corners.append(index - 1 if index > 0 else vertices_so_far + index)
    return corners
