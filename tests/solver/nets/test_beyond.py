"""Nets that followed the paper: asymptotic at one angle, pseudo-geodesic, with plane lines."""

from __future__ import annotations

import functools

import numpy as np
import pytest

from solver import InputError, QuadMesh, optimise
from solver.analysis import lines, measures
from solver.analysis.advisor import advise
from solver.mesh.combed import Combed
from solver.mesh.primitives import primitive
from solver.nets.options import NetOptions
from tests.meshes import (
    constant_ratio,
    deformed,
    freeform_roof,
    freeform_saddle,
    grid,
    noisy,
    small_circles,
)


def reached(start: QuadMesh, net: str, **options):
    outcome = optimise(start, net, options=NetOptions(**options))
    assert outcome.report.status == "converged", outcome.report.message
    assert max(spread.max for spread in outcome.report.residuals.values()) <= 1e-10
    return outcome.mesh, outcome.report


def with_turned_faces(mesh: QuadMesh) -> QuadMesh:
    """The same mesh, each face but the first written from a corner of its own."""
    first = np.random.default_rng(3).integers(0, 4, len(mesh.faces))
    first[0] = 0
    places = (first[:, None] + np.arange(4)) % 4
    return QuadMesh(mesh.vertices, np.take_along_axis(mesh.faces, places, axis=1))


def around_one_vertex(count: int, size: int = 3) -> QuadMesh:
    """A bent disk of ``count`` square patches around one vertex."""
    points, faces, numbers = [], [], {}

    def number(place):
        key = tuple(np.round(place, 6))
        if key not in numbers:
            numbers[key] = len(points)
            points.append([*place, 0.02 * place[0] ** 2 - 0.03 * place[1] ** 2])
        return numbers[key]

    for k in range(count):
        one, two = 2 * np.pi * k / count, 2 * np.pi * (k + 1) / count
        u, v = np.array([np.cos(one), np.sin(one)]), np.array([np.cos(two), np.sin(two)])
        at = [[number(i * u + j * v) for j in range(size + 1)] for i in range(size + 1)]
        for i in range(size):
            for j in range(size):
                faces.append([at[i][j], at[i + 1][j], at[i + 1][j + 1], at[i][j + 1]])
    return QuadMesh(np.array(points), np.array(faces))


@pytest.mark.parametrize("ratio", [0.5, 2.0])
def test_lines_of_a_surface_of_one_curvature_ratio_cross_at_its_angle(ratio):
    angle = np.degrees(2 * np.arctan(np.sqrt(ratio)))
    exact = [constant_ratio(n, n, ratio) for n in (15, 29)]
    off = [measures.uneven_angle(mesh).max() for mesh in exact]
    assert off[1] < 0.3 * off[0] < 1e-3
    assert measures.asymptotic(exact[1]).max() < 0.15 * measures.asymptotic(exact[0]).max()
    mesh, report = reached(noisy(exact[0]), "asymptotic-angle")
    assert report.details["angle"] == pytest.approx(angle, abs=1.5)
    a, b, c, d = mesh.vertices[mesh.faces].transpose(1, 0, 2)
    one, two = b + c - a - d, c + d - a - b
    sizes = np.linalg.norm(one, axis=1) * np.linalg.norm(two, axis=1)
    found = np.degrees(np.arccos((one * two).sum(axis=1) / sizes))
    assert np.ptp(found) < 1e-8 and measures.asymptotic(mesh).max() < 1e-10


def test_an_angle_that_is_given_bends_the_saddle_either_way_whatever_corner_faces_begin_at():
    start = freeform_saddle(16, 14)
    mesh, report = reached(start, "asymptotic-angle", angle=75.0)
    assert np.degrees(measures.medial_angles(mesh.vertices[mesh.faces])) == pytest.approx(75.0)
    assert report.form.off_surface.percent < 5 and report.form.zigzag > 0.85
    again, _ = reached(with_turned_faces(start), "asymptotic-angle", angle=75.0)
    assert np.abs(again.vertices - mesh.vertices).max() < 1e-6 * mesh.mean_edge
    other, _ = reached(start, "asymptotic-angle", angle=105.0)
    assert np.degrees(measures.medial_angles(other.vertices[other.faces])) == pytest.approx(105.0)


@pytest.mark.parametrize("angle", [None, 60.0])
def test_slanted_lines_cross_at_one_angle_that_is_found_or_given(angle):
    start = freeform_roof(14, 12)
    pushed = start.vertices + 0.4 * start.vertices[:, [1]] * [1.0, 0.0, 0.0]
    drawn = start.with_vertices(pushed)
    mesh, report = reached(drawn, "isogonal", angle=angle)
    found = np.degrees(measures.medial_angles(mesh.vertices[mesh.faces]))
    slant = np.degrees(np.arctan2(1.0, 0.4))
    assert np.ptp(found) < 1e-8
    assert found.mean() == pytest.approx(angle or slant, abs=1e-8 if angle else 2.0)
    if angle is None:
        assert report.details["angle"] == pytest.approx(found.mean(), abs=1e-8)
    # A coarse grid: a quarter of that on one twice as fine.
    assert report.form.off_surface.percent < 3.0
    assert report.form.zigzag > report.form.zigzag_start - 0.01
    turned, _ = reached(with_turned_faces(drawn), "isogonal", angle=angle)
    assert np.abs(turned.vertices - mesh.vertices).max() < 1e-6 * mesh.mean_edge


def test_families_that_are_exchanged_around_a_vertex_have_no_angle_but_a_right_one():
    assert [Combed(around_one_vertex(n).connectivity).families for n in (3, 4, 5, 6)] == [
        *(False, True, False, True)
    ]
    assert [Combed(around_one_vertex(n).connectivity).oriented for n in (4, 6, 8)] == [
        *(True, False, True)
    ]
    with pytest.raises(InputError, match="only a right angle is the same for all faces"):
        optimise(around_one_vertex(5), "asymptotic-angle")
    with pytest.raises(InputError, match="only a right angle"):
        optimise(around_one_vertex(5), "isogonal")
    with pytest.raises(InputError, match="only a right angle"):
        optimise(around_one_vertex(3), "orthogonal", options=NetOptions(angle=80.0))
    with pytest.raises(InputError, match="an even number of faces meet"):
        optimise(around_one_vertex(5), "web")
    with pytest.raises(InputError, match=r"give --tilt-u and --tilt-v of 90 .*or 180"):
        optimise(around_one_vertex(6), "pseudo-geodesic")


def test_directions_are_those_of_a_grid_however_faces_are_written():
    mesh = with_turned_faces(freeform_roof(6, 5))
    combed = Combed(mesh.connectivity)
    moved = mesh.vertices[combed.stars[:, 1:]] - mesh.vertices[combed.stars[:, :1]]
    along = moved[0, 0, :2] / np.linalg.norm(moved[0, 0, :2])
    across = np.array([-along[1], along[0]])
    for k, direction in enumerate((along, across, -along, -across)):
        assert (moved[:, k, :2] @ direction > 0.5).all()
    edges = mesh.vertices[mesh.connectivity.edges]
    signed = combed.edge_signs[:, None] * (edges[:, 1] - edges[:, 0])[:, :2]
    assert (np.maximum(signed @ along, signed @ across) > 0.5).all()


def test_small_circles_of_a_sphere_have_the_tilt_of_their_radius():
    mesh = small_circles(radius=50.0)
    for family in (0, 1):
        tilt = lines.common_tilt(*lines.family_bends(mesh, family))
        assert np.degrees(tilt) == pytest.approx(40.0, abs=0.1)
    assert lines.tilt(mesh).max() < 1e-5
    # Of a surface that is no sphere the nearest net has tilts of its own.
    near, report = reached(deformed(mesh, 0.05), "pseudo-geodesic")
    for family, name in enumerate(("tilt u", "tilt v")):
        tilt = np.degrees(lines.common_tilt(*lines.family_bends(near, family)))
        assert report.details[name] == pytest.approx(tilt % 180.0, abs=1e-6)
    assert report.form.off_surface.percent < 0.1


@functools.cache
def tilted_roof() -> QuadMesh:
    mesh, report = reached(freeform_roof(16, 14), "pseudo-geodesic", tilt_u=40.0, tilt_v=140.0)
    assert report.form.off_surface.percent < 0.5 and report.form.area_ratio > 0.95
    assert report.form.zigzag > report.form.zigzag_start - 0.02
    return mesh


def test_lines_bend_at_the_angles_that_are_given_and_the_roof_stays():
    mesh = tilted_roof()
    stars = Combed(mesh.connectivity).stars
    at = mesh.vertices[stars]
    normal = np.cross(at[:, 1] - at[:, 3], at[:, 2] - at[:, 4])
    for family, wanted in ((0, 40.0), (1, 140.0)):
        into, out = at[:, 0] - at[:, 3 + family], at[:, 1 + family] - at[:, 0]
        into, out = (v / np.linalg.norm(v, axis=1)[:, None] for v in (into, out))
        bend, along = out - into, into + out
        left = np.cross(normal, along)
        upright = np.cross(along, left)
        left /= np.linalg.norm(left, axis=1)[:, None]
        upright /= np.linalg.norm(upright, axis=1)[:, None]
        side, up = (np.einsum("ij,ij->i", bend, each) for each in (left, upright))
        counted = np.linalg.norm(bend, axis=1) > 1e-3
        assert counted.mean() > 0.9
        found = np.degrees(np.arctan2(side, up))[counted] % 180
        assert found == pytest.approx(wanted, abs=1e-6)


def test_a_tilted_net_is_told_from_others():
    found = advise(tilted_roof())
    assert found[0].net == "pseudo-geodesic" and found[0].distance < 1e-10


@pytest.mark.parametrize(("plane", "allowed"), [("one", 0.5), ("both", 0.7)])
def test_lines_of_a_roof_lie_in_planes_and_faces_are_flat(plane, allowed):
    start = deformed(primitive("translational", 13, 11), 0.03)
    mesh, report = reached(start, "planar-lines", plane=plane)
    assert report.form.off_surface.percent < allowed and report.form.zigzag > 0.9
    assert measures.planarity(mesh).max() < 1e-10
    off = [lines.off_plane(mesh, family).max() for family in "uv"]
    assert min(off) < 1e-10 and (max(off) < 1e-10) == (plane == "both")
    listed = np.reshape(report.details["planes"], (-1, 4))
    chosen = lines.long_lines(mesh, "uv" if plane == "both" else "uv"[int(np.argmin(off))])
    for line, (*normal, far) in zip(chosen, listed, strict=True):
        assert np.abs(mesh.vertices[line.vertices] @ normal - far).max() < 1e-9 * mesh.mean_edge
        assert np.linalg.norm(normal) == pytest.approx(1.0)
        points = mesh.vertices[line.vertices] - mesh.vertices[line.vertices].mean(axis=0)
        assert np.linalg.svd(points, compute_uv=False)[2] < 1e-9 * mesh.mean_edge


@pytest.mark.parametrize("kind", ["aag", "agg", "ggg"])
def test_three_families_of_a_web_run_straight_on_a_freeform_saddle(kind):
    start = freeform_saddle(14, 12)
    mesh, report = reached(start, "web", web=kind)
    assert report.form.off_surface.percent < 1.5
    assert report.form.zigzag > report.form.zigzag_start - 0.02
    assert lines.web(mesh, kind).max() < 1e-10 < 1e-4 < lines.web(start, kind).max()
    combed = Combed(mesh.connectivity)
    at, corners = mesh.vertices[combed.stars], mesh.vertices[combed.diagonal_stars]
    normal = np.cross(at[:, 1] - at[:, 3], at[:, 2] - at[:, 4])
    normal /= np.linalg.norm(normal, axis=1)[:, None]

    def plain(points, k):
        """Volume of normal, edge before and after: none where a line runs straight on."""
        into, out = points[:, 0] - points[:, k + 2], points[:, k] - points[:, 0]
        into, out = (v / np.linalg.norm(v, axis=1)[:, None] for v in (into, out))
        return np.abs(np.einsum("ij,ij->i", np.cross(into, out), normal)).max()

    straight = [plain(at, k) < 1e-10 for k in (1, 2)] + [
        any(plain(corners, k) < 1e-10 for k in (1, 2))
    ]
    assert sum(straight) == kind.count("g")
    if kind == "aag":
        flat = np.einsum("ijk,ik->ij", at[:, 1:] - at[:, :1], normal)
        assert np.abs(flat).max() < 1e-10 * mesh.mean_edge


@pytest.mark.parametrize("net", ["orthogonal", "isogonal", "isothermic"])
def test_lines_with_noise_are_drawn_even_and_even_ones_are_left_as_they_were(net):
    roof = freeform_roof(12, 10)
    start = noisy(roof, 0.1)
    found = {weight: optimise(start, net, evenness=weight).report.form for weight in (None, 0.0)}
    assert found[None].zigzag_start < 0 and found[None].zigzag > 0.5 > found[0.0].zigzag + 0.5
    even = [optimise(roof, net, evenness=weight).mesh.vertices for weight in (None, 0.0)]
    assert np.array_equal(*even)


def test_noise_does_not_crumple_a_net_whose_lines_lie_in_planes():
    start, both = noisy(freeform_roof(12, 10), 0.1, 3), NetOptions(plane="both")
    form = optimise(start, "planar-lines", options=both).report.form
    # With the noise taken as drawn it ends at -0.2 and 3.4 %.
    assert form.zigzag > 0.8 and form.off_surface.percent < 1.5


@pytest.mark.parametrize(("net", "options"), [("asymptotic-angle", {}), ("web", {"web": "aag"})])
def test_a_saddle_across_its_asymptotic_lines_is_told_soon_and_never_called_a_success(net, options):
    u, v = np.meshgrid(np.linspace(-0.5, 0.5, 14), np.linspace(-0.5, 0.5, 11), indexing="ij")
    start = grid(30 * u + 3 * v, 20 * v - 4 * u, 12 * u**2 - 20 * v**2 + 2 * u * v)
    report = optimise(start, net, options=NetOptions(**options)).report
    assert report.status == "collapsed" and report.iterations <= 20
    assert "align it with lines for asymptotic-angle" in report.message
    assert report.warnings and "bend with the surface" in report.warnings[0]


def test_bad_options_of_these_nets_are_one_line():
    with pytest.raises(InputError, match="tilt u: expected 0 to 180 degrees, got 200"):
        NetOptions(tilt_u=200.0)
    with pytest.raises(InputError, match="plane: expected one, u, v or both, got 'w'"):
        NetOptions(plane="w")
    with pytest.raises(InputError, match="no line of family u has more than three vertices"):
        optimise(freeform_roof(3, 3), "planar-lines")
