"""Nets along lines of curvature: what they measure, what they cover, what is refused."""

from __future__ import annotations

import numpy as np
import pytest

from solver import Constraints, InputError, optimise
from solver.align.align import aligned
from solver.align.features import creased
from solver.align.reach import reaching
from solver.align.triangle_mesh import one_surface
from solver.analysis import form, measures
from solver.mesh.closest import Polyline, TriangleSurface
from tests.design_surfaces import (
    barrel,
    cap,
    catenoid,
    dome,
    hall,
    plane,
    saddle,
    triangles,
    without,
)

# The surfaces are 20 to 30 m wide, their triangles half a metre.
EDGE = 1.5


@pytest.fixture(scope="module")
def on_saddle():
    points, faces = triangles(saddle)
    return points, faces, aligned(points, faces, edge=EDGE)


@pytest.fixture(scope="module")
def on_dome():
    points, faces = triangles(dome)
    return points, faces, aligned(points, faces, edge=EDGE)


def off(points, mesh_points, mesh_faces):
    """Distances from triangles."""
    feet, _ = TriangleSurface(mesh_points, mesh_faces).closest(points)
    return np.linalg.norm(points - feet, axis=1)


def test_a_saddle_gets_a_net_that_is_nearly_principal(on_saddle):
    mesh = on_saddle[2].mesh
    assert not len(on_saddle[2].irregular)
    assert measures.orthogonality(mesh).max() < 3e-2
    assert measures.orthogonality(mesh).mean() < 5e-3
    assert measures.planarity(mesh).max() < 2e-3
    assert measures.planarity(mesh).mean() < 3e-4
    assert mesh.mean_edge == pytest.approx(EDGE, rel=0.05)


def test_the_net_covers_its_surface_and_overhangs_by_a_face_at_most(on_saddle):
    points, faces, made = on_saddle
    quads = TriangleSurface.from_quads(made.mesh)
    # A chord of an edge leaves a surface of radius 15 by 20 mm.
    assert off(points[faces].mean(axis=1), quads.vertices, quads.triangles).max() < 0.03
    far = off(made.mesh.vertices, points, faces)
    assert far.max() < 1.5 * EDGE
    larger = reaching(made.mesh, points, faces)
    assert off(made.mesh.vertices, *larger).max() < 0.01
    # Every face has a part on the surface.
    inner = far[made.mesh.faces].min(axis=1)
    assert inner.max() < EDGE


def beyond(formula, margin):
    """Points (N, 3) of a surface of 30 m by 20 m that lie beyond its border by a length."""
    along, across, run = margin / 30, margin / 20, np.linspace(0, 1, 200)
    sides = [(run, np.full(200, end)) for end in (-across, 1 + across)]
    sides += [(np.full(200, end), run) for end in (-along, 1 + along)]
    return np.concatenate([np.stack(formula(*side), axis=1) for side in sides])


def test_the_net_overhangs_by_so_much_that_its_vertices_may_move(on_saddle):
    made = on_saddle[2]
    quads = TriangleSurface.from_quads(made.mesh)
    assert off(beyond(saddle, 0.2 * EDGE), quads.vertices, quads.triangles).max() < 0.03


def test_the_border_is_carried_along(on_saddle):
    points, _, made = on_saddle
    (line,) = made.border
    assert len(line) == 2 * (61 + 37) - 4
    assert {tuple(row) for row in line} <= {tuple(row) for row in points}


def test_the_field_is_that_of_the_lines(on_saddle):
    points, faces, made = on_saddle
    field = made.field
    np.testing.assert_allclose(np.linalg.norm(field.directions, axis=2), 1.0)
    assert np.abs(np.einsum("nk,nk->n", *field.directions.transpose(1, 0, 2))).max() < 1e-12
    assert off(field.places, points, faces).max() < 0.02
    # Where a face of the net is near a cross, its edges run as one of the two directions.
    corners = made.mesh.vertices[made.mesh.faces]
    centre, along = corners.mean(axis=1), corners[:, 1] - corners[:, 0]
    nearest = np.linalg.norm(centre[:, None] - field.places[None], axis=2).argmin(axis=1)
    turned = np.einsum("nkj,nj->nk", field.directions[nearest], along)
    angles = np.arccos(np.abs(turned).max(axis=1) / np.linalg.norm(along, axis=1))
    near = np.linalg.norm(centre - field.places[nearest], axis=1) < 0.3 * EDGE
    assert near.mean() > 0.7
    assert np.degrees(angles[near]).max() < 5.0
    assert field.certainty.min() >= 0
    assert field.certainty.max() == 1.0
    assert not len(made.singular.places)


def test_singular_points_stand_at_the_irregular_vertices(on_dome):
    made = on_dome[2]
    assert len(made.singular.places) == len(made.irregular) > 0
    places = made.mesh.vertices[made.irregular]
    apart = np.linalg.norm(places[:, None] - made.singular.places[None], axis=2)
    assert apart.min(axis=1).max() < 0.2 * EDGE
    degrees = np.bincount(made.mesh.connectivity.edges.ravel())[made.irregular]
    assert (degrees == made.singular.valences[apart.argmin(axis=1)]).all()


def test_an_exact_net_is_a_hair_away(on_saddle):
    points, faces, made = on_saddle
    outcome = optimise(made.mesh, "principal", constraints=Constraints(close_to=(points, faces)))
    report = outcome.report
    assert report.status == "converged"
    surface = TriangleSurface(*reaching(made.mesh, points, faces))
    found = form.form_of(made.mesh, outcome.mesh, surface)
    assert found.off_surface.percent < 0.1
    assert found.area_ratio == pytest.approx(1, abs=0.005)
    assert found.zigzag > 0.95
    # The border is covered still.
    quads = TriangleSurface.from_quads(outcome.mesh)
    assert off(made.border[0], quads.vertices, quads.triangles).max() < 0.03


def test_a_dome_has_vertices_of_three_and_five_faces_at_its_umbilics(on_dome):
    made = on_dome[2]
    valence = np.bincount(made.mesh.faces.ravel())[made.irregular]
    assert sorted(valence) == [3, 3, 5, 5]
    places = made.mesh.vertices[made.irregular]
    # The dome has two planes of symmetry, and its umbilics lie on them.
    assert np.abs(places[:, :2]).min(axis=1).max() < 0.5 * EDGE
    assert form.form_of(made.mesh, made.mesh).zigzag > 0.5


def test_the_same_net_twice(on_dome):
    again = aligned(*on_dome[:2], edge=EDGE)
    assert np.array_equal(again.mesh.vertices, on_dome[2].mesh.vertices)
    assert np.array_equal(again.mesh.faces, on_dome[2].mesh.faces)


def test_last_digits_do_not_decide_between_two_nets(on_dome):
    points, faces, net = on_dome
    noise = np.random.default_rng(0).normal(size=points.shape)
    again = aligned(points + 1e-15 * noise, faces, edge=EDGE)
    assert np.array_equal(again.mesh.vertices, net.mesh.vertices)


def test_lines_for_asymptotic_do_not_curve_out_of_a_minimal_surface():
    points, faces = triangles(catenoid)
    made = aligned(points, faces, net="asymptotic", edge=1.0)
    along = aligned(points, faces, net="principal", edge=1.0)
    # The normal curvature of an edge, from the normals of the surface at its ends.
    bend = {}
    for name, mesh in (("asymptotic", made.mesh), ("principal", along.mesh)):
        ends = mesh.vertices[mesh.connectivity.edges]
        radius = np.hypot(ends[..., 0], ends[..., 1])
        normals = np.stack(
            [ends[..., 0] / radius, ends[..., 1] / radius, -np.sinh(ends[..., 2] / 5)], axis=-1
        )
        normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
        step = ends[:, 1] - ends[:, 0]
        turn = ((normals[:, 1] - normals[:, 0]) * step).sum(axis=1) / (step * step).sum(axis=1)
        bend[name] = np.abs(turn).mean()
    assert bend["asymptotic"] < 0.02 * bend["principal"]


def test_lines_run_along_a_stroke():
    points, faces = triangles(saddle)
    # Straight in plan, 30 degrees across the lines of curvature, which run along x and y here.
    x = np.linspace(-7, 7, 30)
    y = np.tan(np.radians(30)) * x
    u, v = (x - 0.15 * y) / 30.6, (y + x * 2 / 15) / 20.4
    stroke = np.stack([x, y, 12 * u**2 - 20 * v**2 + 2 * u * v], axis=1)

    def across(strokes):
        mesh = aligned(points, faces, edge=EDGE, strokes=strokes).mesh
        ends = mesh.vertices[mesh.connectivity.edges]
        middle, run = ends.mean(axis=1), ends[:, 1] - ends[:, 0]
        far = np.abs(middle[:, 1] - np.tan(np.radians(30)) * middle[:, 0])
        near = (far < 0.7) & (np.abs(middle[:, 0]) < 5)
        turn = np.degrees(np.arctan2(run[near, 1], run[near, 0])) - 30
        # Of lines along it and across it.
        return np.abs((turn + 45) % 90 - 45).mean()

    assert across([]) > 20
    assert across([stroke]) < 8
    with pytest.raises(InputError, match=r"stroke 2.*off the surface"):
        aligned(points, faces, edge=EDGE, strokes=[stroke, stroke + [0, 0, 9]])
    with pytest.raises(InputError, match="two points"):
        aligned(points, faces, edge=EDGE, strokes=[stroke[:1]])


def with_an_opening(points, faces):
    """A jagged half-round opening at the border."""
    return without(points, faces, lambda at: np.hypot(at[:, 0] - 13, at[:, 1] - 1) < 3.5)


@pytest.mark.parametrize("change", [lambda *surface: surface, with_an_opening])
def test_a_net_may_follow_the_border(change):
    points, faces = change(*triangles(saddle))
    made = aligned(points, faces, edge=EDGE, border="follow")
    assert made.border == ()
    surface = one_surface(points, faces)
    (loop,) = surface.loops()
    rim = Polyline(surface.points[[*loop, loop[0]]])
    mesh = made.mesh
    border = mesh.vertices[mesh.connectivity.boundary_vertices]
    assert np.linalg.norm(border - rim.closest(border)[0], axis=1).max() < 1e-5
    # The corners of the surface are corners of the net.
    corners = points[[0, 36, 60 * 37, 60 * 37 + 36]] if len(points) == 61 * 37 else points[[0, 36]]
    near = np.linalg.norm(border[:, None] - corners, axis=2).min(axis=0)
    assert near.max() < 1e-5
    assert not measures.flipped(mesh).any()
    assert measures.edge_ratio(mesh) > 0.4
    # Further in its lines are those of curvature.
    deep = rim_distance(mesh, rim) > 4 * EDGE
    assert deep.sum() > 20
    assert measures.orthogonality(mesh)[deep].max() < 0.06


def rim_distance(mesh, rim):
    """(F,) distance of faces from a polyline."""
    centres = mesh.vertices[mesh.faces].mean(axis=1)
    return np.linalg.norm(centres - rim.closest(centres)[0], axis=1)


@pytest.mark.parametrize("border", ["trim", "follow"])
def test_creases_are_lines_of_the_net(border):
    points, faces = triangles(hall, 61, 49)
    made = aligned(points, faces, edge=EDGE, border=border)
    mesh = made.mesh
    assert all("degrees to the lines of curvature" in remark for remark in made.remarks)
    assert not measures.flipped(mesh).any()
    pairs = mesh.vertices[mesh.connectivity.edges]
    for valley in (8.0, 16.0):
        on = (np.abs(pairs[:, :, 1] - valley) < 1e-5).all(axis=1)
        run = pairs[on][:, :, 0]
        # One after the other, to both ends of the hall, or to the last vertices before them.
        short = EDGE if border == "trim" else 1e-5
        assert np.ptp(run, axis=1).sum() == pytest.approx(np.ptp(run), rel=1e-6)
        assert run.min() < short
        assert run.max() > 30 - short


def test_a_crease_is_long_and_sharp():
    points, faces = triangles(hall, 31, 25)
    mesh = one_surface(points, faces)
    sharp = creased(mesh, EDGE)
    start, end = (mesh.points[side[sharp]] for side in mesh.ends)
    assert set(np.round(start[:, 1], 6)) | set(np.round(end[:, 1], 6)) == {8.0, 16.0}
    assert len(start) == 2 * 30
    assert not creased(mesh, 20.0).any()
    assert not creased(one_surface(*triangles(dome, 21, 15)), EDGE).any()


def test_rows_may_be_longer_than_they_are_wide():
    points, faces = triangles(barrel)
    made = aligned(points, faces, edge=1.2, ratio=2.0)
    corners = made.mesh.vertices[made.mesh.faces]
    sides = np.linalg.norm(corners - np.roll(corners, -1, axis=1), axis=2)
    one, two = sides[:, [0, 2]].mean(), sides[:, [1, 3]].mean()
    assert max(one, two) / min(one, two) == pytest.approx(2, rel=0.1)


def test_lines_run_round_an_opening():
    points, faces = triangles(saddle)
    points, faces = without(points, faces, lambda c: np.hypot(c[:, 0] - 2, c[:, 1] - 1) < 4)
    made = aligned(points, faces, edge=EDGE)
    assert len(made.border) == 2
    assert len(made.mesh.connectivity.boundary_loops) == 2
    assert not len(made.irregular)


def test_a_small_opening_is_run_over_and_said():
    points, faces = triangles(saddle)
    points, faces = without(points, faces, lambda c: np.hypot(c[:, 0] - 2, c[:, 1] - 1) < 0.6)
    made = aligned(points, faces, edge=3.0)
    assert len(made.mesh.connectivity.boundary_loops) == 1
    (said,) = made.remarks
    assert "the opening at (1." in said or "the opening at (2." in said
    assert "lines run over it" in said


def test_no_opening_is_closed_without_a_word():
    points, faces = triangles(saddle)
    for radius in (1.2, 1.6, 2.0, 2.4):
        inside = np.array([2.0, 1.0])
        open_ = without(points, faces, lambda c: np.hypot(*(c[:, :2] - inside).T) < radius)  # noqa: B023
        made = aligned(*open_, edge=2.0)
        loops = len(made.mesh.connectivity.boundary_loops)
        assert loops + len(made.remarks) == 2


@pytest.mark.parametrize("formula", [plane, cap])
def test_flat_and_round_surfaces_get_lines_along_their_border(formula):
    points, faces = triangles(formula, 41, 31)
    made = aligned(points, faces, edge=1.0)
    assert any("along its border" in remark for remark in made.remarks)
    rim = made.mesh.vertices[made.mesh.connectivity.boundary_vertices]
    assert len(rim) > 20
    assert measures.orthogonality(made.mesh).mean() < 2e-2
    with pytest.raises(InputError, match="flat or round"):
        aligned(points, faces, net="asymptotic", edge=1.0)


def test_noise_is_smoothed_and_said():
    points, faces = triangles(saddle)
    noise = np.random.default_rng(3).normal(size=points.shape)
    made = aligned(points + 0.02 * noise, faces, edge=EDGE)
    assert any("rough" in remark for remark in made.remarks)
    assert not len(made.irregular)
    assert off(made.mesh.vertices, *reaching(made.mesh, points, faces)).mean() < 0.015


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (dict(edge=90.0), "leaves room for"),
        (dict(edge=0.01), r"faces, 100,000 at most; 0\.\d+ would give about a thousand"),
        (dict(edge=-1.0), "edge: expected a number above 0"),
        (dict(edge=float("nan")), "edge: expected a finite number, got nan"),
        (dict(edge=1.0, ratio=0.0), "ratio"),
        (dict(edge=1.0, border="cut"), "border: expected trim or follow"),
        (dict(edge=1.0, net="cubic"), "net: expected principal, developable"),
        (dict(edge=1.0, net="asymptotic"), "bends both ways"),
    ],
)
def test_what_cannot_be_is_said_in_a_line(change, words):
    points, faces = triangles(dome, 31, 21)
    with pytest.raises(InputError, match=words) as caught:
        aligned(points, faces, **change)
    assert "\n" not in str(caught.value)


def test_surfaces_that_are_none_are_refused():
    points, faces = triangles(plane, 11, 11)
    with pytest.raises(InputError, match="2 pieces"):
        aligned(
            np.concatenate([points, points + [50, 0, 0]]),
            np.concatenate([faces, faces + len(points)]),
            edge=2.0,
        )
    u = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    ring, angle = np.meshgrid(u, u, indexing="ij")
    torus = np.stack(
        [(5 + np.cos(angle)) * np.cos(ring), (5 + np.cos(angle)) * np.sin(ring), np.sin(angle)], -1
    ).reshape(-1, 3)
    k = np.arange(1600).reshape(40, 40)
    quads = [k, np.roll(k, -1, 0), np.roll(k, (-1, -1), (0, 1)), np.roll(k, -1, 1)]
    q = np.stack(quads, axis=-1).reshape(-1, 4)
    with pytest.raises(InputError, match="closed"):
        aligned(torus, np.concatenate([q[:, :3], q[:, [0, 2, 3]]]), edge=1.0)
    with pytest.raises(InputError, match="one side"):
        aligned(*_moebius(), edge=0.5)


def _moebius():
    along = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    across = np.linspace(-0.5, 0.5, 5)
    a, t = np.meshgrid(along, across, indexing="ij")
    radius = 4 + t * np.cos(a / 2)
    points = np.stack([radius * np.cos(a), radius * np.sin(a), t * np.sin(a / 2)], -1)
    k = np.arange(200).reshape(40, 5)
    following = np.concatenate([k[1:], k[:1, ::-1]])
    q = np.stack([k[:, :-1], following[:, :-1], following[:, 1:], k[:, 1:]], -1).reshape(-1, 4)
    return points.reshape(-1, 3), np.concatenate([q[:, :3], q[:, [0, 2, 3]]])


def test_stages_are_told_and_may_break_it_off():
    points, faces = triangles(saddle, 31, 21)
    seen = []
    aligned(points, faces, edge=2.5, waiting=seen.append)
    assert list(dict.fromkeys(seen)) == ["curvature", "directions", "map", "quads"]

    def stop(stage):
        if stage == "map":
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        aligned(points, faces, edge=2.5, waiting=stop)
