"""Options are declared once; here: what texts on the command line say of them."""

from __future__ import annotations

import argparse
import math

import pytest

from freecad_ortho.cli import options as arguments
from solver import InputError
from solver.option import Option

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


def test_only_what_was_given_counts():
    parser = argparse.ArgumentParser()
    for option in (LENGTH, ANGLES, ON):
        arguments.add(parser, option)
    assert arguments.given((LENGTH, ANGLES, ON), parser.parse_args([])) == {}
    found = arguments.given((LENGTH, ON), parser.parse_args(["--edge", "2", "--no-closed"]))
    assert found == {"edge": 2.0, "closed": False}
