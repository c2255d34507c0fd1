"""Lamellas in two layers: holes above each other, and the clearance that keeps layers apart."""

import dataclasses

import numpy as np
import pytest

from freecad_ortho.fabrication import Lamellas, Selection, build, clash
from freecad_ortho.fabrication.clash import check_clashes
from solver.mesh.quadmesh import QuadMesh
from tests.conftest import shared_mesh
from tests.fabrication.test_lamellas import check_solids, flat_grid, rounded, worst_clash
from tests.meshes import helicoid


def test_standing_ones_in_two_layers_have_no_holes_without_a_mate():
    structure = build(flat_grid(), [Lamellas(60, 5, layers=2, hole=11)])
    check_solids(structure)
    assert not any(part.pattern.holes for part in structure.parts)
    assert any("no bolt holds them" in words for words in structure.report()["messages"])
    assert worst_clash(structure) == 0.0


def test_two_lying_layers_have_a_bolt_hole_at_each_crossing():
    structure = build(flat_grid(), [Lamellas(60, 5, position="lying", layers=2, hole=11)])
    for part, solid in zip(structure.parts, structure.solids(), strict=True):
        assert len(part.pattern.holes) == len(part.vertices)
        assert {hole.diameter for hole in part.pattern.holes} == {11}
        centres = np.array([hole.centre for hole in part.pattern.holes])
        for mark in part.pattern.marks:
            if not mark.text:
                arms = np.linalg.norm(mark.points[:, None] - centres, axis=2)
                assert arms.min() == pytest.approx(5.5 + 6) and mark.points.min() >= -1e-9
        assert solid.isValid()
        assert solid.Volume() == pytest.approx(part.area * 5, rel=1e-9)
    assert worst_clash(structure) == 0.0
    # The holes of both layers are above each other.
    holes = {}
    for part in structure.parts:
        for hole, vertex in zip(part.pattern.holes, part.vertices, strict=True):
            local = np.append(hole.centre - part.pattern.axis[(len(part.pattern.axis) - 1) // 2], 0)
            holes.setdefault(vertex, []).append(part.origin + local @ part.frame)
    for vertex, pair in holes.items():
        assert len(pair) == 2
        assert np.abs(np.diff(pair, axis=0))[0, :2].max() <= 1e-9, vertex


def test_the_clearance_that_keeps_lying_layers_apart_is_named():
    settings = Lamellas(60, 5, position="lying", layers=2, strip="twisted")
    some = Selection(lines=(2, 3, 4))
    structure = build(rounded(), [settings], selection=some)
    clashes = check_clashes(structure.parts).clashes
    (words,) = [words for words in structure.report()["messages"] if "take clearance" in words]
    assert f"touch at {len(clashes)} crossing" in words and clashes
    least = float(words.rpartition(" ")[2])
    for clearance, apart in ((least, True), (0.7 * least, False)):
        made = build(
            rounded(), [dataclasses.replace(settings, clearance=clearance)], selection=some
        )
        assert (not check_clashes(made.parts).clashes) is apart
        named = any("take clearance" in words for words in made.report()["messages"])
        assert named is not apart


def skewed(angle):
    """A bent and twisted net of three rows whose lines cross at an angle, degrees."""
    i, j = np.meshgrid(*2 * [np.arange(4) - 1.5], indexing="ij")
    across, along = np.sin(np.radians(angle)), np.cos(np.radians(angle))
    height = 0.3 * (0.3 * i**2 - 0.2 * j**2 + 0.3 * i * j)
    k = np.arange(16).reshape(4, 4)
    faces = np.stack([k[:-1, :-1], k[1:, :-1], k[1:, 1:], k[:-1, 1:]], axis=-1).reshape(-1, 4)
    points = np.stack([i + along * j, across * j, height], axis=-1).reshape(-1, 3)
    return QuadMesh(1000 * points, faces)


@pytest.mark.parametrize("net", ["own", "wein99_diag"])
def test_the_clearance_that_is_named_works_where_lines_cross_askew(net, monkeypatch):
    """Plates share a rhombus, whose corners are further off than those of a rectangle."""
    monkeypatch.setattr(clash, "CONTACT", 1e-10)
    mesh = skewed(75) if net == "own" else shared_mesh(net).scaled(1000.0)
    some = None if net == "own" else Selection(lines=(10, 11, 12))
    settings = Lamellas(60, 4, position="lying", layers=2)
    said = build(mesh, [settings], selection=some)
    (words,) = [words for words in said.report()["messages"] if "take clearance" in words]
    least = float(words.rpartition(" ")[2])
    for clearance, apart in ((least, True), (0.85 * least, False)):
        made = build(mesh, [dataclasses.replace(settings, clearance=clearance)], selection=some)
        assert any("take clearance" in words for words in made.report()["messages"]) is not apart
        assert not (apart and check_clashes(made.parts).clashes)


def test_layers_that_twist_are_kept_apart_to_their_corners(monkeypatch):
    # Corners that are a tenth of a millimetre deep share little; contact leaves room for that.
    monkeypatch.setattr(clash, "CONTACT", 1e-10)
    net = helicoid(5, 5).scaled(2500.0)
    settings = Lamellas(60, 5, position="lying", layers=2, strip="twisted")
    (words,) = [w for w in build(net, [settings]).report()["messages"] if "take clearance" in w]
    least = float(words.rpartition(" ")[2])
    for clearance, apart in ((least, True), (0.93 * least, False)):
        made = build(net, [dataclasses.replace(settings, clearance=clearance)])
        assert (not check_clashes(made.parts).clashes) is apart
        named = any("touch at" in words for words in made.report()["messages"])
        assert named is not apart
