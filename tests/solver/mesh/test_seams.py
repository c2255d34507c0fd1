"""What meets without being joined is found, said with its remedy, and welded without harm."""

from __future__ import annotations

import json
import re

import numpy as np
import pytest

from freecad_ortho import api, fabrication
from freecad_ortho.__main__ import main
from solver import QuadMesh, optimise
from solver.mesh.mirror import mirrored, welded
from solver.mesh.seams import seams
from tests.conftest import grid_faces, shared_input, wavy_grid


def tube(noise: float = 0.0, around: int = 16, along: int = 5) -> QuadMesh:
    """A twisted cone cut open along a line: one component whose border meets itself."""
    turn, height = np.meshgrid(
        np.linspace(0, 2 * np.pi, around + 1), np.arange(along), indexing="ij"
    )
    radius = 3 + 0.4 * np.sin(turn + height) - 0.2 * height
    points = np.stack(
        [radius * np.cos(turn + 0.1 * height), radius * np.sin(turn + 0.1 * height), height], axis=2
    ).reshape(-1, 3)
    points[-along:] = points[:along] + noise * np.random.default_rng(0).normal(size=(along, 3))
    return QuadMesh(points, grid_faces(around + 1, along))


def stepped(noise: float = 0.0) -> QuadMesh:
    """Two patches side by side, the second of half the mesh size: every other vertex faces none."""
    coarse, fine = wavy_grid(4, 4, height=0.0), wavy_grid(7, 7, height=0.0)
    beside = 0.5 * fine.vertices + coarse.vertices[12]
    beside += noise * np.random.default_rng(1).normal(size=beside.shape)
    points = np.concatenate([coarse.vertices, beside])
    return QuadMesh(points, np.concatenate([coarse.faces, fine.faces + 16]))


def tolerance_in(remark: str) -> float:
    return float(re.search(r"'weld --tolerance (\S+)'", remark)[1])


@pytest.mark.parametrize("noise", [0.0, 1e-9, 3e-5])
def test_an_open_seam_is_found_and_the_remedy_closes_it(noise):
    mesh = tube(noise)
    found = seams(mesh)
    assert found.pairs.tolist() == [[k, 80 + k] for k in range(5)]
    assert len(found.junctions) == len(found.doubles) == 0
    (remark,) = found.remarks()
    assert remark.startswith("10 border vertices lie where another does without being joined")
    whole = welded([mesh], tolerance_in(remark))
    assert len(whole.vertices) == 80
    assert seams(whole).remarks() == []
    assert len(whole.connectivity.boundary_loops) == 2
    assert len(welded([mesh]).vertices) == 80


def test_what_is_further_apart_is_no_seam():
    assert seams(tube(1e-2)).remarks() == []
    assert len(welded([tube(1e-2)]).vertices) == 85
    assert seams(wavy_grid(9, 8)).remarks() == []


@pytest.mark.parametrize("noise", [0.0, 1e-6])
def test_vertices_on_another_edge_are_found(noise):
    mesh = stepped(noise)
    found = seams(mesh)
    assert found.pairs.tolist() == [[12, 16], [13, 18], [14, 20], [15, 22]]
    assert found.junctions.tolist() == [[17, 12, 13], [19, 13, 14], [21, 14, 15]]
    seam, junction = found.remarks()
    assert "first: 12 and 16" in seam
    assert junction.startswith("3 border vertices lie on the edge of a face")
    assert "first: 17 on edge 12 - 13" in junction and "'subdivide'" in junction
    left = welded([mesh])
    assert len(left.vertices) == len(mesh.vertices) - 4
    assert [remark[:17] for remark in seams(left).remarks()] == ["3 border vertices"]


def test_doubles_are_told_from_seams_and_welded_away():
    mesh = tube()
    twice = QuadMesh(
        np.concatenate([mesh.vertices, mesh.vertices]),
        np.concatenate([mesh.faces, mesh.faces[:20] + 85]),
    )
    (remark,) = seams(twice).remarks()
    assert remark.startswith("20 faces lie on another (first: faces 0 and 64)")
    assert len(welded([twice]).faces) == 64


def test_a_fine_edge_is_never_welded_away():
    mesh = wavy_grid(6, 6)
    points = mesh.vertices.copy()
    points[7] = points[8] + 1e-7
    short = mesh.with_vertices(points)
    assert seams(short).remarks() == []
    assert welded([short], tolerance=0.05).faces.tolist() == mesh.faces.tolist()
    both = mirrored(wavy_grid(4, 4, shear=0.0, height=0.0), (1, 0, 0))
    assert len(welded([both], tolerance=0.09).faces) == len(both.faces)


@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e6])
@pytest.mark.parametrize("shift", [0.0, 1e3])
def test_size_and_place_do_not_matter(scale, shift):
    mesh = stepped(1e-6)
    moved = mesh.with_vertices(scale * (mesh.vertices + shift))
    assert seams(moved).pairs.tolist() == seams(mesh).pairs.tolist()
    assert seams(moved).junctions.tolist() == seams(mesh).junctions.tolist()


def test_a_result_says_that_its_seam_came_apart():
    report = optimise(tube(), "orthogonal").report
    seam, opened = report.as_dict()["remarks"]
    assert seam.startswith("10 border vertices")
    assert re.search(r"came apart by up to \d\.\d+ mean edges", opened)
    assert optimise(welded([tube()]), "orthogonal").report.remarks == []


def test_how_far_a_seam_came_apart_is_measured_at_pairs_and_on_edges():
    mesh = stepped()
    found = seams(mesh)
    assert len(found.pairs) and len(found.junctions)
    assert found.opened(mesh, mesh) == pytest.approx(0, abs=1e-12)
    for vertex, share in ((found.junctions[-1, 0], 0.1), (found.pairs[-1, 1], 0.3)):
        points = mesh.vertices + [5.0, -3.0, 2.0]
        points[vertex, 2] += share * mesh.mean_edge
        assert found.opened(mesh, mesh.with_vertices(points)) == pytest.approx(share)


def test_every_command_says_it_and_reports_keep_it(tmp_path, capsys):
    path, net = tmp_path / "tube.obj", tmp_path / "net.obj"
    api.write_mesh(path, tube(1e-9).scaled(1000.0), "mm")
    words = "10 border vertices lie where another does"
    assert main(["check", str(path), "--json"]) == 0
    said = capsys.readouterr()
    assert words in said.err and words in json.loads(said.out)["remarks"][0]
    report = tmp_path / "r.json"
    options = ["--net", "orthogonal", "-o", str(net), "--report", str(report)]
    assert main(["optimise", str(path), *options]) == 0
    said = capsys.readouterr()
    assert said.err.count(words) == 1 and "came apart by up to" in said.out
    assert words in json.loads(report.read_text())["remarks"][0]
    structure = fabrication.build(tube().scaled(1000.0), fabrication.systems_of("beams", {}))
    assert words in structure.report()["messages"][0]
    assert main(["weld", str(path), "-o", str(net)]) == 0
    assert "80 vertices, 64 quads; 5 vertices merged" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("name", "count", "left"), [("twisted_tube_seam", 14, 112), ("unwelded_mm_noise", 116, 42)]
)
def test_files_that_came_apart(name, count, left, tmp_path):
    loaded = api.read_mesh(shared_input(f"{name}.obj"), "mm")
    remark = next(remark for remark in loaded.remarks if "without being joined" in remark)
    assert remark.startswith(f"{count} border vertices")
    for tolerance in (1e-5, tolerance_in(remark)):
        whole = welded([loaded.mesh], tolerance)
        assert len(whole.vertices) == left
        assert seams(whole).remarks() == []
        assert whole.connectivity.components.max() == 0
