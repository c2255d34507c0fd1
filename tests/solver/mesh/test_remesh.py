"""Triangles to quads: with the library where it is installed, and with stand-ins that misbehave."""

from __future__ import annotations

import importlib.util
import re
import sys
import time

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.__main__ import main
from freecad_ortho.triangles import read_triangles
from solver import InputError
from solver.analysis import measures
from solver.mesh import remesh
from solver.mesh.closest import TriangleSurface
from solver.mesh.primitives import primitive
from solver.mesh.remesh import LIBRARY, quads_from_triangles
from tests.conftest import grid_faces, shared_input
from tests.meshes import rhombic_dodecahedron

STAND_IN = """
import os, time
import numpy as np

def pyquadriflow(faces, seed, vertices, triangles, sharp, boundary, *other):
    n = int(round(faces ** 0.5)) + 1
    {act}
    # A square grid over the box of the input, drawn in by 5 % and bent off the surface.
    low, high = np.min(vertices, axis=0), np.max(vertices, axis=0)
    u, v = np.meshgrid(np.linspace(0.05, 0.95, n), np.linspace(0.05, 0.95, n), indexing="ij")
    points = np.stack([low[0] + u * (high - low)[0], low[1] + v * (high - low)[1], 0.02 + 0 * u], 2)
    k = np.arange(n * n).reshape(n, n)
    quads = np.stack([k[:-1, :-1], k[1:, :-1], k[1:, 1:], k[:-1, 1:]], 2).reshape(-1, 4)
    return dict(vertices=points.reshape(-1, 3).tolist(), faces=quads.tolist())
"""


def triangles(mesh):
    quads = mesh.faces
    return mesh.vertices, np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


@pytest.fixture
def library(tmp_path, monkeypatch):
    """Put a stand-in for the library first on the path; it does what it is told."""

    def install(act: str = "pass") -> None:
        folder = tmp_path / "site" / LIBRARY
        folder.mkdir(parents=True)
        (folder / "__init__.py").write_text("")
        (folder / f"{LIBRARY}.py").write_text(STAND_IN.format(act=act))
        monkeypatch.syspath_prepend(str(tmp_path / "site"))
        for name in [name for name in sys.modules if name.startswith(LIBRARY)]:
            monkeypatch.delitem(sys.modules, name)

    return install


def test_border_corners_and_surface_are_kept(library):
    library()
    arch = primitive("translational", 25, 21)
    made = quads_from_triangles(*triangles(arch), faces=100)
    mesh = made.mesh
    assert len(mesh.faces) == 100
    assert len(made.irregular) == 0
    surface = TriangleSurface(*triangles(arch))
    assert np.linalg.norm(surface.closest(mesh.vertices)[0] - mesh.vertices, axis=1).max() < 1e-12
    corners = arch.vertices[[0, 20, 24 * 21, 25 * 21 - 1]]
    apart = np.linalg.norm(mesh.vertices[:, None] - corners[None], axis=2).min(axis=0)
    assert apart.max() < 1e-12
    rim = mesh.vertices[mesh.connectivity.boundary_vertices]
    border = arch.vertices[arch.connectivity.edges[arch.connectivity.boundary_edges]]
    count = len(border)
    lines = TriangleSurface(
        border.reshape(-1, 3), np.arange(2 * count).reshape(-1, 2)[:, [0, 1, 1]]
    )
    assert np.linalg.norm(lines.closest(rim)[0] - rim, axis=1).max() < 1e-12
    assert made.border_gap < 0.02
    assert not measures.flipped(mesh).any()
    assert measures.edge_ratio(mesh) > 0.5


@pytest.fixture
def piercing(monkeypatch):
    """A stand-in in this process: a grid, pierced where more quads than these are asked for."""

    def install(least: int) -> list[int]:
        asked = []

        def run(points, corners, faces, seed, time_limit, waiting):
            asked.append(faces)
            made: dict = {}
            exec(STAND_IN.format(act="pass"), made)
            found = made["pyquadriflow"](faces, seed, points.tolist(), corners, False, True)
            raw, quads = np.array(found["vertices"]), np.array(found["faces"])
            middle = raw[quads].mean(axis=1) - 0.5 * (points.min(axis=0) + points.max(axis=0))
            hole = 0.12 if faces > least else 0.0
            return raw, quads[np.linalg.norm(middle[:, :2], axis=1) > hole]

        monkeypatch.setattr(remesh, "_run", run)
        return asked

    return install


def pierced(count: int = 25, hole: float = 0.2, noise: float = 0.0):
    """Triangles of a square plate of side 1 with a hole in its middle, and the hole's radius."""
    places = np.linspace(0, 1, count)
    x, y = np.meshgrid(places, places, indexing="ij")
    points = np.stack([x, y, 0 * x], axis=2).reshape(-1, 3)
    quads = grid_faces(count, count)
    middle = points[quads].mean(axis=1) - [0.5, 0.5, 0.0]
    quads = quads[np.linalg.norm(middle, axis=1) > hole]
    moved = noise * np.random.default_rng(0).normal(size=points.shape)
    return points + moved, np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


@pytest.mark.parametrize("noise", [0.0, 0.002])
def test_an_opening_is_kept_by_smaller_quads(piercing, noise):
    asked = piercing(300)
    made = quads_from_triangles(*pierced(noise=noise), faces=200)
    assert asked == [200, 280, 400]
    (remark,) = made.remarks
    assert re.fullmatch(
        r"with 200 quads the opening at .*, 0.4\d+ wide, is lost; made smaller", remark
    )
    assert len(made.mesh.connectivity.boundary_loops) == 2
    assert 340 < len(made.mesh.faces) < 400
    assert made.border_gap < 0.06


@pytest.mark.parametrize(
    ("hole", "least", "words"),
    [
        (
            0.2,
            10**6,
            r"with 200 to 800 quads the opening at \(0.5, 0.5, 0\), 0.417 wide, is lost; try "
            "another seed, or close it in the triangles where it is not meant",
        ),
        (
            0.05,
            10**6,
            r"with 200 quads the opening .* wide, is lost; ask for about \d000 faces, or",
        ),
        (
            0.0,
            0,
            r"the number of borders becomes 2 instead of 1, one at \(0.5, 0.5, \S+\), 0.\d+ w",
        ),
    ],
)
def test_openings_that_cannot_be_kept_are_refused_by_name(piercing, hole, least, words):
    piercing(least)
    with pytest.raises(InputError, match=words) as caught:
        quads_from_triangles(*pierced(hole=hole), faces=200)
    assert "\n" not in str(caught.value)


def test_a_piece_or_a_closed_surface_is_not_lost(piercing):
    piercing(10**6)
    points, corners = triangles(primitive("rectangle", 9, 9))
    both = np.concatenate([points, points + [0, 0, 3]]), np.concatenate([corners, corners + 81])
    with pytest.raises(InputError, match=r"the border at \(.*\), .* wide, is lost"):
        quads_from_triangles(*both, faces=100)
    with pytest.raises(InputError, match="the number of borders becomes 1 instead of 0"):
        quads_from_triangles(*triangles(rhombic_dodecahedron()), faces=20)


def test_command_says_that_quads_are_smaller(piercing, tmp_path, capsys):
    piercing(300)
    path, out = tmp_path / "in.off", tmp_path / "out.obj"
    points, corners = pierced()
    rows = [" ".join(map(str, row)) for row in points.tolist()]
    rows += [f"3 {a} {b} {c}" for a, b, c in corners.tolist()]
    path.write_text(f"OFF {len(points)} {len(corners)} 0\n" + "\n".join(rows))
    assert main(["quads", str(path), "--faces", "200", "--unit", "m", "-o", str(out)]) == 0
    said = capsys.readouterr()
    assert said.err.startswith("note: with 200 quads the opening at (0.5, 0.5, 0), 0.417 wide")
    out.unlink()
    assert main(["quads", str(path), "--faces", "40", "--unit", "m", "-o", str(out)]) == 2
    said = capsys.readouterr().err
    assert said.startswith("error: remesh: with 40 to 160 quads the opening at")
    assert said.count("\n") == 1
    assert not out.exists()


def test_a_library_that_hangs_is_stopped(library):
    library("time.sleep(60)")
    start = time.perf_counter()
    with pytest.raises(InputError, match=r"within 1\.5 s and was stopped"):
        quads_from_triangles(*triangles(primitive("rectangle", 5, 5)), faces=16, time_limit=1.5)
    assert time.perf_counter() - start < 10


def test_who_waits_can_stop_it(library):
    library("time.sleep(60)")
    start, parts = time.perf_counter(), []

    def waiting(part):
        parts.append(part)
        if len(parts) == 5:
            raise InputError("stopped")

    with pytest.raises(InputError, match=r"^stopped$"):
        quads_from_triangles(*triangles(primitive("rectangle", 5, 5)), faces=16, waiting=waiting)
    assert time.perf_counter() - start < 10
    assert 0 < parts[0] < parts[-1] < 0.2


@pytest.mark.parametrize(
    ("act", "words"),
    [
        ("os._exit(11)", "failed"),
        ("raise Exception('no field')", "no field"),
        ("return dict(vertices=[[0, 0, 0]] * 4, faces=[[0, 1, 2, 3]])", "unusable"),
        ("return dict(vertices=[], faces=[])", "no quads"),
    ],
)
def test_a_library_that_fails_is_said_in_a_line(library, act, words):
    library(act)
    with pytest.raises(InputError, match=words) as caught:
        quads_from_triangles(*triangles(primitive("rectangle", 5, 5)), faces=16)
    assert "\n" not in str(caught.value)


def test_a_missing_library_is_said(monkeypatch, tmp_path, capsys):
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    path = tmp_path / "in.obj"
    api.write_mesh(path, primitive("rectangle", 5, 5))
    assert main(["quads", str(path), "--faces", "30", "-o", str(tmp_path / "out.obj")]) == 2
    text = capsys.readouterr().err
    assert "pip install pyQuadriFlow" in text and text.count("\n") == 1
    assert not (tmp_path / "out.obj").exists()


def test_command_reads_triangles_of_other_programs(library, tmp_path, capsys):
    library()
    trimesh = pytest.importorskip("trimesh")
    points, corners = triangles(primitive("translational", 15, 11))
    for extension in ("stl", "glb", "ply", "off"):
        path = tmp_path / f"in.{extension}"
        trimesh.Trimesh(points, corners, process=False).export(path)
        out = tmp_path / "out.obj"
        words = ["quads", str(path), "--edge", "0.3", "--unit", "m", "-o", str(out)]
        assert main(words) == 0, capsys.readouterr().err
        loaded = api.read_mesh(out)
        assert loaded.unit == "m"
        assert loaded.mesh.mean_edge == pytest.approx(0.3, rel=0.15)
        assert "0 irregular vertices" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("change", "settings", "words"),
    [
        (lambda p, t: (p, t), {}, "give one"),
        (lambda p, t: (p, t), {"faces": 10, "edge": 1.0}, "give one"),
        (lambda p, t: (p, t), {"faces": 2}, "4 to 200,000"),
        (lambda p, t: (p, t), {"edge": -1.0}, "edge"),
        (lambda p, t: (p, t), {"faces": 9, "time_limit": 0}, "time limit"),
        (lambda p, t: (p, t), {"faces": 9, "time_limit": float("inf")}, "limit: expected a finite"),
        (lambda p, t: (p, t), {"faces": 9, "time_limit": 4000}, "3,600 at most, got 4000"),
        (lambda p, t: (p, t), {"faces": 9.5}, "faces: expected a whole number, 4 to 200,000, got"),
        (lambda p, t: (p, t), {"edge": 1e-200}, "edge: expected a length .* 4 to 200,000 quads"),
        (lambda p, t: (p, t + 99), {"faces": 9}, "vertices are numbered"),
        (lambda p, t: (p, np.concatenate([t, t[:, [1, 0, 2]], t])), {"faces": 9}, "more than two"),
        (lambda p, t: (p[t].reshape(-1, 3) + 0.01 * np.arange(3 * len(t))[:, None],
                       np.arange(3 * len(t)).reshape(-1, 3)), {"faces": 9}, "soup"),
    ],
)  # fmt: skip
def test_bad_input_is_one_line(library, change, settings, words):
    library()
    with pytest.raises(InputError, match=words) as caught:
        quads_from_triangles(*change(*triangles(primitive("translational", 6, 5))), **settings)
    assert "\n" not in str(caught.value)


@pytest.mark.skipif(importlib.util.find_spec(LIBRARY) is None, reason="library not installed")
@pytest.mark.parametrize("name", ["enneper", "catenoid", "translational"])
def test_with_the_library_itself(name):
    points, corners = triangles(primitive(name, 36, 30))
    made = quads_from_triangles(points, corners, faces=300)
    assert len(made.mesh.faces) == pytest.approx(300, rel=0.4)
    assert len(made.irregular) <= 8
    assert not measures.flipped(made.mesh).any()
    assert measures.edge_ratio(made.mesh) > 0.4


@pytest.mark.slow
@pytest.mark.skipif(importlib.util.find_spec(LIBRARY) is None, reason="library not installed")
def test_the_library_keeps_a_round_opening():
    points, corners, _ = read_triangles(shared_input("plate_round_hole.obj"))
    made = quads_from_triangles(points, corners, faces=200)
    assert "the opening at (10, 10, 1.895), 6.6 wide, is lost; made smaller" in made.remarks[0]
    assert len(made.mesh.connectivity.boundary_loops) == 2
    assert made.border_gap < 0.1
    hole = min(made.mesh.connectivity.boundary_loops, key=len)
    radius = np.linalg.norm(made.mesh.vertices[hole, :2] - 10.0, axis=1)
    assert np.abs(radius - 3.3).max() < 0.05
