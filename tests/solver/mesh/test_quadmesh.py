"""A mesh from plain lists and arrays, and what is refused in one line."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

from solver import InputError, QuadMesh

POINTS = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
FACE = [[0, 1, 2, 3]]


@pytest.mark.parametrize("kind", [list, tuple, np.array, lambda rows: np.array(rows, np.float32)])
def test_plain_lists_and_arrays_are_a_mesh(kind):
    mesh = QuadMesh(kind(POINTS), kind(FACE))
    assert mesh.vertices.dtype == np.float64 and mesh.faces.dtype == np.int64
    assert mesh.vertices.tolist() == POINTS and mesh.faces.tolist() == FACE
    assert mesh.mean_edge == 1.0


def test_a_mesh_is_a_copy_that_nobody_changes():
    points = np.array(POINTS, dtype=float)
    mesh = QuadMesh(points, FACE)
    points[0] = 5.0
    assert mesh.vertices[0].tolist() == [0, 0, 0]
    with pytest.raises(ValueError, match="read-only"):
        mesh.vertices[0] = 1.0
    with pytest.raises(AttributeError):
        mesh.vertices = points


def test_connectivity_is_shared_and_survives_a_journey():
    mesh = QuadMesh(POINTS, FACE)
    moved = mesh.with_vertices(mesh.vertices + 1.0)
    assert moved.connectivity is mesh.connectivity
    assert QuadMesh(moved.vertices, mesh.connectivity).connectivity is mesh.connectivity
    again = pickle.loads(pickle.dumps(moved))
    assert again.vertices.tolist() == moved.vertices.tolist() and again.faces.tolist() == FACE


@pytest.mark.parametrize(
    ("points", "faces", "says"),
    [
        (POINTS, [[0, 1, 2]], r"faces: expected an array of shape \(F, 4\)"),
        (POINTS, [[0, 1, 2, 3], [0, 1, 2]], "faces: expected whole numbers of shape"),
        (POINTS, [[0, 1, 2, 2.5]], "faces: expected whole numbers of shape"),
        (POINTS, [[0, 1, 2, np.nan]], "faces: expected whole numbers of shape"),
        (POINTS, ["abcd"], "faces: expected whole numbers of shape"),
        (POINTS, None, "faces: expected whole numbers of shape"),
        (POINTS, [], r"faces: expected an array of shape \(F, 4\) with F > 0"),
        (POINTS, [[0, 1, 2, 4]], r"faces: face 0 names vertices \[0, 1, 2, 4\]"),
        ([[0, 0], [1, 0], [1, 1], [0, 1]], FACE, r"vertices: expected shape \(V, 3\), got \(4, 2"),
        ([[0, 0, 0], [1, 0]], FACE, "vertices: expected numbers of shape"),
        ("points", FACE, "vertices: expected numbers of shape"),
        (3.0, FACE, r"vertices: expected shape \(V, 3\), got \(\)"),
        ([[0, 0, 0], [1, 0, 0], [1, np.inf, 0], [0, 1, 0]], FACE, "vertices: 1 have NaN"),
    ],
)
def test_what_is_no_mesh_is_refused_in_one_line(points, faces, says):
    with pytest.raises(InputError, match=says) as said:
        QuadMesh(points, faces)
    assert "\n" not in str(said.value)


def test_other_positions_need_the_same_number():
    mesh = QuadMesh(POINTS, FACE)
    with pytest.raises(InputError, match=r"vertices: expected shape \(4, 3\), got \(3, 3\)"):
        mesh.with_vertices(np.zeros((3, 3)))
