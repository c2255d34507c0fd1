"""Files in other orientations and of other libraries: turned upright, read through the library."""

from __future__ import annotations

import sys

import numpy as np
import pytest

from freecad_ortho import api, file_libraries
from freecad_ortho.__main__ import main
from freecad_ortho.mesh_files import read_mesh_file
from freecad_ortho.sources import source
from freecad_ortho.triangles import read_triangles
from solver import InputError
from solver.analysis.upright import side_remark
from solver.mesh.mirror import reversed_orientation
from solver.mesh.primitives import primitive
from tests.conftest import shared_input, wavy_grid

LYING = wavy_grid(5, 4).vertices[:, [0, 2, 1]] * [1, 1, -1]


@pytest.fixture
def lying(tmp_path):
    path = tmp_path / "lying.obj"
    mesh = wavy_grid(5, 4)
    api.write_mesh(path, mesh.with_vertices(LYING), "m")
    return path


def test_y_up_files_stand_upright_everywhere(lying, tmp_path, capsys):
    upright = wavy_grid(5, 4).vertices
    assert (api.read_mesh(lying, up="y").mesh.vertices == upright).all()
    assert (read_triangles(lying, "y")[0] == upright).all()
    out = tmp_path / "out.obj"
    for command in ("convert", "weld", "orient", "formfind", "offset --distance 100"):
        assert main([*command.split(), str(lying), "--up", "y", "-o", str(out)]) == 0, command
        size = np.ptp(api.read_mesh(out).mesh.vertices, axis=0)
        assert size[2] < min(size[:2]), command
    words = ["--net", "orthogonal", "--close-to", str(lying), "--fix", "corners", "--up", "y"]
    assert main(["optimise", str(lying), *words, "-o", str(out)]) in (0, 1)
    assert np.abs(api.read_mesh(out).mesh.vertices - upright).max() < 1.0
    assert main(["check", str(lying), "--up", "y"]) == 0
    capsys.readouterr()
    with pytest.raises(InputError, match="up: expected z or y, got 'x'"):
        api.read_mesh(lying, up="x")


def test_the_file_that_lay_on_its_side():
    loaded = api.read_mesh(shared_input("yup.obj"), "m", up="y")
    assert (np.abs(loaded.mesh.face_normals[:, 2]) > 0.7).all()


def test_only_a_mesh_that_faces_sideways_lies_on_its_side():
    mesh = wavy_grid(5, 4)
    lying = mesh.with_vertices(LYING)
    down = (0.0, 0.0, -1.0)
    words = side_remark(lying, down)
    assert words is not None and "it faces y" in words and "--up y" in words
    assert side_remark(reversed_orientation(lying), down) == words
    assert side_remark(mesh, down) is None
    assert side_remark(lying, (0.0, 0.0, 0.0)) is None
    assert side_remark(lying, (0.0, -1.0, 0.0)) is None
    # A tube faces all ways.
    assert side_remark(primitive("catenoid", 12, 5), down) is None


def test_whoever_loads_a_net_on_its_side_is_told(lying, tmp_path, capsys):
    out = str(tmp_path / "out.obj")
    words = "note: the net lies on its side: it faces y"
    assert main(["formfind", str(lying), "--vertex-load", "0,0,-1", "-o", out]) == 0
    assert words in capsys.readouterr().err
    for up, said in (("z", True), ("y", False)):
        main(["optimise", str(lying), "--net", "stress", "--load", "1", "--up", up, "-o", out,
              "--max-steps", "2"])  # fmt: skip
        assert (words in capsys.readouterr().err) == said
    made = source("form-finding").make(
        {"vertex_load": (0.0, 0.0, -1.0)}, meshes=[api.read_mesh(lying).mesh]
    )
    assert "lies on its side" in made.remarks[1]


LEGACY = """# vtk DataFile Version 3.0
quads
ASCII
DATASET {kind}
POINTS 6 float
0 0 0 1 0 0 2 0 0 0 1 0 1 1 0 2 1 0
{cells} 2 10
4 0 1 4 3
4 1 2 5 4
{types}
"""


@pytest.mark.skipif("vtkmodules" not in sys.modules and not file_libraries.find_spec("vtkmodules"),
                    reason="vtk is not installed")  # fmt: skip
def test_vtk_files_are_read_and_damaged_ones_refused(tmp_path):
    path = tmp_path / "net.vtk"
    for kind, cells, types in (
        ("POLYDATA", "POLYGONS", ""),
        ("UNSTRUCTURED_GRID", "CELLS", "CELL_TYPES 2\n9\n9\n"),
    ):
        path.write_text(LEGACY.format(kind=kind, cells=cells, types=types))
        data = read_mesh_file(path)
        assert data.polygons == [[0, 1, 4, 3], [1, 2, 5, 4]]
        assert data.vertices.tolist() == [[x, y, 0] for y in (0, 1) for x in (0, 1, 2)]
    for text in ("", "solid", path.read_text().replace("9\n9", "10\n10")):
        path.write_text(text)
        with pytest.raises(InputError, match=r"net\.vtk: (cannot be read|has no)") as caught:
            api.read_mesh(path)
        assert "\n" not in str(caught.value)


def test_without_the_library_one_line_says_so(tmp_path, monkeypatch):
    path = tmp_path / "net.vtu"
    with pytest.raises(InputError, match="no such file"):
        api.read_mesh(path)
    path.write_text("")
    monkeypatch.setattr(file_libraries, "find_spec", lambda name: None)
    with pytest.raises(InputError, match="needs the package 'vtk'; install it") as caught:
        api.read_mesh(path)
    assert "\n" not in str(caught.value)


def test_a_file_of_triangles_that_was_cut_off_is_named(tmp_path):
    trimesh = pytest.importorskip("trimesh")
    whole, part = tmp_path / "whole.stl", tmp_path / "part.stl"
    trimesh.creation.icosphere(3).export(whole)
    part.write_bytes(whole.read_bytes()[:5000])
    with pytest.raises(InputError, match=r"part\.stl: (has no triangles|cannot be read)"):
        read_triangles(part)
