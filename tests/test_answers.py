"""Lower rooms ask, higher ones answer: without either importing what is above it."""

from __future__ import annotations

import sys

import pytest

from freecad_ortho import answers


@pytest.fixture(autouse=True)
def nobody(monkeypatch):
    monkeypatch.setattr(answers, "_given", {})
    monkeypatch.setattr(answers, "_promised", [])


def test_what_was_given_is_asked_for():
    answers.give("double", lambda number: 2 * number)
    assert answers.ask("double", 21) == 42


def test_a_module_that_was_promised_is_loaded_at_the_first_question(tmp_path, monkeypatch):
    lines = "from freecad_ortho import answers\nanswers.give('sum', lambda *all: sum(all))\n"
    (tmp_path / "promised_room.py").write_text(lines, encoding="utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    for _ in range(2):
        answers.promise("promised_room")
    assert "promised_room" not in sys.modules
    assert answers.ask("sum", 1, 2, 3) == 6
    monkeypatch.delitem(sys.modules, "promised_room")
    assert answers.ask("sum", 4) == 4 and "promised_room" not in sys.modules


def test_what_nobody_does_is_said():
    with pytest.raises(LookupError, match="edit cloud: nothing that is loaded does this"):
        answers.ask("edit cloud")
