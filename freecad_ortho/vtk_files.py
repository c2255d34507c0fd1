"""VTK files through the library of that name, which comes with cadquery; needs no FreeCAD."""

from __future__ import annotations

import os

import numpy as np

from freecad_ortho.file_libraries import FileLibrary
from solver.errors import InputError
from solver.io.obj import ObjData

ENDINGS = (".vtk", ".vtp", ".vtu", ".vts")
# Cells by their VTK number: what stands for polygons, and what no surface has.
_PIXEL, _POLYGONS, _NOTHING = 8, (5, 7, 9), (0, 1, 2, 3, 4)
_LIBRARY = FileLibrary("vtkmodules", "vtk", "VTK", "OBJ or PLY", ", it comes with cadquery")


class VtkReader:
    """Calls of the library; for :class:`solver.isolated.Isolated`, as bad files may crash it."""

    def polygons(self, path: str) -> tuple[list[list[float]], list[list[int]]]:
        """Points, and corners of the faces; lines and vertices are passed over.

        Raises:
            ValueError: the file cannot be read, or has cells that are no faces.
        """
        from vtkmodules.vtkIOLegacy import vtkDataSetReader
        from vtkmodules.vtkIOXML import vtkXMLGenericDataObjectReader

        legacy = path.lower().endswith(".vtk")
        reader = vtkDataSetReader() if legacy else vtkXMLGenericDataObjectReader()
        reader.SetFileName(path)
        reader.Update()
        grid = reader.GetOutput()
        if grid is None or not hasattr(grid, "GetCell") or not grid.GetNumberOfCells():
            raise ValueError("no mesh in it, or damaged")
        points = [list(grid.GetPoint(k)) for k in range(grid.GetNumberOfPoints())]
        faces = []
        for k in range(grid.GetNumberOfCells()):
            kind, ids = grid.GetCellType(k), grid.GetCell(k).GetPointIds()
            corners = [ids.GetId(j) for j in range(ids.GetNumberOfIds())]
            if kind == _PIXEL:
                faces.append([corners[j] for j in (0, 1, 3, 2)])
            elif kind in _POLYGONS:
                faces.append(corners)
            elif kind not in _NOTHING:
                raise ValueError(f"cell {k} is no face but of VTK's kind {kind}: take its surface")
        return points, faces


def read_vtk(path: str | os.PathLike[str]) -> ObjData:
    """Read the faces of a VTK file, legacy or XML: polygons or a grid of faces.

    Raises:
        InputError: no such file, the library missing, or nothing with faces in it.
    """
    name = os.fspath(path)
    points, faces = _LIBRARY.call(VtkReader, "polygons", name)
    if not points or not faces:
        raise InputError(f"{name}: has no vertices or no faces; export the mesh's faces")
    return ObjData(np.array(points, dtype=np.float64), faces, None)
