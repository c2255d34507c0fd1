"""Whether the form of a net is fit to be built, and where it is not."""

from __future__ import annotations

from dataclasses import dataclass
from typing import cast

import numpy as np

from solver.analysis import measures
from solver.analysis.form import Form, off_border
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.tuning import Tuning


@dataclass(frozen=True)
class Finding:
    """A measure of form and what it may be.

    Attributes:
        measure: ``folded faces``, ``evenness of lines``, ``shortest edge`` (over the mean edge, in
            parts of what it was at the start), ``off the surface`` or ``off the border`` (in model
            units).
        value: of the net.
        limit: the most, or of evenness and edges the least, that it may be.
        met: whether it is.
        where: the face, edge or vertex where it is worst.
        place: its coordinates.
        remedy: what to try where it is not met.
    """

    measure: str
    value: float
    limit: float
    met: bool
    where: str
    place: list[float]
    remedy: str


def check_form(
    start: QuadMesh,
    mesh: QuadMesh,
    form: Form,
    within: float | None = None,
    tuning: Tuning | None = None,
    overhangs: bool = False,
) -> tuple[Finding, ...]:
    """Hold the form of a net against what is fit to be built.

    Args:
        start: the mesh before it was made exact.
        mesh: the net, with the same faces.
        form: of the net, against its design surface.
        within: how far from the surface, and from its border, it may be, in model units; by default
            1 % of the size.
        tuning: what counts as short and as uneven.
        overhangs: whether the net goes on beyond the border of the surface and is cut there, so
            that its own border is no outline.
    """
    tuning = tuning or Tuning()
    off = form.off_surface
    far = within or tuning.another * float(np.linalg.norm(np.ptp(start.vertices, axis=0)))
    outline = () if overhangs else (_outline(start, mesh, far),)
    return (
        _folds(start, mesh),
        _evenness(mesh, form, tuning),
        _edges(start, mesh, tuning),
        Finding(
            "off the surface",
            off.max,
            far,
            off.max <= far,
            f"face {off.face}",
            _at(mesh, mesh.faces[off.face]),
            "a shorter edge, another net, or a larger distance",
        ),
        *outline,
    )


def _folds(start: QuadMesh, mesh: QuadMesh) -> Finding:
    folded = np.flatnonzero(measures.flipped(mesh))
    allowed = int(measures.flipped(start).sum())
    worst = int(folded[0]) if len(folded) else 0
    return Finding(
        "folded faces",
        len(folded),
        allowed,
        len(folded) <= allowed,
        f"face {worst}",
        _at(mesh, mesh.faces[worst]),
        "a shorter edge, or a surface that is smoother there",
    )


def _evenness(mesh: QuadMesh, form: Form, tuning: Tuning) -> Finding:
    """Where lines bend least evenly, and how evenly they do altogether."""
    least = min(form.zigzag_start, tuning.even) - tuning.uneven
    quadruples = mesh.connectivity.line_quadruples
    worst = int(mesh.faces[0, 0])
    if len(quadruples):
        a, b, c, d = mesh.vertices[quadruples].transpose(1, 0, 2)
        uneven: FloatArray = np.linalg.norm(3 * (b - c) - a + d, axis=1)
        worst = int(quadruples[np.argmax(uneven), 1])
    return Finding(
        "evenness of lines",
        form.zigzag,
        least,
        form.zigzag >= least,
        f"vertex {worst}",
        _at(mesh, np.array([worst])),
        "a shorter edge, or a larger weight of evenness",
    )


def _edges(start: QuadMesh, mesh: QuadMesh, tuning: Tuning) -> Finding:
    kept = measures.edge_ratio(mesh) / max(measures.edge_ratio(start), 1e-12)
    ends = mesh.connectivity.edges[np.argmin(mesh.edge_lengths)]
    return Finding(
        "shortest edge",
        kept,
        tuning.cramped,
        kept >= tuning.cramped,
        f"edge {ends[0]}-{ends[1]}",
        _at(mesh, ends),
        "another edge length or ratio, or a larger weight of fairness",
    )


def _outline(start: QuadMesh, mesh: QuadMesh, most: float) -> Finding:
    """Where the net has left the border along which it was drawn: there the surface is bare."""
    far, vertex = off_border(start, mesh)
    return Finding(
        "off the border",
        far,
        most,
        far <= most,
        f"vertex {vertex}",
        _at(mesh, np.array([vertex])),
        "a net that overhangs the border and is cut there, or a planar one that glides on its "
        "border, with faces that are flat but for some millimetres",
    )


def _at(mesh: QuadMesh, vertices: np.ndarray) -> list[float]:
    return cast(list[float], mesh.vertices[vertices].mean(axis=0).tolist())
