"""Few kinds of parts: exact nets whose parts repeat, counted by other means than they were made."""

import numpy as np
import pytest

from solver import Constraints, InputError, QuadMesh, Session, optimise
from solver.analysis import measures
from solver.analysis.kinds import kinds_within
from solver.analysis.rows import rows_along
from solver.grouping import in_rows, merged, near_ones
from solver.terms.repetition import SameLengths
from tests.conftest import shared_mesh, surface_of_revolution, wavy_grid


def bent_barrel():
    """A barrel that is wider at one end: 48 panels of 48 kinds."""
    mesh = surface_of_revolution()
    x, y, z = mesh.vertices.T
    return mesh.with_vertices(np.stack([x * (1 + 0.04 * y), y * (1 + 0.03 * z), z], axis=1))


def apart(mesh):
    """(F, 6) distances between the corners of each panel."""
    corners = mesh.vertices[mesh.faces]
    i, j = np.triu_indices(4, 1)
    return np.linalg.norm(corners[:, i] - corners[:, j], axis=2)


@pytest.fixture(scope="module")
def panels():
    return optimise(bent_barrel(), repeat="panels", kinds=6, alike=1e-3)


def test_few_kinds_of_panels_are_an_exact_net_that_is_still_what_was_drawn(panels):
    report, mesh = panels.report, panels.mesh
    found = report.repetition
    assert report.status == "converged" and found.is_reached and report.is_repeated
    # Panels along a parallel are one kind, of which there are six.
    assert found.kinds == 6 and found.kinds_before >= 12 and found.counts == [8] * 6
    assert max(measures.orthogonality(mesh).max(), measures.planarity(mesh).max()) <= 1e-12
    assert report.form.zigzag >= 0.9 and report.form.off_surface.percent <= 2
    assert report.as_dict()["repetition"]["kind"] == found.kind


def test_panels_of_a_kind_are_equal_where_the_net_allows_it(panels):
    kind = np.array(panels.report.repetition.kind)
    for number in range(6):
        group = apart(panels.mesh)[kind == number]
        # In any of the orders that turn a panel by half: all begin at the same corner here.
        assert np.ptp(group, axis=0).max() <= 1e-9
    assert panels.report.repetition.largest_miss <= 1e-9


def test_equal_lengths_of_edges():
    outcome = optimise(bent_barrel(), repeat="edges", kinds=13, alike=1e-3)
    lengths = np.sort(outcome.mesh.edge_lengths)
    assert outcome.report.repetition.kinds <= 13
    # Intervals of twice the tolerance cover them: counted from the shortest on.
    count, first = 0, -1.0
    for length in lengths:
        if length > first + 2e-3 * (1 + 1e-9):
            count, first = count + 1, length
    assert count == outcome.report.repetition.kinds


def test_nodes_of_few_angles():
    start = bent_barrel()
    outcome = optimise(start, repeat="nodes", kinds=30, alike_angle=0.4)
    found = outcome.report.repetition
    assert found.kinds <= 30 < found.kinds_before
    assert found.kinds == kinds_within(outcome.mesh, "nodes", 0.4).number


def test_as_few_as_can_be_found_and_too_few():
    start = wavy_grid(6, 5, shear=0.05)
    few = optimise(start, repeat="panels", alike=0.002, max_steps=60).report.repetition
    assert few.asked is None and few.is_reached and few.kinds < few.kinds_before
    report = optimise(start, repeat="panels", kinds=2, alike=1e-7, max_steps=30).report
    assert report.status == "converged"
    assert not report.is_repeated and report.repetition.kinds > 2
    # Nothing is worth lines that zigzag.
    assert report.form.zigzag >= min(0.85, report.form.zigzag_start) - 0.05


def test_how_far_off_is_far_is_told_by_the_size_of_the_start():
    """By that of the net it sets out from, which has drawn back, 8 kinds were the fewest."""
    start = shared_mesh("quad_dome")
    report = optimise(start, "planar", repeat="panels", kinds=6, alike=0.0016).report
    assert report.is_repeated and report.form.off_surface.percent <= 2.0


def test_rows_are_what_lies_along_lines():
    mesh = surface_of_revolution(5, 4)
    around = mesh.connectivity.edge_families
    # Vertices are numbered along meridians: faces 0, 1, 2 lie on one.
    family = int(around[np.flatnonzero((mesh.connectivity.edges == [0, 1]).all(axis=1))[0]])
    assert len(np.unique(rows_along(mesh, "panels", family))) == 4
    assert len(np.unique(rows_along(mesh, "panels", 1 - family))) == 3
    assert len(np.unique(rows_along(mesh, "panels", 1 - family, 2))) == 6
    assert len(np.unique(rows_along(mesh, "nodes", family))) == 5
    # Across four rows, and along five lines.
    assert len(np.unique(rows_along(mesh, "edges", family))) == 4 + 5
    rows = rows_along(mesh, "panels", 1 - family).reshape(4, 3)
    assert (rows == rows[0]).all() and len(set(rows[0])) == 3


def test_sorting_parts_anew_never_raises_the_energy():
    mesh = wavy_grid(9, 8, shear=0.1)
    x = mesh.vertices.ravel() + 0.02 * np.random.default_rng(1).normal(size=mesh.vertices.size)
    (term,) = near_ones(mesh, mesh.vertices.ravel(), "panels", 7, 30)
    energies = [(term.linearise(x).residual ** 2).sum()]
    for _ in range(4):
        term = term.follow(x)
        energies.append((term.linearise(x).residual ** 2).sum())
    assert energies[1] < energies[0] and (np.diff(energies) <= 1e-15).all()


def test_the_two_rows_that_are_most_alike_become_one():
    mesh = surface_of_revolution()
    x = mesh.vertices.ravel()
    found = [in_rows(mesh, x, "panels", family, None) for family in (0, 1)]
    (rows,) = min(found, key=lambda terms: len(terms[0].shapes))
    assert len(rows.shapes) == 6
    (fewer,) = merged([rows], 5, x)
    together = [np.unique(rows.kind[fewer.kind == k]) for k in range(5)]
    pair = next(group for group in together if len(group) == 2)
    turned = rows.shapes[:, rows.orders][:, :, None] - rows.shapes
    away = np.linalg.norm(turned, axis=3).min(axis=1) + np.eye(6)
    assert away[tuple(pair)] == pytest.approx(away.min())


def test_a_panel_turned_by_half_is_of_the_same_kind():
    corners = np.array([[0, 0, 0], [2, 0, 0], [1.8, 1, 0], [0.1, 1.2, 0]])
    points = np.concatenate([corners, np.roll(corners, 2, axis=0) + 5])
    mesh = QuadMesh(points, np.arange(8).reshape(2, 4))
    turns = (np.arange(4)[:, None] + np.arange(4)) % 4
    term = SameLengths(mesh.faces, turns, apart(mesh)[:1], np.ones(2))
    assert np.abs(term.linearise(points.ravel()).residual).max() <= 1e-14


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"repeat": "panes"}, "repeat: expected none, panels, edges or nodes, got 'panes'"),
        ({"repeat": "panels", "kinds": 0}, "kinds: expected 1 to 48, as the mesh has 48 panels"),
        ({"repeat": "edges", "kinds": 111}, "expected 1 to 110"),
        ({"repeat": "nodes", "kinds": 2}, "expected 3 to 63.*one for each number of edges"),
        ({"repeat": "panels", "alike": -1.0}, "alike: expected a number above 0, got -1.0"),
        ({"repeat": "nodes", "alike_angle": 0.0}, "alike angle: expected a number above 0 degrees"),
        (
            {"repeat": "panels", "constraints": Constraints(handles={0: np.zeros(3)})},
            "nets with handles",
        ),
    ],
)
def test_what_cannot_be_is_refused(settings, words):
    with pytest.raises(InputError, match=words):
        optimise(bent_barrel(), **settings)


def test_live_editing_does_not_look_for_kinds():
    mesh = bent_barrel()
    session = Session(mesh, [0], repeat="panels", kinds=6)
    session.drag({0: mesh.vertices[0] + 0.01})
    assert session.settle().report.repetition is None
