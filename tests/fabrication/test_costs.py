"""What is bought and what it costs, read back by another library; several lengths and sizes."""

from dataclasses import replace

import numpy as np
import pytest

from freecad_ortho.fabrication import Beams, Panels, Workshop, build
from freecad_ortho.fabrication.exchange.costs import rectangle_left
from freecad_ortho.fabrication.exchange.spreadsheet import write_xlsx
from freecad_ortho.fabrication.formats import FORMATS
from freecad_ortho.fabrication.prices import read_prices
from freecad_ortho.fabrication.production import produce
from freecad_ortho.fabrication.stock import stock_list
from solver.errors import InputError

needed = pytest.mark.skipif(
    FORMATS["xlsx"].missing, reason="needs the packages of requirements-exchange.txt"
)
PRICES = """item;unit;price
steel;kg;2,40
IPE200;m;31.5  # from the wholesaler
sheet steel 12 mm;m2;190
sheet steel 12 mm;piece;900
"""


@pytest.fixture(scope="module")
def production(roof, tmp_path_factory):
    prices = tmp_path_factory.mktemp("prices") / "prices.csv"
    prices.write_text(PRICES, encoding="utf-8")
    job = build(roof, [Beams(200, 20, section="IPE200"), Panels(12, 10)])
    shop = Workshop(
        sheet=(6000, 3000),
        sheet_sizes="2000x2000, 3000x1500,9000x9000",
        stock=12000,
        stock_lengths="8000,6000,4000",
        prices=str(prices),
    )
    return produce(job, shop)


@pytest.mark.parametrize(("spare", "count"), [(0.5, 1), (-0.5, 2)])
def test_two_parts_share_a_bar_that_has_room_for_their_cuts(production, spare, count):
    part = next(part for part in production.structure.parts if part.kind == "beam")
    shop = Workshop()
    needed = 2 * (part.length + shop.saw + shop.trim)
    shop = Workshop(stock=needed + spare)
    bars = stock_list([part, replace(part, name="B9999")], shop).bars
    assert len(bars) == count
    assert all(bar.used <= bar.length for bar in bars)


@pytest.fixture(scope="module")
def book(production, tmp_path_factory):
    openpyxl = pytest.importorskip("openpyxl")
    path = tmp_path_factory.mktemp("costs") / "lists.xlsx"
    write_xlsx(path, production, "roof", lambda done: None)
    return [openpyxl.load_workbook(path, data_only=values) for values in (True, False)]


def rows_of(page):
    head, *rows = page.values
    return [dict(zip(head, row, strict=True)) for row in rows]


def test_bars_are_as_short_as_their_parts_allow(production):
    sizes = [4000.0, 6000.0, 8000.0, 12000.0]
    lengths = {bar.length for bar in production.bars}
    assert len(lengths) > 1
    for bar in production.bars:
        assert bar.length == min(size for size in sizes if size >= bar.used - 1e-6)
        assert bar.left >= -1e-6
    sawn = sorted(name for bar in production.bars for name in bar.parts)
    assert sawn == sorted(part.name for part in production.structure.parts if part.kind == "beam")
    assert production.report()["stock"]["length_mm"] == max(lengths)


def test_sheets_are_as_small_as_their_parts_allow(production):
    assert {(sheet.width, sheet.height) for sheet in production.sheets} >= {(6000.0, 3000.0)}
    for sheet in production.sheets:
        far = np.concatenate([each.outline for each in sheet.placements]).max(axis=0) + 10
        fits = [
            size
            for size in ((2000.0, 2000.0), (3000.0, 1500.0), (6000.0, 3000.0))
            if (far <= np.array(size) + 1e-6).all()
        ]
        assert (sheet.width, sheet.height) == fits[0]


def test_small_ones_go_on_small_sheets(roof):
    job = build(roof, [Beams(60, 12)])
    plain = produce(job, Workshop(sheet=(6000, 3000)))
    both = produce(job, Workshop(sheet=(6000, 3000), sheet_sizes="2000x1500"))
    assert [sheet.placements[0].name for sheet in both.sheets] == [
        sheet.placements[0].name for sheet in plain.sheets
    ]
    names = {placed.name for sheet in both.sheets for placed in sheet.placements}
    assert names == {part.name for part in job.parts}
    area = sum(sheet.width * sheet.height for sheet in both.sheets)
    assert area <= 6000 * 3000 * len(plain.sheets)
    report = both.report()["sheets"]
    assert report["waste"] == pytest.approx(1 - sum(s.used for s in both.sheets) / area)


@needed
def test_stock_costs_what_the_list_says(production, book):
    values, formulas = book
    rows = rows_of(values["cost of stock"])
    *rows, total = rows
    bars = [row for row in rows if row["item"] == "IPE200"]
    length = sum(bar.length for bar in production.bars) / 1000
    assert sum(row["pieces"] for row in bars) == len(production.bars)
    assert sum(row["amount"] for row in bars) == pytest.approx(length)
    assert sum(row["cost"] for row in bars) == pytest.approx(31.5 * length)
    sheets = [row for row in rows if row["item"].startswith("sheet")]
    area = sum(sheet.width * sheet.height for sheet in production.sheets) * 1e-6
    assert sum(row["amount"] for row in sheets) == pytest.approx(area)
    assert total["cost"] == pytest.approx(31.5 * length + 190 * area)
    page = formulas["cost of stock"]
    assert page["H2"].value == "=F2*G2"
    assert page.cell(page.max_row, 8).value == f"=SUM(H2:H{page.max_row - 1})"
    mass = rows_of(values["mass and cost"])[0]
    assert mass["cost"] == pytest.approx(2.4 * mass["mass kg"])
    assert mass["mass kg"] == pytest.approx(sum(production.structure.masses.values()))


@needed
def test_off_cuts_add_up(production, book):
    rows = rows_of(book[0]["off-cuts"])
    assert [row["from"] for row in rows] == [
        each.name for each in (*production.bars, *production.sheets)
    ]
    left = {bar.name: bar for bar in production.bars}
    for row in rows:
        if row["from"] in left:
            bar = left[row["from"]]
            assert row["left_mm"] == pytest.approx(bar.left, abs=0.06)
            assert row["rest"] == ("kept" if bar.left >= 500 else "scrap")
    for sheet in production.sheets:
        across, up = rectangle_left(sheet)
        far = np.concatenate([each.outline for each in sheet.placements]).max(axis=0)
        assert (across, up) in (
            (sheet.width - far[0], sheet.height),
            (sheet.width, sheet.height - far[1]),
        )


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("steel,kg", "line 1: expected item, unit"),
        ("item,unit,price\nsteel,lb,3", r"line 2: expected item, unit \(kg, m, m2, piece\)"),
        ("steel,kg,-1", "line 1: expected item"),
        ("steel,kg,nan", "line 1: expected item"),
        ("steel,kg,1\nsteel,kg,2", "line 2: steel has a price a kg already; keep one"),
        ("# none\n", "no price in it; write rows as steel,kg,2.40"),
    ],
)
def test_bad_price_lists_are_refused(tmp_path, text, words):
    (tmp_path / "p.csv").write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=words):
        read_prices(tmp_path / "p.csv")


def test_bad_sizes_of_the_store_are_refused(tmp_path):
    with pytest.raises(InputError, match=r"stock lengths: expected mm with commas .*'6 m'"):
        Workshop(stock_lengths="6 m")
    with pytest.raises(InputError, match="sheet: expected WxH in mm"):
        Workshop(sheet_sizes="3000")
    with pytest.raises(InputError, match="no such file"):
        Workshop(prices=str(tmp_path / "none.csv"))
