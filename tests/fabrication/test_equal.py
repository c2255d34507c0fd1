"""Equal parts can be swapped: solids coincide, whatever the list that says so."""

import csv
import json
from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
from scipy.spatial.distance import pdist

from freecad_ortho import api
from freecad_ortho.fabrication import Beams, FlatPattern, Hole, Mark, Panels, build, write
from freecad_ortho.fabrication.bodies import BOX_SIDES, Polyhedron
from freecad_ortho.fabrication.equal import TOLERANCE_MM, equal_groups
from freecad_ortho.fabrication.groups import groups_of
from freecad_ortho.fabrication.material import MATERIALS
from freecad_ortho.fabrication.nesting.sheet import turned
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.workshop import Workshop
from solver.errors import InputError

OUTLINE = np.array([[0, 0], [100, 0], [80, 40], [0, 60]], float)
HOLE = np.array([20.0, 20.0])


def plate(outline=OUTLINE, turn=0.0, lean=0.0, hole=HOLE, **more):
    """A plate whose upper side is moved by ``lean``, turned about its origin."""
    under, over = (turned(outline + [shift, 0.0], turn) for shift in (0.0, lean))
    corners = [np.column_stack([ring, np.full(4, z)]) for ring, z in ((under, 0), (over, 10))]
    pattern = FlatPattern(under, (), np.zeros(2), 1.0, **more)
    if hole is not None:
        pattern = replace(pattern, holes=(Hole(turned(hole[None], turn)[0], 8.0),))
    return Part(
        *("P0000", "panel", Polyhedron(np.concatenate(corners), BOX_SIDES), np.zeros(3), np.eye(3)),
        *(pattern, 100.0, 60.0, 10.0, 1.0, 1.0, MATERIALS["steel"]),
    )


def equal(*parts):
    return len(equal_groups(parts)) == 1


def test_plates_may_be_turned_but_nothing_else_differs():
    assert equal(plate(), plate(turn=73.0), plate(turn=200.0))
    assert not equal(plate(), plate(OUTLINE * 1.02))
    assert not equal(plate(), plate(OUTLINE[::-1] * [-1, 1]))
    # Outlines alone say nothing about the ends.
    assert not equal(plate(), plate(lean=2.0))
    assert equal(plate(), plate(lean=0.3))


def test_holes_and_lines_count_and_words_do_not():
    assert not equal(plate(), plate(hole=None))
    assert not equal(plate(), plate(hole=HOLE + 3.0))
    line = Mark(np.array([[5.0, 5.0], [30.0, 5.0]]))
    one, other = plate(), plate()
    marked = replace(other, pattern=replace(other.pattern, marks=(line,)))
    assert not equal(one, marked)
    moved = replace(other, pattern=replace(other.pattern, marks=(Mark(line.points + 2),)))
    assert not equal(marked, moved)
    words = Mark(np.array([[5.0, 5.0]]), "N0007", 4.0)
    assert equal(one, replace(other, pattern=replace(other.pattern, marks=(words,))))


def test_kinds_and_materials_are_kept_apart():
    assert not equal(plate(), replace(plate(), kind="louvre"))
    assert not equal(plate(), replace(plate(), material=MATERIALS["glass"]))


@pytest.mark.parametrize(
    "systems",
    [
        [Beams(200, 20)],
        [Beams(200, 12, section="hollow", section_width=80)],
        [Beams(200, 12, section="I"), Panels(20, 15, edge="bevel")],
    ],
)
def test_distances_within_equal_parts_agree(roof, systems):
    """Corner to corner, whatever the turn: what mitres and bevels change shows here."""
    parts = build(roof, systems).parts
    groups = equal_groups(parts)
    assert sorted(number for group in groups for number in group) == list(range(len(parts)))
    assert any(len(group) > 1 for group in groups)
    for group in groups:
        sizes = [np.sort(pdist(parts[number].body.corners)) for number in group]
        for size in sizes:
            assert np.abs(size - sizes[0]).max() <= 2 * TOLERANCE_MM


def test_ends_of_alike_outlines_are_told_apart(roof):
    """Beams of one outline meet others under different angles at the border and inside."""
    parts = build(roof, [Beams(200, 20)]).parts
    groups = equal_groups(parts)
    leader = {number: group[0] for group in groups for number in group}
    outlines = [part.pattern.outline for part in parts]
    alike = [
        (i, j)
        for i, j in combinations(range(len(parts)), 2)
        if np.abs(outlines[i] - outlines[j]).max() < 0.1
    ]
    assert any(leader[i] != leader[j] for i, j in alike)


@pytest.mark.parametrize("sizes", [{"bore": 20.0}, {"node": "socket"}])
def test_one_answer_in_lists_report_and_printed_joints(roof, tmp_path, sizes):
    write(api.fabricate(roof, "beams+nodes+panels", **sizes), tmp_path)
    report = json.loads((tmp_path / "report.json").read_text())
    printed = {path.stem for path in (tmp_path / "joints").glob("*.stl")}
    rows = {}
    for name in ("parts.csv", "nodes.csv"):
        with (tmp_path / name).open() as stream:
            rows[name] = {row["name"]: row["equal_to"] for row in csv.DictReader(stream)}
    nodes = {name: to for name, to in rows["parts.csv"].items() if name.startswith("N")}
    assert set(nodes.values()) == printed
    assert rows["nodes.csv"] == nodes
    listed = {name: first for first, some in report["nodes"]["equal"].items() for name in some}
    assert {name: to for name, to in nodes.items() if name in listed} == listed
    assert report["nodes"]["different"] == len(printed)
    kinds = report["families"]["shapes"]
    assert kinds["node"]["different"] == len(printed)
    assert set(kinds) == {"beam", "node", "panel"}


def test_how_near_equal_parts_are_is_said_by_the_workshop():
    parts = [
        replace(plate(), name="P0"),
        replace(plate(OUTLINE + [[0, 0], [1, 0], [0, 0], [0, 0]]), name="P1"),
    ]
    counts = {within: len(groups_of(parts, (), within).shapes["panel"]) for within in (0.5, 2.0)}
    assert counts == {0.5: 2, 2.0: 1}
    assert groups_of(parts, (), 2.0).equal_to == {"P0": "P0", "P1": "P0"}
    assert groups_of(parts, (), 2.0).report()["tolerance_mm"] == 2.0
    for wrong in (0.0, -1.0, 50.0):
        with pytest.raises(InputError, match="equal: expected"):
            Workshop(equal=wrong)
