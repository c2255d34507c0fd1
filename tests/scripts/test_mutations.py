"""The script of small changes changes what it says, and nothing that no program would notice."""

from __future__ import annotations

import ast
import json
import subprocess
import sys

import pytest

from tests.conftest import ROOT

sys.path.insert(0, str(ROOT / "scripts"))
from mutation_map import Coverage, read_at
from mutation_nearest import Nearest
from mutation_places import mutations_of
from mutation_probes import CALLED, with_calls
from mutation_record import Record

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


def test_the_innermost_statement_of_a_function_says_that_it_is_reached():
    source = """def one(x):
    if x > 1:
        return [
            x,
        ]
    elif x:
        x += 1
    return x


TWO = one(2)
"""
    reached: list[int] = []
    names = {CALLED: reached.append}
    exec(
        compile(with_calls(source, {2: [1], 4: [2, 3], 6: [4], 7: [5], 11: [6]}), "", "exec"), names
    )
    assert reached == [1, 2, 3]
    reached.clear()
    assert names["one"](1) == 2
    assert reached == [1, 4, 5]


def test_tests_are_near_what_they_name():
    sources = {
        "solver/walls.py": "def wall(): ...",
        "solver/roofs.py": "from .walls import wall\n\ndef roof(): ...",
    }
    tests = {
        "tests/solver/test_other.py": "import numpy",
        "tests/solver/test_roofs.py": "from solver.roofs import roof",
        "tests/solver/test_walls.py": "from solver.walls import wall",
    }
    near = Nearest(sources, tests)
    order = sorted(tests, key=near.ranks("solver/walls.py").get)
    assert order == [f"tests/solver/test_{name}.py" for name in ("walls", "roofs", "other")]
    assert near.ranks("solver/roofs.py")["tests/solver/test_roofs.py"] == 0


RATIO = """STEPS = 2


def share(part, whole):
    return part / whole


def spread(values):
    return max(values) - min(values)


def steps():
    left = STEPS
    while left > 0:
        left -= 1
    return left


def unused():
    return 1 + 1
"""
TESTS = """import ratio


def test_share():
    assert ratio.share(1, 1) == 1


def test_spread():
    assert ratio.spread([1, 2]) == 1


def test_steps():
    assert ratio.STEPS == 2 and ratio.steps() == 0


def test_broken():
    assert ratio.share(1, 2) == 3
"""
RUN = """import json, sys
from pathlib import Path
sys.path.insert(0, sys.argv[1])
import mutation_forks
from mutation_places import mutations_of
from mutation_probes import Places
mutation_forks._ENDLESS = 1.0
root = Path(sys.argv[2])
sources = {"ratio.py": (root / "ratio.py").read_text()}
drawn = dict(enumerate(mutations_of("ratio.py", sources["ratio.py"])))
ranks = {number: {"tests/test_ratio.py": 0} for number in drawn}
warm = mutation_forks.Warm(root, drawn, Places(drawn, sources), ranks)
found = warm.try_file("tests/test_ratio.py", sorted(drawn))
print(json.dumps({str(drawn[number]): [one.tests, one.by] for number, one in found.items()}))
"""


def test_changes_are_tried_in_forks(tmp_path):
    (tmp_path / "ratio.py").write_text(RATIO)
    (tmp_path / "tests").mkdir()
    (tmp_path / "tests" / "test_ratio.py").write_text(TESTS)
    command = [sys.executable, "-c", RUN, str(ROOT / "scripts"), str(tmp_path)]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
    found = {words.partition(": ")[2]: tried for words, tried in json.loads(done.stdout).items()}
    test = "tests/test_ratio.py::test_"
    # A test that fails as it is notices nothing; what no test reaches is not tried.
    assert found == {
        "2 in «STEPS = 2» -> 3": [1, f"{test}steps"],
        "/ in «return part / whole» -> *": [1, ""],
        "- in «return max(values) - min(values)» -> +": [1, f"{test}spread"],
        "> in «while left > 0:» -> >=": [1, f"{test}steps"],
        "0 in «while left > 0:» -> 1": [1, f"{test}steps"],
        "left -= 1 in «left -= 1» -> pass": [1, f"tests that never end, {test}steps first"],
        "1 in «left -= 1» -> 2": [1, ""],
    }


def test_what_was_tried_is_taken_up_again_for_the_same_draw(tmp_path):
    drawn = mutations_of("some.py", SOURCE)[:2]
    record = Record.of(tmp_path / "kept.json", drawn)
    record.noticed["2"], record.asked["1"] = "tests/test_a.py::test_b", 3
    record.keep(tmp_path / "kept.json")
    assert Record.of(tmp_path / "kept.json", drawn).table().splitlines()[2:] == [
        f"| 1 | `{drawn[0]}` | none of 3 tests |",
        f"| 2 | `{drawn[1]}` | `tests/test_a.py::test_b` |",
    ]
    assert not Record.of(tmp_path / "kept.json", drawn[:1]).noticed
