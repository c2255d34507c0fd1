"""Parameter lines: their order, families and numbers follow the connectivity alone."""

import numpy as np
import pytest

from solver.mesh.coarsen import compact
from solver.mesh.connectivity import Connectivity
from solver.mesh.diagonal import diagonal_meshes
from solver.mesh.grid import grid_faces
from solver.mesh.lines import ParameterLines, joined_at_border
from solver.mesh.primitives import rectangle
from solver.mesh.quadmesh import QuadMesh


def lines_of(m, n, **closed):
    return ParameterLines(Connectivity(grid_faces(m, n, **closed), m * n))


def test_lines_of_a_grid_are_its_rows_and_columns():
    lines, numbers = lines_of(5, 4), np.arange(20).reshape(5, 4)
    assert [line.vertices.tolist() for line in lines.of_family("u")] == numbers.T.tolist()
    assert [line.vertices.tolist() for line in lines.of_family("v")] == numbers.tolist()
    assert [line.number for line in lines.all] == [0, 1, 2, 3, 0, 1, 2, 3, 4]
    assert not any(line.closed for line in lines.all)


def test_edges_join_the_vertices_in_order_and_each_belongs_to_one_line():
    lines = lines_of(6, 5, closed_u=True)
    ends = lines.connectivity.edges
    for line in lines.all:
        path = np.append(line.vertices, line.vertices[0]) if line.closed else line.vertices
        pairs = np.sort(np.stack([path[:-1], path[1:]], axis=1), axis=1)
        assert (ends[line.edges] == pairs).all()
        assert (lines.edge_line[line.edges] == line.number).all()
        assert (lines.edge_family[line.edges] == "uv".index(line.family)).all()
    used = np.concatenate([line.edges for line in lines.all])
    assert sorted(used) == list(range(len(ends)))


def test_closed_lines_return_and_start_at_their_smallest_vertex():
    lines = lines_of(6, 5, closed_u=True)
    assert all(line.closed and len(line.edges) == 6 for line in lines.of_family("u"))
    assert all(not line.closed and len(line.edges) == 4 for line in lines.of_family("v"))
    assert all(line.vertices[0] == line.vertices.min() for line in lines.all)


def fan(count):
    """Faces around one vertex, two neighbours sharing each spoke."""
    spoke, tip = 1 + np.arange(count), 1 + count + np.arange(count)
    faces = np.stack([0 * spoke, spoke, tip, np.roll(spoke, -1)], axis=1)
    return ParameterLines(Connectivity(faces, 1 + 2 * count))


@pytest.mark.parametrize(("count", "families"), [(3, {""}), (5, {""}), (6, {"u", "v"})])
def test_families_exist_where_they_can_alternate(count, families):
    lines = fan(count)
    assert {line.family for line in lines.all} == families
    spokes = [line for line in lines.all if 0 in line.vertices]
    assert len(spokes) == count
    assert all(len(line.edges) == 1 for line in spokes)


def test_each_component_has_its_own_families():
    one = grid_faces(3, 3)
    lines = ParameterLines(Connectivity(np.concatenate([one, np.roll(one, -1, axis=1) + 9]), 18))
    first, second = (
        {
            tuple(line.vertices % 9)
            for line in lines.of_family("u")
            if (line.vertices < 9).all() == k
        }
        for k in (True, False)
    )
    assert first == {(0, 3, 6), (1, 4, 7), (2, 5, 8)}
    assert second == {(0, 1, 2), (3, 4, 5), (6, 7, 8)}


def test_names_survive_a_move_and_do_not_depend_on_the_start_corner_within_a_family():
    faces = grid_faces(4, 5)
    turned = ParameterLines(Connectivity(np.roll(faces, 2, axis=1), 20))
    plain = ParameterLines(Connectivity(faces, 20))
    for one, other in zip(plain.all, turned.all, strict=True):
        assert one.family == other.family
        assert one.vertices.tolist() == other.vertices.tolist()


def zigzag(bulge=0.0):
    """A diagonal mesh of a square, its border a zigzag, raised by ``bulge`` at the middle."""
    flat = rectangle(9, 9, length=8.0, width=8.0)
    part = diagonal_meshes(flat).first
    mesh = compact(part, part.faces)
    away = np.hypot(*(mesh.vertices[:, :2] - mesh.vertices[:, :2].mean(axis=0)).T)
    return mesh.with_vertices(mesh.vertices + bulge * np.stack([0 * away, 0 * away, away**2], 1))


@pytest.mark.parametrize("bulge", [0.0, 0.01])
def test_lines_run_on_through_a_zigzag_border(bulge):
    mesh = zigzag(bulge)
    ends = [line for line in ParameterLines(mesh.connectivity).all if len(line.edges) == 1]
    lines = ParameterLines.of(mesh)
    assert len(ends) > 10
    assert len(lines.all) < len(ParameterLines(mesh.connectivity).all) - len(ends) / 2
    # Whatever meets at a vertex runs through it, but at corners of the border.
    count = np.zeros(mesh.connectivity.vertex_count, dtype=int)
    for line in lines.all:
        count[line.vertices[[0, -1]]] += 1
        steps = np.diff(mesh.vertices[line.vertices], axis=0)
        steps /= np.linalg.norm(steps, axis=1, keepdims=True)
        assert np.einsum("ij,ij->i", steps[1:], steps[:-1]).min(initial=1.0) > np.cos(0.3)
    inwards = mesh.connectivity.boundary_vertices & (mesh.connectivity.edge_valence == 4)
    assert inwards.sum() > 5 and not count[inwards].any()
    assert lines.passed[inwards].all()
    covered = np.concatenate([line.edges for line in lines.all])
    assert sorted(covered) == list(range(len(mesh.connectivity.edges)))


def test_lines_that_turn_too_much_at_the_border_end_there():
    mesh = zigzag(0.3)
    assert len(ParameterLines.of(mesh).all) > len(ParameterLines.of(zigzag()).all)


def test_lines_of_nets_without_a_zigzag_are_those_of_the_connectivity():
    mesh = rectangle(6, 5, length=5.0, width=4.0)
    one, other = ParameterLines.of(mesh), ParameterLines(mesh.connectivity)
    assert not len(one.joined)
    for here, there in zip(one.all, other.all, strict=True):
        assert (here.family, here.number) == (there.family, there.number)
        assert here.vertices.tolist() == there.vertices.tolist()


def test_two_sides_of_one_face_are_no_line():
    """However straight they meet, and where no families of lines tell them apart."""
    fan = [[0, 1, 2, 3], [0, 3, 4, 5], [0, 5, 6, 7]]
    # Three faces around vertex 8: the net has no families.
    odd = [[8, 2, 1, 9], [8, 9, 10, 11], [8, 11, 12, 2]]
    flat = [[0, 0], [1, 0], [0.2, 1], [-1, 0.07], [-2, -1], [-0.6, -0.8], [0, -2], [0.5, -0.9]]
    flat += [[1.5, 1], [2, 0], [3, 0.5], [2.5, 1.5], [1, 2]]
    mesh = QuadMesh(np.column_stack([flat, np.zeros(len(flat))]), fan + odd)
    sides = [set(sides) for sides in mesh.connectivity.face_edges.tolist()]
    joined = joined_at_border(mesh)
    assert not any(set(pair) <= side for pair in joined.tolist() for side in sides)
