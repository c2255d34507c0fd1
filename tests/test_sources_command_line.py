"""Commands that make or change meshes: real files out, one line for every mistake."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.__main__ import main
from freecad_ortho.sources import source
from solver.analysis import measures
from solver.mesh.grid import grid_of
from solver.mesh.primitives import primitive
from solver.multinet import is_multi_net, multi_net_residual
from tests.conftest import wavy_grid


@pytest.fixture
def wave(tmp_path):
    path = tmp_path / "wave.obj"
    api.write_mesh(path, wavy_grid(9, 7), "m")
    return str(path)


def call(tmp_path, *words, name="out.obj"):
    out = tmp_path / name
    assert main([*words, "-o", str(out)]) == 0
    return api.read_mesh(out)


def test_help_says_what_each_command_does(capsys):
    with pytest.raises(SystemExit):
        main(["--help"])
    # Lines break anywhere, within words with hyphens as well.
    said = "".join(capsys.readouterr().out.split())
    for command in ("checkerboard", "subdivide", "coarsen", "trim", "mirror", "inversion"):
        meaning = source(command).meaning
        words = command + meaning[0].lower() + meaning[1:]
        assert "".join(words.split()) in said


@pytest.mark.parametrize("moving", ["lambda", "mu", "nu"])
@pytest.mark.parametrize("curve", ["wave", "ring", "arch"])
def test_multinet_keeps_its_contract(tmp_path, capsys, moving, curve):
    words = ["multinet", "--axes", "9,5,2", "--moving", moving, "--curve", curve]
    mesh = call(tmp_path, *words, "--sampling", "12x9").mesh
    assert (grid_of(mesh).numbers == np.arange(108).reshape(12, 9)).all()
    assert multi_net_residual(mesh).worst < 1e-14
    assert "admissible from" in capsys.readouterr().out
    for step in (2, 3):
        part = mesh.vertices.reshape(12, 9, 3)[::step, ::step]
        spread = np.linalg.norm(part[:, :, None, None] - part[None, None], axis=4)
        assert np.abs(spread - spread.transpose(0, 3, 2, 1)).max() < 1e-12


def test_multinet_range_reflection_place_and_unit(tmp_path):
    words = ["multinet", "--axes", "9,5,2", "--moving", "mu", "--range", "-5,-2"]
    words += ["--curve", "wave", "--sampling", "8x6", "--reflect", "x,y,z", "--unit", "m"]
    plain = call(tmp_path, *words)
    moved = call(tmp_path, *words, "--rotate", "30,20,10", "--centre", "-100,0,5")
    assert plain.unit == "m"
    assert len(plain.mesh.faces) == 8 * 35
    np.testing.assert_allclose(moved.mesh.edge_lengths, plain.mesh.edge_lengths, atol=1e-12)
    np.testing.assert_allclose(moved.mesh.vertices.mean(axis=0), [-100, 0, 5], atol=1e-9)


def test_semi_axes_and_t_are_said_as_in_a_document(tmp_path):
    squares = ["--axes", "9,4,1", "--moving", "mu", "--range", "-3.5,-2", "--sampling", "6x5"]
    plain = ["--semi-axes", "3,2,1", "--moving", "mu", "--t-range", "-3.5,-2", "--sampling", "6x5"]
    in_mm = ["--semi-axes", "3000mm,2000mm,1000mm", "--moving", "mu", "--sampling", "6x5"]
    in_mm += ["--t-range", "-3500000mm2,-2000000mm2", "--unit", "m"]
    before = call(tmp_path, "multinet", *squares).mesh.vertices
    assert (call(tmp_path, "multinet", *plain).mesh.vertices == before).all()
    np.testing.assert_allclose(call(tmp_path, "multinet", *in_mm).mesh.vertices, before, atol=1e-12)
    made = source("elliptic multi-net").make(
        {
            "semi_axes": (3e3, 2e3, 1e3),
            "moving": "mu",
            "t_range": (-3.5e6, -2e6),
            "sampling": (6, 5),
        }
    )
    np.testing.assert_allclose(made.mesh.vertices / 1000, before, atol=1e-12)


def test_primitives_are_as_large_in_every_unit(tmp_path):
    words = ["primitive", "cone", "--sampling", "9x4"]
    metres = call(tmp_path, *words, "--unit", "m").mesh.vertices
    assert (call(tmp_path, *words).mesh.vertices == metres).all()
    feet = call(tmp_path, *words, "--unit", "ft", "--set", "height=1500mm").mesh.vertices
    cone = call(tmp_path, *words, "--unit", "m", "--set", "height=1.5").mesh.vertices
    np.testing.assert_allclose(0.3048 * feet, cone, atol=1e-12)


def test_names_that_options_had_before_are_understood(tmp_path, wave):
    def same(*pairs):
        one, two = (call(tmp_path, *words).mesh for words in pairs)
        return np.array_equal(one.vertices, two.vertices) and np.array_equal(one.faces, two.faces)

    assert same(("diagonal", wave, "--boundary", "fill"), ("diagonal", wave, "--border", "fill"))
    assert same(("mirror", wave, "--alone"), ("mirror", wave, "--image-only", "--normal", "1,0,0"))
    assert same(
        ("coarsen", wave, "--every", "3x2", "--drop-border"),
        ("coarsen", wave, "--every", "3x2", "--no-keep-border"),
    )
    assert same(
        ("formfind", wave, "--lift", "0,1;62,0.5", "--beam-load", "0,0,-1", "--border", "3"),
        ("formfind", wave, "--lift", "0:1; 62:0.5", "--edge-load", "0,0,-1")
        + ("--border-density", "3"),
    )
    conics = ("primitive", "confocal-conics", "--sampling", "9x5", "--set")
    assert same((*conics, "squares=9,4"), (*conics, "semi_axes=3,2"))


def test_multinet_by_formulas_values_and_points_agree(tmp_path):
    words = ["multinet", "--axes", "9,5,2", "--moving", "lambda", "--range", "0,3"]
    words += ["--spacing", "parameter", "--sampling", "6x4"]
    formulas = call(tmp_path, *words, "--curve", "-4.5+2*s; -8+2*s^2").mesh
    s = np.linspace(0, 1, 6)
    table = tmp_path / "values.csv"
    np.savetxt(table, np.stack([-4.5 + 2 * s, -8 + 2 * s**2], axis=1), delimiter=",")
    by_values = call(tmp_path, *words, "--curve", str(table)).mesh
    np.testing.assert_allclose(by_values.vertices, formulas.vertices, atol=1e-12)
    points = tmp_path / "points.txt"
    np.savetxt(points, formulas.vertices.reshape(6, 4, 3)[:, 1], fmt="%.17g")
    by_points = call(tmp_path, *words, "--curve", str(points)).mesh
    np.testing.assert_allclose(by_points.vertices, formulas.vertices, atol=1e-9)


def test_multinet_on_a_quadric_snaps_drawn_points(tmp_path):
    drawn = tmp_path / "drawn.txt"
    drawn.write_text("2.9 0.2 0.1\n2.2 1.4 0.4\n1.2 1.7 0.8\n0.3 1.5 1.1\n")
    words = ["multinet", "--axes", "9,4,2", "--quadric", "ellipsoid", "--curve", str(drawn)]
    words += ["--range", "-1,2", "--sampling", "7x5"]
    mesh = call(tmp_path, *words).mesh
    assert (call(tmp_path, *words, "--snap").mesh.vertices == mesh.vertices).all()
    assert is_multi_net(mesh, 1e-14)
    near = np.linalg.norm(mesh.vertices[:, None] - np.loadtxt(drawn)[None, :1], axis=2).min()
    assert near < 0.3


def test_fit_finds_the_multi_net_that_a_mesh_nearly_is(tmp_path, capsys):
    words = ["multinet", "--axes", "9,5,2", "--moving", "lambda", "--curve", "arch", "--unit", "m"]
    mesh = call(tmp_path, *words, "--sampling", "12x9").mesh
    noise = 1e-4 * np.random.default_rng(0).normal(size=mesh.vertices.shape)
    near = tmp_path / "near.ply"
    api.write_mesh(near, mesh.with_vertices(mesh.vertices + noise), "m")
    assert not is_multi_net(api.read_mesh(near).mesh)
    capsys.readouterr()
    found = call(tmp_path, "fit-multinet", str(near))
    said = capsys.readouterr().out
    assert "ellipsoid" in said and said.count("\n") == 1
    assert found.unit == "m"
    assert (found.mesh.faces == mesh.faces).all()
    assert is_multi_net(found.mesh, 1e-13)
    assert np.abs(found.mesh.vertices - mesh.vertices).max() < 1e-3
    fine = call(tmp_path, "fit-multinet", str(near), "--sampling", "30x20").mesh
    assert len(fine.vertices) == 600
    assert is_multi_net(fine, 1e-13)


def test_primitives_and_changes_of_meshes(tmp_path, wave, capsys):
    sphere = call(tmp_path, "primitive", "sphere", "--sampling", "12x7", "--set", "radius=3").mesh
    np.testing.assert_allclose(np.linalg.norm(sphere.vertices, axis=1), 3)
    half = call(tmp_path, "primitive", "sphere", "--sampling", "7x5", "--set", "angles=-90,90").mesh
    ball = call(tmp_path, "mirror", str(tmp_path / "out.obj"), "--normal", "x", name="ball.ply")
    assert len(ball.mesh.faces) == 2 * len(half.faces)
    assert grid_of(ball.mesh).closed_u
    assert call(tmp_path, "subdivide", wave, "--levels", "2").mesh.faces.shape == (768, 4)
    fine = call(tmp_path, "subdivide", wave, "--rule", "catmull-clark", name="fine.obj")
    assert fine.unit == "m"
    back = call(tmp_path, "coarsen", str(tmp_path / "fine.obj"), "--every", "2").mesh
    assert len(back.faces) == 48
    assert len(call(tmp_path, "coarsen", wave, "--every", "3x2").mesh.vertices) == 4 * 4
    assert len(call(tmp_path, "trim", wave, "--rows", "1,0,0,2").mesh.faces) == 7 * 4
    assert len(call(tmp_path, "trim", wave, "--rings", "1").mesh.faces) == 6 * 4
    assert len(call(tmp_path, "diagonal", wave, "--which", "second").mesh.faces) == 18
    assert len(call(tmp_path, "medial", wave).mesh.vertices) == 48
    assert len(call(tmp_path, "checkerboard", wave).mesh.faces) == 48 + 35
    assert len(call(tmp_path, "dual", wave).mesh.faces) == 48
    assert "note: dual: the net has none, its edges would miss by" in capsys.readouterr().err
    swapped = call(tmp_path, "orient", wave, "--swap", "--reverse").mesh
    assert grid_of(swapped).numbers.shape == (7, 9)


def test_transform_weld_and_convert(tmp_path, wave):
    mesh = api.read_mesh(wave).mesh
    moved = call(tmp_path, "transform", wave, "--move", "8,0,0", "--scale", "2").mesh
    np.testing.assert_allclose(moved.vertices, 2 * mesh.vertices + [8, 0, 0])
    image = call(tmp_path, "mirror", wave, "--alone", "--point", "-0.3,0,0", name="b.off").mesh
    assert image.vertices[:, 0].max() < 0
    converted = call(tmp_path, "convert", wave, name="wave.json")
    assert (converted.mesh.vertices == mesh.vertices).all()
    assert converted.unit == "m"
    barrel = tmp_path / "barrel.obj"
    api.write_mesh(barrel, primitive("catenoid", 24, 9), "m")
    bent = call(tmp_path, "moebius", str(barrel), "--centre", "0,7,0.5", name="bent.obj").mesh
    assert measures.circular(bent).max() < 1e-11
    assert np.abs(bent.vertices - primitive("catenoid", 24, 9).vertices).max() > 0.05
    # Two halves in different units and formats become one net.
    api.write_mesh(tmp_path / "left.ply", primitive("sphere", 5, 5, angles=(0, 180)), "m")
    right = primitive("sphere", 5, 5, angles=(180, 360)).scaled(1000)
    api.write_mesh(tmp_path / "right.obj", right, "mm")
    words = ["weld", str(tmp_path / "left.ply"), str(tmp_path / "right.obj")]
    joined = call(tmp_path, *words)
    assert joined.unit == "m"
    assert len(joined.mesh.vertices) == 8 * 5


def test_formfind_from_flat_to_minimal(tmp_path, capsys):
    flat = tmp_path / "flat.obj"
    assert main(["primitive", "rectangle", "--sampling", "13x13", "-o", str(flat)]) == 0
    words = ["formfind", str(flat), "--supports", "corners", "--lift", "0,0.4;168,0.4"]
    net = call(tmp_path, *words, "--border", "5").mesh
    assert np.ptp(net.vertices[:, 2]) == pytest.approx(0.4)
    words += ["--kind", "membrane", "--cable", "3"]
    film = call(tmp_path, *words).mesh
    assert film.vertices[84, 2] == pytest.approx(0.2, abs=1e-9)
    assert "in equilibrium" in capsys.readouterr().out
    hung = call(tmp_path, "formfind", str(flat), "--area-load", "0,0,-0.2").mesh
    assert -0.1 < hung.vertices[84, 2] < -0.01
    blown = tmp_path / "blown.obj"
    code = main(["formfind", str(flat), "--kind", "membrane", "--pressure", "90", "-o", str(blown)])
    assert code == 1
    assert not blown.exists()
    assert "lower the load" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        ("multinet --axes 9,5 --moving mu --sampling 4x4", "--axes: expected 3 finite numbers"),
        (
            "multinet --axes 5,9,2 --moving mu --sampling 4x4",
            "semi axes: expected three different ones, the largest first",
        ),
        (
            "multinet --axes 9,5,2 --moving rho --sampling 4x4",
            "--moving: expected lambda, mu or nu",
        ),
        ("multinet --axes 9,5,2 --moving mu --sampling 4", "--sampling: expected MxN"),
        (
            "multinet --axes 9,5,2 --moving mu --sampling 1x4",
            "sampling: expected a whole number, 2 or more",
        ),
        (
            "multinet --axes 9,5,2 --moving mu --sampling 4x4 --range -6,-3",
            "t: expected -5 <= T0 < T1 <= -2 for this",
        ),
        (
            "multinet --axes 9,5,2 --moving mu --sampling 4x4 --range -3,-4",
            "t: expected -5 <= T0 < T1 <= -2 for this",
        ),
        (
            "multinet --axes 9,5,2 --moving mu --sampling 4x4 --curve nowhere.txt",
            "--curve: 'nowhere.txt' is neither a file nor",
        ),
        (
            "multinet --axes 9,5,2 --moving mu --sampling 4x4 --curve __import__('os');s",
            "formula: '__import__' in '__import__('os')'",
        ),
        (
            "multinet --axes 9,5,2 --moving mu --sampling 4x4 --curve 1/(s-0.5);-7",
            "formula: '1/(s-0.5)' is not a finite number",
        ),
        (
            "multinet --axes 9,5,2 --moving mu --sampling 4x4 --reflect w",
            "reflect: expected some of x, y, z, each once",
        ),
        (
            "multinet --axes 9,5,2 --quadric cube --sampling 4x4",
            "--quadric: expected ellipsoid, one-sheeted",
        ),
        (
            "multinet --axes 9,5,2 --quadric ellipsoid --sampling 4x4 --curve wave",
            "--curve: expected a file of points on the",
        ),
        ("multinet --axes 9,5,2 --sampling 4x4", "one of the arguments --moving --quadric is"),
        ("primitive cube --sampling 4x4", "NAME: expected catenoid, cone"),
        ("primitive sphere --sampling 4x4 --set radius", "--set: expected PARAMETER=VALUE"),
        (
            "primitive sphere --sampling 4x4 --set radius=x",
            "--set radius: expected a finite number",
        ),
        ("primitive sphere --sampling 99999999x4", "--sampling: expected MxN"),
        ("primitive sphere --sampling 4x4 --set girth=2", "sphere: has sampling, radius, angles"),
        (
            "primitive sphere --sampling 4x4 --set placement=2",
            "--set placement: is said by --centre",
        ),
        ("primitive rotational --sampling 4x4 --set profile=nowhere.txt", "nowhere.txt: no such"),
        (
            "multinet --axes 9,5,2 --quadric ellipsoid --first-formula s",
            "--first-formula: the multi",
        ),
        ("multinet --semi-axes 9,5m --moving mu", "--semi-axes: expected 3 finite numbers"),
        ("diagonal WAVE --which 3", "--which: expected first or second"),
        ("subdivide WAVE --levels 0", "levels: expected a whole number, 1 or more, got 0"),
        ("subdivide WAVE --rule bezier", "--rule: expected plain or catmull-clark"),
        ("coarsen WAVE --every 0", "u: expected a step of at least 1"),
        ("coarsen WAVE --every z", "--every: expected K|KxL"),
        ("trim WAVE", "trim: expected rings or rows"),
        ("trim WAVE --rows 9,9,9,9", "u: expected to cut 0 to 7 of 8 rows"),
        ("trim WAVE --rows 1.5,0,0,0", "--rows: expected whole numbers"),
        ("coarsen WAVE --every 2.5", "--every: expected K|KxL"),
        ("mirror WAVE --normal 0,0,0", "plane: expected a normal and a point of three"),
        ("mirror WAVE --point 2,0,0", "mirror: the mesh reaches across the plane,"),
        ("transform WAVE --scale 0", "scale: expected a number above 0, got 0"),
        ("transform WAVE --move 1,2", "--move: expected 3 finite numbers"),
        (
            "transform WAVE --invert 0,0,0,-1",
            "--invert: is a command of its own now; write inversion",
        ),
        ("inversion WAVE --centre 0,0,9 --radius 0", "radius: expected a number above 0"),
        ("weld WAVE --tolerance 0.01", "--tolerance: is a length; say its unit, as 0.01mm"),
        ("weld WAVE --tolerance -1mm", "tolerance: expected 0 m or more"),
        ("weld WAVE nowhere.obj", "nowhere.obj: no such file"),
        ("formfind WAVE --supports roof", "supports: expected boundary, corners or vertex"),
        ("formfind WAVE --kind soap", "--kind: expected cables or membrane"),
        ("formfind WAVE --supports 1 --lift 2,1", "lift: vertex 2 is no support"),
        ("formfind WAVE --density 0", "supports: 35 vertices hang on no support"),
        ("formfind nowhere.ply", "nowhere.ply: no such file"),
        ("convert nowhere.stl", "nowhere.stl: .stl holds triangles only"),
        ("fit-multinet nowhere.obj", "nowhere.obj: no such file"),
        ("fit-multinet WAVE --sampling 1x5", "sampling: expected a whole number, 2 or more"),
        ("fit-multinet WAVE --sampling 3", "--sampling: expected MxN"),
        ("quads nowhere.stl --faces 9", "nowhere.stl: no such file"),
        ("quads WAVE", "remesh: expected either a number of faces"),
    ],
)
def test_bad_input_is_one_line_and_nothing_is_written(tmp_path, capsys, wave, words, expected):
    out = tmp_path / "result.obj"
    arguments = [wave if word == "WAVE" else word for word in words.split(" ")]
    try:
        code = main([*arguments, "-o", str(out)])
    except SystemExit as ended:
        code = ended.code
    captured = capsys.readouterr()
    assert code == 2, captured
    assert captured.err.startswith(f"error: {expected}")
    assert captured.err.strip().count("\n") == 0
    assert captured.out == ""
    assert sorted(path.name for path in tmp_path.iterdir()) == ["wave.obj"]


def test_places_that_cannot_be_written_are_said_first(tmp_path, capsys, wave):
    for target in (tmp_path, tmp_path / "nowhere" / "a.obj"):
        assert main(["subdivide", wave, "-o", str(target)]) == 2
        assert capsys.readouterr().err.startswith("error: ")


def test_the_sail_of_the_page_on_sources_is_a_start_for_a_minimal_net(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    commands = (
        "primitive rectangle --sampling 13x13 --set length=12 --set width=12 --unit m -o flat.obj",
        "formfind flat.obj --supports corners --lift 0:3;168:3 --border-density 10 -o sail.obj",
        "diagonal sail.obj -o diagonal.obj",
        "optimise sail.obj --net asymptotic -o net.obj --report of-sail.json",
        "optimise diagonal.obj --net asymptotic -o net.obj --report of-diagonal.json",
    )
    for command in commands:
        assert main(command.split()) == 0, command
    sail, other = (
        json.loads(Path(name).read_text(encoding="utf-8"))
        for name in ("of-sail.json", "of-diagonal.json")
    )
    assert sail["off_surface"]["percent"] < 0.5 * other["off_surface"]["percent"]
    assert sail["zigzag"] >= 0.8 and 0.9 <= sail["area_ratio"] <= 1.1
