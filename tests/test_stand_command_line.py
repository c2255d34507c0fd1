"""The command stand, as one types it."""

import json
import time

import pytest

from freecad_ortho.__main__ import main
from solver.io.obj import write_obj
from solver.mesh.primitives import primitive
from tests.conftest import ROOT

ROOF = str(ROOT / "examples" / "data" / "demo_roof.obj")


def test_the_demo_roof_is_checked_and_reported(tmp_path, capsys):
    folder = tmp_path / "out"
    command = ["stand", ROOF, "--section", "tube:100x60x5", "--material", "S355"]
    command += ["--supports", "boundary", "--snow", "1.5", "--wind", "0.6@x", "--self-weight"]
    start = time.process_time()
    assert main([*command, "-o", str(folder)]) == 1
    assert time.process_time() - start < 5
    said = capsys.readouterr()
    assert said.out.startswith("Does not pass this check: buckling factor 3.")
    assert said.out.count("\n") == 1 and "Panels weigh nothing here" in said.err
    report = json.loads((folder / "check.json").read_text(encoding="utf-8"))
    assert report["imbalance"] < 1e-9
    factors = report["combinations"][0]["buckling_factors"]
    assert len(factors) == 5 and factors == sorted(factors)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--supports", "3,4"], "mechanism"),
        (["--no-self-weight"], "loads: there are none"),
        (["--section", "tube:9"], "section"),
        (["--material", "butter"], "material: there are no rules for members of 'butter'"),
        (["--snow", "much"], "--snow: expected a finite number"),
        (["--combinations", "none.json"], "none.json: is no JSON file"),
        (["--lightest-of", "tubes", "--groups", "rows"], "groups: expected all, families or bands"),
        (["--section", "tube:60x40x4,roof=tube:80x40x4"], "there is no group 'roof' of members"),
    ],
)
def test_bad_input_is_one_line_and_writes_nothing(tmp_path, capsys, words, said):
    folder = tmp_path / "out"
    assert main(["stand", ROOF, *words, "-o", str(folder)]) == 2
    error = capsys.readouterr().err.strip().splitlines()[-1]
    assert error.startswith("error: ") and said in error
    assert not folder.exists()


def test_families_are_sized_and_the_fabrication_report_tells_it(tmp_path, capsys):
    mesh = primitive("translational", 7, 5)
    net, files = tmp_path / "dome.obj", tmp_path / "files"
    write_obj(net, mesh.with_vertices(2.0 * mesh.vertices), unit="m")
    sections = "tube:20x20x2+tube:30x30x2+tube:40x40x3+tube:50x50x3+tube:60x60x4"
    command = ["stand", str(net), "--lightest-of", sections, "--groups", "families"]
    assert main([*command, "--snow", "3", "-o", str(files)]) == 0
    said = capsys.readouterr().out
    assert " border, " in said and "pass, the lightest found (" in said
    command = ["fabricate", str(net), "--system", "panels", "-o", str(files)]
    assert main([*command, "--check", str(files / "check.json")]) == 0
    page = (files / "report.html").read_text(encoding="utf-8")
    assert "<h2>Structural check</h2>" in page and said.split(" Files are in")[0][-40:] in page
    assert main([*command, "--check", str(files / "report.json")]) == 2
    assert "is no check.json of a structural check" in capsys.readouterr().err
