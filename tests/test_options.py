"""Options are declared once; here: what texts on the command line say of them, their ranges."""

from __future__ import annotations

import argparse
import math

import numpy as np
import pytest

from freecad_ortho.cli import options as arguments
from freecad_ortho.fabrication.systems import SYSTEMS
from freecad_ortho.fabrication.tolerances import Tolerances
from freecad_ortho.fabrication.workshop import Workshop
from freecad_ortho.sources.catalogue import SOURCES
from freecad_ortho.structural.design import Design
from solver import InputError
from solver.mesh import remesh
from solver.nets.options import OPTIONS
from solver.nets.settings import WEIGHTS
from solver.option import (
    NUMBERS,
    POSITIVE,
    Option,
    Range,
    number_within,
    one_of,
    whole_number,
)

LENGTH = Option("edge", 0.0, "length", "Wanted edge length")
ANGLES = Option("angles", (0.0, 360.0), "angle", "First and last angle")
AREA = Option("t_range", (0.0, 0.0), "area", "First and last t")
WORD = Option("quadric", "ellipsoid", "choice", "Kind", ("ellipsoid", "one-sheeted hyperboloid"))
COUNTS = Option("rows", (0, 0, 0, 0), "count", "Rows")
ON = Option("closed", True, "flag", "Closed")


@pytest.mark.parametrize(
    ("option", "text", "unit", "value"),
    [
        (LENGTH, "1.5", "m", 1.5),
        (LENGTH, "1500 mm", "m", 1.5),
        (LENGTH, "1e3mm", "m", 1.0),
        (LENGTH, "2in", "mm", 50.8),
        (ANGLES, "-90, 90deg", "mm", (-90.0, 90.0)),
        (ANGLES, "0,1rad", "m", (0.0, math.degrees(1.0))),
        (AREA, "-1,2m2", "mm", (-1.0, 2e6)),
        (AREA, "0,4000000 mm^2", "m", (0.0, 4.0)),
        (WORD, "one-sheeted", "mm", "one-sheeted hyperboloid"),
        (COUNTS, "1,0,2,0", "mm", (1, 0, 2, 0)),
    ],
)
def test_a_text_says_a_value_in_the_unit_asked_for(option, text, unit, value):
    exact = value if isinstance(value, str) else pytest.approx(value, rel=1e-15)
    assert arguments.read(option, text, unit) == exact


@pytest.mark.parametrize(
    ("option", "text", "words"),
    [
        (LENGTH, "1.5 furlongs", "--edge: expected a finite number, got '1.5 furlongs'"),
        (LENGTH, "2 m2", "--edge: expected a finite number, got '2 m2'"),
        (LENGTH, "1,2", "--edge: expected a finite number"),
        (LENGTH, "1-2m", "--edge: expected a finite number"),
        (ANGLES, "0,3m", "--angles: expected 2 finite numbers"),
        (AREA, "0,1m", "--t-range: expected 2 finite numbers"),
        (WORD, "cube", "--quadric: expected ellipsoid or one-sheeted hyperboloid, got 'cube'"),
        (WORD, "", "--quadric: expected ellipsoid or"),
        (COUNTS, "1,0,2.5,0", "--rows: expected whole numbers"),
    ],
)
def test_what_says_no_value_is_refused_by_the_name_of_the_argument(option, text, words):
    with pytest.raises(InputError) as caught:
        arguments.read(option, text)
    assert str(caught.value).startswith(words)


@pytest.mark.parametrize(
    ("kind", "of_mm", "of_metres"),
    [
        ("length", 250.0, 0.25),
        ("distance", -250.0, -0.25),
        ("area", (1e6, 4e6), (1.0, 4.0)),
        ("points", ((1000.0, 0.0, 2000.0),), ((1.0, 0.0, 2.0),)),
        ("per_length", 0.002, 2.0),
        ("per_area", 3e-6, 3.0),
        ("angle", 30.0, 30.0),
    ],
)
def test_defaults_are_told_in_the_unit_asked_for(kind, of_mm, of_metres):
    told = Option("it", of_mm, kind, "").default_in(1000.0)
    assert np.array(told) == pytest.approx(np.array(of_metres), rel=1e-14)


@pytest.mark.parametrize(
    ("option", "parts"),
    [
        (LENGTH, ("Edge",)),
        (ANGLES, ("AnglesStart", "AnglesEnd")),
        (AREA, ("TRangeStart", "TRangeEnd")),
        (COUNTS, ("RowsFirst", "RowsSecond", "RowsThird", "RowsFourth")),
        (WORD, ("Quadric",)),
    ],
)
def test_each_number_of_an_option_has_a_property(option, parts):
    assert option.parts == parts


def test_only_what_was_given_counts():
    parser = argparse.ArgumentParser()
    for option in (LENGTH, ANGLES, ON):
        arguments.add(parser, option)
    assert arguments.given((LENGTH, ANGLES, ON), parser.parse_args([])) == {}
    found = arguments.given((LENGTH, ON), parser.parse_args(["--edge", "2", "--no-closed"]))
    assert found == {"edge": 2.0, "closed": False}


EVERY = {
    **{f"{name}.{item.name}": item for name, table in SYSTEMS.items() for item in table.options},
    **{f"{name}.{item.name}": item for name, source in SOURCES.items() for item in source.options},
    **{f"check.{item.name}": item for item in Design.options},
    **{f"net.{item.name}": item for item in (*OPTIONS.values(), *WEIGHTS.values())},
    **{f"quads.{item.name}": item for item in remesh.OPTIONS},
    **{f"tolerances.{item.name}": item for item in Tolerances.options},
    **{f"workshop.{item.name}": item for item in Workshop.options},
}


@pytest.mark.parametrize(
    ("allowed", "inside", "outside", "words"),
    [
        (Range(0, 0.5), (0, 0.5), (-0.1, 0.6), "0 to 0.5 mm"),
        (Range(0, 20, above=True), (0.1, 20), (0, 21), "a number above 0, 20 mm at most"),
        (Range(0, 180, True, True), (1, 179), (0, 180), "a number between 0 and 180 mm"),
        (Range(10, 100_000), (10, 100_000), (9, 100_001), "10 to 100,000 mm"),
        (Range(0, 1, below=True), (0, 0.9), (1,), "0 to below 1 mm"),
        (Range(2), (2, 1e9), (1,), "2 mm or more"),
        (POSITIVE, (1e-9,), (0, -1), "a number above 0 mm"),
        (Range(most=5), (-9, 5), (6,), "5 mm at most"),
        (Range(most=5, below=True), (-9, 4), (5,), "a number below 5 mm"),
        (Range(), (-1e9, 1e9), (math.nan,), ""),
    ],
)
def test_a_range_holds_what_its_words_say(allowed, inside, outside, words):
    assert [allowed.holds(value) for value in (*inside, *outside)] == [
        *(True for _ in inside), *(False for _ in outside)
    ]  # fmt: skip
    assert allowed.words("mm") == words


@pytest.mark.parametrize("where", EVERY)
def test_defaults_are_allowed_and_what_is_beyond_is_refused(where):
    option = EVERY[where]
    if option.kind not in NUMBERS:
        return
    if option.default is not None:
        option.check(option.default)
    for end, way in ((option.range.least, -1.0), (option.range.most, 1.0)):
        if math.isfinite(end):
            beyond = end + way
            value = (beyond,) * len(option.default) if option.several else beyond
            with pytest.raises(InputError, match=f"^{option.name.replace('_', ' ')}: expected "):
                option.check(value)


def test_systems_that_share_an_option_mean_the_same_by_it():
    shared = {}
    for name, system in SYSTEMS.items():
        for option in system.options:
            shared.setdefault(option.name, {})[name] = option
    for name, found in shared.items():
        if name not in ("gap", "thickness"):
            assert len(set(map(repr, found.values()))) == 1, name
        kinds = {(option.kind, option.parts, option.choices) for option in found.values()}
        assert len(kinds) == 1, name


@pytest.mark.parametrize(
    ("check", "words"),
    [
        (lambda: one_of("way", "fil", ("drop", "fill")), "way: expected drop or fill, got 'fil'"),
        (lambda: one_of("curve", 3, {"wave": 1}), "curve: expected wave, got '3'"),
        (lambda: one_of("curve", ["a"], {"wave": 1}), r"""curve: expected wave, got "\['a'\]\""""),
        (lambda: number_within("scale", -1), "scale: expected a number above 0, got -1"),
        (lambda: number_within("wall", 0, unit="mm"), "wall: expected a number above 0 mm, got 0"),
        (lambda: number_within("scale", math.nan), "scale: expected a finite number, got nan"),
        (lambda: whole_number("rings", 1, Range(2)), "rings: .* whole number, 2 or more, got 1"),
        (lambda: whole_number("rings", 2.5, Range(2)), "rings: .* whole number, .* got 2.5"),
    ],
)  # fmt: skip
def test_the_same_fault_is_told_in_the_same_words_where_no_option_is_declared(check, words):
    with pytest.raises(InputError, match=words):
        check()


def test_the_help_says_the_ends_of_a_range():
    parser = argparse.ArgumentParser()
    arguments.add(parser, Option("tilt", 0.0, "angle", "Tilt", within=Range(-90, 90)))
    arguments.add(parser, Option("height", 5.0, "length", "Height", within=POSITIVE))
    assert "tilt, -90 to 90 (default: 0)" in parser.format_help()
    assert "height (default: 0.005 m)" in parser.format_help()
