"""Each primitive is exactly the net that it says, or becomes it at the rate that it says."""

from __future__ import annotations

import numpy as np
import pytest

from solver import InputError
from solver.analysis import measures
from solver.analysis.spheres import cmc, common_radius
from solver.mesh.primitives import PRIMITIVES, primitive, tangent_developable, translational
from solver.mesh.primitives.translational import arch
from solver.multinet import multi_net_residual
from tests.solver.multinet.test_multi_nets import worst_of_all

PROFILE = [(3.0, 0.0), (2.0, 1.0), (2.5, 2.0), (1.0, 3.0)]
EXACT = 2e-12


def build(name, count, **parameters):
    if name == "rotational":
        parameters["profile"] = PROFILE
    return primitive(name, count, count, **parameters)


@pytest.mark.parametrize(
    ("name", "parameters"),
    [
        ("sphere", {}),
        ("sphere", {"angles": (10.0, 200.0), "radius": 1e4}),
        ("rotational", {}),
        ("cylinder", {}),
        ("cone", {}),
        ("catenoid", {}),
        ("unduloid", {"periods": 1.7}),
        ("tangent-developable", {}),
        ("rectangle", {"length": 3.0}),
    ],
)
def test_principal_exactly(name, parameters):
    mesh = build(name, 12, **parameters)
    for measure in (measures.planarity, measures.orthogonality, measures.circular):
        assert measure(mesh).max() < EXACT
    assert not measures.flipped(mesh).any()


@pytest.mark.parametrize(
    "name", ["sphere", "rotational", "cylinder", "cone", "catenoid", "helicoid", "ellipsoid"]
    + ["elliptic-paraboloid", "unduloid", "rectangle", "confocal-conics"]
)  # fmt: skip
def test_multi_nets_exactly(name):
    points = build(name, 11).vertices.reshape(11, 11, 3)
    assert worst_of_all(points) < 1e-13
    assert multi_net_residual(build(name, 11)).worst < 1e-13


@pytest.mark.parametrize(
    ("name", "lines", "measure"),
    [
        ("helicoid", "asymptotic", measures.asymptotic),
        ("helicoid", "asymptotic", measures.orthogonality),
        ("enneper", "asymptotic", measures.asymptotic),
        ("enneper", "principal", measures.planarity),
        ("helicoid", "principal", measures.planarity),
    ],
)
def test_minimal_surfaces_exactly(name, lines, measure):
    assert measure(build(name, 14, lines=lines)).max() < EXACT


@pytest.mark.parametrize(
    ("name", "parameters", "measure", "order"),
    [
        ("helicoid", {"lines": "principal"}, measures.orthogonality, 2),
        ("catenoid", {"lines": "asymptotic"}, measures.orthogonality, 2),
        ("catenoid", {"lines": "asymptotic"}, measures.asymptotic, 3),
        ("enneper", {"lines": "asymptotic"}, measures.orthogonality, 2),
        ("enneper", {"lines": "principal"}, measures.orthogonality, 2),
        ("scherk", {}, measures.orthogonality, 2),
        ("scherk", {}, measures.asymptotic, 3),
        ("scherk", {"lines": "principal"}, measures.orthogonality, 2),
        ("scherk", {"lines": "principal"}, measures.planarity, 5),
        ("ellipsoid", {"clear": 0.2}, measures.planarity, 2),
        ("elliptic-paraboloid", {"clear": 0.2}, measures.planarity, 2),
        ("unduloid", {"lines": "cmc", "periods": 0.5}, measures.orthogonality, 2),
        ("unduloid", {"lines": "cmc", "periods": 0.5}, cmc, 2),
    ],
)
def test_limits_at_their_rate(name, parameters, measure, order):
    errors = [measure(build(name, count, **parameters)).max() for count in (17, 33, 65)]
    rates = -np.diff(np.log2(errors))
    assert rates[-1] > order - 0.15
    assert errors[-1] < 2e-3


def test_cmc_lines_of_the_unduloid_have_its_radius():
    mesh = primitive("unduloid", 81, 81, lines="cmc", widest=1.3, narrowest=0.5)
    assert abs(common_radius(mesh)) == pytest.approx(1.8, rel=2e-3)
    assert not measures.flipped(mesh).any()


@pytest.mark.parametrize("modulus", [0.1, 0.4, 0.9])
def test_unduloid_profile_solves_its_equation(modulus):
    mesh = primitive("unduloid", 5, 4001, narrowest=modulus, periods=1.0)
    r = np.hypot(*mesh.vertices[:4001, :2].T)
    z = mesh.vertices[:4001, 2]
    slope = np.gradient(z, np.cumsum(np.append(0, np.hypot(np.diff(r), np.diff(z)))))
    # Delaunay: (1 + b) r dz/ds = r^2 + b for widest 1, narrowest b; extremes at the places said.
    assert np.abs((1 + modulus) * r * slope - r**2 - modulus)[2:-2].max() < 1e-5
    assert r.max() == pytest.approx(1, abs=1e-9)
    assert r.min() == pytest.approx(modulus, abs=1e-9)


def test_too_few_vertices_for_a_turn_are_refused():
    with pytest.raises(InputError, match="3 x 3 vertices some faces have no area; take more"):
        primitive("helicoid", 3, 3)
    assert len(primitive("helicoid", 4, 3).faces) == 6


@pytest.mark.parametrize("lines", ["principal", "asymptotic"])
def test_a_catenoid_is_as_high_as_was_asked_for(lines):
    z = primitive("catenoid", 9, 9, lines=lines, waist=2.0, height=3.0).vertices[:, 2]
    assert (z.min(), z.max()) == pytest.approx((-1.5, 1.5), rel=1e-14)


def test_points_lie_on_their_surfaces():
    x, y, z = primitive("ellipsoid", 12, 9, semi_axes=(3.0, 2.0, 1.2)).vertices.T
    assert np.abs(x**2 / 9 + y**2 / 4 + z**2 / 1.44 - 1).max() < 1e-13
    x, y, z = primitive("elliptic-paraboloid", 9, 8, first=2.0, second=1.0).vertices.T
    assert np.abs(x**2 / 4 + y**2 / 2 - z).max() < 1e-12
    for lines in ("asymptotic", "principal"):
        x, y, z = primitive("scherk", 9, 8, lines=lines).vertices.T
        assert np.abs(z - np.log(np.cos(y) / np.cos(x))).max() < 1e-12
    x, y, z = primitive("catenoid", 9, 8, lines="asymptotic", waist=2.0).vertices.T
    assert np.abs(np.hypot(x, y) - 2 * np.cosh(z / 2)).max() < 1e-12


def test_angles_turn_a_helicoid_of_curvature_lines_along_itself():
    still = primitive("helicoid", 9, 7, lines="principal", pitch=3.0, angles=(0.0, 90.0)).vertices
    turned = primitive("helicoid", 9, 7, lines="principal", pitch=3.0, angles=(60.0, 90.0)).vertices
    turn = np.exp(1j * np.radians(60.0))
    here, there = still[:, 0] + 1j * still[:, 1], turned[:, 0] + 1j * turned[:, 1]
    assert np.abs(there - turn * here).max() < 1e-12
    assert turned[:, 2] == pytest.approx(still[:, 2] + 3.0 / 6)


def test_translational_nets_are_planar_and_chebyshev_where_edges_agree():
    mesh = primitive("translational", 12, 9)
    assert measures.planarity(mesh).max() < 1e-13
    edge = 2 * np.sin(0.05)
    arc = np.arange(10) * 0.1
    one = np.stack([np.sin(arc), 0 * arc, np.cos(arc)], axis=1)
    two = np.stack([0.6 * edge * np.arange(8), 0.8 * edge * np.arange(8), 0 * np.arange(8)], axis=1)
    assert measures.chebyshev(translational(one, two)).max() < 1e-13
    points = arch(21, 3.0, -0.7, (1.0, 0.0, 0.0))
    assert np.ptp(np.linalg.norm(np.diff(points, axis=0), axis=1)) < 1e-14
    np.testing.assert_allclose(
        points[[0, 10, -1]], [[-1.5, 0, 0], [0, 0, -0.7], [1.5, 0, 0]], atol=1e-14
    )


def test_tangent_developable_unrolls_to_equal_lengths():
    """Rulings are straight, and neighbouring ones meet on the spine, so that the sheet unrolls."""
    t = np.linspace(0, 2, 13)
    spine = np.stack([np.cos(t), np.sin(t), 0.4 * t**2], axis=1)
    mesh = tangent_developable(12, 6, spine=spine, width=0.7)
    lines = mesh.vertices.reshape(12, 6, 3)
    steps = np.diff(lines, axis=1)
    assert np.linalg.norm(np.cross(steps[:, 1:], steps[:, :-1]), axis=2).max() < 1e-14
    meet = [np.linalg.norm(lines[i + k] - spine[i + 1], axis=1) for k in (0, 1) for i in range(11)]
    np.testing.assert_allclose(meet[:11], meet[11:], atol=1e-13)


@pytest.mark.parametrize("name", PRIMITIVES)
def test_every_primitive_has_words_defaults_and_good_faces(name):
    mesh = build(name, 9)
    assert len(mesh.vertices) == 81
    assert measures.edge_ratio(mesh) > 0.02
    assert not measures.flipped(mesh).any()
    assert PRIMITIVES[name].meaning.endswith(".")


@pytest.mark.parametrize(
    ("name", "parameters", "words"),
    [
        ("dodecahedron", {}, "primitive: expected catenoid, "),
        ("sphere", {"radius": -1.0}, "a number above 0"),
        ("sphere", {"diameter": 1.0}, "radius, angles, latitudes, not 'diameter'"),
        ("sphere", {"radius": "big"}, "of the kind of 1.0"),
        ("sphere", {"latitudes": (-90.0, 10.0)}, "first latitude"),
        ("enneper", {"reach": 2.0}, "reach"),
        ("scherk", {"reach": 0.0}, "reach"),
        ("helicoid", {"lines": "straight"}, "asymptotic or principal"),
        ("ellipsoid", {"semi_axes": (2.0, 2.0, 1.0)}, "different"),
        ("unduloid", {"narrowest": 3.0}, "exchange"),
        ("tangent-developable", {"spine": [[0, 0, 0]]}, "expected 10 points"),
        ("cone", {"height": float("nan")}, "height: expected a finite number, got nan"),
    ],
)
def test_bad_parameters_get_one_line(name, parameters, words):
    with pytest.raises(InputError, match=words):
        primitive(name, 9, 9, **parameters)


@pytest.mark.parametrize("name", PRIMITIVES)
@pytest.mark.parametrize("sampling", [(1, 9), (9, 1), (0, 0), (-2, 9), (2.5, 9)])
def test_too_few_vertices_get_one_line(name, sampling):
    with pytest.raises(InputError, match=r"sampling: expected at least \d x \d vertices"):
        primitive(name, *sampling)
