"""Options of ``optimise`` that say which net, what is held where, and what it carries."""

from __future__ import annotations

import argparse
import re
from typing import Any

import numpy as np

from freecad_ortho import api
from freecad_ortho.cli import values
from freecad_ortho.mesh_files import read_mesh_file, upright
from freecad_ortho.triangles import read_triangles
from freecad_ortho.units import millimetres_per
from solver import Constraints, InputError, NetOptions
from solver.io.points import read_points
from solver.io.polygons import quads_of
from solver.mesh.mirror import size_of
from solver.mesh.quadmesh import FloatArray
from solver.nets.constraints import (
    BoundaryGlide,
    CurveGlide,
    Glide,
    PlaneGlide,
    SurfaceGlide,
)

_AXES = "xyz"
_CHEBYSHEV = ("chebyshev", "geodesic-chebyshev")
# Nets that have an option, and what it is where it was not given.
_ONLY: dict[str, tuple[tuple[str, ...], object]] = {
    "diagonal": (("geodesic", "dog", "asymptotic", "cmc", "snet", "geodesic-chebyshev"), False),
    "radius": (("cmc",), None),
    "length": (_CHEBYSHEV, None),
    "per_family": (_CHEBYSHEV, False),
    "angle": (("orthogonal",), 90.0),
    "reference": (("isometric",), None),
    "load": (("stress",), 0.0),
    "load_area": (("stress",), 0.0),
    "load_length": (("stress",), 0.0),
    "supports": (("stress",), None),
    "compression": (("stress",), False),
    "tension": (("stress",), False),
}
# The end of a --glide that names vertices; a path may have an @ of its own.
_VERTICES = re.compile(r"@([\d,]+)$")
# Curves whose ends are nearer than this part of their size are closed.
_CLOSED = 1e-6


def add(parser: argparse.ArgumentParser) -> None:
    """Add the options; lengths are in the unit of the mesh file."""
    parser.add_argument("--multi", type=float, metavar="W", help="weight of the multi-net guide")
    parser.add_argument("--isometry", type=float, metavar="W", help="weight of faces' own shape")
    parser.add_argument("--diagonal", action="store_true", help="star terms on the diagonal net")
    parser.add_argument("--radius", type=float, metavar="R", help="cmc: radius (default: free)")
    parser.add_argument("--length", type=float, metavar="L", help="chebyshev: edge length")
    parser.add_argument("--per-family", action="store_true", help="chebyshev: a length a family")
    parser.add_argument(
        "--angle", type=float, default=90.0, metavar="DEG", help="orthogonal: angle"
    )
    parser.add_argument("--reference", metavar="FILE", help="isometric: the mesh in its own shape")
    parser.add_argument("--load", type=float, default=0.0, help="stress: load of a vertex")
    parser.add_argument("--load-area", type=float, default=0.0, help="stress: load of unit area")
    parser.add_argument("--load-length", type=float, default=0.0, help="stress: weight of edges")
    parser.add_argument("--supports", metavar="boundary|corners|I,J", help="stress: what is held")
    forces = parser.add_mutually_exclusive_group()
    forces.add_argument("--compression", action="store_true", help="stress: no tension")
    forces.add_argument("--tension", action="store_true", help="stress: no compression")
    parser.add_argument(
        "--handle", action="append", default=[], metavar="I:x,y,z", help="drag vertex I there"
    )
    parser.add_argument(
        "--glide",
        action="append",
        default=[],
        metavar="boundary|plane:z=0|curve:FILE|surface:FILE",
        help="what boundary vertices (all, for a surface) move along; @I,J names others",
    )
    parser.add_argument("--close-to", metavar="FILE", help="a surface to stay near")
    parser.add_argument("--symmetry", default="", metavar="x,y", help="mirror planes")


def settings(options: argparse.Namespace, loaded: api.LoadedMesh) -> dict[str, Any]:
    """Turn parsed options into keyword arguments of ``api.optimise`` for a mesh near its origin.

    Raises:
        InputError: an option that the net does not have, or one that cannot be used.
    """
    for name, (nets, default) in _ONLY.items():
        if getattr(options, name) != default and options.net not in nets:
            raise InputError(
                f"--{name.replace('_', '-')}: only {', '.join(nets)} nets have it, not "
                f"{options.net}; leave it out"
            )
    forces = "compression" if options.compression else "tension" if options.tension else "free"
    reference = None
    if options.reference:
        reference = _reference(options.reference, options.up, loaded)
    fix = options.fix
    if options.supports and fix != "none":
        raise InputError("--supports: what does not move is supported; give --fix or --supports")
    if options.net == "stress":
        fix = options.supports or (fix if fix != "none" else "boundary")
    return {
        "fix": fix,
        "multi": options.multi,
        "isometry": options.isometry,
        "options": NetOptions(
            diagonal=options.diagonal,
            radius=options.radius,
            length=options.length,
            per_family=options.per_family,
            angle=options.angle,
            reference=reference,
            load=options.load,
            load_area=options.load_area,
            load_length=options.load_length,
            forces=forces,
        ),
        "constraints": _constraints(options, loaded),
    }


def _reference(path: str, up: str, loaded: api.LoadedMesh) -> FloatArray:
    """Positions of the reference mesh, whose faces must be those of the mesh."""
    data, mesh = read_mesh_file(path, up), loaded.mesh
    other, _ = quads_of(data, path)
    if other.vertices.shape != mesh.vertices.shape or not np.array_equal(other.faces, mesh.faces):
        raise InputError(
            f"{path}: has other vertices or faces than the mesh ({len(other.vertices)} and "
            f"{len(other.faces)}, not {len(mesh.vertices)} and {len(mesh.faces)}, or in another "
            "order); give the same mesh in another shape"
        )
    return _in_unit(other.vertices, data.unit, loaded.unit)


def _in_unit(points: FloatArray, named: str | None, wanted: str) -> FloatArray:
    """Points of a file that names its unit, in another; others are taken for it already."""
    return points if named is None else points * (millimetres_per(named) / millimetres_per(wanted))


def _constraints(options: argparse.Namespace, loaded: api.LoadedMesh) -> Constraints | None:
    """What the options hold, about the local origin of the mesh."""
    unit = loaded.unit
    handles = dict(_handle(text) for text in options.handle)
    glide = tuple(_glide(text, unit, options.up) for text in options.glide)
    near = None
    if options.close_to:
        near = _surface(options.close_to, unit, options.up)
    symmetry = options.symmetry.replace(",", "").replace(" ", "").lower()
    if not (handles or glide or near or symmetry):
        return None
    wanted = Constraints(handles=handles, glide=glide, close_to=near, symmetry=symmetry)
    return wanted.about(loaded.origin)


def _handle(text: str) -> tuple[int, FloatArray]:
    try:
        vertex, place = text.split(":")
        x, y, z = (float(word) for word in place.split(","))
        return int(vertex), np.array([x, y, z])
    except ValueError:
        raise InputError(f"handle: expected I:x,y,z such as 12:0,0,3.5, got '{text}'") from None


def _glide(text: str, unit: str, up: str) -> Glide:
    match = _VERTICES.search(text)
    what = text[: match.start()] if match else text
    kind, _, where = what.partition(":")
    vertices = np.array(values.whole_numbers("glide", match[1])) if match else None
    if what == "boundary" and not match:
        return BoundaryGlide()
    if kind == "plane" and where[:2] in ("x=", "y=", "z="):
        (place,) = values.numbers("glide", where[2:], 1)
        return PlaneGlide(_AXES.index(where[0]), place, vertices)
    if kind == "curve" and where:
        points, closed = _curve(where, up)
        return CurveGlide(points, closed, vertices)
    if kind == "surface" and where:
        return SurfaceGlide(*_surface(where, unit, up), vertices)
    raise InputError(
        "glide: expected boundary, plane:z=0, curve:FILE or surface:FILE, and @I,J for some "
        f"vertices only, got '{text}'"
    )


def _surface(path: str, unit: str, up: str) -> tuple[FloatArray, np.ndarray]:
    """Points and triangles of a surface's file."""
    points, triangles, named = read_triangles(path, up)
    return _in_unit(points, named, unit), triangles


def _curve(path: str, up: str) -> tuple[FloatArray, bool]:
    """Points of a file, without the last where it is the first again: then they are closed."""
    curve = upright(read_points(path), up)
    apart = np.abs(curve[-1] - curve[0]).max()
    closed = len(curve) > 3 and bool(apart <= _CLOSED * size_of(curve))
    return (curve[:-1] if closed else curve), closed
