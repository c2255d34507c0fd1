"""Axes: exactly torsion-free, of even height, whatever the mesh."""

import numpy as np
import pytest

from solver import optimise
from solver.mesh.quadmesh import QuadMesh, unit_rows
from solver.offset.axes import torsion_free_axes
from tests.conftest import demo_roof, shared_mesh
from tests.meshes import rhombic_dodecahedron


def grid(rows, columns, closed=False):
    number = np.arange(rows * columns).reshape(rows, columns)
    if closed:
        number = np.concatenate([number, number[:, :1]], axis=1)
    corners = number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]
    return np.stack(corners, axis=-1).reshape(-1, 4)


def revolution(rows=14, columns=22, sweep=4.5):
    """Meridians and parallels of a wavy surface: planar faces with equal diagonals, exactly."""
    height, angle = np.meshgrid(
        np.linspace(0, 3, rows), np.linspace(0, sweep, columns), indexing="ij"
    )
    radius = 2 + 0.4 * np.sin(2 * height)
    points = np.stack([radius * np.cos(angle), radius * np.sin(angle), height], axis=-1)
    return QuadMesh(points.reshape(-1, 3), grid(rows, columns)[:, ::-1])


def sheared():
    """Planar faces, but far from orthogonal."""
    mesh = revolution()
    return mesh.with_vertices(mesh.vertices @ np.array([[1, 0.3, 0], [0, 1, 0.2], [0, 0, 1.1]]))


def translation():
    """A curve moved along a curve: every face a parallelogram."""
    x, y = np.meshgrid(np.linspace(-1, 1, 12), np.linspace(-1, 1, 9), indexing="ij")
    points = np.stack([x + 0.1 * y**2, y, 0.4 * x**2 + 0.2 * np.cosh(y)], axis=-1)
    return QuadMesh(points.reshape(-1, 3), grid(12, 9))


def torus():
    """Closed, rings around the axis and across it."""
    around, across = np.meshgrid(
        np.arange(16) * np.pi / 8, np.arange(12) * np.pi / 6, indexing="ij"
    )
    radius = 3 + np.cos(across)
    points = np.stack(
        [radius * np.cos(around), radius * np.sin(around), np.sin(across)], axis=-1
    ).reshape(-1, 3)
    number = np.arange(16 * 12).reshape(16, 12)
    ahead, beside = np.roll(number, -1, axis=0), np.roll(number, -1, axis=1)
    faces = np.stack([number, ahead, np.roll(ahead, -1, axis=1), beside], axis=-1)
    return QuadMesh(points, faces.reshape(-1, 4))


def saddle():
    """Straight lines on a hyperbolic paraboloid: an asymptotic net, no face planar."""
    x, y = np.meshgrid(np.linspace(-1, 1, 11), np.linspace(-1, 1, 11), indexing="ij")
    points = np.stack([x, y, 0.5 * x * y], axis=-1)
    return QuadMesh(points.reshape(-1, 3), grid(11, 11))


PLANAR = {
    "revolution": revolution,
    "sheared": sheared,
    "translation": translation,
    "torus": torus,
    "dodecahedron": rhombic_dodecahedron,
}


def edge_directions(mesh):
    start, end = mesh.connectivity.edges.T
    return unit_rows(mesh.vertices[end] - mesh.vertices[start])


def twist_of(mesh, directions):
    start, end = mesh.connectivity.edges.T
    return np.abs(
        np.linalg.det(np.stack([directions[start], directions[end], edge_directions(mesh)], 1))
    )


@pytest.mark.parametrize("make", PLANAR.values(), ids=PLANAR)
def test_planar_faces_leave_no_twist(make):
    mesh = make()
    axes = torsion_free_axes(mesh)
    assert axes.twist.max() <= 1e-12
    assert np.allclose(axes.twist, twist_of(mesh, axes.directions), rtol=0, atol=1e-14)
    assert np.allclose(np.linalg.norm(axes.directions, axis=1), 1, rtol=1e-14)


@pytest.mark.parametrize("make", PLANAR.values(), ids=PLANAR)
def test_offset_mesh_is_parallel(make):
    mesh = make()
    axes = torsion_free_axes(mesh)
    moved = mesh.with_vertices(mesh.vertices + 0.1 * axes.offsets)
    assert np.abs(np.cross(edge_directions(mesh), edge_directions(moved))).max() <= 1e-12
    start, _ = mesh.connectivity.edges.T
    arm = moved.vertices[start] - mesh.vertices[start]
    distance = np.linalg.norm(np.cross(arm, edge_directions(mesh)), axis=1)
    assert np.allclose(distance, 0.1 * axes.heights, rtol=1e-12, atol=0)


@pytest.mark.parametrize("make", [revolution, torus, rhombic_dodecahedron])
def test_principal_meshes_get_even_heights(make):
    axes = torsion_free_axes(make())
    assert np.abs(axes.heights - 1).max() <= 0.05
    assert axes.heights.mean() == pytest.approx(1, abs=1e-12)


def test_edges_on_a_sphere_give_equal_heights():
    mesh = rhombic_dodecahedron()
    axes = torsion_free_axes(mesh)
    assert np.allclose(axes.heights, 1, atol=1e-12)
    assert np.allclose(axes.offsets, mesh.vertices / np.sqrt(8 / 3), atol=1e-6)
    assert axes.lean_deg.max() <= 1e-4


def test_flat_mesh_stands_upright():
    x, y = np.meshgrid(np.arange(5.0), np.arange(4.0) ** 1.2, indexing="ij")
    mesh = QuadMesh(np.stack([x, y + 0.1 * x, 0 * x], axis=-1).reshape(-1, 3), grid(5, 4))
    axes = torsion_free_axes(mesh)
    assert np.allclose(axes.offsets, [0, 0, 1], atol=1e-12)
    assert np.allclose(axes.lean_deg, 0, atol=1e-6)


@pytest.mark.parametrize("noise", [1e-10, 1e-8])
def test_nearly_planar_faces_keep_even_heights(noise):
    mesh = revolution()
    exact = torsion_free_axes(mesh)
    shaken = mesh.vertices + noise * np.random.default_rng(1).standard_normal(mesh.vertices.shape)
    axes = torsion_free_axes(mesh.with_vertices(shaken))
    assert axes.twist.max() <= 10 * noise
    assert np.abs(axes.offsets - exact.offsets).max() <= 1e-4


def test_twist_shrinks_with_planarity():
    mesh = revolution()
    shake = np.random.default_rng(2).standard_normal(mesh.vertices.shape)
    for noise in (1e-6, 1e-4, 1e-3):
        axes = torsion_free_axes(mesh.with_vertices(mesh.vertices + noise * mesh.mean_edge * shake))
        assert 0 < axes.twist.max() <= noise
        assert np.abs(axes.heights - 1).max() <= 0.06


def test_one_bad_face_spoils_only_its_neighbourhood():
    mesh = revolution()
    vertices = mesh.vertices.copy()
    vertices[0] *= 1.05
    axes = torsion_free_axes(mesh.with_vertices(vertices))
    far = ~np.isin(mesh.connectivity.edges, mesh.faces[(mesh.faces == 0).any(axis=1)]).any(axis=1)
    assert axes.twist[far].max() <= 1e-11
    assert np.abs(axes.heights - 1).max() <= 0.1


def test_asymptotic_mesh_falls_back_and_says_its_twist():
    mesh = saddle()
    axes = torsion_free_axes(mesh)
    assert np.isfinite(axes.offsets).all()
    assert axes.twist.max() > 1e-3
    normals = twist_of(mesh, mesh.vertex_normals)
    assert np.linalg.norm(axes.twist) <= np.linalg.norm(normals)
    assert np.abs(axes.heights - 1).max() <= 0.1
    assert axes.lean_deg.max() <= 30


def test_free_of_unit_and_place():
    mesh = sheared()
    angle = 0.7
    turn = np.array(
        [[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]]
    ) @ np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0.0]])
    moved = mesh.with_vertices(1000 * mesh.vertices @ turn.T + [10.0, -20.0, 30.0])
    here, there = torsion_free_axes(mesh), torsion_free_axes(moved)
    assert np.allclose(there.offsets, here.offsets @ turn.T, atol=1e-6)
    assert np.allclose(there.heights, here.heights, atol=1e-6)


def test_components_and_unused_vertices():
    one, two = revolution(), translation()
    count = len(one.vertices)
    vertices = np.concatenate([one.vertices, [[9.0, 9.0, 9.0]], 50 * two.vertices + 100])
    faces = np.concatenate([one.faces, two.faces + count + 1])
    both = torsion_free_axes(QuadMesh(vertices, faces))
    assert np.allclose(both.offsets[:count], torsion_free_axes(one).offsets, atol=1e-6)
    assert np.allclose(both.offsets[count + 1 :], torsion_free_axes(two).offsets, atol=1e-6)
    assert (both.offsets[count] == 0).all()
    assert both.lean_deg[count] == 0
    assert both.twist.max() <= 1e-12


def test_single_face_and_straight_corner():
    square = QuadMesh([[0, 0, 0], [2, 0, 0], [2, 1, 0], [0, 1, 0]], [[0, 1, 2, 3]])
    assert np.allclose(torsion_free_axes(square).offsets, [0, 0, 1])
    straight = QuadMesh([[0, 0, 0], [1, 0, 0], [2, 0, 0], [1, 1, 0]], [[0, 1, 2, 3]])
    assert np.allclose(torsion_free_axes(straight).directions, [0, 0, 1], atol=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize(
    "name",
    [
        "demo roof",
        *(
            pytest.param(name, marks=pytest.mark.shared)
            for name in ("heart", "conical1", "botanic-garden-bubble-0", "complete01")
        ),
    ],
)
def test_optimised_meshes_get_torsion_free_beams_of_even_height(name):
    mesh = demo_roof() if name == "demo roof" else shared_mesh(name)
    axes = torsion_free_axes(optimise(mesh, "principal").mesh)
    assert axes.twist.max() <= 1e-7
    assert np.abs(axes.heights - 1).max() <= 0.05


def test_double_face_is_no_division_by_zero():
    """A face and its reverse have no normal at all, so no axes; whoever uses them says so."""
    square = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    pillow = QuadMesh(square, [[0, 1, 2, 3], [3, 2, 1, 0]])
    assert np.isfinite(torsion_free_axes(pillow).offsets).all()
