"""Vertices slid along a surface to right angles and flat faces."""

from __future__ import annotations

import numpy as np
import pytest

from solver import QuadMesh
from solver.align.align import aligned
from solver.align.slide import _equations, slid
from solver.align.triangle_mesh import TriangleMesh
from solver.analysis import measures
from solver.mesh.closest import TriangleSurface
from solver.mesh.grid import grid_mesh
from tests.design_surfaces import barrel, saddle, triangles

NO_LINES = np.zeros((0, 2), dtype=np.int64)


def bent(count=13, by=0.0):
    """A net on a barrel vault of radius 8, along its lines of curvature, or bent away by a part."""
    s, t = np.meshgrid(*2 * [np.linspace(-0.6, 0.6, count)], indexing="ij")
    u, v = s + by * np.sin(3 * t) * s, t + by * np.cos(2 * s)
    return grid_mesh(np.stack([8 * u, 8 * np.sin(v), 8 * np.cos(v)], axis=-1))


def vault():
    def formula(u, v):
        a, b = 3 * (u - 0.5), 3 * (v - 0.5)
        return 8 * a, 8 * np.sin(b), 8 * np.cos(b)

    return TriangleMesh(*triangles(formula, 61, 241))


def worst(net):
    return measures.orthogonality(net).max(), measures.planarity(net).max()


def test_derivatives_are_those_of_the_equations():
    net = bent(4, 0.1)
    dice = np.random.default_rng(1)
    places = net.vertices + dice.normal(0, 0.05, net.vertices.shape)
    move = dice.normal(size=places.shape)
    regular = np.arange(len(net.faces)) != 2
    _, slope = _equations(places, net.faces, regular)
    step = 1e-6
    ahead, back = (_equations(places + h * move, net.faces, regular)[0] for h in (step, -step))
    value = _equations(places, net.faces, regular)[0]
    count = len(net.faces)
    # Mean lengths of diagonals are not derived: what they divide is compared at their own.
    first, second = (net.faces[:, [k, k + 2]] for k in (0, 1))

    def mean(at):
        ends = [at[pair[:, 1]] - at[pair[:, 0]] for pair in (first, second)]
        return np.tile(np.linalg.norm(ends, axis=2).mean(axis=0), 2)

    found = (ahead * mean(places + step * move) - back * mean(places - step * move)) / (2 * step)
    assert slope @ move.ravel() == pytest.approx(found / mean(places), rel=1e-5, abs=1e-6)
    assert value[2] == 0 and value[count + 2] != 0


def test_a_net_beside_the_lines_of_curvature_comes_nearer_to_them_on_the_surface():
    start, surface = bent(by=0.06), vault()
    found = slid(start, surface, NO_LINES)
    right, flat = worst(start)
    assert right > 0.05 and flat > 2e-3
    assert worst(found)[0] < right / 10 and worst(found)[1] < flat / 2
    assert measures.edge_ratio(found) > 0.85 * measures.edge_ratio(start)
    off = TriangleSurface(surface.points, surface.triangles).closest(start.vertices)[0]
    placed = QuadMesh(off, start.faces)
    found = slid(placed, surface, NO_LINES).vertices
    feet = TriangleSurface(surface.points, surface.triangles).closest(found)[0]
    assert np.linalg.norm(found - feet, axis=1).max() < 1e-9


def test_vertices_on_feature_lines_stay():
    surface = vault()
    ground = TriangleSurface(surface.points, surface.triangles)
    start = bent(by=0.06)
    start = start.with_vertices(ground.closest(start.vertices)[0])
    middle = np.flatnonzero(np.abs(surface.points[:, 0]) < 1e-9)
    lines = np.stack([middle[:-1], middle[1:]], axis=1)
    on = np.abs(start.vertices[:, 0]) < 1e-3
    assert on.sum() > 10
    free, held = slid(start, surface, NO_LINES), slid(start, surface, lines)
    assert np.array_equal(held.vertices[on], start.vertices[on])
    assert not np.allclose(free.vertices[on], start.vertices[on], atol=1e-3)


def test_a_net_stays_as_it_is_where_edges_would_get_too_short():
    start = bent(by=0.06)
    places = start.vertices.copy()
    # Two vertices in all but one place: whatever moves them together is refused.
    places[84] = places[85] + 1e-6 * (places[84] - places[85])
    start = start.with_vertices(places)
    found = slid(start, vault(), NO_LINES)
    assert measures.edge_ratio(found) >= 0.85 * measures.edge_ratio(start)


def test_lines_that_are_not_even_are_left_to_the_optimisation():
    start = bent(by=0.06)
    places = start.vertices.copy()
    # Every other row is moved along the vault.
    places[:, 0] += 0.5 * (np.arange(len(places)) // 13 % 2)
    uneven = start.with_vertices(places)
    assert measures.smoothness(start) > 0.25 > measures.smoothness(uneven)
    assert slid(uneven, vault(), NO_LINES) is uneven
    assert slid(start, vault(), NO_LINES) is not start


@pytest.mark.parametrize("formula", [barrel, saddle])
def test_principal_nets_are_aligned_so(formula):
    given = triangles(formula)
    made, plain = (aligned(*given, net=net, edge=2.0).mesh for net in ("principal", "developable"))
    assert np.array_equal(made.faces, plain.faces)
    # A tenth of what the start of an optimisation may have is not lowered for its own sake.
    assert worst(made)[0] < max(worst(plain)[0] / 2, 3e-3)
    assert worst(made)[1] < 0.6 * worst(plain)[1]
    # Without even motions vertices follow the facets of the surface, and lines zigzag.
    assert measures.smoothness(made) >= measures.smoothness(plain) - 0.05
    off = TriangleSurface(*given)
    far = [np.linalg.norm(n.vertices - off.closest(n.vertices)[0], axis=1) for n in (made, plain)]
    # The same vertices are on the surface, but for some at its border.
    assert (far[0] < 1e-9).sum() > 0.97 * (far[1] < 1e-9).sum()
