"""Shared volumes of convex pieces against other geometry, and the kernel kept out of the check."""

import pickle
from concurrent.futures import Executor, Future
from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import linprog
from scipy.spatial import ConvexHull, HalfspaceIntersection

from freecad_ortho.fabrication import Beams, build
from freecad_ortho.fabrication.bodies import BOX_CORNERS, BOX_SIDES
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.convex import convex_pieces, shared_volume, volume_bounds
from freecad_ortho.fabrication.systems import Nodes
from solver.mesh.quadmesh import QuadMesh
from tests.fabrication.conftest import grid_faces


@pytest.fixture(scope="module")
def drilled_hubs():
    """Two hubs of one size, drilled along their axes."""
    x, y = np.meshgrid(np.arange(4.0), np.arange(4.0), indexing="ij")
    points = 1000 * np.stack([x, y, 0 * x], axis=-1).reshape(-1, 3)
    plane = QuadMesh(points, grid_faces(4, 4))
    structure = build(plane, [Beams(200, 12, ends="hub"), Nodes("hub", bore=60)])
    inner = [5, 6]
    return [structure.results["nodes"].parts[vertex] for vertex in inner]


class Elsewhere(Executor):
    """Does the work here, on what would arrive in another process."""

    def __init__(self):
        self.works = 0

    def submit(self, function, /, *arguments):
        self.works += 1
        future = Future()
        travelled = pickle.loads(pickle.dumps((function, arguments)))
        future.set_result(travelled[0](*travelled[1]))
        return future


def stacked(hubs):
    """Five hubs that stand in each other: no pair of them is told apart without the kernel."""
    one, other = hubs
    return [
        replace(other, name=f"N{k}", origin=one.origin + np.array([0.0, 0.0, 30.0 * k]))
        for k in range(5)
    ]


def hull(points):
    """Corners and outward triangles of a convex hull."""
    points = points[ConvexHull(points).vertices]
    found = ConvexHull(points)
    loops = []
    for loop, plane in zip(found.simplices.tolist(), found.equations, strict=True):
        a, b, c = points[loop]
        outward = np.cross(b - a, c - a) @ plane[:3] > 0
        loops.append(tuple(loop if outward else loop[::-1]))
    return points, tuple(loops)


def box(low, high):
    return np.where(BOX_CORNERS, high, low).astype(float), BOX_SIDES


def shared(one, other):
    return shared_volume(convex_pieces([one]), convex_pieces([other]))


def by_halfspaces(one, other):
    """The volume by another way: the point deepest inside, then the dual hull (Qhull)."""
    planes = np.concatenate([ConvexHull(points).equations for points, _ in (one, other)])
    deepest = linprog(
        [0, 0, 0, -1],
        A_ub=np.column_stack([planes[:, :3], np.ones(len(planes))]),
        b_ub=-planes[:, 3],
        bounds=[(None, None)] * 3 + [(0, None)],
    )
    if deepest.status != 0 or deepest.x[3] < 1e-9:
        return 0.0
    return ConvexHull(HalfspaceIntersection(planes, deepest.x[:3]).intersections).volume


def test_shared_volume_of_random_hulls_is_that_of_their_halfspaces():
    random = np.random.default_rng(0)
    found = []
    for _ in range(60):
        one, other = (hull(random.normal(size=(10, 3)) * 100) for _ in range(2))
        other = (other[0] + random.normal(size=3) * 60, other[1])
        found.append(shared(one, other))
        assert found[-1] == pytest.approx(by_halfspaces(one, other), rel=1e-9)
        assert shared(other, one) == pytest.approx(found[-1], rel=1e-9)
    assert 5 < np.count_nonzero(found) < 60


def test_pieces_that_one_side_parts_are_known_to_share_nothing():
    """Without a cut, whichever of them is the first; no side of the other one would do."""
    base = hull(np.array([[0, 9, 0], [0, -9, 9], [0, -9, -9], [-5, 0, 0]], dtype=float))
    tip = hull(np.array([[0.1, 0, 0], [9, 9, 9], [9, -9, 9], [9, 0, -9]], dtype=float))
    for far, known in ((0.0, True), (-0.2, False)):
        pieces = convex_pieces([base, (tip[0] + (far, 0, 0), tip[1])])
        found = volume_bounds(pieces, np.array([[0, 1], [1, 0]]))
        assert ((found == 0) == known).all()


@pytest.mark.parametrize("nudge", [0.0, 1e-13, -1e-13, 1e-10, -1e-10, 1e-8, -1e-8])
def test_sides_in_nearly_one_plane_do_no_harm(nudge):
    """Where boolean operations on boundaries go wrong."""
    plate = box((0, 0, 0), (1000, 12, 120))
    turn = np.array([[1, nudge, 0], [-nudge, 1, nudge], [0, -nudge, 1]])
    for low, high, volume in [
        ((0, 0, 0), (1000, 12, 120), 1000 * 12 * 120),
        ((500, 0, 0), (2000, 12, 120), 500 * 12 * 120),
        ((500, -3, 0), (700, 15, 120), 200 * 12 * 120),
        ((1000, 0, 0), (2000, 12, 120), 0.0),
        ((200, 3, 20), (300, 9, 30), 100 * 6 * 10),
        ((0, 12, 0), (1000, 24, 120), 0.0),
    ]:
        corners, sides = box(low, high)
        assert shared(plate, (corners @ turn + nudge, sides)) == pytest.approx(volume, abs=5)


def test_a_hull_that_its_sides_do_not_describe_is_held_by_half_spaces():
    """A notched prism: more than it, and never less."""
    corners, _ = box((0, 0, 0), (10, 10, 10))
    notched = np.concatenate([corners, [[5, 5, 4]]])
    lid = tuple((4 + k, 4 + (k + 1) % 4, 8) for k in range(4))
    (piece,) = convex_pieces([(notched, (*BOX_SIDES[1:], *lid))])
    assert not piece.convex
    assert shared_volume([piece], convex_pieces([box((-1, -1, -1), (11, 11, 11))])) >= 1000 - 200


@pytest.mark.parametrize(
    "kind",
    [
        {"section": "plate"},
        {"section": "hollow", "section_width": 60},
        {"section": "I", "section_width": 60},
        {"section": "T", "section_width": 60, "ends": "hub"},
    ],
)
def test_beams_along_edges_never_need_the_kernel(roof, kind, monkeypatch):
    """Copies moved by a known way: the volume of what they share is exact for every section."""
    monkeypatch.setattr("OCP.BRepAlgoAPI.BRepAlgoAPI_Common", None)
    part = build(roof, [Beams(160, 8, **kind)]).parts[20]
    for move in ([0, 30, 0], [0, 159, 0], [2, 3, 3], [0, 161, 0]):
        copy = replace(part, name="copy", origin=part.origin + np.array(move) @ part.frame)
        check = check_clashes([part, copy])
        assert check.cut == 0
        clash = check.clashes[0].volume if check.clashes else 0.0
        monkeypatch.undo()
        assert clash == pytest.approx(part.solid().intersect(copy.solid()).Volume(), rel=1e-6)
        monkeypatch.setattr("OCP.BRepAlgoAPI.BRepAlgoAPI_Common", None)


def test_the_kernel_does_not_overrule_half_spaces(drilled_hubs, monkeypatch):
    """Whatever it finds beyond what convex pieces leave does not count."""
    one, other = drilled_hubs
    near = replace(other, origin=one.origin + np.array([0.0, 0.0, 199.0]))
    bound = float(np.ptp(one.body.outline, axis=0).prod())
    monkeypatch.setattr(
        "freecad_ortho.fabrication.clash._shared_volume", lambda one, other: 1000 * bound
    )
    (clash,) = check_clashes([one, near]).clashes
    assert clash.volume == pytest.approx(bound, rel=1e-9)


def test_a_check_can_be_stopped_between_any_two_cuts(drilled_hubs, monkeypatch):
    """Progress is told before every cut, and what it raises ends the check."""
    parts = stacked(drilled_hubs)
    cuts = []

    class Stop(Exception):
        pass

    def cut(one, other):
        cuts.append(one)
        return 0.0

    def progress(fraction):
        assert 0 <= fraction <= 1
        if len(cuts) == 3:
            raise Stop

    monkeypatch.setattr("freecad_ortho.fabrication.clash._shared_volume", cut)
    with pytest.raises(Stop):
        check_clashes(parts, progress=progress)
    assert len(cuts) == 3


def test_every_cut_of_the_kernel_is_work_of_its_own_for_the_workers(drilled_hubs):
    """They find what is found without them, from what arrives in another process."""
    parts, elsewhere = stacked(drilled_hubs), Elsewhere()
    check = check_clashes(parts, elsewhere)
    assert elsewhere.works == check.cut == 10
    assert check == check_clashes(parts)
    shares = sorted(clash.volume / parts[0].volume for clash in check.clashes)
    apart = sorted(1 - 30 * (i - j) / 200 for i in range(5) for j in range(i))
    assert shares == pytest.approx(apart, rel=1e-9)
