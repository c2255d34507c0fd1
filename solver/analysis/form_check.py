"""Whether the form of a net is fit to be built, and where it is not."""

from __future__ import annotations

from dataclasses import dataclass
from typing import cast

import numpy as np

from solver.analysis import measures
from solver.analysis.form import Form
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.tuning import Tuning


@dataclass(frozen=True)
class Finding:
    """A measure of form and what it may be.

    Attributes:
        measure: ``folded faces``, ``evenness of lines``, ``shortest edge`` (over the mean edge, in
            parts of what it was at the start) or ``off the surface`` (in model units).
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
) -> tuple[Finding, ...]:
    """Hold the form of a net against what is fit to be built.

    Args:
        start: the mesh before it was made exact.
        mesh: the net, with the same faces.
        form: of the net, against its design surface.
        within: how far from the surface it may be, in model units; by default 1 % of the size.
        tuning: what counts as short and as uneven.
    """
    tuning = tuning or Tuning()
    off = form.off_surface
    far = within or tuning.another * float(np.linalg.norm(np.ptp(start.vertices, axis=0)))
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


def _at(mesh: QuadMesh, vertices: np.ndarray) -> list[float]:
    return cast(list[float], mesh.vertices[vertices].mean(axis=0).tolist())
