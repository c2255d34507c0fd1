"""The report in numbers and for people, and the lists beside it."""

import json
import re
from dataclasses import replace

import pytest

from freecad_ortho.fabrication import Beams, Panels, Workshop, build, write
from freecad_ortho.fabrication.part import measure_words
from freecad_ortho.fabrication.production import produce
from freecad_ortho.fabrication.report import report_page
from tests.fabrication.test_production import table


@pytest.fixture(scope="module")
def written(twisted, tmp_path_factory):
    """A structure with parts beyond the limits, with sheets and stock."""
    folder = tmp_path_factory.mktemp("written")
    structure = build(twisted, [Beams(200, 12)])
    write(structure, folder, workshop=Workshop(sheet=(3000, 1500), stock=5000, kerf=0.4))
    return structure, folder


def test_lists_read_back(written):
    structure, folder = written
    rows = table(folder / "nodes.csv")
    assert [int(row["vertex"]) for row in rows] == list(range(36))
    assert rows[7]["name"] == "N0007"
    assert len(rows[7]["angles_deg"].split()) == len(rows[7]["neighbours"].split()) == 4
    # All of them are cut from sheets.
    assert table(folder / "stock.csv") == []
    for row, part in zip(table(folder / "parts.csv"), structure.parts, strict=True):
        assert row["equal_to"] <= part.name


def test_report_in_numbers(written):
    structure, folder = written
    report = json.loads((folder / "report.json").read_text())
    assert report["kerf_mm"] == 0.4
    assert report["sheets"]["parts"] == len(structure.parts)
    assert 0 < report["sheets"]["waste"] < 1
    assert (report["stock"]["bars"], report["stock"]["length_mm"]) == (0, None)
    failed = report["verdict"]["failed"]
    assert failed and len(failed) + report["verdict"]["passed"] == len(structure.parts)


def test_the_report_counts_every_sheet(plane):
    structure = build(plane, [Panels(20, 15)])
    production = produce(structure, Workshop(sheet=(2500, 1200)))
    found = production.report()["sheets"]
    assert found["count"] == len(production.sheets) == len(found["sheets"]) > 2
    named = [name for sheet in found["sheets"] for name in sheet["parts"]]
    assert sorted(named) == sorted(part.name for part in structure.parts)
    assert found["parts"] == len(named) > len(found["sheets"][0]["parts"])
    used = sum(part.pattern.area for part in structure.parts)
    assert found["waste"] == pytest.approx(1 - used / (found["count"] * 2500 * 1200))


def test_report_for_people_needs_nothing_else(written):
    structure, folder = written
    page = (folder / "report.html").read_text()
    links = re.findall(r'(?:src|href)="[^"]*"|url\([^)]*\)|@import', page)
    assert links == []
    assert all(f"<td>{part.name}</td>" in page for part in structure.parts)
    failing = json.loads((folder / "report.json").read_text())["verdict"]["failed"]
    over = sum(verdict != "ok" for verdict in structure.verdicts)
    assert (f"{over} of {len(structure.parts)} parts exceed a limit" in page) == bool(over)
    assert re.search(r"Clashes: \d+ times two beams, at worst B\d{4} and B\d{4} by", page)
    assert page.count('<tr class="bad">') == len(failing)
    assert page.count('class="bad" d=') == 2 * len(failing)
    assert "twist, deg" in page and "Sheets" in page
    assert "come near each other" in page


def test_page_is_well_formed(written):
    from html.parser import HTMLParser

    class Checker(HTMLParser):
        def __init__(self):
            super().__init__()
            self.open = []

        def handle_starttag(self, tag, attributes):
            if tag not in ("meta",):
                self.open.append(tag)

        def handle_endtag(self, tag):
            assert self.open.pop() == tag

        def handle_startendtag(self, tag, attributes):
            pass

    checker = Checker()
    checker.feed((written[1] / "report.html").read_text())
    assert checker.open == []


def test_bends_read_back(roof, tmp_path):
    structure = build(roof, [Beams(200, 12, ends="through-u")])
    files = write(structure, tmp_path)
    assert tmp_path / "bends.csv" in files
    rows = table(tmp_path / "bends.csv")
    expected = [
        (part.name, number, bend)
        for part in structure.parts
        if part.pattern is not None
        for number, bend in enumerate(part.pattern.bends)
    ]
    assert len(rows) == len(expected) > 0
    for row, (name, number, bend) in zip(rows, expected, strict=True):
        assert (row["part"], int(row["bend"])) == (name, number)
        ends = [float(row[column]) for column in ("x1_mm", "y1_mm", "x2_mm", "y2_mm")]
        assert ends == pytest.approx(bend.points.ravel(), abs=1e-6)
        assert float(row["angle_deg"]) == pytest.approx(bend.angle_deg, abs=1e-6)


def test_no_list_of_bends_for_flat_plates(written):
    assert not (written[1] / "bends.csv").exists()


def test_a_long_report_ends_its_lists_and_names_the_files(plane, tmp_path):
    """Groups first, then the parts that fail, then some of the others."""
    structure = build(plane, [Beams(200, 30), Panels(20, 15)])
    parts = list(structure.parts)
    parts[-1] = replace(parts[-1], measures=replace(parts[-1].measures, gap_mm=7.0))
    many = [
        replace(part, name=f"{part.name}-{k}", origin=part.origin + [0, 0, 5000.0 * k])
        for k in range(4)
        for part in parts
    ]
    result = replace(structure.results["panels"], parts=tuple(many))
    page = report_page(produce(replace(structure, results={"panels": result})))
    assert page.index("Parts in groups") < page.index("Measures") < page.index("<h2>Parts</h2>")
    rows = page[page.index("<h2>Parts</h2>") :].split("<tr")[2:]
    assert len(rows) == 60 and len(many) > 100
    assert ['class="bad"' in row for row in rows] == [True] * 4 + [False] * 56
    assert f"<p>{len(many) - 60} more parts: all are in parts.csv.</p>" in page
    count = {kind: sum(part.kind == kind for part in many) for kind in ("beam", "panel")}
    assert f"<td>beam</td><td>steel</td><td>30</td><td>{count['beam']}</td>" in page
    assert f"<td>panel</td><td>steel</td><td>20</td><td>{count['panel']}</td>" in page


def test_units_of_measures_in_words():
    assert measure_words("torsion_deg_per_m") == ("torsion", "deg/m")
    assert measure_words("min_bend_radius_mm") == ("min bend radius", "mm")
    assert measure_words("stress_MPa") == ("stress", "MPa")


def test_the_page_calls_rests_of_rounding_nothing(roof, tmp_path):
    write(build(roof, [Beams(200, 20)]), tmp_path)
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    table = page[page.index('<div class="parts">') :]
    assert "<th>bearing, mm</th>" not in table, "no beam bears on anything"
    numbers = [float(cell) for cell in re.findall(r"<td>(-?[\d.]+(?:e-?\d+)?)</td>", table)]
    assert numbers
    assert all(number == 0 or abs(number) >= 1e-9 for number in numbers)
