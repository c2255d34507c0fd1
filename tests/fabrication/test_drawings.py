"""Drawings for the office, read back by a library that did not write them."""

import re
from ctypes import c_uint
from unittest.mock import Mock

import numpy as np
import pytest
import shapely

from freecad_ortho.fabrication import Beams, Lamellas, Panels, Workshop, build
from freecad_ortho.fabrication.drawing_form import PAPERS, SCALES, scale_for
from freecad_ortho.fabrication.exchange.drawings import write_drawings
from freecad_ortho.fabrication.exchange.drawings.node_detail import typical_node
from freecad_ortho.fabrication.exchange.drawings.part_detail import _VIEWS, typical_parts
from freecad_ortho.fabrication.exchange.drawings.pen import Pen
from freecad_ortho.fabrication.exchange.outlines import seen_lines
from freecad_ortho.fabrication.formats import FORMATS
from freecad_ortho.fabrication.production import produce
from freecad_ortho.fabrication.report.pictures import silhouettes
from freecad_ortho.fabrication.site import Selection
from freecad_ortho.fabrication.systems.nodes import Nodes
from freecad_ortho.fabrication.tables import lists
from solver.errors import InputError
from solver.mesh.quadmesh import QuadMesh
from tests.meshes import grid

pytestmark = pytest.mark.skipif(
    FORMATS["drawings"].missing, reason="needs the packages of requirements-exchange.txt"
)
POINTS = 72 / 25.4


class Drawn(Pen):
    """Keeps the lines that are drawn."""

    def __init__(self):
        self.kept = []

    def lines(self, lines, *_, **__):
        self.kept += lines

    def text(self, *_, **__):
        pass


def test_a_line_goes_through_all_of_its_points():
    canvas = Mock()
    Pen(canvas).lines([np.array([[0.0, 0.0], [10.0, 0.0], [10.0, 5.0]]) / POINTS])
    path = canvas.beginPath.return_value
    points = [one.args for one in (*path.moveTo.mock_calls, *path.lineTo.mock_calls)]
    np.testing.assert_allclose(points, [(0.0, 0.0), (10.0, 0.0), (10.0, 5.0)])


def test_views_of_parts_turn_them_and_mirror_none():
    for words, rows in _VIEWS.items():
        np.testing.assert_allclose(rows @ rows.T, np.eye(3), err_msg=words)
        assert np.linalg.det(rows) == pytest.approx(1.0), words


@pytest.mark.parametrize("turn", [90.0, -90.0])
def test_arrows_of_an_angle_stand_at_both_ends_and_point_at_them(turn):
    pen = Drawn()
    pen.angle(np.zeros(2), 0.0, turn, 20.0, "90")
    ring, *strokes = pen.kept
    ends = np.array([[20.0, 0.0], [0.0, np.sign(turn) * 20.0]])
    np.testing.assert_allclose(ring[[0, -1]], ends, atol=1e-12)
    for end, pair in zip(ends, (strokes[:2], strokes[2:]), strict=True):
        # From the tip back into the arc, one stroke within the circle and one without.
        back = ring[16] - end
        for tip, tail in pair:
            np.testing.assert_allclose(tip, end, atol=1e-12)
            assert (tail - tip) @ back > 0
        assert min(np.linalg.norm(tail) for _, tail in pair) < 20.0


def drawn(job, path, **options):
    import pypdfium2

    production = produce(job, Workshop(sheet=(12000, 4000), **options))
    write_drawings(path, production, 'Dach "ü" / 7', lambda done: None)
    pages = {}
    for page in pypdfium2.PdfDocument(path):
        text = page.get_textpage()
        words = text.get_text_range().replace("\r", "")
        number = re.search(r"drawing\n(\S+)", words)[1]
        pages[number] = (page, text, words)
    return production, pages


@pytest.fixture(scope="module")
def framed(roof, tmp_path_factory):
    job = build(roof, [Nodes(), Beams(200, 20, ends="hub"), Panels(12, 10)])
    path = tmp_path_factory.mktemp("drawings") / "a.pdf"
    return (*drawn(job, path, date="1 May"), path)


def numbers_in(words):
    return {float(word) for word in re.findall(r"(?<![\d.])-?\d+\.\d(?![\d.])", words)}


def place_of(text, words):
    """Where a line of text begins on its page, mm; of the first one of these words."""
    found = text.search(words).get_next()
    assert found is not None, words
    box = text.get_charbox(found[0])
    return np.array(box[:2]) / POINTS


def outlines_on(page):
    """How many parts are seen on a page: what is filled in their light grey."""
    import pypdfium2.raw

    count = 0
    for each in page.get_objects(filter=[pypdfium2.raw.FPDF_PAGEOBJ_PATH]):
        colour = [c_uint() for _ in range(4)]
        pypdfium2.raw.FPDFPageObj_GetFillColor(each.raw, *colour)
        count += [one.value for one in colour[:3]] == [245] * 3
    return count


def test_all_that_is_written_stands_on_the_page_and_fields_below_each_other(framed):
    for number, (page, text, _) in framed[1].items():
        boxes = np.array([text.get_charbox(k) for k in range(text.count_chars())]) / POINTS
        assert (boxes.reshape(-1, 2).min(axis=0) >= 0.0).all(), number
        size = np.array([page.get_width(), page.get_height()]) / POINTS
        assert (boxes.reshape(-1, 2).max(axis=0) <= size).all(), number
        fields = ("project", 'Dach "ü"', "title", "scale", "1:")
        heights = [place_of(text, words)[1] for words in fields]
        assert heights == sorted(heights, reverse=True), number


def test_pages_have_their_paper_and_number(framed):
    production, pages, _ = framed
    kinds = len({part.kind for part in production.structure.parts})
    assert len(pages) == 1 + len(production.sheets) + 1 + kinds
    for number, (page, _, words) in enumerate(pages.values(), start=1):
        size = np.array([page.get_width(), page.get_height()]) / POINTS
        np.testing.assert_allclose(size, PAPERS["a3"], atol=1e-3)
        for word in ('Dach "ü" / 7', "1 May", f"{number} / {len(pages)}"):
            assert word in words
        assert int(re.search(r"1:(\d+)", words)[1]) in SCALES


def test_dimensions_of_parts_are_those_of_the_list(framed):
    production, pages, _ = framed
    columns, rows = lists(production)["parts"]
    listed = {row[0]: dict(zip(columns, row, strict=True)) for row in rows}
    chosen = typical_parts(production)
    assert {part.kind for part, _ in chosen} == {row["kind"] for row in listed.values()}
    for part, alike in chosen:
        row, words = listed[part.name], pages[f"PART-{part.name}"][2]
        assert sum(each["equal_to"] == part.name for each in listed.values()) == alike
        seen = numbers_in(words)
        if part.pattern is not None:
            assert round(float(row["length_mm"]), 1) in seen
            assert round(float(row["width_mm"]), 1) in seen
            corners = part.pattern.outline
            if len(corners) <= 8:
                sides = np.abs(np.roll(corners, -1, axis=0) - corners)
                # What is written aslant this reader does not find.
                straight = sides[(sides.min(axis=1) < 1e-6) & (sides.max(axis=1) > 200)]
                assert len(straight)
                assert {round(float(side.max()), 1) for side in straight} <= seen
            assert f"thickness {float(row['thickness_mm']):g}" in words
        assert f"{float(row['mass_kg']):.2f} kg" in words


def test_the_node_has_the_angles_of_the_list(framed):
    production, pages, _ = framed
    node = typical_node(production)
    columns, rows = lists(production)["nodes"]
    row = next(dict(zip(columns, row, strict=True)) for row in rows if row[0] == node.name)
    words = pages[f"NODE-{node.name}"][2]
    for angle in row["angles_deg"].split():
        assert f"{float(angle):.2f}\N{DEGREE SIGN}" in words
    for other in row["neighbours"].split():
        assert f"to N{int(other):04d}" in words
    assert ", ".join(f"{float(row[f'{k}_mm']):.1f}" for k in "xyz") in words


def five_sectors(count=3, size=3000.0):
    """A level pentagon of five times ``count`` x ``count`` quads that meet at one inner vertex."""
    turns = 2 * np.pi / 5 * np.arange(6)
    rim = size * np.stack([np.cos(turns), np.sin(turns), 0 * turns], axis=1)
    u, v = (each[..., None] for each in np.meshgrid(*[np.linspace(0, 1, count + 1)] * 2))
    points, faces = [], []
    for k in range(5):
        corner = (rim[k] + rim[k + 1]) / 1.6
        patch = u * (1 - v) * rim[k] + u * v * corner + (1 - u) * v * rim[k + 1]
        number = np.arange((count + 1) ** 2).reshape(count + 1, -1) + k * (count + 1) ** 2
        sides = number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]
        faces.append(np.stack(sides, axis=2).reshape(-1, 4))
        points.append(patch.reshape(-1, 3))
    _, first, place = np.unique(
        np.round(np.concatenate(points), 6), axis=0, return_index=True, return_inverse=True
    )
    return QuadMesh(np.concatenate(points)[first], place.ravel()[np.concatenate(faces)])


def test_an_irregular_node_is_not_the_typical_one():
    production = produce(build(five_sectors(), [Beams(100, 10)]))
    meeting = [len(node.neighbours) for node in production.nodes]
    assert max(meeting) == 5
    assert len(typical_node(production).neighbours) == 4


def test_the_plan_is_to_scale(framed):
    production, pages, _ = framed
    _, text, words = pages["PLAN"]
    assert "seen along y" in words, "a net that stands upright is seen from its side"
    scale = int(re.search(r"1:(\d+)", words)[1])
    points = production.structure.site.mesh.vertices[:, [0, 2]]
    shown = ["N0005", "N0015", "N0055", "N0029"]
    places = np.array([place_of(text, name) for name in shown])
    wanted = points[[int(name[1:]) for name in shown]] / scale
    np.testing.assert_allclose(places - places[0], wanted - wanted[0], atol=0.05)
    for line in production.structure.site.lines.all:
        assert f"{line.family}{line.number}" in words.split()
    used = points[[node.vertex for node in production.nodes]]
    assert set(np.round(np.ptp(used, axis=0), 1).tolist()) <= numbers_in(words)


def test_every_sheet_has_a_page_with_its_parts(framed):
    production, pages, _ = framed
    for sheet in production.sheets:
        words = pages[sheet.name.upper()][2]
        assert all(placed.name in words for placed in sheet.placements)
        assert sheet.file_name in words
        assert {sheet.width, sheet.height} <= numbers_in(words)


def test_numbers_that_have_no_room_go_on_in_pieces(tmp_path):
    count = 40
    x, y = np.meshgrid(np.arange(count), np.arange(count), indexing="ij")
    points = np.stack([x, y, 0.02 * (x**2 - y**2)], axis=-1).reshape(-1, 3) * 1000.0
    number = np.arange(count**2).reshape(count, count)
    faces = np.stack([number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]], axis=-1)
    net = QuadMesh(points, faces.reshape(-1, 4))
    job = build(net, [Beams(100, 10)], selection=Selection("u", (0, 20, 39)))
    production, pages = drawn(job, tmp_path / "b.pdf", paper="a4")
    pieces = [words for number, (_, _, words) in pages.items() if number.startswith("PLAN-")]
    for number, (page, _, _) in pages.items():
        assert outlines_on(page) or not number.startswith("PLAN"), number
    assert f"PLAN-1 to PLAN-{len(pieces)}" in pages["PLAN"][2]
    found = sorted(name for words in pieces for name in re.findall(r"N\d{4}", words))
    assert found == sorted(node.name for node in production.nodes)


def test_plans_of_trimmed_nets_end_at_the_border(tmp_path):
    x, y = np.meshgrid(np.arange(8.0), np.arange(9.0))
    net = grid(x, y, 0 * x).scaled(1000.0)
    rim = np.array([(600, 800, 0), (6300, 800, 0), (6300, 7500, 0), (600, 7500, 0)], dtype=float)
    job = build(net, [Beams(100, 10), Panels(12, 10)], border=[rim])
    _, pages = drawn(job, tmp_path / "t.pdf", paper="a4")
    _, text, words = pages["PLAN"]
    spread = np.concatenate([part.origin + part.body.points @ part.frame for part in job.parts])
    assert set(np.round(np.ptp(spread[:, :2], axis=0), 1).tolist()) <= numbers_in(words)
    assert len(re.findall(r"N\d{4}", words)) == 6 * 7, "nodes beyond the border are not shown"
    # Both ends of a line have its name just outside of the border.
    scale = int(re.search(r"1:(\d+)", words)[1])
    assert "overall sizes of all parts" in words
    found = text.search("u3", match_whole_word=True)
    places = [text.get_charbox(at[0])[0] / POINTS * scale for at in iter(found.get_next, None)]
    assert len(places) == 2


def test_what_is_put_together_from_pieces_has_one_outline():
    square = np.array([(0, 0), (1, 0), (1, 1), (0, 1)], dtype=float)
    around = [(0, 0), (1, 0), (2, 0), (0, 1), (2, 1), (0, 2), (1, 2), (2, 2)]
    clouds = [square + [1e6 + x, -1e6 + y] for x, y in around] + [square, square[:2] * 3]
    found = silhouettes(clouds, [7] * 8 + [3, 5])
    assert sorted(found) == [3, 5, 7]
    areas = [shapely.Polygon(ring).area for ring in found[7]]
    assert areas == pytest.approx([9, 1], abs=1e-4)
    assert [shapely.Polygon(ring).area for ring in found[3]] == pytest.approx([1])
    assert len(found[5][0]) == 2, "what is seen from its narrow side is a line"


def test_bent_and_round_things_are_drawn(roof, tmp_path):
    some = Selection(family="u", lines=(0, 3))
    job = build(roof, [Lamellas(60, 4, hole=9)], selection=some)
    production, pages = drawn(job, tmp_path / "c.pdf", paper="a0")
    (part, _) = typical_parts(production)[0]
    words = pages[f"PART-{part.name}"][2]
    bends = [f"{bend.angle_deg:.2f}" for bend in part.pattern.bends]
    assert f"from the left: {', '.join(bends[:12])}" in words.replace("\n", "")
    assert round(part.length, 1) in numbers_in(words)


def test_what_is_behind_is_not_seen():
    import cadquery

    front = cadquery.Workplane().box(10, 10, 10).val()
    behind = cadquery.Workplane().box(4, 4, 4).translate((0, 0, -20)).val()
    beside = cadquery.Workplane().box(4, 4, 4).translate((20, 0, -20)).val()
    lines = seen_lines([each.wrapped for each in (front, behind, beside)], np.eye(3))
    ends = np.concatenate(lines)
    assert np.abs(ends[ends[:, 0] < 10]).min(axis=0) == pytest.approx([5, 5])
    np.testing.assert_allclose(ends.max(axis=0), [22, 5])
    length = sum(float(np.linalg.norm(np.diff(line, axis=0), axis=1).sum()) for line in lines)
    assert length == pytest.approx(40 + 16)


def test_same_bytes_twice(framed, tmp_path):
    production, _, path = framed
    write_drawings(tmp_path / "d.pdf", production, 'Dach "ü" / 7', lambda done: None)
    assert (tmp_path / "d.pdf").read_bytes() == path.read_bytes()


def test_scales_are_standard_ones():
    assert scale_for(390.0, 100.0, (400.0, 200.0)) == 1
    assert scale_for(410.0, 100.0, (400.0, 200.0)) == 2
    assert scale_for(41000.0, 100.0, (400.0, 200.0)) == 200


def test_bad_paper_and_dates_are_refused():
    with pytest.raises(InputError, match="paper: expected a4, a3, a2, a1 or a0, got 'a5'"):
        Workshop(paper="a5")
    with pytest.raises(InputError, match="date: expected up to 30 characters"):
        Workshop(date="1 May\n2026")
