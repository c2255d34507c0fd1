"""Whether a mesh is a multi-net, and which one is nearest."""

from __future__ import annotations

import numpy as np
import pytest

from solver import InputError, QuadMesh
from solver.mesh.coarsen import trimmed
from solver.mesh.grid import grid_mesh, grid_of
from solver.mesh.primitives import primitive
from solver.multinet import (
    elliptic_net,
    fit_multi_net,
    is_multi_net,
    multi_net_residual,
    rotational_net,
)
from solver.multinet.presets import PRESETS
from tests.conftest import wavy_grid
from tests.solver.multinet.test_multi_nets import worst_of_all


def net_mesh(m: int = 15, n: int = 9, moving: str = "lambda", name: str = "arch") -> QuadMesh:
    return elliptic_net((9, 5, 2), moving, PRESETS[name].curve, unfolded=True).sampled(m, n)


def shaken(mesh: QuadMesh, amount: float, seed: int = 0) -> QuadMesh:
    noise = np.random.default_rng(seed).normal(size=mesh.vertices.shape)
    return mesh.with_vertices(mesh.vertices + amount * noise)


@pytest.mark.parametrize("shape", [(15, 9), (6, 14), (2, 2), (3, 7)])
@pytest.mark.parametrize("amount", [1e-9, 1e-4, 0.1])
def test_residual_is_the_maximum_over_all_rectangles(shape, amount):
    for seed in range(3):
        mesh = shaken(net_mesh(*shape), amount, seed)
        found = multi_net_residual(mesh)
        points = mesh.vertices.reshape(*shape, 3)
        assert found.worst == pytest.approx(worst_of_all(points), rel=1e-9, abs=2e-15)
        assert found.bound == found.worst
        i, j, k, line = found.rectangle
        a, b, c, d = points[i, j], points[k, line], points[k, j], points[i, line]
        size = np.linalg.norm(np.ptp(mesh.vertices, axis=0))
        violation = abs(((b - a) ** 2).sum() - ((c - d) ** 2).sum()) / size**2
        assert violation == pytest.approx(found.worst, rel=1e-9, abs=2e-15)


def test_one_moved_vertex_far_from_everything_is_found():
    mesh = net_mesh(30, 25)
    bent = mesh.vertices.copy()
    bent[7 * 25 + 11] += [0, 0, 1e-7]
    found = multi_net_residual(mesh.with_vertices(bent))
    assert found.worst == pytest.approx(worst_of_all(bent.reshape(30, 25, 3)), rel=1e-6)
    i, j, k, line = found.rectangle
    assert {(7, 11)} <= {(i, j), (k, line), (k, j), (i, line)}
    assert not is_multi_net(mesh.with_vertices(bent))
    assert is_multi_net(mesh)


def test_exact_nets_are_certified_without_visits():
    mesh = net_mesh(60, 50)
    found = multi_net_residual(mesh)
    assert found.visited == 1
    assert found.bound < 1e-14
    assert is_multi_net(rotational_net([(3, 0), (2, 1), (2.5, 1.7)], 9))
    assert multi_net_residual(wavy_grid(9, 8)).worst > 1e-3


def test_orthogonal_in_each_face_is_not_enough():
    """Rectangles of two widths side by side: every face has equal diagonals, the pair has not."""
    fold = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0.0]])
    lift = np.array([0.0, 0.0, 1.0])
    lean = np.array([0.0, 0.6, 0.8])
    points = np.stack([fold, fold + lift, fold + lift + lean], axis=1)
    points[2, 2] = points[1, 2] + [0, 0.3, 0.1]
    assert not is_multi_net(grid_mesh(points))


def test_rows_and_columns_are_found_under_any_numbering():
    mesh = net_mesh(7, 5)
    rng = np.random.default_rng(1)
    number = rng.permutation(len(mesh.vertices))
    vertices = np.empty_like(mesh.vertices)
    vertices[number] = mesh.vertices
    faces = number[mesh.faces][rng.permutation(len(mesh.faces))]
    turned = np.stack([np.roll(f, rng.integers(4)) for f in faces])
    other = QuadMesh(vertices, turned)
    assert sorted(grid_of(other).numbers.shape) == [5, 7]
    assert is_multi_net(other)
    ring = elliptic_net((9, 5, 2), "lambda", PRESETS["ring"].curve, unfolded=True, closed=True)
    grid = grid_of(ring.sampled(9, 4))
    assert grid.closed_u and not grid.closed_v
    assert (grid.numbers.ravel() == np.arange(36)).all()


def test_irregular_meshes_are_refused():
    faces = [[0, 1, 2, 3], [0, 3, 4, 5], [0, 5, 6, 1]]
    angle = np.arange(6) * np.pi / 3
    corners = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    corner = QuadMesh(np.vstack([[0, 0, 0.5], corners]), faces)
    with pytest.raises(InputError, match="grid type"):
        multi_net_residual(corner)


@pytest.mark.parametrize("moving", ["lambda", "mu", "nu"])
def test_fit_recovers_the_confocal_system(moving):
    turned = np.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]])
    mesh = net_mesh(14, 9, moving)
    moved = mesh.with_vertices(mesh.vertices @ turned.T * 1000 + [5000.0, -200.0, 30.0])
    fit = fit_multi_net(moved)
    assert fit.deviation < 1e-8
    np.testing.assert_allclose(fit.quadric.centre, [5000, -200, 30], rtol=0, atol=1e-7)
    inverse = np.sort(1 / fit.quadric.curvatures) / 1e6
    np.testing.assert_allclose(np.diff(inverse), [3, 4], rtol=1e-10)
    assert multi_net_residual(fit.mesh).worst < 1e-13


def test_fit_of_a_noisy_mesh_is_near_and_exact():
    mesh = net_mesh(14, 9)
    size = np.linalg.norm(np.ptp(mesh.vertices, axis=0))
    noisy = shaken(mesh, 1e-4 * size)
    fit = fit_multi_net(noisy)
    assert fit.deviation < 6e-4 * size
    assert multi_net_residual(noisy).worst > 1e-4
    assert multi_net_residual(fit.mesh).worst < 1e-13
    np.testing.assert_allclose(fit.quadric.centre, 0, atol=0.02 * size)


def test_fit_needs_one_side_of_the_symmetry_planes():
    whole = primitive("ellipsoid", 16, 9, semi_axes=(3.0, 2.0, 1.2), clear=0.1)
    with pytest.raises(InputError, match="cut the mesh there"):
        fit_multi_net(whole)
    fit = fit_multi_net(trimmed(whole, (0, 0), (0, 5)))
    assert fit.deviation < 1e-11
    np.testing.assert_allclose(np.diff(np.sort(1 / fit.quadric.curvatures)), [2.56, 5], rtol=1e-11)


def test_fit_says_where_no_central_quadric_fits():
    with pytest.raises(InputError, match="paraboloids"):
        fit_multi_net(primitive("elliptic-paraboloid", 12, 9))


def test_fit_refuses_planar_lines():
    with pytest.raises(InputError, match="planar"):
        fit_multi_net(rotational_net([(3, 0), (2, 1), (2.5, 1.7)], 9))
