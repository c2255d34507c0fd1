"""Quadric, curve and t values of the multi-net nearest to a mesh."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

from solver.errors import InputError
from solver.mesh.grid import grid_mesh, grid_of
from solver.mesh.mirror import size_of
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.multinet.net import MultiNet
from solver.multinet.polyline import multi_net
from solver.multinet.quadric import Quadric

# A line flatter than this, thickness over length, determines no quadric.
_FLAT = 1e-5
# A net that misses the mesh by more than this part of its size is no fit.
_FAR = 0.1


@dataclass(frozen=True, eq=False)
class MultiNetFit:
    """The multi-net that was fitted.

    Attributes:
        net: its smooth form; sample it anew at will.
        s: (M,) curve parameters of the lines of the mesh.
        t: (N,) t values, 0 on the least planar line.
        transposed: the curve runs along v of the mesh, not along u.
        mesh: the exact multi-net at these parameters, numbered like the mesh.
        deviation: largest distance between the vertices of both, in the model's unit.
    """

    net: MultiNet
    s: FloatArray
    t: FloatArray
    transposed: bool
    mesh: QuadMesh
    deviation: float

    @property
    def quadric(self) -> Quadric:
        """The quadric of the curve."""
        return self.net.quadric


def fit_multi_net(mesh: QuadMesh) -> MultiNetFit:
    """Fit a quadric, a polyline on it and t values to a mesh of grid type.

    The lines of a multi-net are affine images of each other (D Eq. 2), v_l = A_l v_0 + a_l with
    A_l^2 - I = t_l S: a linear fit of the A_l, a rank-one fit of all A_l^2 - I and a linear fit of
    the centre give a start; least squares over quadric and t refine it, the curve eliminated.

    Raises:
        InputError: not of grid type, or all parameter lines are planar (rotational and planar nets
            have no unique quadric).
    """
    grid = grid_of(mesh)
    points = grid.points(mesh)
    shift, size = points.reshape(-1, 3).mean(axis=0), size_of(points.reshape(-1, 3))
    scaled = (points - shift) / size
    families = [_thickest(scaled.transpose(1, 0, 2)), _thickest(scaled)]
    if max(families)[0] < _FLAT:
        raise InputError(
            "fit: all parameter lines are planar, which leaves the quadric open; "
            "build rotational and planar multi-nets from their profile or conics instead"
        )
    transposed = families[1][0] > families[0][0]
    base = families[transposed][1]
    if transposed:
        scaled = scaled.transpose(1, 0, 2)
    closed = grid.closed_v if transposed else grid.closed_u
    try:
        quadric, t = _refined(scaled, base, *_start(scaled, base))
        curve = quadric.from_frame(_curve(scaled, quadric, t))
        centre = quadric.centre * size + shift
        real = Quadric(quadric.curvatures / size**2, quadric.rotation, centre)
        net = multi_net(real, curve * size + shift, closed=closed)
    except (InputError, np.linalg.LinAlgError):
        raise _no_fit() from None
    s = np.arange(len(curve)) / (len(curve) - 1 + closed)
    t = np.clip(t * size**2, *real.admissible)
    exact = net.points(s, t)
    ordered = exact.transpose(1, 0, 2) if transposed else exact
    deviation = float(np.linalg.norm(ordered - points, axis=2).max())
    if deviation > _FAR * size:
        raise _no_fit()
    result = grid_mesh(ordered, grid.closed_u, grid.closed_v)
    vertices = np.empty_like(mesh.vertices)
    vertices[grid.numbers.ravel()] = result.vertices
    return MultiNetFit(net, s, t, transposed, mesh.with_vertices(vertices), deviation)


def _no_fit() -> InputError:
    return InputError(
        "fit: no central quadric fits the lines: they lie on paraboloids, or cross a "
        "symmetry plane of the quadric (cut the mesh there), or the mesh is far from a "
        "multi-net (check it first)"
    )


def _thickness(line: FloatArray) -> float:
    values = np.linalg.svd(line - line.mean(axis=0), compute_uv=False)
    return float(values[2] / values[0]) if len(values) > 2 and len(line) > 3 else 0.0


def _thickest(lines: FloatArray) -> tuple[float, int]:
    """How far the least planar line is from planar, and its number."""
    values = [_thickness(line) for line in lines]
    # The middle one where they are alike.
    order = sorted(range(len(lines)), key=lambda k: abs(k - len(lines) // 2))
    best = max(order, key=lambda k: round(values[k], 3))
    return values[best], best


def _start(points: FloatArray, base: int) -> tuple[Quadric, FloatArray]:
    """Quadric and (N,) t values, 0 on line ``base``, by linear steps from (M, N, 3) points."""
    known = np.column_stack([points[:, base], np.ones(len(points))])
    affine = np.stack([np.linalg.lstsq(known, line)[0] for line in points.transpose(1, 0, 2)])
    maps = 0.5 * (affine[:, :3] + affine[:, :3].transpose(0, 2, 1))
    excess = maps @ maps - np.eye(3)
    left, values, right = np.linalg.svd(excess.reshape(-1, 9), full_matrices=False)
    shape, t = right[0].reshape(3, 3), left[:, 0] * values[0]
    centre = np.linalg.lstsq((np.eye(3) - maps).reshape(-1, 3), affine[:, 3].ravel())[0]
    arms = points[:, base] - centre
    level = float(np.einsum("ix,xy,iy->i", arms, shape, arms).mean())
    axes = np.linalg.eigh(shape / level)
    rotation = axes[1] * np.linalg.det(axes[1])
    t = (t - t[base]) * level
    return Quadric(axes[0], rotation, centre), t


def _refined(
    points: FloatArray, base: int, quadric: Quadric, t: FloatArray
) -> tuple[Quadric, FloatArray]:
    free = np.delete(np.arange(len(t)), base)

    def build(x: FloatArray) -> tuple[Quadric, FloatArray]:
        turn = Rotation.from_rotvec(x[:3]).as_matrix()
        values = np.zeros(len(t))
        values[free] = x[9:]
        return Quadric(x[6:9], turn @ quadric.rotation, x[3:6]), values

    def residual(x: FloatArray) -> FloatArray:
        there, values = build(x)
        return np.asarray(_predicted(points, there, values) - points).ravel()

    start = np.concatenate([np.zeros(3), quadric.centre, quadric.curvatures, t[free]])
    result = least_squares(residual, start, x_scale="jac", xtol=1e-15, ftol=1e-15, max_nfev=30)
    return build(result.x)


def _curve(points: FloatArray, quadric: Quadric, t: FloatArray) -> FloatArray:
    """(M, 3) best curve points on the quadric, in its frame."""
    factors = np.sqrt(np.maximum(1.0 + t[:, None] * quadric.curvatures, 0.0))
    frame = quadric.to_frame(points)
    curve = (frame * factors).sum(axis=1) / (factors**2).sum(axis=0)
    value = (curve**2 * quadric.curvatures).sum(axis=1)
    return np.asarray(curve / np.sqrt(np.maximum(value, 1e-9))[:, None])


def _predicted(points: FloatArray, quadric: Quadric, t: FloatArray) -> FloatArray:
    factors = np.sqrt(np.maximum(1.0 + t[:, None] * quadric.curvatures, 0.0))
    return quadric.from_frame(_curve(points, quadric, t)[:, None] * factors)
