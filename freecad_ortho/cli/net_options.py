"""Options of ``optimise`` that say which net, what is held where, and what it carries."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

import numpy as np

from freecad_ortho import api
from freecad_ortho.triangles import read_triangles
from solver import Constraints, InputError, NetOptions
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.nets.constraints import (
    BoundaryGlide,
    CurveGlide,
    Glide,
    PlaneGlide,
    SurfaceGlide,
)

_AXES = "xyz"


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


def settings(options: argparse.Namespace, mesh: QuadMesh) -> dict[str, Any]:
    """Turn parsed options into keyword arguments of ``api.optimise`` for a mesh."""
    forces = "compression" if options.compression else "tension" if options.tension else "free"
    reference = None
    if options.reference:
        reference = _reference(options.reference, mesh)
    fix = options.fix
    if options.net == "stress":
        fix = options.supports or (fix if fix != "none" else "boundary")
    elif options.supports:
        raise InputError("supports: only stress nets have them; use --fix for other nets")
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
        "constraints": _constraints(options),
    }


def _reference(path: str, mesh: QuadMesh) -> FloatArray:
    """Positions of the reference mesh, whose faces must be those of the mesh."""
    other = api.read_mesh(path).mesh
    if other.vertices.shape != mesh.vertices.shape or not np.array_equal(other.faces, mesh.faces):
        raise InputError(
            f"{path}: has other vertices or faces than the mesh ({len(other.vertices)} and "
            f"{len(other.faces)}, not {len(mesh.vertices)} and {len(mesh.faces)}, or in another "
            "order); give the same mesh in another shape"
        )
    return other.vertices


def _constraints(options: argparse.Namespace) -> Constraints | None:
    handles = dict(_handle(text) for text in options.handle)
    glide = tuple(_glide(text) for text in options.glide)
    near = None
    if options.close_to:
        near = _surface(options.close_to)
    symmetry = options.symmetry.replace(",", "").replace(" ", "").lower()
    if not (handles or glide or near or symmetry):
        return None
    return Constraints(handles=handles, glide=glide, close_to=near, symmetry=symmetry)


def _handle(text: str) -> tuple[int, FloatArray]:
    try:
        vertex, place = text.split(":")
        x, y, z = (float(word) for word in place.split(","))
        return int(vertex), np.array([x, y, z])
    except ValueError:
        raise InputError(f"handle: expected I:x,y,z such as 12:0,0,3.5, got '{text}'") from None


def _glide(text: str) -> Glide:
    what, _, named = text.partition("@")
    kind, _, where = what.partition(":")
    vertices = _numbers(named) if named else None
    if kind == "boundary" and not where:
        return BoundaryGlide()
    if kind == "plane" and where[:2] in ("x=", "y=", "z="):
        try:
            return PlaneGlide(_AXES.index(where[0]), float(where[2:]), vertices)
        except ValueError:
            pass
    if kind == "curve" and where:
        points, closed = _curve(where)
        return CurveGlide(points, closed, vertices)
    if kind == "surface" and where:
        return SurfaceGlide(*_surface(where), vertices)
    raise InputError(
        f"glide: expected boundary, plane:z=0, curve:FILE or surface:FILE, got '{text}'"
    )


def _numbers(text: str) -> np.ndarray:
    try:
        return np.array([int(word) for word in text.split(",")], dtype=np.int64)
    except ValueError:
        raise InputError(f"glide: expected vertex numbers after @, got '{text}'") from None


def _surface(path: str) -> tuple[FloatArray, np.ndarray]:
    """Points and triangles of a surface's file."""
    points, triangles, _ = read_triangles(path)
    return points, triangles


def _curve(path: str) -> tuple[FloatArray, bool]:
    """Points of a text file, one ``x y z`` (or ``v x y z``) a line; closed where first is last."""
    try:
        lines = Path(path).read_text(encoding="utf-8").replace(",", " ").splitlines()
    except (OSError, UnicodeDecodeError):
        raise InputError(f"{path}: cannot be read; give a text file of points") from None
    points = []
    for number, line in enumerate(lines, start=1):
        words = line.split()
        if words[:1] == ["v"]:
            words = words[1:]
        elif not words or not (words[0][0].isdigit() or words[0][0] in "+-."):
            continue
        try:
            x, y, z = (float(word) for word in words[:3])
        except ValueError:
            raise InputError(
                f"{path}, line {number}: expected 'x y z', got '{line[:40]}'"
            ) from None
        points.append([x, y, z])
    if len(points) < 2:
        raise InputError(f"{path}: a curve needs at least two points, found {len(points)}")
    curve = np.array(points)
    closed = len(curve) > 3 and bool(np.allclose(curve[0], curve[-1]))
    return (curve[:-1] if closed else curve), closed
