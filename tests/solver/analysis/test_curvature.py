"""Curvatures on analytic surfaces: second order, right signs, Gauss-Bonnet, units."""

from __future__ import annotations

import numpy as np
import pytest

from solver import QuadMesh
from solver.analysis.curvature import (
    angle_defects,
    gauss_curvature,
    mean_curvature,
    vertex_areas,
)
from solver.analysis.gauss_image import gauss_image, gauss_image_area
from tests.conftest import surface_of_revolution, wavy_grid
from tests.meshes import UNDULOID_CURVATURE, bent_sheet, grid, parameters, unduloid


def sphere(u, v):
    return np.stack([np.cos(v) * np.cos(u), np.cos(v) * np.sin(u), np.sin(v)], axis=-1) * 2.0


def torus(u, v):
    ring = 3.0 + np.cos(v)
    return np.stack([ring * np.cos(u), ring * np.sin(u), np.sin(v)], axis=-1)


def helicoid(u, v):
    return np.stack([v * np.cos(u), v * np.sin(u), u], axis=-1)


def catenoid(u, v):
    return np.stack([np.cosh(v) * np.cos(u), np.cosh(v) * np.sin(u), v], axis=-1)


def zero(u, v):
    return 0.0 * u


# Point, H (towards the normal u x v) and K at parameters (u, v).
SURFACES = {
    "sphere": (sphere, lambda u, v: zero(u, v) - 0.5, lambda u, v: zero(u, v) + 0.25),
    "torus": (
        torus,
        lambda u, v: -(3.0 + 2 * np.cos(v)) / (2 * (3.0 + np.cos(v))),
        lambda u, v: np.cos(v) / (3.0 + np.cos(v)),
    ),
    "helicoid": (helicoid, zero, lambda u, v: -1 / (1 + v**2) ** 2),
    "catenoid": (catenoid, zero, lambda u, v: -1 / np.cosh(v) ** 4),
}

# A net along the parameters, one across them, and a sheared one with growing steps.
NETS = {
    "along": lambda s, t: (s, t),
    "turned": lambda s, t: (0.7 * s - 0.5 * t, 0.7 * s + 0.5 * t),
    "sheared": lambda s, t: (s + 0.4 * t + 0.15 * s**2, 0.8 * t + 0.1 * s * t),
}


def errors(surface, net, count):
    """Largest errors of H and K over the inner vertices of a count x count sampling."""
    position, mean, gauss = SURFACES[surface]
    u, v = NETS[net](*parameters(count, count, 1.2, 1.0))
    u, v = u + 0.3, v + 0.2
    mesh = grid(*np.moveaxis(position(u, v), -1, 0))
    inner = ~mesh.connectivity.boundary_vertices
    h, k = mean(u, v).ravel(), gauss(u, v).ravel()
    return (
        np.abs(mean_curvature(mesh) - h)[inner].max(),
        np.abs(gauss_curvature(mesh) - k)[inner].max(),
    )


@pytest.mark.parametrize("net", NETS)
@pytest.mark.parametrize("surface", SURFACES)
def test_both_curvatures_are_second_order(surface, net):
    table = np.array([errors(surface, net, count) for count in (17, 33, 65)])
    slopes = np.log2(table[:-1] / np.maximum(table[1:], 1e-300))
    exact = table[-1] < 1e-9
    assert ((slopes[-1] > 1.9) | exact).all(), (table, slopes)
    assert table[-1].max() < 2e-3


def test_curvature_follows_the_normal_and_the_unit():
    mesh = wavy_grid(9, 8)
    turned = QuadMesh(mesh.vertices, mesh.faces[:, ::-1])
    inner = ~mesh.connectivity.boundary_vertices
    h, k = mean_curvature(mesh)[inner], gauss_curvature(mesh)[inner]
    assert np.allclose(mean_curvature(turned)[inner], -h, rtol=1e-12, atol=1e-14)
    assert np.allclose(gauss_curvature(turned)[inner], k, rtol=1e-9, atol=1e-12)
    assert np.allclose(mean_curvature(mesh.scaled(1000.0))[inner], h / 1000, rtol=1e-9, atol=1e-15)
    assert np.allclose(gauss_curvature(mesh.scaled(1000.0))[inner], k / 1e6, rtol=1e-7, atol=1e-18)
    assert np.ptp(h) > 0.05


def test_a_closed_mesh_has_the_total_curvature_of_its_genus():
    count = 12
    turn = 2 * np.pi * np.arange(count) / count
    points = torus(*np.meshgrid(turn, turn + 0.1, indexing="ij")).reshape(-1, 3)
    corner = np.arange(count**2).reshape(count, count)
    ahead = np.roll(corner, -1, axis=0)
    quads = np.stack([corner, ahead, np.roll(ahead, -1, 1), np.roll(corner, -1, 1)], axis=2)
    ring = QuadMesh(points, quads.reshape(-1, 4))
    assert abs(angle_defects(ring).sum()) < 1e-12
    assert abs(gauss_image(ring).sum()) < 1e-12
    assert gauss_image_area(ring) == pytest.approx(8 * np.pi, rel=0.03)
    cube = QuadMesh(
        [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)],
        [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]],
    )
    assert np.allclose(angle_defects(cube), np.pi / 2, rtol=1e-14)
    assert np.allclose(gauss_image(cube), np.pi / 2, rtol=1e-14)
    assert vertex_areas(cube).sum() == pytest.approx(6.0)


def test_with_planar_faces_the_gauss_image_is_the_angle_defect():
    mesh = surface_of_revolution()
    inner = ~mesh.connectivity.boundary_vertices
    assert np.allclose(gauss_image(mesh)[inner], angle_defects(mesh)[inner], rtol=0, atol=1e-13)
    assert (gauss_image(mesh)[inner] > 1e-3).all()


@pytest.mark.parametrize("surface", ["torus", "helicoid"])
def test_gauss_image_area_is_the_integral_of_k(surface):
    position, _, gauss = SURFACES[surface]
    misses = []
    for count in (17, 33, 65):
        u, v = NETS["sheared"](*parameters(count, count, 1.2, 1.0))
        mesh = grid(*np.moveaxis(position(u, v), -1, 0))
        inner = ~mesh.connectivity.boundary_vertices
        integral = (gauss(u, v).ravel() * vertex_areas(mesh))[inner]
        misses.append(np.abs(gauss_image(mesh)[inner] - integral).max() / np.abs(integral).min())
    assert (np.log2(np.array(misses[:-1]) / misses[1:]) > 1.85).all()
    assert gauss_image_area(mesh) == pytest.approx(np.abs(integral).sum(), rel=1e-2)


def test_a_bent_sheet_has_no_gauss_curvature():
    sheets = [bent_sheet(count, count) for count in (9, 17, 33)]
    gauss = np.array([np.nanmax(np.abs(gauss_curvature(sheet))) for sheet in sheets])
    areas = np.array([gauss_image_area(sheet) for sheet in sheets])
    assert (np.log2(gauss[:-1] / gauss[1:]) > 1.8).all()
    assert (np.log2(areas[:-1] / areas[1:]) > 3).all()
    assert gauss[-1] < 2e-3
    assert areas[-1] < 1e-5
    assert np.nanmax(np.abs(mean_curvature(sheets[-1]))) > 0.3


def test_the_unduloid_has_its_curvature():
    misses = []
    for count in (29, 57):
        mesh = unduloid(count, count)
        misses.append(np.nanmax(np.abs(np.abs(mean_curvature(mesh)) - UNDULOID_CURVATURE)))
    assert np.log2(misses[0] / misses[1]) > 1.85
    assert misses[1] < 1e-3


def test_the_boundary_has_no_value():
    mesh = wavy_grid(5, 6)
    rim = mesh.connectivity.boundary_vertices
    for values in (gauss_curvature(mesh), mean_curvature(mesh), gauss_image(mesh)):
        assert values.shape == (30,)
        assert (np.isnan(values) == rim).all()
