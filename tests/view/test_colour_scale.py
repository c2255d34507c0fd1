"""Ranges and labels of colour maps."""

import numpy as np

from freecad_ortho.view.colour_scale import ColourScale
from freecad_ortho.view.colours import NO_VALUE, palette
from solver.analysis.fields import Field


def field(values, **kind):
    return Field("vertices", np.array(values, dtype=float), **kind)


def test_decades_are_even():
    scale = ColourScale.of_decades(-6, -1)
    np.testing.assert_allclose(
        scale.fractions(np.array([0.0, 1e-9, 1e-6, 1e-1, 10.0])), [0.0, -0.6, 0.0, 1.0, 1.4]
    )
    assert scale.labels() == [
        (0.0, "1e-6"),
        (0.2, "1e-5"),
        (0.4, "1e-4"),
        (0.6, "1e-3"),
        (0.8, "0.01"),
        (1.0, "0.1"),
    ]


def test_signed_fields_are_white_at_zero():
    values = field([-1e-6, 0.0, 3e-6], dimension=-2, signed=True)
    scale = ColourScale.automatic(values)
    assert scale.low == -scale.high
    np.testing.assert_allclose(scale.colours(values)[1], 0.96)
    assert scale.labels()[2] == (0.5, "0 1/m²")


def test_curvatures_are_said_a_metre():
    scale = ColourScale.automatic(field([-0.002, 0.002], dimension=-1, signed=True))
    assert scale.labels()[4] == (1.0, "2 1/m")


def test_missing_values_are_grey_and_infinite_ones_at_the_end():
    scale = ColourScale.between(field([0.0], dimension=1), 0.0, 10.0)
    colours = palette(scale.fractions(np.array([np.nan, np.inf, 10.0])))
    np.testing.assert_allclose(colours[0], NO_VALUE)
    np.testing.assert_allclose(colours[1], colours[2])


def test_equal_values_lie_in_the_middle():
    values = field([990.0, 990.0 * (1 + 1e-9)], dimension=1)
    scale = ColourScale.automatic(values)
    np.testing.assert_allclose(scale.fractions(values.values), 0.5, atol=1e-2)
    assert all(words.endswith(" mm") for _, words in scale.labels())
    assert len({words for _, words in scale.labels()}) == 5


def test_no_values_at_all():
    scale = ColourScale.automatic(field([np.nan, np.nan]))
    assert scale.low < scale.high


def test_a_range_the_wrong_way_round_still_has_labels():
    scale = ColourScale.between(field([1.0], dimension=1), 100.0, 1.0)
    assert scale.low < 100.0 < scale.high
    assert len(scale.labels()) == 5
