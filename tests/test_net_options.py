"""Options of the command ``optimise`` that say which net, what is held where, what it carries."""

from __future__ import annotations

import argparse
import json
import re

import numpy as np
import pytest

from freecad_ortho import api, written
from freecad_ortho.__main__ import main
from freecad_ortho.cli import net_options, values
from solver import QuadMesh
from solver.analysis import measures, spheres
from solver.nets import register, unregister
from solver.nets.settings import fixed_vertices
from tests.conftest import grid_faces, shared_mesh, wavy_grid
from tests.own_net import FLAT


@pytest.fixture
def wave(tmp_path):
    path = tmp_path / "wave.obj"
    api.write_mesh(path, wavy_grid(9, 8, shear=0.1))
    return path


def optimised(tmp_path, start, *arguments: str):
    out, report = tmp_path / "net.obj", tmp_path / "net.json"
    code = main(["optimise", str(start), "-o", str(out), "--report", str(report), *arguments])
    assert code == 0, json.loads(report.read_text())["message"]
    return api.read_mesh(out).mesh, json.loads(report.read_text())


def test_a_net_of_ones_own_is_offered(wave, tmp_path, capsys):
    register(FLAT)
    try:
        with pytest.raises(SystemExit):
            main(["optimise", "--help"])
        words = " ".join(capsys.readouterr().out.split())
        assert "isometric, flat (default: principal)" in words
        assert "--length L chebyshev, geodesic-chebyshev, flat: edge length" in words
        assert main(["check", str(wave)]) == 0
        shown = capsys.readouterr().out
        assert re.search(r"^flatness +\d", shown, re.M) and re.search(r"^flat +\d", shown, re.M)
        mesh, report = optimised(tmp_path, wave, "--net", "flat")
        assert report["net"] == "flat" and measures.planarity(mesh).max() <= 1e-10
    finally:
        unregister(FLAT.name)


def test_radius_of_a_cmc_net(tmp_path):
    start = tmp_path / "cmc.obj"
    api.write_mesh(start, shared_mesh("cmc1"))
    mesh, _ = optimised(tmp_path, start, "--net", "cmc", "--radius", "3.6")
    assert abs(spheres.common_radius(mesh)) == pytest.approx(3.6, rel=1e-9)


def test_length_of_a_chebyshev_net(tmp_path, wave):
    mesh, _ = optimised(tmp_path, wave, "--net", "chebyshev", "--length", "1.1")
    assert np.allclose(mesh.edge_lengths, 1.1, atol=1e-9)


def test_a_length_for_each_family(tmp_path):
    i, j = np.meshgrid(np.arange(8.0), 2.0 * np.arange(7.0), indexing="ij")
    points = np.stack([i, j + 0.05 * i, 0.4 * np.sin(0.5 * i)], axis=2).reshape(-1, 3)
    start = tmp_path / "sheet.obj"
    api.write_mesh(start, QuadMesh(points, grid_faces(8, 7)))
    mesh, _ = optimised(tmp_path, start, "--net", "chebyshev", "--per-family")
    for family in (0, 1):
        chosen = mesh.connectivity.edge_families == family
        assert measures.equal_edges(mesh, chosen).max() < 1e-10
    assert measures.chebyshev(mesh).max() > 0.2


def test_angle_of_the_medial_lines(tmp_path, wave):
    mesh, _ = optimised(tmp_path, wave, "--net", "orthogonal", "--angle", "80")
    assert measures.medial_angle(mesh, np.radians(80)).max() < 1e-9
    assert measures.orthogonality(mesh).min() > 0.05


def test_stress_net_with_area_load_and_supports(tmp_path):
    start = tmp_path / "dome.obj"
    api.write_mesh(start, shared_mesh("quad_dome"))
    mesh, report = optimised(
        tmp_path, start, "--net", "stress", "--load-area", "3", "--compression"
    )
    assert report["residuals"]["equilibrium"]["max"] <= 1e-10
    assert max(report["details"]["force_densities"]) <= 0.0
    assert len(report["details"]["force_densities"]) == len(mesh.connectivity.edges)


def test_isometric_to_a_reference_with_a_handle(tmp_path):
    angle = np.linspace(-0.6, 0.6, 9)
    i, j = np.meshgrid(angle, 0.15 * np.arange(7), indexing="ij")
    bent = np.stack([np.sin(i), j, np.cos(i)], axis=2).reshape(-1, 3)
    start = tmp_path / "sheet.obj"
    sheet = QuadMesh(bent, grid_faces(9, 7))
    api.write_mesh(start, sheet)
    x, y, z = bent[3] + [0.05, 0, -0.05]
    mesh, report = optimised(
        tmp_path,
        start,
        "--net",
        "isometric",
        "--reference",
        str(start),
        "--handle",
        f"3:{x},{y},{z}",
    )
    assert measures.isometry(mesh, sheet.vertices).max() <= 1e-10
    assert report["moved"]["max"] > 0.1


def test_gliding_on_a_curve_file_and_a_plane(tmp_path, wave):
    start = api.read_mesh(wave).mesh
    curve = tmp_path / "curve.txt"
    rim = start.vertices[:8]
    points = np.vstack([rim[0] - [0, 4, 0], rim, rim[-1] + [0, 4, 0]]) + [0, 0, 0.1]
    curve.write_text("\n".join(" ".join(map(str, point)) for point in points))
    height = start.vertices[-1, 2]
    mesh, report = optimised(
        tmp_path,
        wave,
        *("--net", "orthogonal", "--glide", f"curve:{curve}", "--glide", f"z={height}@71"),
    )
    assert report["residuals"]["glide"]["max"] <= 1e-10
    assert mesh.vertices[71, 2] == pytest.approx(height, abs=1e-9)


def test_gliding_on_a_surface_file(tmp_path, wave):
    surface = tmp_path / "surface.obj"
    api.write_mesh(surface, wavy_grid(9, 8, shear=0.1))
    _, report = optimised(tmp_path, wave, "--net", "orthogonal", "--glide", f"surface:{surface}")
    assert report["residuals"]["glide"]["max"] <= 1e-10
    assert report["moved"]["max"] > 0.01


def glides(*arguments: str):
    """Constraints that the options ask for, of a mesh in metres."""
    return settings_of(*arguments)["constraints"]


def settings_of(*arguments: str):
    """What the options say of a mesh in metres."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--net", default="principal")
    values.add_up(parser)
    net_options.add(parser)
    net_options.add_close_to(parser)
    options = parser.parse_args(arguments)
    return net_options.settings(options, api.ReadMesh(wavy_grid(3, 3), "m", ()))


@pytest.mark.parametrize(("gap", "closed"), [(0.0, True), (1e-9, True), (0.5, False)])
def test_a_curve_far_from_the_origin_closes_where_its_ends_meet(tmp_path, gap, closed):
    angle = np.linspace(0, 2 * np.pi, 9)
    curve = np.stack([5 * np.cos(angle), 5 * np.sin(angle), 0 * angle], axis=1)
    curve[-1] += [0, 0, gap]
    path = tmp_path / "b@1.txt"
    np.savetxt(path, curve + [1e6, 2e6, 0], fmt="%.12g")
    (glide,) = glides("--glide", f"curve:{path}@3,4").glide
    assert glide.closed is closed
    assert len(glide.points) == 9 - closed
    assert glide.vertices.tolist() == [3, 4]


def test_places_are_in_the_unit_that_is_named_or_that_of_the_file():
    wanted = glides("--handle", "5:1,20cm,300 mm", "--glide", "z = 1500mm@3", "--glide", "x=2@4")
    assert wanted.handles[5] == pytest.approx([1.0, 0.2, 0.3], rel=1e-15)
    assert [(one.axis, one.place, one.vertices.tolist()) for one in wanted.glide] == [
        (2, 1.5, [3]),
        (0, 2.0, [4]),
    ]


def test_loads_that_name_their_unit_are_those_of_the_mesh():
    said = ["--net", "stress", "--load", "500 N", "--load-area", "1.5kN/m2", "--load-length", "2"]
    options = settings_of(*said)["options"]
    assert options.load == pytest.approx(0.5, rel=1e-15)
    assert (options.load_area, options.load_length) == (1.5, 2.0)
    assert written.number("1.5 kN/m2", "per_area", "mm") == pytest.approx(1.5e-6, rel=1e-15)


@pytest.mark.parametrize(
    "fix", ["boundary,5", ["boundary", 5], "5, Boundary", ["none", "boundary", 5]]
)
def test_words_and_numbers_of_vertices_go_together(fix):
    mesh = wavy_grid(5, 4)
    held = np.flatnonzero(fixed_vertices(mesh, fix))
    assert held.tolist() == sorted({5, *mesh.connectivity.boundary_vertices.nonzero()[0]})


@pytest.mark.parametrize("named", ["mm", None])
def test_surfaces_count_in_the_unit_that_their_file_names(tmp_path, named):
    surface, factor = wavy_grid(4, 4), 1000.0 if named else 1.0
    path = str(tmp_path / "surface.obj")
    api.write_mesh(path, surface.scaled(factor), named)
    found = glides("--glide", f"surface:{path}", "--close-to", path)
    for points in (found.glide[0].points, found.close_to[0]):
        assert np.allclose(points, surface.vertices, rtol=1e-12)


def test_a_reference_counts_in_the_unit_that_its_file_names(tmp_path):
    sheet = wavy_grid(5, 4, shear=0.0)
    api.write_mesh(tmp_path / "start.obj", sheet, "m")
    api.write_mesh(tmp_path / "reference.obj", sheet.scaled(1000.0), "mm")
    x, y, z = sheet.vertices[0] + [0.0, 0.0, 0.2]
    mesh, _ = optimised(
        tmp_path,
        tmp_path / "start.obj",
        *("--net", "isometric", "--reference", str(tmp_path / "reference.obj")),
        *("--handle", f"0:{x},{y},{z}"),
    )
    assert measures.isometry(mesh, sheet.vertices).max() <= 1e-10


def test_the_other_variant_is_named_where_it_is_much_closer(tmp_path, capsys):
    s, t = np.meshgrid(np.linspace(-1, 1, 9), np.linspace(-1, 1, 9), indexing="ij")
    points = np.stack([s * np.cos(t), s * np.sin(t), t], axis=2).reshape(-1, 3)
    start = tmp_path / "helicoid.obj"
    api.write_mesh(start, QuadMesh(points, grid_faces(9, 9)))
    main(
        ["optimise", str(start), "--net", "asymptotic", "--diagonal", "-o", str(tmp_path / "n.obj")]
    )
    assert "try: without --diagonal" in capsys.readouterr().err
    main(["optimise", str(start), "--net", "asymptotic", "-o", str(tmp_path / "n.obj")])
    assert "diagonal" not in capsys.readouterr().err


def test_the_advisor_knows_where_asymptotic_lines_are(tmp_path, capsys):
    angles = np.linspace(-0.4, 0.4, 8)
    u, v = np.meshgrid(angles, angles, indexing="ij")
    cap = np.stack([np.cos(v) * np.cos(u), np.cos(v) * np.sin(u), np.sin(v)], axis=2)
    start = tmp_path / "cap.obj"
    api.write_mesh(start, QuadMesh(cap.reshape(-1, 3), grid_faces(8, 8)))
    main(["check", str(start), "--json"])
    advice = json.loads(capsys.readouterr().out)["advice"]
    verdicts = {(entry["net"], entry["diagonal"]): entry["possible"] for entry in advice["nets"]}
    assert not verdicts[("asymptotic", False)]
    assert not verdicts[("asymptotic", True)]
    assert verdicts[("principal", False)]
    assert verdicts[("cmc", False)]
    # On a sphere every net is principal: circles of latitude and meridians are trapezoids.
    assert advice["already"] and advice["nets"][0]["net"] in ("principal", "circular")
    assert advice["recommendation"].endswith(f"{advice['nets'][0]['net']} net already")


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--handle", "5:1,2"], "handle: expected I:x,y,z"),
        (["--handle", "5000:1,2,3"], "handle: vertex 5000 does not exist"),
        (["--glide", "ceiling"], "glide: expected boundary, z=0"),
        (
            ["--glide", "plane:z=high"],
            "glide: expected a number such as z=0 or z=1.5m, got 'plane:z=high'",
        ),
        (["--handle", "5:1,2,3 furlong"], "handle: expected I:x,y,z such as 12:0,0,3.5m, got"),
        (["--fix", "boundary,500"], "fix: vertex 500 does not exist"),
        (["--fix", "boundary,rim"], "fix: expected none, corners, boundary or vertex numbers"),
        (["--net", "stress", "--load-area", "1kN/m"], "--load-area: expected a finite number"),
        (["--glide", "boundary@3"], "glide: expected boundary, z=0"),
        (["--glide", "plane:z=0@3,,4"], "glide: expected 3 finite numbers"),
        (["--glide", "plane:z=0@3,72"], "glide: vertex 72 does not exist"),
        (["--glide", "plane:z=999"], "no free boundary vertex lies within half"),
        (["--glide", "curve:absent.txt"], "absent.txt: no such file"),
        (["--glide", "surface:absent.obj"], "absent.obj: no such file"),
        (["--glide", "surface:absent.stl"], "absent.stl: no such file"),
        (["--close-to", "absent.obj"], "absent.obj: no such file"),
        (["--symmetry", "q"], "symmetry: expected letters"),
        (["--net", "isometric", "--reference", "absent.obj"], "absent.obj: no such file"),
        (["--supports", "corners"], "--supports: only stress nets have it, not principal"),
        (["--net", "stress", "--supports-fixed", "--fix", "5"], "give one of them"),
        (["--supports-fixed"], "--supports-fixed: only stress nets have it, not principal"),
        (["--singular", "maybe"], "singular: expected exempt or include"),
        (["--within", "0"], "within: expected a number above 0"),
        (
            ["--net", "planar", "--flatness", "0"],
            "flatness: expected a number above 0, got 0.0; without it: exactly flat",
        ),
        (["--flatness", "2mm"], "--flatness: only planar nets have it, not principal"),
        (
            ["--net", "conical", "--diagonal"],
            "--diagonal: only geodesic, dog, chebyshev, geodesic-chebyshev",
        ),
        (["--radius", "3"], "--radius: only cmc nets have it"),
        (["--tension"], "--forces: only stress nets have it, not principal"),
        (["--forces", "pull"], "--forces: expected free, compression or tension, got 'pull'"),
        (["--net", "cmc", "--radius", "1 furlong"], "--radius: expected a finite number"),
        (["--net", "fishing"], "net: expected principal, planar, planar-lines"),
        (["--load-area", "3"], "--load-area: only stress nets have it"),
        (["--net", "stress", "--supports", "1,2"], "would be a mechanism"),
        (["--net", "cmc", "--radius", "-1"], "radius: expected a number above 0, got -1"),
        (["--net", "cmc", "--radius", "0.3"], "radius: 0.3 is too small for the star of vertex"),
        (["--net", "isometric", "--reference", "other.obj"], "has other vertices or faces"),
        (["--multi", "-1"], "multi: expected 0 or more, got -1"),
        (["--isometry", "-1"], "isometry: expected 0 or more, got -1"),
    ],
)
def test_bad_options_are_one_line_and_write_nothing(
    wave, tmp_path, capsys, monkeypatch, arguments, words
):
    monkeypatch.chdir(tmp_path)
    api.write_mesh("other.obj", wavy_grid(4, 4))
    assert main(["optimise", str(wave), "-o", "out.obj", *arguments]) == 2
    text = capsys.readouterr().err.strip()
    assert words in text
    assert text.splitlines()[-1].startswith("error:")
    assert not (tmp_path / "out.obj").exists()


def test_few_kinds_are_told_and_too_many_end_with_code_1(tmp_path, wave, capsys):
    told = ["--repeat", "panels", "--kinds", "20", "--alike", "0.01"]
    mesh, report = optimised(tmp_path, wave, *told)
    found, said = report["repetition"], capsys.readouterr().out
    assert found["kinds"] <= 20 and report["is_repeated"] and len(found["kind"]) == 56
    assert f"panels: {found['kinds']} kinds within 0.01 mm, {found['kinds_before']} before" in said
    assert measures.planarity(mesh).max() <= 1e-10
    out = str(tmp_path / "few.obj")
    many = ["--repeat", "edges", "--kinds", "2", "--alike", "1e-6", "--max-steps", "30"]
    assert main(["optimise", str(wave), "-o", out, *many]) == 1
    refused = capsys.readouterr().err
    assert "were the fewest that were found where 2 are allowed; try:" in refused
    assert refused.rstrip().endswith("or --net planar, which has more freedom")
    # A planar net has that freedom already.
    assert main(["optimise", str(wave), "-o", out, "--net", "planar", *many]) == 1
    assert capsys.readouterr().err.rstrip().endswith("more kinds, or a larger --within")
    for word, value in (("--kinds", "0"), ("--kinds", "57"), ("--alike", "-1")):
        assert main(["optimise", str(wave), "-o", out, "--repeat", "panels", word, value]) == 2
        refusal = capsys.readouterr().err.splitlines()[-1]
        assert refusal.startswith(f"error: {word[2:]}: expected")


def test_check_says_how_easily_a_shell_is_built(tmp_path, wave, capsys):
    assert main(["check", str(wave), "--unit", "m", "--build", "--sections", "2"]) == 0
    shown = capsys.readouterr().out
    assert re.search(r"^joints +72$", shown, re.M)
    assert re.search(r"^cross sections +2 ", shown, re.M)
    assert main(["check", str(wave), "--unit", "m", "--build", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["build"]["joints"] == 72
    assert main(["check", str(wave), "--unit", "mm", "--build"]) == 2
    assert "mind the unit of the mesh" in capsys.readouterr().err
