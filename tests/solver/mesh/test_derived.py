"""Diagonal, medial and checkerboard meshes; subdivision and coarsening."""

from __future__ import annotations

import numpy as np
import pytest

from solver import InputError, QuadMesh
from solver.analysis import measures
from solver.mesh.coarsen import coarsened, coarsened_grid, trimmed, without_border
from solver.mesh.diagonal import checkerboard, diagonal_meshes, medial_mesh
from solver.mesh.grid import grid_mesh, grid_of
from solver.mesh.primitives import primitive
from solver.mesh.subdivide import catmull_clark, subdivided
from solver.multinet import is_multi_net
from tests.conftest import surface_of_revolution, wavy_grid


def star_of(valence: int, rings: int = 1) -> QuadMesh:
    """One interior vertex of the given valence, every patch rings x rings faces, slightly bent."""
    angle = np.arange(valence) * 2 * np.pi / valence
    arm = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    corners = np.stack([arm, arm + np.roll(arm, -1, axis=0)], axis=1).reshape(-1, 3)
    vertices = np.vstack([[0, 0, 0.3], corners])
    around = 1 + 2 * np.arange(valence)
    faces = np.stack([0 * around, around, around + 1, 1 + 2 * ((np.arange(valence) + 1) % valence)])
    mesh = QuadMesh(vertices, faces.T)
    return mesh if rings == 1 else subdivided(mesh, rings - 1)


def pinched_grid() -> QuadMesh:
    """A grid of which two far corners are one vertex."""
    mesh = wavy_grid(4, 4)
    faces = np.where(mesh.faces == 15, 0, mesh.faces)
    return QuadMesh(mesh.vertices[:15], faces)


def face_set(mesh: QuadMesh, digits: int = 9) -> set:
    """Faces as oriented cycles of coordinates, whatever the numbering."""
    result = set()
    for face in np.round(mesh.vertices[mesh.faces], digits) + 0.0:
        rows = [tuple(row) for row in face]
        first = rows.index(min(rows))
        result.add(tuple(rows[first:] + rows[:first]))
    return result


@pytest.mark.parametrize(
    "mesh", [wavy_grid(6, 5), primitive("sphere", 8, 6), star_of(5, 2), wavy_grid(4, 3)]
)
def test_diagonals_there_and_back(mesh):
    pair = diagonal_meshes(mesh)
    assert (pair.mesh.faces == mesh.faces).all()
    assert (pair.mesh.vertices == mesh.vertices).all()
    assert len(pair.first.vertices) + len(pair.second.vertices) == len(mesh.vertices)
    # Corresponding edges are the two diagonals of a face.
    corners = mesh.vertices[mesh.faces]
    both = np.linalg.norm([corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]], axis=2)
    np.testing.assert_allclose(np.sort(pair.edge_lengths, axis=0), np.sort(both, axis=0))
    # Every edge of the diagonal meshes is a diagonal of a face, and faces look the same way.
    for part, numbers in ((pair.first, pair.first_numbers), (pair.second, pair.second_numbers)):
        diagonals = {frozenset(f[::2]) for f in mesh.faces.tolist()}
        diagonals |= {frozenset(f[1::2]) for f in mesh.faces.tolist()}
        assert {frozenset(e) for e in numbers[part.connectivity.edges].tolist()} <= diagonals
        used = part.connectivity.referenced
        turned = np.einsum(
            "ij,ij->i", part.vertex_normals[used], mesh.vertex_normals[numbers[used]]
        )
        assert turned.min() > 0.5


def test_a_moved_pair_gives_a_moved_mesh():
    mesh = wavy_grid(6, 5)
    pair = diagonal_meshes(mesh)
    moved = pair.with_vertices(pair.first.vertices + [1, 2, 3], pair.second.vertices + [1, 2, 3])
    np.testing.assert_allclose(moved.mesh.vertices, mesh.vertices + [1, 2, 3])


def test_orthogonal_means_rhombic_pair_and_rhombic_checkerboard():
    mesh = surface_of_revolution()
    one, two = diagonal_meshes(mesh).edge_lengths
    np.testing.assert_allclose(one, two, rtol=1e-13)
    pattern = checkerboard(mesh)
    sides = pattern.edge_lengths[pattern.connectivity.face_edges[: len(mesh.faces)]]
    assert np.ptp(sides, axis=1).max() < 1e-13
    assert np.ptp(checkerboard(wavy_grid(5, 5)).edge_lengths) > 1e-2


def test_border_of_the_diagonal_mesh_can_be_filled():
    mesh = wavy_grid(7, 6)
    dropped, filled = diagonal_meshes(mesh), diagonal_meshes(mesh, "fill")
    # Two boundary vertices out of three neighbours: (2 (7 + 6) - 8) quads more, on both together.
    count = [sum(len(m.faces) for m in (p.first, p.second)) for p in (dropped, filled)]
    assert count == [5 * 4, 5 * 4 + 2 * (5 + 4)]
    assert (filled.first.face_normals[:, 2] > 0.3).all()
    assert filled.first.face_area_vectors[:, 2].sum() == pytest.approx(
        mesh.face_area_vectors[:, 2].sum(), rel=0.2
    )
    assert (filled.mesh.vertices == mesh.vertices).all()


def test_checkerboard_faces_are_parallelograms_and_cover_each_star():
    mesh = star_of(5, 3)
    pattern = checkerboard(mesh)
    corners = pattern.vertices[pattern.faces[: len(mesh.faces)]]
    assert np.abs(corners[:, 0] - corners[:, 1] + corners[:, 2] - corners[:, 3]).max() < 1e-14
    assert len(pattern.faces) == len(mesh.faces) + len(mesh.connectivity.stars)
    assert not measures.flipped(pattern).any()


def test_medial_mesh_surrounds_each_star():
    mesh = wavy_grid(6, 5)
    medial = medial_mesh(mesh)
    assert sorted(grid_of(medial).numbers.shape) == [4, 5]
    np.testing.assert_allclose(medial.vertices, mesh.vertices[mesh.faces].mean(axis=1))
    assert (
        np.einsum(
            "ij,ij->i", medial.face_normals, mesh.vertex_normals[mesh.connectivity.stars[:, 0]]
        )
        > 0.9
    ).all()


@pytest.mark.parametrize("refine", [subdivided, catmull_clark])
@pytest.mark.parametrize(
    "mesh", [wavy_grid(5, 4), star_of(3), star_of(5), primitive("sphere", 6, 5)]
)
def test_subdivision_keeps_parameter_lines(refine, mesh):
    fine = refine(mesh, 2)
    assert len(fine.faces) == 16 * len(mesh.faces)
    assert not measures.flipped(fine).any()
    net, old = fine.connectivity, mesh.connectivity
    irregular = np.flatnonzero(~net.regular & ~net.boundary_vertices)
    assert irregular.tolist() == np.flatnonzero(~old.regular & ~old.boundary_vertices).tolist()
    # Every fourth line again gives the old connectivity, and for plain subdivision the old mesh.
    special = np.flatnonzero(~old.regular)
    back = coarsened(fine, 4, int(special[0]) if len(special) else 0)
    assert {frozenset(f) for f in back.faces.tolist()} == {
        frozenset(f) for f in mesh.faces.tolist()
    }
    # With the corner first that was first: u stays u.
    assert {tuple(f) for f in back.faces.tolist()} == {tuple(f) for f in mesh.faces.tolist()}
    if refine is subdivided:
        assert face_set(back) == face_set(mesh)
    # u stays u: side 0 of the fine faces lies along side 0 of the old ones.
    first = np.roll(fine.vertices[fine.faces], -1, axis=1) - fine.vertices[fine.faces]
    base = np.roll(mesh.vertices[mesh.faces], -1, axis=1) - mesh.vertices[mesh.faces]
    along = np.einsum("fpi,fi->fp", first[:, 0].reshape(len(mesh.faces), 16, 3), base[:, 0])
    assert (along > 0).all()


def test_catmull_clark_of_a_known_mesh():
    """A regular grid over a bicubic: masks 1/64 [1 6 1; 6 36 6; 1 6 1]; a line stays a line."""
    flat = primitive("rectangle", 5, 4)
    fine = catmull_clark(flat)
    assert np.abs(fine.vertices[:, 2]).max() == 0
    np.testing.assert_allclose(fine.vertices[:20], flat.vertices, atol=1e-15)
    lifted = flat.vertices.copy()
    lifted[2 * 4 + 1, 2] = 64.0
    height = catmull_clark(flat.with_vertices(lifted)).vertices[:20, 2].reshape(5, 4)
    np.testing.assert_allclose(height[2, 1], 36)
    np.testing.assert_allclose([height[1, 1], height[3, 1], height[2, 2]], 6)
    np.testing.assert_allclose([height[1, 2], height[3, 2]], 1)
    # The border's curve knows nothing of the inside.
    np.testing.assert_allclose([height[:, 0], height[:, 3]], 0)
    rim = flat.vertices.copy()
    rim[2 * 4, 2] = 8.0
    border = catmull_clark(flat.with_vertices(rim)).vertices[:20, 2].reshape(5, 4)[:, 0]
    np.testing.assert_allclose(border, [0, 1, 6, 1, 0])


def test_catmull_clark_at_an_irregular_vertex():
    mesh = star_of(5)
    point = catmull_clark(mesh).vertices[0]
    centres = mesh.vertices[mesh.faces].mean(axis=1).mean(axis=0)
    middles = 0.5 * (mesh.vertices[0] + mesh.vertices[1::2].mean(axis=0))
    np.testing.assert_allclose(
        point, (centres + 2 * middles + 2 * mesh.vertices[0]) / 5, atol=1e-15
    )


def test_coarse_and_trimmed_multi_nets_stay_exact():
    mesh = primitive("ellipsoid", 12, 10)
    for part in (
        coarsened_grid(mesh, 3, 2),
        coarsened_grid(mesh, 4, 3, keep_border=False),
        trimmed(mesh, (0, 2), (0, 3)),
    ):
        assert is_multi_net(part, 1e-14)
    assert coarsened_grid(mesh, 3, 2).vertices.shape == (4 * 6, 3)
    np.testing.assert_array_equal(
        trimmed(mesh, (0, 2), (0, 3)).vertices,
        mesh.vertices.reshape(12, 10, 3)[:, 2:7].reshape(-1, 3),
    )
    assert is_multi_net(coarsened(primitive("helicoid", 9, 9), 2), 1e-14)


def test_border_rings_come_off():
    mesh = wavy_grid(7, 6)
    inner = without_border(mesh, 2)
    assert len(inner.faces) == 2 * 1
    np.testing.assert_array_equal(
        inner.vertices, mesh.vertices.reshape(7, 6, 3)[2:5, 2:4].reshape(-1, 3)
    )


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: diagonal_meshes(wavy_grid(2, 2)), "too few"),
        (lambda: diagonal_meshes(primitive("sphere", 7, 5)), "two-coloured"),
        (lambda: diagonal_meshes(wavy_grid(4, 4), "round"), "drop or fill"),
        (lambda: medial_mesh(wavy_grid(2, 5)), "valence four"),
        (lambda: subdivided(wavy_grid(3, 3), 0), "levels: expected a whole number, 1 or more"),
        (lambda: catmull_clark(wavy_grid(3, 3), 40), "take fewer"),
        (lambda: coarsened(wavy_grid(6, 5), 2), "trim rows"),
        (lambda: coarsened(wavy_grid(6, 5), 1), "every: expected a whole number, 2 or more"),
        (lambda: coarsened_grid(primitive("sphere", 8, 5), 3), "divides the 8"),
        (lambda: coarsened_grid(star_of(5, 2)), "grid type"),
        (lambda: grid_of(pinched_grid()), "grid type"),
        (lambda: trimmed(wavy_grid(6, 5), (5, 0), (0, 0)), "0 to 4 of 5"),
        (lambda: trimmed(primitive("sphere", 8, 5), (1, 0), (0, 0)), "runs around"),
        (lambda: without_border(wavy_grid(4, 4), 2), "no face is left"),
        (lambda: grid_mesh(np.zeros((1, 5, 3))), "sampling"),
    ],
)
def test_bad_input_is_one_line(call, words):
    with pytest.raises(InputError, match=words) as caught:
        call()
    assert "\n" not in str(caught.value)
