"""Add-on, Python package and pins agree; icons are as they say; no merge is left half done."""

import re
import xml.etree.ElementTree as ElementTree

import pytest

import freecad_ortho
from tests.conftest import ROOT

SPACE = {"p": "https://wiki.freecad.org/Package_Metadata"}
PACKAGE = ElementTree.parse(ROOT / "package.xml").getroot()


def text(path):
    return PACKAGE.find(path, SPACE).text


def test_add_on():
    assert text("p:version") == freecad_ortho.__version__
    assert text("p:license") == "LGPL-2.1-or-later"
    assert (ROOT / PACKAGE.find("p:license", SPACE).get("file")).is_file()
    assert (ROOT / text("p:icon")).is_file()
    workbench = PACKAGE.find("p:content/p:workbench", SPACE)
    name = workbench.find("p:classname", SPACE).text
    assert f"class {name}(" in (ROOT / "InitGui.py").read_text(encoding="utf-8")


def test_dependencies():
    project = pytest.importorskip("tomllib").loads((ROOT / "pyproject.toml").read_text())["project"]
    extras = project["optional-dependencies"]
    depends = {item.text for item in PACKAGE.findall("p:depend", SPACE)}
    assert depends == names([*project["dependencies"], *extras["fabrication"]])
    files = {"requirements": depends} | {
        f"requirements-{extra}": names(extras[extra]) for extra in ("exchange", "fast", "remesh")
    }
    for name, wanted in files.items():
        pins = (ROOT / f"{name}.txt").read_text(encoding="utf-8")
        assert wanted <= set(re.findall(r"^([\w.-]+)==", pins, re.MULTILINE)), name


def names(requirements):
    return {re.match(r"[\w.-]+", item)[0] for item in requirements}


def test_icons_are_64_by_64():
    icons = sorted((ROOT / "freecad_ortho" / "resources" / "icons").glob("*.svg"))
    assert len(icons) >= 7
    for path in icons:
        image = ElementTree.parse(path).getroot()
        assert (image.get("width"), image.get("height")) == ("64", "64"), path


WRITTEN = {".py", ".md", ".ts", ".txt", ".toml", ".xml", ".sh", ".yml", ".html", ".css", ".svg"}


def left_by_a_merge(folder):
    """Lines of texts in there, hidden folders apart, that are marks of a merge: file and number."""
    return [
        f"{path.relative_to(folder)}:{number}"
        for place in (folder, *folder.glob("[!.]*/"))
        for path in sorted(place.glob("*" if place == folder else "**/*"))
        if path.suffix in WRITTEN and path.is_file()
        for number, line in enumerate(
            path.read_text(encoding="utf-8", errors="replace").splitlines(), 1
        )
        if re.match(r"(<{7}|>{7}|[|]{7}) ", line)
    ]


def test_no_merge_was_left_half_done():
    assert left_by_a_merge(ROOT) == []


def test_a_merge_left_half_done_is_found(tmp_path):
    (tmp_path / "some" / "where").mkdir(parents=True)
    (tmp_path / "clean.md").write_text("a <<<<<<< b\n=======\n<<<<<<<<<\n")
    assert left_by_a_merge(tmp_path) == []
    sides = "<" * 7 + " ours\nyes\n=======\nno\n" + ">" * 7 + " theirs\n"
    (tmp_path / "some" / "where" / "half.ts").write_text(sides)
    (tmp_path / "half.md").write_text(sides)
    assert left_by_a_merge(tmp_path) == [
        *("half.md:1", "half.md:5", "some/where/half.ts:1", "some/where/half.ts:5"),
    ]
