"""A field of four directions on a triangle mesh that follows its lines of curvature.

In each triangle a direction and its three quarter turns, as the complex number ``exp(4 i angle)``
in the triangle's frame. It is as smooth as it can be and near to the curvature lines where these
are certain: where both curvatures are alike, neighbours decide.

Source: Knoeppel, Crane, Pinkall, Schroeder (2013), Globally optimal direction fields.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from scipy.sparse import coo_array, diags_array
from scipy.sparse.linalg import splu
from scipy.spatial import cKDTree

from solver.align.triangle_mesh import TriangleMesh
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray

QUARTER = np.pi / 2
# Where curvatures differ by this part of what they differ by on half the surface, they are certain.
_CERTAIN = 0.5
# The least that curvature says anywhere, so that the system is never singular.
_WHISPER = 1e-6
# What is said beyond the border is a guess.
_BEYOND = 0.5
# What a field may stray more for each singular vertex less.
_STRAYS = 0.05
# Least part of the larger curvature that the other one counts as: lines cross at 25 degrees at
# least.
_SLIGHT = 0.05
# Edges that two singular vertices should be apart.
_APART = 2.5
# Distances, in edges, round singular vertices within which the guide may be silenced.
_REACHES = (2.0, 4.0, 7.0, 11.0)


@dataclass(frozen=True, eq=False)
class GuidingField:
    """What the directions should be, and how much that counts.

    Attributes:
        angles: (T,) in each triangle's frame.
        certainty: (T,) 0 to 1.
        stretch: (T,) how different the curvatures are, 1 at the middle of all.
        inner: how many of the triangles are the surface's own.
        skew: (T, 2, 2) map from right-angled crosses to directions of lines that cross at other
            angles, in each triangle's frame; None where they cross at right angles.
    """

    angles: FloatArray
    certainty: FloatArray
    stretch: FloatArray
    inner: int
    skew: FloatArray | None = None

    @property
    def firmness(self) -> FloatArray:
        """(T,) how much the lines of a map have to follow, 0 to 1."""
        return np.minimum(1.0, self.stretch**2)

    def calmed(self, part: float) -> GuidingField:
        """The same that counts less."""
        return replace(self, certainty=part * self.certainty)


@dataclass(frozen=True, eq=False)
class DirectionField:
    """Directions, and where they cannot be continued.

    Attributes:
        angles: (T,) of one of the four directions, in each triangle's frame.
        quarters: (V,) 1 where a net has a vertex with three faces, -1 five, -2 six; 0 elsewhere
            and at the border.
    """

    angles: FloatArray
    quarters: IntArray


def curvature_guide(
    mesh: TriangleMesh, tensors: FloatArray, inner: int, turn: float
) -> GuidingField:
    """Directions of largest curvature, turned by an angle.

    Args:
        mesh: the surface, with its apron.
        tensors: (T, 2, 2) shape operators in the triangles' frames.
        inner: how many of the triangles are the surface's own.
        turn: angle in radians, a quarter of pi for lines of no curvature on minimal surfaces.
    """
    real = (tensors[:, 0, 0] - tensors[:, 1, 1]) / 2
    size = np.hypot(real, tensors[:, 0, 1])
    angles = np.arctan2(tensors[:, 0, 1], real) / 2 + turn
    order = np.argsort(size[:inner])
    halfway = np.cumsum(mesh.areas[:inner][order])
    middle = size[order[np.searchsorted(halfway, halfway[-1] / 2)]]
    stretch = size / max(middle, np.finfo(float).tiny)
    certainty = np.minimum(1.0, (stretch / _CERTAIN) ** 2)
    certainty[inner:] *= _BEYOND
    return GuidingField(angles, certainty, stretch, inner)


def asymptotic_skew(tensors: FloatArray) -> FloatArray:
    """(T, 2, 2) what turns crosses at 45 degrees to curvature into the asymptotic directions.

    Where the curvatures are k and l, asymptotic lines run at an angle a to the direction of k with
    tan(a)^2 = -k / l; the map stretches by cos(a) and sin(a) along the principal directions, times
    the square root of two. Its determinant is the sine of the angle between the lines.

    Args:
        tensors: (T, 2, 2) shape operators in the triangles' frames.
    """
    bent, axes = np.linalg.eigh(tensors)
    size = np.abs(bent)
    # Where the surface is nearly flat, or bends in one direction only, nothing is to be divided by.
    least = np.maximum(_SLIGHT * size.max(axis=1, keepdims=True), np.finfo(float).tiny)
    size = np.sqrt(np.maximum(size, least))
    stretch = np.sqrt(2) * size[:, ::-1] / np.linalg.norm(size, axis=1, keepdims=True)
    return np.asarray(np.einsum("tik,tk,tjk->tij", axes, stretch, axes))


def smooth_field(
    mesh: TriangleMesh, guide: GuidingField, edge: float, step: Callable[[], object] = lambda: None
) -> DirectionField:
    """Find the smooth field near the guide, with the fewest singular vertices that it needs.

    The guide is made to count less round singular vertices, further and further; what has fewer is
    kept, and of as many what has them further apart, since a net needs edges between them.

    Args:
        mesh: the surface, with its apron.
        guide: wanted directions.
        edge: wanted edge length; what turns within less is smoothed away.
        step: called before each further field; what it raises is passed on.
    """
    certainty = guide.certainty
    field = _solved(mesh, guide.angles, certainty, edge)
    outside = np.ones(len(mesh.points), dtype=bool)
    outside[mesh.triangles[: guide.inner]] = False
    # Beyond the border nothing has to be followed where that is not simple.
    within = certainty * (np.arange(len(certainty)) < guide.inner)
    if field.quarters[outside].any():
        certainty = within
        step()
        field = _solved(mesh, guide.angles, certainty, edge)
    worth, strayed = _worth(mesh, field, edge), _strayed(mesh, guide, field)
    centres = mesh.centres
    for reach in _REACHES:
        singular = np.flatnonzero(field.quarters)
        if worth == (0, 0.0):
            break
        far = cKDTree(mesh.points[singular]).query(centres)[0]
        less = np.minimum(certainty, within * np.minimum(1.0, (far / reach / edge) ** 4))
        step()
        trial = _solved(mesh, guide.angles, less, edge)
        found = _worth(mesh, trial, edge)
        more = _strayed(mesh, guide, trial) - strayed
        if found < worth and more < _STRAYS * max(1, worth[0] - found[0]):
            field, certainty, worth = trial, less, found
    return field


def _strayed(mesh: TriangleMesh, guide: GuidingField, field: DirectionField) -> float:
    """How far a field leaves its guide where that is certain: 0 not, 1 as any other field."""
    weight = (guide.certainty * mesh.areas)[: guide.inner]
    apart = 1 - np.cos(4 * (field.angles - guide.angles)[: guide.inner])
    return float((weight * apart).sum() / weight.sum())


def _worth(mesh: TriangleMesh, field: DirectionField, edge: float) -> tuple[int, float]:
    """Number of singular vertices, and by how many edges two of them are too near to each other."""
    singular = mesh.points[field.quarters != 0]
    if len(singular) < 2:
        return len(singular), 0.0
    nearest = float(cKDTree(singular).query(singular, k=2)[0][:, 1].min())
    return len(singular), max(0.0, _APART - nearest / edge)


def turns(mesh: TriangleMesh, angles: FloatArray) -> tuple[IntArray, FloatArray]:
    """How directions go over inner edges.

    Returns:
        (E,) quarter turns from the first triangle's direction, carried over, to the second's, and
        (E,) the angle that is left.
    """
    first, second = (mesh.edges // 3).T
    difference = angles[second] - angles[first] - _carried(mesh)
    quarter = np.round(difference / QUARTER)
    return quarter.astype(np.int64), difference - quarter * QUARTER


def _carried(mesh: TriangleMesh) -> FloatArray:
    """(E,) what an angle in the first triangle's frame grows by in the second's."""
    start, end = mesh.ends
    along = mesh.points[end] - mesh.points[start]
    one, two = (
        np.arctan2(
            (along * mesh.axes[side, 1]).sum(axis=1), (along * mesh.axes[side, 0]).sum(axis=1)
        )
        for side in (mesh.edges // 3).T
    )
    carried: FloatArray = two - one
    return carried


def _solved(
    mesh: TriangleMesh, angles: FloatArray, certainty: FloatArray, edge: float
) -> DirectionField:
    first, second = (mesh.edges // 3).T
    weight, carried = smoothness(mesh), np.exp(4j * _carried(mesh))
    held = np.maximum(certainty, _WHISPER) * mesh.areas / edge**2
    count = len(mesh.triangles)
    rows = np.concatenate([first, second, first, second])
    columns = np.concatenate([first, second, second, first])
    values = np.concatenate([weight, weight, -weight * carried.conj(), -weight * carried])
    matrix = coo_array((values, (rows, columns)), shape=(count, count)) + diags_array(held)
    factors = splu(
        matrix.tocsc(),
        permc_spec="MMD_AT_PLUS_A",
        diag_pivot_thresh=0.0,
        options={"SymmetricMode": True},
    )
    found = np.angle(factors.solve(held * np.exp(4j * angles))) / 4
    return DirectionField(found, quarters_of(mesh, found))


def smoothness(mesh: TriangleMesh) -> FloatArray:
    """(E,) how much a turn over each inner edge counts: its length over the way across it."""
    start, end = (mesh.points[side] for side in mesh.ends)
    length = np.linalg.norm(end - start, axis=1)
    centres = mesh.centres
    across = sum(
        np.linalg.norm(np.cross(centres[side] - start, end - start), axis=1) / length
        for side in (mesh.edges // 3).T
    )
    weight: FloatArray = length / across
    return weight


def quarters_of(mesh: TriangleMesh, angles: FloatArray) -> IntArray:
    """(V,) by how many quarter turns directions (T,) miss themselves round each inner vertex."""
    left = turns(mesh, angles)[1]
    corners = mesh.points[mesh.triangles]
    missing = np.full(len(mesh.points), 2 * np.pi)
    for k in range(3):
        one, two = (corners[:, (k + other) % 3] - corners[:, k] for other in (1, 2))
        angle = np.arctan2(np.linalg.norm(np.cross(one, two), axis=1), (one * two).sum(axis=1))
        np.subtract.at(missing, mesh.triangles[:, k], angle)
    start, end = mesh.ends
    np.subtract.at(missing, start, left)
    np.add.at(missing, end, left)
    missing[mesh.on_rim] = 0.0
    quarters: IntArray = np.round(missing / QUARTER).astype(np.int64)
    # Directions that go once round themselves go over into each other: only the mesh is at fault.
    return np.where(quarters % 4 == 0, 0, quarters)
