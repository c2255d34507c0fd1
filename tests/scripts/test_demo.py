"""demo.sh: bad arguments get one line; a whole run leaves every file, each readable."""

import csv
import json
import os
import re
import subprocess
from pathlib import Path

import numpy as np
import pytest

from freecad_ortho.step_faces import triangles_from_step
from solver import read_mesh
from solver.align.reach import reaching
from solver.analysis.form import off_surface
from solver.mesh.closest import TriangleSurface

ROOT = Path(__file__).resolve().parents[2]
SURFACE, MESH = (ROOT / "examples" / "data" / f"demo_roof.{kind}" for kind in ("step", "obj"))
FILES = {
    "structure.step",
    "flat.dxf",
    "parts.csv",
    "nodes.csv",
    "stock.csv",
    "bevels.csv",
    "report.json",
    "report.html",
    "model.FCStd",
    "preview.png",
    "net.obj",
}
BUILT = FILES | {"net.json", "aligned.json", "aligned.obj", "edge-beam.csv"}


def demo(*arguments, cwd=ROOT):
    return subprocess.run(
        ["bash", str(ROOT / "scripts" / "demo.sh"), *map(str, arguments)],
        cwd=cwd,
        capture_output=True,
        text=True,
        check=False,
    )


def test_help(tmp_path):
    result = demo("--help", cwd=tmp_path)
    assert result.returncode == 0
    assert all(name in result.stdout for name in BUILT)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--colour"], "unknown option '--colour'"),
        (["--mesh"], "--mesh needs a value"),
        (["--mesh", "nowhere.obj"], "no readable file 'nowhere.obj'"),
        (["--mesh", "."], "no readable file '.'"),
        (["--surface", "nowhere.step"], "--surface: no readable file 'nowhere.step'"),
        (["--surface", SURFACE, "--mesh", MESH], "--surface and --mesh: give one of them"),
        (["--mesh", MESH, "--edge", "2"], "--edge: a mesh has its edges already"),
        (["--unit", "km"], "expected mm, cm, m, in or ft, got 'km'"),
        (["--height", "0"], "expected millimetres above 0, got '0'"),
        (["--height", "-200"], "expected millimetres above 0, got '-200'"),
        (["--panel-thickness", "0"], "expected millimetres above 0, got '0'"),
        (["--thickness", "thick"], "expected millimetres above 0, got 'thick'"),
        (["one", "two"], "got 'one' and 'two'"),
        (["/proc/nowhere"], "cannot be written"),
    ],
)
def test_bad_arguments_get_one_line(tmp_path, arguments, words):
    result = demo(*arguments, cwd=tmp_path)
    assert result.returncode == 2
    assert result.stdout == ""
    assert len(result.stderr.splitlines()) == 1
    assert result.stderr.startswith("demo.sh: ")
    assert words in result.stderr
    assert not list(tmp_path.iterdir())


def test_bad_mesh_leaves_nothing(tmp_path):
    mesh = tmp_path / "triangle.obj"
    mesh.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    result = demo(tmp_path / "out", "--mesh", mesh)
    assert result.returncode == 2
    assert "Traceback" not in result.stderr
    assert "triangle" in result.stderr.splitlines()[-1]
    assert not list((tmp_path / "out").iterdir())


def wavy_grid(path, edge):
    """Write 6 x 5 quads of a gentle wave, without naming a unit."""
    u, v = np.meshgrid(np.arange(7.0), np.arange(6.0), indexing="ij")
    points = np.stack([u + 0.1 * v, v, 0.1 * (u - 3) ** 2 - 0.05 * (v - 2.5) ** 2], axis=-1) * edge
    numbers = np.arange(1, 43).reshape(7, 6)
    quads = np.stack([numbers[:-1, :-1], numbers[1:, :-1], numbers[1:, 1:], numbers[:-1, 1:]], -1)
    text = ["v {} {} {}".format(*point) for point in points.reshape(-1, 3).tolist()]
    text += ["f {} {} {} {}".format(*quad) for quad in quads.reshape(-1, 4).tolist()]
    path.write_text("\n".join(text) + "\n")
    return path


@pytest.mark.slow
def test_another_mesh_of_unknown_unit(tmp_path):
    mesh = wavy_grid(tmp_path / "small.obj", edge=0.1)
    result = demo("out", "--mesh", mesh.name, cwd=tmp_path)
    assert result.returncode == 0, result.stderr
    assert "unit: taken as m, which makes the mean edge 10" in result.stderr
    assert {path.name for path in (tmp_path / "out").iterdir()} == FILES
    with (tmp_path / "out" / "parts.csv").open(newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert len(rows) == 6 * 6 + 7 * 5 + 6 * 5
    assert max(float(row["height_mm"]) for row in rows if row["kind"] == "beam") < 30


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    folder = tmp_path_factory.mktemp("demo") / "some where"
    result = demo(folder)
    assert result.returncode == 0, result.stderr
    return folder, result


@pytest.fixture(scope="module")
def parts(run):
    with (run[0] / "parts.csv").open(newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


@pytest.fixture(scope="module")
def net(run):
    return read_mesh(run[0] / "net.json")


@pytest.mark.slow
def test_writes_every_file_and_nothing_else(run):
    assert {path.name for path in run[0].iterdir()} == BUILT


@pytest.mark.slow
def test_the_net_lies_on_the_surface_and_parts_at_its_umbilics(net):
    assert 440 < len(net.faces) < 500
    around = net.connectivity
    irregular = ~around.regular & ~around.boundary_vertices
    assert irregular.sum() == 2
    mesh = net.scaled(1000.0)
    # The surface as it goes on beyond its border, which the net overhangs.
    ground = TriangleSurface(*reaching(mesh, *triangles_from_step(SURFACE)))
    assert off_surface(mesh, ground).max() < 40.0


@pytest.mark.slow
def test_ends_with_ten_lines(run, net, parts):
    table = run[1].stdout.strip().splitlines()
    assert len(table) == 10
    assert f"{len(net.faces)} quads" in table[0]
    assert float(re.search(r"(\d+) mm off the surface", table[3])[1]) < 40
    kinds = [row["kind"] for row in parts]
    assert f"{kinds.count('beam')} plates" in table[4]
    assert f"{kinds.count('panel')} plates" in table[7] and table[7].endswith(" 3 mm thick")
    assert float(re.search(r"([\d.]+) t of steel", table[8])[1]) < 60
    twist = float(re.search(r"worst (\S+) degrees", table[5])[1])
    assert twist < 1e-5
    low, high = map(float, re.findall(r"\d+\.\d+", table[6]))
    assert 190 <= low <= high <= 210


@pytest.mark.slow
def test_report(run, net):
    stages = json.loads((run[0] / "report.json").read_text())["build"]["stages"]
    assert list(stages) == ["align", "optimise", "fabricate"]
    optimised = stages["optimise"]["numbers"]
    assert optimised["status"] == "converged"
    assert (optimised["vertices"], optimised["faces"]) == (len(net.vertices), len(net.faces))
    assert all(residual["max"] <= 1e-10 for residual in optimised["residuals"].values())
    assert optimised["moved"]["mean"] <= 1.0


@pytest.mark.slow
def test_parts_list(parts, net):
    names = [row["name"] for row in parts]
    beams = {row["name"] for row in parts if row["kind"] == "beam"}
    panels = {row["name"] for row in parts if row["kind"] == "panel"}
    edge = {row["name"] for row in parts if row["kind"] == "edge-beam"}
    assert beams | panels | edge == set(names) and edge
    assert {row["verdict"] for row in parts} == {"ok"}
    assert beams <= {f"B{k:04d}" for k in range(len(net.connectivity.edges))}
    # At the border faces have none, one, or two.
    faces = {int(re.sub(r"\D", "", name)) for name in panels}
    inner = np.flatnonzero(~net.connectivity.boundary_vertices[net.faces].any(axis=1))
    assert set(inner.tolist()) <= faces <= set(range(len(net.faces)))
    assert all(float(row["volume_mm3"]) > 0 and float(row["mass_kg"]) > 0 for row in parts)


@pytest.mark.slow
def test_flat_patterns(run, parts):
    import ezdxf

    drawing = ezdxf.readfile(run[0] / "flat.dxf")
    assert {"CUT", "ENGRAVE", "LABEL"} <= {layer.dxf.name for layer in drawing.layers}
    blocks = {block.name for block in drawing.blocks}
    assert {row["name"] for row in parts} <= blocks


@pytest.mark.slow
def test_step(run, parts):
    import cadquery

    path = run[0] / "structure.step"
    text = path.read_text(encoding="utf-8", errors="replace")
    assert {row["name"] for row in parts} <= set(re.findall(r"PRODUCT\('([^']*)'", text))
    solids = cadquery.importers.importStep(str(path)).solids().vals()
    assert len(solids) == len(parts)
    volume = sum(float(row["volume_mm3"]) for row in parts)
    assert sum(solid.Volume() for solid in solids) == pytest.approx(volume, rel=1e-6)


@pytest.mark.slow
def test_preview(run):
    from PIL import Image

    with Image.open(run[0] / "preview.png") as picture:
        pixels = np.asarray(picture.convert("RGB")).astype(int)
    assert pixels.shape == (1000, 1600, 3)
    assert (pixels.min(axis=-1) > 250).mean() > 0.2
    middle = pixels[250:650, 300:1000]
    assert (middle.min(axis=-1) < 200).mean() > 0.3
    red, _, blue = np.moveaxis(middle, -1, 0)
    assert (blue - red > 40).mean() > 0.1


CHECK_MODEL = """
import os
import sys

import FreeCAD

document = FreeCAD.openDocument(os.environ["ORTHO_MODEL"])
for feature in document.Objects:
    solids = len(feature.Shape.Solids) if hasattr(feature, "Shape") else 0
    faces = len(feature.Faces) // 4 if hasattr(feature, "Faces") else 0
    print("OBJECT", feature.Label, solids, faces)
sys.stdout.flush()
os._exit(0)
"""


@pytest.mark.slow
def test_model_opens(run, net, parts, tmp_path):
    import numpy

    script = tmp_path / "check_model.py"
    script.write_text(CHECK_MODEL)
    environment = os.environ | {
        "FREECAD_USER_HOME": str(tmp_path),
        "ORTHO_MODEL": str(run[0] / "model.FCStd"),
        "PYTHONPATH": f"{ROOT}:{Path(numpy.__file__).parents[1]}",
    }
    result = subprocess.run(
        [os.environ.get("ORTHO_FREECADCMD", "freecadcmd"), script],
        env=environment,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert "Traceback" not in result.stdout + result.stderr
    found = re.findall(r"^OBJECT (.*) (\d+) (\d+)$", result.stdout, re.MULTILINE)
    kinds = [row["kind"] for row in parts]
    assert found == [
        ("Design surface", "0", "0"),
        ("Principal mesh", "0", str(len(net.faces))),
        ("Edge-beam", str(kinds.count("edge-beam")), "0"),
        ("Beams", str(kinds.count("beam")), "0"),
        ("Panels", str(kinds.count("panel")), "0"),
    ]
