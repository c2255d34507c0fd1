"""Nets on faces that meet at creases: roofs of flat faces, and vaults with groins."""

from __future__ import annotations

import numpy as np
import pytest

from solver import Constraints, optimise
from solver.align.align import aligned
from solver.align.facets import FlatFaces, carried_on, turning, zipped
from solver.align.features import creased
from solver.align.patch_counts import counts_along
from solver.align.triangle_mesh import one_surface
from solver.analysis import measures
from solver.mesh.closest import TriangleSurface
from tests.design_surfaces import BENT, GABLE, HIP, WING, groined, sheet

UP = np.array([0.3, -0.2, 0.933])


@pytest.fixture(scope="module")
def vault():
    return aligned(*groined(), edge=1.6)


def run_along(net, start, end):
    """What part of a straight line edges of a net lie on."""
    start, end = np.array(start, dtype=float), np.array(end, dtype=float)
    along = (end - start) / np.linalg.norm(end - start)
    arms = net.vertices - start
    part = arms @ along / np.linalg.norm(end - start)
    on = np.linalg.norm(arms - np.outer(arms @ along, along), axis=1) < 1e-8
    on &= (part > -1e-6) & (part < 1 + 1e-6)
    edges = net.connectivity.edges
    return net.edge_lengths[on[edges].all(axis=1)].sum() / np.linalg.norm(end - start)


@pytest.mark.parametrize("border", ["trim", "follow"])
@pytest.mark.parametrize(("roof", "irregular"), [(HIP, 4), (BENT, 0), (GABLE, 0), (WING, 2)])
def test_lines_run_along_eaves_ridges_hips_and_valleys(roof, irregular, border):
    points, triangles = sheet(roof)
    made = aligned(points, triangles, edge=1.2, border=border)
    mesh = one_surface(points, triangles)
    start, end = mesh.half_edges[mesh.rim].T
    creases = turning(mesh, 0.03)
    for one, two in [*zip(start, end, strict=True), *np.transpose(mesh.ends)[creases]]:
        assert run_along(made.mesh, mesh.points[one], mesh.points[two]) == pytest.approx(1.0)
    # Coordinates are rounded to a part of 2^32 of the size, which those of the others have already.
    near = 1e-8 if roof is WING else 1e-12
    assert measures.planarity(made.mesh).max() < near
    assert (
        np.linalg.norm(
            TriangleSurface(points, triangles).closest(made.mesh.vertices)[0] - made.mesh.vertices,
            axis=1,
        ).max()
        < near
    )
    assert made.mesh.mean_edge == pytest.approx(1.2, rel=0.1)
    assert made.mesh.edge_lengths.min() > 0.4 * made.mesh.mean_edge
    assert len(made.irregular) == irregular == len(made.singular.places)
    # Slopes of five sides have another vertex in their middle than those of three.
    assert (made.singular.valences == (5 if roof is WING else 3)).all()
    assert not made.border and "flat faces" in made.remarks[0]
    assert np.abs((made.field.directions[:, 0] * made.field.directions[:, 1]).sum(1)).max() < 1e-12


def test_corners_are_right_on_a_gable_roof_and_askew_on_a_hip_roof():
    for roof, right in ((GABLE, True), (HIP, False)):
        made = aligned(*sheet(roof), edge=1.2)
        assert (measures.orthogonality(made.mesh).max() < 1e-12) == right
        assert ("corners right as" in made.remarks[1]) is right
        assert ("--net planar" in made.remarks[1]) is not right


def test_anywhere_and_in_any_unit_it_is_the_same_net():
    points, triangles = sheet(HIP)
    here = aligned(points, triangles, edge=1.2).mesh
    turn = np.linalg.qr(np.stack([UP, [1, 0, 0], [0, 1, 0]], axis=1))[0]
    there = aligned(1e3 * points @ turn.T + 1e7, triangles[::-1], edge=1200.0).mesh
    moved = 1e3 * here.vertices @ turn.T + 1e7
    assert len(there.faces) == len(here.faces)
    off = np.linalg.norm(moved[:, None] - there.vertices, axis=2).min(axis=1)
    assert off.max() < 1e-4


def test_a_symmetric_roof_gets_a_symmetric_net():
    net = aligned(*sheet(HIP), edge=1.2, symmetry="x,y").mesh
    images = net.vertices * [-1, 1, 1] + [24, 0, 0]
    assert np.linalg.norm(images[:, None] - net.vertices, axis=2).min(axis=1).max() < 1e-12


def test_lines_run_along_groins_that_curvature_crosses(vault):
    net = vault.mesh
    crown = np.flatnonzero(np.linalg.norm(net.vertices - [0, 0, 7.5], axis=1) < 1e-9)
    assert len(crown) == 1
    # Groins are over the diagonals of the plan.
    over = np.abs(np.abs(net.vertices[:, 0]) - np.abs(net.vertices[:, 1])) < 1e-9
    along = net.connectivity.edges[over[net.connectivity.edges].all(axis=1)]
    plan = np.linalg.norm(np.diff(net.vertices[along][:, :, :2], axis=1), axis=2).sum()
    assert plan == pytest.approx(4 * 6 * np.sqrt(2))
    lower = np.minimum(net.vertices[:, 0] ** 2, net.vertices[:, 1] ** 2)
    assert np.abs(net.vertices[:, 2] - np.sqrt(7.5**2 - lower)).max() < 0.01
    assert net.edge_lengths.min() > 0.3 * net.mean_edge
    assert not measures.flipped(net).any()
    assert "creases between 4 faces run at" in vault.remarks[-1]


def test_a_groin_that_fades_out_at_the_crown_is_carried_on():
    mesh = one_surface(*groined())
    sharp = creased(mesh, 1.6)
    facets = FlatFaces.of(mesh, carried_on(mesh, sharp, 2.4), 1.6)
    assert [len(sides) for sides in facets.sides] == [3, 3, 3, 3]
    assert len(facets.chains) == 8


@pytest.mark.parametrize("edge", [0.7, 1.1, 1.9, 2.6])
def test_numbers_along_sides_fit(edge):
    mesh = one_surface(*sheet(HIP))
    facets = FlatFaces.of(mesh, turning(mesh, 0.03), edge)
    along, ways = counts_along(facets, edge)
    for sides, inside in zip(facets.sides, ways, strict=True):
        sums = [sum(along[number] for number, _ in side) for side in sides]
        if len(sides) == 4:
            assert sums[:2] == sums[2:]
        else:
            assert min(inside) > 0
            assert sums == [inside[k - 1] + inside[k - 2] for k in range(3)]
    worst = max(
        abs(np.log2(count * edge / chain.length))
        for count, chain in zip(along, facets.chains, strict=True)
    )
    assert worst < 1


def test_what_is_no_polygon_is_left_to_directions():
    points, triangles = sheet(HIP)
    mesh = one_surface(points, triangles)
    assert FlatFaces.of(mesh, np.zeros(len(mesh.edges), dtype=bool), 1.2) is None
    # A crease that ends inside a face.
    points, triangles = groined()
    mesh = one_surface(points, triangles)
    assert FlatFaces.of(mesh, creased(mesh, 1.6), 1.6) is None
    # An opening in a face.
    opened = triangles[np.linalg.norm(points[triangles].mean(axis=1) - [4, 0, 7.5], axis=1) > 1]
    mesh = one_surface(points, opened)
    assert FlatFaces.of(mesh, carried_on(mesh, creased(mesh, 1.6), 2.4), 1.6) is None


def test_faces_that_have_other_vertices_along_their_crease_meet():
    points, triangles = sheet(GABLE)
    more = np.array([[5, 5, 3], [9, 5, 3], [15, 5, 3]], dtype=float)
    # One slope has a vertex more on the ridge than the other.
    one = [[0, 1, 5], [0, 5, 8], [0, 8, 7], [0, 7, 6], [0, 6, 4]]
    cut = [*one, [3, 4, 6], [3, 6, 8], [2, 3, 8], [2, 8, 5]]
    opened = one_surface(np.concatenate([points, more]), np.array(cut))
    assert len(opened.loops()) == 2
    closed = zipped(opened, 1e-6)
    assert len(closed.loops()) == 1
    assert closed.areas.sum() == pytest.approx(opened.areas.sum())
    net = aligned(opened.points, opened.triangles, edge=1.2).mesh
    assert len(net.faces) == len(aligned(points, triangles, edge=1.2).mesh.faces)


@pytest.mark.parametrize(("roof", "net"), [(HIP, "planar"), (GABLE, "principal")])
def test_an_exact_net_on_flat_faces_stays_as_it_is(roof, net):
    points, triangles = sheet(roof)
    start = aligned(points, triangles, edge=2.5).mesh
    outcome = optimise(start, net, constraints=Constraints(close_to=(points, triangles)))
    assert outcome.report.status == "converged"
    assert np.array_equal(outcome.mesh.vertices, start.vertices)
    # Its lines are straight between creases, which is no zigzag.
    assert not any("zigzag" in remark for remark in outcome.report.remarks)


def test_an_exact_net_beside_its_surface_is_brought_to_it():
    points, triangles = sheet(GABLE)
    start = aligned(points, triangles, edge=2.5).mesh
    above = start.with_vertices(start.vertices + [0, 0, 0.1])
    outcome = optimise(above, "planar", constraints=Constraints(close_to=(points, triangles)))
    assert outcome.report.form.off_surface.max < 0.05
