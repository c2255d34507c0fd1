"""Arches: flat plates in the planes of lines, slots where the planes meet, planes as a list."""

from __future__ import annotations

import csv
import functools

import numpy as np
import pytest

from freecad_ortho.fabrication import build, write
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.pattern import polygon_area
from freecad_ortho.fabrication.site import Selection
from freecad_ortho.fabrication.systems import Arches
from solver import InputError, NetOptions, QuadMesh, optimise
from solver.mesh.primitives import primitive
from tests.meshes import deformed, grid


@functools.cache
def roof(plane: str = "both") -> QuadMesh:
    """A roof 12 m wide whose lines lie in planes."""
    start = deformed(primitive("translational", 9, 7), 0.02)
    outcome = optimise(start, "planar-lines", options=NetOptions(plane=plane))
    assert outcome.report.status == "converged"
    return outcome.mesh.scaled(12000.0 / float(np.ptp(start.vertices[:, 0])))


@functools.cache
def laps():
    return build(roof(), [Arches(250.0, 16.0)])


def test_plates_lie_in_the_planes_of_their_lines_and_have_their_outlines():
    structure, mesh = laps(), roof()
    assert sorted(part.name for part in structure.parts)[::15] == ["A-U000", "A-V008"]
    for part in structure.parts:
        line = mesh.vertices[list(part.vertices)]
        off = (line - part.origin) @ part.frame.T
        assert np.abs(off[:, 2]).max() < 1e-6
        assert off[:, :2] == pytest.approx(part.pattern.axis, abs=1e-6)
        assert part.measures.gap_mm < 1e-6 and not part.pattern.bends
        assert part.volume == pytest.approx(16.0 * polygon_area(part.pattern.outline), rel=1e-12)
        assert sum(block.volume for block in part.body.pieces()) == pytest.approx(part.volume)
    solid = structure.parts[3].solid()
    assert solid.isValid() and solid.Volume() == pytest.approx(structure.parts[3].volume)


def test_half_laps_take_the_plate_that_crosses_and_leave_it_no_more_than_the_clearance():
    structure = laps()
    assert structure.report()["arches"]["half_laps"] == 63
    assert not check_clashes(structure.parts).clashes
    tight = build(roof(), [Arches(250.0, 16.0, clearance=0.0)])
    assert not check_clashes(tight.parts).clashes
    # A slot that were narrower or less deep by 2 mm would be cut into.
    by_name = {part.name: part for part in tight.parts}
    one, other = by_name["A-U003"], by_name["A-V004"]
    middle = roof().vertices[next(iter(set(one.vertices) & set(other.vertices)))]
    for part, opens in ((one, 1.0), (other, -1.0)):
        meeting = np.cross(one.frame[2], other.frame[2])
        meeting *= np.sign(meeting @ part.frame[1]) / np.linalg.norm(meeting)
        place = (middle - part.origin) @ part.frame.T
        inside = [_within(part, place + part.frame @ (step * opens * meeting)) for step in (-2, 2)]
        assert inside == [True, False]
        across = part.frame @ np.cross(part.frame[2], meeting)
        angle = np.abs(one.frame[2] @ other.frame[2])
        half = (16.0 + 16.0 * angle) / 2 / np.sqrt(1 - angle**2)
        up = part.frame @ (60.0 * opens * meeting)
        sides = [_within(part, place + up + step * across) for step in (half - 0.5, half + 0.5)]
        assert sides == [False, True]


def _within(part, place) -> bool:
    import shapely

    return bool(shapely.contains_xy(shapely.Polygon(part.pattern.outline), *place[:2]))


@pytest.mark.parametrize("through", ["u", "v"])
def test_one_family_runs_through_and_the_other_is_pieces_between(through):
    structure = build(roof(), [Arches(250.0, 16.0, through=through)])
    whole = [part for part in structure.parts if part.name.count("-") == 1]
    pieces = [part for part in structure.parts if part.name.count("-") == 2]
    assert {part.family for part in whole} == {through}
    assert len(pieces) == {"u": 9 * 6, "v": 7 * 8}[through]
    assert all(len(part.vertices) == 2 for part in pieces)
    assert not check_clashes(structure.parts).clashes
    for part in structure.parts:
        assert sum(block.volume for block in part.body.pieces()) == pytest.approx(part.volume)


def test_planes_are_listed_where_they_stand_in_the_files(tmp_path):
    mesh = roof().with_vertices(roof().vertices + [3e6, 5e6, 0.0])
    structure = build(mesh, [Arches(250.0, 16.0)]).measured_from("keep")
    write(structure, tmp_path)
    rows = list(csv.DictReader((tmp_path / "planes.csv").open()))
    assert len(rows) == 16
    by_name = {part.name: part for part in structure.parts}
    for row in rows:
        point = np.array([float(row[f"{axis}_mm"]) for axis in "xyz"])
        normal = np.array([float(row[f"normal_{axis}"]) for axis in "xyz"])
        line = mesh.vertices[list(by_name[row["name"]].vertices)]
        assert np.abs((line - point) @ normal).max() < 1e-4
        assert float(row["deviation_mm"]) < 1e-6
        steps = np.linalg.norm(np.diff(line, axis=0), axis=1)
        assert float(row["length_mm"]) == pytest.approx(steps.sum(), abs=1e-4)


def test_the_family_that_is_not_plane_gets_no_plates_and_a_word():
    structure = build(roof("u"), [Arches(250.0, 16.0)])
    assert {part.family for part in structure.parts} == {"u"}
    (words,) = [word for word in structure.report()["messages"] if word.startswith("arches")]
    assert "family v gets no plates: its line" in words and "plates allow 1 mm" in words
    with pytest.raises(InputError, match=r"optimise the net to plane lines first"):
        build(roof("u"), [Arches(250.0, 16.0)], selection=Selection("v"))


def test_what_cannot_be_built_is_one_line():
    with pytest.raises(InputError, match="optimise the net to plane lines first"):
        build(
            deformed(primitive("translational", 9, 7), 0.02).scaled(9000.0), [Arches(250.0, 16.0)]
        )
    with pytest.raises(InputError, match=r"slots cut line . of . apart|take lower or thinner"):
        build(roof(), [Arches(250.0, 1500.0)])
    with pytest.raises(InputError, match="clearance: 300 mm makes slots deeper"):
        Arches(250.0, 16.0, clearance=300.0)
    with pytest.raises(InputError, match="through: expected u, v or both, got 'w'"):
        Arches(250.0, 16.0, through="w")
    x, y = np.meshgrid(np.linspace(0, 4000, 5), np.linspace(0, 4000, 5), indexing="ij")
    skew = grid(x + 0.95 * y, 0.25 * y, -((x / 4000) ** 2) * 300)
    with pytest.raises(InputError, match=r"the planes of lines .* meet at"):
        build(skew, [Arches(200.0, 16.0)])
