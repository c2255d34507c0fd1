"""PLY, OFF and JSON keep quads, digits, order and unit; broken files get one line."""

from __future__ import annotations

import json
import struct

import numpy as np
import pytest

from freecad_ortho import api
from solver import InputError, OutputError
from solver.io.points import read_points
from solver.io.polygons import read_polygons, write_mesh
from tests.conftest import wavy_grid

MESH = wavy_grid(5, 4).scaled(1 / 3)


@pytest.mark.parametrize("extension", ["obj", "ply", "off", "json", "PLY"])
@pytest.mark.parametrize("unit", ["m", None])
def test_written_and_read_back_every_digit(tmp_path, extension, unit):
    path = tmp_path / f"net.{extension}"
    api.write_mesh(path, MESH, unit)
    loaded = api.read_mesh(path)
    assert loaded.unit == (unit or "mm")
    # A mesh 1.5 mm wide in no unit is remarked.
    assert len(loaded.remarks) == (unit is None)
    assert (loaded.mesh.faces == MESH.faces).all()
    assert (loaded.mesh.vertices == MESH.vertices).all()
    assert sorted(p.name for p in tmp_path.iterdir()) == [path.name]


@pytest.mark.parametrize("extension", ["obj", "ply", "off", "json"])
def test_marks_and_line_ends_of_other_systems_do_not_matter(tmp_path, extension):
    path = tmp_path / f"net.{extension}"
    api.write_mesh(path, MESH, "m")
    path.write_bytes(b"\xef\xbb\xbf" + path.read_bytes().replace(b"\n", b"\r\n"))
    loaded = api.read_mesh(path)
    assert loaded.unit == "m"
    assert (loaded.mesh.vertices == MESH.vertices).all()


def binary_ply(order: str, index: str = "vertex_indices", scalar: str = "double") -> bytes:
    name = {"<": "binary_little_endian", ">": "binary_big_endian"}[order]
    head = f"""ply
format {name} 1.0
comment unit: cm
comment made by hand
element vertex {len(MESH.vertices)}
property {scalar} x
property {scalar} y
property {scalar} z
property uchar red
element face {len(MESH.faces)}
property float quality
property list uchar int {index}
element edge 1
property int vertex1
property int vertex2
end_header
"""
    kind = {"double": "d", "float": "f"}[scalar]
    body = b"".join(struct.pack(f"{order}3{kind}B", *row, 7) for row in MESH.vertices.tolist())
    body += b"".join(struct.pack(f"{order}fB4i", 0.5, 4, *row) for row in MESH.faces.tolist())
    return head.encode() + body + struct.pack(f"{order}2i", 0, 1)


@pytest.mark.parametrize("order", ["<", ">"])
@pytest.mark.parametrize("index", ["vertex_indices", "vertex_index"])
def test_binary_ply_of_other_programs(tmp_path, order, index):
    path = tmp_path / "net.ply"
    path.write_bytes(binary_ply(order, index))
    data = read_polygons(path)
    assert data.unit == "cm"
    assert data.polygons == MESH.faces.tolist()
    assert (data.vertices == MESH.vertices).all()
    path.write_bytes(binary_ply(order, index, "float"))
    np.testing.assert_allclose(read_polygons(path).vertices, MESH.vertices, atol=1e-6)


@pytest.mark.parametrize("name", ["net.stl", "net.xyz", "net"])
def test_unknown_ending_is_refused_by_name(tmp_path, name):
    with pytest.raises(InputError, match=r"ends in \.obj, \.ply, \.off, \.json, got"):
        api.write_mesh(tmp_path / name, MESH)
    assert list(tmp_path.iterdir()) == []


def test_other_libraries_read_what_is_written(tmp_path):
    trimesh = pytest.importorskip("trimesh")
    for extension in ("ply", "off"):
        path = tmp_path / f"net.{extension}"
        write_mesh(path, MESH)
        other = trimesh.load(path, process=False)
        assert len(other.faces) == 2 * len(MESH.faces)
        np.testing.assert_allclose(other.vertices, MESH.vertices, atol=1e-7)


def test_off_with_header_in_one_line_colours_and_comments(tmp_path):
    path = tmp_path / "net.off"
    path.write_text("OFF 4 1 0 # head\n\n0 0 0\n1 0 0 # x\n1 1 0\n0 1 0\n4 0 1 2 3 255 0 0\n")
    assert read_polygons(path).polygons == [[0, 1, 2, 3]]


def test_mixed_meshes_say_what_to_do(tmp_path):
    path = tmp_path / "mixed.ply"
    path.write_text(
        "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
        "property float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n4 0 1 2 3\n3 1 4 2\n"
    )
    with pytest.raises(InputError, match="1 triangle among 2; face 1 has 3; make quads of them"):
        api.read_mesh(path)


@pytest.mark.parametrize(
    ("name", "content", "words"),
    [
        ("a.ply", b"solid", "header is missing"),
        ("a.ply", b"ply\nformat ascii 2\nelement vertex x\nend_header\n", "not understood"),
        ("a.ply", b"ply\nelement vertex 1\nend_header\n", "format line"),
        ("a.ply", binary_ply("<")[:-60], "cut off or damaged"),
        ("a.ply", b"ply\nformat ascii 1.0\nend_header\n", "no vertices"),
        ("a.off", b"COFFEE", "first word is not OFF"),
        ("a.off", b"OFF\n4 1 0\n0 0 0\n", "cut off"),
        ("a.off", b"OFF\n1 1 0\n0 0 a\n1 0\n", "line 3: expected 3 numbers"),
        ("a.off", b"OFF\nfour one\n", "expected 2 numbers"),
        ("a.json", b"{", "vertices"),
        ("a.json", b'{"vertices": [[0, 0]], "faces": [[0, 1, 2, 3]]}', "three coordinates"),
        ("a.json", b'{"vertices": [[0, 0, 0]], "faces": [[0.5, 1, 2, 3]]}', "expected"),
        ("a.json", b"[1, 2]", "expected"),
        ("a.stl", b"solid", "triangles only"),
        ("missing.ply", None, "no such file"),
        ("missing.off", None, "no such file"),
    ],
)
def test_broken_files_get_one_line(tmp_path, name, content, words):
    path = tmp_path / name
    if content is not None:
        path.write_bytes(content)
    with pytest.raises(InputError, match=words) as caught:
        read_polygons(path)
    assert "\n" not in str(caught.value)


def test_nothing_is_left_where_nothing_can_be_written(tmp_path):
    for extension in ("ply", "off", "json"):
        with pytest.raises(OutputError):
            write_mesh(tmp_path / "nowhere" / f"net.{extension}", MESH)


def test_json_is_plain(tmp_path):
    path = tmp_path / "net.json"
    write_mesh(path, MESH, "ft")
    data = json.loads(path.read_text())
    assert sorted(data) == ["faces", "unit", "vertices"]


def test_lists_of_points(tmp_path):
    path = tmp_path / "points.csv"
    path.write_bytes(b"\xef\xbb\xbf1, 2, 3\r\n# x, y, z\r\n\r\n4;5;6 # last\r\n")
    np.testing.assert_array_equal(read_points(path), [[1, 2, 3], [4, 5, 6]])
    obj = tmp_path / "line.obj"
    obj.write_text("o line\nv 0 0 0\nv 1 0 0\nl 1 2\n")
    assert read_points(obj).shape == (2, 3)
    for text, words in (
        ("1 2\n", "3 numbers"),
        ("1 2 x\n", "line 1"),
        ("1 2 3\n", "at least 2 points, got 1"),
    ):
        path.write_text(text)
        with pytest.raises(InputError, match=words):
            read_points(path)
