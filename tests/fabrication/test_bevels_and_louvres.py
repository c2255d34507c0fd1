"""Bevelled panels: sides in the planes of the axes, gap the same everywhere. Louvres: rhombi."""

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.fabrication import Beams, Panels, build
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.systems import Louvres
from solver.errors import InputError
from solver.mesh.quadmesh import QuadMesh
from tests.fabrication.test_beam_sections_and_ends import assert_closed
from tests.fabrication.test_beams_and_panels import inset_area


def upright(structure, mesh, edge):
    """Unit normal of the plane that an edge and its axes share."""
    start, end = mesh.connectivity.edges[edge]
    normal = np.cross(structure.axes.directions[start], mesh.vertices[end] - mesh.vertices[start])
    return normal / np.linalg.norm(normal)


@pytest.mark.parametrize("offset", ["above", "centre", "below"])
@pytest.mark.parametrize("name", ["roof", "skewed", "dodecahedron"])
def test_bevelled_sides_are_half_a_gap_from_the_axes(meshes, name, offset):
    mesh = meshes[name]
    made = build(mesh, [Panels(40, 16, offset, "bevel")])
    net = mesh.connectivity
    for part in made.parts[::3]:
        assert_closed(part.body)
        for k in range(4):
            edge = net.face_edges[part.face, k]
            normal = upright(made, mesh, edge)
            corners = part.points[[k, (k + 1) % 4, k + 4, (k + 1) % 4 + 4]]
            distance = (corners - mesh.vertices[net.edges[edge, 0]]) @ normal
            assert np.abs(distance) == pytest.approx(8, abs=1e-6)
        solid = part.solid()
        assert solid.isValid()
        assert solid.Volume() == pytest.approx(part.volume)
    assert check_clashes(made.parts).clashes == ()


def test_bevelled_volume_is_that_of_a_frustum(skewed):
    made = build(skewed, [Panels(30, 12, "above", "bevel")])
    for part in made.parts[::4]:
        low, high = part.body.corners[:4, :2], part.body.corners[4:, :2]
        # Areas at both ends and in the middle: exact for sides that are planes.
        middle = area((low + high) / 2)
        assert part.volume == pytest.approx(30 / 6 * (area(low) + 4 * middle + area(high)))
        blank = part.pattern.outline
        assert part.pattern.area >= max(area(low), area(high)) - 1e-6
        assert area(blank) == pytest.approx(part.area)


def area(ring):
    x, y = ring.T
    return 0.5 * (x @ np.roll(y, -1) - y @ np.roll(x, -1))


def test_bevelled_panels_lie_on_beams(roof):
    made = build(roof, [Beams(160, 10), Panels(20, 12, edge="bevel")])
    assert check_clashes(made.parts).clashes == ()
    assert made.report()["panels"]["clear_gap_min_mm"] == pytest.approx(12)


@pytest.mark.parametrize("axis", ["u", "v"])
@pytest.mark.parametrize("tilt", [0, 25, -60])
def test_louvres_are_rhombi_between_midpoints(roof, axis, tilt):
    made = build(roof, [Louvres(6, 14, axis, tilt)])
    report = made.report()["louvres"]
    assert report["sides_differ_max_mm"] <= 1e-9  # the roof's diagonals are equal
    for part in made.parts:
        corner = roof.vertices[roof.faces[part.face]]
        points = (corner + np.roll(corner, -1, axis=0)) / 2
        assert part.area == pytest.approx(inset_area(points, 7.0))
        normal = roof.face_normals[part.face]
        angle = np.arcsin(np.linalg.norm(np.cross(part.frame[2], normal)))
        assert np.degrees(angle) == pytest.approx(abs(tilt), abs=1e-5)
        np.testing.assert_allclose(part.frame @ part.frame.T, np.eye(3), atol=1e-12)
        # The axis runs through two opposite midpoints, along its family.
        lines = [points[0] - points[2], points[1] - points[3]]
        aligned = [np.linalg.norm(np.cross(part.frame[0], x)) <= 1e-6 for x in lines]
        assert sum(aligned) == 1
        assert part.solid().isValid()
        assert part.solid().Volume() == pytest.approx(6 * part.area)
    other = build(roof, [Louvres(6, 14, "v" if axis == "u" else "u", tilt)])
    cosines = [
        one.frame[0] @ two.frame[0] for one, two in zip(made.parts, other.parts, strict=True)
    ]
    assert np.abs(cosines).max() <= 1e-9  # medial lines of an orthogonal net are square
    assert check_clashes(made.parts).clashes == ()


@pytest.mark.parametrize("axis", ["u", "v"])
def test_louvres_that_are_no_rhombi_shrink_until_their_shorter_sides_are_gone(axis):
    """Diagonals of 1789 and 894 mm, square to each other: half of them are the louvre's sides."""
    corners = np.array([[0, 0, 0], [1000, 0, 0], [1600, 800, 0], [600, 800, 0.0]])
    (part,) = build(QuadMesh(corners, [[0, 1, 2, 3]]), [Louvres(6, 440, axis)]).parts
    long, short = np.sqrt(800000), np.sqrt(200000)
    assert part.area == pytest.approx((long - 440) * (short - 440))
    with pytest.raises(InputError, match="louvre in face 0; take a gap below 447 mm"):
        build(QuadMesh(corners, [[0, 1, 2, 3]]), [Louvres(6, 500, axis)])


def test_plates_in_faces_are_as_thick_by_default_whether_panels_or_louvres(roof):
    for name in ("panels", "louvres"):
        assert {part.thickness for part in api.fabricate(roof, name).parts} == {12.0}


def test_louvres_between_beams(skewed):
    made = build(skewed, [Beams(160, 20), Louvres(6, 14, tilt=20)])
    assert check_clashes(made.parts).clashes == ()


@pytest.mark.parametrize(
    "system, values, words",
    [
        ("panels", {"panel_edge": "round"}, "panel edge: expected square or bevel"),
        ("panels", {"panel_edge": "bevel", "gap": 4000}, "gap: 4000 mm"),
        ("louvres", {"gap": 2000}, "leaves nothing of the louvre in face"),
        ("louvres", {"gap": 0.2, "thickness": 90}, "neighbours lean together"),
        ("louvres", {"tilt": 90}, "tilt: expected a number between -90 and 90 degrees, got 90"),
        ("louvres", {"louvre_axis": "w"}, "louvre axis: expected u or v, got 'w'"),
    ],
)
def test_settings_that_do_not_fit_are_one_line(roof, system, values, words):
    with pytest.raises(InputError, match=words) as caught:
        api.fabricate(roof, system, **values)
    assert "\n" not in str(caught.value)
