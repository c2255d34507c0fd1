"""Histograms of the report: bars beside each other, as tall as there are parts of that value."""

import re
from xml.etree import ElementTree

import pytest

from freecad_ortho.fabrication.report.plots import histogram

SVG = "{http://www.w3.org/2000/svg}"


def drawn(*values, limit=None):
    text = histogram("length", "mm", values, limit)
    return ElementTree.fromstring(re.search("<svg.*</svg>", text)[0])


def test_bars_stand_in_their_bins():
    """24 bins of 12.5 over 0 to 24 mm, the tallest 120 high."""
    bars = drawn(0.0, 0.5, 12.2, 24.0).findall(f"{SVG}rect")
    numbers = [[float(bar.get(name)) for name in ("x", "y", "width", "height")] for bar in bars]
    assert numbers == [[0, 0, 11.5, 120], [150, 60, 11.5, 60], [287.5, 60, 11.5, 60]]
    assert [bar[0].text for bar in bars] == ["2 parts", "1 parts", "1 parts"]


@pytest.mark.parametrize(("limit", "at"), [(6.0, ["M75.0 0V120"]), (25.0, []), (None, [])])
def test_the_limit_is_drawn_where_it_is_in_sight(limit, at):
    lines = drawn(0.0, 24.0, limit=limit).findall(f"{SVG}path[@class='limit']")
    assert [line.get("d") for line in lines] == at


def test_equal_values_have_a_bar_in_the_middle():
    (bar,) = drawn(5.0, 5.0).findall(f"{SVG}rect")
    assert 137 <= float(bar.get("x")) <= 150
