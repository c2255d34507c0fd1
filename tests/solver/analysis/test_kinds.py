"""Kinds of panels, edges and nodes, against meshes whose kinds are known by counting."""

from itertools import combinations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from solver import QuadMesh
from solver.analysis import kinds
from solver.analysis.kinds import REPEATED, corner_miss, kinds_within, spokes
from solver.errors import InputError
from tests.conftest import grid_faces, surface_of_revolution, wavy_grid


def squares(rows=5, columns=4):
    i, j = np.meshgrid(np.arange(float(rows)), np.arange(float(columns)), indexing="ij")
    points = np.stack([i, j, 0 * i], axis=2).reshape(-1, 3)
    return QuadMesh(points, grid_faces(rows, columns))


def loose(*quads):
    """A mesh of single faces."""
    points = np.concatenate(quads).astype(float)
    return QuadMesh(points, np.arange(len(points)).reshape(-1, 4))


QUAD = np.array([[0, 0, 0], [2, 0, 0], [1.7, 1.3, 0.2], [0.1, 1.0, 0]])


@pytest.mark.parametrize(
    ("of", "counts"), [("panels", [12]), ("edges", [31]), ("nodes", [10, 6, 4])]
)
def test_squares(of, counts):
    found = kinds_within(squares(), of, 1e-9)
    assert found.counts.tolist() == counts and found.worst <= 1e-12


@pytest.mark.parametrize(("of", "number"), [("panels", 6), ("edges", 13), ("nodes", 19)])
def test_a_surface_of_revolution_repeats_along_its_parallels(of, number):
    """Six rows of panels, and so many lengths along meridians; seven around.

    Of nodes seven inside, and five at each of two meridians, which are mirror images of each other;
    the two edges of a corner say nothing of that.
    """
    found = kinds_within(surface_of_revolution(), of, 1e-6)
    assert found.number == number
    assert found.counts.sum() == {"panels": 48, "edges": 110, "nodes": 63}[of]


def test_many_equal_panels_are_not_compared_in_pairs(monkeypatch):
    mesh = surface_of_revolution()
    before = [kinds_within(mesh, of, 1e-6).counts.tolist() for of in REPEATED]
    monkeypatch.setattr(kinds, "_MOST_PAIRS", 0)
    monkeypatch.setattr(kinds._Search, "pairs", None)
    assert [kinds_within(mesh, of, 1e-6).counts.tolist() for of in REPEATED] == before


def test_a_panel_may_be_turned_and_not_flipped_over():
    turned = Rotation.from_euler("xyz", [0.3, 1.1, -2.0]).apply(np.roll(QUAD, 1, axis=0)) + 5
    flipped = np.roll(QUAD[::-1] * [1, -1, 1], 2, axis=0)
    mirrored = (QUAD * [-1, 1, 1])[::-1]
    assert kinds_within(loose(QUAD, turned), "panels", 1e-9).number == 1
    assert kinds_within(loose(QUAD, mirrored), "panels", 0.05).number == 2
    assert kinds_within(loose(QUAD, flipped), "panels", 0.05).number == 2


def test_lengths_are_in_as_few_groups_as_possible():
    rng = np.random.default_rng(3)
    for _ in range(20):
        ends = np.concatenate([[0.0], np.cumsum(rng.uniform(0.5, 1.5, 3))])
        points = np.stack([ends, 0 * ends, 0 * ends], axis=1)
        mesh = QuadMesh(np.concatenate([points, points + [0, 1, 0]]), grid_faces(2, 4)[:, ::-1])
        found, within = kinds_within(mesh, "edges", 0.1), 0.1
        lengths = np.unique(mesh.edge_lengths.round(12))
        least = next(
            k
            for k in range(1, len(lengths) + 1)
            for cut in combinations(range(1, len(lengths)), k - 1)
            if all(np.ptp(part) <= 2 * within for part in np.split(lengths, cut))
        )
        assert found.number == least
        assert found.worst <= within
        for number in range(found.number):
            group = mesh.edge_lengths[found.kind == number]
            assert np.ptp(group) == pytest.approx(2 * found.miss[found.kind == number].max())


def test_every_panel_is_near_one_that_leads_its_kind():
    mesh = wavy_grid(9, 8, shear=0.1)
    corners = mesh.vertices[mesh.faces]
    corners = corners - corners.mean(axis=1, keepdims=True)
    found = kinds_within(mesh, "panels", 0.012)
    assert 1 < found.number < len(mesh.faces) / 2
    assert (np.diff(found.counts) <= 0).all()
    for number in range(found.number):
        group = np.flatnonzero(found.kind == number)
        leaders = group[found.miss[group] == 0]
        shape = corners[leaders[0]]
        turned = [np.roll(corners[group], turn, axis=1) for turn in range(4)]
        away = [corner_miss(part, np.broadcast_to(shape, part.shape)) for part in turned]
        assert np.allclose(np.min(away, axis=0), found.miss[group], rtol=0, atol=1e-12)
        assert found.miss[group].max() <= 0.012


@pytest.mark.parametrize("of", REPEATED)
def test_fewer_kinds_with_a_larger_tolerance(of):
    mesh = wavy_grid(7, 6)
    numbers = [kinds_within(mesh, of, within).number for within in (1e-3, 0.05, 0.3, 3.0)]
    assert numbers == sorted(numbers, reverse=True) and numbers[0] > numbers[-1]


def test_neighbours_are_in_their_order_around_a_node():
    mesh = squares(3, 3)
    rings = {int(v): ring for hub in spokes(mesh) for v, ring in zip(*hub[:2], strict=True)}
    assert sorted(map(len, rings.values())) == [2] * 4 + [3] * 4 + [4]
    for vertex, ring in rings.items():
        away = mesh.vertices[ring] - mesh.vertices[vertex]
        angles = np.unwrap(np.arctan2(away[:, 1], away[:, 0]))
        assert (np.diff(angles) > 0).all() and angles[-1] - angles[0] < 2 * np.pi


@pytest.mark.parametrize(("of", "within"), [("panes", 1.0), ("panels", 0.0), ("edges", np.nan)])
def test_what_cannot_be_counted_is_refused(of, within):
    with pytest.raises(
        InputError, match=r"repeat: expected|tolerance of kinds: expected a (finite )?number"
    ):
        kinds_within(squares(), of, within)
