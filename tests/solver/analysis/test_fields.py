"""Fields of meshes whose values are known."""

import numpy as np
import pytest

from solver.analysis.fields import field, fields, turning_radii
from solver.analysis.forces import edge_forces, force_densities
from solver.errors import InputError
from solver.mesh.closest import TriangleSurface
from solver.mesh.quadmesh import QuadMesh
from solver.statics import unbalanced
from tests.conftest import wavy_grid


def cylinder(radius, rows=12, columns=9):
    angle = np.linspace(0.0, 1.5, rows)
    height = np.linspace(0.0, 2.0, columns)
    a, h = np.meshgrid(angle, height, indexing="ij")
    points = np.stack([radius * np.cos(a), radius * np.sin(a), h], axis=2).reshape(-1, 3)
    number = np.arange(rows * columns).reshape(rows, columns)
    faces = np.stack([number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]], axis=2)
    return QuadMesh(points, faces.reshape(-1, 4))


@pytest.mark.parametrize("name", fields())
def test_every_field_has_one_value_a_place(name):
    mesh = wavy_grid(7, 6)
    reference = TriangleSurface.from_quads(mesh)
    result = field(mesh, name, reference)
    count = {"faces": 30, "vertices": 42, "edges": len(mesh.connectivity.edges)}[result.place]
    assert result.values.shape == (count,)
    assert np.isfinite(result.values).any()


@pytest.mark.parametrize("name", fields())
def test_dimension_is_the_power_of_the_length(name):
    mesh = wavy_grid(7, 6)
    one = field(mesh, name, TriangleSurface.from_quads(mesh.scaled(1.001)))
    large = mesh.scaled(1000.0)
    two = field(large, name, TriangleSurface.from_quads(large.scaled(1.001)))
    np.testing.assert_allclose(
        two.values,
        one.values * 1000.0**one.dimension,
        rtol=1e-7,
        atol=1e-12 * 1000.0**one.dimension,
    )


def test_turning_radius_of_a_cylinder_is_its_radius():
    mesh = cylinder(3.0)
    radii = turning_radii(mesh).reshape(12, 9)
    np.testing.assert_allclose(radii[1:-1], 3.0, rtol=1e-12)
    # The straight lines alone run through the inner vertices of the first and last circle.
    assert (radii[[0, -1], 1:-1] > 1e6).all()
    assert np.isnan(radii[[0, 0, -1, -1], [0, -1, 0, -1]]).all()


def test_gap_is_the_distance_to_the_reference():
    mesh = cylinder(3.0)
    reference = TriangleSurface.from_quads(mesh.with_vertices(mesh.vertices + [0.0, 0.0, 5.0]))
    gap = field(mesh, "Gap to reference", reference)
    np.testing.assert_allclose(gap.values.max(), 5.0, rtol=1e-12)
    with pytest.raises(InputError, match="no reference surface"):
        field(mesh, "Gap to reference")


def test_unknown_field_is_named():
    with pytest.raises(InputError, match=r"expected Orthogonality.*got 'Colour'"):
        field(wavy_grid(3, 3), "Colour")


@pytest.mark.parametrize("side", [9, 60])
def test_a_hanging_square_is_balanced_by_tension(side):
    flat = wavy_grid(side, side, height=0.0)
    x, y = (flat.vertices - flat.vertices.mean(axis=0))[:, :2].T
    # A translational paraboloid on a square grid carries equal loads by equal force densities.
    hanging = flat.with_vertices(np.stack([x, y, 0.25 * (x**2 + y**2)], axis=1))
    densities = force_densities(hanging)
    inner = np.flatnonzero(~hanging.connectivity.boundary_vertices)
    load = np.ones(len(hanging.vertices))
    left = unbalanced(hanging.connectivity, hanging.vertices, densities, load, inner)
    assert left.max() < 1e-10
    assert (edge_forces(hanging) > -1e-9).all()
