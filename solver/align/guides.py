"""What the directions of a net should be on a surface: along curvature, its border, strokes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from scipy.spatial import cKDTree

from solver.align.features import Features
from solver.align.field import GuidingField, asymptotic_skew, curvature_guide
from solver.align.jets import face_tensors
from solver.align.membrane import membrane_forces
from solver.align.triangle_mesh import TriangleMesh
from solver.errors import InputError
from solver.mesh.closest import TriangleSurface
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray
from solver.sentence import Sentence

# What a net can be aligned as, and by how much its lines are turned from those of curvature, or of
# stress: the nets whose lines others begin with (``Net.lines``), and with ``developable`` all those
# of sheets of that ``Net.shape``.
TURNED = {
    "principal": 0.0,
    "developable": 0.0,
    "asymptotic": np.pi / 4,
    "asymptotic-angle": np.pi / 4,
    "cmc": np.pi / 4,
    "stress": 0.0,
}
# Where curvatures differ by less than this part of what they are, or by less than this angle an
# edge, on half of the surface, it is round or flat and any line is one of curvature.
_ROUND, _FLAT = 0.02, 5e-4
# A surface bends both ways where its curvatures are opposite on this part of it.
_MOSTLY = 0.8
# How much more than curvature a stroke counts; in edges, how wide it is, within which distance
# lines turn to it, and how far from the surface it may be.
_STROKE, _WIDE, _TURN, _OFF = 30.0, 0.6, 8.0, 1.0
# In edges, how wide a feature line is.
_BESIDE = 0.4
# Normals of a plane differ by no more; those of flat faces that meet at creases by more.
_PLANE, _FOLDED = 1e-3, 0.1
# The border gives a plane its lines if so much of it runs in one direction, within so many degrees;
# how much more level sides count where several are as long.
_MUCH, _ALIKE, _LEVEL = 0.25, 1.0, 0.01
# So many of the longest pieces of the border are tried.
_TRIED = 200
# Places that a stroke is looked at, for each edge of the net.
_PLACES = 6


def net_guide(
    mesh: TriangleMesh,
    inner: int,
    tensors: FloatArray,
    net: str,
    edge: float,
    stands_on: str,
    remarks: list[str],
) -> GuidingField:
    """Directions in which a net has its lines, where the surface has any.

    Args:
        mesh: the surface, with its apron.
        inner: how many of the triangles are the surface's own.
        tensors: (T, 2, 2) shape operators in the triangles' frames.
        net: one of :data:`TURNED`.
        edge: wanted edge length.
        stands_on: what carries the shell whose stresses a stress net follows.
        remarks: gets a sentence where the surface has no lines of its own.

    Raises:
        InputError: a surface that has no such lines.
    """
    if net == "stress":
        forces = membrane_forces(mesh, inner, stands_on, edge)
        return curvature_guide(mesh, face_tensors(mesh, forces), inner, TURNED[net])
    own, areas = tensors[:inner], mesh.areas[:inner]
    mean, gauss = np.trace(own, axis1=1, axis2=2) / 2, np.linalg.det(own)
    differ = np.sqrt(np.maximum(mean**2 - gauss, 0.0))
    if _middle(differ, areas) < max(_ROUND * _middle(np.abs(mean), areas), _FLAT / edge):
        if TURNED[net]:
            raise InputError(
                f"net: on a flat or round surface no line is more {net} than another; choose "
                "principal, or a surface that is curved differently in its directions"
            )
        remarks.append(
            Sentence(
                "the surface is flat or round: every direction is one of curvature; the lines run "
                "along its border"
            )
        )
        bent = float(np.ptp(mesh.normals[:inner], axis=0).max())
        if bent > _FOLDED and _middle(np.abs(mean), areas) < _FLAT / edge:
            remarks.append(
                Sentence(
                    "it is made of flat faces that meet at creases: lines along these cannot run "
                    "along all eaves as well; a net on each face alone (--faces) keeps to its "
                    "longest side"
                )
            )
        straight = _along_side(mesh, inner) if bent < _PLANE else None
        return straight or _along_border(mesh, inner)
    if net in ("asymptotic", "asymptotic-angle"):
        saddle = float(areas[gauss < 0].sum() / areas.sum())
        if saddle < _MOSTLY:
            raise InputError(
                f"net: {net} lines need a surface that bends both ways, this one does on "
                f"{100 * saddle:.0f} % of its area; choose principal or cmc"
            )
    guide = curvature_guide(mesh, tensors, inner, TURNED[net])
    return replace(guide, skew=asymptotic_skew(tensors)) if net == "asymptotic-angle" else guide


def with_strokes(
    mesh: TriangleMesh, guide: GuidingField, strokes: Sequence[FloatArray], edge: float
) -> GuidingField:
    """Let lines of the net run along curves, whatever curvature says there.

    Args:
        mesh: the surface, with its apron.
        guide: the directions that hold elsewhere.
        strokes: polylines (n, 3) on the surface or near it.
        edge: wanted edge length.

    Raises:
        InputError: a stroke of one point, or one that is off the surface.
    """
    if not strokes:
        return guide
    surface = TriangleSurface(mesh.points, mesh.triangles[: guide.inner])
    for number, stroke in enumerate(strokes, start=1):
        places, along = walked(stroke, edge / _PLACES, number)
        feet, _ = surface.closest(places)
        off = float(np.linalg.norm(places - feet, axis=1).max())
        if off > _OFF * edge:
            raise InputError(
                f"stroke {number}: it is up to {off:.3g} off the surface, more than an edge; "
                "draw it on the surface"
            )
        guide = _run_along(mesh, guide, feet, along, (_WIDE * edge, _TURN * edge))
    return guide


def along_features(
    mesh: TriangleMesh, guide: GuidingField, features: Features, edge: float
) -> GuidingField:
    """Let lines of the net run along feature lines, and turn to them within their reach.

    Args:
        mesh: the surface, with its apron.
        guide: the directions that hold elsewhere.
        features: of the surface.
        edge: wanted edge length.
    """
    if not len(features.edges):
        return guide
    start, end = (mesh.points[side[features.edges]] for side in mesh.ends)
    count = int(np.ceil(np.linalg.norm(end - start, axis=1).max() / edge * _PLACES)) + 1
    part = ((np.arange(count) + 0.5) / count)[:, None, None]
    places = (start + part * (end - start)).reshape(-1, 3)
    along, reach = np.tile(features.along, (count, 1)), np.tile(features.reach, count)
    return _run_along(mesh, guide, places, along, (_BESIDE * edge, reach * edge))


def _run_along(
    mesh: TriangleMesh,
    guide: GuidingField,
    places: FloatArray,
    along: FloatArray,
    reach: tuple[float, float | FloatArray],
) -> GuidingField:
    """Directions (N, 3) at places (N, 3) hold nearer than the first reach.

    Curvature is silent where the lines turn from it to them, the less the further, up to the
    second.
    """
    far, nearest = cKDTree(places).query(mesh.centres)
    less = np.minimum(1.0, far / np.broadcast_to(reach[1], len(places))[nearest])
    angles, certainty, stretch = (
        guide.angles.copy(),
        guide.certainty * less**4,
        guide.stretch * less**2,
    )
    rows: IntArray = np.flatnonzero(far < reach[0])
    first, second = ((along[nearest[rows]] * mesh.axes[rows, k]).sum(axis=1) for k in (0, 1))
    angles[rows] = np.arctan2(second, first)
    certainty[rows], stretch[rows] = _STROKE, 1.0
    skew = guide.skew
    if skew is not None:
        # Beside such a line the others cross it at right angles.
        part = np.where(far < reach[0], 0.0, less**2)[:, None, None]
        skew = part * skew + (1 - part) * np.eye(2)
    return replace(guide, angles=angles, certainty=certainty, stretch=stretch, skew=skew)


def walked(stroke: FloatArray, step: float, number: int) -> tuple[FloatArray, FloatArray]:
    """Places along a polyline, and its direction there."""
    runs = np.diff(stroke, axis=0)
    lengths = np.linalg.norm(runs, axis=1)
    if not lengths.sum() > 0:
        raise InputError(f"stroke {number}: expected two points or more; draw a longer one")
    runs, starts, lengths = runs[lengths > 0], stroke[:-1][lengths > 0], lengths[lengths > 0]
    counts = np.maximum(1, np.ceil(lengths / step)).astype(np.int64)
    row = np.repeat(np.arange(len(runs)), counts)
    part = (np.arange(len(row)) - np.repeat(np.cumsum(counts) - counts, counts) + 0.5) / counts[row]
    return starts[row] + part[:, None] * runs[row], runs[row] / lengths[row, None]


def _middle(values: FloatArray, areas: FloatArray) -> float:
    """Median by area."""
    order = np.argsort(values)
    half = np.cumsum(areas[order])
    return float(values[order][np.searchsorted(half, half[-1] / 2)])


def _along_border(mesh: TriangleMesh, inner: int) -> GuidingField:
    """Directions of the border at its own triangles, nothing elsewhere."""
    angles, certainty = np.zeros((2, len(mesh.triangles)))
    first, second = (mesh.edges // 3).T
    at_border = (first < inner) != (second < inner)
    start, end = mesh.ends
    run = (mesh.points[end] - mesh.points[start])[at_border]
    for side in (first, second):
        rows = side[at_border]
        axes = mesh.axes[rows]
        angles[rows] = np.arctan2((run * axes[:, 1]).sum(axis=1), (run * axes[:, 0]).sum(axis=1))
        certainty[rows] = 1.0
    return GuidingField(angles, certainty, np.zeros(len(angles)), inner)


def _along_side(mesh: TriangleMesh, inner: int) -> GuidingField | None:
    """The direction of the longest side of a plane, all over it; None where no side is long."""
    sides = ((mesh.edges // 3) < inner).sum(axis=1) == 1
    start, end = (side[sides] for side in mesh.ends)
    run = mesh.points[end] - mesh.points[start]
    length = np.linalg.norm(run, axis=1)
    axes = mesh.axes[0]
    angles = np.arctan2(run @ axes[1], run @ axes[0])
    tried = np.argsort(-length, kind="stable")[:_TRIED]
    apart = np.abs(np.sin(2 * (angles[tried, None] - angles)))
    alike = apart < np.sin(2 * np.radians(_ALIKE))
    much = alike @ length / length.sum()
    level = 1 - np.abs(run[tried, 2]) / length[tried]
    best = int(np.argmax(much + _LEVEL * level))
    if much[best] < _MUCH:
        return None
    along = run[tried[best]]
    count = len(mesh.triangles)
    turned = np.arctan2(mesh.axes[:, 1] @ along, mesh.axes[:, 0] @ along)
    return GuidingField(turned, np.ones(count), np.zeros(count), inner)
