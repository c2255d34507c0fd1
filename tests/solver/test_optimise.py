"""The solver on real meshes: precision, shape, fixed vertices, bad settings, stopping."""

from __future__ import annotations

import numpy as np
import pytest

from solver import Constraints, InputError, QuadMesh, optimise, read_mesh, start_optimisation
from solver.analysis import measures
from solver.analysis.advisor import advice_as_dict
from solver.mesh.diagonal import diagonal_meshes
from solver.nets.constraints import BoundaryGlide
from tests.conftest import demo_roof, grid_faces, shared_input, shared_mesh, wavy_grid
from tests.meshes import grid, noisy, parameters, right_angles
from tests.solver.analysis.test_directions import saddle

# Name and largest mean move, in mean edges.
REQUIRED = {
    "heart": 2.0,
    "conical1": 1.0,
    "botanic-garden-bubble-0": 1.0,
    "complete01": 1.0,
    "demo roof": 1.0,
}


def mesh_named(name: str) -> QuadMesh:
    return demo_roof() if name == "demo roof" else shared_mesh(name)


@pytest.mark.parametrize("backend", ["rslab", "scipy"])
@pytest.mark.parametrize("name", REQUIRED)
def test_principal_meshes_to_machine_precision(name, backend):
    if backend == "rslab":
        pytest.importorskip("rslab", reason="rslab is optional; scipy is tested beside it")
    start = mesh_named(name)
    outcome = optimise(start, "principal", backend=backend)
    mesh, report = outcome.mesh, outcome.report
    assert report.status == "converged", report.message
    assert right_angles(mesh).max() <= 1e-10
    assert measures.planarity(mesh).max() <= 1e-10
    assert measures.edge_ratio(mesh) >= 0.5 * measures.edge_ratio(start)
    assert not measures.flipped(mesh).any()
    moved = np.linalg.norm(mesh.vertices - start.vertices, axis=1) / start.mean_edge
    assert moved.mean() <= REQUIRED[name]
    assert np.isclose(report.moved.mean, moved.mean())
    assert (mesh.faces == start.faces).all()


@pytest.mark.parametrize("name", REQUIRED)
def test_a_fixed_boundary_keeps_every_bit(name):
    start = mesh_named(name)
    before = measures.orthogonality(start).mean()
    outcome = optimise(start, "principal", fix="boundary", max_steps=60)
    rim = start.connectivity.boundary_vertices
    assert (outcome.mesh.vertices[rim] == start.vertices[rim]).all()
    assert (outcome.mesh.vertices[~rim] != start.vertices[~rim]).any()
    report = outcome.report
    measured = {
        "orthogonality": right_angles(outcome.mesh).max(),
        "planarity": measures.planarity(outcome.mesh).max(),
    }
    assert {name: spread.max for name, spread in report.residuals.items()} == measured
    assert (report.status == "converged") == (max(measured.values()) <= 1e-10)
    assert measures.orthogonality(outcome.mesh).mean() < before
    assert not measures.flipped(outcome.mesh).any()
    assert measures.edge_ratio(outcome.mesh) >= 0.25 * measures.edge_ratio(start)


def test_rounding_noise_of_the_unit_does_not_matter():
    start = wavy_grid(10, 9)
    small = optimise(start.scaled(1e-3))
    large = optimise(start.scaled(1e3))
    assert small.report.iterations == large.report.iterations
    assert np.allclose(small.mesh.vertices * 1e6, large.mesh.vertices, rtol=0, atol=1e-6)


def test_same_input_same_bytes():
    start = wavy_grid(10, 9)
    assert optimise(start).mesh.vertices.tobytes() == optimise(start).mesh.vertices.tobytes()


def test_report_counts_as_the_paper_does():
    start = wavy_grid(10, 9)
    report = optimise(start).report
    # Three coordinates a vertex and a normal a face; diagonals, four edges and unit length a face.
    assert report.variables == 3 * 90 + 3 * 72
    assert report.constraints == 6 * 72
    assert report.vertices == 90
    assert report.faces == 72
    assert report.seconds >= report.seconds_per_iteration >= report.solve_seconds_per_iteration > 0


def test_unreferenced_vertices_stay_and_components_are_independent():
    one, two = wavy_grid(8, 7), wavy_grid(6, 9, shear=0.3)
    lone = np.array([[100.0, 1 / 3, 7.0]])
    points = np.vstack([one.vertices, lone, two.vertices + [30.0, 0, 0]])
    faces = np.vstack([one.faces, two.faces + 57])
    outcome = optimise(QuadMesh(points, faces))
    assert outcome.report.status == "converged"
    assert (outcome.mesh.vertices[56] == lone[0]).all()


def test_a_principal_mesh_stays_where_it_is(barrel):
    outcome = optimise(barrel)
    assert outcome.report.status == "converged"
    assert outcome.report.iterations == 0
    assert (outcome.mesh.vertices == barrel.vertices).all()


def test_smoothing_a_principal_mesh_keeps_it_principal(barrel):
    outcome = optimise(barrel, fairness=0.1)
    assert outcome.report.status == "converged"
    assert 1e-3 < outcome.report.moved.max < 0.5


def test_stepping_equals_one_call_and_can_stop():
    start = wavy_grid(10, 9)
    run = start_optimisation(start)
    while not run.finished:
        record = run.step()
        assert record.step == len(run.history)
    whole = optimise(start)
    assert (run.outcome().mesh.vertices == whole.mesh.vertices).all()
    stopped = optimise(start, callback=lambda record: record.step == 3)
    assert stopped.report.status == "stopped"
    assert stopped.report.iterations == 3
    with pytest.raises(RuntimeError, match="finished"):
        run.step()


def test_an_interrupt_returns_what_there_is():
    def interrupt(record):
        if record.step == 2:
            raise KeyboardInterrupt

    outcome = optimise(wavy_grid(8, 8), callback=interrupt)
    assert outcome.report.status == "stopped"
    assert outcome.report.iterations == 2


def test_a_stalled_run_names_the_place():
    start = wavy_grid(6, 6)
    # Vertex 7 alone has to make faces 0 and 1 planar and orthogonal.
    report = optimise(start, fix=[0, 1, 2, 6, 8], max_steps=60).report
    assert report.status != "converged"
    assert "at face 0" in report.message or "at face 1" in report.message


def test_a_face_that_cannot_move_is_refused():
    with pytest.raises(InputError, match="face 0 cannot move at all, but its"):
        optimise(wavy_grid(6, 6), fix=[0, 1, 6, 7, 13])


def test_step_limit_is_said():
    report = optimise(wavy_grid(10, 9), max_steps=4).report
    assert report.status == "stopped"
    assert "more than 4 steps" in report.message


def test_corner_fixing_and_vertex_lists():
    start = wavy_grid(8, 7)
    for fix, numbers in (("corners", [0, 6, 49, 55]), ("3, 11", [3, 11]), ([5], [5])):
        outcome = optimise(start, fix=fix)
        assert (outcome.mesh.vertices[numbers] == start.vertices[numbers]).all()
        assert outcome.report.status == "converged"


def test_everything_fixed_moves_nothing():
    start = wavy_grid(5, 5)
    outcome = optimise(start, fix=range(25))
    assert (outcome.mesh.vertices == start.vertices).all()
    assert outcome.report.status == "stalled"


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"net": "wiggly"}, "net: expected "),
        ({"fix": "edges"}, "fix: expected none, corners, boundary"),
        ({"fix": "0,99"}, "fix: vertex 99 does not exist"),
        ({"fairness": -1.0}, "fairness: expected 0 or more, got -1.0"),
        ({"closeness": float("nan")}, "closeness: expected a finite number, got nan"),
        ({"tolerance": 0.0}, "tolerance: expected a number above 0, got 0.0"),
        ({"max_steps": 0}, "max steps: expected a whole number, 1 or more"),
        ({"backend": "abacus"}, "sparse solver: expected "),
    ],
)
def test_bad_settings_are_refused_in_one_line(settings, words):
    with pytest.raises(InputError, match=words) as caught:
        optimise(wavy_grid(4, 4), **settings)
    assert "\n" not in str(caught.value)


def test_corners_of_a_closed_band_do_not_exist():
    count = 12
    angle = 2 * np.pi * np.arange(count) / count
    ring = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    points = np.vstack([ring, 1.5 * ring + [0, 0, 0.4]])
    around = (np.arange(count) + 1) % count
    faces = np.stack([np.arange(count), around, around + count, np.arange(count) + count], axis=1)
    with pytest.raises(InputError, match="has no corners"):
        optimise(QuadMesh(points, faces), fix="corners")


def test_grid_faces_helper_is_oriented():
    mesh = QuadMesh([[0, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 0]], grid_faces(2, 2))
    assert mesh.face_normals[0, 2] == 1.0


def test_shape_that_was_given_up_is_told_in_numbers():
    x, y = parameters(11, 9, 10.0, 8.0)
    dome = grid(x, y, 3.7 - 0.09 * (x**2 + y**2))
    report = optimise(dome, "asymptotic").report
    assert report.status == "collapsed" and report.far
    assert "as a plane only" in report.message and "fixed or glides" in report.message
    assert "where a surface bulges it has no such lines" in report.message
    assert report.size_start[2] == np.ptp(dome.vertices[:, 2])
    assert report.size[2] < 0.5 * report.size_start[2]
    assert report.mean_edge == dome.mean_edge
    near = optimise(dome, "principal").report
    assert near.status == "converged" and not near.far


def test_net_that_is_there_already_is_called_so():
    found = optimise(grid(*parameters(5, 4, 4.0, 3.0), np.zeros((5, 4))), "principal")
    assert found.report.iterations == 0 and not found.report.far
    assert found.report.message.startswith("the mesh is a principal net already")
    assert advice_as_dict(found.mesh)["already"]
    assert advice_as_dict(found.mesh)["recommendation"].endswith("net already")


def test_a_collapse_to_a_plane_is_no_success_and_names_the_start_that_keeps_its_height():
    start = saddle()
    found = optimise(start, "principal")
    assert np.ptp(found.mesh.vertices[:, 2]) < 1e-6 * np.ptp(start.vertices[:, 2])
    assert found.report.status == "collapsed"
    assert "as a plane only" in found.report.message
    assert "its diagonal mesh (diagonal IN.obj -o OUT.obj)" in found.report.message
    other = diagonal_meshes(start).first
    kept = optimise(other, "principal")
    assert kept.report.status == "converged"
    assert np.ptp(kept.mesh.vertices[:, 2]) > 0.9 * np.ptp(other.vertices[:, 2])


def test_a_plane_that_was_asked_for_is_a_success():
    start = saddle(rows=7, columns=7)
    x, y = parameters(3, 3, 30.0, 30.0)
    level = grid(x, y, 0 * x)
    triangles = level.faces[:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3)
    near = Constraints(close_to=(level.vertices, triangles))
    found = optimise(start, "principal", constraints=near)
    assert measures.thickness(found.mesh) < 0.05 * measures.thickness(start)
    assert found.report.status == "converged", found.report.message
    for net in ("geodesic", "dog", "chebyshev", "geodesic-chebyshev", "isometric"):
        assert start_optimisation(start, net).original.may_flatten
    assert not start_optimisation(start, "asymptotic").original.may_flatten
    flat = noisy(grid(*parameters(7, 7, 6.0, 6.0), np.zeros((7, 7))), 0.02)
    assert optimise(flat, "principal").report.status == "converged"


@pytest.mark.parametrize(("shift", "said"), [(0.45, True), (0.0, False)])
def test_a_net_that_zigzags_is_not_called_one_without_a_word(shift, said):
    x, y = np.meshgrid(np.arange(9.0), np.arange(9.0))
    report = optimise(grid(x + shift * (y % 2), y, 0.05 * (x**2 - y**2)), "planar").report
    assert report.status == "converged"
    assert any("lines zigzag (evenness" in remark for remark in report.remarks) == said


def test_lines_that_zigzag_much_more_than_those_of_the_start_are_said():
    start = read_mesh(shared_input("near.obj"))
    glide = Constraints(glide=(BoundaryGlide(),))
    report = optimise(start, "principal", constraints=glide).report
    assert report.form.zigzag_start > 0.9 > 0.6 > report.form.zigzag
    assert any("lines zigzag (evenness" in remark for remark in report.remarks)
