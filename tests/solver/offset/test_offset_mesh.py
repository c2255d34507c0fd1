"""Offset meshes: parallel, and at a constant distance where the net allows it."""

import numpy as np
import pytest

from solver import InputError, optimise
from solver.mesh.quadmesh import QuadMesh, unit_rows
from solver.offset.offset_mesh import KINDS, offset_mesh
from tests.conftest import shared_mesh, wavy_grid
from tests.solver.offset.test_axes import (
    PLANAR,
    grid,
    revolution,
    rhombic_dodecahedron,
    saddle,
    translation,
)


def rotational(profile, segments=16, sweep=3.0):
    """Radius and height of each parallel, turned around z: isosceles trapezoids."""
    angle = np.linspace(0, sweep, segments)
    radius, height = np.asarray(profile)[:, :, None].transpose(1, 0, 2)
    points = np.stack(
        np.broadcast_arrays(radius * np.cos(angle), radius * np.sin(angle), height), axis=-1
    )
    return QuadMesh(points.reshape(-1, 3), grid(len(profile), segments)[:, ::-1])


def koebe(rows=7, segments=16, sweep=3.0):
    """A rotational mesh all of whose edges touch the unit sphere."""
    half = sweep / (segments - 1) / 2
    turn = 0.0  # of the meridian's tangent point
    profile = []
    reach = np.sin(half)
    for _ in range(rows):
        start = turn - np.arctan(reach)
        size = np.sqrt(1 + reach**2)
        profile.append((size * np.cos(start), size * np.sin(start)))
        # The parallel through the next vertex touches the sphere as well: its half edge is as long
        # as the meridian's tangent, reach = r sin(half).
        ahead = np.sin(half) * np.cos(turn) / (1 + np.sin(half) * np.sin(turn))
        reach = ahead
        end = turn + np.arctan(ahead)
        turn = end + np.arctan(ahead)
    return rotational(profile, segments, sweep)


def apart(mesh, moved, kind):
    """Distances of vertices, edges or faces, each measured between its whole lines and planes."""
    if kind == "vertex":
        return np.linalg.norm(moved.vertices - mesh.vertices, axis=1)
    if kind == "face":
        plane = mesh.vertices[mesh.faces].mean(axis=1)
        arms = moved.vertices[moved.faces] - plane[:, None]
        return np.einsum("fk,fck->fc", mesh.face_normals, arms).ravel()
    start, end = mesh.connectivity.edges.T
    along = unit_rows(mesh.vertices[end] - mesh.vertices[start])
    return np.linalg.norm(np.cross(along, moved.vertices[start] - mesh.vertices[start]), axis=1)


def turned(mesh, moved):
    start, end = mesh.connectivity.edges.T
    one, two = (unit_rows(m.vertices[end] - m.vertices[start]) for m in (mesh, moved))
    return np.linalg.norm(one - two, axis=1).max()


def test_koebe_mesh_touches_the_sphere():
    mesh = koebe()
    start, end = (mesh.vertices[ends] for ends in mesh.connectivity.edges.T)
    assert np.allclose(
        np.linalg.norm(np.cross(start, unit_rows(end - start)), axis=1), 1, rtol=1e-14
    )


def parallel_to_koebe():
    """Meridian edges stretched one by one, parallels accordingly: edges stay parallel."""
    mesh = koebe()
    points = mesh.vertices.reshape(7, 16, 3)
    radius, height = np.hypot(points[:, 0, 0], points[:, 0, 1]), points[:, 0, 2]
    stretch = np.array([1.0, 1.7, 0.6, 1.2, 2.0, 0.9])
    profile = [
        1 + np.concatenate([[0], np.cumsum(stretch * np.diff(radius))]),
        np.concatenate([[0], np.cumsum(stretch * np.diff(height))]),
    ]
    return rotational(np.stack(profile, axis=1))


EXACT = {
    "vertex of revolution": ("vertex", revolution),
    "face of revolution": ("face", revolution),
    "edge of koebe": ("edge", koebe),
    "edge of parallel to koebe": ("edge", parallel_to_koebe),
    "edge of dodecahedron": ("edge", rhombic_dodecahedron),
    "face of dodecahedron": ("face", rhombic_dodecahedron),
}


@pytest.mark.parametrize("distance", [0.04, -0.04])
@pytest.mark.parametrize("kind, make", EXACT.values(), ids=EXACT)
def test_distance_is_constant_where_the_net_allows_it(kind, make, distance):
    mesh = make()
    found = offset_mesh(mesh, distance, kind)
    expected = distance if kind == "face" else abs(distance)
    assert np.allclose(apart(mesh, found.mesh, kind), expected, rtol=1e-8, atol=0)
    assert turned(mesh, found.mesh) <= 1e-12
    assert found.miss.max() <= 1e-8 * abs(distance)
    assert "everywhere" in found.message


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("make", PLANAR.values(), ids=PLANAR)
def test_edges_stay_parallel_and_the_miss_is_measured(make, kind):
    mesh = make()
    found = offset_mesh(mesh, 0.03, kind)
    assert turned(mesh, found.mesh) <= 1e-8
    element = "edge" if kind == "parallel" else kind
    distances = apart(mesh, found.mesh, element)
    assert np.isclose(found.miss.max(), np.abs(distances - 0.03).max(), atol=1e-10)
    assert np.allclose(found.length_ratio, found.mesh.edge_lengths / mesh.edge_lengths, rtol=1e-12)


def test_constant_is_more_even_than_parallel():
    mesh = translation()
    for kind in ("vertex", "face"):
        assert np.ptp(apart(mesh, offset_mesh(mesh, 0.05, kind).mesh, kind)) < 0.7 * np.ptp(
            apart(mesh, offset_mesh(mesh, 0.05).mesh, kind)
        )


def test_offset_follows_unit_and_motion():
    mesh = revolution()
    turn = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))[0]
    turn *= np.sign(np.linalg.det(turn))
    other = mesh.with_vertices(1000 * mesh.vertices @ turn.T + 7e3)
    one, two = offset_mesh(mesh, 0.1, "face"), offset_mesh(other, 100.0, "face")
    assert np.allclose(two.mesh.vertices, 1000 * one.mesh.vertices @ turn.T + 7e3, atol=1e-5)


@pytest.mark.shared
@pytest.mark.parametrize("kind, net", [("vertex", "circular"), ("face", "conical")])
@pytest.mark.parametrize("name", ["heart", "conical1", "botanic-garden-bubble-0"])
def test_optimised_nets_of_the_authors(name, kind, net):
    start = shared_mesh(name)
    mesh = optimise(start.scaled(1000 / start.mean_edge), net=net).mesh
    found = offset_mesh(mesh, 100.0, kind)
    expected = apart(mesh, found.mesh, kind)
    assert np.abs(expected - 100).max() <= 1e-5
    assert turned(mesh, found.mesh) <= 1e-12


def test_what_is_missing_is_said():
    found = offset_mesh(saddle(), 0.05, "parallel")
    assert "not parallel" in found.message and "planar faces first" in found.message
    found = offset_mesh(translation(), 0.05, "face")
    face = int(np.argmax(found.miss))
    assert f"misses by up to {found.miss.max():.3g} at face {face}" in found.message
    assert "conical net" in found.message


@pytest.mark.parametrize("make", [saddle, lambda: wavy_grid(9, 8)])
@pytest.mark.parametrize("kind", KINDS)
def test_any_mesh_gives_finite_numbers(make, kind):
    found = offset_mesh(make(), 0.01, kind)
    assert np.isfinite(found.mesh.vertices).all()
    assert found.message


def test_vertices_without_faces_stay():
    mesh = revolution()
    more = QuadMesh(np.vstack([mesh.vertices, [[9.0, 9, 9]]]), mesh.faces)
    for kind in KINDS:
        found = offset_mesh(more, 0.05, kind)
        assert np.allclose(found.mesh.vertices[-1], 9)
        assert found.miss.max() < 0.01


def test_bad_distances_are_refused():
    mesh = revolution()
    for distance in (0, np.nan, np.inf, True):
        with pytest.raises(InputError, match="distance"):
            offset_mesh(mesh, distance)
    with pytest.raises(InputError, match="kind: expected parallel, vertex, edge or face, got"):
        offset_mesh(mesh, 0.1, "sideways")
    with pytest.raises(InputError, match="folds the offset mesh at edge") as caught:
        offset_mesh(mesh, -9.0)
    largest = float(str(caught.value).rsplit(" ", 1)[1])
    assert offset_mesh(mesh, -largest).length_ratio.min() > 0
    with pytest.raises(InputError):
        offset_mesh(mesh, -1.01 * largest)
    for unit in (1e-6, 1.0, 1e6):
        points = mesh.vertices.copy()
        points[0] = points[1] + 1e-10 * (points[0] - points[1])
        with pytest.raises(InputError, match="1 have no length, the first is edge 0"):
            offset_mesh(mesh.with_vertices(unit * points), 0.1 * unit)
