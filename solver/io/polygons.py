"""Quad meshes from files and into files, by the file's extension."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from pathlib import Path

from solver.errors import InputError
from solver.io.json_mesh import read_json, write_json
from solver.io.obj import ObjData, read_obj, write_obj
from solver.io.off import read_off, write_off
from solver.io.ply import read_ply, write_ply
from solver.mesh.intake import any_mesh, quad_mesh
from solver.mesh.quadmesh import FloatArray, QuadMesh

READERS: dict[str, Callable[[str | os.PathLike[str]], ObjData]] = {
    ".obj": read_obj,
    ".ply": read_ply,
    ".off": read_off,
    ".json": read_json,
}
WRITERS: dict[str, Callable[[str | os.PathLike[str], QuadMesh, str | None], None]] = {
    ".obj": write_obj,
    ".ply": write_ply,
    ".off": write_off,
    ".json": write_json,
}


def read_polygons(path: str | os.PathLike[str]) -> ObjData:
    """Read vertices, polygons and unit of an OBJ, PLY, OFF or JSON file; others count as OBJ.

    Raises:
        InputError: no such file, a format for triangles, or a file that cannot be understood.
    """
    extension = Path(path).suffix.lower()
    if extension in (".stl", ".glb", ".gltf", ".3mf", ".3ds"):
        raise InputError(
            f"{os.fspath(path)}: {extension} holds triangles only; export quads as OBJ, PLY or "
            "OFF, or make quads of them ('quads', in FreeCAD 'Quads from triangles')"
        )
    return READERS.get(extension, read_obj)(path)


def quads_of(
    data: ObjData, path: str | os.PathLike[str], mixed: bool = False
) -> tuple[QuadMesh, list[str]]:
    """Make the contents of a file a quad mesh, as :func:`solver.mesh.intake.quad_mesh` does.

    Args:
        data: what was read.
        path: of the file.
        mixed: faces may have any number of corners.

    Raises:
        InputError: naming the file, and the line where that is known.
    """
    try:
        make = any_mesh if mixed else quad_mesh
        mesh, remarks = make(data.vertices, data.polygons, data.lines)
    except InputError as error:
        raise InputError(f"{os.fspath(path)}: {error}") from None
    return mesh, [*data.remarks, *remarks]


def read_mesh(path: str | os.PathLike[str], mixed: bool = False) -> QuadMesh:
    """Read the quad mesh of an OBJ, PLY, OFF or JSON file, in the file's own unit.

    What was mended on the way is said by :func:`quads_of` alone.

    Args:
        path: of the file.
        mixed: faces may have any number of corners; such a mesh is for the net planar, panels and
            beams.

    Raises:
        InputError: no such file, or it holds no usable mesh.
    """
    return quads_of(read_polygons(path), path, mixed)[0]


def write_mesh(
    path: str | os.PathLike[str],
    mesh: QuadMesh,
    unit: str | None = None,
    border: Sequence[FloatArray] = (),
) -> None:
    """Write an OBJ, PLY, OFF or JSON file that keeps vertex and face order and every digit.

    Args:
        path: of the file.
        mesh: the mesh.
        unit: of its coordinates.
        border: closed polylines (N, 3) along which parts on the mesh are trimmed; only a JSON file
            keeps them, see :func:`keeps_border`.

    Raises:
        InputError: the name ends in none of ``.obj``, ``.ply``, ``.off`` and ``.json``.
        OutputError: the folder is missing or cannot be written.
    """
    refuse_unknown_extension(path)
    if keeps_border(path):
        write_json(path, mesh, unit, border)
    else:
        WRITERS[Path(path).suffix.lower()](path, mesh, unit)


def keeps_border(path: str | os.PathLike[str]) -> bool:
    """Whether a file of this name has room for the border of a mesh."""
    return Path(path).suffix.lower() == ".json"


def refuse_unknown_extension(path: str | os.PathLike[str]) -> None:
    """Refuse a file to write whose name says no format.

    Raises:
        InputError: naming the extensions there are.
    """
    if Path(path).suffix.lower() not in WRITERS:
        raise InputError(
            f"{os.fspath(path)}: expected a name that ends in {', '.join(WRITERS)}, "
            f"got '{Path(path).suffix}'; end it in one of these"
        )
