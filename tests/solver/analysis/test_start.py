"""What is said of a start before the first step, where it is right and where it would be noise."""

from __future__ import annotations

import numpy as np
import pytest

from solver import Constraints, QuadMesh, optimise, start_optimisation
from solver.analysis.advisor import advise
from solver.analysis.start import start_remarks
from solver.mesh.diagonal import diagonal_meshes
from solver.mesh.quadmesh import unit_rows
from solver.nets.constraints import BoundaryGlide
from tests.conftest import demo_roof, shared_mesh, surface_of_revolution, wavy_grid
from tests.meshes import (
    constant_ratio,
    freeform_saddle,
    grid,
    helicoid,
    noisy,
    scherk,
    unduloid,
)
from tests.solver.analysis.test_directions import saddle
from tests.solver.mesh.test_derived import star_of

GLIDE = Constraints(glide=(BoundaryGlide(),))


def canopy(rows: int = 13, columns: int = 9):
    """A roof that a formula draws: its lines nearly follow the curvature, its border does not."""
    u, v = np.meshgrid(np.linspace(0, 1, rows), np.linspace(0, 1, columns), indexing="ij")
    lift = 3 * np.sin(np.pi * v) * (1 - 0.6 * u) + 2 * np.sin(1.5 * np.pi * u) * (v - 0.5)
    return grid(30 * u, 18 * v, 4 + lift)


def causes(mesh, net="principal", **settings):
    return [remark.cause for remark in start_remarks(mesh, net, **settings)]


@pytest.mark.parametrize("net", ["principal", "circular", "conical"])
def test_lines_across_the_curvature_are_told_with_the_mesh_that_follows_it(net):
    for mesh in (saddle(), scherk(), helicoid(), noisy(scherk())):
        (remark,) = start_remarks(mesh, net)
        assert remark.cause == "diagonal"
        assert "diagonal IN.obj" in str(remark)
        verdicts = {one.net: one for one in advise(mesh) if not one.diagonal}
        assert not verdicts[net].possible and verdicts[net].cause == "diagonal"
        assert verdicts["asymptotic"].possible
    assert "45 degrees" in str(start_remarks(saddle(), net)[0])
    assert causes(diagonal_meshes(saddle()).first, net) == []


def test_lines_that_bend_with_a_saddle_are_told_where_a_net_of_asymptotic_ones_is_wanted():
    asked = {"net": "asymptotic-angle", "asymptotic": True}
    other, remark = start_remarks(diagonal_meshes(saddle()).first, **asked)
    assert (other.cause, remark.cause) == ("variant", "bent")
    assert "align it with lines for asymptotic-angle" in str(remark)
    for mesh in (saddle(), scherk(), constant_ratio(13, 13, 0.5), freeform_saddle()):
        assert causes(mesh, **asked) == []
    assert "of its area only" in str(start_remarks(canopy(), **asked)[0])
    assert causes(canopy(), "asymptotic-angle", diagonal=True, asymptotic=True) == ["bulging"]


def test_lines_between_the_curvature_and_its_diagonals_have_no_mesh_that_follows_it():
    assert causes(saddle(20.0)) == ["oblique"]


def test_nothing_is_said_of_starts_that_do_well():
    for mesh in (demo_roof(), wavy_grid(10, 9), surface_of_revolution(), unduloid()):
        assert causes(mesh) == []
        assert next(one for one in advise(mesh) if one.net == "principal").possible
    assert causes(saddle(), "asymptotic") == []


@pytest.mark.parametrize("name", ["heart", "conical1", "botanic-garden-bubble-0", "complete01"])
def test_nothing_is_said_of_meshes_of_the_paper_that_do_well(name):
    mesh = shared_mesh(name)
    assert causes(mesh) == []
    assert next(one for one in advise(mesh) if one.net == "principal").possible


def test_a_held_border_that_twists_the_surface_is_measured():
    """Along the straight border of z = c x y the normal turns by the difference of arctan(c x)."""
    x, y = np.meshgrid(np.linspace(0, 4, 9), np.linspace(0, 3, 7), indexing="ij")
    mesh = grid(x, y, 0.1 * x * y)
    everywhere = np.ones(len(mesh.vertices), dtype=bool)
    remark = next(
        one for one in start_remarks(mesh, "principal", held=everywhere) if one.cause == "border"
    )
    turn, *ends = remark.numbers
    assert turn == pytest.approx(np.degrees(np.arctan(0.4)), abs=1e-9)
    # Of the four sides, that along x at y = 0 turns farthest.
    assert set(ends) in ({0, 56}, {6, 62})
    assert f"{turn:.1f} degrees" in str(remark)
    assert not any(one.cause == "border" for one in start_remarks(mesh, "principal"))


def test_a_held_border_in_a_plane_twists_by_the_difference_of_its_corners():
    """Parallel normals of a curve in a plane keep their angle to that plane, here 20, then 50."""
    slope = np.radians(np.linspace(0, 90, 7))
    curve = np.stack([np.sin(slope), 0 * slope, 1 - np.cos(slope)], axis=1)
    chords = unit_rows(np.diff(curve, axis=0))[[0, 0, 1, 2, 3, 5, 5]]
    rise = np.radians([20, 25, 30, 35, 40, 45, 50])[:, None]
    inward = np.cross(chords, [0.0, 1.0, 0.0])
    beside = curve + 0.4 * (np.cos(rise) * [0.0, 1.0, 0.0] + np.sin(rise) * inward + 0.3 * chords)
    mesh = grid(*np.moveaxis(np.stack([curve, beside], axis=1), 2, 0))
    held = np.ones(14, dtype=bool)
    held[3:12:2] = False
    remark = next(
        one for one in start_remarks(mesh, "principal", held=held) if one.cause == "border"
    )
    turn, *ends = remark.numbers
    assert sorted(ends) == [0, 12]
    assert turn == pytest.approx(30, abs=1e-9)


def test_a_held_loop_without_corners_that_does_not_close_is_measured():
    """A tube's wavy rim; a plane rim is fine whatever its shape."""
    angle, height = np.meshgrid(np.linspace(0, 2 * np.pi, 25)[:-1], [0.0, 0.5, 1.0], indexing="ij")
    number = np.arange(72).reshape(24, 3)
    after = np.roll(number, -1, axis=0)
    faces = np.stack([number[:, :-1], after[:, :-1], after[:, 1:], number[:, 1:]], -1)
    radius = 1 + 0.2 * np.cos(2 * angle)
    for wave, expected in ((0.0, []), (0.4, ["border"])):
        lift = wave * (np.sin(2 * angle + 0.5) + np.sin(3 * angle))
        points = np.stack([radius * np.cos(angle), radius * np.sin(angle), height + lift], -1)
        mesh = QuadMesh(points.reshape(-1, 3), faces.reshape(-1, 4))
        held = np.ones(72, dtype=bool)
        assert [c for c in causes(mesh, held=held) if c == "border"] == expected


def test_gliding_border_that_is_out_of_reach_is_told_before_the_first_step():
    run = start_optimisation(canopy(), constraints=GLIDE)
    assert not run.history and [remark.cause for remark in run.remarks] == ["border"]
    report = run.run(lambda record: record.step >= 15).report
    assert report.warnings == [str(run.remarks[0])]
    assert report.status == "stopped"
    # Nothing was fixed, so there is nothing to free.
    assert "fixed" not in report.message
    assert "a border that may leave its curve" in report.message
    free = optimise(canopy())
    assert free.report.status == "converged" and not free.report.warnings


def test_gliding_border_that_is_within_reach_gets_no_remark():
    assert not start_optimisation(demo_roof(), constraints=GLIDE).remarks


def test_right_angles_that_no_face_has_to_have_are_no_distance():
    flat = star_of(5)
    flat = flat.with_vertices(flat.vertices * [1, 1, 0])
    assert flat.connectivity.singular_faces.all()
    (principal,) = [one for one in advise(flat) if one.net == "principal" and not one.diagonal]
    assert principal.distance < 1e-12


def test_advice_names_what_was_held():
    def advice(**settings):
        run = start_optimisation(wavy_grid(6, 6), **settings)
        run.step()
        run.stop()
        return run.outcome().report.message

    assert "fewer fixed vertices" in advice(fix=[0, 3])
    assert "fewer supports" in advice(net="stress", fix="boundary")
    assert "fewer" not in advice()


def test_planar_nets_are_told_where_no_flat_faces_are_near():
    """Most of a hyperbolic paraboloid along its lines; a part of a dome, whose diagonals differ."""
    x, y = np.meshgrid(np.linspace(-5, 5, 15), np.linspace(-5, 5, 15), indexing="ij")
    (remark,) = start_remarks(grid(x, y, 0.05 * x * y), "planar")
    assert remark.cause == "diagonal" and "on 100 %" in str(remark)
    dome = grid(3 * x, 2 * y, 6 * np.cos(0.27 * x) * np.cos(0.27 * y))
    (remark,) = start_remarks(dome, "planar")
    assert remark.cause == "oblique" and "diagonal" not in str(remark)
    # Along its principal lines any surface has flat faces near; so has a sphere, and a plane.
    for start in (grid(x, y, 0.05 * (x**2 - y**2)), surface_of_revolution(9, 9), grid(x, y, 0 * x)):
        assert causes(start, "planar") == []
