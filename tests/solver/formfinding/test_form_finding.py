"""Form-finding against shapes that are known: parabola, catenary, catenoid, sphere, arcs."""

from __future__ import annotations

import numpy as np
import pytest

from solver import InputError, QuadMesh
from solver.formfinding import (
    CableNet,
    Membrane,
    VertexLoads,
    family_densities,
    find_form,
    supported,
)
from solver.mesh.primitives import primitive
from solver.mesh.transform import similarity
from solver.multinet import rotational_net
from tests.conftest import wavy_grid


def ends(mesh: QuadMesh, across: int) -> np.ndarray:
    held = np.zeros(len(mesh.vertices), dtype=bool)
    held[:across] = held[-across:] = True
    return held


def check_equilibrium(found, held, tension, loads):
    """Forces at every vertex summed edge by edge, by other code than the solver's."""
    links, densities = tension.links(found.mesh)
    total = loads.forces(found.mesh).copy()
    for (i, j), q in zip(links.tolist(), densities.tolist(), strict=True):
        pull = q * (found.mesh.vertices[j] - found.mesh.vertices[i])
        total[i] += pull
        total[j] -= pull
    size = np.abs(densities).max() * found.mesh.mean_edge
    assert np.abs(total[~held]).max() < 1e-8 * size
    np.testing.assert_allclose(found.reactions[held], -total[held], rtol=0, atol=1e-9 * size)
    whole = loads.forces(found.mesh).sum(axis=0) + found.reactions.sum(axis=0)
    assert np.abs(whole).max() < 1e-8 * size * len(held)


def test_uniform_vertex_loads_hang_in_a_parabola():
    mesh = primitive("rectangle", 17, 4, length=16.0)
    held, net = ends(mesh, 4), CableNet(family_densities(mesh, u=3.0, v=0.0))
    loads = VertexLoads(vertex=(0, 0, -0.6))
    one_each = VertexLoads(vertex=np.tile([0, 0, -0.6], (len(mesh.vertices), 1)))
    np.testing.assert_array_equal(one_each.forces(mesh), loads.forces(mesh))
    found = find_form(mesh, held, net, loads)
    assert found.converged and found.iterations == 1
    x, _, z = found.mesh.vertices.T
    # q (z_left - 2 z + z_right) = 0.6 at unit steps: z = 0.1 (x^2 - 64), exactly.
    np.testing.assert_allclose(z, 0.1 * (x**2 - 64), rtol=0, atol=1e-11)
    np.testing.assert_allclose(found.mesh.vertices[:, :2], mesh.vertices[:, :2], rtol=0, atol=1e-12)
    check_equilibrium(found, held, net, loads)


def test_self_weight_hangs_in_a_catenary():
    errors = []
    for count in (9, 17, 33):
        mesh = primitive("rectangle", count, 3, length=2.0)
        q = 0.8 * (count - 1) / 2
        # Width 1: the middle row carries weight 1/2 a length, each border 1/4; horizontal pull 0.8.
        net = CableNet(family_densities(mesh, u=0.5 * q, v=0, border=0.25 * q))
        found = find_form(mesh, ends(mesh, 3), net, VertexLoads(area=(0, 0, -1)))
        assert found.converged
        x, _, z = found.mesh.vertices.T
        errors.append(np.abs(z - 0.8 * (np.cosh(x / 0.8) - np.cosh(1 / 0.8))).max())
    assert errors[-1] < 1e-3
    assert np.diff(np.log2(errors)).max() < -1.9


def test_beam_load_counts_every_edge_by_its_length():
    mesh = primitive("rectangle", 9, 5, length=2.0)
    net, loads = CableNet(40.0), VertexLoads(beam=(0, 0, -1))
    held = supported(mesh, "boundary")
    found = find_form(mesh, held, net, loads)
    assert found.converged
    check_equilibrium(found, held, net, loads)
    assert loads.forces(found.mesh)[:, 2].sum() == pytest.approx(-found.mesh.edge_lengths.sum())
    assert found.mesh.vertices[~held, 2].max() < 0


def test_cable_net_between_raised_corners_is_linear_and_saddle_shaped():
    mesh = primitive("rectangle", 9, 9)
    raised = mesh.vertices.copy()
    raised[[0, 80], 2] = 0.5
    start = mesh.with_vertices(raised)
    held = supported(start, "corners")
    weak = find_form(start, held, CableNet(family_densities(start, border=3.0)))
    strong = find_form(start, held, CableNet(family_densities(start, border=300.0)))
    assert weak.iterations == 1
    check_equilibrium(weak, held, CableNet(family_densities(start, border=3.0)), VertexLoads())
    assert weak.mesh.vertices[40] == pytest.approx([0, 0, 0.25])
    # Strong border cables are nearly straight, weak ones sag inward.
    side = [np.abs(found.mesh.vertices[4 * 9, 1]) for found in (weak, strong)]
    assert side[0] < side[1] - 0.05 and side[1] > 0.48
    # Scaling all densities changes nothing.
    again = find_form(start, held, CableNet(7 * family_densities(start, border=3.0)))
    np.testing.assert_allclose(again.mesh.vertices, weak.mesh.vertices, rtol=0, atol=1e-13)


def test_membrane_between_two_rings_is_a_catenoid():
    errors = []
    for count in (7, 13, 25):
        height = np.linspace(-0.5, 0.5, count)
        ring = np.stack([np.cosh(0.5) + 0 * height, height], axis=1)
        mesh = rotational_net(ring, 2 * count - 2)
        found = find_form(mesh, supported(mesh, "boundary"), Membrane(2.0))
        assert found.converged and found.iterations < 30
        x, y, z = found.mesh.vertices.T
        errors.append(np.abs(np.hypot(x, y) - np.cosh(z)).max())
    assert errors[-1] < 1e-3
    assert np.diff(np.log2(errors)).max() < -1.9


def test_membrane_under_pressure_is_a_sphere():
    errors = []
    for count in (7, 13, 25):
        ends_ = np.radians([10, 60])
        share = np.linspace(0, 1, count)[:, None]
        corner = np.stack([np.cos(ends_), np.sin(ends_)], axis=1)
        mesh = rotational_net(corner[0] + share * (corner[1] - corner[0]), 4 * count - 4)
        found = find_form(
            mesh, supported(mesh, "boundary"), Membrane(3.0), VertexLoads(pressure=6.0)
        )
        assert found.converged
        errors.append(np.abs(np.linalg.norm(found.mesh.vertices, axis=1) - 1).max())
    assert errors[-1] < 5e-4
    assert np.diff(np.log2(errors)).max() < -1.8


def test_cables_of_a_flat_membrane_are_arcs():
    mesh = primitive("rectangle", 13, 13)
    found = find_form(mesh, supported(mesh, "corners"), Membrane(2.0, cable=3.0))
    assert found.converged
    rim = found.mesh.vertices.reshape(13, 13, 3)[:, 0]
    assert np.abs(found.mesh.vertices[:, 2]).max() < 1e-12
    # Force over stress is the radius: three points of an arc of radius 1.5.
    one, two = rim[0, :2] - rim[6, :2], rim[-1, :2] - rim[6, :2]
    cross = abs(one[0] * two[1] - one[1] * two[0])
    radius = np.linalg.norm(one) * np.linalg.norm(two) * np.linalg.norm(one - two) / (2 * cross)
    assert radius == pytest.approx(1.5, rel=2e-3)
    assert (found.mesh.face_normals[:, 2] > 0.999).all()


def test_results_do_not_depend_on_place_and_unit():
    mesh = wavy_grid(7, 6)
    held = supported(mesh, "boundary")
    here = find_form(mesh, held, Membrane(1.0), VertexLoads(pressure=0.1)).mesh
    moved = similarity(mesh, scale=1000.0, degrees=(10, 20, 30), move=(5e3, 0, -2e3))
    there = find_form(moved, held, Membrane(1000.0), VertexLoads(pressure=0.1)).mesh
    expected = similarity(here, scale=1000.0, degrees=(10, 20, 30), move=(5e3, 0, -2e3))
    np.testing.assert_allclose(there.vertices, expected.vertices, rtol=0, atol=1e-7)


def test_no_equilibrium_is_said():
    mesh = primitive("rectangle", 7, 7)
    held = supported(mesh, "boundary")
    blown = find_form(mesh, held, Membrane(), VertexLoads(pressure=50.0), max_iterations=40)
    assert not blown.converged
    assert "lower the load" in blown.message
    seen = []
    find_form(
        mesh,
        held,
        Membrane(),
        VertexLoads(pressure=1.0),
        callback=lambda k, f: seen.append(k) or k == 2,
    )
    assert seen == [1, 2]


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda m: supported(m, "roof"), "boundary, corners"),
        (lambda m: supported(m, "3,99"), "0 to 11"),
        (lambda m: supported(primitive("sphere", 6, 5), "corners"), "no corners"),
        (lambda m: find_form(m, supported(m, "1"), CableNet(0.0)), "hang on no support"),
        (lambda m: find_form(m, np.ones(12, dtype=bool), CableNet()), "every vertex is held"),
        (lambda m: find_form(m, supported(m, "1"), CableNet([1.0, 2.0])), "densities"),
        (
            lambda m: find_form(m, supported(m, "1"), CableNet(), VertexLoads(area=(1, 2))),
            "area load",
        ),
        (lambda m: Membrane(stress=-1.0), "stress"),
        (lambda m: Membrane(cable=-1.0), "cable"),
        (
            lambda m: find_form(m, supported(m, "1"), CableNet(), VertexLoads(pressure=np.nan)),
            "pressure",
        ),
    ],
)
def test_bad_input_is_one_line(call, words):
    with pytest.raises(InputError, match=words) as caught:
        call(wavy_grid(4, 3))
    assert "\n" not in str(caught.value)
