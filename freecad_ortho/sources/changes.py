"""Nets made from other nets: derived meshes, cuts, copies and transformations."""

from __future__ import annotations

import operator
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from freecad_ortho.sources.source import Made, Source
from solver.errors import InputError
from solver.mesh import coarsen, diagonal, mirror, subdivide, transform
from solver.mesh.dual import christoffel_dual
from solver.mesh.quadmesh import QuadMesh
from solver.offset.offset_mesh import KINDS, offset_mesh
from solver.option import NOT_ZERO, POSITIVE, Former, Option

# Edges of a dual that miss by this part of the mean one are rounding.
_DUAL = 1e-7
_CENTRE = Option("centre", (0.0, 0.0, 0.0), "distance", "This point stays where it is")


def _one(change: Callable[..., QuadMesh]) -> Callable[..., Made]:
    """A source's function from one that changes one mesh."""

    def build(meshes: Sequence[QuadMesh], unit: str, **options: Any) -> Made:
        return Made(change(meshes[0], **options))

    return build


def _diagonal(mesh: QuadMesh, which: str, border: str) -> QuadMesh:
    pair = diagonal.diagonal_meshes(mesh, border)
    part = pair.first if which == "first" else pair.second
    return coarsen.compact(part, part.faces)


def _dual(meshes: Sequence[QuadMesh], unit: str) -> Made:
    found = christoffel_dual(meshes[0])
    if found.misfit <= _DUAL:
        return Made(found.mesh)
    first, second = meshes[0].connectivity.edges[found.edge]
    words = (
        f"dual: the net has none, its edges would miss by {100 * found.misfit:.2g} % of the mean "
        f"one (edge {first} - {second}), and this is the nearest mesh; optimise to an isothermic "
        "net first, and cut open what closes around"
    )
    return Made(found.mesh, (words,))


def _subdivided(mesh: QuadMesh, levels: int, rule: str) -> QuadMesh:
    change = subdivide.subdivided if rule == "plain" else subdivide.catmull_clark
    return change(mesh, levels)


def _coarsened(mesh: QuadMesh, every: tuple[int, int], keep_border: bool) -> QuadMesh:
    """Every k-th line: of any mesh where both steps are equal and fit, else of grid type."""
    if every[0] == every[1]:
        try:
            return coarsen.coarsened(mesh, every[0])
        except InputError:
            if mesh.connectivity.regular[~mesh.connectivity.boundary_vertices].all():
                return coarsen.coarsened_grid(mesh, *every, keep_border)
            raise
    return coarsen.coarsened_grid(mesh, *every, keep_border)


def _trimmed(mesh: QuadMesh, rings: int, rows: tuple[int, int, int, int]) -> QuadMesh:
    if not rings and not any(rows):
        raise InputError("trim: expected rings or rows to cut off, got none; say how many")
    if rings:
        mesh = coarsen.without_border(mesh, rings)
    return coarsen.trimmed(mesh, (rows[0], rows[2]), (rows[1], rows[3])) if any(rows) else mesh


def _mirrored(
    mesh: QuadMesh, normal: tuple[float, ...], point: tuple[float, ...], image_only: bool
) -> QuadMesh:
    return (mirror.reflection if image_only else mirror.mirrored)(mesh, normal, point)


def _oriented(mesh: QuadMesh, reverse: bool, swap: bool) -> QuadMesh:
    mesh = mirror.reversed_orientation(mesh) if reverse else mesh
    return mirror.swapped(mesh) if swap else mesh


def _moved(
    mesh: QuadMesh, scale: float, turn: ArrayLike, move: ArrayLike, centre: ArrayLike
) -> QuadMesh:
    return transform.similarity(mesh, scale=scale, degrees=turn, move=move, centre=centre)


def _welded(meshes: Sequence[QuadMesh], unit: str, tolerance: float) -> Made:
    whole = mirror.size_of(np.concatenate([mesh.vertices for mesh in meshes]))
    mesh = mirror.welded(meshes, max(tolerance / whole, mirror.SAME_PLACE))
    return Made(mesh, tuple(mirror.weld_remarks(meshes, mesh)))


def _offset(meshes: Sequence[QuadMesh], unit: str, distance: float, kind: str) -> Made:
    found = offset_mesh(meshes[0], distance, kind)
    return Made(found.mesh, (f"in {unit}: {found.message}",))


CHANGES = (
    Source(
        "offset",
        "A parallel net at a distance that is constant where the net allows it",
        (
            Option("distance", 200.0, "distance",
                   "The offset lies this far along the normals, below where it is negative",
                   within=NOT_ZERO),
            Option("kind", "parallel", "choice",
                   "Vertices, edges or faces keep the distance, or edges stay parallel",
                   tuple(KINDS)),
        ),
        _offset,
        "net",
    ),
    Source(
        "diagonal mesh",
        "One of the two meshes of face diagonals",
        (
            Option("which", "first", "choice", "The first of the two holds the first vertex",
                   ("first", "second")),
            Option("border", "drop", "choice",
                   "The border is left a zigzag, or closed by narrow quads",
                   ("drop", "fill"), former=Former("boundary")),
        ),
        _one(_diagonal),
        "net",
        stays=True,
    ),
    Source(
        "medial mesh",
        "Points where the medial lines of the faces cross",
        (),
        _one(diagonal.medial_mesh),
        "net",
        stays=True,
    ),
    Source(
        "checkerboard",
        "Midpoints of the edges: a parallelogram in each face",
        (),
        _one(diagonal.checkerboard),
        "net",
        stays=True,
    ),
    Source(
        "Christoffel dual",
        "Parallel edges, each diagonal parallel to the other one; of a sphere a minimal surface",
        (),
        _dual,
        "net",
    ),
    Source(
        "subdivide",
        "Four faces for each, parameter lines kept",
        (
            subdivide.LEVELS,
            Option("rule", "plain", "choice", "New vertices lie in the middle, or all are smoothed",
                   ("plain", "catmull-clark")),
        ),
        _one(_subdivided),
        "net",
        stays=True,
    ),
    Source(
        "coarsen",
        "Every k-th parameter line",
        (
            Option("every", (2, 2), "count", "Every so many lines of u and v stay",
                   suffixes=("U", "V"), written="K|KxL"),
            Option("keep_border", True, "flag", "Keep the last line where the step misses it",
                   brief="leave the last line out where the step misses it",
                   former=Former("drop_border", operator.not_)),
        ),
        _one(_coarsened),
        "net",
        stays=True,
    ),
    Source(
        "trim",
        "Rings or rows of faces cut off",
        (
            Option("rings", 1, "count", "So many rings of faces are cut off at the border"),
            Option("rows", (0, 0, 0, 0), "count",
                   "So many rows are cut off at the starts and ends of u and v",
                   suffixes=("UStart", "UEnd", "VStart", "VEnd"), written="U0,U1,V0,V1"),
        ),
        _one(_trimmed),
        "net",
        stays=True,
    ),
    Source(
        "mirror",
        "The net and its mirror image, the seam merged",
        (
            Option("normal", (1.0, 0.0, 0.0), "direction", "The mirror plane has this normal"),
            Option("point", (0.0, 0.0, 0.0), "distance",
                   "The mirror plane goes through this point"),
            Option("image_only", False, "flag", "The mirror image comes alone",
                   former=Former("alone")),
        ),
        _one(_mirrored),
        "net",
    ),
    Source(
        "orient",
        "Other side up, or families u and v exchanged",
        (
            Option("reverse", True, "flag", "The other side is turned up"),
            Option("swap", False, "flag", "The families u and v change places"),
        ),
        _one(_oriented),
        "net",
        stays=True,
    ),
    Source(
        "transform",
        "Moved, turned and scaled",
        (
            Option("scale", 1.0, "number", "The net is scaled by this factor", within=POSITIVE),
            Option("turn", (0.0, 0.0, 0.0), "angle",
                   "The net is turned by these angles about x, then y, then z"),
            Option("move", (0.0, 0.0, 0.0), "distance", "The net is moved by this"),
            _CENTRE,
        ),
        _one(_moved),
        "net",
    ),
    Source(
        "Moebius transformation",
        "Bent so that circles stay circles; place and size stay",
        (
            Option("centre", (0.0, 0.0, 20000.0), "distance", "The inversion has its centre here"),
            Option("strength", 1.0, "number",
                   "Less than 1 moves the centre farther away", within=POSITIVE),
        ),
        _one(transform.moebius),
        "net",
    ),
    Source(
        "inversion",
        "Inverted in a sphere",
        (
            Option("centre", (0.0, 0.0, 20000.0), "distance", "The sphere has its centre here"),
            Option("radius", 10000.0, "length", "The sphere has this radius", within=POSITIVE),
        ),
        _one(transform.inverted),
        "net",
    ),
    Source(
        "weld",
        "Nets joined into one where borders meet, also within one net",
        (Option("tolerance", 1.0, "length", "Vertices that are nearer than this are merged"),),
        _welded,
        "nets",
    ),
)  # fmt: skip
