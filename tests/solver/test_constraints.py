"""Handles, gliding, symmetry, a surface to stay near."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from solver import Constraints, InputError, NetOptions, Session, optimise
from solver.analysis import measures
from solver.candidate import judge
from solver.mesh.closest import Polyline, TriangleSurface
from solver.nets import NETS
from solver.nets.constraints import (
    BoundaryGlide,
    CurveGlide,
    PlaneGlide,
    SurfaceGlide,
    settled,
)
from solver.nets.options import OPTIONS
from solver.nets.settings import Weights
from solver.plan import Plan
from tests.conftest import QuadMesh, grid_faces, surface_of_revolution, wavy_grid
from tests.meshes import noisy

TRIANGLE = np.eye(3), np.array([[0, 1, 2]])


def bent_sheet(rows: int = 13, columns: int = 11) -> QuadMesh:
    angle = np.linspace(-0.7, 0.7, rows)
    i, j = np.meshgrid(angle, 0.1 * np.arange(columns), indexing="ij")
    points = np.stack([np.sin(i), j, np.cos(i)], axis=2).reshape(-1, 3)
    return QuadMesh(points, grid_faces(rows, columns))


def solved(outcome):
    assert outcome.report.status == "converged", outcome.report.message
    return outcome.mesh


def test_feet_glide_on_the_ground():
    start = wavy_grid(10, 9)
    tilted = start.with_vertices(start.vertices - [0, 0, start.vertices[:9, 2].min()])
    feet = np.arange(9)
    raised = tilted.vertices.copy()
    raised[feet, 2] = 0.1 * np.sin(feet)
    start = tilted.with_vertices(raised)
    glide = PlaneGlide(2, 0.0, feet)
    mesh = solved(optimise(start, constraints=Constraints(glide=(glide,))))
    assert np.abs(mesh.vertices[feet, 2]).max() <= 1e-10 * start.mean_edge
    assert np.abs(mesh.vertices[feet, :2] - start.vertices[feet, :2]).max() > 1e-3


def test_the_boundary_glides_on_its_own_curve():
    start = wavy_grid(12, 11, shear=0.05)
    outcome = optimise(start, "orthogonal", constraints=Constraints(glide=(BoundaryGlide(),)))
    mesh = solved(outcome)
    (loop,) = start.connectivity.boundary_loops
    feet, _ = Polyline(start.vertices[loop], closed=True).closest(mesh.vertices[loop])
    assert np.linalg.norm(mesh.vertices[loop] - feet, axis=1).max() <= 1e-10
    corners = start.connectivity.corners
    assert (mesh.vertices[corners] == start.vertices[corners]).all()
    moved = np.linalg.norm(mesh.vertices[loop] - start.vertices[loop], axis=1)
    assert moved.max() > 1e-3


def test_a_net_reached_through_an_easier_one_glides_on_the_start_curve():
    start, fixed = wavy_grid(7, 6), np.zeros(42, dtype=bool)
    wanted = settled(start, fixed, Constraints(glide=(BoundaryGlide(), PlaneGlide(1, 5.0))))
    plan = Plan(NETS["conical"], start, fixed, NetOptions(), wanted, Weights())
    way, failed = plan.way(), judge(plan.original, plan.original.start, 1e-10)
    next(way)
    way_round = way.send(failed)
    assert way_round.easier
    arrived = replace(failed, mesh=noisy(start, 0.3, seed=1), met=True)
    later = way.send(arrived).problem
    assert later.mesh is arrived.mesh
    assert later.measures["glide"](start, np.zeros(0)).max() <= 1e-14
    gliding = [term.vertices.tolist() for term in later.constraints if term.name == "glide"]
    assert gliding == [start.connectivity.boundary_loops[0].tolist(), list(range(5, 42, 6))]


def test_boundaries_that_touch_glide_each_on_its_own():
    points = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.1], [2, 1, 0], [2, 2, 0.1], [1, 2.2, 0]]
    start = QuadMesh(points, [[0, 1, 2, 3], [2, 4, 5, 6]])
    outcome = optimise(start, "orthogonal", constraints=Constraints(glide=(BoundaryGlide(),)))
    assert outcome.report.residuals["glide"].max <= 1e-10


def test_vertices_glide_on_a_drawn_curve():
    start = wavy_grid(10, 9, shear=0.1)
    rim = np.arange(9)
    curve = start.vertices[rim] + [0.2, 0.0, 0.1]
    glide = CurveGlide(np.vstack([curve[0] - [0, 3, 0], curve, curve[-1] + [0, 3, 0]]))
    mesh = solved(optimise(start, "orthogonal", constraints=Constraints(glide=(glide,))))
    feet, _ = Polyline(glide.points, closed=False).closest(mesh.vertices[rim])
    assert np.linalg.norm(mesh.vertices[rim] - feet, axis=1).max() <= 1e-10


def test_all_vertices_glide_on_a_surface():
    fine = surface_of_revolution(41, 31)
    surface = TriangleSurface.from_quads(fine)
    start = surface_of_revolution(9, 7)
    noise = 0.05 * np.random.default_rng(3).normal(size=start.vertices.shape)
    start = start.with_vertices(start.vertices + noise)
    glide = SurfaceGlide(surface.vertices, surface.triangles)
    mesh = solved(optimise(start, "orthogonal", constraints=Constraints(glide=(glide,))))
    feet, _ = surface.closest(mesh.vertices)
    assert np.linalg.norm(mesh.vertices - feet, axis=1).max() <= 1e-10


def test_a_near_surface_draws_the_mesh():
    start = wavy_grid(10, 9)
    lifted = start.with_vertices(start.vertices + [0, 0, 0.8])
    surface = TriangleSurface.from_quads(lifted)
    near = Constraints(close_to=(surface.vertices, surface.triangles))
    mesh = solved(optimise(start, constraints=near))
    away = np.linalg.norm(mesh.vertices - surface.closest(mesh.vertices)[0], axis=1)
    before = np.linalg.norm(start.vertices - surface.closest(start.vertices)[0], axis=1)
    assert away.mean() < 0.3 * before.mean()


def test_symmetry_is_kept_exactly():
    i, j = np.meshgrid(np.arange(-5.0, 6.0), np.arange(8.0), indexing="ij")
    points = np.stack([i + 0.05 * i * j, j, 2 * np.cos(0.3 * i) + 0.2 * np.sin(j)], axis=2)
    start = QuadMesh(points.reshape(-1, 3), grid_faces(11, 8))
    mesh = solved(optimise(start, constraints=Constraints(symmetry="x")))
    twin = mesh.vertices.reshape(11, 8, 3)[::-1] * [-1, 1, 1]
    assert np.abs(mesh.vertices.reshape(11, 8, 3) - twin).max() <= 1e-10


def test_a_vertex_needs_a_mirror_image_of_its_own():
    i, j = np.meshgrid([-3.0, -2, -1, -0.1, 0.1, 0.2, 1, 2, 3], np.arange(4.0), indexing="ij")
    points = np.stack([i, j, 0.1 * i**2], axis=2).reshape(-1, 3)
    start = QuadMesh(points, grid_faces(9, 4))
    with pytest.raises(InputError, match="symmetry: vertex 20 has no mirror image"):
        optimise(start, "orthogonal", constraints=Constraints(symmetry="x"))


def test_isometric_dragging_by_two_handles_keeps_every_face():
    start = bent_sheet()
    handles = {5: start.vertices[5] + [0.1, 0, -0.1], 137: start.vertices[137] - [0.1, 0, 0.1]}
    outcome = optimise(start, "isometric", constraints=Constraints(handles=handles))
    mesh = solved(outcome)
    assert measures.isometry(mesh, start.vertices).max() <= 1e-10
    for vertex, target in handles.items():
        assert np.linalg.norm(mesh.vertices[vertex] - target) < 0.3 * np.linalg.norm(
            start.vertices[vertex] - target
        )


def test_isometry_as_a_guide_keeps_a_sheet_from_stretching():
    sheet = optimise(bent_sheet(), "geodesic").mesh
    stretched = {}
    for weight in (None, 10.0):
        session = Session(sheet, [0, 10, 132], "geodesic", isometry=weight)
        session.drag({132: sheet.vertices[132] + [-0.1, 0.0, 0.2]}, steps=5)
        found = solved(session.settle())
        stretched[weight] = np.abs(found.edge_lengths / sheet.edge_lengths - 1).max()
        assert measures.geodesic(found).max() <= 1e-10
    assert stretched[10.0] < 0.7 * stretched[None]


@pytest.mark.parametrize(
    ("constraints", "words"),
    [
        ({"handles": {999: np.zeros(3)}}, "handle: vertex 999 does not exist"),
        ({"handles": {0: np.zeros(3)}}, "handle: vertex 0 is fixed too"),
        ({"handles": {5: np.full(3, np.nan)}}, "handle: the target of vertex 5 is not finite"),
        ({"glide": (PlaneGlide(2, 1e3),)}, "no free boundary vertex lies within half"),
        ({"glide": (PlaneGlide(2, 0.0, np.array([3, -1])),)}, "glide: vertex -1 does not exist"),
        ({"glide": (SurfaceGlide(*TRIANGLE, np.array([30])),)}, "glide: vertex 30 does not exist"),
        ({"symmetry": "w"}, "symmetry: expected letters"),
        ({"symmetry": "x"}, "has no mirror image in the plane x=0"),
    ],
)
def test_contradictions_are_refused_in_one_line(constraints, words):
    with pytest.raises(InputError, match=words) as caught:
        optimise(wavy_grid(6, 5), fix=[0], constraints=Constraints(**constraints))
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("fix", "constraints", "words"),
    [
        ([0, 1, 6, 5], {}, "face 0 cannot move at all, but its orthogonality is off by"),
        ([3], {"glide": (PlaneGlide(2, 0.0, np.array([3, 4])),)}, "vertex 3 cannot move at all"),
    ],
)
def test_contradicting_fixes_are_refused(fix, constraints, words):
    with pytest.raises(InputError, match=words) as caught:
        optimise(wavy_grid(6, 5), fix=fix, constraints=Constraints(**constraints))
    assert "\n" not in str(caught.value) and "free one" in str(caught.value)


@pytest.mark.parametrize("net", ["asymptotic", "cmc", "geodesic", "conical"])
def test_a_mesh_without_stars_cannot_carry_star_nets(net):
    strip = wavy_grid(6, 2)
    with pytest.raises(InputError, match="needs inner vertices with four faces"):
        optimise(strip, net)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"radius": -2.0}, "radius: expected a number above 0, got -2"),
        ({"length": float("nan")}, "length: expected a finite number, got nan"),
        ({"angle": 180.0}, "angle: expected a number between 0 and 180 degrees, got 180"),
    ],
)
def test_bad_options_are_refused_in_one_line(options, words):
    with pytest.raises(InputError, match=words):
        NetOptions(**options)


@pytest.mark.parametrize(
    ("net", "options", "words"),
    [
        (
            "principal",
            {"radius": 3.0},
            "radius: only cmc nets have it, not principal; ",
        ),
        ("conical", {"diagonal": True}, "diagonal: only .*geodesic.* nets have it, not conical"),
        ("planar", {"reference": np.zeros((30, 3))}, "reference: only isometric nets have it"),
        ("cmc", {"forces": "tension"}, "forces: only stress nets have it, not cmc"),
    ],
)
def test_an_option_that_a_net_does_not_have_is_refused(net, options, words):
    with pytest.raises(InputError, match=f"^{words}"):
        optimise(wavy_grid(6, 5), net, options=NetOptions(**options))


def test_defaults_may_be_said_of_every_net():
    usual = {name: option.default for name, option in OPTIONS.items()}
    assert NetOptions(**usual).given == ()
    assert optimise(wavy_grid(6, 5), options=NetOptions(**usual)).report.status == "converged"


def test_a_reference_must_have_the_same_vertices():
    with pytest.raises(InputError, match="reference: expected 30 vertices"):
        optimise(wavy_grid(6, 5), "isometric", options=NetOptions(reference=np.zeros((4, 3))))
