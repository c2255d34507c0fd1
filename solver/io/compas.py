"""Meshes as the framework COMPAS stores them in JSON, in all of its layouts.

Vertices are named by keys and carry coordinates as attributes, which may stand in the defaults. The
mesh itself is the whole file (COMPAS 0), its ``value`` (1) or its ``data`` (2), alone or in a list.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from solver.errors import InputError

# Containers that a mesh is looked for in, and how deep.
_WITHIN, _DEPTH = ("data", "value", "mesh"), 4
_DEFAULTS = ("default_vertex_attributes", "dva")


def compas_mesh(data: object, name: str) -> tuple[list[list[float]], list[list[int]]] | None:
    """Coordinates and faces (numbers from 0, in the order of the file); None: no COMPAS mesh.

    Args:
        data: what the JSON file holds.
        name: of the file, for messages.

    Raises:
        InputError: several meshes, or a face that names a vertex which is not there.
        KeyError, TypeError, ValueError, AttributeError: coordinates that are no numbers.
    """
    found = list(_meshes(data, _DEPTH))
    if not found:
        return None
    if len(found) > 1:
        raise InputError(f"{name}: holds {len(found)} COMPAS meshes; export one a file")
    (mesh,) = found
    defaults: dict[str, Any] = {}
    for key in _DEFAULTS:
        defaults |= mesh.get(key) or {}
    vertices = [
        [float({**defaults, **attributes}[axis]) for axis in "xyz"]
        for attributes in mesh["vertex"].values()
    ]
    number = {str(key): place for place, key in enumerate(mesh["vertex"])}
    faces = []
    for key, corners in mesh["face"].items():
        missing = [corner for corner in corners if str(corner) not in number]
        if missing:
            raise InputError(
                f"{name}: face '{key}' names vertex '{missing[0]}', which is not there; mend the "
                "face or export again"
            )
        faces.append([number[str(corner)] for corner in corners])
    return vertices, faces


def _meshes(data: object, depth: int) -> Iterator[Mapping[str, Any]]:
    """Everything that has vertices and faces by key."""
    if isinstance(data, dict):
        if isinstance(data.get("vertex"), dict) and isinstance(data.get("face"), dict):
            yield data
        elif depth:
            for key in _WITHIN:
                yield from _meshes(data.get(key), depth - 1)
    elif isinstance(data, list) and depth:
        for item in data:
            yield from _meshes(item, depth - 1)
