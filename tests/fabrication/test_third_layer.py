"""Lamellas along diagonals of webs: straight, held at every crossing, free of clashes."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_ortho.fabrication import Lamellas, build
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.site import Selection
from freecad_ortho.fabrication.systems.lamellas.above import Above
from solver import optimise
from solver.errors import InputError
from solver.mesh.diagonal_lines import diagonal_lines
from solver.mesh.quadmesh import QuadMesh
from solver.nets.options import NetOptions
from tests.meshes import freeform_roof, freeform_saddle, grid, rhombic_dodecahedron

SIZES = {"width": 60.0, "thickness": 4.0, "strip": "twisted"}


def web(start: QuadMesh, kind: str) -> QuadMesh:
    """A web of some 5 m, in mm."""
    outcome = optimise(start, "web", options=NetOptions(web=kind))
    assert outcome.report.status == "converged"
    return outcome.mesh.scaled(1000.0)


@pytest.fixture(scope="module")
def standing():
    """A lying layer on standing lamellas, of a web of two asymptotic families and a geodesic."""
    return build(web(freeform_saddle(6, 5, 5.0), "aag"), [Lamellas(diagonals="auto", **SIZES)])


@pytest.fixture(scope="module")
def lying():
    """A third lying layer, of three geodesic families."""
    net = web(freeform_roof(7, 6, 6.0), "ggg")
    settings = Lamellas(diagonals="auto", position="lying", layers=2, clearance=9.0, **SIZES)
    return build(net, [settings])


def of_kind(structure, kind):
    return [part for part in structure.parts if part.kind == kind]


def along_diagonals(structure):
    return [part for part in of_kind(structure, "lamella") if part.family == "d"]


@pytest.mark.parametrize(("layers", "count"), [("standing", 4 + 3 - 1), ("lying", 5 + 4 - 1)])
def test_slats_along_geodesic_diagonals_are_cut_straight(layers, count, request):
    structure = request.getfixturevalue(layers)
    slats = along_diagonals(structure)
    net = structure.mesh.connectivity
    # One from each vertex on two sides of the grid of the inner ones.
    assert len(slats) == count
    assert {v for part in slats for v in part.vertices} >= set(net.stars[:, 0].tolist())
    for part in slats:
        assert part.measures.straightness_mm <= 1e-9 * part.length
        assert part.measures.lean_deg < 10.0
        assert not part.curved
        # A straight axis is one level line of the pattern.
        assert np.ptp(part.pattern.axis[:, 1]) <= 1e-9 * part.length


def test_slats_keep_the_lengths_of_their_axes(standing):
    for part in along_diagonals(standing):
        steps = np.linalg.norm(np.diff(part.pattern.axis, axis=0), axis=1)
        points = standing.mesh.vertices[list(part.vertices)]
        apart = np.linalg.norm(np.diff(points, axis=0), axis=1)
        # Above the net by the level of the layer, so as much longer or shorter as that bends it.
        assert steps[1:-1] == pytest.approx(apart, rel=0.02)


def test_each_crossing_on_standing_ones_has_an_angle_that_lies_on_both(standing):
    report = standing.report()["lamellas"]
    ties = of_kind(standing, "cleat")
    met = {v for part in along_diagonals(standing) for v in part.vertices}
    assert {part.vertices[0] for part in ties} == met
    assert report["ties"] == len(ties)
    by_name = {part.name: part for part in standing.parts}
    for tie in ties:
        upright, slat = (by_name[mark.text] for mark in tie.pattern.marks)
        assert (upright.family in "uv", slat.family) == (True, "d")
        for drill, plate in zip(tie.body.drills, (upright, slat), strict=True):
            place = tie.origin + drill.centre @ tie.frame
            middles = np.array([plate.origin + d.centre @ plate.frame for d in plate.body.drills])
            ways = np.array([d.direction @ plate.frame for d in plate.body.drills])
            arms = place - middles
            depth = np.einsum("nk,nk->n", arms, ways)
            aside = np.linalg.norm(arms - depth[:, None] * ways, axis=1)
            nearest = aside.argmin()
            assert aside[nearest] < 0.2
            both = (tie.thickness + plate.thickness) / 2
            assert both - 1e-6 <= abs(depth[nearest]) < both + 0.5
            own = drill.direction @ tie.frame
            assert abs(own @ ways[nearest]) > np.cos(np.radians(2.0))


def test_slats_lie_on_upper_edges_with_the_clearance(standing):
    level = standing.report()["lamellas"]["diagonal_level_mm"]
    assert level >= 30.0 + 1.0 + 2.0
    assert level < 30.0 + 1.0 + 2.0 + 5.0


def test_slats_fold_back_onto_their_axes(standing):
    lamellas = standing.results["lamellas"].geometry.lamellas
    slats = [each for each in lamellas if each.family == "d"]
    assert len(slats) == len(along_diagonals(standing))
    for each in slats:
        strip = each.ribbon.strip
        assert np.abs(strip.refolded()[:, 0] - strip.points).max() <= 1e-6


@pytest.mark.parametrize("layers", ["standing", "lying"])
def test_nothing_clashes(layers, request):
    structure = request.getfixturevalue(layers)
    found = check_clashes(structure.parts)
    assert found.near > len(along_diagonals(structure))
    assert (found.clashes, found.open) == ((), ())


def test_one_bolt_passes_three_lying_layers(lying):
    report = lying.report()["lamellas"]
    held = [names for each in lying.fasteners for names in each.joins]
    triple = [names for names in held if len(names) == 3]
    assert len(triple) == report["triple_crossings"] > 0
    assert {name[2] for names in triple for name in names} == {"U", "V", "D"}
    # Nothing else passes there: as many bolts as crossings of both families.
    assert len(held) == report["crossings"]


def test_of_a_web_with_one_asymptotic_family_that_alone_carries_the_diagonals_straight():
    net = web(freeform_saddle(6, 5, 5.0), "agg")
    whole = build(net, [Lamellas(**SIZES)])
    (said,) = (
        words for words in whole.results["lamellas"].messages if "alone are straight" in words
    )
    family = said.split("family ")[1][0]
    settings = Lamellas(diagonals="auto", **SIZES)
    structure = build(net, [settings], selection=Selection(family))
    slats = of_kind(structure, "lamella")
    assert {part.family for part in slats} == {family, "d"}
    for part in slats:
        assert part.measures.straightness_mm <= 1e-9 * part.length
    report = structure.report()["lamellas"]
    assert report["pattern"] == "straight"
    assert report["ties"] == len({v for part in along_diagonals(structure) for v in part.vertices})
    assert check_clashes(structure.parts).clashes == ()
    # The other family bends within its strips when it stands.
    other = build(net, [Lamellas(**SIZES)], selection=Selection({"u": "v", "v": "u"}[family]))
    assert other.report()["lamellas"]["pattern"] == "free"


def test_lines_of_diagonals_pass_each_inner_vertex_once():
    net = grid(np.arange(5.0)[:, None], np.arange(4.0), np.zeros((5, 4))).connectivity
    for family in (0, 1):
        lines = diagonal_lines(net, family)
        inner = [v for line in lines for v in line.vertices if not net.boundary_vertices[v]]
        assert sorted(inner) == sorted(net.stars[:, 0].tolist())
        assert sorted(len(line.vertices) for line in lines) == [3, 3, 4, 4]


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"position": "tilted"}, "take position standing with layers 1"),
        ({"layers": 2}, "take position standing with layers 1"),
        ({"smooth": True, "strip": "auto"}, "leave smooth or diagonals out"),
        ({"hole": 30.0}, "smaller hole or wider"),
        ({"diagonals": "third"}, "diagonals"),
    ],
)
def test_what_cannot_be_is_refused_in_one_line(settings, words):
    with pytest.raises(InputError, match=words) as refused:
        Lamellas(**{"diagonals": "auto", **SIZES, **settings})
    assert "\n" not in str(refused.value)


def test_a_net_without_families_of_diagonals_is_refused():
    with pytest.raises(InputError, match="take diagonals none"):
        build(rhombic_dodecahedron().scaled(2000.0), [Lamellas(diagonals="auto", **SIZES)])


@pytest.mark.parametrize(("count", "shown"), [(5, "C0, C1, C2, C3, C4;"), (6, "C3, C4 ...;")])
def test_the_first_five_angles_without_room_are_named(count, shown):
    (words,) = Above([], lost=[f"C{number}" for number in range(count)]).words()
    assert words.startswith(f"lamellas: {count} of {count} angles") and shown in words
