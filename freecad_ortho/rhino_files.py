"""3DM files of Rhino through the library rhino3dm, where it is there; needs no FreeCAD."""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from freecad_ortho.file_libraries import FileLibrary
from solver.errors import InputError
from solver.io.obj import ObjData
from solver.mesh.quadmesh import FloatArray

ENDINGS = (".3dm",)
_UNITS = {"Millimeters": "mm", "Centimeters": "cm", "Meters": "m", "Inches": "in", "Feet": "ft"}
_NO_UNIT = ("None", "Unset", "CustomUnits")
_LIBRARY = FileLibrary("rhino3dm", "rhino3dm", "3DM", "OBJ")
# Points for each span of a curve that is no polyline, and at most so many.
_STEPS, _MOST = 64, 4096


class RhinoReader:
    """Calls of the library; for :class:`solver.isolated.Isolated`, as bad files may crash it."""

    def polygons(self, path: str) -> tuple[list[list[float]], list[list[int]], str, int]:
        """Points and corners of the faces of all meshes, the unit, and how many meshes there are.

        Of surfaces by subdivision it is the mesh that controls them.

        Raises:
            ValueError: the file cannot be read.
        """
        import rhino3dm

        model = self._model(path)
        points: list[list[float]] = []
        faces: list[list[int]] = []
        meshes = [each.Geometry for each in model.Objects]
        cages = [each for each in meshes if isinstance(each, rhino3dm.SubD)]
        meshes = [each for each in meshes if isinstance(each, rhino3dm.Mesh)]
        meshes += [rhino3dm.Mesh.CreateFromSubDControlNet(cage) for cage in cages]
        for mesh in meshes:
            base = len(points)
            points += [[place.X, place.Y, place.Z] for place in mesh.Vertices.ToPoint3dArray()]
            for number in range(len(mesh.Faces)):
                a, b, c, d = mesh.Faces[number]
                # A triangle has its last corner twice.
                faces.append([base + corner for corner in ((a, b, c) if c == d else (a, b, c, d))])
        return points, faces, _unit_of(model), len(meshes)

    def curves(self, path: str) -> tuple[list[list[list[float]]], str]:
        """Points along all curves, and the unit.

        Raises:
            ValueError: the file cannot be read.
        """
        import rhino3dm

        model = self._model(path)
        shapes = [each.Geometry for each in model.Objects]
        found = []
        for curve in (each for each in shapes if isinstance(each, rhino3dm.Curve)):
            corners = curve.TryGetPolyline()
            if corners is not None:
                line = [corners[number] for number in range(len(corners))]
            else:
                domain = curve.Domain
                steps = min(_STEPS * max(curve.SpanCount, 1), _MOST)
                at = np.linspace(domain.T0, domain.T1, steps + 1)
                line = [curve.PointAt(place) for place in at.tolist()]
            found.append([[point.X, point.Y, point.Z] for point in line])
        return found, _unit_of(model)

    def _model(self, path: str) -> Any:
        import rhino3dm

        model = rhino3dm.File3dm.Read(path)
        if model is None:
            raise ValueError("no 3DM file, or damaged")
        return model


def _unit_of(model: Any) -> str:
    return str(model.Settings.ModelUnitSystem).rpartition(".")[2]


def read_3dm(path: str | os.PathLike[str]) -> ObjData:
    """Read the meshes of a 3DM file, with the cages of its surfaces by subdivision, and its unit.

    Raises:
        InputError: no such file, the library missing, or no mesh in it.
    """
    name = os.fspath(path)
    points, faces, unit, count = _LIBRARY.call(RhinoReader, "polygons", name)
    if not faces:
        raise InputError(f"{name}: has no mesh in it; make one of its surfaces (_QuadRemesh)")
    said = (f"{count} meshes of the file are taken as one",) if count > 1 else ()
    known = None if unit in _NO_UNIT else _UNITS.get(unit, unit)
    return ObjData(np.array(points, dtype=np.float64), faces, known, remarks=said)


def read_3dm_curves(path: str | os.PathLike[str]) -> tuple[list[FloatArray], str | None]:
    """Read the curves of a 3DM file as polylines (n, 3), and its unit, None where it names none.

    Raises:
        InputError: no such file, the library missing, or no curve in it.
    """
    name = os.fspath(path)
    lines, unit = _LIBRARY.call(RhinoReader, "curves", name)
    if not lines:
        raise InputError(f"{name}: has no curve in it; draw one, or give a list of points")
    known = None if unit in _NO_UNIT else _UNITS.get(unit, unit)
    return [np.array(line, dtype=np.float64) for line in lines], known
