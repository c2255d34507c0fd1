"""A bent sheet of a given thickness as a solid."""

from __future__ import annotations

import numpy as np

from freecad_ortho.fabrication.ruled import RuledBody
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray, QuadMesh


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


def _refuse_folds(mesh: QuadMesh, sides: FloatArray, thickness: float, name: str) -> None:
    """Refuse a thickness at which a side of the sheet folds over."""
    for points in sides:
        corner = points[mesh.faces]
        after, before = np.roll(corner, -1, axis=1) - corner, np.roll(corner, 1, axis=1) - corner
        upright = np.einsum("fck,fk->fc", np.cross(after, before), mesh.face_normals)
        if (upright <= 0).any():
            face = int((upright <= 0).any(axis=1).argmax())
            raise InputError(
                f"patches: {name} is bent more sharply than {thickness:g} mm of thickness allow, "
                f"at its face {face}; take a thinner plate"
            )
