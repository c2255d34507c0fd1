"""Panels: a plate in every face, shrunk by half the gap on each side.

The gap is measured on the mesh. Where neighbours lean together, their plates come closer than that
at one of their levels: by ``2 z tan(theta / 2)`` at level ``z`` for faces that meet at an angle
``theta``. Each side shrinks by half the gap, and by more only where otherwise less than half of the
gap would stay clear; so a flat pattern is the face less half the gap unless the plates would touch.

With bevelled edges the sides of the plates are parallel to the planes of the beams instead, which
contain the node axes: the gap is the same at every level, and half of it lies on each side.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_ortho.fabrication.sizes import rounded_down
from freecad_ortho.fabrication.systems.beams.geometry import LEFT_TOP, RIGHT_TOP, BeamGeometry
from solver.errors import InputError
from solver.mesh.connectivity import Connectivity, IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows

# Sine of a corner's exterior angle below which its two sides count as one line.
_STRAIGHT = 1e-3


@dataclass(frozen=True, eq=False)
class PanelGeometry:
    """All panels of a mesh as arrays, one row a face; mm.

    Attributes:
        points: (F, 8, 3) lower corners, then upper corners, counter-clockwise from above.
        origin: (F, 3) where the lower left corner of the flat pattern's box is.
        frame: (F, 3, 3) rows along the first side, across it, normal.
        outline: (F, 4, 2) the plate to cut in its plane, the first side of the face along x.
        upper: (F, 4, 2) outline of the upper side, less than the plate where bevels lean in.
        sides: (F, 4) how far each side moved inwards.
        clear: (F, 4) gap that stays clear at the tightest level, inf at the boundary.
        lift: (F,) from the parallel mesh to the plate's lower face; 0 without beams.
    """

    points: FloatArray
    origin: FloatArray
    frame: FloatArray
    outline: FloatArray
    upper: FloatArray
    sides: FloatArray
    clear: FloatArray
    lift: FloatArray


def panel_geometry(
    mesh: QuadMesh,
    levels: tuple[float, float],
    gap: float,
    beams: BeamGeometry | None = None,
    inward: FloatArray | None = None,
) -> PanelGeometry:
    """Compute the corners of all panels.

    Args:
        mesh: positions in mm; with beams, of the parallel mesh at the beams' upper level.
        levels: lower and upper level along the face normal, mm from the mesh.
        gap: joint between neighbours, mm.
        beams: when given, panels lie on them, lifted until no beam's upper side cuts a panel.
        inward: (F, 4, 3) normals of the planes that bevelled sides are parallel to, into the face;
            without it sides are square.

    Raises:
        InputError: a face that the gap leaves nothing of.
    """
    corner = mesh.vertices[mesh.faces]
    middle = corner.mean(axis=1)
    normal = mesh.face_normals
    side = np.roll(corner, -1, axis=1) - corner
    first = unit_rows(side[:, 0] - np.einsum("fk,fk->f", side[:, 0], normal)[:, None] * normal)
    second = np.cross(normal, first)
    frame = np.stack([first, second, normal], axis=1)
    flat = np.einsum("fck,fdk->fcd", corner - middle[:, None], frame[:, :2])

    thickness = levels[1] - levels[0]
    lower = np.full(len(corner), levels[0])
    lift = np.zeros(len(corner))
    if beams is not None:
        lift = _lift(mesh.connectivity, beams, middle, normal)
        lower = lift
    upper = lower + thickness
    if inward is None:
        sides, clear = _square_sides(mesh.connectivity, normal, side, (lower, upper), gap)
        rings = [inset(flat, sides)] * 2
        outline = rings[0]
    else:
        by_level = [_bevelled_sides(frame, inward, level, gap) for level in (lower, upper)]
        rings = [inset(flat, sides) for sides in by_level]
        sides = np.minimum(*by_level)
        outline = inset(flat, sides)
        clear = np.full(sides.shape, gap)
    for ring in rings:
        _refuse_gap(gap, thickness, flat, ring)
    points = np.concatenate(
        [
            middle[:, None]
            + np.einsum("fcd,fdk->fck", ring, frame[:, :2])
            + (level[:, None] * normal)[:, None]
            for ring, level in zip(rings, (lower, upper), strict=True)
        ],
        axis=1,
    )
    low = np.concatenate([outline.min(axis=1), lower[:, None]], axis=1)
    origin = middle + np.einsum("fd,fdk->fk", low, frame)
    return PanelGeometry(points, origin, frame, outline, rings[1], sides, clear, lift)


def _square_sides(
    connectivity: Connectivity,
    normal: FloatArray,
    side: FloatArray,
    levels: tuple[FloatArray, FloatArray],
    gap: float,
) -> tuple[FloatArray, FloatArray]:
    """How far square sides move inwards, and the gap that stays clear, (F, 4) each."""
    bend = half_angle_tangents(connectivity, normal, side)
    closing = np.max([-level[:, None] * bend for level in levels] + [0 * bend], axis=0)
    sides = np.maximum(gap / 2, closing + gap / 4)
    sides = np.where(np.isnan(bend), gap / 2, sides)
    return sides, np.where(np.isnan(bend), np.inf, 2 * (sides - closing))


def _bevelled_sides(
    frame: FloatArray, inward: FloatArray, level: FloatArray, gap: float
) -> FloatArray:
    """(F, 4) how far sides parallel to these planes move inwards at a level (F,)."""
    flat = np.linalg.norm(np.einsum("fck,fdk->fcd", inward, frame[:, :2]), axis=2)
    up = np.einsum("fck,fk->fc", inward, frame[:, 2])
    return np.asarray((gap / 2 - up * level[:, None]) / flat)


def neighbours(connectivity: Connectivity) -> IntArray:
    """(F, 4) face across each side, -1 at the boundary."""
    twins = connectivity.twins
    return np.where(twins >= 0, twins // 4, -1).reshape(-1, 4)


def half_angle_tangents(
    connectivity: Connectivity, normal: FloatArray, side: FloatArray
) -> FloatArray:
    """(F, 4) tan(theta / 2) across each side, positive at a ridge, NaN at the boundary."""
    across = neighbours(connectivity)
    other = normal[across]
    sine = np.einsum("fck,fck->fc", np.cross(normal[:, None], other), unit_rows(side))
    cosine = np.einsum("fk,fck->fc", normal, other)
    tangent = sine / np.maximum(1 + cosine, 1e-6)
    return np.where(across >= 0, tangent, np.nan)


def _lift(
    connectivity: Connectivity, beams: BeamGeometry, middle: FloatArray, normal: FloatArray
) -> FloatArray:
    """(F,) how far the beams' upper sides stand above each face of the parallel mesh."""
    on_left = connectivity.edge_faces[connectivity.face_edges, 0]
    on_left = on_left == np.arange(len(middle))[:, None]
    top = np.where(
        on_left[:, :, None, None],
        beams.points[:, LEFT_TOP][connectivity.face_edges],
        beams.points[:, RIGHT_TOP][connectivity.face_edges],
    )
    above = np.einsum("fcpk,fk->fcp", top - middle[:, None, None], normal)
    return np.maximum(above.max(axis=(1, 2)), 0.0)


def inset(polygon: FloatArray, distance: FloatArray) -> FloatArray:
    """Move side k of each polygon (F, 4, 2) inwards by ``distance[:, k]``."""
    along = unit_rows(np.roll(polygon, -1, axis=1) - polygon)
    before = np.roll(along, 1, axis=1)
    here, last = distance, np.roll(distance, 1, axis=1)
    sine = before[..., 0] * along[..., 1] - before[..., 1] * along[..., 0]
    straight = np.abs(sine) < _STRAIGHT
    divisor = np.where(straight, 1.0, sine)[..., None]
    shift = (last[..., None] * along - here[..., None] * before) / divisor
    mean = unit_rows(along + before)
    inward = np.stack([-mean[..., 1], mean[..., 0]], axis=-1)
    even = np.maximum(here, last)[..., None] * inward
    return np.asarray(polygon + np.where(straight[..., None], even, shift))


def _refuse_gap(gap: float, thickness: float, polygon: FloatArray, outline: FloatArray) -> None:
    side = np.roll(polygon, -1, axis=1) - polygon
    left = np.roll(outline, -1, axis=1) - outline
    kept = np.einsum("fcd,fcd->fc", left, side) / np.einsum("fcd,fcd->fc", side, side)
    if kept.min() <= 1e-3:
        face = int(np.argmin(kept.min(axis=1)))
        largest = gap / (1 - float(kept.min()))
        raise InputError(
            f"gap: {gap:g} mm with panels {thickness:g} mm thick leaves nothing "
            f"of face {face}; take a gap below {rounded_down(largest)} mm or thinner panels"
        )
