"""Axial forces of frames beside those of nets that carry by these alone."""

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.structural.combinations import STRENGTH
from solver import optimise
from solver.mesh.primitives import primitive

LINE = ["strength: 1 point loads"]


@pytest.fixture(scope="module")
def dome():
    mesh = primitive("translational", 8, 7)
    return mesh.with_vertices(2.0 * mesh.vertices)


def loaded(mesh, size=-5.0):
    """How far equal forces on all inner vertices, and nothing else, are carried by axial forces."""
    inner = np.flatnonzero(~mesh.connectivity.boundary_vertices).tolist()
    loads = [f"{vertex}:0,0,{size}" for vertex in inner]
    check = api.check_structure(
        mesh, unit="m", section="tube:60x40x4", load=loads, self_weight=False, combinations=LINE
    )
    (found,) = [one for one in check.found if one.combination.kind == STRENGTH]
    return found.membrane


def test_a_stress_net_leaves_nothing_of_its_load_to_bending(dome):
    made = optimise(dome, net="stress").mesh
    drawn, formed = loaded(dome), loaded(made)
    assert formed.left < 1e-6 < 0.01 < drawn.left
    assert 0.9 < formed.carried <= 1.0 and 0.9 < drawn.carried <= 1.0


def test_a_level_grid_carries_nothing_by_axial_forces(dome):
    found = loaded(dome.with_vertices(dome.vertices * [1.0, 1.0, 1e-9]))
    assert found.left == pytest.approx(1.0, abs=1e-6)
    assert found.carried == pytest.approx(0.0, abs=1e-6)


def test_the_size_of_a_load_does_not_matter(dome):
    one, two = loaded(dome), loaded(dome, -10.0)
    assert (one.left, one.carried, one.apart) == pytest.approx((two.left, two.carried, two.apart))
