"""The form check names what is wrong with a net, and where."""

from __future__ import annotations

import numpy as np
import pytest

from solver.analysis.form import form_of
from solver.analysis.form_check import check_form
from tests.conftest import surface_of_revolution


@pytest.fixture(scope="module")
def start():
    return surface_of_revolution(13, 11)


def checked(start, vertices, within=None, overhangs=False):
    mesh = start.with_vertices(vertices)
    found = check_form(start, mesh, form_of(start, mesh), within, overhangs=overhangs)
    return {finding.measure: finding for finding in found}


def moved(start, vertex, by):
    points = start.vertices.copy()
    points[vertex] += by
    return points


def test_a_net_as_it_was_drawn_holds(start):
    found = checked(start, start.vertices)
    assert all(finding.met for finding in found.values())
    assert found["folded faces"].value == 0
    assert found["shortest edge"].value == pytest.approx(1.0)
    assert found["off the surface"].value < 1e-12


def test_a_vertex_off_the_surface_is_named(start):
    vertex = 6 * 11 + 5
    out = 0.01 * start.vertex_normals[vertex]
    far = checked(start, moved(start, vertex, out), within=0.005)["off the surface"]
    assert (far.met, far.limit) == (False, 0.005)
    assert far.value == pytest.approx(0.01, rel=0.02)
    assert vertex in start.faces[int(far.where.removeprefix("face "))]
    np.testing.assert_allclose(far.place, start.vertices[vertex], atol=start.mean_edge)
    assert checked(start, moved(start, vertex, out), within=0.02)["off the surface"].met


def test_without_a_distance_one_percent_of_the_size_is_allowed(start):
    size = np.linalg.norm(np.ptp(start.vertices, axis=0))
    finding = checked(start, start.vertices)["off the surface"]
    assert finding.limit == pytest.approx(0.01 * size)


def test_a_net_that_leaves_its_border_is_named_unless_it_overhangs(start):
    vertex = int(start.connectivity.boundary_loops[0][4])
    points = moved(start, vertex, 0.01 * start.vertex_normals[vertex])
    for within, met in ((0.02, True), (0.005, False)):
        left = checked(start, points, within)["off the border"]
        assert (left.met, left.limit, left.where) == (met, within, f"vertex {vertex}")
        assert left.value == pytest.approx(0.01)
        np.testing.assert_allclose(left.place, points[vertex])
        assert "off the border" not in checked(start, points, within, overhangs=True)


def test_an_edge_that_has_shrunk_is_named(start):
    first, second = start.connectivity.edges[40]
    run = start.vertices[second] - start.vertices[first]
    short = checked(start, moved(start, first, 0.8 * run))["shortest edge"]
    assert not short.met
    assert short.value < 0.4
    assert short.where == f"edge {first}-{second}"


def test_a_folded_face_is_named(start):
    face = start.faces[30]
    across = start.vertices[face[2]] - start.vertices[face[0]]
    folded = checked(start, moved(start, face[0], 1.5 * across))["folded faces"]
    assert not folded.met
    assert folded.value >= 1
    named = start.faces[int(folded.where.removeprefix("face "))]
    assert set(named) & set(face)


def test_lines_that_zigzag_are_named_where_they_do(start):
    rng = np.random.default_rng(3)
    points = start.vertices + 0.01 * rng.standard_normal(start.vertices.shape)
    worst = 6 * 11 + 5
    points[worst] += 0.1 * start.vertex_normals[worst]
    uneven = checked(start, points)["evenness of lines"]
    assert not uneven.met
    assert uneven.value < uneven.limit <= 0.85
    assert np.linalg.norm(uneven.place - start.vertices[worst]) < 2 * start.mean_edge
