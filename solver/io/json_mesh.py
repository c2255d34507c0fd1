"""Quad meshes as JSON: ``{"unit": "mm", "vertices": [[x, y, z]], "faces": [[a, b, c, d]]}``.

A mesh that overhangs the surface that it is on has the surface's border too, ``"border": [[[x, y,
z], ...], ...]``: closed polylines, along which parts on the mesh are trimmed.
"""

from __future__ import annotations

import json
import os
from collections.abc import Sequence

import numpy as np

from solver.errors import InputError
from solver.io.atomic import write_text
from solver.io.compas import compas_mesh
from solver.io.obj import ObjData
from solver.io.reading import read_text
from solver.io.units import unit_named
from solver.mesh.quadmesh import FloatArray, QuadMesh


def read_json(path: str | os.PathLike[str]) -> ObjData:
    """Read vertices, faces (numbers from 0) and unit, or a mesh of COMPAS.

    Raises:
        InputError: no such file, not JSON, or other than lists of numbers in it.
    """
    name = os.fspath(path)
    try:
        data = json.loads(read_text(path))
        found = compas_mesh(data, name)
        if found is None:
            found = (
                data["vertices"],
                [[_whole(corner) for corner in face] for face in data["faces"]],
            )
        unit = data.get("unit", data.get("units")) if isinstance(data, dict) else None
        vertices = np.array(found[0], dtype=np.float64)
    except (
        ValueError,
        OverflowError,
        KeyError,
        TypeError,
        AttributeError,
        RecursionError,
    ) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(
            f'{name}: expected {{"vertices": [[x, y, z], ...], "faces": [[a, b, c, d], ...]}} or a '
            "mesh of COMPAS; export again"
        ) from None
    if vertices.ndim != 2 or vertices.shape[1] != 3 or not found[1]:
        raise InputError(f"{name}: expected vertices of three coordinates and at least one face")
    border = _border(data.get("border", []), name) if isinstance(data, dict) else ()
    named = unit_named(unit) if isinstance(unit, str) else None
    return ObjData(vertices, found[1], named, border=border)


def _border(data: object, name: str) -> tuple[FloatArray, ...]:
    """Closed polylines (N, 3) from lists of points.

    Raises:
        InputError: anything else.
    """
    try:
        if not isinstance(data, list):
            raise TypeError
        lines = tuple(np.array(line, dtype=np.float64) for line in data)
        good = all(line.ndim == 2 and line.shape[1] == 3 and len(line) > 2 for line in lines)
        if not (good and all(np.isfinite(line).all() for line in lines)):
            raise ValueError
    except (TypeError, ValueError, OverflowError):
        raise InputError(
            f"{name}: border: expected closed polylines [[[x, y, z], ...], ...] of three points or "
            "more; mend it or leave it out"
        ) from None
    return lines


def _whole(corner: object) -> int:
    if not isinstance(corner, int) or isinstance(corner, bool):
        raise TypeError
    return corner


def write_json(
    path: str | os.PathLike[str],
    mesh: QuadMesh,
    unit: str | None = None,
    border: Sequence[FloatArray] = (),
) -> None:
    """Write a mesh with every digit, whole or not at all.

    Args:
        path: of the file.
        mesh: the mesh.
        unit: of its coordinates.
        border: closed polylines (N, 3) along which parts on the mesh are trimmed.

    Raises:
        OutputError: the folder is missing or cannot be written.
    """
    data: dict[str, object] = {} if unit is None else {"unit": unit}
    data |= {"vertices": mesh.vertices.tolist(), "faces": mesh.connectivity.polygons}
    if border:
        data["border"] = [line.tolist() for line in border]
    write_text(path, json.dumps(data) + "\n")
