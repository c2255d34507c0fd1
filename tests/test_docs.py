"""The documents stay true: links lead somewhere, nets and measures and options are all named."""

import re
import shlex

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.__main__ import main
from freecad_ortho.cli import commands
from freecad_ortho.fabrication.tables import COLUMNS
from solver.mesh.primitives import primitive
from solver.nets import NETS, all_measures, nets_with, unregister
from solver.nets.options import OPTIONS
from tests.conftest import ROOT
from tests.design_surfaces import saddle, triangles

DOCUMENTS = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]


def text(name):
    return (ROOT / name).read_text(encoding="utf-8")


@pytest.mark.parametrize("path", DOCUMENTS, ids=lambda path: path.name)
def test_links_lead_to_files(path):
    links = re.findall(r"\]\(([^)#]+)", path.read_text(encoding="utf-8"))
    for link in links:
        if not link.startswith("https://"):
            assert (path.parent / link).is_file(), link


def test_every_page_is_reached_from_the_readme():
    reached, ahead = set(), [ROOT / "README.md"]
    while ahead:
        page = ahead.pop()
        reached.add(page)
        links = re.findall(r"\]\(([^)#]+\.md)", page.read_text(encoding="utf-8"))
        pages = {(page.parent / link).resolve() for link in links if "://" not in link}
        ahead += sorted(pages - reached - {*ahead})
    assert set(DOCUMENTS) <= reached


def test_every_net_and_measure_is_explained():
    rows = set(re.findall(r"^\| `?([a-z- ]+)`? \|", text("docs/nets.md"), re.MULTILINE))
    assert set(NETS) <= rows, "a net is missing in docs/nets.md"
    assert set(all_measures()) <= rows, "a measure is missing in docs/nets.md"


def test_tables_of_nets_and_options_say_what_the_table_of_nets_says():
    document = text("docs/nets.md")
    for net in NETS.values():
        assert f"| `{net.name}` | {net.condition} | {net.purpose} |" in document
    rows = [line.split(" | ") for line in document.splitlines() if line.startswith("| `--")]
    for option in OPTIONS.values():
        word = option.name.replace("_", "-")
        (row,) = [row for row in rows if re.search(rf"--{word}\b(?!-)", row[0])]
        assert row[1] == ", ".join(nets_with(option.name)), row


def test_every_net_has_its_picture_and_numbers():
    document = text("docs/nets.md")
    sections = set(re.findall(r"^### ([a-z-]+)$", document, re.MULTILINE))
    pictures = set(re.findall(r"\(pictures/nets/([a-z-]+)\.png\)", document))
    table = document.split("<!-- examples table: begin -->")[1].split("<!-- examples table: end")[0]
    numbers = set(re.findall(r"^\| ([a-z-]+) \|", table, re.MULTILINE))
    assert set(NETS) <= sections & pictures & numbers


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
    known = {"--help"}
    for script in (ROOT / "scripts").iterdir():
        if script.suffix in (".py", ".sh"):
            known |= set(
                re.findall(r"[\"' |](--[a-z][a-z-]+)\b", script.read_text(encoding="utf-8"))
            )
    for command in every_command(capsys):
        known |= options_of(command, capsys)
    for path in DOCUMENTS:
        named = set(re.findall(r"(?<![\w<-])--[a-z][a-z-]+", path.read_text(encoding="utf-8")))
        assert named <= known, path.name


@pytest.fixture
def workplace(tmp_path, monkeypatch):
    """A folder with the files that the commands of the documents begin with."""
    monkeypatch.chdir(tmp_path)
    dome = primitive("translational", 11, 9)
    api.write_mesh("in.obj", dome.with_vertices(dome.vertices - dome.vertices.min(axis=0)), "m")
    api.write_mesh("sheet.obj", primitive("rectangle", 19, 15, length=4.5, width=3.5), "m")
    assert main(shlex.split("multinet --axes 9,5,2 --moving nu --sampling 9x7 -o nearly.obj")) == 0
    api.write_mesh("left.obj", primitive("sphere", 5, 5, angles=(0, 180)), "m")
    api.write_mesh("right.obj", primitive("sphere", 5, 5, angles=(180, 360)), "m")
    cadquery = pytest.importorskip("cadquery")
    hall = cadquery.Workplane().box(24000, 16000, 6000)
    cadquery.exporters.export(hall, "hall.step")
    trimesh = pytest.importorskip("trimesh")
    trimesh.Trimesh(*triangles(saddle, 41, 31)).export("roof.stl")
    (tmp_path / "drawn.txt").write_text("2.9 .2 .1\n2.2 1.4 .4\n1.2 1.7 .8\n.3 1.5 1.1\n")


def test_commands_of_sources_run(workplace):
    lines = re.findall(r"(?:^    |`)ortho ([^`\n]+)", text("docs/sources.md"), re.MULTILINE)
    assert len(lines) >= 20
    for line in lines:
        if not line.startswith("quads"):  # needs a library that is not always there
            assert main(shlex.split(line)) == 0, line


def test_commands_of_nets_run(workplace):
    lines = re.findall(r"^    python -m freecad_ortho (.+)", text("docs/nets.md"), re.MULTILINE)
    assert len(lines) > len(NETS)
    # A dome is no minimal surface: all that would be left of it is a plane.
    minimal = {
        "asymptotic -o": "helicoid",
        "asymptotic --diagonal": "catenoid",
        "asymptotic-angle -o": "helicoid",
    }
    dome = api.read_mesh("in.obj").mesh
    for line in lines:
        found = [primitive(name, 11, 9) for words, name in minimal.items() if words in line]
        api.write_mesh("in.obj", found[0] if found else dome, "m")
        assert main(shlex.split(line)) == 0, line


def test_python_of_nets_runs():
    code = re.search(r"```python\n(.*?)```", text("docs/nets.md"), re.DOTALL)[1]
    found = {"mesh": primitive("rectangle", 19, 15, length=4.5, width=3.5)}
    exec(code, found)
    assert found["session"].settle().report.status == "converged"


def test_a_net_of_your_own_runs_everywhere(tmp_path, monkeypatch, capsys):
    blocks = re.findall(r"```python\n(.*?)```", text("docs/own-net.md"), re.DOTALL)
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    monkeypatch.chdir(tmp_path)
    found = {}
    try:
        exec(blocks[0], found)
        assert capsys.readouterr().out.startswith("incircular net reached: worst ")
        roof = api.read_mesh("incircular.obj").mesh
        corners = roof.vertices[roof.faces]
        sides = np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2)
        assert np.abs(sides @ [1, -1, 1, -1]).max() < 1e-9 * roof.mean_edge
        exec(blocks[1], found)
        error, said = capsys.readouterr().out.splitlines()
        assert float(error) < 1e-8 and said.startswith("own net reached")
        command = "optimise examples/data/demo_roof.obj --net incircular -o out.obj"
        assert main(shlex.split(command)) == 0
        assert (api.read_mesh("out.obj").mesh.vertices == roof.vertices).all()
    finally:
        unregister("incircular")
