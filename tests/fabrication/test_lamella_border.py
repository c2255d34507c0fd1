"""Lamellas that a border cuts: where they end, what they still cross, what is left out."""

import numpy as np
import pytest
import shapely

from freecad_ortho.fabrication import build
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.systems import systems_of
from tests.meshes import scherk

SIDE = 9


@pytest.fixture(scope="module")
def net():
    """Asymptotic lines of a minimal surface, 10 m wide."""
    mesh = scherk(SIDE, SIDE)
    return mesh.with_vertices(5000 * mesh.vertices)


@pytest.fixture(scope="module")
def border(net):
    """A closed curve on it and an opening in it."""
    return [ring(net, 0.83, 0.78), ring(net, 0.31, 0.27)]


def ring(net, rows, columns):
    points = net.vertices.reshape(SIDE, SIDE, 3)
    angle = np.linspace(0, 2 * np.pi, 240, endpoint=False)
    half = (SIDE - 1) / 2
    row, column = half * (1 + rows * np.sin(angle)), half * (1 + columns * np.cos(angle))
    i, j = row.astype(int), column.astype(int)
    s, t = (row - i)[:, None], (column - j)[:, None]
    first = (1 - t) * points[i, j] + t * points[i, j + 1]
    return (1 - s) * first + s * ((1 - t) * points[i + 1, j] + t * points[i + 1, j + 1])


def lamellas(net, border, **settings):
    systems = systems_of("lamellas", {"width": 60.0, "thickness": 4.0, **settings})
    return build(net, systems, border=border)


SETTINGS = [
    {},
    {"position": "lying", "layers": 2},
    pytest.param({"strip": "twisted", "stock": 4000.0}, marks=pytest.mark.slow),
]


@pytest.mark.parametrize("settings", SETTINGS, ids=["slots", "two layers", "spliced"])
def test_they_are_whole_parts_and_do_not_clash(net, border, settings):
    structure = lamellas(net, border, **settings)
    assert check_clashes(structure.parts).clashes == ()
    names = {part.name for part in structure.parts}
    assert len(names) == len(structure.parts)
    for part in structure.parts:
        solid = part.solid()
        assert solid.isValid(), part.name
        assert solid.Volume() == pytest.approx(part.volume, rel=1e-6)
        assert shapely.Polygon(part.pattern.outline).is_valid
        # Nothing is told of what they would cross outside.
        told = {mark.text for mark in part.pattern.marks if mark.text.startswith("L-")}
        assert told <= names
    assert not any("run on over the border" in words for words in structure.report()["messages"])


@pytest.mark.parametrize("position", ["standing", "lying"])
def test_they_end_at_the_border_and_not_beyond(net, border, position):
    structure = lamellas(net, border, position=position, layers=2)
    across = 60.0 if position == "lying" else 4.0
    line = np.concatenate(border)
    ends = []
    for lamella in structure.results["lamellas"].geometry.lamellas:
        ends += lamella.ribbon.strip.points[[0, -1]].tolist()
        assert len(lamella.vertices) >= 1
    away = np.linalg.norm(np.array(ends)[:, None] + structure.site.shift - line, axis=2)
    spacing = np.linalg.norm(np.diff(border[0], axis=0), axis=1).max()
    # Half of the section is set back, more where the border is slanted.
    near = away.min(axis=1) <= spacing / 2 + 2 * across + 10
    assert near.mean() > 0.9
    assert structure.report()["lamellas"]["trimmed"] == len(structure.parts)


def test_an_opening_makes_two_of_one_line(net, border):
    names = {part.name for part in lamellas(net, border).parts}
    middle = f"L-U{SIDE // 2:03d}"
    assert {middle, f"{middle}b"} <= names
    assert f"{middle}b" not in {part.name for part in lamellas(net, border[:1]).parts}


def test_without_a_border_nothing_changes(net):
    whole = lamellas(net, [])
    assert "trimmed" not in whole.report()["lamellas"]
    assert len(whole.parts) == 2 * SIDE


@pytest.mark.parametrize("position", ["standing", "lying"])
def test_along_the_border_they_are_cut_by_what_the_axes_along_it_span(net, border, position):
    """Lying ones reach it with both their corners, where the square cut leaves a tooth."""
    square, along = (
        lamellas(net, border, position=position, layers=2, border_cut=cut)
        for cut in ("square", "along")
    )
    assert check_clashes(along.parts).clashes == ()
    assert [part.name for part in along.parts] == [part.name for part in square.parts]
    for part in along.parts:
        assert part.solid().isValid(), part.name
        assert part.solid().Volume() == pytest.approx(part.volume, rel=1e-6)
        assert shapely.Polygon(part.pattern.outline).is_valid
    gaps = []
    for structure in (square, along):
        walls = wall_of(structure, border)
        ends = []
        for lamella in structure.results["lamellas"].geometry.lamellas:
            ribbon = lamella.ribbon
            for station, face in ((0, 0), (-1, len(ribbon.strip.lengths) - 1)):
                edges = [ribbon.edge(level)[station] for level in (ribbon.lower, ribbon.upper)]
                corners, _ = ribbon.placed(face, np.array(edges))
                ends.append([walls(corner) for corner in corners])
        gaps.append(np.array(ends))
    # How far the two corners of an end differ in their distance from the border.
    teeth = [np.ptp(gap, axis=1) for gap in gaps]
    if position == "lying":
        # Exactly, but for the border's own bends within the width; some run along it too closely.
        assert np.quantile(teeth[0], 0.35) > 10
        assert np.quantile(teeth[1], 0.35) < 0.05
        assert np.quantile(teeth[1], 0.65) < 3
        assert (teeth[1] <= teeth[0] + 3).all()
    assert np.median(teeth[1]) < np.median(teeth[0])
    assert sum(part.area for part in along.parts) > sum(part.area for part in square.parts)


def wall_of(structure, border):
    """Distance of points from the surface of the axes along the border, mm."""
    site = structure.site
    points = np.concatenate([line - site.shift for line in border])
    ahead = np.concatenate([np.roll(line, -1, axis=0) - line for line in border])

    def distance(point):
        vertex = int(np.linalg.norm(site.mesh.vertices - point, axis=1).argmin())
        axis = site.axes.directions[vertex]
        across = np.eye(3) - np.outer(axis, axis)
        arms, steps = (point - points) @ across, ahead @ across
        share = np.clip((arms * steps).sum(axis=1) / (steps**2).sum(axis=1), 0, 1)
        return float(np.linalg.norm(arms - share[:, None] * steps, axis=1).min())

    return distance
