"""Sheets and rows that are larger than a sheet are cut along lines of the net, files read back."""

import json
import math

import ezdxf
import numpy as np
import pytest

from freecad_ortho.fabrication import BentPanels, Patches, Selection, Workshop, build, write
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.pattern import polygon_area
from solver.errors import InputError
from solver.mesh.grid import grid_mesh
from tests.fabrication.test_lamellas import check_solids
from tests.fabrication.test_patches import LENGTH, RADIUS, TURN, cone, cylinder
from tests.meshes import grid

CHORD = 2 * RADIUS * math.sin(TURN / 20)


def outlines(folder):
    """The cut outline (N, 2) of each part, by its name, from its block."""
    blocks = ezdxf.readfile(folder / "flat.dxf").blocks
    found = {}
    for block in blocks:
        for outline in block.query('LWPOLYLINE[layer=="CUT"]'):
            found[block.name] = np.array([point[:2] for point in outline.get_points()])
    return found


def smallest_box(points):
    """Sides of the smallest rectangle along one of the outline's sides, the longer one first."""
    sides = np.roll(points, -1, axis=0) - points
    boxes = []
    for x, y in sides / np.linalg.norm(sides, axis=1)[:, None]:
        boxes.append(np.sort(np.ptp(points @ np.array([[x, -y], [y, x]]), axis=0))[::-1])
    return min(boxes, key=np.prod)


def written(structure, folder, size, **more):
    """Report and outlines of files whose sheets have a size."""
    write(structure, folder, workshop=Workshop(sheet=size, spacing=10, **more))
    report = json.loads((folder / "report.json").read_text())
    found = outlines(folder)
    assert list(found) == [part.name for part in structure.parts]
    assert report["sheets"]["too_large"] == []
    assert report["sheets"]["parts"] == len(found)
    return report, found


def test_a_sheet_is_cut_in_both_directions(tmp_path):
    size, gap = (1320.0, 1200.0), 8.0
    structure = build(cylinder(), [Patches(6, gap=gap, sheet=size, spacing=10)])
    report, found = written(structure, tmp_path, size)
    # Of 10 faces of 300 mm four fit, of 7 of 429 mm two.
    assert len(found) == 3 * 4
    for points in found.values():
        assert (smallest_box(points) <= np.array(size) - 2 * 10 + 1e-6).all()
    left = (LENGTH - 3 * gap) * (10 * CHORD - 2 * gap)
    assert sum(map(polygon_area, found.values())) == pytest.approx(left, rel=1e-6)
    assert any("1 patch cut along lines of the net into 12 parts" in w for w in report["messages"])
    assert not check_clashes(structure.parts).clashes
    check_solids(structure)


@pytest.mark.parametrize("across", [False, True])
@pytest.mark.parametrize("size", [(1020.0, 620.0), (620.0, 1020.0)])
def test_a_sheet_is_cut_the_way_that_makes_fewer_parts(size, across):
    """3000 x 900 mm on 1000 x 600: five strips in a row beat three by two, whatever lies along."""
    x, y = np.meshgrid(200.0 * np.arange(16), 150.0 * np.arange(7), indexing="ij")
    points = np.stack([x, y, 0 * x], axis=-1)
    mesh = grid_mesh(points.swapaxes(0, 1) if across else points)
    structure = build(mesh, [Patches(6, gap=4.0, sheet=size, spacing=10)])
    assert len(structure.parts) == 5
    assert sum(part.area for part in structure.parts) == pytest.approx((3000 - 4 * 4) * 900)


def test_a_sector_is_cut_until_its_curved_pieces_fit(tmp_path):
    size = (900.0, 700.0)
    structure = build(cone(2.5), [Patches(3, sheet="900x700")])
    (whole,) = build(cone(2.5), [Patches(3)]).parts
    _, found = written(structure, tmp_path, size)
    for points in found.values():
        assert (smallest_box(points) <= np.array(size) - 20 + 1e-6).all()
    area = sum(map(polygon_area, found.values()))
    assert 0.95 * whole.area < area < whole.area


@pytest.mark.parametrize("thickness", [3.0, 12.0])
def test_rows_are_cut_at_their_bends(tmp_path, thickness):
    """Each joint takes the gap, and what the plates need that lean together there."""
    size, gap = (1500.0, 600.0), 10.0
    rings = Selection("u" if len(rows("u")) == 7 else "v")
    (one, *_) = build(cylinder(), [BentPanels(thickness, gap)], selection=rings).parts
    panels = BentPanels(thickness, gap, sheet=size, spacing=10)
    structure = build(cylinder(), [panels], selection=rings)
    report, found = written(structure, tmp_path, size)
    pieces = [name for name in found if name.startswith(one.name)]
    assert pieces == [f"{one.name}-{number}" for number in (1, 2, 3)]
    for points in found.values():
        assert (smallest_box(points) <= np.array(size) - 20 + 1e-6).all()
    joint = gap / math.cos(TURN / 10 / 2) + thickness * math.tan(TURN / 10 / 2)
    wide = LENGTH / 7 - gap
    left = one.area - 2 * joint * wide
    assert sum(polygon_area(found[name]) for name in pieces) == pytest.approx(left, rel=1e-6)
    assert any("7 rows cut along lines of the net into 21 parts" in w for w in report["messages"])
    assert not check_clashes(structure.parts).clashes
    check_solids(structure)


def test_a_face_that_fits_no_sheet_is_the_only_one_that_does_not(tmp_path):
    """Faces 0.5 m long and one of 3 m among them: the others are cut to sheets all the same."""
    x, y = np.meshgrid([0.0, 500, 1000, 4000, 4500, 5000, 5500], [0.0, 400], indexing="ij")
    net = grid(x, y, 0 * x)
    for family in "uv":
        if len(build(net, [BentPanels(3)], selection=Selection(family)).parts) == 1:
            break
    panels = BentPanels(3, sheet=(1200, 600), spacing=10)
    structure = build(net, [panels], selection=Selection(family))
    assert [part.vertices for part in structure.parts] == [
        tuple(range(6)),
        tuple(range(4, 8)),
        tuple(range(6, 12)),
        tuple(range(10, 14)),
    ]
    write(structure, tmp_path, workshop=Workshop(sheet=(1200, 600)))
    report = json.loads((tmp_path / "report.json").read_text())
    assert report["sheets"]["too_large"] == [structure.parts[1].name]
    assert any("so that all but 1 fit on" in words for words in report["messages"])


def rows(family):
    return build(cylinder(), [BentPanels(3)], selection=Selection(family)).parts


def test_the_width_of_the_cut_counts(tmp_path):
    """A pattern that fills the room exactly does not once its outline is the tool's path."""
    size = (LENGTH + 20.0, 10 * CHORD + 20.0 + 1e-6)
    assert len(build(cylinder(), [Patches(6, sheet=size)]).parts) == 1
    structure = build(cylinder(), [Patches(6, sheet=size, kerf=2.0)])
    assert len(structure.parts) > 1
    written(structure, tmp_path, size, kerf=2.0)


def test_faces_that_fit_no_sheet_are_all_named(tmp_path):
    """The net is as coarse as it is: what is larger than a sheet still is named, part by part."""
    for system in (Patches(6, sheet="300x200"), BentPanels(3, sheet="300x200")):
        structure = build(cylinder(), [system])
        with pytest.raises(InputError, match="not fit on 300 x 200 mm") as refused:
            write(structure, tmp_path, workshop=Workshop(sheet=(300, 200)))
        assert all(part.name in str(refused.value) for part in structure.parts)


def test_a_size_that_is_none_is_refused():
    for system in (Patches, BentPanels):
        with pytest.raises(InputError, match="sheet: expected WxH in mm"):
            system(3.0, sheet="large")
