"""Mirror, weld, orientation, swap; similarity and Moebius transformations."""

from __future__ import annotations

import numpy as np
import pytest

from solver import InputError, QuadMesh
from solver.analysis import measures
from solver.analysis.spheres import cmc
from solver.mesh.grid import grid_of
from solver.mesh.mirror import mirrored, reflection, reversed_orientation, swapped, welded
from solver.mesh.primitives import primitive
from solver.mesh.transform import inverted, moebius, similarity
from tests.conftest import surface_of_revolution, wavy_grid
from tests.solver.mesh.test_derived import face_set, star_of


def test_mirror_merges_exactly_the_seam():
    half = primitive("sphere", 9, 6, angles=(0.0, 180.0), radius=2.0)
    whole = mirrored(half, (0.0, -3.0, 0.0))
    assert face_set(whole) == face_set(primitive("sphere", 16, 6, radius=2.0))
    assert (whole.faces[: len(half.faces)] == half.faces).all()
    apart = mirrored(similarity(half, move=(0, 1, 0)), (0, 1, 0))
    assert apart.connectivity.components.max() == 1
    image = reflection(wavy_grid(4, 4), (1, 2, 2), (1, 0, 0))
    twice = reflection(image, (1, 2, 2), (1, 0, 0))
    np.testing.assert_allclose(twice.vertices, wavy_grid(4, 4).vertices, atol=1e-14)


def test_meshes_weld_into_a_net_with_an_irregular_vertex():
    whole = star_of(5, 3)
    rng = np.random.default_rng(0)
    meshes = []
    for k in range(5):
        faces = whole.faces[16 * k : 16 * k + 16]
        kept, numbers = np.unique(faces, return_inverse=True)
        noise = 1e-12 * rng.normal(size=(len(kept), 3))
        meshes.append(QuadMesh(whole.vertices[kept] + noise, numbers.reshape(-1, 4)))
    meshes[2] = reversed_orientation(meshes[2])
    joined = welded(meshes)
    assert len(joined.vertices) == len(whole.vertices)
    assert face_set(joined) == face_set(whole)
    irregular = ~joined.connectivity.regular & ~joined.connectivity.boundary_vertices
    assert joined.connectivity.edge_valence[irregular].tolist() == [5]
    assert len(welded(meshes, tolerance=1e-15).vertices) == 5 * 25
    assert face_set(welded([whole] * 3)) == face_set(whole)


def test_orientation_and_families():
    mesh = wavy_grid(5, 4)
    other = reversed_orientation(mesh)
    np.testing.assert_allclose(other.vertex_normals, -mesh.vertex_normals, atol=1e-15)
    assert (reversed_orientation(other).faces == mesh.faces).all()
    turned = swapped(mesh)
    assert face_set(turned) == face_set(mesh)
    assert grid_of(turned).numbers.shape == (4, 5)
    assert (grid_of(turned).numbers.ravel() == np.arange(20)).all()
    np.testing.assert_array_equal(turned.vertices[1 * 5 + 0], mesh.vertices[4 * 4 + 1])
    star = star_of(5, 2)
    assert face_set(swapped(star)) == face_set(star)
    assert (swapped(star).faces[:, 0] == star.faces[:, 1]).all()


def test_similarity_keeps_shape():
    mesh = wavy_grid(5, 4)
    moved = similarity(mesh, scale=3.0, degrees=(20, -30, 50), move=(1, 2, 3), centre=(4, 5, 6))
    np.testing.assert_allclose(moved.edge_lengths, 3 * mesh.edge_lengths)
    np.testing.assert_allclose(measures.planarity(moved), measures.planarity(mesh))
    quarter = similarity(mesh, degrees=(0, 0, 90)).vertices
    np.testing.assert_allclose(quarter, mesh.vertices[:, [1, 0, 2]] * [-1, 1, 1], atol=1e-14)
    fixed = similarity(
        wavy_grid(2, 2), scale=2, degrees=(10, 0, 0), centre=wavy_grid(2, 2).vertices[3]
    )
    np.testing.assert_allclose(fixed.vertices[3], wavy_grid(2, 2).vertices[3])


@pytest.mark.parametrize("centre", [(0.0, 0.0, 4.0), (1.0, 5.0, -2.0)])
def test_moebius_keeps_circles_and_spheres(centre):
    barrel = surface_of_revolution(17, 15)
    for image in (
        inverted(barrel, centre, 2.0),
        moebius(barrel, centre),
        moebius(barrel, centre, 0.3),
    ):
        assert measures.circular(image).max() < 1e-12
        assert measures.planarity(image).max() < 1e-12
        assert not measures.flipped(image).any()
    # A mesh on a sphere through nothing special stays on a sphere: all stars have one radius.
    ball = moebius(primitive("sphere", 12, 9), centre)
    assert cmc(ball).max() < 1e-11
    back = inverted(inverted(barrel, centre, 2.0), centre, 2.0)
    np.testing.assert_allclose(back.vertices, barrel.vertices, atol=1e-12)
    assert (back.faces == barrel.faces).all()


def test_inversion_keeps_the_outside_outside():
    ball = primitive("sphere", 12, 9)
    image = inverted(ball, (0.0, 0.0, 4.0), 2.0)
    # The ball of radius 1 at distance 4 goes to the one between 4 / 5 and 4 / 3 below the centre.
    centre = np.array([0, 0, 4 - 0.5 * (4 / 5 + 4 / 3)])
    np.testing.assert_allclose(np.linalg.norm(image.vertices - centre, axis=1), 4 / 15)
    outward = image.vertices[image.faces].mean(axis=1) - centre
    assert (np.einsum("ij,ij->i", image.face_normals, outward) > 0).all()
    assert (image.faces[:, 0] == ball.faces[:, 1]).all()


def test_moebius_keeps_place_orientation_and_principal_order():
    errors = []
    for count in (15, 29, 57):
        mesh = primitive("ellipsoid", count, count, clear=0.2)
        image = moebius(mesh, (0.5, 6.0, 1.0))
        errors.append(measures.planarity(image).max())
    assert np.diff(np.log2(errors)).max() < -1.8
    one = wavy_grid(9, 8)
    near = moebius(one, one.vertices.mean(axis=0) + [0, 0, 500.0])
    assert np.abs(near.vertices - one.vertices).max() < 0.3
    assert (np.einsum("ij,ij->i", near.vertex_normals, one.vertex_normals) > 0.99).all()


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: mirrored(wavy_grid(4, 4), (1, 0, 0), (1.5, 0, 0)), "across the plane"),
        (lambda: mirrored(wavy_grid(4, 4), (0, 0, 0)), "normal"),
        (lambda: mirrored(primitive("rectangle", 4, 4), (0, 0, 1)), "across the plane"),
        (lambda: welded([]), "at least one mesh"),
        (lambda: similarity(wavy_grid(3, 3), scale=-1), "scale: expected a number above 0, got -1"),
        (lambda: similarity(wavy_grid(3, 3), move=(1, 2)), "three finite numbers"),
        (lambda: inverted(wavy_grid(3, 3), wavy_grid(3, 3).vertices[4], 1), "vertex 4"),
        (lambda: inverted(wavy_grid(3, 3), (0, 0, 9), 0), "radius"),
        (lambda: moebius(wavy_grid(3, 3), wavy_grid(3, 3).vertices.mean(axis=0)), "mean point"),
    ],
)
def test_bad_input_is_one_line(call, words):
    with pytest.raises(InputError, match=words) as caught:
        call()
    assert "\n" not in str(caught.value)
