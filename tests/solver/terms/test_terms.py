"""One test for every term: derivatives, zero on an exact solution, rigid motion, units."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from solver.terms.closeness import Closeness
from solver.terms.edge_vectors import EdgeVectors
from solver.terms.fairness import Fairness
from solver.terms.multi import multi_net
from solver.terms.orthogonality import Orthogonality
from solver.terms.planarity import Planarity
from tests.conftest import QuadMesh, grid_faces, surface_of_revolution, wavy_grid


def straight_grid() -> QuadMesh:
    i, j = np.meshgrid(np.arange(5.0), 1.5 * np.arange(4.0), indexing="ij")
    points = np.stack([i, j, 0.3 * i - 0.2 * j], axis=2).reshape(-1, 3)
    return QuadMesh.from_arrays(points, grid_faces(5, 4))


def rectangles() -> QuadMesh:
    i, j = np.meshgrid(np.arange(5.0), 1.5 * np.arange(4.0), indexing="ij")
    return QuadMesh.from_arrays(np.stack([i, j, 0 * i], axis=2).reshape(-1, 3), grid_faces(5, 4))


REST = wavy_grid(5, 4, shear=0.1)

# name: term on a mesh, a mesh that fulfils it exactly, whether a rigid motion leaves it alone.
TERMS = {
    "orthogonality": (lambda m: Orthogonality(m.faces), surface_of_revolution(5, 4), True),
    "planarity": (lambda m: Planarity(m.faces), surface_of_revolution(5, 4), True),
    "multi-net": (lambda m: multi_net(m.connectivity), rectangles(), True),
    "fairness": (lambda m: Fairness(m.connectivity.line_triples), straight_grid(), True),
    "smooth motion": (
        lambda m: Fairness(m.connectivity.line_triples, REST.vertices.ravel()),
        REST,
        False,
    ),
    "edge vectors": (
        lambda m: EdgeVectors(m.connectivity.edges, REST.vertices.ravel()),
        REST,
        False,
    ),
    "closeness": (lambda m: Closeness(np.arange(20), REST.vertices), REST, False),
}


@pytest.fixture(params=TERMS)
def case(request):
    return TERMS[request.param]


def test_jacobian_agrees_with_central_differences(case):
    build, _, _ = case
    mesh = wavy_grid(5, 4)
    term = build(mesh)
    x = mesh.vertices.ravel() + 0.05 * np.random.default_rng(1).normal(size=60)
    residual, jacobian = term.linearise(x)
    assert residual.shape == jacobian.shape[:2]
    assert jacobian.shape == (*residual.shape, term.unknowns.shape[1])
    step = 1e-5
    for column in range(term.unknowns.shape[1]):
        change = np.zeros_like(jacobian[:, :, column])
        for element, unknown in enumerate(term.unknowns[:, column]):
            ahead, back = x.copy(), x.copy()
            ahead[unknown] += step
            back[unknown] -= step
            difference = term.linearise(ahead).residual - term.linearise(back).residual
            change[element] = difference[element] / (2 * step)
        assert np.abs(change - jacobian[:, :, column]).max() < 1e-8
    assert np.abs(jacobian).max() > 0.1


def test_vanishes_on_an_exact_solution_and_not_elsewhere(case):
    build, exact, _ = case
    term = build(exact)
    assert np.abs(term.linearise(exact.vertices.ravel()).residual).max() < 1e-13
    bent = exact.vertices + 0.1 * np.random.default_rng(2).normal(size=exact.vertices.shape)
    assert np.abs(term.linearise(bent.ravel()).residual).max() > 1e-3


def test_rigid_motion(case):
    build, _, invariant = case
    mesh = wavy_grid(5, 4)
    turned = Rotation.from_euler("xyz", [0.3, -1.1, 2.0]).apply(mesh.vertices.copy()) + [
        3.0,
        -2.0,
        5.0,
    ]
    term = build(mesh)
    before = np.linalg.norm(term.linearise(mesh.vertices.ravel()).residual, axis=1)
    after = np.linalg.norm(term.linearise(turned.ravel()).residual, axis=1)
    assert np.allclose(before, after, atol=1e-12) == invariant


def test_linear_terms_have_a_constant_jacobian(case):
    build, _, _ = case
    mesh = wavy_grid(5, 4)
    term = build(mesh)
    here = term.linearise(mesh.vertices.ravel()).jacobian
    there = term.linearise(2 * mesh.vertices.ravel() ** 2).jacobian
    assert np.array_equal(here, there) == term.linear


@pytest.mark.parametrize("build", [Orthogonality, Planarity])
def test_net_terms_do_not_depend_on_the_size_of_a_face(build):
    mesh = wavy_grid(5, 4)
    term = build(mesh.faces)
    small = term.linearise(1e-3 * mesh.vertices.ravel()).residual
    assert np.allclose(small, term.linearise(mesh.vertices.ravel()).residual, rtol=1e-10)
