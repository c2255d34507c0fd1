"""Triangle meshes from files: surfaces to remesh, to glide on or to stay close to."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np

from freecad_ortho.mesh_files import ENDINGS, read_mesh_file, upright
from freecad_ortho.step_faces import is_step, triangles_from_step
from solver.errors import InputError
from solver.mesh.connectivity import IntArray
from solver.mesh.intake import refuse_missing_vertices
from solver.mesh.quadmesh import FloatArray


def read_triangles(
    path: str | os.PathLike[str], up: str = "z"
) -> tuple[FloatArray, IntArray, str | None]:
    """Vertices (V, 3), triangles (T, 3) and unit of a file; larger faces are cut into fans.

    OBJ, PLY, OFF, JSON and VTK are read here, STEP through cadquery, in mm, STL, GLB and others
    through trimesh.

    Args:
        path: the file.
        up: ``z``, or ``y`` for a file whose y points up.

    Raises:
        InputError: no such file, trimesh missing, or nothing with triangles in it.
    """
    if is_step(path):
        points, triangles = triangles_from_step(path)
        return upright(points, up), triangles, "mm"
    if Path(path).suffix.lower() in ENDINGS:
        data = read_mesh_file(path, up)
        try:
            refuse_missing_vertices(data.polygons, len(data.vertices), data.lines)
        except InputError as error:
            raise InputError(f"{path}: {error}") from None
        fans = [(p[0], p[k], p[k + 1]) for p in data.polygons for k in range(1, len(p) - 1)]
        return data.vertices, np.array(fans, dtype=np.int64).reshape(-1, 3), data.unit
    if not Path(path).is_file():
        raise InputError(f"{path}: no such file; check the path")
    try:
        import trimesh
    except ImportError:
        raise InputError(
            f"{path}: reading this format needs trimesh; install it or export OBJ or PLY"
        ) from None
    try:
        mesh: Any = trimesh.load(os.fspath(path), force="mesh")
        vertices, faces = np.asarray(mesh.vertices, dtype=np.float64), np.asarray(mesh.faces)
    except Exception as error:  # trimesh raises whatever its many readers raise
        reason = (str(error).splitlines() or ["damaged"])[0][:80]
        raise InputError(f"{path}: cannot be read ({reason}); export OBJ or PLY") from None
    if not faces.size:
        raise InputError(f"{path}: has no triangles; it may be cut off: export it again")
    return upright(vertices.reshape(-1, 3), up), faces.astype(np.int64).reshape(-1, 3), None
