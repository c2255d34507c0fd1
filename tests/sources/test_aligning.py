"""Nets along lines of curvature of surfaces that come as functions."""

from __future__ import annotations

import re

import numpy as np
import pytest

from freecad_ortho.sources.aligning import aligned_on, edge_for
from freecad_ortho.sources.catalogue import source
from freecad_ortho.surface_files import SurfaceFile
from solver.analysis import measures
from solver.errors import InputError
from solver.mesh.sampling import ParametricSurface
from tests.design_surfaces import saddle


def in_mm(u, v):
    return 1000 * np.stack(np.broadcast_arrays(*saddle(u, v)), axis=-1)


def foot(points):
    """The nearest points, by Newton steps from the parameters under the points."""
    u, v = np.full((2, len(points)), 0.5)
    for _ in range(30):
        at, step = in_mm(u, v), 1e-5
        one, two = (in_mm(u + step, v) - at) / step, (in_mm(u, v + step) - at) / step
        a, b, c = (np.einsum("nk,nk->n", x, y) for x, y in ((one, one), (one, two), (two, two)))
        off = points - at
        p, q = (np.einsum("nk,nk->n", off, x) for x in (one, two))
        u = np.clip(u + (c * p - b * q) / (a * c - b * b), 0, 1)
        v = np.clip(v + (a * q - b * p) / (a * c - b * b), 0, 1)
    return in_mm(u, v)


WHOLE = ParametricSurface(in_mm, (0.0, 1.0), (0.0, 1.0), foot=foot)


def test_defaults_make_about_600_faces():
    made = source("along curvature").make({}, surfaces=[WHOLE])
    assert 500 < len(made.mesh.faces) < 800
    assert measures.orthogonality(made.mesh).mean() < 1e-2


def test_vertices_are_on_the_exact_surface_but_for_what_overhangs():
    made = aligned_on([WHOLE], "principal", 2500.0, 1.0)
    far = np.linalg.norm(foot(made.mesh.vertices) - made.mesh.vertices, axis=1)
    assert (far < 1e-6).mean() > 0.6
    # What is not on it is beyond the border, not a little above.
    assert not ((far > 1e-6) & (far < 20)).any()


def test_cad_faces_are_spoken_of_in_the_unit_that_was_asked_for():
    with pytest.raises(InputError, match=r"edge: 40 leaves room .*; \d\.\d or less"):
        SurfaceFile("m", [WHOLE]).aligned(edge=40.0, net="principal")
    made = SurfaceFile("m", [WHOLE]).aligned(edge=2.5, net="principal").net
    far = np.linalg.norm(foot(1000 * made.mesh.vertices) / 1000 - made.mesh.vertices, axis=1)
    assert (far < 1e-9).mean() > 0.6
    assert made.mesh.mean_edge == pytest.approx(2.5, rel=0.1)


def test_two_faces_that_meet_are_one_surface():
    halves = [WHOLE.part((0.0, 0.5), (0.0, 1.0)), WHOLE.part((0.5, 1.0), (0.0, 1.0))]
    made = aligned_on(halves, "principal", 2500.0, 1.0)
    whole = aligned_on([WHOLE], "principal", 2500.0, 1.0)
    assert len(made.border) == 1
    assert len(made.mesh.faces) == pytest.approx(len(whole.mesh.faces), rel=0.05)


def test_an_edge_length_for_600_faces():
    assert edge_for(600.0, 1.0) == 1.0
    assert edge_for(1200.0, 2.0) == 1.0
    with pytest.raises(ValueError, match="ratio"):
        edge_for(600.0, 0.0)


def test_places_far_from_the_origin_are_told_from_a_point_that_is_said():
    u, v = np.meshgrid(np.linspace(0, 1, 40), np.linspace(0, 1, 40), indexing="ij")
    points = np.stack(saddle(u, v), axis=-1).reshape(-1, 3)
    k = np.arange(1600).reshape(40, 40)
    corners = [k[:-1, :-1], k[1:, :-1], k[1:, 1:], k[:-1, 1:]]
    first, second, third, fourth = (corner.ravel() for corner in corners)
    faces = np.concatenate(
        [np.stack(c, 1) for c in ((first, second, third), (first, third, fourth))]
    )
    middles = points[faces].mean(axis=1)
    place = points[k[20, 20]]
    faces = faces[np.linalg.norm(middles - place, axis=1) > 0.6]
    here = SurfaceFile("m", mesh=(points, faces)).aligned(edge=3.0).net.remarks
    shift = np.array([4.0e5, 5.0e6, 0.0])
    there = SurfaceFile("m", mesh=(points + shift, faces)).aligned(edge=3.0).net.remarks
    numbers = re.search(r"places are told from \(([^)]*)\)", there[-1]).group(1)
    told = re.search(r"the opening at \(([^)]*)\)", there[0]).group(1)
    origin, at = (np.array([float(x) for x in words.split(",")]) for words in (numbers, told))
    np.testing.assert_allclose(origin + at, place + shift, atol=0.3)
    assert not any("told from" in remark for remark in here)
