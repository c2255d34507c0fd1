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
from freecad_ortho.fabrication.systems.panels.corners import PanelCorners, uncut
from freecad_ortho.fabrication.systems.panels.hubs import Stands, corner_cuts, lift_over
from freecad_ortho.fabrication.systems.panels.planes import Planes
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray, Connectivity, IntArray, SameSize
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows

# Sine of a corner's exterior angle below which its two sides count as one line.
_STRAIGHT = 1e-3


@dataclass(frozen=True, eq=False)
class PanelGeometry:
    """All panels of a mesh as arrays, one row a face; mm.

    Where faces have several sizes, those with n corners each: then 4 is n.

    Attributes:
        origin: (F, 3) where the lower left corner of the flat pattern's box is.
        planes: of the faces.
        outline: (F, 4, 2) the plate to cut in its plane, the first side of the face along x,
            before corners are cut off.
        upper: (F, 4, 2) outline of the upper side, less than the plate where bevels lean in.
        lower: (F, 4, 2) outline of the lower side.
        levels: (2, F) of the lower and upper side above the planes.
        corners: lines that cut corners off.
        sides: (F, 4) how far each side moved inwards.
        clear: (F, 4) width of the joint where it is tightest, inf at the boundary.
        lift: (F,) from the parallel mesh to the plate's lower face; 0 without beams.
        over_hubs: (F,) true where that lifts the panel over hubs.
    """

    origin: FloatArray
    planes: Planes
    outline: FloatArray
    upper: FloatArray
    lower: FloatArray
    levels: FloatArray
    corners: PanelCorners
    sides: FloatArray
    clear: FloatArray
    lift: FloatArray
    over_hubs: BoolArray

    def lower_edges(self) -> FloatArray:
        """(F, 4, 2, 3) ends of the lower edges, in the site's mesh."""
        return self.planes.in_space(self.corners.trimmed(self.lower), self.levels[0])


def panel_geometry(
    mesh: QuadMesh,
    levels: tuple[float, float],
    gap: float,
    beams: BeamGeometry | None = None,
    inward: FloatArray | None = None,
    stands: Stands | None = None,
    wanted: BoolArray | None = None,
    bed: float = 0.0,
    depth: float = 0.0,
    same: SameSize | None = None,
) -> PanelGeometry:
    """Compute the corners of all panels.

    Args:
        mesh: positions in mm; with beams, of the parallel mesh at the beams' upper level.
        levels: lower and upper level along the face normal, mm from the mesh.
        gap: joint between neighbours, mm.
        beams: when given, panels lie on them, lifted until no beam's upper side cuts a panel.
        inward: (F, 4, 3) normals of the planes that bevelled sides are parallel to, into the face;
            without it sides are square.
        stands: hubs that the panels stay clear of. Panels on beams whose cut corners would leave
            nothing of a side are lifted over them.
        wanted: (F,) faces of which something is to be left, by default all.
        bed: what lies between panels and beams, mm.
        depth: of what is below panels, as wide as they are; square ones leave room for it, mm.
        same: the faces, equally many corners each, by default all; of some the joints to others are
            not measured.

    Raises:
        InputError: a face that the gap or the hubs leave nothing of.
    """
    faces = same or mesh.connectivity.by_size[0]
    planes, thickness = Planes.of(mesh, faces), levels[1] - levels[0]
    lift = np.zeros(len(faces.numbers))
    over_hubs = np.zeros(len(lift), dtype=bool)
    if beams is not None:
        lift = _lift(mesh.connectivity, faces, beams, planes) + bed
        if stands is not None:
            over_hubs |= not stands.cut
            if stands.cut:
                both = np.stack([lift, lift + thickness])
                rings = _rings(mesh, faces, planes, both, gap, inward, depth)
                over_hubs = corner_cuts(planes, both, stands).through(*rings).gone(*rings)
            lift = np.where(over_hubs, np.maximum(lift, lift_over(planes, stands.hubs)), lift)
    lower = np.full(len(lift), levels[0]) if beams is None else lift
    both = np.stack([lower, lower + thickness])
    rings = _rings(mesh, faces, planes, both, gap, inward, depth)
    for ring in rings:
        _refuse_gap(gap, thickness, planes.flat, ring, wanted, faces.numbers)
    lines = uncut(*faces.faces.shape)
    if stands is not None:
        lines = corner_cuts(planes, both, stands).spared(over_hubs).through(*rings)
    lines.refuse_meeting(faces.numbers, *rings)
    outline = rings[0] if inward is None else _wider(rings[0], rings[1], planes.flat)
    low = np.concatenate([outline.min(axis=1), lower[:, None]], axis=1)
    origin = planes.middle + np.einsum("fd,fdk->fk", low, planes.frame)
    solid = [
        planes.in_space(lines.trimmed(ring), level) for ring, level in zip(rings, both, strict=True)
    ]
    return PanelGeometry(
        origin,
        planes,
        outline,
        rings[1],
        rings[0],
        both,
        lines,
        _distances(planes.flat, outline),
        joint_widths(mesh.connectivity, np.concatenate(solid, axis=2))
        if same is None
        else np.full(faces.faces.shape, np.inf),
        lift,
        over_hubs,
    )


def _rings(
    mesh: QuadMesh,
    faces: SameSize,
    planes: Planes,
    levels: FloatArray,
    gap: float,
    inward: FloatArray | None,
    depth: float,
) -> list[FloatArray]:
    """Outlines (F, 4, 2) of the lower and upper side of the panels at levels (2, F)."""
    if inward is None:
        taken = np.stack([levels[0] - depth, levels[1]])
        return [inset(planes.flat, _square_sides(mesh, faces, taken, gap))] * 2
    return [
        inset(planes.flat, _bevelled_sides(planes.frame, inward, level, gap)) for level in levels
    ]


def _wider(one: FloatArray, other: FloatArray, flat: FloatArray) -> FloatArray:
    """Outlines (F, 4, 2) that hold two others with parallel sides."""
    return inset(flat, np.minimum(_distances(flat, one), _distances(flat, other)))


def _distances(flat: FloatArray, ring: FloatArray) -> FloatArray:
    """(F, 4) how far the sides of an outline lie inwards of the face's."""
    along = unit_rows(np.roll(flat, -1, axis=1) - flat)
    arms = ring - flat
    return np.asarray(along[..., 0] * arms[..., 1] - along[..., 1] * arms[..., 0])


def joint_widths(connectivity: Connectivity, sides: FloatArray) -> FloatArray:
    """(F, 4) how far the sides of neighbouring plates (F, 4, 4, 3) are apart, inf at the boundary.

    Of faces of several sizes (H,) from sides (H, 4, 3), by half-edges.

    Measured square to the plane midway between the two sides, between their nearest corners: what
    stays clear whatever the lift and the angle of the plates. Of faces that are not planar the two
    sides rise differently, and that plane is turned about the upright to run along both.
    """
    here = sides.reshape(-1, 4, 3)
    start, end, high_start = here[:, 0], here[:, 1], here[:, 2]
    outward = unit_rows(np.cross(end - start, high_start - start))
    twins = np.where(connectivity.twins >= 0, connectivity.twins, 0)
    ahead = unit_rows(end - start)
    along = ahead - ahead[twins]
    midway = outward - outward[twins]
    share = np.einsum("hk,hk->h", midway, along) / np.maximum((along**2).sum(axis=1), 1e-12)
    across = np.stack([midway, midway - share[:, None] * along])
    across /= np.maximum(np.linalg.norm(across, axis=2, keepdims=True), 1e-12)
    near = np.einsum("hek,dhk->dhe", here, across).max(axis=2)
    far = np.einsum("hek,dhk->dhe", here[twins], across).min(axis=2)
    widths = np.where(connectivity.twins >= 0, (far - near).max(axis=0), np.inf)
    return widths.reshape(sides.shape[:-2])


def _square_sides(mesh: QuadMesh, faces: SameSize, levels: FloatArray, gap: float) -> FloatArray:
    """(F, 4) how far square sides move inwards, so that half of the gap stays clear."""
    corner = mesh.vertices[faces.faces]
    side = np.roll(corner, -1, axis=1) - corner
    across = neighbours(mesh.connectivity, faces)
    bend = _tangents(mesh.face_normals[faces.numbers], mesh.face_normals, side, across)
    closing = np.max([-level[:, None] * bend for level in levels] + [0 * bend], axis=0)
    sides = np.maximum(gap / 2, closing + gap / 4 * np.hypot(1.0, bend))
    return np.asarray(np.where(np.isnan(bend), gap / 2, sides))


def _bevelled_sides(
    frame: FloatArray, inward: FloatArray, level: FloatArray, gap: float
) -> FloatArray:
    """(F, 4) how far sides parallel to these planes move inwards at a level (F,)."""
    flat = np.linalg.norm(np.einsum("fck,fdk->fcd", inward, frame[:, :2]), axis=2)
    up = np.einsum("fck,fk->fc", inward, frame[:, 2])
    return np.asarray((gap / 2 - up * level[:, None]) / flat)


def neighbours(connectivity: Connectivity, same: SameSize | None = None) -> IntArray:
    """(F, 4) face across each side, -1 at the boundary; by default of all faces."""
    chosen = same or connectivity.by_size[0]
    twins = connectivity.twins[chosen.half_edges]
    return np.where(twins >= 0, connectivity.half_faces[twins], -1)


def half_angle_tangents(
    connectivity: Connectivity, normal: FloatArray, side: FloatArray
) -> FloatArray:
    """(F, 4) tan(theta / 2) across each side, positive at a ridge, NaN at the boundary."""
    return _tangents(normal, normal, side, neighbours(connectivity))


def _tangents(
    normal: FloatArray, normals: FloatArray, side: FloatArray, across: IntArray
) -> FloatArray:
    """The same of faces with these normals; those across (F, 4) have theirs in ``normals``."""
    other = normals[across]
    sine = np.einsum("fck,fck->fc", np.cross(normal[:, None], other), unit_rows(side))
    cosine = np.einsum("fk,fck->fc", normal, other)
    tangent = sine / np.maximum(1 + cosine, 1e-6)
    return np.where(across >= 0, tangent, np.nan)


def sides_of(connectivity: Connectivity, faces: SameSize) -> tuple[IntArray, BoolArray]:
    """(F, 4) edge number of each side, and whether the face is on its left."""
    edges = connectivity.half_edge_edges[faces.half_edges]
    return edges, connectivity.edge_faces[edges, 0] == faces.numbers[:, None]


def _lift(
    connectivity: Connectivity, faces: SameSize, beams: BeamGeometry, planes: Planes
) -> FloatArray:
    """(F,) how far the beams' upper sides stand above each face of the parallel mesh."""
    edges, on_left = sides_of(connectivity, faces)
    top = np.where(
        on_left[:, :, None, None],
        beams.points[:, LEFT_TOP][edges],
        beams.points[:, RIGHT_TOP][edges],
    )
    above = np.einsum("fcpk,fk->fcp", top - planes.middle[:, None, None], planes.frame[:, 2])
    return np.asarray(np.maximum(above.max(axis=(1, 2)), 0.0))


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


def _refuse_gap(
    gap: float,
    thickness: float,
    polygon: FloatArray,
    outline: FloatArray,
    wanted: BoolArray | None,
    numbers: IntArray,
) -> None:
    side = np.roll(polygon, -1, axis=1) - polygon
    left = np.roll(outline, -1, axis=1) - outline
    kept = np.einsum("fcd,fcd->fc", left, side) / np.einsum("fcd,fcd->fc", side, side)
    if wanted is not None:
        kept = np.where(wanted[:, None], kept, 1.0)
    if kept.min() <= 1e-3:
        face = int(np.argmin(kept.min(axis=1)))
        largest = gap / (1 - float(kept.min()))
        raise InputError(
            f"gap: {gap:g} mm with panels {thickness:g} mm thick leaves nothing "
            f"of face {numbers[face]}; take a gap below {rounded_down(largest)} mm or thinner "
            "panels"
        )
