"""Files as other programs lay them out: each is read whole, or refused in one line."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.triangles import read_triangles
from solver import InputError
from solver.io.obj import read_obj
from solver.io.off import read_off
from solver.io.points import read_points
from solver.io.polygons import read_polygons
from tests.conftest import shared_input, wavy_grid

SQUARE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"
CORNERS = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]


@pytest.mark.parametrize(
    ("name", "vertices", "faces"),
    [
        ("backslash_comment.obj", 16, 9),
        ("backslash_space.obj", 16, 9),
        ("face_comment.obj", 16, 9),
        ("libigl_layout.off", 4, 1),
        ("comma.obj", 20, 12),
    ],
)
def test_files_that_lost_something_are_whole(name, vertices, faces):
    mesh = api.read_mesh(shared_input(name)).mesh
    assert (len(mesh.vertices), len(mesh.faces)) == (vertices, faces)
    assert mesh.connectivity.referenced.all()
    assert (mesh.face_normals[:, 2] > 0.5).all()


@pytest.mark.parametrize(
    "text",
    [
        "# from C:\\jobs\\\n" + SQUARE,
        "  # from C:\\jobs\\\n" + SQUARE,
        "o C:\\jobs\\\n" + SQUARE.replace("f", "g roof\\\nusemtl D:\\steel\\\nmtllib E:\\\nf"),
        SQUARE.replace("3 4\n", "3 4 # a \\\n"),
        SQUARE.replace("0\n", "0 # point 1 \\\n"),
        SQUARE.replace("f 1 2 3 4", "f 1 \\ \t\n 2 \\\n# in between\n 3 4"),
        SQUARE.replace("f 1 2 3 4", "f 1 2 \\ # half\n3 4"),
        SQUARE.replace("v 1 0 0", "v 1 \\\n0 \\\n0").replace("f 1 2 3 4\n", "f -4 -3 -2 -1\\\n"),
        SQUARE.replace("v 1 1 0\n", "v 1 1 0\r\n").replace("v 0 1 0\n", "v 0 1 0\r"),
        "# a\x0bv 9 9 9\u2028v 8 8 8\x0cv 7 7 7\n" + SQUARE,
        SQUARE.replace("v 1 0 0", "vn 0 0 1 \\\nv 1 0 0"),
    ],
)
def test_comments_and_continuations_swallow_nothing(tmp_path, text):
    path = tmp_path / "mesh.obj"
    path.write_bytes(text.encode())
    data = read_obj(path)
    assert data.vertices.tolist() == CORNERS
    assert data.polygons == [[0, 1, 2, 3]]


def test_a_vertex_that_runs_into_the_next_is_refused(tmp_path):
    path = tmp_path / "mesh.obj"
    path.write_text(SQUARE.replace("v 1 0 0", "v 1 0 0 \\"))
    with pytest.raises(InputError, match="line 2: expected 'v x y z', got 'v 1 0 0 v 1 1 0'"):
        read_obj(path)


BODY = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"


@pytest.mark.parametrize(
    "text",
    [
        "OFF\n4 1 0\n" + BODY + "4 0\n1\n2\n3\n",
        "OFF4 1 0\n" + BODY + "4 0 1 2 3\n",
        "off 4 1 0 " + BODY.replace("\n", " ") + "4 0 1 2 3",
        "OFF\n4\n1\n0\n" + BODY.replace(" ", "\n") + "4\n0\n1\n2\n3\n",
        "OFF # head\n# unit: m\n4 1 # no edges\n" + BODY + "# faces\n4 0 1 2 3 # last\n",
        "OFF\n4 1\n" + BODY + "4 0 1 2 3 255 0 0\n",
        "OFF\n4 1 4\n" + BODY + "4 0 1 2 3 0.5 0.5 0.5 1.0\n",
        "OFF\n4 1 4\n" + BODY + "4 0 1 2\n3 0.5 0.5 0.5 1.0\n",
        "OFF\n4 1 4\n" + BODY.replace("0\n", "0 255 0 0\n") + "4 0 1 2 3\n",
        "COFF\n4 1 4\n" + BODY.replace("0\n", "0 255 0 0 255\n") + "4 0 1 2 3\n",
        "COFF 4 1 4 " + BODY.replace("0\n", "0 255 0 0 255 ") + "4 0 1 2 3\n",
        "COFF 4 1 4 " + BODY.replace("0\n", "0 .1 .1 .1 ") + "4 0 1 2 3\n",
        "NOFF\n4 1 4\n" + BODY.replace("0\n", "0\n0 0 1\n") + "4 0 1 2 3\n",
        "STCNOFF\n4 1 4\n" + BODY.replace("0\n", "0\n0 0 1\n1 1 1 1\n0.5 0.5\n") + "4 0 1 2 3\n",
        "OFF\n4 1 0\n" + BODY.replace("1 ", "1,0 ") + "4 0 1 2 3\n",
    ],
)
def test_off_is_numbers_in_any_lines(tmp_path, text):
    path = tmp_path / "mesh.off"
    path.write_text(text)
    data = read_off(path)
    assert data.vertices.tolist() == CORNERS
    assert data.polygons == [[0, 1, 2, 3]]


def test_off_of_many_faces_in_one_line(tmp_path):
    mesh = wavy_grid(5, 4)
    path = tmp_path / "mesh.off"
    api.write_mesh(path, mesh)
    plain = read_off(path)
    head, *rest = path.read_text().split("\n")
    path.write_text(head + " ".join(rest))
    data = read_off(path)
    assert data.polygons == plain.polygons == mesh.faces.tolist()
    assert (data.vertices == mesh.vertices).all()
    coloured = [line + " 200 100 50" * line.startswith("4 ") for line in rest]
    path.write_text("\n".join([head, *coloured]))
    data = read_off(path)
    assert data.polygons == mesh.faces.tolist()
    assert list(data.lines) == list(plain.lines)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("OFF BINARY\n4 1 0\n", "is an OFF file binary; export"),
        ("4OFF\n4 1 0\n", "of other than three dimensions; export"),
        ("nOFF 2\n4 1 0\n", "of other than three dimensions; export"),
        ("OFF", "expected 2 numbers"),
        ("OFF 4", "expected 2 numbers"),
        ("OFF -4 1 0", "expected 2 numbers"),
        ("OFF 1 1", "not those of 1 vertices and 1 faces"),
        ("OFF 4 0 0\n" + BODY, "no vertices or no faces"),
        ("OFF\n4 1 0\n" + BODY.replace("1 1 0", "1 1") + "4 0 1 2 3\n", "line 5: expected 3"),
        ("OFF\n4 1 0\n" + BODY + "4 0 1 2\n", "line 7: expected a number of corners, 3 or"),
        ("OFF\n4 1 0\n" + BODY + "4 0 1 x 3\n", "line 7: expected a number of corners, 3 or"),
        ("OFF\n4 1 0\n" + BODY + "99999999999999999999999 0 1 2 3\n", "line 7: expected a number"),
        ("OFF\n4 1 0\n" + BODY + "4 0 1 2 3\n4 0 1 2 3\n", "not those of 4 vertices and 1 faces"),
        ("OFF\n99999999999999999999 1 0\n" + BODY, "not those of 99999999999999999999 vertices"),
    ],
)
def test_other_off_files_are_refused_in_one_line(tmp_path, text, words):
    path = tmp_path / "mesh.off"
    path.write_text(text)
    with pytest.raises(InputError, match=words) as caught:
        read_off(path)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("extension", ["obj", "off", "ply"])
def test_decimal_commas_are_read_and_said(tmp_path, extension):
    path = tmp_path / f"mesh.{extension}"
    mesh = wavy_grid(4, 4).scaled(1 / 3)
    api.write_mesh(path, mesh, "m")
    text = path.read_text()
    head, mark, body = text.partition("end_header")
    body = body.replace(".", ",") if mark else ""
    path.write_text((head + mark + body) if mark else text.replace(".", ","))
    loaded = api.read_mesh(path)
    assert (loaded.mesh.vertices == mesh.vertices).all()
    assert any("decimal commas" in remark for remark in loaded.remarks)
    place = path.read_text().rindex(",")
    path.write_text(path.read_text()[:place] + "." + path.read_text()[place + 1 :])
    with pytest.raises(InputError, match="a decimal comma, others a decimal point"):
        api.read_mesh(path)


def test_decimal_commas_in_lists_of_points(tmp_path):
    path = tmp_path / "points.csv"
    path.write_text("1,5;2;3\n4;5,25;6\n")
    np.testing.assert_array_equal(read_points(path), [[1.5, 2, 3], [4, 5.25, 6]])
    path.write_text("1,5 2,5 3\n4 5 6\n")
    with pytest.raises(InputError, match=r"expected 3 numbers a line.*a comma alone separates"):
        read_points(path)


@pytest.mark.parametrize("extension", ["obj", "off", "ply", "json"])
@pytest.mark.parametrize("encoding", ["utf-16-le", "utf-16-be"])
def test_utf_16_is_read_where_it_is_marked(tmp_path, extension, encoding):
    path = tmp_path / f"mesh.{extension}"
    mesh = wavy_grid(4, 4)
    api.write_mesh(path, mesh, "m")
    text = path.read_text()
    path.write_bytes(("\ufeff" + text).encode(encoding))
    assert (api.read_mesh(path).mesh.vertices == mesh.vertices).all()
    path.write_bytes(text.encode(encoding))
    with pytest.raises(InputError) as caught:
        read_polygons(path)
    assert "UTF-16" in str(caught.value) or extension == "ply"


@pytest.mark.parametrize("reader", [api.read_mesh, read_triangles])
@pytest.mark.parametrize(
    ("name", "text", "words"),
    [
        ("a.obj", SQUARE.replace("4\n", "9" * 25 + "\n"), "with a far too large number"),
        ("a.obj", SQUARE.replace("4\n", "-" + "9" * 25 + "\n"), "counts back beyond the first"),
        ("a.off", "OFF 4 1 0 " + BODY + "4 0 1 2 " + "9" * 25, "with a far too large number"),
        ("a.json", '{"vertices": [[0, 0, 0]], "faces": [[0, 0, 0, 1e999]]}', "expected"),
        ("a.json", '{"vertices": [[' + "9" * 400 + ', 0, 0]], "faces": [[0, 0, 0]]}', "expected"),
        ("a.ply", "element face 1\nproperty list float int vertex_indices\nend_header\n"
         + BODY + "inf 0 1 2 3\n", "cut off or damaged"),
        ("a.ply", "element face 1\nproperty list char int vertex_indices\nend_header\n"
         + BODY + "-1 0 1 2 3\n", "cut off or damaged"),
        ("a.ply", "element face inf\nproperty list uchar int vertex_indices\nend_header\n" + BODY,
         "'element face inf' is not understood"),
        ("a.ply", f"element mark {10**15}\nend_header\n" + BODY, "no vertices or no faces"),
    ],
)  # fmt: skip
def test_numbers_without_bounds_are_refused_where_they_are_read(
    tmp_path, name, text, words, reader
):
    path = tmp_path / name
    head = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    path.write_text((head + "property float z\n" if name == "a.ply" else "") + text)
    with pytest.raises(InputError, match=words) as caught:
        reader(path)
    assert "\n" not in str(caught.value)
