"""Sheets of labels: every label where the sheet has it, read by a reader of QR codes."""

from collections import Counter
from dataclasses import replace

import numpy as np
import pytest

from freecad_ortho.fabrication import Beams, Workshop, build
from freecad_ortho.fabrication.exchange.labels import write_labels
from freecad_ortho.fabrication.label_form import label_form
from freecad_ortho.fabrication.production import produce
from solver.errors import InputError

# Labels as their makers tell them: size, margins left and above, from one label to the next, mm.
SOLD = {
    "3x8": (70, 36, 0, 4.5, 70, 36),
    "a4-3x7": (63.5, 38.1, 7.25, 15.15, 66, 38.1),
    "2x7": (99.1, 38.1, 4.65, 15.15, 101.6, 38.1),
    "2x4": (99.1, 67.7, 4.65, 13.1, 101.6, 67.7),
    "4x10": (48.5, 25.4, 8, 21.5, 48.5, 25.4),
    "5x13": (38.1, 21.2, 4.75, 10.7, 40.6, 21.2),
    "Letter-3x10": (66.675, 25.4, 4.7625, 12.7, 69.85, 25.4),
    "letter-2x7": (101.6, 33.867, 3.96875, 21.167, 106.3625, 33.867),
    "letter-2x5": (101.6, 50.8, 3.96875, 12.7, 106.3625, 50.8),
}
# One's own: 210 - 2 x 6 - 2 x 3 are three of 64 mm, 297 - 2 x 10 - 7 x 2 eight of 32.875.
OWN = {"3x8:6x10:3x2": (64, 32.875, 6, 10, 67, 34.875)}
ALL = SOLD | OWN
SIDES = ("left", "right")


@pytest.fixture(scope="module")
def production(roof):
    return produce(build(roof, [Beams(200, 20)]))


@pytest.mark.parametrize("words", ALL)
def test_sheets_are_as_they_are_sold(words):
    form, (width, height, left, above, across, down) = label_form(words), ALL[words]
    np.testing.assert_allclose(form.size, (width, height), rtol=0, atol=1e-3)
    first, beside = form.corner(0), form.corner(1)
    below = form.corner(form.columns)
    np.testing.assert_allclose(first[0], left, rtol=0, atol=1e-3)
    np.testing.assert_allclose(form.paper[1] - first[1] - form.size[1], above, rtol=0, atol=1e-3)
    np.testing.assert_allclose(beside[0] - first[0], across, rtol=0, atol=1e-3)
    np.testing.assert_allclose(first[1] - below[1], down, rtol=0, atol=1e-3)
    # As far from the other side.
    last = form.corner(form.count - 1)
    assert last[0] + width == pytest.approx(form.paper[0] - left, abs=1e-3)
    assert last[1] == pytest.approx(above, abs=1e-3)


@pytest.mark.parametrize("words", ["3x8", "2x4", "4x10", "5x13", "letter-3x10", *OWN])
def test_labels_are_read_where_they_are(production, tmp_path, words):
    pdfium, zxing = pytest.importorskip("pypdfium2"), pytest.importorskip("zxingcpp")
    pytest.importorskip("reportlab")
    shop = replace(production.workshop, label_sheet=words)
    path = tmp_path / "labels.pdf"
    write_labels(path, replace(production, workshop=shop), 'Dach "ü"', lambda done: None)
    pages, form = pdfium.PdfDocument(path), label_form(words)
    names = [part.name for part in production.structure.parts]
    assert len(pages) == -(-len(names) // form.count)
    dots = 200 / 72
    np.testing.assert_allclose(
        pages[0].get_size(), np.array(form.paper) * 72 / 25.4, rtol=0, atol=0.01
    )
    found = zxing.read_barcodes(pages[0].render(scale=dots).to_pil())
    seen = {}
    for code in found:
        corners = [getattr(code.position, f"{a}_{b}") for a in ("top", "bottom") for b in SIDES]
        seen[code.text] = np.array([(each.x, each.y) for each in corners]) * 25.4 / 200
    assert len(found) == len(seen)
    assert set(seen) == set(names[: form.count])
    for number, name in enumerate(names[: form.count]):
        x, y = form.corner(number)
        top = form.paper[1] - y - form.size[1]
        inside = seen[name] - [x, top]
        assert (inside > 0.5).all()
        assert (inside < np.array(form.size) - 0.5).all()


@pytest.mark.parametrize("words", ["4x10", "5x13", "2x4"])
def test_no_two_texts_of_a_label_overlap(production, tmp_path, words):
    pdfium = pytest.importorskip("pypdfium2")
    pytest.importorskip("reportlab")
    shop = replace(production.workshop, label_sheet=words)
    path = tmp_path / "labels.pdf"
    write_labels(path, replace(production, workshop=shop), "Roof", lambda done: None)
    page = pdfium.PdfDocument(path)[0]
    texts = page.get_textpage()
    boxes = np.array([texts.get_rect(k) for k in range(texts.count_rects())])
    words_of = Counter(texts.get_text_range().split())
    assert words_of["Roof"] == words_of["beside"] == label_form(words).count
    low, high = boxes[:, None, :2], boxes[:, None, 2:]
    both = np.minimum(high, boxes[None, :, 2:]) - np.maximum(low, boxes[None, :, :2])
    over = (both > 0.3).all(axis=2) & ~np.eye(len(boxes), dtype=bool)
    assert not over.any()


def test_what_no_sheet_is_said():
    for words, said in (
        ("3x9", r"label sheet: expected 3x8, 3x7, .*margins in mm as 3x9:5x12, got '3x9'"),
        ("a5-3x8", "got 'a5-3x8'"),
        ("9x30:5x5", r"would be 22.22 x 9.567 mm, and need 35 x 15"),
        ("0x3:5x5", "would be 0 x "),
        ("3x8:200x5", "would be 0 x 35.88 mm"),
    ):
        with pytest.raises(InputError, match=said):
            Workshop(label_sheet=words)
