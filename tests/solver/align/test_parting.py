"""Flat faces parted at corners that point inwards, and beside openings."""

from __future__ import annotations

import numpy as np
import pytest

from solver import Constraints, optimise
from solver.align.align import aligned
from solver.align.facets import FlatFaces, turning
from solver.align.parting import parted
from solver.align.triangle_mesh import TriangleMesh, one_surface
from solver.analysis import measures
from tests.design_surfaces import HIP, WING, sheet


def pierced(x, y):
    """A level square, 8 m wide, with a square opening of 2 m whose least corner is given."""
    outer = [(0, 0), (8, 0), (8, 8), (0, 8)]
    inner = [(x, y), (x + 2, y), (x + 2, y + 2), (x, y + 2)]
    points = np.column_stack([np.array(outer + inner, dtype=float), np.zeros(8)])
    rows = [((k, (k + 1) % 4, 4 + (k + 1) % 4), (k, 4 + (k + 1) % 4, 4 + k)) for k in range(4)]
    return TriangleMesh(points, np.array([row for pair in rows for row in pair]))


def widest(mesh, sharp):
    """The largest angle, in degrees, of a face at a vertex of its outline."""
    facets = FlatFaces.of(mesh, sharp, 1.0, 96)
    found = 0.0
    for own in facets.triangles:
        half = mesh.half_edges.reshape(-1, 3, 2)[own].reshape(-1, 2)
        rim = {tuple(pair) for pair in half.tolist()}
        rim = [pair for pair in rim if pair[::-1] not in rim]
        for vertex in {pair[0] for pair in rim}:
            total = 0.0
            for triangle in mesh.triangles[own]:
                if vertex in triangle:
                    k = int(np.flatnonzero(triangle == vertex)[0])
                    one, two = (
                        mesh.points[triangle[(k + n) % 3]] - mesh.points[vertex] for n in (1, 2)
                    )
                    cosine = one @ two / np.linalg.norm(one) / np.linalg.norm(two)
                    total += np.degrees(np.arccos(np.clip(cosine, -1, 1)))
            found = max(found, total)
    return found


def test_a_roof_without_such_corners_stays_as_it_is():
    mesh = one_surface(*sheet(HIP))
    sharp = turning(mesh, 0.03)
    made, lines = parted(mesh, sharp, 1.2)
    assert made is mesh and (lines == sharp).all()


def test_a_face_is_parted_at_a_wing_and_beside_a_window():
    mesh = one_surface(*sheet(WING))
    made, lines = parted(mesh, turning(mesh, 0.03), 1.2)
    facets = FlatFaces.of(made, lines, 1.2)
    # The slope is parted in two by the wing, and the one with the window in four.
    assert len(facets.sides) == 3 + 1 + 4
    assert made.areas.sum() == pytest.approx(mesh.areas.sum())
    assert widest(made, lines) < 181.0
    # The ridge of the wing goes on to the ridge of the roof.
    assert np.linalg.norm(made.points - [12, 5, 3], axis=1).min() < 1e-9


@pytest.mark.parametrize("corner", [(3, 3), (1, 2), (0.2, 3), (5.9, 5.8)])
def test_round_an_opening_anywhere_no_corner_points_inwards(corner):
    mesh = pierced(*corner)
    made, lines = parted(mesh, np.zeros(len(mesh.edges), dtype=bool), 1.0)
    assert made.areas.sum() == pytest.approx(60.0)
    assert widest(made, lines) < 181.0
    assert len(made.loops()) == 2


def test_panels_end_at_a_window_and_stay_flat_where_they_are():
    points, triangles = sheet(WING)
    # Files of triangles have seven digits.
    points = points.astype(np.float32).astype(float)
    made = aligned(points, triangles, edge=1.2)
    assert "made of 4 flat faces" in made.remarks[0]
    net = made.mesh
    assert measures.area(net) == pytest.approx(one_surface(points, triangles).areas.sum())
    assert len(net.connectivity.boundary_loops) == 2
    assert net.edge_lengths.min() > 0.4 * net.mean_edge
    outcome = optimise(net, "planar", constraints=Constraints(close_to=(points, triangles)))
    assert outcome.report.status == "converged" and not outcome.report.history
    assert measures.planarity(outcome.mesh).max() < 1e-12
    assert np.abs(outcome.mesh.vertices - net.vertices).max() < 1e-5
