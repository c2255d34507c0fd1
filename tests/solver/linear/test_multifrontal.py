"""The own sparse Cholesky factorisation against dense algebra and against scipy's SuperLU."""

from __future__ import annotations

import time

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.sparse import csc_array, diags_array
from scipy.sparse.linalg import splu

from solver.errors import SingularSystemError
from solver.linear.multifrontal import Multifrontal
from solver.linear.sparsity import Numbering
from solver.mesh.quadmesh import QuadMesh
from solver.mesh.subdivide import subdivided
from solver.terms.base import coordinates_of
from tests.conftest import wavy_grid


def layout_of(stencils, points, free=None, scalars=0):
    if free is None:
        free = np.ones(3 * len(points) + scalars, dtype=bool)
    return Numbering(stencils, free, points, reorder=True).sparsity


def random_matrix(pattern, seed=0):
    """A positive definite matrix of the pattern: lower triangle, and whole."""
    numbers = np.random.default_rng(seed)
    size = pattern.size
    lower = csc_array(
        (numbers.normal(size=len(pattern.indices)), pattern.indices, pattern.indptr),
        shape=(size, size),
    )
    off = lower - diags_array(lower.diagonal())
    whole = off + off.T
    whole = csc_array(whole + diags_array(1 + abs(whole).sum(axis=1)))
    data = lower.data.copy()
    data[pattern.indptr[:-1]] = whole.diagonal()
    return data, whole


def assert_solves(pattern, seed=0):
    data, whole = random_matrix(pattern, seed)
    wanted = np.random.default_rng(seed + 1).normal(size=(2, pattern.size))
    solve = Multifrontal(pattern).factor(data)
    for x in wanted:
        assert np.allclose(solve(whole @ x), x, rtol=0, atol=1e-11)


@pytest.mark.parametrize("sides", [(3, 3), (9, 8), (40, 17)])
def test_grids(sides):
    mesh = wavy_grid(*sides)
    stencils = [coordinates_of(mesh.faces), coordinates_of(mesh.connectivity.stars)]
    assert_solves(layout_of(stencils, mesh.vertices))


def test_a_closed_mesh_with_irregular_vertices():
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
    sides = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    mesh = subdivided(QuadMesh(corners, np.array(sides)), 3)
    assert len(mesh.connectivity.stars) < len(mesh.vertices) == 386
    assert_solves(layout_of([coordinates_of(mesh.faces)], mesh.vertices))


def test_meshes_that_are_not_joined():
    mesh = wavy_grid(12, 12)
    faces = np.concatenate([mesh.faces, mesh.faces + len(mesh.vertices)])
    for offset in (0.0, 50.0):
        points = np.concatenate([mesh.vertices, mesh.vertices + offset])
        assert_solves(layout_of([coordinates_of(faces)], points))


def test_fixed_unknowns_and_scalars_that_few_or_all_share():
    mesh = wavy_grid(20, 15)
    count = len(mesh.vertices)
    free = np.ones(3 * count + len(mesh.faces) + 1, dtype=bool)
    free[np.random.default_rng(0).integers(0, 3 * count, 200)] = False
    free[: 3 * 15] = False
    own = 3 * count + np.arange(len(mesh.faces))[:, None]
    shared = np.full_like(own, len(free) - 1)
    stencil = np.hstack([coordinates_of(mesh.faces), own, shared])
    pattern = layout_of([stencil], mesh.vertices, free)
    assert pattern.size == free.sum()
    assert_solves(pattern)


def test_the_order_does_not_depend_on_where_the_mesh_lies():
    """Scalars too have a place, amid the vertices that they meet."""
    mesh = wavy_grid(30, 30)
    edges = mesh.connectivity.edges
    own = 3 * len(mesh.vertices) + np.arange(len(edges))[:, None]
    stencils = [np.hstack([coordinates_of(edges), own])]
    here, there = (
        layout_of(stencils, mesh.vertices + [shift, 0, 0], scalars=len(edges)).unknowns
        for shift in (0.0, 1024.0)
    )
    assert (here == there).all()


def test_nothing_free():
    mesh = wavy_grid(3, 3)
    pattern = layout_of([coordinates_of(mesh.faces)], mesh.vertices, np.zeros(27, dtype=bool))
    assert Multifrontal(pattern).factor(np.zeros(0))(np.zeros(0)).shape == (0,)


@settings(max_examples=30, deadline=None)
@given(count=st.integers(1, 150), links=st.integers(0, 400), seed=st.integers(0, 10_000))
def test_random_graphs(count, links, seed):
    numbers = np.random.default_rng(seed)
    pairs = numbers.integers(0, count, size=(links, 2))
    pairs = pairs[pairs[:, 0] != pairs[:, 1]]
    free = numbers.random(3 * count) < 0.8
    assert_solves(layout_of([coordinates_of(pairs)], numbers.normal(size=(count, 3)), free), seed)


@pytest.mark.parametrize("where", [0, -1])
def test_a_matrix_that_is_not_positive_definite_is_refused(where):
    mesh = wavy_grid(12, 12)
    pattern = layout_of([coordinates_of(mesh.faces)], mesh.vertices)
    solver = Multifrontal(pattern)
    data, whole = random_matrix(pattern)
    for pivot in (0.0, -1.0):
        broken = data.copy()
        broken[pattern.indptr[:-1][where]] = pivot
        with pytest.raises(SingularSystemError, match="raise the damping"):
            solver.factor(broken)
    # A refusal leaves nothing behind.
    x = np.arange(pattern.size) / pattern.size
    assert np.allclose(solver.factor(data)(whole @ x), x, rtol=0, atol=1e-11)


def test_earlier_factors_outlive_later_ones():
    mesh = wavy_grid(9, 9)
    pattern = layout_of([coordinates_of(mesh.faces)], mesh.vertices)
    solver = Multifrontal(pattern)
    (one, first), (two, _) = random_matrix(pattern, 1), random_matrix(pattern, 2)
    solve = solver.factor(one)
    solver.factor(two)
    x = np.ones(pattern.size)
    assert np.allclose(solve(first @ x), x, rtol=0, atol=1e-11)


def test_fills_in_and_costs_less_than_superlu():
    mesh = wavy_grid(40, 40)
    stencils = [coordinates_of(mesh.faces), coordinates_of(mesh.connectivity.line_triples)]
    pattern = layout_of(stencils, mesh.vertices)
    data, whole = random_matrix(pattern)
    solver = Multifrontal(pattern)

    def superlu():
        options = {"SymmetricMode": True}
        return splu(whole, "MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options=options)

    own, other = [], []
    for _ in range(5):
        for times, factor in ((own, lambda: solver.factor(data)), (other, superlu)):
            begin = time.process_time()
            factor()
            times.append(time.process_time() - begin)
    assert min(own) < 0.6 * min(other)


@pytest.mark.slow
def test_a_hundred_thousand_vertices():
    mesh = wavy_grid(317, 317)
    stencils = [coordinates_of(mesh.faces), coordinates_of(mesh.connectivity.line_triples)]
    assert_solves(layout_of(stencils, mesh.vertices))
