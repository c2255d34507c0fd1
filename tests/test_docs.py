"""The documents stay true: links lead somewhere, nets and measures and options are all named."""

import re

import pytest

from freecad_ortho.cli import commands
from freecad_ortho.fabrication.tables import COLUMNS
from solver.analysis.check import MEASURES
from solver.nets import RECIPES
from tests.conftest import ROOT

DOCUMENTS = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]


def text(name):
    return (ROOT / name).read_text(encoding="utf-8")


@pytest.mark.parametrize("path", DOCUMENTS, ids=lambda path: path.name)
def test_links_lead_to_files(path):
    links = re.findall(r"\]\(([^)#]+)", path.read_text(encoding="utf-8"))
    for link in links:
        if not link.startswith("https://"):
            assert (path.parent / link).is_file(), link


def test_every_net_and_measure_is_explained():
    rows = set(re.findall(r"^\| `?([a-z- ]+)`? \|", text("docs/nets.md"), re.MULTILINE))
    assert set(RECIPES) <= rows, "a net is missing in docs/nets.md"
    assert {name for name, *_ in MEASURES} <= rows, "a measure is missing in docs/nets.md"


def test_every_net_has_its_picture_and_numbers():
    document = text("docs/nets.md")
    sections = set(re.findall(r"^### ([a-z-]+)$", document, re.MULTILINE))
    pictures = set(re.findall(r"\(pictures/nets/([a-z-]+)\.png\)", document))
    table = document.split("<!-- examples table: begin -->")[1].split("<!-- examples table: end")[0]
    numbers = set(re.findall(r"^\| ([a-z-]+) \|", table, re.MULTILINE))
    assert set(RECIPES) <= sections & pictures & numbers


def test_every_column_is_explained():
    assert all(f"`{column}`" in text("docs/fabrication.md") for column in COLUMNS)


def options_of(command, capsys):
    with pytest.raises(SystemExit):
        commands.run([command, "--help"])
    return set(re.findall(r"(?<![\w-])--[a-z][a-z-]+", capsys.readouterr().out))


def every_command(capsys):
    with pytest.raises(SystemExit):
        commands.run(["--help"])
    return re.search(r"\{([a-z,-]+)\}", capsys.readouterr().out)[1].split(",")


def test_every_option_is_named(capsys):
    for command in ("optimise", "fabricate", "check"):
        for option in options_of(command, capsys) - {"--help", "--verbose", "--output"}:
            documents = "".join(path.read_text(encoding="utf-8") for path in DOCUMENTS)
            assert option in documents, f"{command} {option} is in no document"


def test_options_that_are_named_exist(capsys):
    known = {"--mesh", "--help", "--write", "--quick"}  # of the scripts
    for command in every_command(capsys):
        known |= options_of(command, capsys)
    for path in DOCUMENTS:
        named = set(re.findall(r"(?<![\w<-])--[a-z][a-z-]+", path.read_text(encoding="utf-8")))
        assert named <= known, path.name
