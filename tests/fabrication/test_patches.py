"""Developable sheets: exact patterns of cylinders and cones, valid solids, files that read back."""

import csv
import math
from itertools import pairwise

import ezdxf
import numpy as np
import pytest
import shapely.affinity

from freecad_ortho.fabrication import Patches, Selection, build, write
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.pattern import polygon_area
from freecad_ortho.fabrication.step import read_step
from solver import optimise
from solver.errors import InputError
from solver.mesh.grid import grid_mesh
from solver.mesh.primitives import primitive
from tests.conftest import shared_mesh
from tests.fabrication.test_lamellas import check_solids
from tests.meshes import bent_sheet

RADIUS, TURN, LENGTH = 2000.0, 1.5, 3000.0


def cylinder(turn=TURN, count=11):
    """Generators along u on a part of a cylinder, with side normals outwards."""
    angle, along = np.meshgrid(np.linspace(0, turn, count), np.linspace(0, 1, 8), indexing="ij")
    points = [RADIUS * np.cos(angle), RADIUS * np.sin(angle), LENGTH * along]
    return grid_mesh(np.stack(points, axis=-1))


def cone(turn):
    """A sheet of a cone between distances of 1 and 3 m from its tip, normals inwards."""
    away, angle = np.meshgrid(np.linspace(1, 3, 9), np.linspace(0, turn, 13), indexing="ij")
    x, y = 0.6 * away * np.cos(angle), 0.6 * away * np.sin(angle)
    return grid_mesh(1000 * np.stack([x, y, 0.8 * away], axis=-1))


def ring():
    """Rings and generators of a whole cylinder."""
    angle, along = np.meshgrid(np.arange(12) * np.pi / 6, np.linspace(0, 1, 5), indexing="ij")
    points = [RADIUS * np.cos(angle), RADIUS * np.sin(angle), LENGTH * along]
    return grid_mesh(np.stack(points, axis=-1), closed_u=True)


def test_a_cylinder_unrolls_to_its_rectangle():
    (part,) = build(cylinder(), [Patches(6)]).parts
    chord = 2 * RADIUS * math.sin(TURN / 20)
    assert sorted(part.pattern.size) == pytest.approx(sorted([LENGTH, 10 * chord]), rel=1e-9)
    assert part.area == pytest.approx(LENGTH * 10 * chord, rel=1e-9)
    # Facets of one thickness: on both sides of the middle the mitres even out.
    assert part.volume == pytest.approx(6 * part.area, rel=1e-9)
    assert part.measures.gap_mm <= 1e-6
    assert part.measures.min_bend_radius_mm == pytest.approx(RADIUS, rel=0.01)
    assert part.name == "D0000"


@pytest.mark.parametrize("turn", [0.8, 2.5])
def test_a_cone_unrolls_to_its_sector(turn):
    structure = build(cone(turn), [Patches(3)])
    (part,) = structure.parts
    # Each of the 12 facets opens by the same angle about the tip.
    facet = 2 * math.asin(0.6 * math.sin(turn / 24))
    assert part.area == pytest.approx(12 * 0.5 * (3000**2 - 1000**2) * math.sin(facet), rel=1e-9)
    assert part.measures.gap_mm <= 1e-6
    lengths = np.linalg.norm(
        np.roll(part.pattern.outline, -1, axis=0) - part.pattern.outline, axis=1
    )
    assert lengths.sum() == pytest.approx(4000 + 12 * 8000 * math.sin(facet / 2), rel=1e-9)
    check_solids(structure)


def test_cut_along_lines_the_pieces_are_the_whole():
    whole = build(cylinder(), [Patches(6)]).parts[0]
    lines = Selection("v", (2, 6))
    structure = build(cylinder(), [Patches(6)], selection=lines)
    assert [part.name for part in structure.parts] == ["D0000", "D0001", "D0002"]
    # Two joints of 10 mm along generators of the whole length.
    joints = 2 * 10 * LENGTH
    assert sum(part.area for part in structure.parts) == pytest.approx(
        whole.area - joints, rel=1e-9
    )
    texts = {mark.text for mark in structure.parts[1].pattern.marks if mark.text}
    assert {"D0000", "D0002", "V003", "U001"} <= texts
    check_solids(structure)
    assert not check_clashes(structure.parts).clashes


@pytest.mark.parametrize("family", ["u", "v"])
def test_strips_cut_from_a_sheet_are_bent_as_it_is(family):
    """Rings and generators of a cylinder, and lines that run aslant to the rulings."""
    strips = build(cylinder(), [Patches(6)], selection=Selection(family)).parts
    radii = [part.measures.min_bend_radius_mm for part in strips]
    # Along generators each strip is one plane face wide; along rings it bends like the whole.
    assert radii == ([pytest.approx(RADIUS, rel=2e-3)] * 7 if family == "u" else [None] * 10)
    sheet = bent_sheet().scaled(1000.0)
    (whole,) = build(sheet, [Patches(3)]).parts
    strips = build(sheet, [Patches(3)], selection=Selection(family)).parts
    sharpest = min(part.measures.min_bend_radius_mm for part in strips)
    assert sharpest <= 1010.0
    assert sharpest == pytest.approx(whole.measures.min_bend_radius_mm, rel=0.1)


def test_pieces_too_narrow_for_a_circle_are_left_out_and_named():
    x, y = np.meshgrid(np.arange(5.0), np.arange(4.0), indexing="ij")
    net = grid_mesh(1000.0 * np.stack([x, y, 0 * x], axis=-1))
    wide, narrow = (
        np.array([(a, 200, 0), (b, 200, 0), (b, 2800, 0), (a, 2800, 0)], dtype=float)
        for a, b in ((300, 3000), (3300, 3340))
    )
    structure = build(net, [Patches(2)], border=[wide, narrow])
    report = structure.report()["patches"]
    assert len(report["left_out"]) == 1
    assert report["left_out_mm2"] == pytest.approx(40 * 2600, rel=1e-3)
    (part,) = structure.parts
    assert part.area == pytest.approx(2700 * 2600, rel=1e-3)


def test_strips_of_a_sheet_that_is_bent_too_far_fail_as_it_does(tmp_path):
    sheet = bent_sheet().scaled(1000.0)
    for name, lines in (("whole", Selection()), ("strips", Selection("u"))):
        write(build(sheet, [Patches(10)], selection=lines), tmp_path / name)
        with (tmp_path / name / "parts.csv").open(newline="") as stream:
            rows = list(csv.DictReader(stream))
        worst = max(rows, key=lambda row: float(row["stress_MPa"]))
        assert 900 < float(worst["stress_MPa"]) < 1200
        assert worst["verdict"].startswith("bending stress 1") and "355 MPa" in worst["verdict"]


@pytest.mark.parametrize("long", [5.0, 30.0])
def test_names_of_lines_cross_no_line(long):
    """Faces six times as long as wide, or square: each name lies in one face."""
    x, y = np.meshgrid(long * np.arange(5), 5.0 * np.arange(7), indexing="ij")
    (part,) = build(grid_mesh(np.stack([x, y, 0 * x], axis=-1)), [Patches(0.5)]).parts
    texts = [mark for mark in part.pattern.marks if mark.text]
    lines = [shapely.LineString(mark.points) for mark in part.pattern.marks if not mark.text]
    lines.append(shapely.Polygon(part.pattern.outline).exterior)
    assert len({mark.text for mark in texts}) == len(texts) == 3 + 5
    for mark in texts:
        wide = mark.size * np.array([len(mark.text), 1.0]) / 2
        box = shapely.affinity.rotate(shapely.box(*-wide, *wide), mark.angle, origin=(0, 0))
        box = shapely.affinity.translate(box, *mark.points[0])
        assert mark.size > 0.1 * 5 and not any(box.intersects(line) for line in lines)


def test_joints_are_as_wide_as_asked_for():
    """In place and in the patterns, also where the sheet bends aslant to the cuts."""
    sheet = bent_sheet().scaled(1000.0)
    pieces = build(sheet, [Patches(3, gap=8)], selection=Selection("u")).parts
    for one, other in pairwise(pieces):
        apart = np.linalg.norm(one.points[:, None] - other.points[None], axis=2).min(axis=1)
        assert 7.9 < apart.min() <= 8.0
    whole = build(sheet, [Patches(3)]).parts[0]
    length = 3000.0
    lost = whole.area - sum(part.area for part in pieces)
    assert lost == pytest.approx(8 * length * (len(pieces) - 1), rel=0.01)
    assert not check_clashes(pieces).clashes
    with pytest.raises(InputError, match=r"gap: 400 mm leaves nothing of .* cut of D\d{4}; take"):
        build(cylinder(), [Patches(6, gap=400)], selection=Selection("v"))


def test_a_ring_must_be_cut_and_then_unrolls():
    with pytest.raises(InputError, match=r"closes on itself.*family and lines"):
        build(ring(), [Patches(6)])
    (part,) = build(ring(), [Patches(6)], selection=Selection("v", (0,))).parts
    # The cut is a joint of the piece with itself.
    around = 12 * 2 * RADIUS * math.sin(math.pi / 12) - 10
    assert sorted(part.pattern.size) == pytest.approx(sorted([LENGTH, around]), rel=1e-9)
    assert part.volume == pytest.approx(6 * part.area, rel=1e-9)
    assert part.solid().isValid()


def test_what_does_not_unroll_is_refused_in_one_line():
    dome = primitive("translational", 13, 13).scaled(1000.0)
    with pytest.raises(InputError, match=r"not developable.*%.*geodesic and Chebyshev"):
        build(dome, [Patches(3)])
    with pytest.raises(InputError, match="thinner plate"):
        build(cylinder(), [Patches(5000.0)])
    with pytest.raises(InputError, match="thickness"):
        Patches(0.0)
    # Three times around a cone of a wide angle the sector overlaps itself.
    with pytest.raises(InputError, match=r"overlaps itself|folds over"):
        build(cone(3.6 * math.pi), [Patches(3)])


def test_a_pattern_that_overlaps_itself_is_refused_even_where_the_sheet_does_not():
    away, angle = np.meshgrid(np.linspace(2, 4, 5), np.linspace(0, 12.0, 61), indexing="ij")
    rise = np.linspace(0, 3, 61)
    points = np.stack([away * np.cos(angle), away * np.sin(angle), rise + 0 * away], axis=-1)
    with pytest.raises(InputError, match="family and lines"):
        build(grid_mesh(1000 * points), [Patches(3, distortion=50.0)])


@pytest.fixture(scope="module")
def sphere_files(tmp_path_factory):
    """chebyshev_sphere as a developable net, model in m, and its files."""
    outcome = optimise(shared_mesh("chebyshev_sphere"), "geodesic-chebyshev")
    assert outcome.report.status == "converged"
    folder = tmp_path_factory.mktemp("patch")
    structure = build(outcome.mesh.scaled(1000.0), [Patches(2)])
    write(structure, folder)
    return structure, folder


def test_chebyshev_sphere_unrolls_in_one_piece(sphere_files):
    structure, folder = sphere_files
    report = structure.report()["patches"]
    assert report["distortion_max_percent"] <= 0.03
    assert report["distortion_max_mm"] <= 0.03
    check_solids(structure)
    ((name, solid),) = read_step(folder / "structure.step")
    assert name == "D0000"
    assert solid.isValid()
    assert solid.Volume() == pytest.approx(structure.parts[0].volume, rel=1e-6)
    with (folder / "distortion.csv").open(encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    assert len(rows) == len(structure.mesh.connectivity.edges)
    worst = max(abs(float(row["distortion_percent"])) for row in rows)
    assert worst == pytest.approx(report["distortion_max_percent"], abs=1e-6)


def test_the_pattern_reads_back(sphere_files):
    structure, folder = sphere_files
    block = ezdxf.readfile(folder / "flat.dxf").blocks["D0000"]
    (outline,) = block.query('LWPOLYLINE[layer=="CUT"]')
    points = np.array([point[:2] for point in outline.get_points()])
    assert polygon_area(points) == pytest.approx(structure.parts[0].area, rel=1e-6)
    inner = ~structure.mesh.connectivity.boundary_edges
    assert len(block.query('LINE[layer=="ENGRAVE"]')) >= inner.sum()
