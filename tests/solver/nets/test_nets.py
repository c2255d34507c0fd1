"""Every net to machine precision on its required meshes, judged by independent measures."""

from __future__ import annotations

import functools

import numpy as np
import pytest

from solver import InputError, QuadMesh, optimise
from solver.analysis import measures, spheres
from solver.nets.options import NetOptions
from solver.report import Outcome
from tests.conftest import shared_mesh
from tests.meshes import START_MESHES, noisy, right_angles

# What must vanish in each net, on every face, edge or star.
MEASURES = {
    "principal": (right_angles, measures.planarity),
    "planar": (measures.planarity,),
    "circular": (measures.planarity, measures.circular),
    "conical": (measures.planarity, measures.conical),
    "geodesic": (right_angles, measures.geodesic),
    "dog": (measures.equal_angles,),
    "chebyshev": (right_angles, measures.chebyshev),
    "geodesic-chebyshev": (right_angles, measures.geodesic, measures.chebyshev),
    "asymptotic": (right_angles, measures.asymptotic),
    "cmc": (right_angles, spheres.cmc),
}
DIAGONAL_MEASURES = {
    right_angles,
    measures.geodesic,
    measures.asymptotic,
    measures.equal_angles,
    measures.chebyshev,
    spheres.cmc,
}

REQUIRED = [
    *[
        (net, name, False)
        for net in ("principal", "circular", "conical")
        for name in ("heart", "conical1", "botanic-garden-bubble-0", "complete01")
    ],
    *[("planar", name, False) for name in ("botanic-garden-bubble-0", "6-sub-lifted")],
    *[
        (net, name, False)
        for net in ("geodesic", "dog", "geodesic-chebyshev")
        for name in ("chebyshev_sphere", "bent sheet")
    ],
    ("chebyshev", "chebyshev_sphere", False),
    ("chebyshev", "gnet1", False),
    *[("asymptotic", name, False) for name in ("knet1", "scherk", "helicoid")],
    *[("asymptotic", name, True) for name in ("enneper2", "complete01")],
    *[("cmc", name, False) for name in ("cmc1", "unduloid")],
]
# Starts that are far from the net, or nearer to another one.
HARD = [
    ("cmc", "wein99_diag", False),
    ("cmc", "wein99_diag", True),
    ("geodesic", "gnet1", False),
    ("asymptotic", "helical-minimal", False),
]
SLOW = {
    ("chebyshev", "gnet1", False),
    ("geodesic-chebyshev", "chebyshev_sphere", False),
    *HARD,
}


def identity(case: tuple[str, str, bool]) -> str:
    net, name, diagonal = case
    return f"{net}{' --diagonal' if diagonal else ''} {name}"


def cases() -> list:
    return [
        pytest.param(*case, marks=[pytest.mark.slow] if case in SLOW else [], id=identity(case))
        for case in [*REQUIRED, *HARD]
    ]


@functools.cache
def start_mesh(name: str) -> QuadMesh:
    return noisy(exact_mesh(name)) if name in START_MESHES else exact_mesh(name)


def exact_mesh(name: str) -> QuadMesh:
    return START_MESHES[name]() if name in START_MESHES else shared_mesh(name)


@functools.cache
def solved(net: str, name: str, diagonal: bool = False) -> Outcome:
    return optimise(start_mesh(name), net, options=NetOptions(diagonal=diagonal))


def worst(net: str, mesh: QuadMesh, diagonal: bool) -> float:
    values = []
    for measure in MEASURES[net]:
        settings = {"diagonal": diagonal} if measure in DIAGONAL_MEASURES else {}
        values.append(measure(mesh, **settings))
    assert all(len(value) and np.isfinite(value).all() for value in values)
    return max(float(value.max()) for value in values)


def extents(mesh: QuadMesh) -> np.ndarray:
    """Root mean squares along the principal axes, in mean edges, the largest first."""
    centred = mesh.vertices - mesh.vertices.mean(axis=0)
    sizes = np.linalg.svd(centred, compute_uv=False)
    return sizes / np.sqrt(len(centred)) / mesh.mean_edge


@pytest.mark.parametrize(("net", "name", "diagonal"), cases())
def test_nets_to_machine_precision(net, name, diagonal):
    start = start_mesh(name)
    outcome = solved(net, name, diagonal)
    mesh, report = outcome.mesh, outcome.report
    assert report.status == "converged", report.message
    assert worst(net, mesh, diagonal) <= 1e-10
    assert worst(net, start, diagonal) > 1e-5
    assert measures.edge_ratio(mesh) >= 0.25 * measures.edge_ratio(start)
    assert not measures.flipped(mesh).any()
    assert (mesh.faces == start.faces).all()
    # A plane would be every net at once: the shape must have stayed one.
    assert extents(mesh)[2] >= 0.5 * extents(start)[2]
    assert report.moved.mean <= 4.0


@pytest.mark.parametrize("net", ["principal", "conical", "geodesic", "asymptotic", "cmc"])
def test_same_input_same_bytes(net):
    name = {"asymptotic": "scherk", "cmc": "unduloid"}.get(net, "bent sheet")
    start = start_mesh(name)
    again = optimise(start.with_vertices(start.vertices.copy()), net)
    assert again.mesh.vertices.tobytes() == solved(net, name).mesh.vertices.tobytes()
    assert again.report.iterations == solved(net, name).report.iterations


def test_a_given_radius_is_kept():
    start = start_mesh("unduloid")
    outcome = optimise(start, "cmc", options=NetOptions(radius=1.03))
    assert outcome.report.status == "converged"
    signed = float(np.copysign(1.03, spheres.common_radius(start)))
    assert spheres.cmc(outcome.mesh, radius=signed).max() <= 1e-10
    assert abs(spheres.common_radius(outcome.mesh)) == pytest.approx(1.03, abs=1e-10)


@pytest.mark.parametrize("net", ["principal", "circular", "conical"])
def test_nets_of_planar_faces_have_no_diagonal_variant(net):
    words = f"diagonal: only geodesic, .* have it, not {net}; leave it out"
    with pytest.raises(InputError, match=words):
        optimise(start_mesh("bent sheet"), net, options=NetOptions(diagonal=True))


@pytest.mark.parametrize("net", ["geodesic", "asymptotic", "cmc", "conical"])
def test_unit_and_place_do_not_matter(net):
    name = {"asymptotic": "scherk", "cmc": "unduloid"}.get(net, "bent sheet")
    start = start_mesh(name)
    turn = np.linalg.qr(np.random.default_rng(4).normal(size=(3, 3)))[0]
    turn *= np.sign(np.linalg.det(turn))
    elsewhere = start.with_vertices(1000 * start.vertices @ turn.T + [500.0, -300.0, 200.0])
    outcome = optimise(elsewhere, net)
    expected = 1000 * solved(net, name).mesh.vertices @ turn.T + [500.0, -300.0, 200.0]
    assert outcome.report.status == "converged"
    assert np.abs(outcome.mesh.vertices - expected).max() < 1e-7 * elsewhere.mean_edge
