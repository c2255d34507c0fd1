"""Options of ``optimise`` that say which net, what is held where, and what it carries."""

from __future__ import annotations

import argparse
import re
from typing import Any

import numpy as np

from freecad_ortho import api
from freecad_ortho.cli import options as arguments
from freecad_ortho.cli import values
from freecad_ortho.mesh_files import read_mesh_file, upright
from freecad_ortho.triangles import read_triangles
from freecad_ortho.units import millimetres_per
from freecad_ortho.written import mirror_planes, place, plane
from solver import Constraints, InputError, NetOptions
from solver.io.points import read_points
from solver.io.polygons import quads_of
from solver.mesh.connectivity import IntArray
from solver.mesh.mirror import size_of
from solver.mesh.quadmesh import FloatArray
from solver.nets import Net, net_named, nets_with, refuse_foreign
from solver.nets.constraints import (
    BoundaryGlide,
    CurveGlide,
    Glide,
    PlaneGlide,
    SurfaceGlide,
)
from solver.nets.options import OPTIONS
from solver.nets.settings import STEPS, WEIGHTS
from solver.nets.supports import SUPPORTS

# Points (V, 3) and triangles (T, 3) of a surface.
Triangles = tuple[FloatArray, IntArray]
# The end of a --glide that names vertices; a path may have an @ of its own.
_VERTICES = re.compile(r"@([\d,]+)$")
# Curves whose ends are nearer than this part of their size are closed.
_CLOSED = 1e-6


def add(parser: argparse._ActionsContainer) -> None:
    """Add the options; lengths are in the unit of the mesh file."""
    add_most(parser)
    parser.add_argument("--symmetry", default="", metavar="x,y", help="mirror planes")


def add_most(parser: argparse._ActionsContainer) -> None:
    """Add the options but mirror planes."""
    parser.add_argument(
        "--fix",
        default="none",
        metavar="none|corners|boundary|I,J,K",
        help="what must not move; several, as boundary,5",
    )
    arguments.add(parser, STEPS)
    for weight in WEIGHTS.values():
        arguments.add(parser, weight)
    for option in OPTIONS.values():
        arguments.add(parser, option, f"{_nets(nets_with(option.name))}: ")
    for word in ("compression", "tension"):
        words = f"the same as --forces {word}"
        parser.add_argument(
            f"--{word}", dest="forces", action="store_const", const=word, help=words
        )
    arguments.add(parser, SUPPORTS, f"{_nets(nets_with(SUPPORTS.name))}: ")
    parser.add_argument(
        "--supports-fixed",
        action="store_true",
        help=f"{_nets(nets_with(SUPPORTS.name))}: supports do not slide",
    )
    parser.add_argument(
        "--handle",
        action="append",
        default=[],
        metavar="I:x,y,z",
        help="drag vertex I there, in the unit of the mesh or one that is named, as 12:0,0,3.5m",
    )
    parser.add_argument(
        "--glide",
        action="append",
        default=[],
        metavar="boundary|z=0|curve:FILE|surface:FILE",
        help="what boundary vertices (all, for a surface) move along; @I,J names others",
    )


def add_close_to(parser: argparse._ActionsContainer) -> None:
    """Add the option that names a surface."""
    parser.add_argument("--close-to", metavar="FILE", help="a surface to stay near")


def refuse_unfit(options: argparse.Namespace) -> Net:
    """Refuse options that the net does not have; return the net.

    Raises:
        InputError: naming the option and the nets that have it, or no such net, or no steps.
    """
    asked = net_named(options.net)
    STEPS.check(arguments.given([STEPS], options).get("max_steps", STEPS.default))
    arguments.given(WEIGHTS.values(), options)
    declared = {**OPTIONS, SUPPORTS.name: SUPPORTS}
    said = arguments.given(declared.values(), options)
    refuse_foreign(asked, said, lambda name: arguments.flag_of(declared[name]))
    if options.supports_fixed:
        refuse_foreign(asked, [SUPPORTS.name], lambda _: "--supports-fixed")
    if options.supports_fixed and options.fix != "none":
        raise InputError(
            "--supports-fixed: what --fix names does not move already; give one of them"
        )
    return asked


def settings(
    options: argparse.Namespace, read: api.ReadMesh, surface: Triangles | None = None
) -> dict[str, Any]:
    """Turn parsed options into keyword arguments of ``api.optimise`` for a mesh near its origin.

    Args:
        options: those of this module.
        read: the mesh.
        surface: to stay near where the options name none, in the unit of the mesh.

    Raises:
        InputError: an option that the net does not have, or one that cannot be used.
    """
    asked = refuse_unfit(options)
    chosen = arguments.given(OPTIONS.values(), options, read.unit)
    standing, ends = options.supports or asked.supports, (STEPS, *WEIGHTS.values())
    if "reference" in chosen:
        chosen["reference"] = _reference(chosen["reference"], options.up, read)
    return {
        "fix": standing if options.supports_fixed else options.fix,
        "supports": "" if options.supports_fixed else options.supports or "",
        **{option.name: option.default for option in ends},
        **arguments.given(ends, options, read.unit),
        "options": NetOptions(**chosen),
        "constraints": _constraints(options, read, surface),
    }


def _nets(names: tuple[str, ...]) -> str:
    return ", ".join(names) or "no net"


def _reference(path: str, up: str, read: api.ReadMesh) -> FloatArray:
    """Positions of the reference mesh, whose faces must be those of the mesh."""
    data, mesh = read_mesh_file(path, up), read.mesh
    other, _ = quads_of(data, path)
    if other.vertices.shape != mesh.vertices.shape or not np.array_equal(other.faces, mesh.faces):
        raise InputError(
            f"{path}: has other vertices or faces than the mesh ({len(other.vertices)} and "
            f"{len(other.faces)}, not {len(mesh.vertices)} and {len(mesh.faces)}, or in another "
            "order); give the same mesh in another shape"
        )
    return _in_unit(other.vertices, data.unit, read.unit)


def _in_unit(points: FloatArray, named: str | None, wanted: str) -> FloatArray:
    """Points of a file that names its unit, in another; others are taken for it already."""
    return points if named is None else points * (millimetres_per(named) / millimetres_per(wanted))


def _constraints(
    options: argparse.Namespace, read: api.ReadMesh, near: Triangles | None
) -> Constraints | None:
    """What the options hold, about the local origin of the mesh."""
    wanted = _read_constraints(options, read.unit, near)
    return None if wanted is None else wanted.about(read.origin)


def refuse_unreadable(options: argparse.Namespace) -> None:
    """Refuse, before any net is there, what can be read of no net.

    Raises:
        InputError: a handle or a curve that cannot be read.
    """
    _read_constraints(options, "m", None)


def _read_constraints(
    options: argparse.Namespace, unit: str, near: Triangles | None
) -> Constraints | None:
    handles = dict(place("handle", text, unit) for text in options.handle)
    glide = tuple(_glide(text, unit, options.up) for text in options.glide)
    if options.close_to:
        near = surface_in(options.close_to, unit, options.up)
    symmetry = mirror_planes(options.symmetry)
    if not (handles or glide or near or symmetry):
        return None
    return Constraints(handles=handles, glide=glide, close_to=near, symmetry=symmetry)


def _glide(text: str, unit: str, up: str) -> Glide:
    match = _VERTICES.search(text)
    what = text[: match.start()] if match else text
    kind, _, where = what.partition(":")
    vertices = np.array(values.whole_numbers("glide", match[1])) if match else None
    if what == "boundary" and not match:
        return BoundaryGlide()
    # As in documents; the word before it was needed once.
    level = (where if kind == "plane" else what).replace(" ", "")
    if level[:2] in ("x=", "y=", "z="):
        found = plane(level, unit)
        if found is None:
            raise InputError(f"glide: expected a number such as z=0 or z=1.5m, got '{text[:40]}'")
        return PlaneGlide(*found, vertices)
    if kind == "curve" and where:
        points, closed = _curve(where, up)
        return CurveGlide(points, closed, vertices)
    if kind == "surface" and where:
        return SurfaceGlide(*surface_in(where, unit, up), vertices)
    raise InputError(
        "glide: expected boundary, z=0, curve:FILE or surface:FILE, and @I,J for some "
        f"vertices only, got '{text}'"
    )


def surface_in(path: str, unit: str, up: str) -> Triangles:
    """Points and triangles of a surface's file, in a unit.

    Raises:
        InputError: no such file, or nothing with triangles in it.
    """
    points, triangles, named = read_triangles(path, up)
    return _in_unit(points, named, unit), triangles


def _curve(path: str, up: str) -> tuple[FloatArray, bool]:
    """Points of a file, without the last where it is the first again: then they are closed."""
    curve = upright(read_points(path), up)
    apart = np.abs(curve[-1] - curve[0]).max()
    closed = len(curve) > 3 and bool(apart <= _CLOSED * size_of(curve))
    return (curve[:-1] if closed else curve), closed
