"""The whole way from a surface to files as one call of the macro API."""

from __future__ import annotations

import json

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.fabrication import FILES
from solver import InputError, NetOptions, QuadMesh, write_mesh
from solver.analysis import measures
from tests.design_surfaces import HIP, saddle, sheet
from tests.test_build_command_line import NETS

SIZES = {"panel_thickness": 8}


@pytest.fixture(scope="module")
def surface(tmp_path_factory):
    u, v = np.meshgrid(np.linspace(0, 1, 31), np.linspace(0, 1, 21), indexing="ij")
    points = np.stack(saddle(u, v), axis=-1).reshape(-1, 3)
    k = np.arange(31 * 21).reshape(31, 21)
    faces = np.stack([k[:-1, :-1], k[1:, :-1], k[1:, 1:], k[:-1, 1:]], axis=-1).reshape(-1, 4)
    path = tmp_path_factory.mktemp("surface") / "saddle.obj"
    write_mesh(path, QuadMesh(points, faces), "m")
    return path


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("building") / "out"


@pytest.fixture(scope="module")
def first(surface, folder):
    begun = []
    built = api.build_surface(surface, folder, "panels", edge=3.0, progress=begun.append, **SIZES)
    return built, begun


def test_every_stage_is_made_and_told(first, folder):
    built, begun = first
    assert begun == ["align", "optimise", "fabricate"]
    assert {path.name for path in folder.iterdir()} == {*NETS, *FILES}
    assert built.exact and built.parts
    assert all(finding.met for finding in built.form)
    assert built.net.unit == "m"
    assert measures.planarity(built.net.mesh).max() < 1e-10
    assert measures.planarity(built.aligned.mesh).max() > 1e-6
    assert len(built.net.border) == 1
    stages = built.report["build"]["stages"]
    assert list(stages) == ["align", "optimise", "fabricate"]
    assert stages["align"]["settings"] == {"edge": 3.0}
    assert stages["fabricate"]["settings"] == {"system": "panels", "panel_thickness": 8}
    assert all(stage["seconds"] > 0 for stage in stages.values())
    assert built.report["counts"]["panels"] > 50
    assert json.loads((folder / "report.json").read_text()) == built.report
    page = (folder / "report.html").read_text()
    assert "The way to it" in page
    assert "edge 3.0" in page


def test_what_is_there_is_not_made_again(first, surface, folder):
    begun = []
    call = {"edge": 3.0, "progress": begun.append, **SIZES}
    again = api.build_surface(surface, folder, "panels", **call)
    assert begun == []
    assert again.report == first[0].report
    api.build_surface(surface, folder, "panels", gap=12, **call)
    assert begun == ["fabricate"]


def test_a_net_whose_form_does_not_hold_is_not_built(surface, tmp_path):
    call = {"edge": 3.0, "within": 1e-3, **SIZES}
    built = api.build_surface(surface, tmp_path, "panels", **call)
    assert built.exact and not built.parts
    assert [finding.measure for finding in built.form if not finding.met] == ["off the surface"]
    assert {path.name for path in tmp_path.iterdir()} == {*NETS, "report.json"}
    begun = []
    call |= {"go_on": True, "progress": begun.append}
    assert api.build_surface(surface, tmp_path, "panels", **call).parts
    assert begun == ["fabricate"]


def test_a_roof_that_loses_its_eaves_is_not_built_and_a_planar_one_keeps_them(tmp_path):
    points, triangles = sheet(HIP)
    roof = tmp_path / "hip.obj"
    rows = [("v", *point) for point in points] + [("f", *(1 + face)) for face in triangles]
    roof.write_text("".join(" ".join(map(str, row)) + "\n" for row in rows))
    call = {"unit": "m", "edge": 2.5, **SIZES}
    built = api.build_surface(roof, tmp_path / "principal", "panels", **call)
    assert built.exact and not built.parts
    failed = {finding.measure: finding for finding in built.form if not finding.met}
    assert "planar" in failed["off the border"].remedy
    built = api.build_surface(roof, tmp_path / "planar", "panels", net="planar", **call)
    assert built.parts and all(finding.met for finding in built.form)
    assert np.array_equal(built.net.mesh.vertices, built.aligned.mesh.vertices)


def test_options_of_the_net_reach_it(surface, tmp_path):
    flat = NetOptions(flatness=0.02)
    built = api.build_surface(
        surface, tmp_path, "panels", net="planar", edge=3.0, options=flat, go_on=True, **SIZES
    )
    told = built.report["build"]["stages"]["optimise"]["settings"]
    assert told["net"] == "planar"
    assert told["options"]["flatness"] == 0.02


@pytest.mark.parametrize(
    ("more", "words"),
    [
        ({"net": "geodesic"}, "a surface has no lines for geodesic nets"),
        ({"edge": 500.0}, "leaves room for"),
        ({"wide": 3}, "wide"),
        ({"border": "cut"}, "border: expected trim or follow"),
    ],
)
def test_what_cannot_be_is_said_before_anything_is_there(surface, tmp_path, more, words):
    with pytest.raises(InputError, match=words):
        api.build_surface(surface, tmp_path / "out", "panels", **{"edge": 3.0, **SIZES, **more})
    assert not (tmp_path / "out").exists()
