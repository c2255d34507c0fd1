"""Nets along lines of curvature of CAD faces; what a face is comes as plain functions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from freecad_ortho.sources.source import Made, Source
from solver.align.align import Aligned, aligned
from solver.align.guides import TURNED
from solver.errors import InputError
from solver.mesh.closest import TriangleSurface
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.mesh.sampling import ParametricSurface, sampled
from solver.option import Option

# Points of a CAD face along an edge of the net, where they do not come to too many.
_FINER, _POINTS = 4.0, 40_000
# Faces of a net for which no edge length is given, about.
_FACES = 600
# Vertices nearer to the exact surface than this part of an edge are set onto it.
_NEAR = 0.05

OPTIONS = (
    Option("net", "principal", "choice",
           "What the net is to become; asymptotic and cmc lines run at 45 degrees to curvature",
           tuple(TURNED)),
    Option("edge", 0.0, "length", "Wanted edge length", absent="for about 600 faces"),
    Option("ratio", 1.0, "number", "How many times as long edges of the other family of lines are"),
)  # fmt: skip


def _on_faces(
    surfaces: Sequence[ParametricSurface], unit: str, net: str, edge: float, ratio: float
) -> Made:
    made = aligned_on(surfaces, net, edge, ratio)
    return Made(made.mesh, made.remarks)


def aligned_on(
    surfaces: Sequence[ParametricSurface],
    net: str,
    edge: float,
    ratio: float,
    strokes: Sequence[FloatArray] = (),
) -> Aligned:
    """A net along lines of CAD faces that meet smoothly; vertices on the faces themselves.

    Args:
        surfaces: in mm.
        net: what the net is to become, of :data:`solver.align.guides.TURNED`.
        edge: wanted edge length in mm, 0 for about 600 faces.
        ratio: edge length of the other family of lines over that.
        strokes: polylines (n, 3) on the faces, in mm, along which lines of the net run.

    Raises:
        InputError: faces that cannot be sampled, or a surface that has no such net.
    """
    edge = edge or edge_for(_area(surfaces), ratio)
    _refuse_ratio(ratio)
    fine = max(edge * min(1.0, ratio) / _FINER, np.sqrt(_area(surfaces) / _POINTS))
    stand_in = sampled(surfaces, edge=fine)
    triangles = TriangleSurface.from_quads(stand_in.mesh)
    made = aligned(
        *(triangles.vertices, triangles.triangles),
        net=net,
        edge=edge,
        ratio=ratio,
        strokes=strokes,
    )
    mesh = _set_onto(made.mesh, surfaces, edge)
    return replace(made, mesh=mesh)


def edge_for(area: float, ratio: float) -> float:
    """The edge length with which a net of this area has about 600 faces."""
    _refuse_ratio(ratio)
    return float(f"{np.sqrt(area / _FACES / ratio):.2g}")


def _refuse_ratio(ratio: float) -> None:
    if not ratio > 0:
        raise InputError(f"ratio: expected a positive number, got {ratio:g}")


def _area(surfaces: Sequence[ParametricSurface]) -> float:
    """About the area of all faces, from a coarse grid of each."""
    total = 0.0
    for surface in surfaces:
        points = surface.grid(np.linspace(*surface.u, 25), np.linspace(*surface.v, 25))
        one, two = points[1:, 1:] - points[:-1, :-1], points[1:, :-1] - points[:-1, 1:]
        total += 0.5 * float(np.linalg.norm(np.cross(one, two), axis=2).sum())
    return total


def _set_onto(mesh: QuadMesh, surfaces: Sequence[ParametricSurface], edge: float) -> QuadMesh:
    """Vertices moved onto the exact faces, where these are near: not what overhangs the border."""
    best = mesh.vertices.copy()
    far = np.full(len(best), _NEAR * edge)
    for surface in surfaces:
        if surface.foot is None:
            continue
        feet: FloatArray = surface.foot(mesh.vertices)
        moved = np.linalg.norm(feet - mesh.vertices, axis=1)
        nearer = moved < far
        best[nearer], far[nearer] = feet[nearer], moved[nearer]
    return mesh.with_vertices(best)


ALIGNED = Source(
    "along curvature",
    "A net along lines of curvature of CAD faces, or at 45 degrees to them",
    OPTIONS,
    _on_faces,
    "faces",
)
