"""The same mesh in national grid coordinates gives the same net as near the origin."""

from __future__ import annotations

import numpy as np
import pytest

from solver import Constraints, InputError, NetOptions, Session, optimise
from solver.analysis.advisor import advise
from solver.analysis.check import check
from solver.formfinding import Membrane, VertexLoads, find_form, supported
from solver.mesh.mirror import size_of
from solver.nets.constraints import BoundaryGlide, CurveGlide, PlaneGlide, SurfaceGlide
from tests.conftest import surface_of_revolution, wavy_grid
from tests.meshes import bent_sheet

# Multiples of the rounding there, so that both meshes are the same to the last digit.
OFFSETS = [np.array([500123.25, 5412345.5, 4096.0]), np.array([1e7, -1e7, 1e7])]


def rounded(mesh):
    """The mesh on a grid so coarse that it can be moved to the offsets without rounding."""
    return mesh.with_vertices(np.round(mesh.vertices * 2.0**26) / 2.0**26)


def moved(mesh, offset):
    return mesh.with_vertices(mesh.vertices + offset)


def agree(far, near, offset):
    """Same steps, same verdict, and the same shape to 1e-9 of its size."""
    miss = np.abs(far.mesh.vertices - offset - near.mesh.vertices).max()
    assert miss <= 1e-9 * size_of(near.mesh.vertices)
    assert far.report.iterations == near.report.iterations
    assert far.report.status == near.report.status == "converged"
    assert far.report.moved.max == pytest.approx(near.report.moved.max, rel=1e-6)
    assert near.report.origin == [0.0, 0.0, 0.0]


@pytest.mark.parametrize("offset", OFFSETS)
@pytest.mark.parametrize("net", ["principal", "circular", "orthogonal", "cmc"])
def test_a_net_is_the_same_anywhere(net, offset):
    start = rounded(wavy_grid(8, 7))
    far = optimise(moved(start, offset), net)
    agree(far, optimise(start, net), offset)
    apart = np.abs(np.array(far.report.origin) - offset)
    assert (apart[np.abs(offset) > 1e5] <= 6 * size_of(start.vertices)).all()


@pytest.mark.parametrize("offset", OFFSETS)
def test_what_holds_a_net_is_the_same_anywhere(offset):
    start = rounded(surface_of_revolution())
    rim = np.flatnonzero(start.connectivity.boundary_vertices)
    curve = start.vertices[start.connectivity.boundary_loops[0]]
    sheet = np.array([[-9.0, -9, -1.5], [9, -9, -1.5], [9, 9, -0.5], [-9, 9, -0.5]])
    level = float(start.vertices[:, 2].min())
    bottom = np.flatnonzero(start.vertices[:, 2] == level)

    def held(place):
        return [
            Constraints(handles={31: start.vertices[31] + place + [0, 0, 0.25]}),
            Constraints(glide=(BoundaryGlide(),)),
            Constraints(glide=(PlaneGlide(2, level + place[2], bottom),)),
            Constraints(glide=(CurveGlide(curve + place, True, rim[::3]),)),
            Constraints(
                glide=(SurfaceGlide(sheet + place, np.array([[0, 1, 2], [0, 2, 3]]), bottom[3:5]),)
            ),
            Constraints(close_to=(sheet + place, np.array([[0, 1, 2], [0, 2, 3]]))),
        ]

    for near, far in zip(held(np.zeros(3)), held(offset), strict=True):
        settings = {"net": "orthogonal", "fix": [0], "max_steps": 60}
        one = optimise(start, constraints=near, **settings)
        other = optimise(moved(start, offset), constraints=far, **settings)
        agree(other, one, offset)
        assert other.mesh.vertices[0].tobytes() == (start.vertices[0] + offset).tobytes()


def test_a_reference_counts_by_its_shape():
    start = rounded(bent_sheet(9, 8))
    flat = start.vertices + np.sin(start.vertices[:, ::-1]) * 0.01
    near = optimise(start, "isometric", options=NetOptions(reference=flat))
    for offset in OFFSETS:
        far = optimise(moved(start, offset), "isometric", options=NetOptions(reference=flat))
        agree(far, near, offset)


def test_symmetry_about_a_plane_that_is_far_is_refused():
    with pytest.raises(InputError, match="far from the plane x=0"):
        optimise(moved(wavy_grid(6, 6), [1e7, 0, 0]), constraints=Constraints(symmetry="x"))


@pytest.mark.parametrize("offset", OFFSETS)
def test_a_drag_is_the_same_anywhere(offset):
    start = rounded(wavy_grid(8, 7))
    shapes = []
    for place in (np.zeros(3), offset):
        session = Session(moved(start, place), [24, 0])
        target = start.vertices[24] + place + [0, 0, 0.5]
        records = [session.drag({24: target}, steps=3)]
        between = session.vertices - place
        settled = session.settle()
        assert settled.report.status == "converged"
        session.drag({24: target - [0, 0, 0.25]})
        records.append(session.drag({24: target - [0, 0, 0.25]}))
        shapes.append((between, settled.mesh.vertices - place, session.vertices - place, records))
    for one, other in zip(shapes[0][:3], shapes[1][:3], strict=True):
        assert np.abs(one - other).max() <= 1e-8 * size_of(start.vertices)
    assert [record.step for record in shapes[0][3]] == [record.step for record in shapes[1][3]]


@pytest.mark.parametrize("offset", OFFSETS)
def test_measures_and_advice_are_the_same_anywhere(offset):
    for start in (rounded(wavy_grid(8, 7)), optimise(wavy_grid(8, 7)).mesh):
        near, far = check(start), check(moved(start, offset))
        assert far["advice"]["already"] == near["advice"]["already"]
        assert far["multi_net"]["is_multi_net"] == near["multi_net"]["is_multi_net"]
        assert far["flipped_faces"] == near["flipped_faces"]
        for name, entry in near["measures"].items():
            # A coordinate there is rounded to 1e-9, a result near the origin is not.
            assert far["measures"][name]["max"] == pytest.approx(entry["max"], abs=2e-8)
        titles = [one.title for one in advise(start)]
        assert [one.title for one in advise(moved(start, offset))] == titles


@pytest.mark.parametrize("offset", OFFSETS)
def test_a_membrane_finds_its_form_anywhere(offset):
    start = rounded(wavy_grid(7, 6))
    held = supported(start, "boundary")
    loads = VertexLoads((0, 0, -0.1))
    near, far = (
        find_form(moved(start, place), held, Membrane(1.0, 0.0), loads)
        for place in (np.zeros(3), offset)
    )
    assert near.converged and far.converged
    assert near.iterations == far.iterations
    miss = np.abs(far.mesh.vertices - offset - near.mesh.vertices).max()
    assert miss <= 1e-9 * size_of(start.vertices)
