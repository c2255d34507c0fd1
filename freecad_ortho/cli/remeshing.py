"""The command ``quads``: a triangle mesh remeshed to quads."""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np

from freecad_ortho import api
from freecad_ortho.cli import values
from freecad_ortho.units import millimetres_per
from solver.errors import InputError
from solver.io.polygons import READERS, read_polygons
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray
from solver.mesh.remesh import quads_from_triangles


def add(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.description = (
        "Quads with few irregular vertices, on the surface and with border and corners kept; needs "
        "the library pyQuadriFlow."
    )
    parser.add_argument("input", metavar="IN.stl|obj|ply|off|glb")
    parser.add_argument("--faces", type=int, metavar="N", help="wanted number of quads")
    parser.add_argument("--edge", type=float, metavar="L", help="wanted edge length instead")
    parser.add_argument("--corner", type=float, default=40.0, metavar="DEG", help="kept from here")
    parser.add_argument(
        "--seed", type=int, default=0, metavar="K", help="another gives another net"
    )
    parser.add_argument("--time-limit", type=float, default=60.0, metavar="S")
    values.add_output(parser)
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Remesh and write."""
    values.refuse_unwritable(options.output)
    vertices, triangles, unit = read_triangles(options.input)
    unit = options.unit or unit or api.DEFAULT_UNIT
    millimetres_per(unit)
    made = quads_from_triangles(
        vertices,
        triangles,
        faces=options.faces,
        edge=options.edge,
        seed=options.seed,
        time_limit=options.time_limit,
        corner=options.corner,
    )
    words = (
        f"{len(made.irregular)} irregular vertices, mean edge {made.mesh.mean_edge:.4g} {unit}, "
        f"border within {made.border_gap:.2g} {unit}"
    )
    return values.write(options.output, made.mesh, unit, words)


def read_triangles(path: str) -> tuple[FloatArray, IntArray, str | None]:
    """Vertices (V, 3), triangles (T, 3) and unit of a file; larger faces are cut into fans.

    OBJ, PLY, OFF and JSON are read here, STL, GLB and others through trimesh.

    Raises:
        InputError: no such file, trimesh missing, or nothing with triangles in it.
    """
    if Path(path).suffix.lower() in READERS:
        data = read_polygons(path)
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
        mesh = trimesh.load(path, force="mesh")
        return np.asarray(mesh.vertices, dtype=float), np.asarray(mesh.faces, dtype=np.int64), None
    except Exception as error:  # trimesh raises whatever its many readers raise
        reason = (str(error).splitlines() or ["damaged"])[0][:80]
        raise InputError(f"{path}: cannot be read ({reason}); export OBJ or PLY") from None
