"""Small faults of triangles: pinholes, slits, slivers, what noise has folded over."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from solver.align.align import aligned
from solver.align.cells import quads
from solver.align.field import curvature_guide, smooth_field
from solver.align.mend import mended, relaxed
from solver.align.prepare import openings
from solver.align.triangle_mesh import TriangleMesh, one_surface
from solver.analysis import measures
from solver.mesh.closest import TriangleSurface
from tests.design_surfaces import plane, random_surface, saddle, triangles, without


@pytest.mark.parametrize(("wide", "loops", "words"), [(0, 1, 0), (0.01, 1, 1), (0.3, 2, 0)])
def test_a_seam_that_gapes_is_no_opening(wide, loops, words):
    points, faces = triangles(plane, 25, 17)
    near = np.linalg.norm(points[:, :2] - [6, 4], axis=1).argmin()
    # One side of a seam has a vertex of its own.
    beyond = points[faces].mean(axis=1)[:, 0] > points[near, 0]
    faces = np.where(beyond[:, None] & (faces == near), len(points), faces)
    points = np.concatenate([points, points[near][None] + [wide, 0, 0]])
    said: list[str] = []
    assert len(openings(one_surface(points, faces), 1.5, said)) == loops
    assert len(said) == words


def test_openings_smaller_than_a_face_are_closed_and_larger_ones_kept():
    points, faces = triangles(plane, 25, 17)
    small = without(points, faces, lambda at: np.hypot(at[:, 0] - 4, at[:, 1] - 4) < 0.6)
    whole = mended(one_surface(*small), 2.0)
    assert len(whole.loops()) == 1
    assert whole.areas.sum() == pytest.approx(12 * 8)
    assert (whole.normals[:, 2] > 0.99).all()
    assert len(mended(one_surface(*small), 1.0).loops()) == 2


def test_a_lost_triangle_leaves_no_slit():
    points, faces = triangles(plane, 9, 9)
    lost = one_surface(points, np.delete(faces, 36, axis=0))
    assert len(lost.loops()) == 2
    whole = mended(lost, 5.0)
    assert len(whole.loops()) == 1
    assert whole.areas.sum() == pytest.approx(12 * 8)


def test_a_sliver_goes_and_its_vertices_stay():
    # Vertex 4 lies a hair beside the edge from 0 to 2.
    points = np.array([[0, 0, 0], [1, -1, 0], [2, 0, 0], [1, 1, 0], [1, 1e-4, 0]], dtype=float)
    mesh = TriangleMesh(points, np.array([[0, 1, 2], [0, 2, 4], [0, 4, 3], [4, 2, 3]]))
    better = mended(mesh, 0.1)
    assert np.array_equal(better.points, points)
    assert better.areas.min() > 0.4
    assert better.areas.sum() == pytest.approx(mesh.areas.sum())
    assert (better.normals[:, 2] > 0.99).all()


def test_points_spread_out_along_their_surface():
    points, faces = triangles(plane, 13, 9)
    dice = np.random.default_rng(1)
    mesh = one_surface(points, faces)
    moved = mesh.points.copy()
    moved[~mesh.on_rim, :2] += dice.uniform(-0.45, 0.45, (int((~mesh.on_rim).sum()), 2))
    even = relaxed(TriangleMesh(moved, mesh.triangles), 20)
    assert np.array_equal(even.points[mesh.on_rim], mesh.points[mesh.on_rim])
    assert even.points[:, 2] == pytest.approx(0)
    assert TriangleMesh(moved, mesh.triangles).areas.min() < 0.1
    assert even.areas.min() > 0.3


def test_what_is_folded_over_is_unfolded():
    points, faces = triangles(saddle, 21, 15)
    mesh = one_surface(points, faces)
    inner = int(np.flatnonzero(~mesh.on_rim)[60])
    moved = mesh.points.copy()
    # A vertex pushed through the far side of its ring.
    around = mesh.half_edges[mesh.half_edges[:, 0] == inner][0, 1]
    moved[inner] += 1.4 * (mesh.points[around] - mesh.points[inner])
    folded = TriangleMesh(moved, mesh.triangles)
    assert (folded.normals[:, 2] < 0).any()
    better = mended(folded, 0.1)
    assert (better.normals[:, 2] > 0).all()
    same = np.flatnonzero((better.points != moved).any(axis=1))
    assert inner in same
    assert len(same) < 8


def test_directions_that_go_once_round_themselves_are_not_singular():
    # Twice round a point, an angle of 4 pi, as strips have that lie on each other.
    count = 16
    angles = 4 * np.pi * np.arange(count) / count
    rim = np.column_stack([np.cos(angles), np.sin(angles), 0.01 * angles])
    points = np.concatenate([[[0, 0, 0]], rim])
    turn = 1 + np.arange(count)
    corners = np.column_stack([0 * turn, turn, np.roll(turn, -1)])
    mesh = TriangleMesh(points, corners)
    flat = np.zeros((count, 2, 2))
    flat[:, 0, 0] = 1e-9
    guide = curvature_guide(mesh, flat, count, 0.0)
    assert not smooth_field(mesh, guide, 1.0).quarters.any()


@pytest.mark.slow
@pytest.mark.parametrize("seed", [10])
def test_hard_surfaces_get_nets(seed):
    # Singular vertices nearer to each other than a net can have them.
    points, corners = random_surface(seed)
    made = aligned(points, corners, edge=1.2)
    quads = TriangleSurface.from_quads(made.mesh)
    feet, _ = quads.closest(points[corners].mean(axis=1))
    assert np.linalg.norm(points[corners].mean(axis=1) - feet, axis=1).max() < 0.3
    assert (made.mesh.connectivity.components == 0).all()
    assert not measures.flipped(made.mesh).any()


def test_lines_that_cross_beyond_the_border_only_are_left_out(monkeypatch):
    asked: list[int] = []

    def crossing(mesh, cut, made, covered):
        asked.append(covered)
        found = quads(mesh, cut, made, covered)
        again = found.faces[:1] if len(asked) == 1 else found.faces[:0]
        return replace(found, faces=np.concatenate([found.faces, again]))

    monkeypatch.setattr("solver.align.align.quads", crossing)
    points, faces = triangles(saddle, 31, 19)
    made = aligned(points, faces, edge=2.5)
    assert len(asked) == 2 and asked[1] < asked[0]
    net = TriangleSurface.from_quads(made.mesh)
    far = np.linalg.norm(points - net.closest(points)[0], axis=1)
    assert far.max() < 0.1 * made.mesh.mean_edge
