"""Shear panels: what they resist, and that they resist nothing else."""

import numpy as np
import pytest

from solver.frame import corotational
from solver.frame.buckling import buckling
from solver.frame.model import Loads
from solver.frame.panels import ShearPanels
from solver.frame.response import imbalance, response
from solver.frame.second_order import second_order
from tests.solver.frame import frames

WIDE, HIGH, SHEAR = 2000.0, 1500.0, 12_000.0
NODES = np.array([[0.0, 0, 0], [WIDE, 0, 0], [WIDE, 0, HIGH], [0, 0, HIGH]])
CORNERS = np.array([[0, 1, 2, 3]])
PANEL = ShearPanels.of_shear(NODES, CORNERS, SHEAR)


def bay(stiffness=SHEAR, **other):
    """Four bars between hinges, which would sway, with a panel in them."""
    panels = ShearPanels.of_shear(NODES, CORNERS, stiffness)
    bars = [(0, 1), (1, 2), (2, 3), (3, 0)]
    sizes = {"up": (0, 1, 0), "springs": frames.hinged(4), **other}
    return frames.frame(NODES, bars, panels=panels, **sizes)


def test_a_rectangle_is_sheared_as_g_t_says():
    built = bay(area=1e9)
    loads = Loads.none(built)
    loads.nodal[2, 0] = loads.nodal[3, 0] = 500.0
    held = {0: "x y z", 1: "x y z", 2: "y", 3: "y"}
    found = response(frames.system(built, held), loads)
    sway = 1000.0 * HIGH / (SHEAR * WIDE)
    assert found.displacements[2:, 0] == pytest.approx(np.full(2, sway), rel=1e-5)
    flow = built.panels.shear_flows(NODES, found.displacements[:, :3])
    assert np.abs(flow) == pytest.approx([1000.0 / WIDE], rel=1e-5)
    # Bars that hardly stretch cost digits.
    assert imbalance(built, loads, found.reactions) < 1e-8


def test_even_stretches_and_rigid_motion_are_not_resisted():
    turn = corotational.turned_by(np.array([[0.7, -1.9, 0.4]]), np.eye(3)[None])[0]
    for points in (NODES * [1.01, 1.0, 0.98], NODES @ turn.T + [300.0, -20.0, 5.0]):
        assert np.abs(PANEL.forces(NODES, points - NODES)).max() < 1e-8


def test_the_tangent_is_the_derivative_of_the_forces():
    moved = np.random.default_rng(1).normal(size=(4, 3)) * 40
    columns = []
    for k in range(12):
        step = 1e-3 * np.eye(12)[k].reshape(4, 3)
        ahead, back = (PANEL.forces(NODES, moved + s * step)[0] for s in (1, -1))
        columns.append((ahead - back) / 2e-3)
    tangent = PANEL.tangent(NODES, moved)[0]
    assert np.array(columns).T == pytest.approx(tangent, rel=1e-6, abs=1e-6 * np.abs(tangent).max())
    force = PANEL.forces(NODES, moved)[0].reshape(4, 3)
    assert np.abs(force.sum(axis=0)).max() < 1e-9 * np.abs(force).max()
    moment = np.cross(NODES + moved, force).sum(axis=0)
    assert np.abs(moment).max() < 1e-9 * np.abs(force).max() * WIDE


def test_a_braced_column_pair_sways_where_the_panel_gives_way():
    """P = G t b for both columns together: the panel's stiffness against leaning, P / h."""
    built = bay(area=1e9)
    loads = Loads.none(built)
    loads.nodal[2, 2] = loads.nodal[3, 2] = -0.5
    system = frames.system(built, {0: "x y z", 1: "x y z", 2: "y", 3: "y"})
    found = buckling(system, response(system, loads), 1)
    assert found.factors[0] == pytest.approx(SHEAR * WIDE, rel=1e-3)


def test_large_and_small_displacements_agree_under_a_small_load():
    built = bay()
    loads = Loads.none(built)
    loads.nodal[2, 0] = 10.0
    system = frames.system(built, {0: "x y z", 1: "x y z", 2: "y", 3: "y"})
    small, linear = second_order(system, loads).response, response(system, loads)
    assert np.allclose(small.displacements, linear.displacements, rtol=1e-3, atol=1e-6)
    assert imbalance(built, loads, small.reactions) < 1e-5


def test_supports_that_slide_aslant_feel_the_panel_too():
    """Turned as a whole, supports and all, it moves the same."""
    turn = corotational.turned_by(np.array([[0.3, 0.8, -0.5]]), np.eye(3)[None])[0]
    moved = []
    for rotation in (np.eye(3), turn):
        nodes = NODES @ rotation.T
        panels = ShearPanels.of_shear(nodes, CORNERS, SHEAR)
        bars = [(0, 1), (1, 2), (2, 3), (3, 0)]
        built = frames.frame(
            nodes, bars, up=rotation @ [0.0, 1.0, 0.0], springs=frames.hinged(4), panels=panels
        )
        loads = Loads.none(built)
        loads.nodal[3, :3] = rotation @ [800.0, 0.0, 100.0]
        fixed = np.zeros((4, 6), dtype=bool)
        fixed[0, :3], fixed[1, 1:3], fixed[2:, 1] = True, True, True
        directions = np.broadcast_to(rotation.T, (4, 3, 3))
        supports = frames.Supports(fixed, np.zeros((4, 6)), directions)
        found = response(frames.FrameSystem(built, supports), loads)
        moved.append(found.displacements[:, :3] @ rotation)
        assert imbalance(built, loads, found.reactions) < 1e-12
    assert moved[1] == pytest.approx(moved[0], rel=1e-9, abs=1e-9)
