"""Sentences that can be said in other languages: what they are in English, and made again."""

import copy
import json
import pickle
from types import SimpleNamespace

import pytest

from solver.sentence import Measured, Sentence
from solver.summary import _left_out

LINES = (Sentence("1 vertex with {} lines", 3), Sentence("{} vertices with {} lines", 2, 5))


@pytest.mark.parametrize(
    ("said", "words"),
    [
        (Sentence("pinholes are closed: {}, {} across", 2, Measured(0.0123, 1, 2)),
         "pinholes are closed: 2, 0.012 across"),
        (Sentence("t from {}", Measured(-9.6e6, 2, 4, "mm")), "t from -9.6e+06 mm2"),
        (Sentence("edges of {}", Measured(1.25, unit="m")), "edges of 1.25 m"),
        (Sentence("unbalanced {:.0e}", 3e-12), "unbalanced 3e-12"),
        (Sentence("irregular: {}", LINES),
         "irregular: 1 vertex with 3 lines, 2 vertices with 5 lines"),
        (Sentence("a name with {} is kept", "{braces}"), "a name with {braces} is kept"),
    ],
)  # fmt: skip
def test_is_said_in_english_and_kept_apart(said, words):
    assert said == words and isinstance(said, str)
    for again in (copy.deepcopy(said), pickle.loads(pickle.dumps(said))):
        assert (again, again.pattern, again.values) == (said, said.pattern, said.values)
    assert json.loads(json.dumps([said])) == [words]


@pytest.mark.parametrize(("count", "words"), [(1, "1 place next to"), (2, "2 places next to")])
def test_one_place_without_right_angles_is_not_said_to_be_many(count, words):
    (said,) = _left_out(SimpleNamespace(exempt=count))
    assert said.startswith(words)
    assert f" {'is' if count == 1 else 'are'} not asked for right angles" in said
