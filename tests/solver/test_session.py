"""Dragging: the mesh follows the hand, and ends as the net that a cold solve finds."""

from __future__ import annotations

import inspect

import numpy as np
import pytest

from solver import Constraints, InputError, Session, optimise, start_optimisation
from solver.analysis import measures
from solver.linear.multifrontal import Multifrontal
from solver.optimise import Settings
from tests.conftest import wavy_grid
from tests.meshes import bent_sheet, grid, parameters, scherk, unduloid


def solved(outcome):
    assert outcome.report.status == "converged", outcome.report.message
    return outcome.mesh


def dragged(start, net, handles, wobble):
    """A session whose handles went a way of 30 frames, and the targets at its end."""
    session = Session(start, list(handles), net)
    ends = {vertex: start.vertices[vertex] + move for vertex, move in handles.items()}
    for part in np.linspace(0, 1, 31)[1:]:
        aside = wobble * np.sin(np.pi * part)
        session.drag({v: (1 - part) * start.vertices[v] + part * ends[v] + aside for v in handles})
        assert np.isfinite(session.vertices).all()
    return session, ends


@pytest.mark.parametrize(
    ("net", "build", "same"),
    [
        ("principal", lambda: wavy_grid(12, 11), 1e-8),
        ("isometric", bent_sheet, 1e-8),
        # In the weak directions of a geodesic net rounding of its residuals moves vertices by 1e-8
        # edges and more; of the mesh's size it is less.
        ("geodesic", bent_sheet, 5e-8),
        ("asymptotic", scherk, 1e-8),
        ("cmc", unduloid, 1e-8),
    ],
)
def test_a_session_settles_where_a_cold_solve_does_and_without_a_jump(net, build, same):
    start = solved(optimise(build(), net))
    edge = start.mean_edge
    middle = int(np.argmin(np.linalg.norm(start.vertices - start.vertices.mean(axis=0), axis=1)))
    handles = {middle: edge * np.array([0.3, 0.2, 1.0]), 0: edge * np.array([0.2, 0.0, -0.5])}
    session, ends = dragged(start, net, handles, wobble=edge * np.array([0.5, -0.3, 0.0]))
    record = session.drag(ends)
    assert record.worst < 0.1
    assert np.linalg.norm(session.vertices[middle] - ends[middle]) < 0.3 * edge
    # The mouse rests for a second and a half: the mesh creeps to the net, without a jump.
    for _ in range(45):
        before = session.vertices
        session.drag(ends)
        assert np.linalg.norm(session.vertices - before, axis=1).max() < 0.15 * edge
    before = session.vertices
    settled = session.settle()
    mesh = solved(settled)
    assert np.linalg.norm(mesh.vertices - before, axis=1).max() < 0.05 * edge
    cold = solved(optimise(start, net, constraints=Constraints(handles=ends)))
    assert np.abs(mesh.vertices - cold.vertices).max() <= same * edge
    assert session.settle().mesh.vertices.tobytes() == mesh.vertices.tobytes()
    # A second drag goes on from the shape in sight, and its end forgets the first.
    session.drag({0: start.vertices[0]})
    assert np.linalg.norm(session.vertices - mesh.vertices, axis=1).max() < 0.8 * edge
    session.drag({middle: start.vertices[middle]})
    back = solved(session.settle())
    assert np.linalg.norm(back.vertices - start.vertices, axis=1).max() < 0.2 * edge


def test_settling_step_by_step_is_settling():
    start = optimise(wavy_grid(8, 7)).mesh
    session = Session(start, [24, 0])
    session.drag({24: start.vertices[24] + [0, 0, 0.5]}, steps=3)
    settling = session.settling()
    records = []
    while True:
        try:
            records.append(next(settling))
        except StopIteration as end:
            outcome = end.value
            break
    assert len(records) == outcome.report.iterations > 1
    assert outcome.mesh.vertices.tobytes() == session.settle().mesh.vertices.tobytes()
    # One that is left unfinished does no harm to what comes after.
    session.drag({0: start.vertices[0] + [0, 0, 0.1]})
    next(session.settling())
    session.drag({0: start.vertices[0]})
    assert np.isfinite(session.vertices).all()


def test_no_move_of_the_mouse_costs_many_factorisations(monkeypatch):
    calls = []
    factor = Multifrontal.factor
    monkeypatch.setattr(Multifrontal, "factor", lambda *a: calls.append(1) or factor(*a))
    start = solved(optimise(wavy_grid(20, 20), "principal"))
    middle = 20 * 10 + 10
    session = Session(start, [middle, 0, 19, 20 * 19, 20 * 20 - 1])
    way = start.mean_edge * np.array([-1.6, 2.5, 5.2])
    frames = []
    for part in np.linspace(0, 1, 61)[1:]:
        calls.clear()
        session.drag({middle: start.vertices[middle] + part * way})
        frames.append(len(calls))
    assert max(frames) <= 2
    assert sum(frames) <= 25


def test_a_refused_drag_changes_nothing():
    start = optimise(wavy_grid(8, 7)).mesh
    session = Session(start, [24, 0])
    place = start.vertices[24] + [0, 0, 0.5]
    with pytest.raises(InputError, match="vertex 99"):
        session.drag({24: place, 99: place})
    assert np.array_equal(session.targets[24], start.vertices[24])
    for _ in range(20):
        session.drag({24: place})
    assert np.linalg.norm(session.vertices[24] - place) < 0.25


def test_session_refuses_strangers():
    mesh = wavy_grid(6, 5)
    with pytest.raises(InputError, match="none given"):
        Session(mesh, [])
    with pytest.raises(InputError, match="vertex 99 does not exist"):
        Session(mesh, [99])
    with pytest.raises(InputError, match="not one of"):
        Session(mesh, [3]).drag({4: np.zeros(3)})


def test_settings_are_those_of_one_call_and_others_are_listed():
    start = wavy_grid(5, 5)
    said = r"has no 'fairnes'; it has fairness, closeness, multi, multi_patch, evenness"
    with pytest.raises(InputError, match=f"^session: {said}"):
        Session(start, [0], fairnes=1.0)
    with pytest.raises(InputError, match=f"^optimise: {said}"):
        optimise(start, fairnes=1.0)
    keywords = inspect.signature(start_optimisation).parameters.values()
    names = [one.name for one in keywords if one.kind is inspect.Parameter.KEYWORD_ONLY]
    assert names == list(Settings.__annotations__)


@pytest.mark.parametrize("big", [0.3, 1.0])
def test_a_stiff_sheet_settles_where_it_was_dragged(big):
    """Guides that fade let go of nets that hardly bend: handles are then pulled along the nets."""
    x, y = parameters(13, 11, 3.0, 2.5)
    sheet = grid(x, y, 0 * x)
    first, last = 0, len(sheet.vertices) - 1
    ends = {
        first: sheet.vertices[first] + big * np.array([0.3, 0.2, 0.8]),
        last: sheet.vertices[last] + big * np.array([-0.3, -0.2, 0.8]),
    }
    session = Session(sheet, list(ends), net="geodesic-chebyshev")
    for part in np.linspace(0, 1, 11)[1:]:
        session.drag({v: (1 - part) * sheet.vertices[v] + part * end for v, end in ends.items()})
    mesh = solved(session.settle())
    for vertex, end in ends.items():
        way = np.linalg.norm(end - sheet.vertices[vertex])
        assert np.linalg.norm(mesh.vertices[vertex] - end) < 0.05 * way
    assert measures.geodesic(mesh).max() <= 1e-10 and measures.chebyshev(mesh).max() <= 1e-10
