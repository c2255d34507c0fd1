"""Meshes whose faces have any number of corners: read, told apart, made flat, written."""

import numpy as np
import pytest

from examples.mixed_faces import cut_round, honeycomb
from solver import QuadMesh, optimise, read_mesh, write_mesh
from solver.analysis import measures
from solver.analysis.check import check
from solver.analysis.start import start_remarks
from solver.errors import InputError
from solver.mesh.connectivity import Connectivity
from solver.mesh.intake import any_mesh
from solver.mesh.mixed import MixedConnectivity, words_of_sizes
from solver.offset.axes import torsion_free_axes
from solver.terms.derivatives import derivative_error
from solver.terms.umbrella import umbrellas
from tests.conftest import grid_faces, wavy_grid

# A square, a triangle on its right side and a pentagon above both.
VERTICES = np.array(
    [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [1.8, 1.2, 0], [0, 2, 0], [1.5, 2.2, 0]], float
)
POLYGONS = [[0, 1, 2, 3], [1, 4, 2], [3, 2, 4, 6, 5]]


@pytest.fixture(scope="module")
def flat_dome():
    return optimise(cut_round(4), "planar")


@pytest.fixture(scope="module")
def flat_honeycomb():
    return optimise(honeycomb(5), "planar")


def test_connectivity_is_that_of_quads_where_all_faces_are_quads():
    faces = grid_faces(4, 5)
    one, two = Connectivity(faces, 20), MixedConnectivity(faces.tolist(), 20)
    for name in (
        *("half_edges", "twins", "edges", "edge_faces", "boundary_edges", "face_valence"),
        *("regular", "continuation", "line_triples", "line_quadruples", "components"),
        *("half_faces", "following", "flat_quads", "flat_quads_faces", "quads", "half_edge_edges"),
    ):
        assert np.array_equal(getattr(one, name), getattr(two, name)), name
    for ours, theirs in zip(one.boundary_loops, two.boundary_loops, strict=True):
        assert np.array_equal(ours, theirs)
    mesh = wavy_grid(4, 5)
    same = QuadMesh(mesh.vertices, MixedConnectivity(mesh.faces.tolist(), 20))
    for name in ("face_normals", "face_area_vectors", "vertex_normals", "face_gaps"):
        assert getattr(same, name) == pytest.approx(getattr(mesh, name), abs=1e-14), name
    assert same.face_gaps == pytest.approx(measures.diagonal_distances(mesh), abs=1e-14)
    assert measures.planarity(same) == pytest.approx(measures.planarity(mesh), abs=1e-14)
    assert np.array_equal(measures.flipped(same), measures.flipped(mesh))


def test_faces_of_several_sizes_know_their_neighbours_and_areas():
    net = MixedConnectivity(POLYGONS, 7)
    mesh = QuadMesh(VERTICES, net)
    assert len(net.edges) == 9 and net.boundary_edges.sum() == 6
    assert sorted(len(loop) for loop in net.boundary_loops) == [6]
    assert mesh.face_area_vectors[:, 2] == pytest.approx([1.0, 0.4, 1.78], abs=1e-12)
    assert np.array_equal(mesh.face_normals, np.tile([0.0, 0.0, 1.0], (3, 1)))
    # A quad is asked once, a pentagon from each of its corners, a triangle never.
    assert np.bincount(net.flat_quads_faces, minlength=3).tolist() == [1, 0, 5]
    cut = VERTICES[net.triangles]
    areas = 0.5 * np.cross(cut[:, 1] - cut[:, 0], cut[:, 2] - cut[:, 0])[:, 2]
    assert areas.sum() == pytest.approx(mesh.face_area_vectors[:, 2].sum(), abs=1e-12)
    assert not measures.flipped(mesh).any()
    assert words_of_sizes(net.face_sizes) == "1 triangle, 1 quad, 1 of 5 corners"


def test_what_is_turned_over_is_turned_back():
    turned = [POLYGONS[0], POLYGONS[1][::-1], POLYGONS[2]]
    mesh, remarks = any_mesh(VERTICES, turned)
    assert measures.area(mesh) == pytest.approx(1.4 + 1.78)
    assert (mesh.face_area_vectors[:, 2] > 0).all()
    assert any("oriented against its neighbours" in remark for remark in remarks)


@pytest.mark.parametrize(
    ("polygons", "words"),
    [
        ([[0, 1], [0, 1, 2]], "fewer than 3 corners"),
        ([[0, 1, 2, 1, 3]], "repeats a vertex"),
        ([[0, 1, 9]], "vertices are numbered 0 to 6"),
        ([[0, 1, 2], [0, 1, 3], [0, 1, 4, 6, 5]], "more than two faces"),
        ([[0, 1, 3], [1, 2, 3, 4, 3]], "repeats a vertex"),
    ],
)
def test_what_is_no_mesh_is_refused_in_one_line(polygons, words):
    with pytest.raises(InputError, match=words):
        any_mesh(VERTICES, polygons)


@pytest.mark.parametrize("ending", [".obj", ".off", ".ply", ".json"])
def test_files_keep_faces_and_every_digit(tmp_path, ending):
    mesh = QuadMesh(VERTICES + np.pi * 1e-3, MixedConnectivity(POLYGONS, 7))
    write_mesh(tmp_path / f"mixed{ending}", mesh, "m")
    again = read_mesh(tmp_path / f"mixed{ending}", mixed=True)
    assert again.connectivity.polygons == POLYGONS
    assert np.array_equal(again.vertices, mesh.vertices)
    with pytest.raises(InputError, match="expected 4 vertices a face, found 1 triangle"):
        read_mesh(tmp_path / f"mixed{ending}")


def test_nets_that_need_quads_say_so():
    mesh = QuadMesh(VERTICES, MixedConnectivity(POLYGONS, 7))
    with pytest.raises(InputError, match="principal net: expected 4 vertices a face, found 1 tri"):
        optimise(mesh, "principal")
    triangles = QuadMesh(VERTICES[:4], MixedConnectivity([[0, 1, 2], [0, 2, 3]], 4))
    with pytest.raises(InputError, match="triangles, which are flat as they are"):
        optimise(triangles, "planar")


def test_faces_of_all_sizes_become_flat_where_they_were_drawn(flat_dome, flat_honeycomb):
    for outcome in (flat_dome, flat_honeycomb):
        report, net = outcome.report, outcome.mesh.connectivity
        assert report.status == "converged" and report.flipped_faces == 0
        for group in net.by_size:
            corner = outcome.mesh.vertices[group.faces]
            arms = (corner - corner.mean(axis=1, keepdims=True)) / outcome.mesh.mean_edge
            assert np.linalg.svd(arms, compute_uv=False)[:, 2].max() < 1e-10
        assert report.form.off_surface.percent < 0.3
        assert torsion_free_axes(outcome.mesh).twist.max() < 1e-10
    assert set(flat_dome.mesh.connectivity.face_sizes) == {3, 4, 5}


@pytest.mark.slow
def test_noisy_starts_become_flat_too():
    start = honeycomb(3)
    for seed in range(10):
        noise = np.random.default_rng(seed).normal(0, 0.02 * start.mean_edge, start.vertices.shape)
        report = optimise(start.with_vertices(start.vertices + noise), "planar").report
        assert report.status == "converged" and report.flipped_faces == 0


def test_check_measures_what_can_be_asked(flat_dome):
    found = check(flat_dome.mesh)
    assert list(found["measures"]) == ["planarity"] and found["measures"]["planarity"]["max"] < 1e-9
    assert found["advice"]["recommendation"] == "the mesh is a planar net already"
    assert sum(found["corners_of_faces"].values()) == found["faces"]


def test_three_faces_that_meet_on_a_saddle_are_warned_of():
    start = honeycomb(4)
    x, y, _ = start.vertices.T
    saddle = start.with_vertices(np.column_stack([x, y, (x**2 - y**2) / 40000]))
    assert start_remarks(start, "planar") == ()
    (remark,) = start_remarks(saddle, "planar")
    assert "at 100 % of the inner vertices where three faces meet" in str(remark)


def test_motions_that_are_the_same_all_over_cost_nothing():
    mesh = honeycomb(3)
    x = mesh.vertices.ravel() / mesh.mean_edge
    rings = umbrellas(mesh.connectivity, x)
    assert {ring.rings.shape[1] for ring in rings} == {3, 4}
    rough = x + np.random.default_rng(0).normal(0, 0.1, len(x))
    for ring in rings:
        assert (
            np.abs(ring.linearise(x + np.tile([0.3, 1.0, -2.0], len(x) // 3)).residual).max()
            < 1e-13
        )
        assert np.abs(ring.linearise(rough).residual).max() > 0.1
        assert derivative_error(ring, rough) < 1e-8
    assert umbrellas(wavy_grid(4, 5).connectivity, x) == []
