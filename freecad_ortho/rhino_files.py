"""3DM files of Rhino through the library rhino3dm, where it is there; needs no FreeCAD."""

from __future__ import annotations

import os
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from solver.errors import InputError
from solver.io.obj import ObjData
from solver.isolated import Isolated, LibraryError

ENDINGS = (".3dm",)
_UNITS = {"Millimeters": "mm", "Centimeters": "cm", "Meters": "m", "Inches": "in", "Feet": "ft"}
_NO_UNIT = ("None", "Unset", "CustomUnits")
_SECONDS = 120.0


class RhinoReader:
    """Calls of the library; for :class:`solver.isolated.Isolated`, as bad files may crash it."""

    def polygons(self, path: str) -> tuple[list[list[float]], list[list[int]], str, int]:
        """Points and corners of the faces of all meshes, the unit, and how many meshes there are.

        Raises:
            ValueError: the file cannot be read.
        """
        import rhino3dm

        model: Any = rhino3dm.File3dm.Read(path)
        if model is None:
            raise ValueError("no 3DM file, or damaged")
        points: list[list[float]] = []
        faces: list[list[int]] = []
        meshes = [each.Geometry for each in model.Objects]
        meshes = [each for each in meshes if isinstance(each, rhino3dm.Mesh)]
        for mesh in meshes:
            base = len(points)
            points += [[place.X, place.Y, place.Z] for place in mesh.Vertices.ToPoint3dArray()]
            for number in range(len(mesh.Faces)):
                a, b, c, d = mesh.Faces[number]
                # A triangle has its last corner twice.
                faces.append([base + corner for corner in ((a, b, c) if c == d else (a, b, c, d))])
        return points, faces, str(model.Settings.ModelUnitSystem).rpartition(".")[2], len(meshes)


def read_3dm(path: str | os.PathLike[str]) -> ObjData:
    """Read the meshes of a 3DM file, and its unit.

    Raises:
        InputError: no such file, the library missing, or no mesh in it.
    """
    name = os.fspath(path)
    if not Path(name).is_file():
        raise InputError(f"{name}: no such file; check the path")
    if find_spec("rhino3dm") is None:
        raise InputError(
            f"{name}: reading 3DM files needs the package 'rhino3dm'; install it ('pip install "
            "rhino3dm') or export OBJ"
        )
    with Isolated(RhinoReader) as library:
        try:
            found = library.call("polygons", os.path.abspath(name), time_limit=_SECONDS)
        except LibraryError as error:
            raise InputError(f"{name}: cannot be read ({error}); export OBJ") from None
    points, faces, unit, count = found
    if not faces:
        raise InputError(f"{name}: has no mesh in it; make one of its surfaces (_QuadRemesh)")
    said = (f"{count} meshes of the file are taken as one",) if count > 1 else ()
    known = None if unit in _NO_UNIT else _UNITS.get(unit, unit)
    return ObjData(np.array(points, dtype=np.float64), faces, known, remarks=said)
