"""Rows of faces as bent plates: patterns that fold back, valid solids, files that read back."""

import csv
import math
from itertools import pairwise

import ezdxf
import numpy as np
import pytest
import shapely.affinity

from freecad_ortho.fabrication import BentPanels, Selection, build, write
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.pattern import polygon_area
from freecad_ortho.fabrication.step import read_step
from solver import optimise
from solver.errors import InputError
from tests.conftest import shared_mesh, wavy_grid
from tests.fabrication.test_lamellas import check_solids
from tests.fabrication.test_patches import RADIUS, TURN, cone, cylinder, ring

U, V = Selection("u"), Selection("v")


def turned(points, start, end, angle):
    """Rotate points about the line through two others (Rodrigues)."""
    axis = (end - start) / np.linalg.norm(end - start)
    arms = points - start
    along = (arms @ axis)[:, None] * axis
    return (
        start
        + along
        + math.cos(angle) * (arms - along)
        + math.sin(angle) * np.cross(np.broadcast_to(axis, arms.shape), arms)
    )


def folded(pattern):
    """Outline of a pattern folded at its bend lines, one after the other."""
    count = len(pattern.outline) // 2
    points = np.column_stack([pattern.outline, np.zeros(2 * count)])
    right, left = points[:count], points[: count - 1 : -1].copy()
    for bend in pattern.bends:
        rung = int(np.linalg.norm(pattern.outline[:count] - bend.points[0], axis=1).argmin())
        start, end = right[rung].copy(), left[rung].copy()
        angle = -math.radians(bend.angle_deg)
        right[rung + 1 :] = turned(right[rung + 1 :], start, end, angle)
        left[rung + 1 :] = turned(left[rung + 1 :], start, end, angle)
    return np.concatenate([right, left])


def middle_of(part):
    """Corners of the middle of the plate in space, in the order of ``folded``."""
    low, high = np.split(part.points, 2)
    return 0.5 * (low + high)


def distances(points):
    return np.linalg.norm(points[:, None] - points[None], axis=2)


@pytest.mark.parametrize("selection", [U, V])
def test_plates_fold_back_from_their_patterns(roof, selection):
    structure = build(roof, [BentPanels(3, 10)], selection=selection)
    assert len(structure.parts) == {"u": 6, "v": 9}[selection.family]
    assert structure.report()["bent-panels"]["refold_max_mm"] <= 1e-6
    for part in structure.parts:
        assert part.pattern.bends
        miss = np.abs(distances(folded(part.pattern)) - distances(middle_of(part))).max()
        assert miss <= 1e-6
        low, high = np.split(part.points, 2)
        # Not mirrored: both the pattern and its bends are seen from the upper side.
        count = len(low) // 2
        up = high[0] - low[0]
        place = middle_of(part)
        normal = np.cross(place[1] - place[0], place[count] - place[0])
        assert up @ normal > 0
    check_solids(structure)
    assert not check_clashes(structure.parts).clashes


def test_on_a_cylinder_a_row_unrolls_to_its_rectangle():
    chord = 2 * RADIUS * math.sin(TURN / 20)
    structure = build(cylinder(), [BentPanels(6, 10)], selection=U)
    part = structure.parts[0]
    assert part.name == "R-U000"
    width = 3000 / 7 - 10
    assert part.length == pytest.approx(10 * chord - 10, rel=1e-9)
    assert part.width == pytest.approx(width, rel=1e-9)
    assert part.area == pytest.approx(width * (10 * chord - 10), rel=1e-9)
    assert part.volume == pytest.approx(6 * part.area, rel=1e-9)
    angles = [bend.angle_deg for bend in part.pattern.bends]
    assert angles == pytest.approx(9 * [-math.degrees(TURN / 10)], rel=1e-9)
    assert part.measures.min_bend_radius_mm == pytest.approx(chord / (TURN / 10), rel=1e-9)
    flat = build(cylinder(), [BentPanels(6, 10)], selection=V)
    assert all(not part.pattern.bends for part in flat.parts)
    check_solids(structure)


@pytest.mark.parametrize(("scale", "largest"), [(1.0, 12.0), (0.1, 4.0)])
@pytest.mark.parametrize("selection", [U, V])
def test_names_of_neighbours_are_as_large_as_fits_on_their_face(scale, largest, selection):
    made = build(cylinder().scaled(scale), [BentPanels(3 * scale, 10 * scale)], selection=selection)
    parts = {part.name: part for part in made.parts}
    for part in parts.values():
        plate = shapely.Polygon(part.pattern.outline)
        names = [mark for mark in part.pattern.marks if mark.text]
        assert {mark.text for mark in names} <= set(parts) - {part.name} and names
        for mark in names:
            assert 0.25 * largest < mark.size <= largest
            wide = mark.size * np.array([len(mark.text), 1.0]) / 2
            box = shapely.box(*-wide, *wide)
            box = shapely.affinity.rotate(box, mark.angle, origin=(0, 0))
            assert plate.contains(shapely.affinity.translate(box, *mark.points[0]))


def test_on_a_cone_the_clear_gap_is_what_was_asked_for():
    structure = build(cone(2.0), [BentPanels(2, 12)], selection=U)
    check_solids(structure)
    assert len({part.name for part in structure.parts}) == len(structure.parts)
    points = [middle_of(part) for part in structure.parts]
    nearest = min(
        np.linalg.norm(one[:, None] - other[None], axis=2).min() for one, other in pairwise(points)
    )
    assert 11.9 <= nearest <= 13.0


def test_a_closed_row_is_one_plate_with_a_seam():
    structure = build(ring(), [BentPanels(3, 10)], selection=U)
    assert len(structure.parts) == 4
    lean = math.pi / 12
    around = 12 * 2 * RADIUS * math.sin(lean)
    for part in structure.parts:
        # Across the seam its ends lean together: 10 mm apart on the side where they are nearest.
        back = 10 / math.cos(lean) + 3 * math.tan(lean)
        assert part.length == pytest.approx(around - back, abs=1e-6)
    check_solids(structure)


@pytest.mark.parametrize(("sheet", "counts"), [(None, (3, 2, 3, 2)), ("700x600", (2,) * 5)])
def test_rows_are_cut_into_pieces_of_a_wanted_length(sheet, counts):
    """A ring of ten faces in pieces of at most 3.2 of them, or of what a sheet holds besides."""
    chord = 2 * RADIUS * math.sin(TURN / 20)
    rings = U if len(build(cylinder(), [BentPanels(3)], selection=U).parts) == 7 else V
    (whole, *_) = build(cylinder(), [BentPanels(3, 10)], selection=rings).parts
    panels = BentPanels(3, 10, sheet=sheet, piece_length=3.2 * chord)
    structure = build(cylinder(), [panels], selection=rings)
    pieces = [part for part in structure.parts if part.name.startswith(f"{whole.name}-")]
    assert [part.name for part in pieces] == [
        f"{whole.name}-{k}" for k in range(1, len(counts) + 1)
    ]
    assert sorted(len(part.pattern.bends) + 1 for part in pieces) == sorted(counts)
    report = structure.report()
    longest = report["bent-panels"]["piece_length_max_mm"]
    assert longest == pytest.approx(max(counts) * chord, rel=1e-9)
    assert len(structure.parts) == report["bent-panels"]["pieces"] == 7 * len(counts)
    assert any(
        f"7 rows are cut along lines of the net into {7 * len(counts)}" in w
        for w in report["messages"]
    )
    # Between two pieces is the gap, and what plates that lean together take besides.
    bend = TURN / 20
    joint = 10 / math.cos(bend) + 3 * math.tan(bend)
    wide = whole.pattern.size.min()
    assert sum(part.area for part in pieces) == pytest.approx(
        whole.area - (len(counts) - 1) * joint * wide, rel=1e-6
    )
    assert not check_clashes(structure.parts).clashes


def test_pieces_are_no_shorter_than_a_face():
    with pytest.raises(
        InputError, match=r"face 42 of R-U000 is 299.7 mm.*allow longer ones or subdivide"
    ) as refused:
        build(cylinder(), [BentPanels(3, piece_length=50.0)])
    assert "\n" not in str(refused.value)


def test_rows_beside_chosen_lines_alone(roof):
    every = build(roof, [BentPanels()], selection=U).parts
    some = build(roof, [BentPanels()], selection=Selection("u", (2,))).parts
    assert len(some) == 2
    assert {part.name for part in some} < {part.name for part in every}


def test_bad_input_is_refused_in_one_line(twisted, roof):
    with pytest.raises(InputError, match=r"from plane.*for a principal net"):
        build(twisted, [BentPanels()])
    with pytest.raises(InputError, match="gap: 5000 mm"):
        build(roof, [BentPanels(3, 5000.0)])
    with pytest.raises(InputError, match="thickness"):
        BentPanels(-1.0)


def test_files_of_an_optimised_net_read_back(tmp_path):
    net = optimise(wavy_grid(9, 8), "principal").mesh.scaled(1000.0)
    structure = build(net, [BentPanels(2, 8)])
    write(structure, tmp_path)
    read = dict(read_step(tmp_path / "structure.step"))
    drawing = ezdxf.readfile(tmp_path / "flat.dxf")
    with (tmp_path / "bends.csv").open(encoding="utf-8") as stream:
        bends = list(csv.DictReader(stream))
    # Straight across; along the plates, which lean together by up to 3.3 degrees, they are wider.
    gaps = [read[a.name].distance(read[b.name]) for a, b in pairwise(structure.parts)]
    assert 8 - 2e-4 <= min(gaps) <= max(gaps) <= 8 + 1e-6
    for part in structure.parts:
        assert read[part.name].isValid()
        assert read[part.name].Volume() == pytest.approx(part.volume, rel=1e-6)
        block = drawing.blocks[part.name]
        (outline,) = block.query('LWPOLYLINE[layer=="CUT"]')
        corners = np.array([point[:2] for point in outline.get_points()])
        assert polygon_area(corners) == pytest.approx(part.area, rel=1e-6)
        lines = block.query('LINE[layer=="BEND"]')
        assert len(lines) == len(part.pattern.bends)
        assert len([row for row in bends if row["part"] == part.name]) == len(lines)


@pytest.mark.parametrize("name", ["heart", "conical1"])
def test_real_nets(name):
    net = optimise(shared_mesh(name), "principal").mesh.scaled(1000.0)
    structure = build(net, [BentPanels(3, 4)])
    assert structure.report()["bent-panels"]["refold_max_mm"] <= 1e-6
    check_solids(structure)
