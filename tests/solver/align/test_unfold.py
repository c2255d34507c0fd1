"""Nets that lie on themselves: round irregular vertices, and over openings."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from solver import QuadMesh
from solver.align.align import aligned
from solver.align.triangle_mesh import TriangleMesh
from solver.align.unfold import unfolded
from solver.analysis.measures import flipped
from tests.design_surfaces import cap, saddle, triangles, without


def three_fans(steps=4):
    """A net round a vertex of three faces, on a sphere of radius 10, edges of half a metre."""
    rows = np.arange(steps + 1)
    corners, faces, numbers = [], [], {}

    def vertex(sector, i, j):
        # Points on the ray between two sectors belong to both.
        key = ((sector + 1) % 3, j, 0) if i == 0 else (sector, i, j)
        key = (0, 0, 0) if i == j == 0 else key
        if key not in numbers:
            turns = 2 * np.pi / 3 * np.array([sector, sector + 1])
            one, two = np.stack([np.cos(turns), np.sin(turns)], axis=1)
            x, y = 0.5 * (i * one + j * two)
            numbers[key] = len(corners)
            corners.append([x, y, np.sqrt(100 - x * x - y * y)])
        return numbers[key]

    for sector in range(3):
        for i in rows[:-1]:
            for j in rows[:-1]:
                around = ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))
                faces.append([vertex(sector, *place) for place in around])
    return QuadMesh(np.array(corners), np.array(faces))


def surface():
    return TriangleMesh(*triangles(cap, 61, 61))


def test_an_irregular_vertex_that_folds_its_face_is_set_between_its_neighbours():
    net = three_fans()
    assert not flipped(net).any()
    places = net.vertices.copy()
    places[0] = [-0.35, 0.0, np.sqrt(100 - 0.35**2)]
    beside = net.with_vertices(places)
    assert flipped(beside).any()
    found = unfolded(beside, surface())
    assert not flipped(found).any()
    assert np.linalg.norm(found.vertices[0] - [0, 0, 10]) < 0.01
    assert np.array_equal(found.vertices[1:], net.vertices[1:])


def test_regular_vertices_stay_and_so_do_nets_without_folds():
    net = three_fans()
    assert unfolded(net, surface()) is net
    places = net.vertices.copy()
    regular = int(np.flatnonzero(net.connectivity.regular & ~net.connectivity.boundary_vertices)[0])
    away = net.faces[(net.faces == regular).any(axis=1) & ~(net.faces == 0).any(axis=1)]
    places[regular] = 3 * net.vertices[away[0]].mean(axis=0) - 2 * places[regular]
    folded = net.with_vertices(places)
    assert flipped(folded).any()
    assert np.array_equal(unfolded(folded, surface()).vertices[regular], places[regular])


def test_a_net_does_not_meet_itself_over_an_opening():
    points, faces = triangles(saddle)
    open_ = without(points, faces, lambda c: np.hypot(c[:, 0] - 2.0, c[:, 1] - 1.0) < 3.0)
    net = aligned(*open_, edge=2.0).mesh
    assert len(net.connectivity.boundary_loops) == 2
    assert not cKDTree(net.vertices).query_pairs(0.01)
