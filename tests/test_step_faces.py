"""Nets on faces of STEP files, from files that cadquery has written."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.__main__ import main
from freecad_ortho.triangles import read_triangles
from solver import InputError
from solver.analysis import measures

cadquery = pytest.importorskip("cadquery")


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """Paths of STEP files by name."""
    folder = tmp_path_factory.mktemp("step")
    plane = cadquery.Workplane
    shapes = {
        "box": plane().box(4000, 3000, 2000),
        "tube": plane().circle(1000).extrude(3000),
        "drilled": plane().circle(1000).extrude(4000)
        - plane("YZ", origin=(-2000, 0, 2000)).circle(400).extrude(4000),
        "ball": plane().sphere(1000),
    }
    ball = (
        plane().sphere(12000).intersect(plane().box(30000, 30000, 16000).translate((0, 0, 16000)))
    )
    shapes["dome"] = plane(next(x for x in ball.val().Faces() if x.geomType() == "SPHERE"))
    for name, shape in shapes.items():
        cadquery.exporters.export(shape, str(folder / f"{name}.step"))
    return {name: str(folder / f"{name}.step") for name in shapes}


def test_a_box_is_closed_and_looks_outward(files):
    net = api.net_from_step(files["box"], edge=500.0)
    mesh = net.mesh
    assert net.remarks == ()
    assert len(mesh.faces) == 2 * (8 * 6 + 8 * 4 + 6 * 4)
    assert not mesh.connectivity.boundary_vertices.any()
    outward = np.einsum("fi,fi->f", mesh.face_normals, mesh.vertices[mesh.faces].mean(axis=1))
    assert (outward > 0).all()


def test_a_hole_across_the_seam_is_met(files):
    # The mantle is the largest face.
    surfaces = range(1, 4)
    nets = [api.net_from_step(files["drilled"], [k], edge=200.0).mesh for k in surfaces]
    mesh = max(nets, key=lambda net: len(net.faces))
    np.testing.assert_allclose(np.hypot(*mesh.vertices[:, :2].T), 1000, atol=0.5)
    rim = mesh.vertices[mesh.connectivity.boundary_vertices]
    hole = rim[(rim[:, 2] > 500) & (rim[:, 2] < 3500)]
    np.testing.assert_allclose(np.hypot(hole[:, 1], hole[:, 2] - 2000), 400, atol=0.5)
    assert not measures.flipped(mesh).any()


def test_command_line(files, tmp_path, capsys):
    out = str(tmp_path / "net.obj")
    code = main(["faces", files["tube"], "--faces", "1", "--sampling", "16x5", "-o", out])
    assert code == 0
    mesh = api.read_mesh(out).mesh
    assert len(mesh.faces) == 64
    np.testing.assert_allclose(np.hypot(*mesh.vertices[:, :2].T), 1000, rtol=1e-9)
    command = ["faces", files["tube"], "--faces", "1", "--edge", "0.5", "--unit", "m", "-o", out]
    assert main(command) == 0
    loaded = api.read_mesh(out)
    assert loaded.unit == "m"
    assert loaded.mesh.mean_edge == pytest.approx(0.5, rel=0.05)
    capsys.readouterr()
    assert main(["faces", files["ball"], "--sampling", "9x9", "-o", out]) == 2
    assert "face 1: its side v = -1.571 shrinks to a point" in capsys.readouterr().err
    part = ["faces", files["ball"], "--sampling", "16x9", "--v-part", "0.1,0.9", "-o", out]
    assert main(part) == 0


def test_a_dome_that_is_one_face_round_its_crown_becomes_a_net(files, tmp_path, capsys):
    start, net = str(tmp_path / "start.json"), str(tmp_path / "net.json")
    assert main(["align", files["dome"], "--unit", "m", "--edge", "2", "-o", start]) == 0
    assert "4 irregular vertices" in capsys.readouterr().out
    assert (
        main(["optimise", start, "--close-to", files["dome"], "--within", "150mm", "-o", net]) == 0
    )


def test_bad_files_and_faces_get_one_line(files, tmp_path):
    bad = tmp_path / "bad.step"
    bad.write_text("ISO-10303-21; nothing")
    for path, faces, words in (
        ("missing.step", [], "no such file"),
        (bad, [], "STEP|no faces"),
        (files["box"], [7], "faces 1 to 6, not 7"),
    ):
        with pytest.raises(InputError, match=words) as caught:
            api.net_from_step(path, faces, counts=(5, 5))
        assert "\n" not in str(caught.value)


def test_faces_are_triangles_to_stay_near(files):
    points, triangles, unit = read_triangles(files["tube"])
    assert unit == "mm"
    areas = np.linalg.norm(
        np.cross(*(points[triangles[:, k]] - points[triangles[:, 0]] for k in (1, 2))), axis=1
    )
    # Both ends are faces, too.
    assert areas.sum() / 2 == pytest.approx(2 * np.pi * 1000 * (3000 + 1000), rel=1e-3)
    assert np.hypot(points[:, 0], points[:, 1]).max() == pytest.approx(1000, abs=0.01)
    turned, _, _ = read_triangles(files["tube"], up="y")
    np.testing.assert_allclose(turned[:, 2], points[:, 1])
