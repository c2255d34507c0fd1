"""Lines on flat faces, and what is said of a net before it is made exact."""

from __future__ import annotations

import numpy as np

from examples import demo_surface
from solver.align.align import aligned
from solver.align.guides import net_guide, walked
from solver.align.remarks import say_bunched, say_strokes, short_edges
from solver.align.triangle_mesh import one_surface
from solver.mesh.grid import grid_mesh
from tests.conftest import grid_faces
from tests.design_surfaces import saddle, triangles


def test_lines_on_a_flat_face_run_along_its_longest_side():
    u, v = np.meshgrid(np.linspace(0, 1, 17), np.linspace(0, 1, 9), indexing="ij")
    # The side of a hipped roof: eave, two hips, ridge.
    points = np.stack([(1 - 0.6 * v) * 16 * (u - 0.5), 5 * v, 4 * v], axis=2).reshape(-1, 3)
    faces = grid_faces(17, 9)
    halves = np.concatenate([faces[:, :3], faces[:, [0, 2, 3]]])
    made = aligned(points, halves, edge=1.0)
    ends = made.mesh.vertices[made.mesh.connectivity.edges]
    run = np.abs(ends[:, 1] - ends[:, 0])
    across = np.minimum(run[:, 0], np.hypot(run[:, 1], run[:, 2]))
    assert across.max() < 0.02
    assert not len(made.irregular)


def test_strokes_across_curvature_and_lines_that_bunch_are_said():
    points, faces = triangles(saddle, 31, 19)
    said: list[str] = []
    mesh = one_surface(points, faces)
    tensors = np.tile(np.diag([0.2, -0.2]), (len(faces), 1, 1))
    directions = net_guide(mesh, len(faces), tensors, "principal", 1.0, "boundary", said)
    for turned, words in ((0.0, 0), (0.5, 1)):
        along = mesh.axes[:, 0] * np.cos(turned) + mesh.axes[:, 1] * np.sin(turned)
        stroke = np.stack([mesh.centres[40] - 0.1 * along[40], mesh.centres[40] + 0.1 * along[40]])
        said.clear()
        say_strokes(mesh, directions, [stroke], 0.3, "principal", said)
        assert len(said) == words
    assert "29 degrees to the lines of a principal net" in said[0]
    said.clear()
    even = grid_mesh(np.stack(np.meshgrid(np.arange(9.0), np.arange(9.0), [0.0]), -1)[:, :, 0])
    say_bunched(even, 1.0, said)
    assert not said
    x = np.array([0, 1, 2, 2.1, 2.2, 2.3, 3, 4, 5])
    say_bunched(grid_mesh(np.stack(np.meshgrid(x, x, [0.0]), -1)[:, :, 0]), 1.0, said)
    assert "bunch near (2.25, 2.25, 0)" in said[0] and "10 % of what was wanted" in said[0]


def test_stress_lines_that_run_together_are_spread_over_the_surface():
    def roof(u, v):
        return np.moveaxis(demo_surface.surface(2 * u - 1, 2 * v - 1), -1, 0) / 1000

    points, faces = triangles(roof, 41, 33)
    edge = 1.6
    made = aligned(points, faces, net="stress", edge=edge)
    wanted = one_surface(points, faces).areas.sum() / edge**2
    # The net overhangs the border all round.
    assert abs(len(made.mesh.faces) / wanted - 1) < 1 / 3
    assert short_edges(made.mesh) > 0.5 * edge
    assert any("bunch, here" in remark for remark in made.remarks)


def test_a_stroke_is_walked_in_equal_steps_along_unit_directions():
    places, along = walked(np.array([[0, 0, 0], [4.0, 0, 0], [4, 0, 3]]), 2.0, 0)
    np.testing.assert_allclose(places, [(1, 0, 0), (3, 0, 0), (4, 0, 0.75), (4, 0, 2.25)])
    np.testing.assert_allclose(along, [(1, 0, 0)] * 2 + [(0, 0, 1)] * 2)
