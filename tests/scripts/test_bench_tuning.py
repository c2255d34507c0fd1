"""The script that doubles and halves the numbers of the solver says what that changes."""

import sys
from dataclasses import replace
from pathlib import Path

import pytest

from solver import optimise
from solver.tuning import Tuning
from tests.conftest import wavy_grid

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def tool(monkeypatch):
    pytest.importorskip("cadquery")
    monkeypatch.syspath_prepend(str(ROOT / "scripts"))
    import bench_tuning

    yield bench_tuning
    for name in ("bench_tuning", "bench"):
        sys.modules.pop(name)


def test_numbers_are_scaled_as_what_they_are(tool):
    assert tool.scaled(0.3, 2.0) == 0.6
    assert tool.scaled((3.0, 30.0), 0.5) == (1.5, 15.0)
    assert (tool.scaled(25, 0.5), tool.scaled(1, 0.5)) == (12, 1)
    assert tool.written((3.0, 30.0)) == "3, 30"


def test_effects_are_told_apart(tool):
    case = tool.Case("wave", wavy_grid(8, 7, shear=0.2), "principal")
    usual = case.outcome(Tuning())
    assert tool.effect({"wave": usual}, {"wave": usual}) == "nothing"
    slower = tool.effect({"wave": case.outcome(Tuning(fade=0.6))}, {"wave": usual})
    assert slower.split()[1] == "steps" and int(slower.split()[0]) > usual.report.iterations
    moved = replace(usual, mesh=usual.mesh.with_vertices(usual.mesh.vertices + 1.0))
    assert tool.effect({"wave": moved}, {"wave": usual}).startswith("1 case elsewhere, wave by 1.7")
    stopped = optimise(case.mesh, max_steps=1)
    assert tool.effect({"wave": stopped}, {"wave": usual}) == "1 steps; wave: stopped"


def test_a_number_is_tried_on_the_first_case_that_heeds_it(tool):
    start = wavy_grid(6, 5, shear=0.2)
    cases = [
        tool.Case("wave", start, "principal"),
        tool.Case("near", start, "principal", near=0.01),
    ]
    lines = list(tool.table(cases, ["fade", "along_far", "stages"], True))
    steps = sum(case.outcome(Tuning()).report.iterations for case in cases)
    assert lines[0] == f"2 cases, {steps} steps as it is."
    rows = {line.split(" | ")[0]: line for line in lines[4:]}
    assert "elsewhere, near by" not in rows["| fade"] and "steps" in rows["| fade"]
    assert "steps" in rows["| along_far"]
    assert rows["| stages"].endswith("| nothing | nothing |")
