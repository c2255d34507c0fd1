"""Words that depend on a number, and what options are said to do."""

from __future__ import annotations

import json
import re
from types import SimpleNamespace

import pytest

from freecad_ortho.cli.reporting import fabrication_line
from freecad_ortho.fabrication import Limits
from freecad_ortho.fabrication.formats import FORMATS
from freecad_ortho.fabrication.systems import SYSTEMS
from freecad_ortho.fabrication.workshop import Workshop
from freecad_ortho.sources import SOURCES
from freecad_ortho.structural.design import Design
from freecad_ortho.words import counted, plural
from solver.mesh.remesh import OPTIONS as REMESHING
from solver.nets.options import OPTIONS
from solver.nets.settings import WEIGHTS
from solver.nets.supports import SUPPORTS
from solver.option import Option


@pytest.mark.parametrize(
    ("number", "noun", "words"),
    [
        (1, "patch", "1 patch"),
        (2, "patch", "2 patches"),
        (0, "quad", "0 quads"),
        (3, "bent panel", "3 bent panels"),
        (2, "box", "2 boxes"),
        (1, "foot", "1 foot"),
        (4, "foot", "4 feet"),
    ],
)
def test_counts_are_english(number, noun, words):
    assert counted(number, noun) == words


def test_a_noun_without_a_rule_is_given_its_plural():
    assert counted(2, "vertex", "vertices") == "2 vertices"
    assert counted(1, "vertex", "vertices") == "1 vertex"
    assert plural("louvre") == "louvres"


def test_the_line_about_patches(tmp_path, capsys):
    report = {"verdict": {"failed": []}, "mass_kg": 7, "messages": ["sheet: 1 part does not fit"]}
    (tmp_path / "report.json").write_text(json.dumps(report))
    structure = SimpleNamespace(parts=[SimpleNamespace(kind="patch")] * 2)
    line = fabrication_line(structure, str(tmp_path))
    assert line == f"2 patches, 7.0 kg; files are in {tmp_path}"
    assert capsys.readouterr().err == "note: sheet: 1 part does not fit\n"


def options() -> list[Option]:
    of_systems = [option for system in SYSTEMS.values() for option in system.options]
    return [*of_systems, *Workshop.options]


def all_options() -> dict[str, Option]:
    """Options that differ in their meaning, of nets, guides, sources and checks too."""
    of_nets = [*OPTIONS.values(), *WEIGHTS.values(), SUPPORTS, *REMESHING]
    of_sources = [option for source in SOURCES.values() for option in source.options]
    found = [*options(), *of_nets, *of_sources, *Design.options, *Limits.options]
    return {f"{option.name}: {option.meaning}": option for option in found}


# A sentence has one of these: whoever needs another adds it.
VERBS = {
    *("are", "begins", "buckle", "carries", "carry", "change", "comes", "count", "covers", "cut"),
    *(
        "differ",
        "end",
        "follow",
        "follows",
        "get",
        "gets",
        "give",
        "gives",
        "go",
        "goes",
        "grows",
        "has",
    ),
    *("have", "hold", "holds", "is", "join", "keep", "keeps", "leave", "lie", "lies", "lose"),
    *("loses", "make", "may", "measure", "meet", "moves", "pack", "pass", "reach", "reaches"),
    *("run", "runs", "says", "stand", "stands", "stay", "turn", "turns", "unroll", "weigh"),
    *("weighs",),
}


@pytest.mark.parametrize("option", all_options().values(), ids=lambda option: option.name)
def test_what_an_option_does_is_a_sentence(option):
    """Tooltips begin it with a capital and end it with a full stop."""
    first, *rest = option.meaning.split()
    assert first not in ("of", "in", "to", "at", "between", "beyond", "across")
    assert len(rest) >= 3 and option.meaning[-1] not in ".,;"
    assert VERBS & set(re.findall(r"\w+", option.meaning.lower())), "add its verb, if it has one"
    assert option.meaning.lower() != option.label.lower()


@pytest.mark.parametrize("option", options(), ids=lambda option: option.name)
def test_on_the_command_line_it_goes_on_in_small_letters(option):
    assert option.meaning[0].islower()


def test_what_is_zero_where_nothing_was_chosen_is_said():
    """In the property editor, which has no words for an empty field."""
    for option in all_options().values():
        if option.kind == "length" and option.default is None:
            assert option.sentence.endswith(f"; 0 is {option.absent or 'automatic'}")


@pytest.mark.parametrize("each", FORMATS.values(), ids=lambda each: each.name)
def test_what_is_in_a_file_is_a_sentence(each):
    assert each.contents[-1] != "." and VERBS & set(re.findall(r"\w+", each.contents))


def test_a_zero_that_means_something_else_says_what():
    shown = {o.name: o.absent for s in SOURCES.values() for o in s.options} | {
        option.name: option.absent for option in options()
    }
    assert shown["kerf"] == shown["bore"] == "none"
    edges = {o.absent for s in SOURCES.values() for o in s.options if o.name == "edge"}
    assert edges == {"by the sampling", "for about 600 faces"}
    assert not any("; 0:" in option.meaning for option in options())
