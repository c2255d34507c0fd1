"""Beams, nodes and glass at the border of a surface that a net overhangs."""

import numpy as np
import pytest
import shapely

from freecad_ortho.fabrication import Beams, Panels, build
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.systems import Nodes
from tests.fabrication.test_trimming import ALONG_EDGES, SLANTED


@pytest.mark.parametrize("ends", ["mitred", "hub", "lapped", "through-u"])
def test_trimmed_beams_are_whole_parts_that_do_not_meet(roof, border, ends):
    beams = Beams(120, 10, ends=ends, hub_diameter=60)
    structure = build(roof, [beams, Panels(20, 15)], border=border)
    for part in structure.parts:
        assert part.solid().isValid(), part.name
        assert part.solid().Volume() == pytest.approx(part.volume, rel=1e-9)
    assert structure.report()["beams"]["trimmed"] > 20
    assert check_clashes(structure.parts).clashes == ()


def _marks(part):
    return () if part.pattern is None else part.pattern.marks


@pytest.mark.parametrize("section", ["plate", "hollow", "I"])
def test_beams_end_at_the_border(sheet, section):
    """On a plane net no more than half of a beam's width is outside, and it reaches the border."""
    beams = Beams(100, 10, section=section, section_width=60)
    structure = build(sheet, [beams], border=[SLANTED])
    inside = shapely.Polygon(SLANTED[:, :2])
    around = inside.buffer((5 if section == "plate" else 30) + 1e-6)
    plans = [shapely.MultiPoint(part.points[:, :2]).convex_hull for part in structure.parts]
    for part, plan in zip(structure.parts, plans, strict=True):
        assert plan.difference(around).is_empty, part.name
        assert part.solid().isValid()
        assert not any(mark.points.size == 2 and not mark.text for mark in _marks(part))
    lengths = shapely.unary_union(
        [shapely.LineString(sheet.vertices[ends][:, :2]) for ends in sheet.connectivity.edges]
    ).intersection(inside)
    if section == "plate":
        drawn = shapely.unary_union(plans).buffer(1e-6)
        # What is left out is shorter than a stub may be, and what mitres take.
        assert (
            lengths.difference(drawn).length
            <= 100 * len(structure.report()["beams"]["left_out"]) + 1e-3
        )


def test_cut_ends_lie_in_the_planes_of_the_border_and_the_axes(roof, border):
    structure = build(roof, [Beams(200, 12)], border=border)
    site, names = structure.site, {part.name: part for part in structure.parts}
    seen = 0
    for edge, crossings in site.trimming.crossings.items():
        part = names.get(f"B{edge:04d}")
        if part is None or len(crossings) != 1:
            continue
        (one,) = crossings
        first, second = site.axes.offsets[site.mesh.connectivity.edges[edge]]
        normal = np.cross(one.along, (1 - one.place) * first + one.place * second)
        normal /= np.linalg.norm(normal)
        level = (part.points - site.shift - one.point) @ normal
        if np.abs(level).min() < 50:
            on_plane = np.abs(level) < 1e-6
            seen += int(on_plane.sum()) == 6
            assert level[~on_plane].min() > 0 or level[~on_plane].max() < 0
    assert seen > 15


def test_short_beams_at_the_border_are_left_out_and_said(sheet):
    border = [ALONG_EDGES + [[0, 0, 0], [80, 0, 0], [80, 0, 0], [0, 0, 0]]]
    structure = build(sheet, [Beams(100, 10)], border=border)
    report = structure.report()
    assert len(report["beams"]["left_out"]) == 7
    assert any(
        "beams: left out at the border what is shorter than 100 mm" in words
        for words in report["messages"]
    )
    assert len(structure.parts) == 5 * 7 + 6 * 6
    kept = build(sheet, [Beams(100, 10, least_length=50)], border=border)
    assert len(kept.parts) == len(structure.parts) + 7


def test_nodes_stand_where_beams_are_within_the_border(sheet):
    structure = build(sheet, [Beams(100, 10, ends="hub"), Nodes()], border=[SLANTED])
    inside = shapely.Polygon(SLANTED[:, :2])
    within = {
        f"N{number:04d}"
        for number, point in enumerate(sheet.vertices[:, :2])
        if inside.contains(shapely.Point(point))
    }
    assert {part.name for part in structure.parts if part.kind == "node"} == within
    assert check_clashes(structure.parts).clashes == ()


def test_panels_that_too_few_beams_carry_are_counted(sheet):
    messages = build(sheet, [Beams(100, 20), Panels(12, 8)], border=[SLANTED]).report()["messages"]
    assert any("at the border have fewer than two beams under them" in words for words in messages)
    assert not any("bear on the beams by 0 mm" in words for words in messages)
