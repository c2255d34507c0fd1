"""Curves from files: lists of points, or the curves of a 3DM file."""

from __future__ import annotations

import os
from pathlib import Path

from freecad_ortho.mesh_files import upright
from freecad_ortho.rhino_files import ENDINGS, read_3dm_curves
from freecad_ortho.units import MILLIMETRES, millimetres_per
from solver.io.points import read_points
from solver.mesh.quadmesh import FloatArray


def read_curves(path: str | os.PathLike[str], unit: str, up: str = "z") -> list[FloatArray]:
    """Polylines (n, 3) of a file, in a unit.

    Args:
        path: rows of points, which are one curve in that unit already, or a 3DM file, of which all
            curves are taken, in the unit that it names.
        unit: that is wanted.
        up: ``z``, or ``y`` for a file whose y points up.

    Raises:
        InputError: no such file, no curve in it, or one that cannot be understood.
    """
    if Path(path).suffix.lower() not in ENDINGS:
        return [upright(read_points(path), up)]
    lines, own = read_3dm_curves(path)
    scale = 1.0 if own not in MILLIMETRES else millimetres_per(own) / millimetres_per(unit)
    return [scale * upright(line, up) for line in lines]
