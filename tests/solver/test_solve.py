"""Nets posed term by term, with nothing but what `solver` offers by name."""

from __future__ import annotations

import numpy as np
import pytest

import solver
from solver import (
    BoundaryGlide,
    Constraints,
    InputError,
    Linearisation,
    OnEdges,
    OnFaces,
    PlaneGlide,
    QuadMesh,
    of_mesh,
    optimise,
    pose,
    read_mesh,
    solve,
    write_mesh,
)
from solver.analysis import measures
from solver.terms.orthogonality import Orthogonality
from solver.terms.planarity import Planarity
from tests.conftest import ROOT, wavy_grid


class Long(OnEdges):
    """Edges are as long as the mean edge of the start: r = |d| - 1."""

    name = "length"

    def linearise(self, x):
        ends = x[self.unknowns].reshape(-1, 2, 3)
        d = ends[:, 1] - ends[:, 0]
        size = np.linalg.norm(d, axis=1)
        along = d / size[:, None]
        return Linearisation((size - 1)[:, None], np.hstack([-along, along])[:, None, :])


def test_every_name_is_there_and_has_its_words():
    assert sorted(solver.__all__) == solver.__all__
    for name in solver.__all__:
        assert getattr(solver, name).__doc__, name


def test_a_net_of_own_terms_is_solved_and_reported():
    start = wavy_grid(8, 7)
    problem = pose(start, "rods").require(Long(start.connectivity.edges))
    before = problem.start.copy()
    outcome = solve(problem)
    assert outcome.report.status == "converged" and outcome.report.net == "rods"
    np.testing.assert_allclose(outcome.mesh.edge_lengths, start.mean_edge, rtol=1e-9)
    # One equation an edge, no more unknowns than coordinates.
    assert outcome.report.constraints == len(start.connectivity.edges)
    assert outcome.report.variables == start.vertices.size
    assert (problem.start == before).all() and problem.mesh is start


def test_by_default_a_term_is_judged_by_its_own_residuals():
    start = wavy_grid(8, 7)
    report = solve(pose(start).require(Planarity(start.faces)), max_steps=1).report
    own = report.residuals["planarity"].max
    same = solve(
        pose(start).require(Planarity(start.faces), of_mesh(measures.planarity)), max_steps=1
    )
    assert own == pytest.approx(same.report.residuals["planarity"].max, rel=1e-9)
    assert "planarity" in report.message and "at face" in report.message


def test_the_same_terms_reach_what_the_net_of_the_table_reaches():
    start = wavy_grid(8, 7)
    problem = pose(start, "principal")
    problem.require(Orthogonality(start.faces), of_mesh(measures.orthogonality))
    problem.require(Planarity(start.faces), of_mesh(measures.planarity))
    same = optimise(start, "principal").mesh.vertices
    np.testing.assert_allclose(solve(problem).mesh.vertices, same, atol=1e-9)


def test_what_holds_vertices_holds_them():
    start = wavy_grid(8, 7)
    rim = start.connectivity.boundary_vertices
    held = pose(start, fix="boundary").require(Planarity(start.faces))
    assert (solve(held, max_steps=5).mesh.vertices[rim] == start.vertices[rim]).all()

    row = np.flatnonzero(start.vertices[:, 1] == 0.0)
    wanted = Constraints(glide=(PlaneGlide(1, 0.0),))
    outcome = solve(pose(start, constraints=wanted).require(Planarity(start.faces)))
    assert outcome.report.status == "converged", outcome.report.message
    assert set(outcome.report.residuals) == {"planarity", "glide"}
    np.testing.assert_allclose(outcome.mesh.vertices[row, 1], 0.0, atol=1e-9)
    assert np.abs(outcome.mesh.vertices - start.vertices)[row].max() > 0.01

    corners = np.flatnonzero(start.connectivity.corners)
    own = pose(start, constraints=Constraints(glide=(BoundaryGlide(),)))
    moved = solve(own.require(Planarity(start.faces)), max_steps=5).mesh.vertices
    assert (moved[corners] == start.vertices[corners]).all()


def test_handles_pull_and_a_callback_stops():
    start = wavy_grid(8, 7)
    goal = start.vertices[0] + [0.0, 0.0, 1.0]
    problem = pose(start, constraints=Constraints(handles={0: goal}))
    outcome = solve(problem.require(Planarity(start.faces)))
    assert np.linalg.norm(outcome.mesh.vertices[0] - goal) < 0.5
    stopped = solve(pose(start).require(Planarity(start.faces)), callback=lambda record: True)
    assert (stopped.report.status, stopped.report.iterations) == ("stopped", 1)


def test_what_cannot_be_solved_is_refused_in_one_line():
    start = wavy_grid(4, 4)
    with pytest.raises(InputError, match=r"^own net: nothing is required of it; add a term"):
        solve(pose(start))
    posed = pose(start).require(Planarity(start.faces))
    with pytest.raises(InputError, match=r"^tolerance: expected a (finite )?number"):
        solve(posed, tolerance=0)
    with pytest.raises(InputError, match=r"^max steps: expected a whole number, 1 or more, got 0"):
        solve(posed, max_steps=0)
    with pytest.raises(InputError, match=r"^fix: vertex 99 does not exist"):
        pose(start, fix=[99])


class Wrong(OnFaces):
    """Gives whatever it is told to."""

    name = "wrong"
    told = ()

    def linearise(self, x):
        return Linearisation(*self.told)


@pytest.mark.parametrize(
    ("residual", "jacobian", "says"),
    [
        (
            np.zeros(9),
            np.zeros((9, 12)),
            r"residuals \(9, m\) and a Jacobian \(9, m, 12\), got \(9,\)",
        ),
        (np.zeros((9, 1)), np.zeros((9, 2, 12)), r"got \(9, 1\) and \(9, 2, 12\); one row of them"),
        (np.zeros((8, 1)), np.zeros((8, 1, 12)), "expected residuals"),
        (np.full((9, 1), np.nan), np.zeros((9, 1, 12)), "is not finite at the start"),
    ],
)
def test_a_term_whose_arrays_do_not_fit_is_refused_in_one_line(
    monkeypatch, residual, jacobian, says
):
    start = wavy_grid(4, 4)
    monkeypatch.setattr(Wrong, "told", (residual, jacobian))
    with pytest.raises(InputError, match=f"^term wrong: .*{says}") as said:
        solve(pose(start).require(Wrong(start.faces)))
    assert "\n" not in str(said.value)


def test_what_is_no_term_or_sees_no_unknowns_is_refused_in_one_line():
    start = wavy_grid(4, 4)
    with pytest.raises(InputError, match=r"^term: str has no name, unknowns, linear, size, "):
        pose(start).require("planarity")
    strange = Planarity(np.array([[0, 1, 5, 99]]))
    with pytest.raises(InputError, match=r"^term planarity: .* between 0 and 47, got .* up to 299"):
        solve(pose(start).require(strange))


def test_a_single_face_will_do_and_a_plane_where_it_is_asked_for():
    face = QuadMesh([[0, 0, 0], [1, 0, 0], [1, 1, 0.3], [0, 1, 0]], [[0, 1, 2, 3]])
    problem = pose(face, fix=[0, 1, 3]).require(Planarity(face.faces))
    assert solve(problem).report.status == "collapsed"
    problem.may_flatten = True
    outcome = solve(problem)
    assert outcome.report.status == "converged"
    assert abs(outcome.mesh.vertices[2, 2]) < 1e-9


def test_files_are_read_and_written(tmp_path):
    roof = read_mesh(ROOT / "examples" / "data" / "demo_roof.obj")
    assert isinstance(roof, QuadMesh)
    write_mesh(tmp_path / "roof.ply", roof)
    again = read_mesh(tmp_path / "roof.ply")
    assert (again.vertices == roof.vertices).all() and (again.faces == roof.faces).all()
    with pytest.raises(InputError, match=r"roof\.png: expected a name that ends in \.obj"):
        write_mesh(tmp_path / "roof.png", roof)
