"""What a shape is worth: each thing that can spoil a result, alone."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from solver.candidate import judge
from solver.nets.options import NetOptions
from solver.nets.principal import principal
from solver.problem import Problem
from tests.meshes import grid, parameters


@pytest.fixture
def candidate():
    """A gently curved grid, judged against itself with a tolerance that it meets."""
    x, y = parameters(6, 5, 5.0, 4.0)
    mesh = grid(x, y, 0.1 * x**2)
    fixed = np.zeros(len(mesh.vertices), dtype=bool)
    problem = principal(Problem("principal", mesh, fixed), NetOptions())
    return judge(problem, problem.start, 1e-9)


def test_a_shape_that_keeps_its_form_is_good(candidate):
    assert candidate.met and candidate.sound and candidate.valid and candidate.good
    assert not (candidate.flattened or candidate.creased or candidate.gone)


@pytest.mark.parametrize(
    ("change", "spoilt", "kept"),
    [
        ({"flipped": 1}, ["sound", "valid", "good"], ["met"]),
        ({"edge_ratio": 0.2}, ["sound", "valid", "good"], ["met"]),
        ({"edge_ratio": 0.4}, ["good"], ["met", "sound", "valid"]),
        ({"met": False}, ["met", "valid", "good"], ["sound"]),
        ({"crease": 90.0}, ["good"], ["met", "sound", "valid"]),
        ({"thickness": 0.3}, ["good"], ["met", "sound", "valid"]),
    ],
)
def test_each_fault_spoils_what_it_should(candidate, change, spoilt, kept):
    """Edge ratio and thickness are given as parts of those of the start."""
    values = dict(change)
    for name in ("edge_ratio", "thickness"):
        if name in values:
            values[name] *= getattr(candidate, f"{name}_start")
    worse = replace(candidate, **values)
    assert [name for name in spoilt if getattr(worse, name)] == []
    assert [name for name in kept if not getattr(worse, name)] == []
    assert worse.rank < candidate.rank


def test_folds_of_the_start_are_no_fault_of_the_result(candidate):
    assert replace(candidate, flipped=2, flipped_start=2).sound
    assert not replace(candidate, flipped=3, flipped_start=2).sound


def test_a_folded_shape_is_no_solution_even_where_the_net_is_met(candidate):
    x, y = parameters(6, 5, 5.0, 4.0)
    x[3] = x[1] + 0.1
    folded = grid(x, y, 0 * x)
    fixed = np.zeros(len(folded.vertices), dtype=bool)
    flat = grid(*parameters(6, 5, 5.0, 4.0), 0 * x)
    problem = principal(Problem("principal", flat, fixed), NetOptions())
    at = ((folded.vertices - problem.centre) / problem.scale).ravel()
    found = judge(problem, at, 1e-9)
    assert found.met and found.flipped and not found.sound and not found.valid


def test_flattened_is_less_than_a_part_of_what_was_thick(candidate):
    at = replace(candidate, thickness_start=1.0)
    assert at.tuning.flattened == 0.4
    assert replace(at, thickness=0.39).flattened and not replace(at, thickness=0.41).flattened
    thin = replace(at, thickness_start=0.9 * at.tuning.thick, thickness=0.0)
    assert not thin.flattened


def test_gone_is_next_to_nothing_of_what_was_no_plane(candidate):
    at = replace(candidate, thickness_start=0.2)
    assert replace(at, thickness=0.019).gone and not replace(at, thickness=0.021).gone
    assert not replace(at, thickness=0.0, may_flatten=True).gone
    # A level start with a little noise was a plane already.
    assert not replace(at, thickness_start=1e-3, thickness=0.0).gone
