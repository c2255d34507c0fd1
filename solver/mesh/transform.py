"""Similarities and Moebius transformations of a mesh; vertex and face numbers stay."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial.transform import Rotation

from solver.errors import InputError
from solver.mesh.mirror import size_of
from solver.mesh.quadmesh import QuadMesh
from solver.option import number_within


def similarity(
    mesh: QuadMesh,
    *,
    scale: float = 1.0,
    degrees: ArrayLike = (0.0, 0.0, 0.0),
    move: ArrayLike = (0.0, 0.0, 0.0),
    centre: ArrayLike = (0.0, 0.0, 0.0),
) -> QuadMesh:
    """Scale and turn about a centre, then move.

    Args:
        mesh: the mesh.
        scale: positive factor.
        degrees: angles about x, then y, then z (fixed axes).
        move: (3,) translation, in the model's unit.
        centre: (3,) fixed point of scale and turn.

    Raises:
        InputError: a scale that is not positive, or vectors of another shape.
    """
    number_within("scale", scale)
    angles, shift, fixed = (
        _vector(name, value)
        for name, value in (("turn", degrees), ("move", move), ("centre", centre))
    )
    turn = Rotation.from_euler("xyz", angles, degrees=True).as_matrix()
    return mesh.with_vertices(scale * (mesh.vertices - fixed) @ turn.T + fixed + shift)


def inverted(mesh: QuadMesh, centre: ArrayLike, radius: float) -> QuadMesh:
    """Inversion in a sphere, the generator of all Moebius transformations.

    Circles and spheres go to circles and spheres: circular meshes stay circular exactly, S-nets
    stay S-nets, and principal meshes stay principal to the order in which they are circular.
    Faces are turned over, so that what was outside the surface stays outside it unless it held the
    centre.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, figure 10.

    Raises:
        InputError: a radius that is not positive, or a vertex at the centre.
    """
    fixed = _vector("centre", centre)
    number_within("radius", radius)
    arms = mesh.vertices - fixed
    squares = (arms**2).sum(axis=1)
    near = int(np.argmin(squares))
    if squares[near] <= (1e-9 * size_of(mesh.vertices)) ** 2:
        raise InputError(
            f"centre: vertex {near} lies at the centre of inversion and would go to infinity; "
            "move the centre"
        )
    image = fixed + arms * (radius**2 / squares)[:, None]
    return QuadMesh(image, mesh.faces[:, [1, 0, 3, 2]])


def moebius(mesh: QuadMesh, centre: ArrayLike, strength: float = 1.0) -> QuadMesh:
    """Moebius transformation that keeps the mesh's place and size: an inversion, then a mirror.

    The inversion sphere passes through the mesh's mean point, and the mirror plane is the sphere's
    tangent plane there, so that the mean point and the orientation stay and the neighbourhood is
    not scaled.

    Args:
        mesh: the mesh.
        centre: (3,) centre of the inversion, off the mesh; nearer distorts more.
        strength: moves the centre away, to the given distance / strength.

    Raises:
        InputError: a centre at the mean point or at a vertex, or a strength that is not positive.
    """
    number_within("strength", strength)
    middle = mesh.vertices[mesh.connectivity.referenced].mean(axis=0)
    arm = (_vector("centre", centre) - middle) / strength
    distance = float(np.linalg.norm(arm))
    if not distance > 1e-9 * size_of(mesh.vertices):
        raise InputError("centre: lies at the mean point of the mesh; move it off the mesh")
    turned = inverted(mesh, middle + arm, distance)
    normal = arm / distance
    height = (turned.vertices - middle) @ normal
    mirrored = turned.vertices - 2 * height[:, None] * normal
    return QuadMesh(mirrored, mesh.faces)


def _vector(name: str, value: ArrayLike) -> np.ndarray:
    array = np.asarray(value, dtype=np.float64)
    if array.shape != (3,) or not np.isfinite(array).all():
        raise InputError(f"{name}: expected three finite numbers, got {array.tolist()}")
    return array
