"""A bent sheet of a given thickness as a solid."""

from __future__ import annotations

import numpy as np

from freecad_ortho.fabrication.ruled import RuledBody
from solver.analysis.curvature import mean_curvature
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows

# Angle of a bend line below which a sheet is flat there, radians.
_BENT = 1e-6


def half_thicknesses(mesh: QuadMesh, thickness: float) -> FloatArray:
    """(V, 3) from a net to the upper side of its plates.

    Along the vertex normals, as far as keeps the thickness in the faces around; pieces on both
    sides of a cut share them, so they touch and do not overlap.
    """
    normals, faces, count = mesh.vertex_normals, mesh.faces, len(mesh.vertices)
    cosine = np.einsum("fck,fk->fc", normals[faces], mesh.face_normals)
    around = np.maximum(np.bincount(faces.ravel(), minlength=count), 1)
    mean = np.bincount(faces.ravel(), cosine.ravel(), count) / around
    return np.asarray(0.5 * thickness * normals / np.maximum(mean, 0.1)[:, None])


def sheet_body(mesh: QuadMesh, half: FloatArray, thickness: float, name: str) -> RuledBody:
    """Thicken a mesh by half to each side; faces that are not plane become ruled sides.

    Args:
        mesh: with a boundary, mm.
        half: (V, 3) from the mesh to the upper side.
        thickness: mm.
        name: of the part, for the message.

    Raises:
        InputError: the sheet is bent more sharply than its thickness allows.
    """
    net, faces, count = mesh.connectivity, mesh.faces, len(mesh.vertices)
    corners = np.concatenate([mesh.vertices - half, mesh.vertices + half])
    _refuse_folds(mesh, corners.reshape(2, count, 3), thickness, name)
    sides = [tuple(reversed(face)) for face in faces.tolist()]
    sides += [tuple(face) for face in (faces + count).tolist()]
    on_boundary = net.boundary_edges[net.face_edges]
    for face, side in np.argwhere(on_boundary).tolist():
        start, end = int(faces[face, side]), int(faces[face, (side + 1) % 4])
        sides.append((start, end, end + count, start + count))
    blocks = tuple(
        corners[[*face, *(corner + count for corner in face)]] for face in faces.tolist()
    )
    return RuledBody(corners, tuple(sides), blocks=blocks)


def smallest_radius(mesh: QuadMesh) -> float:
    """Smallest radius of a developable mesh, inf where it is flat.

    At inner vertices 1 / (2 H); in a row of faces, which has none, that of its bend lines.
    """
    curvature = np.abs(mean_curvature(mesh))
    inner = 2 * curvature[np.isfinite(curvature)]
    if not len(inner):
        inner = _across_bend_lines(mesh)
    sharpest = float(inner.max()) if len(inner) else 0.0
    return 1 / sharpest if sharpest * mesh.mean_edge > 1e-9 else np.inf


def _across_bend_lines(mesh: QuadMesh) -> FloatArray:
    """(I,) principal curvature at each inner edge of a developable mesh.

    Across the edge the mesh has the curvature L, the angle between its faces over the distance of
    their middles. Where the rulings slant, faces warp: with the twist M of the faces and L N = M^2
    the principal curvature is L + N.
    """
    net, corner = mesh.connectivity, mesh.vertices[mesh.faces]
    edges = np.flatnonzero((net.edge_faces >= 0).all(axis=1))
    sides = net.edge_faces[edges]
    start, end = np.moveaxis(mesh.vertices[net.edges[edges]], 1, 0)
    along = unit_rows(end - start)
    arms = corner.mean(axis=1)[sides] - start[:, None]
    arms = arms - np.einsum("isk,ik->is", arms, along)[..., None] * along[:, None]
    one, two = np.moveaxis(mesh.face_normals[sides], 1, 0)
    angle = np.arctan2(np.linalg.norm(np.cross(one, two), axis=1), np.einsum("ik,ik->i", one, two))
    across = angle / np.linalg.norm(arms, axis=2).sum(axis=1)
    mixed = np.einsum("fck,c,fk->f", corner, [1.0, -1.0, 1.0, -1.0], mesh.face_normals)
    warp = (mixed / np.linalg.norm(mesh.face_area_vectors, axis=1))[sides]
    bent = across * mesh.mean_edge > _BENT
    along_it = np.divide((warp**2).mean(axis=1), across, out=np.zeros(len(edges)), where=bent)
    return np.asarray(across + along_it)


def _refuse_folds(mesh: QuadMesh, layers: FloatArray, thickness: float, name: str) -> None:
    """Refuse a thickness at which a side of the sheet folds over."""
    for points in layers:
        corner = points[mesh.faces]
        after, before = np.roll(corner, -1, axis=1) - corner, np.roll(corner, 1, axis=1) - corner
        upright = np.einsum("fck,fk->fc", np.cross(after, before), mesh.face_normals)
        if (upright <= 0).any():
            face = int((upright <= 0).any(axis=1).argmax())
            raise InputError(
                f"patches: {name} is bent more sharply than {thickness:g} mm of thickness allow, "
                f"at its face {face}; take a thinner plate"
            )
