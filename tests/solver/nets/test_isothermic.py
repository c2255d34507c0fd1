"""Isothermic nets and their duals: minimal surfaces from spheres, and nets from freeform sheets."""

from __future__ import annotations

import functools

import numpy as np
import pytest

from solver import InputError, QuadMesh, optimise
from solver.analysis import measures
from solver.analysis.koenigs import koenigs
from solver.mesh.dual import christoffel_dual
from solver.mesh.primitives import primitive
from tests.meshes import deformed, freeform_roof, grid, noisy


def sphere(count: int, turn: float = 0.0) -> QuadMesh:
    """Squares of the plane on a unit sphere: lines that keep angles and proportions."""
    x, y = np.meshgrid(*[np.linspace(-0.8, 0.8, count)] * 2, indexing="ij")
    w = (x + 1j * y) * np.exp(1j * turn) + 0.1
    size = 1 + np.abs(w) ** 2
    return grid(2 * w.real / size, 2 * w.imag / size, (size - 2) / size)


def enneper(count: int) -> np.ndarray:
    """The minimal surface whose normals are those points of the sphere."""
    x, y = np.meshgrid(*[np.linspace(-0.8, 0.8, count)] * 2, indexing="ij")
    w = x + 1j * y + 0.1
    parts = (w - w**3 / 3, 1j * (w + w**3 / 3), w**2)
    return np.stack([part.real for part in parts], axis=-1).reshape(-1, 3)


def off_by(points: np.ndarray, wanted: np.ndarray) -> float:
    """Largest distance after the best move, turn, scale and reflection, over the size."""
    one, two = points - points.mean(axis=0), wanted - wanted.mean(axis=0)
    left, stretch, right = np.linalg.svd(one.T @ two)
    moved = one @ left @ right * (stretch.sum() / (one**2).sum())
    return float(np.linalg.norm(moved - two, axis=1).max() / np.ptp(two))


def test_the_dual_of_a_sphere_is_a_minimal_surface():
    misses = []
    for count in (9, 17):
        ball = sphere(count)
        assert koenigs(ball).max() < 1e-12
        dual = christoffel_dual(ball)
        assert dual.misfit < 1e-12
        assert measures.circular(dual.mesh).max() < 1e-11
        misses.append(off_by(dual.mesh.vertices, enneper(count)))
    assert misses[1] < 0.3 * misses[0] < 0.01


def test_edges_are_parallel_and_diagonals_those_of_the_other():
    ball = sphere(9, 0.4)
    dual = christoffel_dual(ball).mesh
    edges = ball.connectivity.edges
    one, two = (mesh.vertices[edges[:, 1]] - mesh.vertices[edges[:, 0]] for mesh in (ball, dual))
    assert _aligned(one, two) < 1e-11
    a, b, c, d = ball.vertices[ball.faces].transpose(1, 0, 2)
    p, q, r, s = dual.vertices[dual.faces].transpose(1, 0, 2)
    assert max(_aligned(c - a, s - q), _aligned(d - b, r - p)) < 1e-11
    again = christoffel_dual(dual).mesh.vertices
    low, high = ball.vertices.min(axis=0), ball.vertices.max(axis=0)
    assert np.abs(again - ball.vertices).max() < 1e-11 * np.linalg.norm(high - low)


def _aligned(one: np.ndarray, two: np.ndarray) -> float:
    size = np.linalg.norm(one, axis=1) * np.linalg.norm(two, axis=1)
    return float((np.linalg.norm(np.cross(one, two), axis=1) / size).max())


@functools.cache
def reached():
    outcome = optimise(freeform_roof(12, 10), "isothermic")
    assert outcome.report.status == "converged", outcome.report.message
    return outcome


def test_a_freeform_roof_becomes_isothermic_and_has_a_dual():
    mesh, report = reached().mesh, reached().report
    assert max(spread.max for spread in report.residuals.values()) <= 1e-10
    assert report.form.off_surface.percent < 3 and report.form.zigzag > 0.85
    assert 0.95 < report.form.area_ratio < 1.05
    dual = christoffel_dual(mesh)
    assert dual.misfit < 1e-9
    assert measures.planarity(dual.mesh).max() < 1e-9
    assert measures.circular(dual.mesh).max() < 1e-9
    size = np.linalg.norm(np.ptp(mesh.vertices, axis=0))
    assert np.linalg.norm(np.ptp(dual.mesh.vertices, axis=0)) == pytest.approx(size)


def test_noisy_starts_get_there_too():
    start = deformed(primitive("translational", 9, 8), 0.03)
    for seed in range(10):
        report = optimise(noisy(start, seed=seed), "isothermic").report
        assert report.status == "converged", f"{seed}: {report.message}"


def test_what_has_no_dual_is_told():
    assert christoffel_dual(freeform_roof(8, 7)).misfit > 1e-3
    angle = np.radians(np.arange(6) * 60.0)
    ring = np.column_stack([np.cos(angle), np.sin(angle), 0.1 * (np.arange(6) % 2)])
    cube = QuadMesh(np.vstack([[[0, 0, 0]], ring]), [[0, 1, 2, 3], [0, 3, 4, 5], [0, 5, 6, 1]])
    with pytest.raises(InputError, match="no two families"):
        christoffel_dual(cube)
    dart = QuadMesh([[0, 0, 0], [1, 0, 0], [0.2, 0.2, 0], [0, 1, 0]], [[0, 1, 2, 3]])
    with pytest.raises(InputError, match="face 0 is not convex"):
        christoffel_dual(dart)
