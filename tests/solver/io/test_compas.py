"""Meshes of COMPAS in all layouts that it has had."""

from __future__ import annotations

import json

import pytest

from freecad_ortho import api
from solver import InputError
from solver.io.polygons import read_polygons
from tests.conftest import wavy_grid

MESH = wavy_grid(4, 3)


def layout(first: int = 0, keyed=str) -> dict:
    """What is common to all: vertices and faces by key, keys as texts; z of a vertex may be 0."""
    rows = zip("xyz", zip(*MESH.vertices.tolist(), strict=True), strict=True)
    columns = dict(rows)
    vertex = {
        str(k + first): {axis: column[k] for axis, column in columns.items() if column[k]}
        for k in range(len(MESH.vertices))
    }
    face = {
        str(7 * k): [keyed(corner + first) for corner in corners]
        for k, corners in enumerate(MESH.faces.tolist())
    }
    return {"vertex": vertex, "face": face, "facedata": {}, "edgedata": {}, "max_vertex": 99}


NEW = {"default_vertex_attributes": {"x": 0.0, "y": 0.0, "z": 0.0}, "attributes": {}}
OLD = {"dva": {"x": 0.0, "y": 0.0, "z": 0.0}, "dea": {}, "dfa": {}, "attributes": {"name": "m"}}
DTYPE = "compas.datastructures/Mesh"


@pytest.mark.parametrize(
    "data",
    [
        {"dtype": DTYPE, "data": layout() | NEW, "name": "m", "guid": "1"},
        {"dtype": DTYPE, "value": layout(12) | OLD, "guid": "1"},
        {"compas": "0.19", "datatype": DTYPE, "data": layout(1, str) | OLD},
        layout() | OLD,
        [{"dtype": DTYPE, "data": layout(5) | NEW}],
        {"dtype": "compas/Data", "data": {"mesh": {"dtype": DTYPE, "data": layout() | NEW}}},
    ],
    ids=["2", "1", "0 with type", "0", "list", "within"],
)
def test_every_layout_is_read(tmp_path, data):
    path = tmp_path / "mesh.json"
    path.write_text(json.dumps(data))
    loaded = api.read_mesh(path, "m")
    assert (loaded.mesh.vertices == MESH.vertices).all()
    assert loaded.mesh.faces.tolist() == MESH.faces.tolist()


@pytest.mark.parametrize(
    ("data", "words"),
    [
        ([layout() | NEW, layout() | NEW], "holds 2 COMPAS meshes"),
        (layout() | NEW | {"face": {"0": [0, 1, 2, 400]}}, "face '0' names vertex '400'"),
        (layout() | {"vertex": {"0": {"x": "a"}}}, "or a mesh of COMPAS"),
        (layout() | NEW | {"face": {}}, "at least one face"),
        (layout() | {"vertex": {"0": None}}, "or a mesh of COMPAS"),
    ],
)
def test_others_are_refused_in_one_line(tmp_path, data, words):
    path = tmp_path / "mesh.json"
    path.write_text(json.dumps(data))
    with pytest.raises(InputError, match=words) as caught:
        read_polygons(path)
    assert "\n" not in str(caught.value)
