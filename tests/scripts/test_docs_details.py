"""The page of typical details: each dimension keeps its rule and is what the page says."""

import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def details():
    sys.path.insert(0, str(ROOT / "scripts"))
    import docs_details

    yield docs_details
    sys.path.remove(str(ROOT / "scripts"))


def test_dimensions_keep_their_rules_and_the_page_has_them(details):
    found = list(details.dimensions())
    assert [one for one in found if not one.holds] == []
    assert {one.detail for one in found} == set(details.DETAILS)
    page = details.PAGE.read_text(encoding="utf-8")
    assert details.table() in page


def test_page_shows_a_picture_of_each_detail(details):
    page = details.PAGE.read_text(encoding="utf-8")
    for name in details.DETAILS:
        folder = "details/" if name in details.DRAWN else "node-"
        picture = f"pictures/{folder}{name}.png"
        assert f"({picture})" in page
        assert (ROOT / "docs" / picture).stat().st_size > 10_000
