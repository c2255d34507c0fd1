"""Lamellas that tilt by the angles of a pseudo-geodesic net: straight, exact, free of clashes."""

from __future__ import annotations

import functools

import numpy as np
import pytest

from freecad_ortho.fabrication import Lamellas, build
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.systems.lamellas.axis import Lamella
from freecad_ortho.fabrication.systems.lamellas.crossings import crossings, said_of_wide
from freecad_ortho.fabrication.systems.lamellas.laps import _both_sides
from freecad_ortho.fabrication.systems.lamellas.outline import notch
from freecad_ortho.fabrication.systems.lamellas.ribbon import Ribbon
from solver import optimise
from solver.analysis import lines
from solver.errors import InputError
from solver.mesh.quadmesh import QuadMesh
from solver.nets.options import NetOptions
from solver.unroll.axes import tilted_axes
from solver.unroll.measures import strip_measures
from solver.unroll.twisted import twisted_strip
from tests.meshes import deformed, freeform_roof, helicoid, small_circles


@functools.cache
def net() -> QuadMesh:
    """A piece of a bent ball, 9 m wide, with strips at 40 and 40 degrees."""
    start = deformed(small_circles(8, 7), 0.03).scaled(9000.0)
    outcome = optimise(start, "pseudo-geodesic", options=NetOptions(tilt_u=40.0, tilt_v=40.0))
    assert outcome.report.status == "converged"
    return outcome.mesh


def test_they_unroll_straight_fold_back_and_pass_each_other():
    mesh = net()
    structure = build(mesh, [Lamellas(60.0, 3.0, position="tilted")])
    report = structure.report()["lamellas"]
    assert report["pattern"] == "straight"
    assert report["tilt_deg"]["u"] == pytest.approx(40.0, abs=1e-6)
    assert report["tilt_deg"]["v"] == pytest.approx(40.0, abs=1e-6)
    inner = 0
    for lamella in structure.results["lamellas"].geometry.lamellas:
        strip = lamella.ribbon.strip
        assert np.abs(strip.refolded()[:, 0] - strip.points).max() <= 1e-6
        border = mesh.connectivity.boundary_vertices[list(lamella.vertices)].all()
        if not border:
            inner += 1
            assert lamella.measures.straightness <= 1e-9 * lamella.measures.length
    assert inner == 11
    assert not check_clashes(structure.parts).clashes


def test_the_line_that_strips_share_is_square_to_how_both_lines_bend():
    mesh = net()
    stars = mesh.connectivity.stars
    axes = tilted_axes(mesh, (np.radians(40.0), np.radians(40.0)))[stars[:, 0]]
    spokes = mesh.vertices[stars[:, 1:]] - mesh.vertices[stars[:, :1]]
    spokes /= np.linalg.norm(spokes, axis=2)[:, :, None]
    for one, other in ((0, 2), (1, 3)):
        bend = spokes[:, one] + spokes[:, other]
        assert np.abs(np.einsum("ij,ij->i", bend, axes)).max() < 1e-12


def test_upright_ones_are_those_that_stand():
    mesh = helicoid(9, 7).scaled(2000.0)
    axes = tilted_axes(mesh, (np.pi / 2, np.pi / 2))
    inside = mesh.connectivity.stars[:, 0]
    slant = np.einsum("ij,ij->i", axes[inside], mesh.vertex_normals[inside])
    assert np.degrees(np.arccos(slant.min())) < 3.0
    standing, tilted = (
        build(mesh, [Lamellas(40.0, 3.0, position=position)]).report()["lamellas"]
        for position in ("standing", "tilted")
    )
    assert tilted["length_mm"] == pytest.approx(standing["length_mm"], rel=1e-3)
    assert tilted["tilt_deg"]["u"] == pytest.approx(90.0, abs=3.0)


def slanted(name: str, points: np.ndarray, upright: np.ndarray, vertices: tuple[int, ...]):
    """A plane lamella, 60 x 4 mm, whose rulings stand along one direction."""
    strip = twisted_strip(points, np.tile(upright, (len(points), 1)), None, follow=True)
    measures = strip_measures(strip, 60.0, np.tile(upright, (len(points), 1)))
    stations = tuple(range(len(points)))
    ribbon = Ribbon(strip, -30.0, 30.0, 4.0)
    kinds = ("straight", "straight", True, False)
    return Lamella(name, name[2].lower(), 0, vertices, stations, ribbon, measures, *kinds)


def test_a_twisted_plate_is_thick_square_to_its_rulings():
    """The way to the upper side, half the thickness, wherever the plate has turned to."""
    points = np.linspace(-500.0, 500.0, 3)[:, None] * [1.0, 0.0, 0.0]
    turn = np.radians([0.0, 25.0, 50.0])
    rulings = np.stack([0 * turn, np.sin(turn), np.cos(turn)], axis=1)
    ribbon = Ribbon(twisted_strip(points, rulings, None, follow=True), -30.0, 30.0, 4.0)
    across = ribbon.flat_across[1]
    middle = ribbon.strip.flat_points[1] + 200.0 * np.array([across[1], -across[0]])
    places, up = ribbon.placed(1, middle + np.array([[-20.0], [20.0]]) * across)
    assert np.linalg.norm(up, axis=1) == pytest.approx(2.0, rel=1e-12)
    assert up @ (places[1] - places[0]) == pytest.approx(0.0, abs=1e-9)


def test_points_around_a_slot_reach_from_its_start_to_its_end():
    points = np.linspace(-500.0, 500.0, 3)[:, None] * [1.0, 0.0, 0.0]
    lamella = slanted("L-U000", points, np.array([0.0, 0.0, 1.0]), (0, 1, 2))
    axis = lamella.ribbon.flat_across[1]
    around, _ = _both_sides(lamella, 1, axis, 25.0, np.zeros(3), 4.0)
    assert (around[:, 2].min(), around[:, 2].max()) == pytest.approx((0.0, 25.0))
    assert np.abs(around[:, 1]) == pytest.approx(2.0)
    assert np.abs(around[:, 0]).max() == pytest.approx(10.0)


def test_a_slot_lets_a_plate_pass_that_leans_otherwise_up_to_a_slanted_edge():
    # In the plane y = 0 one stands at 50 degrees, the other, along y, at 35: they meet at y = 0 in
    # the line x = z tan(35), 4 / cos(35) mm wide there, and part at the edge z = 30.
    own, theirs = ([np.sin(a), 0, np.cos(a)] for a in np.radians([50.0, 35.0]))
    along = np.linspace(-500.0, 500.0, 3)[:, None]
    lamellas = [
        slanted("L-U000", along * [1.0, 0.0, 0.0], np.array(own), (1, 0, 2)),
        slanted("L-V000", along * [0.0, 1.0, 0.0], np.array(theirs), (3, 0, 4)),
    ]
    settings = Lamellas(60.0, 4.0, position="tilted", clearance=1.0)
    met = crossings(lamellas, settings)
    slot = met[0][0].slot
    assert slot is not None and slot.upward
    mouth = notch(lamellas[0].ribbon, slot, "", "").mouth - lamellas[0].ribbon.strip.flat_points[1]
    assert np.abs(mouth[:, 1]) == pytest.approx(30.0)
    passes = 30 * np.tan(np.radians(35.0)) + 2 / np.cos(np.radians(35.0)) * np.array([-1, 1])
    turned = np.sort(mouth[:, 0] * np.sign(mouth[:, 1]))
    assert turned[0] <= passes[0] - 0.5 / np.cos(np.radians(50.0)) + 1e-9
    assert turned[1] >= passes[1] + 0.5
    assert "up to" in said_of_wide(lamellas, met, settings)[0]


@pytest.mark.parametrize(
    ("mesh", "settings", "words"),
    [
        (freeform_roof(9, 8), {"pattern": "straight"}, "nearly into the surface|pseudo-geodesic"),
        (small_circles(6, 6), {"pattern": "arc"}, "unroll straight or free, not to arcs"),
        (small_circles(6, 6), {"layers": 2}, "take layers 1"),
        (small_circles(6, 6, 84.0, 5.0, 20.0), {}, "let them lie in layers 2"),
    ],
    ids=["no such net", "arc", "layers", "flat"],
)
def test_what_cannot_be_is_refused_in_one_line(mesh, settings, words):
    with pytest.raises(InputError, match=words) as refused:
        build(mesh.scaled(9000.0), [Lamellas(60.0, 3.0, position="tilted", **settings)])
    assert "\n" not in str(refused.value)
    assert lines.tilt(mesh).max() < 0.2
