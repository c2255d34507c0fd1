"""Bad and odd meshes: refused in one line, or mended and said."""

from __future__ import annotations

import os

import numpy as np
import pytest

from solver.errors import InputError, OutputError
from solver.io.atomic import staged_folder, write_text
from solver.io.obj import read_obj, write_obj
from solver.mesh.intake import quad_mesh, refuse_missing_vertices
from tests.conftest import grid_faces, wavy_grid


def flat_grid(rows=3, columns=3):
    points = np.array([[i, j, 0.0] for i in range(rows) for j in range(columns)])
    return points, grid_faces(rows, columns).tolist()


def test_reversed_faces_are_turned_and_said():
    points, faces = flat_grid(4, 4)
    original = [list(face) for face in faces]
    faces[2] = faces[2][::-1]
    faces[5] = faces[5][::-1]
    mesh, remarks = quad_mesh(points, faces)
    assert "2 faces were oriented against their neighbours (first: face 2)" in remarks[0]
    assert (mesh.face_normals[:, 2] == mesh.face_normals[0, 2]).all()
    for face in (0, 1, 3, 4):
        assert mesh.faces[face].tolist() == original[face]


@pytest.mark.parametrize("corner", [9, -1])
def test_a_face_with_a_number_beyond_the_last_vertex_is_named_with_its_line(corner):
    with pytest.raises(InputError, match=rf"face 1 \(line 12\) names vertex {corner}, .* 0 to 8;"):
        refuse_missing_vertices([[0, 1, 4, 8], [1, 2, corner, 4]], 9, [11, 12])
    # Triangles and larger faces are looked at as well, before they are made quads.
    with pytest.raises(InputError, match=rf"names vertex {corner}"):
        refuse_missing_vertices([[0, 1, corner]], 9)


def test_one_vertex_and_one_face_are_said_in_the_singular():
    points = np.array([[x, y, 0.0] for y in range(2) for x in range(4)] + [[9.0, 9.0, 9.0]])
    _, remarks = quad_mesh(points, [[0, 1, 5, 4], [1, 2, 6, 5], [2, 6, 7, 3]])
    assert remarks == [
        "face 2 was oriented against its neighbours; reversed",
        "vertex 8 belongs to no face; kept where it is",
    ]


def test_components_and_loose_vertices_are_kept_and_said():
    points, faces = flat_grid()
    more = np.vstack([points, points + [10, 0, 0], [[99.0, 0, 0]]])
    mesh, remarks = quad_mesh(more, faces + [[v + 9 for v in face] for face in faces])
    assert "vertex 18 belongs to no face; kept where it is" in remarks
    assert any("2 separate components" in remark for remark in remarks)
    assert (mesh.vertices == more).all()


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda p, f: (p, []), "expected at least one, got none"),
        (lambda p, f: (p[:0], f[:0]), "expected at least one, got none"),
        (lambda p, f: (p, [*f, [0, 1, 4]]), "1 triangle among 5; face 4 has 3"),
        (lambda p, f: (p, [*f, [0, 1, 2, 5, 4]]), "1 face with more than 4 corners"),
        (lambda p, f: (p, [*f, [0, 1, 2, 77]]), "numbered 0 to 8"),
        (
            lambda p, f: (p, [*f, [0, 1, 1, 2]]),
            "1 triangle among 5; face 4 has 3, one of them named",
        ),
        (lambda p, f: (np.where(p == 2, np.nan, p), f), "NaN or infinite"),
        (lambda p, f: (p @ [[1, 0, 0], [0.3, 0, 0], [0, 0, 1]], f), "no area, the first is face 0"),
        (lambda p, f: (p * [1, 0, 1], f), "have no length, the first is edge 0 - 1"),
        (lambda p, f: (p, [*f, [0, 1, 2, 10**20]]), "far too large number"),
        (lambda p, f: (p * 1e200, f), "beyond 1e\\+100"),
        (lambda p, f: (p, [*f, [0, 1, 4, 4]]), "face 4 has 3, one of them named twice; make quads"),
        (lambda p, f: (p, [*f, [0, 0, 4, 4]]), "fewer than 3 corners among 5; face 4 has 2"),
        (lambda p, f: (p, [*f, [0, 1, 0, 4]]), "repeat a vertex, the first is face 4"),
        (lambda p, f: (p, [*f, [0, 1, 2, -1]]), "face 4 names vertex -1, but vertices are"),
        (lambda p, f: (p, [*f, [0, 1, 2, -(10**20)]]), "far too large number"),
        (lambda p, f: (p, [*f, [0, 4, 1, 3]]), "more than two faces"),
        (lambda p, f: (np.vstack([p, p + 0.7]), [*f, [1, 4, 13, 10]]), "more than two faces"),
    ],
)
def test_unusable_meshes_are_refused_in_one_line(change, words):
    points, faces = change(*flat_grid())
    with pytest.raises(InputError, match=words) as caught:
        quad_mesh(points, faces)
    assert "\n" not in str(caught.value)


def test_moebius_band_is_refused():
    count = 7
    points = []
    for k in range(count):
        angle = 2 * np.pi * k / count
        for side in (-0.3, 0.3):
            out = 1 + side * np.cos(angle / 2)
            points.append([out * np.cos(angle), out * np.sin(angle), side * np.sin(angle / 2)])
    faces = [[2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1] for k in range(count - 1)]
    faces.append([2 * count - 2, 1, 0, 2 * count - 1])
    with pytest.raises(InputError, match="cannot be oriented: it closes with a twist between"):
        quad_mesh(np.array(points), faces)


def test_face_with_crossed_corners_is_named():
    points, faces = flat_grid(6, 7)
    a, b, c, d = faces[13]
    for crossed in ([a, c, b, d], [a, b, d, c], [b, a, c, d]):
        with pytest.raises(InputError, match="face 13 has its corners in crossed order") as caught:
            quad_mesh(points, [*faces[:13], crossed, *faces[14:]])
        order = [int(word) for word in str(caught.value).split(": ")[-1].split()]
        mended, _ = quad_mesh(points, [*faces[:13], order, *faces[14:]])
        assert mended.connectivity.boundary_edges.sum() == 22
    crossed = [*faces[:13], [a, c, b, d], *faces[14:20], faces[20][:2] + faces[20][:1:-1]]
    with pytest.raises(InputError, match=r"face 13 \(and 1 more\)"):
        quad_mesh(points, [*crossed, *faces[21:]])


def test_obj_round_trip_keeps_every_bit(tmp_path):
    mesh = wavy_grid(5, 6).scaled(1 / 3)
    path = tmp_path / "mesh.obj"
    write_obj(path, mesh, "ft")
    data = read_obj(path)
    assert (data.vertices == mesh.vertices).all()
    assert data.polygons == mesh.faces.tolist()
    assert data.unit == "ft"


def test_obj_dialects(tmp_path):
    path = tmp_path / "dialect.obj"
    path.write_text(
        "# exported\nmtllib x.mtl\no thing\nv 0 0 0 1.0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
        "vt 0 0\nvn 0 0 1\ng a\nusemtl b\ns off\nf 1/1/1 2//1 3/1 \\\n 4\nf -4 -3 -2 -1\n"
    )
    data = read_obj(path)
    assert data.polygons == [[0, 1, 2, 3], [0, 1, 2, 3]]
    assert data.unit is None


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "no vertex lines"),
        ("solid stl\nfacet\n", "no vertex lines"),
        ("v 0 0 0\nv 1 0 0\n", "no faces"),
        ("v 0 0\n", "line 1: expected 'v x y z'"),
        ("v 0 zero 0\n", "line 1: expected 'v x y z'"),
        ("v 0 0 0\nf 1 2 x 3\n", "line 2: 'x' is not a vertex number"),
        ("v 0 0 0\nf 0 1 2 3\n", "line 2: '0' is not a vertex number"),
    ],
)
def test_broken_obj_files_are_refused_in_one_line(tmp_path, text, words):
    path = tmp_path / "broken.obj"
    path.write_text(text)
    with pytest.raises(InputError, match=words) as caught:
        read_obj(path)
    assert "\n" not in str(caught.value)


def test_missing_file_is_named(tmp_path):
    with pytest.raises(InputError, match="no such file"):
        read_obj(tmp_path / "absent.obj")


def test_a_failed_write_leaves_the_old_file_and_nothing_else(tmp_path):
    target = tmp_path / "mesh.obj"
    target.write_text("old")
    with pytest.raises(UnicodeEncodeError):
        write_text(target, "half \ud800")
    assert target.read_text() == "old"
    with pytest.raises(OutputError, match="cannot be written"):
        write_text(tmp_path / "absent" / "mesh.obj", "text")
    assert list(tmp_path.iterdir()) == [target]


def test_a_file_that_is_written_anew_keeps_its_permissions(tmp_path):
    target = tmp_path / "mesh.obj"
    target.write_text("old")
    target.chmod(0o640)
    write_text(target, "new")
    assert target.read_text() == "new"
    assert target.stat().st_mode & 0o777 == 0o640


def test_a_failed_batch_of_files_changes_nothing(tmp_path):
    (tmp_path / "a.txt").write_text("old")
    with pytest.raises(ZeroDivisionError), staged_folder(tmp_path) as staging:
        (staging / "a.txt").write_text("new")
        raise ZeroDivisionError
    assert [path.name for path in tmp_path.iterdir()] == ["a.txt"]
    assert (tmp_path / "a.txt").read_text() == "old"


def test_a_byte_order_mark_does_not_eat_the_first_vertex(tmp_path):
    path = tmp_path / "marked.obj"
    path.write_bytes(b"\xef\xbb\xbfv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")
    assert len(read_obj(path).vertices) == 4


def test_a_link_keeps_its_target_and_a_device_is_refused(tmp_path):
    real, link = tmp_path / "real.txt", tmp_path / "link.txt"
    real.write_text("old")
    link.symlink_to(real)
    write_text(link, "new")
    assert link.is_symlink()
    assert real.read_text() == "new"
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    with pytest.raises(OutputError, match="not an ordinary file"):
        write_text(pipe, "text")


def test_files_that_moved_before_a_failure_are_put_back(tmp_path):
    (tmp_path / "a.txt").write_text("old")
    (tmp_path / "b.txt").mkdir()
    with pytest.raises(OutputError), staged_folder(tmp_path) as staging:
        (staging / "a.txt").write_text("new")
        (staging / "b.txt").write_text("new")
        (staging / "b.txt.before").mkdir()
        (staging / "b.txt.before" / "in the way").write_text("x")
    assert (tmp_path / "a.txt").read_text() == "old"
    assert (tmp_path / "b.txt").is_dir()


def test_loose_quads_are_told_of_weld():
    points, faces = flat_grid(4, 5)
    corners = points[np.array(faces)].reshape(-1, 3)
    loose = np.arange(len(corners)).reshape(-1, 4).tolist()
    components, remark = quad_mesh(corners, loose)[1]
    assert components == "12 separate components; each is treated on its own"
    # All but the four corners of the grid are there more than once.
    assert remark.startswith(f"{len(corners) - 4} border vertices lie where another does")
    assert "'weld --tolerance 2e-09'" in remark
    apart = quad_mesh(np.vstack([points, points + 9]), faces + (np.array(faces) + 20).tolist())[1]
    assert len(apart) == 1 and "weld" not in apart[0]


def test_doubled_faces_are_left_out_and_said():
    points, faces = flat_grid(4, 4)
    mesh, remarks = quad_mesh(points, [*faces, faces[3][::-1], faces[5][2:] + faces[5][:2]])
    assert mesh.faces.tolist() == faces
    assert remarks == [
        "2 faces have the corners of another (first: face 9); left out, the others are numbered "
        "without them"
    ]
    _, remarks = quad_mesh(points, [faces[0], *faces])
    assert remarks[0].startswith("face 1 has the corners of another")


def test_a_quad_written_with_five_corners_is_read_and_said():
    points, faces = flat_grid()
    mesh, remarks = quad_mesh(points, [[face[0], *face] for face in faces[:2]] + faces[2:])
    assert mesh.faces.tolist() == faces
    assert remarks == ["2 faces name a corner twice in a row (first: face 0); read as quads"]


@pytest.mark.parametrize(
    ("line", "unit"),
    [
        ("# unit: m", "m"),
        ("# Units: inches", "in"),
        ("#UNITS = Millimeters", "mm"),
        ("# File units = feet", "ft"),
        ("# unit: yard", "yard"),
        ("# united: m", None),
        ("# unit:", None),
    ],
)
def test_units_in_every_spelling(tmp_path, line, unit):
    path = tmp_path / "mesh.obj"
    path.write_text(f"# made\n{line}\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 \\\n4\nf 1 2 3\n")
    data = read_obj(path)
    assert (data.unit, data.unit_line) == (unit, 2 if unit else 0)
    assert list(data.lines) == [7, 9]
