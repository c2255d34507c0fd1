"""The script of small changes changes what it says, and nothing that no program would notice."""

from __future__ import annotations

import ast
import sys

import pytest

from tests.conftest import ROOT

sys.path.insert(0, str(ROOT / "scripts"))
from mutation_map import Coverage, read_at
from mutation_places import mutations_of

SOURCE = '''\
"""Adds 1 to 2."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import os

LIMIT: "list[2]" = 0.5


def shorter(words: list[str], other=None) -> tuple[int, 3]:
    """Return 7."""
    if len(words) < 4 and (words[0]) not in (other or "µ"):
        words.append(f"{1 + 2}")
        raise ValueError(
            "5 words" + "at least"
        )
    return -len(words) * 2, not True
'''


def changes() -> dict[str, str]:
    """What each change makes of its place, by the line and what stands there."""
    return {
        f"{one.lines.start} {SOURCE[one.start : one.end]}": one.text
        for one in mutations_of("some.py", SOURCE)
    }


def test_every_kind_of_place_is_found_and_no_words_or_types():
    found = changes()
    statement = 'raise ValueError(\n            "5 words" + "at least"\n        )'
    assert found.pop(f"15 {statement}") == "pass"
    assert found == {
        "8 0.5": "1.0",
        "13 <": "<=",
        "13 4": "5",
        "13 and": "or",
        "13 0": "1",
        "13 not in": "in",
        "13 or": "and",
        '14 words.append(f"{1 + 2}")': "pass",
        "18 -": "",
        "18 *": "/",
        "18 2": "3",
        "18 not": "",
        "18 True": "False",
    }


@pytest.mark.parametrize("path", ["solver/linear/dissection.py", "solver/io/ply.py"])
def test_every_change_is_one_that_python_reads_and_makes_a_difference(path):
    source = (ROOT / path).read_text(encoding="utf-8")
    tree = ast.dump(ast.parse(source))
    found = mutations_of(path, source)
    assert len(found) > 50
    for one in found:
        assert ast.dump(ast.parse(one.applied(source))) != tree, str(one)
        assert str(one).startswith(f"{path}:{one.lines.start}: ")


def test_what_runs_on_import_is_shown_by_whoever_uses_it():
    lines = len(SOURCE.splitlines())
    assert read_at(SOURCE, 8) == (["LIMIT"], range(1, lines + 2))
    assert read_at("A, B = 1, 2\n", 1) == (["A", "B"], range(1, 3))
    assert read_at("class C:\n    size: int = 3\n", 2) == (["C"], range(1, 4))
    # The head of a function is shown by what is in it; a line in it runs by itself.
    assert read_at(SOURCE, 11) == ([], range(12, lines + 1))
    assert read_at(SOURCE, 13) == ([], None)


def test_the_quickest_tests_come_first_and_end_with_the_allowance():
    path = "solver/linear/dissection.py"
    source = (ROOT / path).read_text(encoding="utf-8")
    one = next(
        one for one in mutations_of(path, source) if read_at(source, one.lines.start)[1] is None
    )
    line = one.lines.start
    # A file at a time, that which takes least first; "c" stands for what a fixture runs.
    lines = {path: {line: ["a::slow", "b::quick", "c"], line + 999: ["d::elsewhere"]}}
    seconds = {
        "a::slow": 100.0,
        "b::quick": 1.0,
        "c::one": 30.0,
        "c::two": 2.0,
        "d::elsewhere": 0.1,
    }
    assert Coverage(lines, seconds).tests(one) == ["b::quick", "c::two", "c::one"]
