"""The smallest radius of sheets and rows of faces that sample surfaces of known radius."""

import math

import numpy as np
import pytest

from freecad_ortho.fabrication import BentPanels, Patches, Selection, build
from freecad_ortho.fabrication.systems.patches.radius import smallest_radius
from tests.meshes import grid

TURNS = [0.0, 0.4, math.pi / 4, 1.2]


def spaced(count, length, grade):
    """``count`` steps over a length around zero, the last ``grade`` times as long as the first."""
    steps = np.linspace(0, 1, count + 1)
    steps = steps if grade == 1 else (grade**steps - 1) / (grade - 1)
    return (steps - 0.5) * length


def laid(count, turn, grade):
    """Plane net of squares or rectangles 1.6 wide, and the square itself, turned."""
    nets = []
    for line in (spaced(count, 1.6, grade), spaced(200, 1.6, 1)):
        s, t = np.meshgrid(line, line, indexing="ij")
        nets.append(
            (s * math.cos(turn) - t * math.sin(turn), s * math.sin(turn) + t * math.cos(turn))
        )
    return nets


def on_cylinder(s, t):
    return (np.sin(s), t, np.cos(s)), np.ones_like(s)


def on_cone(s, t):
    """Isometric to the plane, the tip at (0, -3.6); half its angle is 0.5."""
    away, angle = np.hypot(s, t + 3.6), np.arctan2(s, t + 3.6) / math.sin(0.5)
    radius = away * math.sin(0.5)
    place = radius * np.cos(angle), radius * np.sin(angle), away * math.cos(0.5)
    return place, away * math.tan(0.5)


def on_ellipse(s, t):
    """A cylinder over an ellipse of half axes 1.5 and 1, sharpest near the middle."""
    parameter = np.linspace(-math.pi, math.pi, 20001)
    x, y = 1.5 * np.cos(parameter), np.sin(parameter)
    length = np.append(0, np.cumsum(np.hypot(np.diff(x), np.diff(y))))
    angle = np.interp(s + 0.13, length - length[10000], parameter)
    radius = (2.25 * np.sin(angle) ** 2 + np.cos(angle) ** 2) ** 1.5 / 1.5
    return (1.5 * np.cos(angle), np.sin(angle), t), radius


@pytest.mark.parametrize("grade", [1, 3])
@pytest.mark.parametrize("turn", TURNS)
@pytest.mark.parametrize("count", [4, 6, 10])
@pytest.mark.parametrize("surface", [on_cylinder, on_cone, on_ellipse])
def test_a_sheet_is_never_said_to_be_bent_less_than_it_is(surface, count, turn, grade):
    net, everywhere = laid(count, turn, grade)
    found = smallest_radius(grid(*surface(*net)[0]))
    true = surface(*everywhere)[1].min()
    assert found <= (1.02 if count < 6 else 1.01) * true
    assert found >= (0.9 if count == 10 and grade == 1 else 0.65) * true


def frustum(around, along, grade):
    """Circles and rulings of a cone, its radius from 500 to 2,000 mm, half its angle 0.5."""
    angle = spaced(around, 2.0, grade)
    radius = 1250 + spaced(along, 1500.0, grade)
    angle, radius = np.meshgrid(angle, radius, indexing="ij")
    return grid(radius * np.cos(angle), radius * np.sin(angle), radius / math.tan(0.5))


@pytest.mark.parametrize("grade", [1, 3])
@pytest.mark.parametrize(("around", "along"), [(3, 1), (6, 1), (6, 2), (8, 4)])
def test_a_cone_is_bent_most_at_its_narrow_border(around, along, grade):
    """As one patch, and as rows of faces around the cone."""
    mesh, true = frustum(around, along, grade), 500 / math.cos(0.5)
    patch = build(mesh, [Patches(1)]).parts
    rows = [part for family in "uv" for part in _rows(mesh, family)]
    for parts in (patch, rows):
        found = min(part.measures.min_bend_radius_mm or math.inf for part in parts)
        assert 0.8 * true <= found <= true


def _rows(mesh, family):
    return build(mesh, [BentPanels(1, 4)], selection=Selection(family)).parts
