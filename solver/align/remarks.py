"""What is to be said of a net on a surface before it is made exact."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.spatial import cKDTree

from solver.align.features import Features
from solver.align.field import QUARTER, GuidingField
from solver.align.guides import walked
from solver.align.triangle_mesh import TriangleMesh
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.sentence import Measured, Sentence, at

# Degrees to the lines of curvature from which on no exact net keeps a border, and a stroke.
_ASKEW, _ACROSS = 2.0, 10.0
# Curvature that says less than this says nothing of a stroke.
_SILENT = 0.05
# Lines bunch where this part of all edges is shorter than that part of what was wanted.
_SOME, BUNCHED = 0.05, 0.25


def say_border(mesh: TriangleMesh, guide: GuidingField, edge: float, remarks: list[str]) -> None:
    """Say that no exact net keeps a border that is no line of curvature.

    Args:
        mesh: the surface, with its apron.
        guide: the directions of curvature.
        edge: wanted edge length.
        remarks: gets the sentence.
    """
    turned = turned_from_border(mesh, guide, Features.border(mesh, guide.inner, edge))
    if turned > _ASKEW:
        remarks.append(
            Sentence(
                "the border runs at {:.0f} degrees to the lines of curvature on average: an exact "
                "principal net leaves it; a planar one with some millimetres of flatness, which "
                "glides along its boundary, keeps it",
                turned,
            )
        )


def turned_from_border(mesh: TriangleMesh, guide: GuidingField, rim: Features) -> float:
    """Mean angle between a border and the nearest of the guide's directions, 0 to 45 degrees.

    Args:
        mesh: the surface, with its apron.
        guide: directions, by how certain they are.
        rim: edges of the border.
    """
    start, end = (mesh.points[side[rim.edges]] for side in mesh.ends)
    inner = (mesh.edges[rim.edges] // 3).min(axis=1)
    return turned_by(mesh, guide, inner, rim.along, np.linalg.norm(end - start, axis=1))


def turned_by(
    mesh: TriangleMesh,
    guide: GuidingField,
    rows: IntArray,
    along: FloatArray,
    lengths: FloatArray,
) -> float:
    """Mean angle in degrees between pieces of a curve and the guide in triangles below them.

    Args:
        mesh: the surface, with its apron.
        guide: directions, by how certain they are.
        rows: (N,) triangles.
        along: (N, 3) unit vectors along the pieces.
        lengths: (N,) of them.
    """
    first, second = ((along * mesh.axes[rows, k]).sum(axis=1) for k in (0, 1))
    turned = np.arctan2(second, first) - guide.angles[rows]
    turned -= QUARTER * np.round(turned / QUARTER)
    weight = guide.certainty[rows] * lengths
    return float(np.degrees((weight * np.abs(turned)).sum() / max(weight.sum(), 1e-300)))


def say_strokes(
    mesh: TriangleMesh,
    guide: GuidingField,
    strokes: Sequence[FloatArray],
    step: float,
    net: str,
    remarks: list[str],
) -> None:
    """Say which strokes run across the lines that an exact net has.

    Args:
        mesh: the surface, with its apron.
        guide: the directions of these lines.
        strokes: polylines (n, 3).
        step: how far places are apart at which it is looked.
        net: its name.
        remarks: gets a sentence for each.
    """
    centres = cKDTree(mesh.centres[: guide.inner])
    for number, stroke in enumerate(strokes, start=1):
        places, along = walked(stroke, step, number)
        rows: IntArray = centres.query(places)[1]
        if guide.certainty[rows].mean() < _SILENT:
            continue
        turned = turned_by(mesh, guide, rows, along, np.ones(len(rows)))
        if turned > _ACROSS:
            remarks.append(
                Sentence(
                    "stroke {} runs at {:.0f} degrees to the lines of a {} net on average: the net "
                    "follows it, but an exact one near to this surface does not; draw it along "
                    "these lines, or leave the net as it is aligned",
                    number,
                    turned,
                    net,
                )
            )


def short_edges(mesh: QuadMesh) -> float:
    """The length that one edge in twenty is shorter than."""
    return float(np.quantile(mesh.edge_lengths, _SOME))


def say_bunched(mesh: QuadMesh, edge: float, remarks: list[str]) -> None:
    """Say where lines come much closer together than was wanted.

    Args:
        mesh: the net.
        edge: wanted length of its shorter edges.
        remarks: gets the sentence.
    """
    short = short_edges(mesh)
    if short > BUNCHED * edge:
        return
    ends = mesh.connectivity.edges[mesh.edge_lengths <= short]
    at = ", ".join(f"{x:.4g}" for x in np.median(mesh.vertices[ends].mean(axis=1), axis=0))
    remarks.append(
        Sentence(
            "lines bunch near ({}): one edge in {} is shorter than {:.0f} % of what was wanted; "
            "try: singular vertices beside that place, or another net",
            at,
            round(1 / _SOME),
            100 * short / edge,
        )
    )


def say_openings(
    surface: TriangleMesh, loops: list[list[int]], mesh: QuadMesh, remarks: list[str]
) -> None:
    """Name openings that the net runs over: the smallest, as many as it has too few.

    Args:
        surface: that the net was made on.
        loops: vertices around each of its openings, and its border.
        mesh: the net.
        remarks: gets the sentences.
    """
    spans = [float(np.linalg.norm(np.ptp(surface.points[loop], axis=0))) for loop in loops]
    closed = len(loops) - len(mesh.connectivity.boundary_loops)
    for k in np.argsort(spans)[: max(closed, 0)].tolist():
        place = surface.points[loops[k]].mean(axis=0)
        remarks.append(
            Sentence(
                "the opening at {}, {} across, is too small for faces of this size: lines run over "
                "it; a shorter edge keeps it",
                at(place),
                Measured(spans[k]),
            )
        )
