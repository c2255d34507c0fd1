"""One test for every term: derivatives, zero on an exact solution, rigid motion, units."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import solver.terms
from solver.mesh.closest import Polyline, TriangleSurface
from solver.statics import VerticalLoads
from solver.terms.base import Term
from solver.terms.beyond_surface import BeyondSurface
from solver.terms.chebyshev import EqualEdges
from solver.terms.closeness import Closeness
from solver.terms.corner_guard import CornerGuard
from solver.terms.derivatives import derivative_error
from solver.terms.edge_guard import EdgeGuard
from solver.terms.edge_vectors import EdgeVectors
from solver.terms.equilibrium import Equilibrium
from solver.terms.evenness import Evenness
from solver.terms.face_angles import CircularFace
from solver.terms.face_guard import FaceGuard
from solver.terms.fairness import Fairness
from solver.terms.flatness import FlatWithin, slack_of
from solver.terms.gliding import Mirrored, OnCurve, OnPlane, OnSurface
from solver.terms.in_plane import InPlane
from solver.terms.isometry import Isometry
from solver.terms.koenigs_star import KoenigsStar
from solver.terms.medial_angle import MedialAngle
from solver.terms.multi import multi_net
from solver.terms.near_surface import NearSurface
from solver.terms.orthogonality import Orthogonality
from solver.terms.planarity import Planarity
from solver.terms.pull import Pull
from solver.terms.repetition import SameAngles, SameLengths
from solver.terms.spherical_star import SphericalStar
from solver.terms.star_angles import ConicalStar, EqualAngleStar, GeodesicStar
from solver.terms.tilted_line import TiltedLine
from solver.terms.umbrella import Umbrella
from tests.conftest import QuadMesh, grid_faces, surface_of_revolution, wavy_grid

ROWS, COLUMNS = 5, 4
COUNT = ROWS * COLUMNS


def grid(shape: Callable[[np.ndarray, np.ndarray], list[np.ndarray]]) -> QuadMesh:
    i, j = np.meshgrid(np.arange(float(ROWS)), np.arange(float(COLUMNS)), indexing="ij")
    return QuadMesh(np.stack(shape(i, j), axis=2).reshape(-1, 3), grid_faces(ROWS, COLUMNS))


STRAIGHT = grid(lambda i, j: [i, 1.5 * j, 0.3 * i - 0.3 * j])
BENT = grid(lambda i, j: [i, 1.5 * j, 0.1 * i**2 - 0.2 * j**2])
RECTANGLES = grid(lambda i, j: [i, 1.5 * j, 0 * i])
SQUARES = grid(lambda i, j: [1.3 * i, 1.3 * j, 0 * i])
RHOMBI = grid(lambda i, j: [i + 0.5 * j, np.sqrt(0.75) * j, 0 * i])
HELICOID = grid(lambda i, j: [(i - 2) * np.cos(0.4 * j), (i - 2) * np.sin(0.4 * j), 0.7 * j])
SPHERE = grid(
    lambda i, j: [
        4 * np.cos(0.2 * j) * np.cos(0.2 * i),
        4 * np.cos(0.2 * j) * np.sin(0.2 * i),
        4 * np.sin(0.2 * j),
    ]
)
MIRRORED = grid(lambda i, j: [i - 2, j, 0.3 * (i - 2) ** 2 + 0.1 * j])
BARREL = surface_of_revolution(ROWS, COLUMNS)
REST = wavy_grid(ROWS, COLUMNS, shear=0.1)
ALL = np.arange(COUNT)
AROUND = (np.arange(4)[:, None] + np.arange(4)) % 4
LENGTHS, SOME = np.array([[1.0], [1.5]]), np.linspace(0.5, 2.0, 31)
# Four edges at right angles: chords of neighbours and of opposite ones, all pairs in order.
CHORDS = np.sqrt(2.0), 2.0, np.sqrt(2.0), np.sqrt(2.0), 2.0, np.sqrt(2.0)
TWINS = np.array([[4 * i + j, 4 * (4 - i) + j] for i in range(2) for j in range(4)])


@dataclass(frozen=True)
class Case:
    """A term on a mesh and what must hold for it.

    Attributes:
        build: makes the term for a mesh; extra unknowns stand behind the coordinates.
        exact: a mesh, with the extra unknowns, on which the term vanishes.
        invariant: a rigid motion leaves the residual alone.
        at_solution: the Jacobian is that of the eliminated problem, exact where it is solved.
    """

    build: Callable[[QuadMesh], Term]
    exact: QuadMesh
    scalars: list[float] = field(default_factory=list)
    invariant: bool = True
    at_solution: bool = False


def following(term):
    return lambda m: term(m).follow(np.append(m.vertices.ravel(), np.zeros(9)))


def two_stars(mesh: QuadMesh) -> Equilibrium:
    """Balance of the inner vertices 5 and 9, each edge around them with a force of its own."""
    stars = mesh.connectivity.stars[[0, 2]]
    densities = 3 * COUNT + np.arange(8).reshape(2, 4)
    loads = VerticalLoads(mesh.connectivity, per_vertex=0.4)
    return Equilibrium(stars[:, 0], stars[:, 1:], densities, loads)


def curve_of(mesh: QuadMesh) -> Polyline:
    return Polyline([[-9.0, 0.2, 0.3], [3.0, 0.2, 0.3], [30.0, 8.0, 1.0]])


SHEET = TriangleSurface([[-50, -50, 0], [50, -50, 0], [0, 90, 0]], [[0, 1, 2]])

CASES = {
    "orthogonality": Case(lambda m: Orthogonality(m.faces), BARREL),
    "planarity": Case(lambda m: Planarity(m.faces), BARREL),
    "flat within": Case(
        lambda m: FlatWithin(m.faces, 3 * COUNT + np.arange(12), 0.2), BARREL, [0.0] * 12
    ),
    "multi-net": Case(lambda m: multi_net(m.connectivity), RECTANGLES),
    "multi-net 2 x 2": Case(lambda m: multi_net(m.connectivity, 2, 2), RECTANGLES),
    "circular": Case(lambda m: CircularFace(m.faces), BARREL),
    "conical": Case(lambda m: ConicalStar(m.connectivity.stars), RECTANGLES),
    "dual ratio": Case(
        lambda m: KoenigsStar(m.connectivity.stars, m.connectivity.diagonal_stars[:, 1:]), BARREL
    ),
    "geodesic": Case(lambda m: GeodesicStar(m.connectivity.stars), RHOMBI),
    "equal angles": Case(lambda m: EqualAngleStar(m.connectivity.stars), RECTANGLES),
    "equal edges": Case(lambda m: EqualEdges(m.connectivity.edges, length=1.3), SQUARES),
    "equal edges, free": Case(
        lambda m: EqualEdges(m.connectivity.edges, shared=3 * COUNT), SQUARES, [1.3]
    ),
    "medial angle": Case(lambda m: MedialAngle(m.faces, np.pi / 3), RHOMBI),
    "medial angle, free": Case(
        lambda m: MedialAngle(m.faces, shared=3 * COUNT), RHOMBI, [np.pi / 3]
    ),
    "tilt": Case(
        lambda m: TiltedLine(m.connectivity.stars, m.connectivity.stars[:, [1, 3]], (np.pi / 2,)),
        HELICOID,
    ),
    "tilt, free": Case(
        lambda m: TiltedLine(m.connectivity.stars, m.connectivity.stars[:, [4, 2]], shared=(60,)),
        HELICOID,
        [np.pi / 2],
    ),
    "tilts of both lines, one free": Case(
        lambda m: TiltedLine(
            m.connectivity.stars,
            np.stack([m.connectivity.stars[:, [1, 3]], m.connectivity.stars[:, [4, 2]]], axis=1),
            (np.pi / 2, 0.0),
            (None, 60),
        ),
        HELICOID,
        [np.pi / 2],
    ),
    "tilt of a diagonal": Case(
        lambda m: TiltedLine(
            m.connectivity.stars, m.connectivity.diagonal_stars[:, [1, 3]], (0.7,)
        ),
        STRAIGHT,
    ),
    "in plane": Case(
        lambda m: InPlane(ALL[:8], np.tile(3 * COUNT + np.arange(4), (8, 1))),
        STRAIGHT,
        [*(np.array([-0.3, 0.2, 1.0]) / np.linalg.norm([-0.3, 0.2, 1.0])), 0.0],
        False,
    ),
    "isometry": Case(lambda m: Isometry(m.faces, REST.vertices), REST),
    "asymptotic": Case(lambda m: SphericalStar(m.connectivity.stars, curvature=0.0), HELICOID),
    "sphere given": Case(lambda m: SphericalStar(m.connectivity.stars, curvature=-0.25), SPHERE),
    "sphere shared": Case(
        lambda m: SphericalStar(m.connectivity.stars, shared=3 * COUNT), SPHERE, [-0.25]
    ),
    "sphere own": Case(lambda m: SphericalStar(m.connectivity.stars), SPHERE, at_solution=True),
    "equilibrium": Case(two_stars, MIRRORED, [-1.0, 0.0, -1.0, 0.0, -1.0, 0.0, -1.0, 0.0], False),
    "fairness": Case(lambda m: Fairness(m.connectivity.line_triples), STRAIGHT),
    "evenness": Case(lambda m: Evenness(m.connectivity.line_quadruples), BENT),
    "smooth motion": Case(
        lambda m: Fairness(m.connectivity.line_triples, REST.vertices.ravel()), REST, [], False
    ),
    "smooth motion of rings": Case(
        lambda m: Umbrella(m.connectivity.stars, REST.vertices.ravel()), REST, [], False
    ),
    "edge vectors": Case(
        lambda m: EdgeVectors(m.connectivity.edges, REST.vertices.ravel()), REST, [], False
    ),
    "edge guard": Case(lambda m: EdgeGuard(m.connectivity.edges, 1.29), SQUARES),
    "face guard": Case(lambda m: FaceGuard(m.faces, 0.99), SQUARES),
    "corner guard": Case(lambda m: CornerGuard(m.faces, np.zeros((len(m.faces), 4))), SQUARES),
    "closeness": Case(lambda m: Closeness(ALL, REST.vertices), REST, [], False),
    "handles": Case(lambda m: Pull(ALL, REST.vertices, goals=REST.vertices + 1.0), REST, [], False),
    "on plane": Case(lambda m: OnPlane(ALL, np.array([0, 0, 1.0]), 0.0), SQUARES, [], False),
    "on surface": Case(following(lambda m: OnSurface(ALL, SHEET)), SQUARES, [], False),
    "near surface": Case(
        following(lambda m: NearSurface(ALL, SHEET, np.zeros((COUNT, 3)))), SQUARES, [], False
    ),
    "near surface, peaked": Case(
        following(lambda m: NearSurface(ALL, SHEET, np.zeros((COUNT, 3)), peak=0.1)),
        SQUARES,
        [],
        False,
    ),
    "beyond surface": Case(
        following(lambda m: BeyondSurface(m.faces, SHEET, 0.05)), SQUARES, [], False
    ),
    "on curve": Case(
        following(lambda m: OnCurve(ALL, curve_of(m))),
        grid(lambda i, j: [0.2 * i - 2 + 0.03 * j, 0.2 + 0 * i, 0.3 + 0 * i]),
        [],
        False,
    ),
    "same lengths": Case(
        lambda m: SameLengths(m.connectivity.edges, np.array([[0, 1]]), LENGTHS, SOME), RECTANGLES
    ),
    "same panels": Case(
        lambda m: SameLengths(
            m.faces,
            AROUND,
            np.array([[1.5, 3.25**0.5, 1, 1, 3.25**0.5, 1.5]]),
            np.linspace(0.5, 2, 12),
        ),
        RECTANGLES,
    ),
    "same lengths, free": Case(
        lambda m: SameLengths(
            *(m.connectivity.edges, np.array([[0, 1]]), LENGTHS, SOME),
            kind=(RECTANGLES.edge_lengths > 1.2).astype(int),
            turn=np.zeros(31, dtype=int),
            shared=np.array([[3 * COUNT], [3 * COUNT + 1]]),
        ),
        RECTANGLES,
        [1.0, 1.5],
    ),
    "same angles": Case(
        lambda m: SameAngles(m.connectivity.stars, AROUND, np.array([[*CHORDS]]), np.ones(6)),
        SQUARES,
    ),
    "mirrored": Case(lambda m: Mirrored(TWINS, 0, 0.0), MIRRORED, [], False),
}


@pytest.fixture(params=CASES)
def case(request) -> Case:
    return CASES[request.param]


def flat(points: np.ndarray, case: Case) -> np.ndarray:
    return np.append(points.ravel(), case.scalars)


def test_every_term_is_tested():
    built = {type(case.build(REST)).__name__ for case in CASES.values()}
    for path in Path(solver.terms.__file__).parent.glob("*.py"):
        module = __import__(f"solver.terms.{path.stem}", fromlist=["*"])
        for name, kind in inspect.getmembers(module, inspect.isclass):
            if kind.__module__ == module.__name__ and hasattr(kind, "linearise"):
                form = getattr(kind, "_is_protocol", False) or inspect.isabstract(kind)
                assert form or name.startswith("_") or name in built, name


def test_jacobian_agrees_with_central_differences(case):
    mesh = case.exact if case.at_solution else wavy_grid(ROWS, COLUMNS)
    term = case.build(mesh)
    noise = 0.0 if case.at_solution else 0.05
    x = flat(mesh.vertices, case)
    x = x + noise * np.random.default_rng(1).normal(size=len(x))
    residual, jacobian = term.linearise(x)
    assert residual.shape == jacobian.shape[:2]
    assert jacobian.shape == (*residual.shape, term.unknowns.shape[1])
    assert derivative_error(term, x) < 2e-8
    assert np.abs(jacobian).max() > 0.05


def test_vanishes_on_an_exact_solution_and_not_elsewhere(case):
    term = case.build(case.exact)
    x = flat(case.exact.vertices, case)
    if case is CASES["equilibrium"]:
        # Forces along the bent lines carry the load: 4 vertices beside, each 0.3 (i - 2)^2 high.
        x = x.copy()
        x[3 * COUNT :] = equilibrium_forces(term, x)
    assert np.abs(term.linearise(x).residual).max() < 1e-13
    bent = case.exact.vertices + 0.1 * np.random.default_rng(2).normal(size=(COUNT, 3))
    assert np.abs(term.linearise(flat(bent, case)).residual).max() > 1e-3


def equilibrium_forces(term: Equilibrium, x: np.ndarray) -> np.ndarray:
    """Forces on the mirrored sheet z = 0.3 i^2 + 0.1 j: only the lines along i are curved."""
    spans = (
        x[3 * term.neighbours[..., None] + np.arange(3)]
        - x[3 * term.centres[:, None, None] + np.arange(3)]
    )
    along_i = np.abs(spans[..., 0]) > 0.5
    # Two neighbours along i rise 0.6 together above the centre, whatever i is.
    return np.where(along_i, 0.4 / 0.6, 0.0).ravel()


def test_rigid_motion(case):
    mesh = case.exact if case.at_solution else wavy_grid(ROWS, COLUMNS)
    rotation = Rotation.from_euler("xyz", [0.3, -1.1, 2.0])
    turned = np.add(rotation.apply(mesh.vertices.copy()), [3.0, -2.0, 5.0])
    term = case.build(mesh)
    before = np.linalg.norm(term.linearise(flat(mesh.vertices, case)).residual, axis=1)
    after = np.linalg.norm(term.linearise(flat(turned, case)).residual, axis=1)
    assert np.allclose(before, after, rtol=0, atol=1e-12) == case.invariant


def test_linear_terms_have_a_constant_jacobian_that_all_elements_share(case):
    mesh = wavy_grid(ROWS, COLUMNS)
    term = case.build(mesh)
    here = term.linearise(flat(mesh.vertices, case)).jacobian
    if term.linear:
        there = term.linearise(flat(2 * mesh.vertices**2, case)).jacobian
        assert np.array_equal(here, there)
        assert (here == here[0]).all()


def test_slacks_stand_at_the_distances_of_faces_from_plane():
    gaps, limit = np.array([-0.5, -0.01, 0.0, 0.2, 0.7]), 0.8
    slack = slack_of(gaps, limit)
    np.testing.assert_allclose(slack / np.sqrt(1 + (slack / limit) ** 2), gaps, atol=1e-15)
    # Beyond the limit they stand within it, and can come back.
    beyond = slack_of(np.array([-3.0, 3.0]), limit)
    assert np.isfinite(beyond).all() and beyond[0] == -beyond[1] < slack[0]


# Of the terms that have no normals, centres or slacks: equations of the grid's 31 edges, 12 faces,
# 6 stars, 22 triples and 13 quadruples of its lines and 20 vertices.
EQUATIONS = {
    "fairness": 3 * 22,
    "smooth motion": 3 * 22,
    "evenness": 3 * 13,
    "edge vectors": 3 * 31,
    "edge guard": 31,
    "equal edges": 31,
    "face guard": 2 * 12,
    "corner guard": 4 * 12,
    "isometry": 3 * 12,
    "dual ratio": 6,
    "equilibrium": 3 * 2,
    "closeness": 3 * 20,
    "handles": 3 * 20,
    "on curve": 2 * 20,
    "on surface": 20,
    "in plane": 8 + 1,
    "mirrored": 3 * 8,
}
WITH_UNKNOWNS = {
    "flat within": (12, 12),
    "circular": (3 * 12, 4 * 12),
    "conical": (3 * 6, 5 * 6),
    "equal angles": (12 * 6, 15 * 6),
    "sphere own": (4 * 6, 5 * 6),
    "tilt": (6 * 6, 9 * 6),
    "tilts of both lines, one free": (9 * 6, 14 * 6),
}


def test_handles_come_nearer_to_their_goals_a_stride_at_a_time():
    begin, end = np.array([[2.0, 0.0, 0.0], [0.0, 0.2, 0.0]]), np.zeros((2, 3))
    pull = Pull(np.arange(2), begin, goals=end, stride=0.5).follow(np.zeros(6))
    assert np.allclose(pull.targets, 0.75 * begin, rtol=0, atol=1e-15)
    for _ in range(3):
        assert not pull.arrived
        pull = pull.follow(np.zeros(6))
    assert pull.arrived


def test_sizes_are_those_of_the_paper():
    wanted = WITH_UNKNOWNS | {name: (0, count) for name, count in EQUATIONS.items()}
    assert {name: CASES[name].build(REST).size for name in wanted} == wanted
    mesh = wavy_grid(ROWS, COLUMNS)
    faces, stars = 12, 6
    assert Orthogonality(mesh.faces).size == (0, faces)
    assert Planarity(mesh.faces).size == (3 * faces, 5 * faces)
    assert SphericalStar(mesh.connectivity.stars, curvature=0.0).size == (3 * stars, 5 * stars)
    assert GeodesicStar(mesh.connectivity.stars).size == (12 * stars, 14 * stars)


@pytest.mark.parametrize(
    "name", ["orthogonality", "planarity", "circular", "conical", "geodesic", "asymptotic"]
)
def test_net_terms_do_not_depend_on_the_size_of_a_face(name):
    case, mesh = CASES[name], wavy_grid(ROWS, COLUMNS)
    term = case.build(mesh)
    small = term.linearise(1e-3 * mesh.vertices.ravel()).residual
    assert np.allclose(small, term.linearise(mesh.vertices.ravel()).residual, rtol=0, atol=1e-13)
