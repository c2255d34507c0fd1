"""Paints a field on the nodes of a net: on its faces, its vertices or its edges."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_ortho.view.colour_scale import ColourScale, shown
from freecad_ortho.view.colours import shading
from solver.analysis.fields import EDGES, VERTICES, Field, field
from solver.mesh.closest import TriangleSurface
from solver.mesh.quadmesh import FloatArray, QuadMesh

# Too slow to follow each step of a moving mesh.
_SLOW = (
    "Twist",
    "Gap to reference",
    "Force",
    "Kinds of panels",
    "Kinds of edges",
    "Kinds of nodes",
)


@dataclass(frozen=True)
class ColourRange:
    """What the user set of a colour map.

    Attributes:
        automatic: take the range from the values; residuals always have ``decades``.
        low: lowest value, in the units of the legend.
        high: highest value.
        decades: lowest and highest power of ten of residuals.
    """

    automatic: bool
    low: float
    high: float
    decades: tuple[int, int]


@dataclass(frozen=True, eq=False)
class Painting:
    """Colours of a net and what the legend says about them.

    Attributes:
        faces: (F, 3) or, with ``per_vertex``, (V, 3) RGB.
        edges: (E, 3) RGB, None where edges have the plain colour.
        per_vertex: whether ``faces`` is blended between the vertices.
        scale: of the legend, None for a plain net.
        note: the extreme value in words.
    """

    faces: FloatArray
    edges: FloatArray | None = None
    per_vertex: bool = False
    scale: ColourScale | None = None
    note: str = ""


def is_quick(name: str) -> bool:
    """Tell whether a colour map can follow a mesh while it moves."""
    return name not in _SLOW


def plain(mesh: QuadMesh, colour: tuple[float, ...]) -> Painting:
    """Faces of one colour, shaded by their direction."""
    return Painting(np.outer(shading(mesh.face_normals), colour[:3]))


def painting(
    mesh: QuadMesh,
    name: str,
    chosen: ColourRange,
    colour: tuple[float, ...],
    reference: TriangleSurface | None = None,
) -> Painting:
    """Paint the colour map of that name.

    Args:
        mesh: in mm.
        name: one of :func:`solver.analysis.fields.fields`.
        chosen: range of values.
        colour: RGB of faces whose edges carry the values.
        reference: what the gap is measured to.

    Raises:
        InputError: the mesh or the missing reference does not allow this map.
    """
    values = field(mesh, name, reference)
    scale = _scale(values, chosen)
    colours = scale.colours(values)
    note = _note(values, scale)
    if values.place == EDGES:
        return Painting(plain(mesh, colour).faces, colours, False, scale, note)
    if values.place == VERTICES:
        shades = shading(mesh.vertex_normals)[:, None]
        return Painting(colours * shades, None, True, scale, note)
    return Painting(colours * shading(mesh.face_normals)[:, None], None, False, scale, note)


def _scale(values: Field, chosen: ColourRange) -> ColourScale:
    if values.decades:
        return ColourScale.of_decades(*chosen.decades)
    if chosen.automatic:
        return ColourScale.automatic(values)
    return ColourScale.between(values, chosen.low, chosen.high)


def _note(values: Field, scale: ColourScale) -> str:
    known = shown(values)[np.isfinite(values.values)]
    if not len(known):
        return "no values"
    if values.decades:
        return f"max {scale.text(float(known.max()))}"
    low, high = float(known.min()), float(known.max())
    return f"{scale.text(float(f'{low:.3g}'))} to {scale.text(float(f'{high:.3g}'))}"
