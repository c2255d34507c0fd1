"""Mesh files as everything here reads them: any format, with z up."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path

import numpy as np

from freecad_ortho.vtk_files import ENDINGS as VTK_ENDINGS
from freecad_ortho.vtk_files import read_vtk
from solver.errors import InputError
from solver.io.obj import ObjData
from solver.io.polygons import READERS, read_polygons
from solver.mesh.quadmesh import FloatArray

# Which axis points up in a file; here it is z.
UP = ("z", "y")
ENDINGS = (*READERS, *VTK_ENDINGS)


def read_mesh_file(path: str | os.PathLike[str], up: str = "z") -> ObjData:
    """Read vertices, polygons and unit of a file.

    Args:
        path: an OBJ, PLY, OFF, JSON or VTK file; others count as OBJ.
        up: ``z``, or ``y`` for a file whose y points up: it is turned about x.

    Raises:
        InputError: no such file, a format for triangles, or a file that cannot be understood.
    """
    reader = read_vtk if Path(path).suffix.lower() in VTK_ENDINGS else read_polygons
    data = reader(path)
    return replace(data, vertices=upright(data.vertices, up))


def upright(points: FloatArray, up: str) -> FloatArray:
    """(n, 3) points turned so that z is up.

    Raises:
        InputError: another axis than y or z.
    """
    if up not in UP:
        raise InputError(f"up: expected {' or '.join(UP)}, got '{up}'")
    if up == "z":
        return points
    x, y, z = points.T
    return np.stack([x, -z, y], axis=1)
