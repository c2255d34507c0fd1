"""Stress nets: precision on real meshes, the catenary, signs of forces, bad supports."""

from __future__ import annotations

import time
from itertools import pairwise

import numpy as np
import pytest

from solver import Constraints, InputError, NetOptions, QuadMesh, optimise, start_optimisation
from solver.analysis import measures
from solver.mesh.closest import Polyline
from solver.nets.constraints import PlaneGlide
from solver.statics import VerticalLoads, start_densities, unbalanced
from tests.conftest import demo_roof, grid_faces, shared_mesh
from tests.meshes import hanging_net, right_angles


def force_left(mesh: QuadMesh, densities: np.ndarray, load: np.ndarray, free) -> float:
    return float(unbalanced(mesh.connectivity, mesh.vertices, densities, load, free).max())


@pytest.mark.parametrize("loading", ["load", "load_area"])
@pytest.mark.parametrize("name", ["quad_dome", "botanic-garden-bubble-0", "6-sub-lifted"])
def test_orthogonal_and_balanced_to_machine_precision(name, loading):
    start = shared_mesh(name)
    outcome = optimise(start, "stress", fix="boundary", options=NetOptions(**{loading: 2.5}))
    mesh, report = outcome.mesh, outcome.report
    assert report.status == "converged", report.message
    assert right_angles(mesh).max() <= 1e-10
    assert not measures.flipped(mesh).any()
    assert measures.edge_ratio(mesh) >= 0.25 * measures.edge_ratio(start)
    rim = mesh.connectivity.boundary_vertices
    assert (mesh.vertices[rim] == start.vertices[rim]).all()
    # Judged in model units and real forces, apart from the solver's own scaling.
    settings = {"per_vertex": 2.5} if loading == "load" else {"per_area": 2.5}
    load = VerticalLoads(mesh.connectivity, **settings).at(mesh.vertices.ravel())
    densities = np.array(report.details["force_densities"])
    assert force_left(mesh, densities, load, np.flatnonzero(~rim)) <= 1e-10


def hanging_strip(count: int) -> QuadMesh:
    """A strip three vertices wide that hangs in a parabola between its ends."""
    u = np.linspace(-1.0, 1.0, count)
    i, j = np.meshgrid(u, np.array([-0.1, 0.0, 0.1]), indexing="ij")
    points = np.stack([i, j, 0.9 * i**2], axis=2).reshape(-1, 3)
    return QuadMesh(points, grid_faces(count, 3))


def catenary_error(count: int) -> float:
    start = hanging_strip(count)
    ends = [*range(3), *range(3 * count - 3, 3 * count)]
    outcome = optimise(start, "stress", fix=ends, options=NetOptions(load_area=1.0))
    assert outcome.report.status == "converged", outcome.report.message
    line = outcome.mesh.vertices.reshape(count, 3, 3)[:, 1]
    assert np.abs(line[:, 1]).max() < 1e-12
    # Force density times run is the horizontal force, the same in every edge of the line.
    density = np.array(outcome.report.details["force_densities"])
    ways = {tuple(edge): q for edge, q in zip(start.connectivity.edges, density, strict=True)}
    middle = [3 * k + 1 for k in range(count)]
    pull = np.array(
        [
            ways[(a, b)] * (outcome.mesh.vertices[b, 0] - outcome.mesh.vertices[a, 0])
            for a, b in pairwise(middle)
        ]
    )
    assert pull.min() > 0
    assert np.ptp(pull) < 1e-10 * pull.mean()
    # The middle line carries half of the strips on both sides: width 0.1, weight 1 a unit of area.
    parameter = pull.mean() / 0.1
    place = int(np.argmin(line[:, 2]))
    smooth = parameter * (np.cosh(line[:, 0] / parameter) - 1.0)
    return float(np.abs(line[:, 2] - line[place, 2] - smooth + smooth[place]).max())


def test_a_hanging_net_is_a_catenary_to_second_order():
    coarse, fine = catenary_error(11), catenary_error(21)
    assert fine < 2e-3
    assert 3.0 < coarse / fine < 5.0


@pytest.mark.parametrize(("forces", "sign"), [("compression", -1), ("tension", 1)])
def test_forces_of_one_sign(forces, sign):
    start = shared_mesh("quad_dome")
    if sign > 0:
        start = start.with_vertices(start.vertices * [1, 1, -1])
    outcome = optimise(start, "stress", fix="boundary", options=NetOptions(forces=forces))
    assert outcome.report.status == "converged", outcome.report.message
    densities = sign * np.array(outcome.report.details["force_densities"])
    net = start.connectivity
    between = net.boundary_vertices[net.edges].all(axis=1)
    assert (densities[between] == 0).all()
    assert (densities[~between] > 0).all()


@pytest.mark.parametrize("sign", [0, 1])
def test_the_forces_of_a_start_that_hangs_are_found_exactly(sign):
    x, y = np.meshgrid(*[np.linspace(-30, 30, 61)] * 2, indexing="ij")
    points = np.stack([x, y, 0.01 * (x**2 + y**2)], axis=2).reshape(-1, 3)
    net = QuadMesh(points, grid_faces(61, 61)).connectivity
    load, rim = np.ones(len(points)), net.boundary_vertices
    densities = start_densities(net, points, load, rim, sign)
    assert unbalanced(net, points, densities, load, np.flatnonzero(~rim)).max() <= 1e-10
    between = rim[net.edges].all(axis=1)
    assert (densities[between] == 0).all()
    assert densities[~between].min() > 0.1


def test_the_forces_of_a_start_that_one_sign_hardly_fits_are_found_soon():
    x, y = np.meshgrid(*[np.linspace(-1, 1, 30)] * 2, indexing="ij")
    height = 0.5 * (1 - x**2) * (1 - y**2) + 0.02 * x * y + 0.02 * np.sin(7.5 * x)
    points = 14.5 * np.stack([x, y, height], axis=2).reshape(-1, 3)
    net = QuadMesh(points, grid_faces(30, 30)).connectivity
    load, rim = np.ones(len(points)), net.boundary_vertices
    seconds = []
    for sign in (0, -1):
        begin = time.process_time()
        densities = start_densities(net, points, load, rim, sign)
        seconds.append(time.process_time() - begin)
    assert unbalanced(net, points, densities, load, np.flatnonzero(~rim)).max() <= 1e-3
    assert (densities[~rim[net.edges].all(axis=1)] <= -1e-3).all()
    assert seconds[1] <= 100 * seconds[0]


def test_forces_scale_with_the_load_and_the_unit():
    start = shared_mesh("cmc1")
    one = optimise(start, "stress", fix="boundary", options=NetOptions(load=1.0))
    many = optimise(start.scaled(1e3), "stress", fix="boundary", options=NetOptions(load=50.0))
    assert np.allclose(1e3 * one.mesh.vertices, many.mesh.vertices, rtol=0, atol=1e-6)
    forces = [np.array(o.report.details["force_densities"]) for o in (one, many)]
    # Force density is force by length: fifty times the load, a thousand times the length.
    assert np.allclose(0.05 * forces[0], forces[1], rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize(
    ("fix", "options", "words"),
    [
        ((), {}, "component 0 has 0 supported vertices"),
        ([0, 1], {}, "component 0 has 2 supported vertices"),
        (range(33), {}, "every vertex is supported"),
        ("boundary", {"load": float("nan")}, "load: expected a finite number"),
        ("boundary", {"load": -1.0}, "sum to more than zero"),
        ("boundary", {"forces": "magic"}, "forces: expected free, compression or tension"),
    ],
)
def test_what_cannot_stand_is_refused_in_one_line(fix, options, words):
    with pytest.raises(InputError, match=words) as caught:
        optimise(hanging_strip(11), "stress", fix=fix, options=NetOptions(**options))
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("forces", ["free", "compression"])
def test_a_level_start_is_refused(forces):
    level = hanging_net()
    level = level.with_vertices(level.vertices * [1, 1, 0] + [0, 0, 7.3])
    with pytest.raises(InputError, match="the start lies level"):
        optimise(level, "stress", fix="boundary", options=NetOptions(forces=forces))


def test_supports_on_one_line_are_a_mechanism():
    mesh = hanging_net()
    edge = np.flatnonzero(mesh.vertices[:, 0] == mesh.vertices[:, 0].min())
    assert len(edge) > 3
    with pytest.raises(InputError, match="lie on one line and it would be a mechanism"):
        optimise(mesh, "stress", fix=edge, options=NetOptions(load=1.0))


def test_the_boundary_is_supported_where_nothing_is_said():
    start = hanging_net()
    said = start_optimisation(start, "stress", fix="boundary")
    unsaid = start_optimisation(start, "stress")
    net = start.connectivity
    assert (said.original.fixed == net.boundary_vertices).all()
    assert (unsaid.original.supported == net.boundary_vertices).all()
    assert (unsaid.original.fixed == net.corners).all()
    assert unsaid.held == ("supports",)
    assert not start_optimisation(start, "principal").original.fixed.any()


def test_supports_slide_along_the_border_and_nowhere_else():
    start = shared_mesh("6-sub-lifted")
    net, outcome = start.connectivity, optimise(start, "stress")
    assert outcome.report.status == "converged", outcome.report.message
    (loop,) = net.boundary_loops
    rim, curve = outcome.mesh.vertices[loop], Polyline(start.vertices[loop], closed=True)
    assert np.abs(curve.closest(rim)[0] - rim).max() < 1e-12 * start.mean_edge * len(loop)
    moved = np.linalg.norm(outcome.mesh.vertices - start.vertices, axis=1)
    assert moved[loop].max() > 1e-3 * start.mean_edge
    assert not moved[net.corners].any()
    some = loop[::3].tolist()
    named = start_optimisation(start, "stress", supports=some).original
    assert np.flatnonzero(named.fixed).tolist() == sorted(some)
    assert (named.supported == named.fixed).all()
    with pytest.raises(InputError, match="principal nets carry no loads"):
        optimise(start, "principal", supports="boundary")


def test_supports_slide_on_what_they_are_told_to():
    start = hanging_net()
    level = Constraints(glide=(PlaneGlide(2, float(start.vertices[0, 2])),))
    run = start_optimisation(start, "stress", constraints=level)
    names = [term.name for term in run.original.constraints]
    assert names.count("glide") == 1
    assert (run.original.supported == start.connectivity.boundary_vertices).all()


def forces_left(mesh: QuadMesh, densities, options: NetOptions, free) -> float:
    """Largest force that is left at a free vertex / mean load, by the definition of the loads."""
    points, edges = mesh.vertices, mesh.connectivity.edges
    span = points[edges[:, 1]] - points[edges[:, 0]]
    pull, load = np.zeros_like(points), np.full(len(points), float(options.load))
    np.add.at(pull, edges[:, 0], densities[:, None] * span)
    np.add.at(pull, edges[:, 1], -densities[:, None] * span)
    a, b, c, d = points[mesh.faces].transpose(1, 0, 2)
    areas = 0.5 * np.linalg.norm(np.cross(c - a, d - b), axis=1)
    weights = options.load_length * np.linalg.norm(span, axis=1)
    np.add.at(load, mesh.faces.ravel(), np.repeat(options.load_area * areas / 4, 4))
    np.add.at(load, edges.ravel(), np.repeat(weights / 2, 2))
    pull[:, 2] -= load
    return float(np.abs(pull[free]).max() / np.abs(load[free]).mean())


# Whole numbers on purpose: a macro may give them.
LOADS = {"vertex": (2, 0, 0), "area": (0, 3, 0), "length": (0, 0, 1.5), "mixed": (-0.3, 4, 1)}


@pytest.mark.parametrize("loads", LOADS.values(), ids=LOADS)
@pytest.mark.parametrize("forces", ["compression", "tension"])
def test_one_kind_of_force_is_reached_only_with_the_loads_that_were_asked(loads, forces):
    """A net that hangs is pulled, one that stands compressed; the other kind is never reached."""
    load, area, length = loads
    options = NetOptions(load=load, load_area=area, load_length=length, forces=forces)
    hanging = hanging_net(9, 8)
    for start, kind in (
        (hanging, "tension"),
        (hanging.with_vertices(hanging.vertices * [1, 1, -1]), "compression"),
    ):
        outcome = optimise(start, "stress", options=options, max_steps=60)
        free = ~start.connectivity.boundary_vertices
        densities = np.array(outcome.report.details["force_densities"])
        left = forces_left(outcome.mesh, densities, options, free)
        if kind == forces:
            assert outcome.report.status == "converged", outcome.report.message
            assert left < 1e-9
            assert (densities <= 0).all() if forces == "compression" else (densities >= 0).all()
        else:
            assert outcome.report.status != "converged" and left > 0.1


def test_a_roof_under_its_weight_stays_what_was_drawn_and_its_lines_are_smooth():
    """The corners of its border, of 80 degrees, are held: no net with right angles is smoother."""
    start = demo_roof()
    options = NetOptions(load_area=1.0, forces="compression")
    outcome = optimise(start, "stress", options=options)
    report, mesh = outcome.report, outcome.mesh
    assert report.status == "converged", report.message
    densities = np.array(report.details["force_densities"])
    free = ~start.connectivity.boundary_vertices
    assert (densities <= 0).all() and forces_left(mesh, densities, options, free) < 1e-9
    assert report.form.off_surface.percent <= 0.1
    assert 0.99 <= report.form.area_ratio <= 1.01
    assert report.form.zigzag >= 0.8
    corner = corner_angles(mesh)
    assert 60 <= corner.min() and corner.max() <= 120


def test_supports_slide_where_the_border_is_only_where_the_net_ends():
    """A face that sticks out has all its corners on the border, and would have no room."""
    count = 7
    u, v = np.meshgrid(np.linspace(-1, 1, count), np.linspace(-1, 1, count), indexing="ij")
    points = np.stack([u + 0.05 * v**2, v + 0.08 * u, 0.4 * (2 - u**2 - v**2)], axis=2)
    faces = grid_faces(count, count)
    # All of the first row but one face in its middle, and all but one of the last column.
    away = [0, 1, 3, 4, 5, *(6 * k + 5 for k in range(6) if k != 3)]
    kept = np.delete(np.asarray(faces), away, axis=0)
    used, numbers = np.unique(kept, return_inverse=True)
    start = QuadMesh(points.reshape(-1, 3)[used], numbers.reshape(-1, 4))
    rim = start.connectivity.boundary_vertices
    assert rim[start.faces].all(axis=1).any()
    outcome = optimise(start, "stress")
    assert outcome.report.status == "converged", outcome.report.message
    assert not measures.flipped(outcome.mesh).any()
    assert right_angles(outcome.mesh).max() <= 1e-10
    moved = np.linalg.norm(outcome.mesh.vertices - start.vertices, axis=1)[rim]
    assert 1e-3 < moved.max() < 0.3
    # Who says that the border stays is taken at his word.
    with pytest.raises(InputError, match="cannot move at all"):
        optimise(start, "stress", fix="boundary")


def corner_angles(mesh: QuadMesh) -> np.ndarray:
    """(F, 4) angles of the faces at their corners, in degrees."""
    points = mesh.vertices[mesh.faces]
    before, after = (np.roll(points, turn, axis=1) - points for turn in (1, -1))
    sine = np.linalg.norm(np.cross(before, after), axis=2)
    return np.degrees(np.arctan2(sine, (before * after).sum(axis=2)))
