"""Mesh files as everything here reads them: any format, with z up."""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

import numpy as np

from freecad_ortho.rhino_files import ENDINGS as RHINO_ENDINGS
from freecad_ortho.rhino_files import read_3dm
from freecad_ortho.units import MILLIMETRES, millimetres_per
from freecad_ortho.vtk_files import ENDINGS as VTK_ENDINGS
from freecad_ortho.vtk_files import read_vtk
from solver.errors import InputError
from solver.io.obj import ObjData
from solver.io.polygons import READERS, quads_of, read_polygons
from solver.mesh.local_origin import LocalOrigin
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.option import one_of

# Which axis points up in a file; here it is z.
UP = ("z", "y")
DEFAULT_UNIT = "mm"
# A mesh without a unit that is smaller than this in mm may well be in metres.
_SMALL = 100.0
# Files that a library of their own reads.
_BY_LIBRARY = {**dict.fromkeys(VTK_ENDINGS, read_vtk), **dict.fromkeys(RHINO_ENDINGS, read_3dm)}
ENDINGS = (*READERS, *_BY_LIBRARY)


def read_mesh_file(path: str | os.PathLike[str], up: str = "z") -> ObjData:
    """Read vertices, polygons and unit of a file.

    Args:
        path: an OBJ, PLY, OFF, JSON, VTK or 3DM file; others count as OBJ.
        up: ``z``, or ``y`` for a file whose y points up: it is turned about x.

    Raises:
        InputError: no such file, a format for triangles, or a file that cannot be understood.
    """
    data = _BY_LIBRARY.get(Path(path).suffix.lower(), read_polygons)(path)
    border = tuple(upright(line, up) for line in data.border)
    return replace(data, vertices=upright(data.vertices, up), border=border)


def upright(points: FloatArray, up: str) -> FloatArray:
    """(n, 3) points turned so that z is up.

    Raises:
        InputError: another axis than y or z.
    """
    one_of("up", up, UP)
    if up == "z":
        return points
    x, y, z = points.T
    return np.stack([x, -z, y], axis=1)


@dataclass(frozen=True)
class ReadMesh:
    """A mesh from a file.

    Attributes:
        mesh: positions in the file's unit.
        unit: mm, cm, m, in or ft.
        remarks: what was mended or is unusual, in plain words.
        border: closed polylines (N, 3) along which parts on it are trimmed, in the file's unit.
    """

    mesh: QuadMesh
    unit: str
    remarks: tuple[str, ...]
    border: tuple[FloatArray, ...] = ()

    @cached_property
    def origin(self) -> LocalOrigin:
        """Point near the mesh where it is far from the origin, in the file's unit."""
        return LocalOrigin.of_mesh(self.mesh)

    @cached_property
    def near(self) -> QuadMesh:
        """The mesh about that point; the mesh itself where it is not far."""
        return self.origin.near_mesh(self.mesh)

    @property
    def near_border(self) -> tuple[FloatArray, ...]:
        """The border about the same point."""
        return tuple(self.origin.near(line) for line in self.border)


def read_mesh(
    path: str | os.PathLike[str], unit: str | None = None, up: str = "z", mixed: bool = False
) -> ReadMesh:
    """Read a quad mesh; its unit is the one given, else the one the file names, else mm.

    Args:
        path: an OBJ, PLY, OFF, JSON, VTK or 3DM file.
        unit: of its coordinates.
        up: ``z``, or ``y`` for a file whose y points up: it is turned about x.
        mixed: faces may have any number of corners; such a mesh is for the net planar, panels and
            beams.

    Raises:
        InputError: the file is missing or is not a usable mesh.
    """
    data = read_mesh_file(path, up)
    if not unit and data.unit and data.unit not in MILLIMETRES:
        where = f", line {data.unit_line}" if data.unit_line else ""
        raise InputError(
            f"{os.fspath(path)}{where}: the unit '{data.unit}' is not known; say it as one of "
            f"{', '.join(MILLIMETRES)}"
        )
    chosen = unit or data.unit or DEFAULT_UNIT
    millimetres_per(chosen)
    mesh, remarks = quads_of(data, path, mixed)
    width = float(np.ptp(mesh.vertices[mesh.connectivity.referenced], axis=0).max())
    if not (unit or data.unit) and width < _SMALL:
        remarks.append(
            f"no unit is said, taken as mm: the mesh is {width:.2g} mm wide; if that is wrong say "
            "the unit (--unit m, or unit of imported meshes in FreeCAD's preferences)"
        )
    return ReadMesh(mesh, chosen, tuple(remarks), data.border)
