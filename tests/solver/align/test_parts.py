"""The steps from a surface to a net, one at a time."""

from __future__ import annotations

import numpy as np
import pytest

from solver.align.apron import extended
from solver.align.cells import Quads, crossing, quads
from solver.align.cut import cut_open
from solver.align.features import Features
from solver.align.field import DirectionField, curvature_guide, smooth_field, turns
from solver.align.guides import _along_border
from solver.align.jets import face_tensors, fitted
from solver.align.reach import beyond, reaching
from solver.align.refine import refined
from solver.align.seamless import GRID, Map, rounded, seamless_map
from solver.align.seams import TURNS, seams
from solver.align.triangle_mesh import TriangleMesh, one_surface
from solver.analysis.fields import field
from solver.mesh.closest import TriangleSurface
from solver.mesh.grid import grid_mesh
from tests.design_surfaces import barrel, dome, plane, triangles, without


def cylinder(u, v):
    angle = 1.5 * u
    return 4 * np.sin(angle), 9 * v, 4 * np.cos(angle)


def work(formula, edge, nu=61, nv=37):
    mesh = one_surface(*triangles(formula, nu, nv))
    inner = len(mesh.triangles)
    mesh, _ = extended(mesh, 2 * edge, edge / 4, 1.5 * edge)
    jets = fitted(mesh, np.arange(len(mesh.points)), edge)
    guide = curvature_guide(mesh, face_tensors(mesh, jets.shape_tensors()), inner, 0.0)
    return mesh, inner, guide, smooth_field(mesh, guide, edge)


def test_curvatures_of_a_cylinder():
    mesh = one_surface(*triangles(cylinder, 41, 41))
    tensors = fitted(mesh, np.arange(len(mesh.points)), 0.8).shape_tensors()
    values = np.sort(np.abs(np.linalg.eigvalsh(tensors)), axis=1)
    inner = ~mesh.on_rim
    assert values[inner, 2] == pytest.approx(0.25, rel=0.02)
    assert values[inner, :2].max() < 1e-3
    # The curved direction is across the axis.
    bent = np.linalg.eigh(tensors)[1][
        np.arange(len(tensors)), :, np.abs(np.linalg.eigvalsh(tensors)).argmax(axis=1)
    ]
    assert np.abs(bent[:, 1]).max() < 1e-2


def test_a_surface_goes_on_as_it_bends():
    mesh = one_surface(*triangles(cylinder, 41, 41))
    larger, _ = extended(mesh, 1.0, 0.25, 1.5)
    assert np.array_equal(larger.points[: len(mesh.points)], mesh.points)
    assert np.array_equal(larger.triangles[: len(mesh.triangles)], mesh.triangles)
    radius = np.hypot(larger.points[:, 0], larger.points[:, 2])
    assert np.abs(radius - 4).max() < 0.03
    assert np.ptp(larger.points[:, 1]) == pytest.approx(11, abs=0.05)
    # No triangle is turned over.
    assert (larger.normals * larger.vertex_normals[larger.triangles[:, 0]]).sum(axis=1).min() > 0.9


def test_strips_of_an_opening_do_not_meet():
    points, faces = triangles(plane, 49, 33)
    points, faces = without(points, faces, lambda c: np.hypot(c[:, 0] - 6, c[:, 1] - 4) < 1)
    mesh = one_surface(points, faces)
    larger, _ = extended(mesh, 2.0, 0.25, 1.5)
    assert (larger.normals[:, 2] * np.sign(mesh.normals[0, 2])).min() > 0.99
    inwards = larger.points[len(mesh.points) :]
    inside = np.hypot(inwards[:, 0] - 6, inwards[:, 1] - 4) < 1
    assert np.hypot(inwards[inside, 0] - 6, inwards[inside, 1] - 4).min() > 0.05


def test_how_a_border_runs():
    points, faces = triangles(plane, 25, 17)
    # A tooth of one cell: at the place where y is 0, x about 6.
    jagged = without(points, faces, lambda at: (np.abs(at[:, 0] - 6) < 0.4) & (at[:, 1] < 0.5))
    surface = one_surface(*jagged)
    inner = len(surface.triangles)
    mesh, _ = extended(surface, 1.0, 0.5, 1.5)
    border = Features.border(mesh, inner, 4.0)
    assert len(border.edges) == len(surface.rim)
    start, end = (mesh.points[side[border.edges]] for side in mesh.ends)
    middle = (start + end) / 2
    across = np.abs(border.along[:, 0]) < 0.5
    # Two sides run across, up to their corners; the tooth runs on with the side that it is in.
    assert np.array_equal(across, (middle[:, 0] < 1e-6) | (middle[:, 0] > 12 - 1e-6))
    straight = (middle[:, 1] > 8 - 1e-6) | across
    assert np.abs(border.along[straight]).max(axis=1).min() > 1 - 1e-9


def test_fans_that_meet_in_a_vertex_are_parted():
    points, faces = triangles(plane, 13, 9)
    # Two openings that touch in a vertex: there its fan is in two parts.
    cells = np.floor(points[faces].mean(axis=1)[:, :2]).astype(int).tolist()
    kept = np.array([cell not in ([5, 3], [6, 4]) for cell in cells])
    mesh = one_surface(points, faces[kept])
    assert len(mesh.points) == len(points) + 1
    doubled = np.flatnonzero((np.abs(mesh.points - [6, 4, 0]) < 1e-9).all(axis=1))
    assert len(doubled) == 2
    # Each part of the border runs through one of the two.
    assert sorted(len(loop) for loop in mesh.loops()) == [8, 40]


def test_triangles_are_turned_alike():
    points, faces = triangles(barrel, 21, 15)
    mixed = faces.copy()
    mixed[::3] = mixed[::3, ::-1]
    mesh = one_surface(points, mixed)
    run = mesh.half_edges[mesh.edges]
    assert (run[:, 0, 0] == run[:, 1, 1]).all()
    assert len(mesh.loops()) == 1


def test_long_edges_are_halved():
    mesh = one_surface(*triangles(barrel, 7, 5))
    finer, values, counts = refined(mesh, mesh.points[:, 0], (10, 6), 1.0)
    lengths = np.linalg.norm(np.diff(finer.points[finer.half_edges], axis=1)[:, 0], axis=1)
    assert lengths.max() <= 1.0
    assert finer.areas.sum() == pytest.approx(mesh.areas.sum())
    inner, covered = counts[0], sum(counts)
    assert finer.areas[:inner].sum() == pytest.approx(mesh.areas[:10].sum())
    assert finer.areas[:covered].sum() == pytest.approx(mesh.areas[:16].sum())
    assert np.allclose(values, finer.points[:, 0])
    assert len(finer.rim) > len(mesh.rim)


def test_a_combed_field_turns_at_its_cut_only():
    mesh, _, _, field = work(dome, 1.5)
    assert field.quarters.any()
    cut = cut_open(mesh, field)
    quarters, left = turns(mesh, cut.angles)
    assert not (quarters[~cut.edges] % 4).any()
    assert (quarters[cut.edges] % 4).any()
    assert np.abs(left).max() <= np.pi / 4 + 1e-9
    # Branches end at singular vertices or at the border.
    start, end = mesh.ends
    count = np.bincount(
        np.concatenate([start[cut.edges], end[cut.edges]]), minlength=len(mesh.points)
    )
    loose = (count == 1) & ~mesh.on_rim
    assert set(np.flatnonzero(loose)) <= set(np.flatnonzero(field.quarters))


def test_a_map_fits_across_its_cut_and_has_singular_vertices_at_whole_places():
    mesh, inner, guide, field = work(dome, 1.5)
    cut = cut_open(mesh, field)
    layout = seams(mesh, cut, field.quarters != 0)
    made = seamless_map(mesh, cut, layout, np.minimum(1, guide.stretch**2), (1.5, 1.5), inner)
    one, two = mesh.edges.T
    for at in (0, 1):
        here = made.corners[one // 3, (one + at) % 3]
        there = made.corners[two // 3, (two + 1 - at) % 3]
        shift = there - np.einsum("eij,ej->ei", TURNS[cut.turns], here)
        assert not (shift % GRID).any()
        assert not shift[~cut.edges].any()
    singular = np.isin(mesh.triangles, np.flatnonzero(field.quarters))
    assert not (made.corners[singular] % GRID).any()
    assert not len(made.folded)


def test_cells_of_a_plain_map_are_a_grid():
    mesh = one_surface(*triangles(plane, 25, 17))
    angles = np.zeros(len(mesh.triangles))
    # Directions along x, in each triangle's frame; coordinates are the place over 2, and 0.3 more.
    east = np.arctan2(mesh.axes[:, 1, 0], mesh.axes[:, 0, 0])
    cut = cut_open(mesh, DirectionField(angles + east, np.zeros(len(mesh.points), dtype=int)))
    assert not cut.edges.any()
    place = np.round((mesh.points[mesh.triangles][..., :2] / 2 + 0.3) * GRID).astype(np.int64)
    found = quads(mesh, cut, Map(place, np.array([], dtype=int)), len(mesh.triangles))
    # 0.3 to 6.3 and 0.3 to 4.3: seven columns and five rows.
    assert len(found.faces) == 35
    assert len(found.places) == 48
    inside = found.places[~found.beyond]
    assert np.abs((inside[:, :2] / 2 + 0.3) % 1 - 0.5).min() > 0.5 - 1e-5
    assert found.beyond.sum() == 48 - 6 * 4
    assert not found.joined


def test_whole_numbers_that_suit_each_other():
    # Rounded one by one, 0.4 and 0.4 come to 0 and 0; their sum is held at 0.8.
    squares = np.array([[2.0, 1.9], [1.9, 2.0]])
    pull = squares @ np.array([0.4, 0.4])
    found = rounded(squares, pull, [])
    assert found.sum() == 1

    def energy(z):
        return z @ squares @ z - 2 * pull @ z

    others = [np.array([a, b]) for a in range(-2, 3) for b in range(-2, 3)]
    assert energy(found) == pytest.approx(min(map(energy, others)))


def test_the_first_place_is_at_zero():
    squares = np.array([[1.0, 0, -1, 0], [0, 1, 0, -1], [-1, 0, 1, 0], [0, -1, 0, 1.0]])
    pull = squares @ np.array([0.2, 0.1, 5.4, -2.2])
    assert rounded(squares, pull, [0, 1]).tolist() == [0, 0, 5, -2]


def test_a_surface_reaches_as_far_as_what_overhangs_it():
    points, faces = triangles(plane, 25, 17)
    x, y = np.meshgrid(np.linspace(-0.5, 12.4, 14), np.linspace(-0.4, 8, 10), indexing="ij")
    mesh = grid_mesh(np.stack([x, y, 0 * x], axis=-1))
    more, triangles_ = reaching(mesh, points, faces)
    larger = TriangleMesh(more, triangles_)
    assert np.ptp(more[:, 0]) > 13.5
    assert np.abs(more[:, 2]).max() < 1e-9
    assert larger.areas.sum() > 13 * 9
    # Colours say how far it is from the surface as it goes on, also when it is asked again.
    ground = TriangleSurface(points, faces)
    for raised in (0.0, 0.01):
        moved = mesh.with_vertices(mesh.vertices + [0, 0, raised])
        gap = field(moved, "Gap to reference", ground).values
        assert gap == pytest.approx(raised, abs=1e-9)
    within = grid_mesh(np.stack([0.9 * x + 0.6, 0.9 * y + 0.5, 0 * x], axis=-1))
    assert reaching(within, points, faces)[0] is points
    elsewhere = grid_mesh(np.stack([x + 60, y, 0 * x], axis=-1))
    assert reaching(elsewhere, points, faces)[0] is points
    above = grid_mesh(np.stack([0.9 * x + 0.6, 0.9 * y + 0.5, 0 * x + 1], axis=-1))
    assert reaching(above, points, faces)[0] is points
    # Room for lines that have to leave it, in its own plane.
    more, _ = beyond(within, points, faces)
    assert np.abs(more[:, 2]).max() < 1e-9
    assert (np.ptp(more, axis=0)[:2] > [12 + 2 * 1.5, 8 + 2 * 1.5]).all()


@pytest.mark.parametrize(
    ("faces", "wrong"),
    [
        ([[0, 1, 2, 3], [1, 4, 5, 2]], None),
        # Two faces on one side of a side; corners that are one; a side without a length.
        ([[0, 1, 2, 3], [0, 1, 4, 5]], 0),
        ([[3, 1, 3, 2]], 3),
        ([[0, 1, 2, 1]], 1),
        ([[0, 4, 4, 2]], 4),
    ],
)
def test_faces_of_a_map_that_overlap_are_found(faces, wrong):
    places = np.arange(18.0).reshape(6, 3)
    none = np.zeros(6, dtype=int)
    found = crossing(Quads(np.array(faces), places, none > 0, none, np.zeros((6, 2), int), 0))
    assert (found is None) if wrong is None else np.array_equal(found, places[wrong])


def test_directions_of_a_border_run_along_it():
    mesh = one_surface(*triangles(plane, 11, 11))
    larger, _ = extended(mesh, 1.0, 0.25, 1.5)
    guide = _along_border(larger, len(mesh.triangles))
    rows = np.flatnonzero(guide.certainty)
    angles = guide.angles[rows, None]
    axes = larger.axes[rows]
    along = np.abs(np.cos(angles) * axes[:, 0] + np.sin(angles) * axes[:, 1])
    assert len(rows) >= 40
    np.testing.assert_allclose(np.sort(along, axis=1), [[0.0, 0.0, 1.0]] * len(rows), atol=1e-6)
