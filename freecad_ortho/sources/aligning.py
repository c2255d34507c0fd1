"""Nets along lines of curvature of CAD faces; what a face is comes as plain functions."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from freecad_ortho.sources.source import Made, Source
from solver.align import options as alignment
from solver.align.align import Aligned, aligned
from solver.align.crosses import Singular
from solver.mesh.poles import stand_in
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.mesh.sampling import ParametricSurface
from solver.option import Option
from solver.sentence import Sentence

# Points of a CAD face along an edge of the net, where they do not come to too many.
_FINER, _POINTS = 4.0, 40_000
# Faces of a net for which no edge length is given, about.
_FACES = 600
# Vertices nearer to the exact surface than this part of an edge are set onto it.
_NEAR = 0.05
# Points that a face is asked for before it is seen whether they are still wanted.
_PORTION = 200

_EDGE = replace(alignment.OPTIONS["edge"], default=0.0, absent="for about 600 faces")
_SINGULARITIES = Option(
    "singularities",
    None,
    "singular",
    "Other than four lines meet here: auto for the fewest that the surface needs, none, or "
    "a file of rows x y z and 3, 5 or 6 lines",
    absent="auto",
)
_STROKES = Option(
    "drawn_strokes", (), "polylines", "The net runs along these lines, drawn on the surface"
)
OPTIONS = (
    alignment.OPTIONS["net"],
    _EDGE,
    *(alignment.OPTIONS[name] for name in ("ratio", "border", "stands_on")),
    _SINGULARITIES,
    alignment.OPTIONS["symmetry"],
    _STROKES,
)


def _on_faces(
    surfaces: Sequence[ParametricSurface],
    unit: str,
    net: str,
    edge: float,
    ratio: float,
    border: str,
    stands_on: str,
    singularities: Singular | None,
    symmetry: str,
    drawn_strokes: Sequence[FloatArray],
    waiting: Callable[[str], object],
    strokes: Sequence[FloatArray] = (),
) -> Made:
    lines = (*strokes, *drawn_strokes)
    made = aligned_on(
        *(surfaces, net, edge, ratio, border, lines, singularities, waiting, stands_on, symmetry)
    )
    remarks = (*_irregular(made), *made.remarks)
    return Made(made.mesh, remarks, made.field, made.singular, made.border)


def _irregular(made: Aligned) -> list[str]:
    """How many irregular vertices there are, by how many lines meet there, in words."""
    lines, counts = np.unique(
        made.mesh.connectivity.face_valence[made.irregular], return_counts=True
    )
    found = tuple(
        Sentence("{} vertices with {} lines", count, meeting)
        if count > 1
        else Sentence("1 vertex with {} lines", meeting)
        for meeting, count in zip(lines.tolist(), counts.tolist(), strict=True)
    )
    return [Sentence("irregular: {}", found)] if found else []


def aligned_on(
    surfaces: Sequence[ParametricSurface],
    net: str,
    edge: float,
    ratio: float,
    border: str = "trim",
    strokes: Sequence[FloatArray] = (),
    singularities: Singular | None = None,
    waiting: Callable[[str], object] = lambda stage: None,
    stands_on: str = "boundary",
    symmetry: str = "none",
) -> Aligned:
    """A net along lines of CAD faces that meet smoothly; vertices on the faces themselves.

    Args:
        surfaces: in the model's unit.
        net: what the net is to become, of :data:`solver.align.guides.TURNED`.
        edge: wanted edge length, 0 for about 600 faces.
        ratio: edge length of the other family of lines over that.
        border: ``trim`` lets the net overhang, ``follow`` bends it to the border.
        strokes: polylines (n, 3) on the faces, along which lines of the net run.
        singularities: where the net has vertices with 3, 5 or 6 faces; the fewest that it needs
            by default.
        waiting: called with the name of each stage, some of them several times; what it raises is
            passed on.
        stands_on: ``boundary`` or ``corners``: what carries the shell that a stress net follows.
        symmetry: planes of symmetry, of :data:`solver.align.symmetry.SYMMETRIES`.

    Raises:
        InputError: faces that cannot be sampled, or a surface that has no such net.
    """
    surfaces = [_in_portions(surface, waiting) for surface in surfaces]
    area = sum(surface.area for surface in surfaces)
    edge = edge or edge_for(area, ratio)
    alignment.OPTIONS["ratio"].check(ratio)
    fine = max(edge * min(1.0, ratio) / _FINER, np.sqrt(area / _POINTS))
    made = aligned(
        *stand_in(surfaces, fine),
        net=net,
        edge=edge,
        ratio=ratio,
        border=border,
        stands_on=stands_on,
        strokes=strokes,
        singularities=singularities,
        symmetry=symmetry,
        waiting=waiting,
    )
    mesh = _set_onto(made.mesh, surfaces, edge)
    return replace(made, mesh=mesh)


def _in_portions(surface: ParametricSurface, waiting: Callable[[str], object]) -> ParametricSurface:
    """A surface that is asked for a few points at a time, and may be broken off in between."""

    def portioned(function: Any, stage: str) -> Any:
        def asked(*columns: FloatArray) -> FloatArray:
            found = []
            for start in range(0, max(len(columns[0]), 1), _PORTION):
                waiting(stage)
                found.append(function(*(column[start : start + _PORTION] for column in columns)))
            return np.concatenate(found)

        return function and asked

    return replace(
        surface,
        evaluate=portioned(surface.evaluate, "surface"),
        inside=portioned(surface.inside, "surface"),
        foot=portioned(surface.foot, "quads"),
    )


def edge_for(area: float, ratio: float) -> float:
    """The edge length with which a net of this area has about 600 faces."""
    alignment.OPTIONS["ratio"].check(ratio)
    return float(f"{np.sqrt(area / _FACES / ratio):.2g}")


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
    strokes=True,
    stages=("surface", "curvature", "directions", "map", "quads"),
)
