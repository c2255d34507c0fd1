"""Louvres, bent panels and patches at the border of a surface: cut there, and whole parts."""

import numpy as np
import pytest
import shapely
from scipy.spatial import cKDTree

from freecad_ortho.fabrication import BentPanels, Panels, Patches, Selection, build
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.systems import Louvres
from freecad_ortho.fabrication.systems.bent_panels.trimmed import trimmed_plate
from solver.analysis.measures import diagonal_distances
from tests.fabrication.test_patches import cylinder
from tests.meshes import bent_sheet


def on_grid(points, along, across, middle=None):
    """A closed curve on a grid of points (M, N, 3): an ellipse in rows and columns."""
    angle = np.linspace(0, 2 * np.pi, 240, endpoint=False)
    centre = (np.array(points.shape[:2]) - 1) / 2 if middle is None else np.array(middle)
    row, column = centre[0] + along * np.sin(angle), centre[1] + across * np.cos(angle)
    i, j = row.astype(int), column.astype(int)
    s, t = (row - i)[:, None], (column - j)[:, None]
    first = (1 - t) * points[i, j] + t * points[i, j + 1]
    return (1 - s) * first + s * ((1 - t) * points[i + 1, j] + t * points[i + 1, j + 1])


@pytest.fixture(scope="module")
def border(roof):
    """An outer border on the roof, an opening in it, and one within a face."""
    points = roof.vertices.reshape(7, 10, 3)
    outer, opening = on_grid(points, 2.6, 4.1), on_grid(points, 0.8, 1.3)
    return [outer, opening, on_grid(points, 0.2, 0.2, (4.5, 2.5))]


def assert_whole_parts(structure):
    for part in structure.parts:
        solid = part.solid()
        assert solid.isValid(), part.name
        assert solid.Volume() == pytest.approx(part.volume, rel=1e-9), part.name
        outline = shapely.Polygon(part.pattern.outline, part.pattern.cutouts)
        assert outline.is_valid
        assert part.area == pytest.approx(outline.area)
        assert part.volume == pytest.approx(part.area * part.thickness, rel=2e-3)
        assert outline.contains(shapely.Point(part.pattern.label))
        for mark in part.pattern.marks:
            assert outline.buffer(1e-6).covers(shapely.MultiPoint(mark.points))
    assert len({part.name for part in structure.parts}) == len(structure.parts)
    assert check_clashes(structure.parts).clashes == ()
    assert not any("run on over the border" in words for words in structure.report()["messages"])


@pytest.mark.parametrize("tilt", [0.0, 40.0])
def test_louvres_are_cut_as_they_lie_and_then_turned(roof, border, tilt):
    structure = build(roof, [Louvres(20, 15, tilt=tilt)], border=border)
    assert_whole_parts(structure)
    report = structure.report()["louvres"]
    assert report["trimmed"] > 5
    assert len(structure.parts) < len(roof.faces)
    lying = build(roof, [Louvres(20, 15)], border=border)
    for part, flat in zip(structure.parts, lying.parts, strict=True):
        assert part.pattern.outline == pytest.approx(flat.pattern.outline)
        # It turns about its axis.
        assert part.frame[0] == pytest.approx(flat.frame[0])
        assert part.frame[2] @ flat.frame[2] == pytest.approx(np.cos(np.radians(tilt)))


def test_narrow_louvres_at_the_border_are_left_out_and_said(roof, border):
    report = build(roof, [Louvres(20, 15, least_width=400)], border=border).report()
    left_out = report["louvres"]["left_out"]
    assert left_out
    assert any(
        "louvres: left out at the border what is narrower than 400" in words
        for words in report["messages"]
    )


def test_bent_panels_are_cut_in_their_patterns(roof, border):
    structure = build(roof, [BentPanels(3, 10)], border=border)
    assert_whole_parts(structure)
    report = structure.report()["bent-panels"]
    assert report["trimmed"] > 5
    assert any(part.pattern.bends for part in structure.parts)


def test_a_patch_is_cut_in_its_pattern():
    """The net of a cylinder unrolls exactly, so what is left of it does."""
    mesh = cylinder()
    points = mesh.vertices.reshape(11, 8, 3)
    border = [on_grid(points, 4.6, 3.1), on_grid(points, 0.9, 0.7)]
    structure = build(mesh, [Patches(6)], border=border)
    assert_whole_parts(structure)
    (part,) = structure.parts
    assert part.name == "D0000"
    assert len(part.pattern.cutouts) == 1
    panels = build(mesh, [Panels(0.01, 0.001)], border=border).parts
    assert part.area == pytest.approx(sum(panel.area for panel in panels), rel=1e-3)


def test_cut_along_lines_patches_keep_their_joints_at_a_border():
    mesh = cylinder()
    border = [on_grid(mesh.vertices.reshape(11, 8, 3), 4.6, 3.1)]
    lines = Selection("v", (2, 6))
    structure = build(mesh, [Patches(6)], selection=lines, border=border)
    assert_whole_parts(structure)
    assert len(structure.parts) == 3
    names = {mark.text for part in structure.parts for mark in part.pattern.marks if mark.text}
    assert {"D0000", "D0001", "D0002"} <= names


@pytest.mark.parametrize("thickness", [2.0, 8.0])
def test_faces_that_are_not_plane_are_cut_along_their_surfaces(thickness):
    mesh = bent_sheet(10, 9)
    mesh = mesh.with_vertices(1000 * mesh.vertices)
    assert diagonal_distances(mesh).max() > 1
    border = [on_grid(mesh.vertices.reshape(10, 9, 3), 4.1, 3.4)]
    structure = build(mesh, [Patches(thickness)], border=border)
    assert_whole_parts(structure)


def test_bent_panels_leave_nothing_of_the_surface_out(roof, border):
    """Without gaps their patterns have the area of the faces within the border."""
    bent, panels = (
        build(roof, [system], border=border).parts
        for system in (BentPanels(0.01, 0.001, least_width=0), Panels(0.01, 0.001, least_width=0))
    )
    assert any(part.pattern.cutouts for part in bent)
    areas = [sum(part.area for part in parts) for parts in (bent, panels)]
    assert areas[0] == pytest.approx(areas[1], rel=1e-5)


def test_bent_panels_fold_back_from_their_patterns(roof, border):
    structure = build(roof, [BentPanels(3, 10)], border=border)
    assert structure.report()["bent-panels"]["refold_max_mm"] <= 1e-6
    seen = 0
    for plate in structure.results["bent-panels"].geometry:
        sides = plate.ribbon.strip.flat_points
        for piece in trimmed_plate(plate, structure.site.trimming):
            low, high = np.split(piece.body.points, 2)
            middle = cKDTree((low + high) / 2)
            for point in np.array(piece.outline.exterior.coords)[:-1]:
                ahead = [plate.ribbon.ahead(k, point[None])[0] for k in range(len(sides))]
                face = min(max(int((np.array(ahead) > 0).sum()) - 1, 0), len(sides) - 2)
                place, _ = plate.ribbon.placed(face, point[None])
                assert middle.query(place[0])[0] <= 1e-6
                seen += 1
    assert seen > 200
