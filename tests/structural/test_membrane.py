"""Axial forces of frames beside those of nets that carry by these alone."""

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.fabrication.profiles import profile
from freecad_ortho.structural.combinations import STRENGTH
from solver import optimise
from solver.mesh.primitives import primitive

LINE = ["strength: 1 point loads"]


@pytest.fixture(scope="module")
def dome():
    mesh = primitive("translational", 8, 7)
    return mesh.with_vertices(2.0 * mesh.vertices)


@pytest.fixture(scope="module")
def formed(dome):
    """What carries equal forces on its inner vertices without bending."""
    return loaded(optimise(dome, net="stress").mesh)


def loaded(mesh, size=-5.0):
    """How far equal forces on all inner vertices, and nothing else, are carried by axial forces."""
    inner = np.flatnonzero(~mesh.connectivity.boundary_vertices).tolist()
    loads = [f"{vertex}:0,0,{size}" for vertex in inner]
    check = api.check_structure(
        mesh, unit="m", section="tube:60x40x4", load=loads, self_weight=False, combinations=LINE
    )
    (found,) = [one for one in check.found if one.combination.kind == STRENGTH]
    return found.membrane


def test_a_stress_net_leaves_nothing_of_its_load_to_bending(dome, formed):
    drawn = loaded(dome)
    assert formed.left < 1e-6 < 0.01 < drawn.left
    assert 0.9 < formed.carried <= 1.0 and 0.9 < drawn.carried <= 1.0


def test_a_level_grid_carries_nothing_by_axial_forces(dome):
    found = loaded(dome.with_vertices(dome.vertices * [1.0, 1.0, 1e-9]))
    assert found.left == pytest.approx(1.0, abs=1e-6)
    assert found.carried == pytest.approx(0.0, abs=1e-6)


def test_the_size_of_a_load_does_not_matter(dome):
    one, two = loaded(dome), loaded(dome, -10.0)
    assert (one.left, one.carried, one.apart) == pytest.approx((two.left, two.carried, two.apart))
    assert one.needed == pytest.approx(two.needed)


@pytest.mark.parametrize("rise", [0.05, 0.5])
def test_four_bars_carry_as_far_as_they_do_not_bend(rise):
    """A force on the middle: bars of slope s, c push by E A s^2 / L and bend by 12 E I c^2 / L^3.

    What they push carries; forces that carry all are larger by one over that part.
    """
    half = 3.0
    mesh = primitive("rectangle", 3, 3, length=2 * half, width=2 * half)
    points = mesh.vertices.copy()
    middle = int(np.flatnonzero(~mesh.connectivity.boundary_vertices)[0])
    points[middle, 2] += rise
    check = api.check_structure(
        mesh.with_vertices(points), unit="m", section="chs:88.9x5", load=f"{middle}:0,0,-5",
        supports="boundary:fixed", self_weight=False, combinations=LINE,
    )  # fmt: skip
    section, length = profile("chs:88.9x5"), 1000 * float(np.hypot(half, rise))
    sine, cosine = 1000 * rise / length, 1000 * half / length
    pushed = 210e3 * section.area * sine**2 / length
    soft = length**3 / (12 * 210e3 * section.inertia_y)
    soft += length / (check.model.frame.stiffness.shear[0] * section.shear_area_z)
    part = pushed / (pushed + cosine**2 / soft)
    (found,) = [one.membrane for one in check.strength]
    assert found.left == pytest.approx(0.0, abs=1e-9)
    assert (found.carried, found.apart) == pytest.approx((part, 1 - part), rel=1e-6)
    assert found.needed == pytest.approx(1 / part, rel=1e-6)


def test_a_stress_net_of_pull_and_push_asks_for_more_than_its_frame_takes(formed):
    """Made without a sign of its forces, u pushes and v pulls: hardly any load holds these up.

    As the equations have no other solution, the forces that balance the load are those it was
    made with, far from the frame's although these leave but a tenth of the load to bending.
    """
    assert formed.left < 1e-9 and formed.carried > 0.9
    assert formed.needed > 2 and formed.apart == pytest.approx(1.0, abs=0.1)
