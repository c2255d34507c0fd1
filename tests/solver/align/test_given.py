"""Singular vertices where somebody asks for them, and no others."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from solver.align.align import aligned
from solver.align.crosses import Singular
from solver.analysis.measures import flipped, orthogonality
from solver.errors import InputError
from tests.design_surfaces import dome, plane, saddle, triangles, without

DOME = triangles(dome, 31, 21)
EDGE = 2.5


def on_dome(*places_and_lines):
    """Singular vertices on the dome above places in plan."""
    rows = np.array(places_and_lines, dtype=float).reshape(-1, 3)
    heights = dome(rows[:, 0] / 30 + 0.5, rows[:, 1] / 20 + 0.5)[2]
    return Singular(np.column_stack([rows[:, :2], heights]), rows[:, 2].astype(int))


def valences(net):
    """How many faces there are at inner vertices that have not four of them."""
    return net.mesh.connectivity.face_valence[net.irregular].tolist()


@pytest.fixture(scope="module")
def automatic():
    return aligned(*DOME, edge=EDGE)


def test_those_that_are_found_anyway_change_nothing(automatic):
    again = aligned(*DOME, edge=EDGE, singularities=automatic.singular)
    assert sorted(valences(again)) == [3, 3, 5, 5]
    assert np.array_equal(again.mesh.vertices, automatic.mesh.vertices)


def test_one_that_is_moved_takes_the_net_along_and_the_others_stay(automatic):
    given = automatic.singular
    row = int(np.flatnonzero(given.valences == 3)[0])
    places = given.places.copy()
    places[row] = on_dome((4.0, 3.0, 3)).places[0]
    net = aligned(*DOME, edge=EDGE, singularities=replace(given, places=places))
    found = net.mesh.vertices[net.irregular]
    apart = np.linalg.norm(found[:, None] - places[None], axis=2)
    # They come to vertices of triangles, which are half an edge wide.
    assert (apart.min(axis=0) < 0.35 * EDGE).all()
    assert sorted(valences(net)) == [3, 3, 5, 5]
    assert not flipped(net.mesh).any()
    assert orthogonality(net.mesh).mean() < 4e-2


@pytest.mark.parametrize(
    "given",
    [
        on_dome(),
        on_dome((3, 2, 3)),
        on_dome((0, 0, 6)),
        on_dome((-4, 0, 3), (5, 1, 5)),
    ],
    ids=["none", "one", "six", "two"],
)
def test_there_are_those_that_are_asked_for_and_no_others(given):
    net = aligned(*DOME, edge=EDGE, singularities=given)
    assert sorted(valences(net)) == sorted(given.valences.tolist())
    assert np.linalg.norm(np.sort(net.singular.places, axis=0) - np.sort(given.places, axis=0)) < (
        0.5 * EDGE
    )
    assert sorted(net.singular.valences.tolist()) == sorted(given.valences.tolist())
    assert not flipped(net.mesh).any()
    assert net.remarks == ()


def test_three_and_five_in_one_place_vanish_and_two_fives_are_one_six():
    both = on_dome((2, 1, 3), (2, 1, 5), (-5, 0, 5), (-5, 0, 5))
    assert valences(aligned(*DOME, edge=EDGE, singularities=both)) == [6]


def test_curvature_is_followed_away_from_them():
    surface = triangles(saddle, 31, 21)
    x, y = np.array([[-8.0, -4.0], [-8.0, -1.0]]).T
    u, v = x / 30, y / 20
    places = np.column_stack([x, y, 12 * u**2 - 20 * v**2 + 2 * u * v])
    plain = aligned(*surface, edge=EDGE)
    pair = aligned(*surface, edge=EDGE, singularities=Singular(places, np.array([3, 5])))
    assert sorted(valences(pair)) == [3, 5]
    apart = [
        np.abs((pair.field.directions[:, 0] * plain.field.directions[:, k]).sum(axis=1))
        for k in (0, 1)
    ]
    turned = np.degrees(np.arccos(np.clip(np.maximum(*apart), -1, 1)))
    away = np.linalg.norm(plain.field.places - places.mean(axis=0), axis=1)
    assert turned[away > 8.0].mean() < 1.0
    assert turned[away < 2.0].mean() > 10.0


def test_round_an_opening_the_field_comes_back_to_itself():
    points, faces = without(*DOME, lambda c: np.hypot(c[:, 0] - 5, c[:, 1]) < 3.5)
    net = aligned(points, faces, edge=EDGE, singularities=on_dome((-6, 3, 3), (-6, -4, 5)))
    assert sorted(valences(net)) == [3, 5]
    assert len(net.mesh.connectivity.boundary_loops) == 2


def test_a_flat_surface_has_them_too():
    given = Singular(np.array([[3.0, 2.0, 0.0], [8.0, 5.0, 0.0]]), np.array([3, 5]))
    net = aligned(*triangles(plane), edge=0.8, singularities=given)
    assert sorted(valences(net)) == [3, 5]
    assert not flipped(net.mesh).any()


def test_a_border_that_is_followed_says_what_they_add_up_to():
    fits = aligned(*DOME, edge=EDGE, border="follow", singularities=on_dome((-5, 2, 3), (5, -2, 5)))
    assert sorted(valences(fits)) == [3, 5]
    with pytest.raises(InputError, match=r"add up to \+2 .* they need \+0: add 2 with 5 lines"):
        given = on_dome((-5, 2, 3), (5, -2, 3))
        aligned(*DOME, edge=EDGE, border="follow", singularities=given)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        (on_dome((0, 0, 4)), "expected 3, 5 or 6 lines"),
        (on_dome((0, 0, 3), (0, 0, 3)), r"at \(0, 0, 6\) make a vertex with 2 lines"),
        (Singular(np.array([[0.0, 0.0, 9.0]]), np.array([3])), "3 off the surface"),
        (Singular(np.array([[0.0, 60.0, 0.0]]), np.array([3])), "off the surface"),
    ],
)
def test_what_cannot_be_is_said_in_a_line(given, words):
    with pytest.raises(InputError, match=f"singularities: .*{words}") as said:
        aligned(*DOME, edge=EDGE, singularities=given)
    assert "\n" not in str(said.value)


def test_moved_onto_another_they_are_joined_or_left_apart():
    there = on_dome((0, 0, 3), (4, 0, 5), (8, 0, 5), (0, 5, 3))
    alone = there.moved(0, there.places[1] + [0.0, 2.0, 0.0], 1.0)
    assert alone.valences.tolist() == [3, 5, 5, 3]
    assert alone.places[0] == pytest.approx(there.places[1] + [0.0, 2.0, 0.0])
    vanished = there.moved(0, there.places[1] + 0.1, 1.0)
    assert vanished.valences.tolist() == [5, 3]
    assert vanished.places == pytest.approx(there.places[2:])
    joined = there.moved(1, there.places[2], 1.0)
    assert joined.valences.tolist() == [3, 6, 3]
    assert joined.places == pytest.approx(there.places[[0, 2, 3]])
    with pytest.raises(InputError, match="would make a vertex with 2"):
        there.moved(3, there.places[0], 1.0)
    with pytest.raises(InputError, match="would make a vertex with 7"):
        on_dome((0, 0, 6), (3, 0, 5)).moved(0, on_dome((3, 0, 5)).places[0], 1.0)
