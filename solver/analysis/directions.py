"""How the parameter lines of a mesh lie to the directions of curvature of its surface."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.analysis.curvature import vertex_areas
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows

# Part of the bending that is twist from which on lines lie nearer to asymptotic directions, which
# are conjugate to themselves, than to two that are conjugate to each other: M^2 = L^2 + N^2.
_ASYMPTOTIC = 2 / 3
# A surface that turns by less than this from vertex to vertex, in radians, has no directions.
_FLAT = 1e-4
_DAMPING = 1e-10


@dataclass(frozen=True)
class Directions:
    """How lines lie to the principal directions, averaged over a mesh.

    Attributes:
        twist: part of the bending that is twist along the lines: sum of 2 M^2 over the sum of
            L^2 + 2 M^2 + N^2, where L, M, N is the second fundamental form along the lines. Zero
            where they follow the principal directions, one where they are asymptotic and cross at
            right angles.
        angle: between the lines and the nearest principal direction, 0 to 45 degrees; vertices
            count by the square of the difference of their principal curvatures. Zero where these
            are equal all over.
    """

    twist: float
    angle: float


def directions(mesh: QuadMesh, diagonal: bool = False) -> Directions:
    """Compare the lines of a mesh, or of its diagonal meshes, with the principal directions.

    A quadric through each star and the opposite corners of its faces gives the second fundamental
    form. Lines that do not cross at right angles count by the cross nearest to them.
    """
    net, form = mesh.connectivity, _second_forms(mesh)
    if not len(net.stars):
        return Directions(0.0, 0.0)
    weight = vertex_areas(mesh)[net.stars[:, 0]]
    turned = form.half_difference * np.exp(-2j * form.cross_angles(mesh, diagonal))
    twist = weight @ (2 * turned.imag**2)
    bending = weight @ (2 * np.abs(form.half_difference) ** 2 + 2 * form.mean**2)
    if bending <= _FLAT**2 * weight.sum() / mesh.mean_edge**2:
        return Directions(0.0, 0.0)
    alignment = weight @ (turned**2).real
    whole = weight @ np.abs(turned) ** 2
    cosine = alignment / whole if whole > _FLAT**2 * bending else 1.0
    angle = np.degrees(np.arccos(np.clip(cosine, -1, 1))) / 4
    return Directions(float(twist / bending), float(angle))


def asymptotic_share(mesh: QuadMesh) -> float:
    """Part of the area where the lines run along the asymptotic directions, nearly.

    Flat faces ask for lines that are conjugate: the tangent planes along a line of one family meet
    in the directions of the other. No such lines are near there.

    Source: Liu et al. (2006), Geometric modeling with conical meshes and developable surfaces,
    section 2.
    """
    if not len(mesh.connectivity.stars):
        return 0.0
    form, weight = _second_forms(mesh), vertex_areas(mesh)[mesh.connectivity.stars[:, 0]]
    turned = form.half_difference * np.exp(-2j * form.cross_angles(mesh, False))
    bending = 2 * np.abs(form.half_difference) ** 2 + 2 * form.mean**2
    curved = bending > _FLAT**2 / mesh.mean_edge**2
    along = curved & (2 * turned.imag**2 > _ASYMPTOTIC * bending)
    return float(weight[along].sum() / weight.sum())


def across_asymptotic(mesh: QuadMesh, diagonal: bool = False) -> tuple[float, float]:
    """How far lines are from asymptotic ones, and on which part of the area there are such.

    The first number is the sum of the squared normal curvatures along both lines over that along
    the principal ones: 0 of asymptotic lines, 1 of lines of curvature. Both count by area.
    """
    net = mesh.connectivity
    if not len(net.stars):
        return 0.0, 1.0
    form, weight = _second_forms(mesh), vertex_areas(mesh)[net.stars[:, 0]]
    angles = form.line_angles(mesh, diagonal)
    along = form.mean[:, None] + (form.half_difference[:, None] * np.exp(-2j * angles)).real
    bending = 2 * np.abs(form.half_difference) ** 2 + 2 * form.mean**2
    if weight @ bending <= _FLAT**2 * weight.sum() / mesh.mean_edge**2:
        return 0.0, 1.0
    saddle = np.abs(form.half_difference) > np.abs(form.mean)
    share = weight @ (along**2).sum(axis=1) / (weight @ bending)
    return float(share), float(weight[saddle].sum() / weight.sum())


@dataclass(frozen=True, eq=False)
class _SecondForms:
    """Second fundamental forms at the stars of a mesh, (S,) each.

    Attributes:
        half_difference: (L - N) / 2 + i M in the frame; its argument is twice the angle to the
            first principal direction.
        mean: (L + N) / 2.
        frame: (S, 2, 3) unit vectors in the tangent plane.
    """

    half_difference: np.ndarray
    mean: FloatArray
    frame: FloatArray

    def cross_angles(self, mesh: QuadMesh, diagonal: bool) -> FloatArray:
        """(S,) angle of the right-angled cross nearest to the two lines through each star."""
        angles = self.line_angles(mesh, diagonal)
        return np.asarray(np.angle(np.exp(4j * angles).sum(axis=1)) / 4)

    def line_angles(self, mesh: QuadMesh, diagonal: bool) -> FloatArray:
        """(S, 2) angles of the two lines through each star."""
        net = mesh.connectivity
        points = mesh.vertices[net.diagonal_stars if diagonal else net.stars]
        along = np.einsum("slk,sak->sla", points[:, 1:3] - points[:, 3:5], self.frame)
        return np.asarray(np.arctan2(along[:, :, 1], along[:, :, 0]))


def _second_forms(mesh: QuadMesh) -> _SecondForms:
    net = mesh.connectivity
    centre = net.stars[:, 0]
    normal = mesh.vertex_normals[centre]
    spoke = mesh.vertices[net.stars[:, 1]] - mesh.vertices[net.stars[:, 3]]
    first = unit_rows(spoke - np.einsum("sk,sk->s", spoke, normal)[:, None] * normal)
    frame = np.stack([first, np.cross(normal, first)], axis=1)
    around = np.concatenate([net.stars[:, 1:], net.diagonal_stars[:, 1:]], axis=1)
    # In mean edges, so that no unit makes the fit worse.
    offset = (mesh.vertices[around] - mesh.vertices[centre][:, None]) / mesh.mean_edge
    x, y = np.einsum("snk,sak->asn", offset, frame)
    height = np.einsum("snk,sk->sn", offset, normal)
    terms = np.stack([x, y, 0.5 * x * x, x * y, 0.5 * y * y], axis=2)
    # A little damping for stars whose neighbours lie on one conic.
    square = np.einsum("snp,snq->spq", terms, terms) + _DAMPING * np.eye(5)
    right = np.einsum("snp,sn->sp", terms, height)
    fit = np.linalg.solve(square, right[:, :, None])[:, :, 0].T / mesh.mean_edge
    return _SecondForms((fit[2] - fit[4]) / 2 + 1j * fit[3], (fit[2] + fit[4]) / 2, frame)
