"""Drawings of drilled nodes: each type has a page with the numbers of its list, drawn to scale."""

import re

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.fabrication import Workshop
from freecad_ortho.fabrication.drawing_form import PAPERS, DrawingForm
from freecad_ortho.fabrication.exchange.drawings import write_drawings
from freecad_ortho.fabrication.exchange.drawings.hole_detail import hole_pages
from freecad_ortho.fabrication.exchange.drawings.page import room_of
from freecad_ortho.fabrication.exchange.drawings.pen import Pen
from freecad_ortho.fabrication.formats import FORMATS
from freecad_ortho.fabrication.production import produce

pytestmark = pytest.mark.skipif(
    FORMATS["drawings"].missing, reason="needs the packages of requirements-exchange.txt"
)
KINDS = {"bolted": "tube:160x80x5", "ball": "chs:88.9x5"}


class Drawn(Pen):
    """Keeps what is told by circles, dimensions and texts."""

    def __init__(self):
        self.circles, self.dimensions, self.texts, self.points = [], [], [], []

    def lines(self, lines, *_, **__):
        self.points += [np.asarray(line) for line in lines]

    def circle(self, at, radius, *_, **__):
        self.circles.append((np.asarray(at), radius))

    def text(self, words, at, *_, **__):
        self.texts.append(words)
        self.points.append(np.asarray(at)[None])

    def dimension(self, one, two, away, words):
        self.dimensions.append((float(np.linalg.norm(two - one)), float(words)))


@pytest.fixture(scope="module", params=KINDS)
def production(request, roof):
    made = api.fabricate(roof, "beams+nodes", node=request.param, section=KINDS[request.param])
    return produce(made, Workshop())


def table_of(production):
    results = production.structure.results.values()
    [table] = [each for result in results for each in result.tables if "holes" in each.name]
    return table


def drawn(page, form):
    pen = Drawn()
    page.draw(pen, *room_of(form, len(page.notes)))
    return pen, int(page.scale.partition(":")[2])


@pytest.mark.parametrize("paper", ["a3", "a4"])
def test_each_type_has_a_page_with_the_rows_of_the_list(production, paper):
    form = DrawingForm(paper)
    table, pages = table_of(production), hole_pages(production, form)
    groups = production.groups.shapes["node"]
    assert len(pages) == len(groups) > 1
    assert {page.number.partition("-")[2] for page in pages} == {group[0] for group in groups}
    sizes = [
        int(found[1]) if (found := re.search(r"(\d+) alike", page.title)) else 1 for page in pages
    ]
    assert sizes == sorted((len(group) for group in groups), reverse=True)
    for page in pages:
        rows = [row for row in table.rows if row[0] == page.number.partition("-")[2]]
        pen, _ = drawn(page, form)
        for row in rows:
            for cell in row[1:]:
                assert str(cell) in pen.texts
        points = np.concatenate(pen.points)
        assert (points >= 0.0).all()
        assert (points <= np.array(PAPERS[paper])).all()


def test_holes_and_their_dimensions_are_to_scale(production):
    table, form = table_of(production), DrawingForm()
    for page in hole_pages(production, form):
        rows = [row for row in table.rows if row[0] == page.number.partition("-")[2]]
        pen, scale = drawn(page, form)
        for length, words in pen.dimensions:
            assert length * scale == pytest.approx(words, abs=0.06)
        told = [words for _, words in pen.dimensions]
        if page.number.startswith("HUB"):
            column = table.columns.index
            assert len(pen.circles) == len(rows)
            for row, (_, radius) in zip(rows, pen.circles, strict=True):
                assert 2 * radius * scale == pytest.approx(float(row[column("hole_mm")]))
            for name in ("from_lower_mm", "face_mm"):
                for row in rows:
                    assert any(abs(float(row[column(name)]) - each) < 0.06 for each in told)
        else:
            (_, radius), *_ = pen.circles
            assert 2 * radius * scale == pytest.approx(float(rows[0][1]))
            assert sorted(told) == sorted([round(float(rows[0][7]), 1), float(rows[0][10])])
            assert (
                f"{rows[0][8]}, drilled \N{LATIN CAPITAL LETTER O WITH STROKE}{rows[0][9]}"
                in pen.texts
            )


def test_faces_of_hubs_are_as_wide_as_those_of_the_solid(production):
    for page in hole_pages(production, DrawingForm()):
        if page.number.startswith("BALL"):
            continue
        [part] = [
            each
            for each in production.structure.parts
            if each.name == page.number.partition("-")[2]
        ]
        pen, scale = drawn(page, DrawingForm())
        outer = part.body.whole.outer
        sides = np.linalg.norm(outer - np.roll(outer, 1, axis=0), axis=1)
        boxes = [line for line in pen.points if line.shape == (4, 2) and line[0, 1] == line[1, 1]]
        drilled = {row[2] for row in table_of(production).rows if row[0] == part.name}
        high = [box for box in boxes if np.ptp(box[:, 1]) * scale > part.length - 1e-6]
        assert len(high) == len(drilled)
        for box in high:
            assert np.abs(sides - np.ptp(box[:, 0]) * scale).min() < 1e-6


def test_they_stand_in_the_file_with_the_others(production, tmp_path):
    import pypdfium2

    write_drawings(tmp_path / "a.pdf", production, "roof", lambda done: None)
    words = [
        page.get_textpage().get_text_range() for page in pypdfium2.PdfDocument(tmp_path / "a.pdf")
    ]
    first = table_of(production).rows[0]
    [page] = [each for each in words if f"-{first[0]}" in each and "azimuth_deg" in each]
    assert all(str(cell) in page for cell in first)
