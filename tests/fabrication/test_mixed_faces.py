"""Panels and beams of faces with three, four, five and six corners."""

import json

import numpy as np
import pytest

from examples.mixed_faces import cut_round, honeycomb
from freecad_ortho.__main__ import main
from freecad_ortho.fabrication import Beams, Panels, build
from freecad_ortho.fabrication.systems.nodes import Nodes
from solver import optimise, write_mesh
from solver.errors import InputError
from solver.mesh.quadmesh import row_lengths

GAP, THICK = 10.0, 12.0


@pytest.fixture(scope="module")
def net():
    return optimise(cut_round(4), "planar").mesh


@pytest.fixture(scope="module")
def structure(net):
    return build(net, [Beams(200, 60), Panels(THICK, GAP)])


def test_every_face_has_a_panel_of_its_size_and_every_edge_a_beam(net, structure):
    panels = [part for part in structure.parts if part.kind == "panel"]
    beams = [part for part in structure.parts if part.kind == "beam"]
    assert len(beams) == len(net.connectivity.edges)
    assert [part.face for part in panels] == list(range(net.connectivity.face_count))
    for part, face in zip(panels, net.connectivity.polygons, strict=True):
        assert part.vertices == tuple(face)
        assert len(part.pattern.outline) == len(face)
    report = structure.report()
    assert report["beams"]["twist_max"] < 1e-10
    sizes = np.bincount(net.connectivity.face_sizes)
    assert report["panels"]["panels_by_corners"] == {
        str(size): count for size, count in enumerate(sizes.tolist()) if count
    }


def test_sides_lie_half_the_gap_within_the_face_and_joints_stay_clear(net):
    laid = build(net, [Panels(THICK, GAP, "above")])
    report = laid.report()["panels"]
    assert report["clear_gap_min_mm"] >= GAP / 2 - 1e-9
    for part, face in zip(laid.parts, net.connectivity.polygons, strict=True):
        corner = net.vertices[face]
        side = np.roll(corner, -1, axis=0) - corner
        inwards = np.cross(net.face_normals[part.face], side)
        inwards /= row_lengths(inwards)[:, None]
        lower = part.points[: len(face)]
        away = np.einsum("pck,ck->pc", lower[:, None] - corner, inwards)
        # Each corner of the plate is on two sides, half the gap or more from both.
        near = np.sort(away, axis=1)[:, :2]
        assert near.min() >= GAP / 2 - 1e-6
        if not report["sides_shrunk_more"]:
            assert near == pytest.approx(np.full(near.shape, GAP / 2), abs=1e-6)


def test_solids_are_whole_and_as_large_as_they_say(structure):
    rare = {}
    for part in structure.parts:
        if part.kind == "panel":
            rare.setdefault(len(part.vertices), part)
    assert set(rare) == {3, 4, 5}
    for part in rare.values():
        solid = part.solid()
        assert solid.isValid()
        assert solid.Volume() == pytest.approx(part.volume, rel=1e-9)


def test_hexagons_stand_clear_of_hubs():
    comb = optimise(honeycomb(3), "planar").mesh
    made = build(
        comb,
        [Beams(200, 40, ends="hub", hub_diameter=180), Nodes(diameter=180), Panels(THICK, GAP)],
    )
    report = made.report()
    assert report["counts"]["panels"] == 9 and report["counts"]["nodes"] == len(comb.vertices)
    assert report["panels"]["corners_cut"] + report["panels"]["lifted_over_hubs"] > 0
    assert report["beams"]["twist_max"] < 1e-10


@pytest.mark.parametrize(
    "asked", [{"frame": "plate"}, {"edge": "bevel"}, {"bending": "cold"}, {"fold": 60.0}]
)
def test_what_needs_quads_is_refused_in_one_line(net, asked):
    with pytest.raises(InputError, match="faces of several sizes are flat plates"):
        build(net, [Panels(THICK, GAP, **asked)])


def test_from_a_file_to_files(tmp_path, capsys):
    start, flat, folder = (tmp_path / name for name in ("start.obj", "flat.obj", "parts"))
    write_mesh(start, honeycomb(3), "mm")
    assert main(["optimise", str(start), "--net", "planar", "-o", str(flat)]) == 0
    assert main(["check", str(flat), "--json"]) == 0
    assert '"6": 9' in capsys.readouterr().out
    asked = ["--system", "beams+panels", "--write", "drawings,3dm", "-o", str(folder)]
    assert main(["fabricate", str(flat), *asked]) == 0
    report = json.loads((folder / "report.json").read_text(encoding="utf-8"))
    assert report["counts"]["panels"] == 9 and report["verdict"]["failed"] == {}
    assert main(["fabricate", str(flat), "--system", "lamellas", "-o", str(folder)]) == 2
    assert "9 of 6 corners" in capsys.readouterr().err
