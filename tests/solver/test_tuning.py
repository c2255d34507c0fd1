"""The numbers of the solver: each is explained, used, and in nobody else's way."""

from __future__ import annotations

import re
from dataclasses import fields, replace
from pathlib import Path

import numpy as np
import pytest

import solver
from solver import optimise, start_optimisation
from solver.tuning import Tuning
from tests.conftest import wavy_grid

ROOT = Path(solver.__file__).parent
NAMES = [item.name for item in fields(Tuning)]


def test_every_number_is_explained_and_used():
    explained = re.findall(r"^        (\w+): ", Tuning.__doc__, re.MULTILINE)
    assert explained == NAMES
    code = "\n".join(
        path.read_text(encoding="utf-8") for path in ROOT.rglob("*.py") if path.name != "tuning.py"
    )
    assert [name for name in NAMES if not re.search(rf"uning\.{name}\b", code)] == []


def test_numbers_at_the_heads_of_files_have_their_reasons():
    constant = re.compile(r"_?[A-Z][A-Z_0-9, ]+(: [^=]+)? = (?P<number>[-+.(\d].*\d)?")
    bare = []
    for path in sorted(ROOT.rglob("*.py")):
        explained, before = False, ""
        for line in path.read_text(encoding="utf-8").splitlines():
            found = constant.match(line)
            # One comment may be of several that follow it.
            explained = found and ("#" in line or before.startswith("#") or explained)
            if found and found["number"] and not explained:
                bare.append(f"{path.relative_to(ROOT)}: {line}")
            before = line
    assert bare == []


def test_the_table_of_what_each_does_has_all_numbers():
    table = (ROOT.parent / "docs" / "tuning.md").read_text(encoding="utf-8")
    rows = dict(re.findall(r"^\| (\w+) \| ([^|]+) \|", table, re.MULTILINE))
    for name in NAMES:
        value = getattr(Tuning(), name)
        parts = value if isinstance(value, tuple) else (value,)
        assert rows[name] == ", ".join(f"{part:g}" for part in parts)


def test_guides_that_fade_more_slowly_lead_for_longer():
    start = wavy_grid(8, 7, shear=0.2)
    usual = optimise(start, "principal").report
    slow = optimise(start, "principal", tuning=Tuning(fade=0.6)).report
    assert slow.status == usual.status == "converged"
    factors = [record.fade for record in slow.history[:4]]
    np.testing.assert_allclose(factors, 0.6 ** np.arange(4), rtol=1e-12)
    assert slow.iterations > usual.iterations


def test_they_reach_every_attempt_and_every_judgement():
    start, other = wavy_grid(8, 7, shear=0.2), Tuning(cramped=2.0, enough=2, patience=3)
    run = start_optimisation(start, "principal", tuning=other)
    outcome = run.run()
    assert run.descent.problem.tuning is other
    # Nothing is roomy enough, so that a second attempt is made, and with two it is enough.
    assert outcome.report.attempts == 2
    assert optimise(start, "principal", tuning=replace(other, cramped=0.5)).report.attempts == 1


@pytest.mark.parametrize("reuses", [1, 5])
def test_factors_serve_as_often_as_is_said(reuses):
    mesh = optimise(wavy_grid(8, 7)).mesh
    session = solver.Session(mesh, [27], tuning=Tuning(reuses=reuses))
    solves = []
    session.drag({27: mesh.vertices[27]})
    stepper = session._run.descent.layout.stepper
    for k in range(6):
        session.drag({27: mesh.vertices[27] + [0.0, 0.0, 0.001 * (k + 1)]})
        solves.append(stepper._reused)
    assert max(solves) <= reuses
