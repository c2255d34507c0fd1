"""How many files an addition touches: the table of docs/development.md, counted in the tree."""

from __future__ import annotations

import re

import pytest

from tests.conftest import ROOT

# One file is written by a script.
SOURCES = [
    path
    for room in ("solver", "freecad_ortho")
    for path in (ROOT / room).rglob("*.py")
    if path.name != "option_keywords.py"
]


def rows() -> list:
    """What is added, how many files, the name of the example, and the files that name it."""
    text = (ROOT / "docs" / "development.md").read_text(encoding="utf-8")
    table = text.split("## Adding")[1].split("\n- **")[0]
    found = []
    for line in re.findall(r"^\| an? .*$", table, re.MULTILINE):
        what, count, example = (cell.strip() for cell in line.strip("|").split("|"))
        name, *files = re.findall(r"`([^`]+)`", example)
        found.append(pytest.param(int(count), name, set(files), id=what))
    return found


def test_the_table_has_a_net_an_option_a_system_a_command_and_a_source():
    kinds = " ".join(row.id for row in rows())
    for kind in ("term", "net", "option of nets", "option of a system", "command", "source"):
        assert f"a {kind}" in kinds or f"an {kind}" in kinds
    assert "a system with its button" in kinds


@pytest.mark.parametrize(("count", "name", "files"), rows())
def test_these_files_and_no_others_name_the_example(count, name, files):
    found = re.compile(rf"(?<![\w-]){re.escape(name)}(?![\w-])")
    naming = {
        path.relative_to(ROOT).as_posix()
        for path in SOURCES
        if found.search(path.read_text(encoding="utf-8"))
    }
    assert naming == files
    assert count == len(files)


def answers() -> list:
    """Rows of the table of questions: names and files."""
    text = (ROOT / "docs" / "development.md").read_text(encoding="utf-8")
    table = text.split("## Where is what?")[1].split("\n## ")[0]
    rows = [line for line in table.splitlines() if "?" in line and line.startswith("|")]
    return [pytest.param(re.findall(r"`([^`]+)`", row), id=row[2:40]) for row in rows]


@pytest.mark.parametrize("words", answers())
def test_answers_name_files_that_have_what_they_say(words):
    files = [word for word in words if word.endswith(".py")]
    texts = [(ROOT / name).read_text(encoding="utf-8") for name in files]
    for word in set(words) - set(files) - {"help"}:
        name = word.rpartition(".")[2]
        assert any(name in text for text in texts), word
