"""Buckling factors against closed forms."""

import numpy as np
import pytest

from solver.frame.buckling import buckling
from solver.frame.elements import geometric
from solver.frame.model import Loads
from solver.frame.response import response
from tests.solver.frame import frames
from tests.solver.frame.frames import ABOUT_Z, AREA, RIGID, SHEAR, TORSION, YOUNGS

LENGTH, COUNT = 3000.0, 8
EULER = np.pi**2 * YOUNGS * ABOUT_Z / LENGTH**2


def first(built, held, loads, count=1):
    system = frames.system(built, held)
    return buckling(system, response(system, loads), count)


@pytest.mark.parametrize(
    ("held", "ratio"),
    [
        ({0: "x y z rx", COUNT: "y z"}, 1.0),
        ({0: RIGID, COUNT: "y z rx ry rz"}, 4.0),
        ({0: RIGID, COUNT: "y z"}, 2.045748),
        ({0: RIGID}, 0.25),
    ],
)
def test_columns_of_euler(held, ratio):
    built = frames.straight(COUNT)
    loads = Loads.none(built)
    loads.nodal[COUNT, 0] = -1.0
    found = first(built, held, loads)
    assert found.factors[0] == pytest.approx(ratio * EULER, rel=1e-3)
    largest = np.linalg.norm(found.shapes[0, :, :3], axis=1).max()
    assert largest == pytest.approx(1.0)


def test_tension_buckles_nothing():
    built = frames.straight(COUNT)
    loads = Loads.none(built)
    loads.nodal[COUNT, 0] = 1.0
    assert not len(first(built, {0: RIGID}, loads).factors)


def test_a_beam_tips_over_sideways():
    """Even moment, ends that cannot twist: pi / L sqrt(E Iz G J); Timoshenko, Gere (1961), 6.3."""
    built = frames.straight(COUNT)
    loads = Loads.none(built)
    loads.nodal[0, 4], loads.nodal[COUNT, 4] = 1.0, -1.0
    found = first(built, {0: "x y z rx", COUNT: "y z rx"}, loads)
    known = np.pi / LENGTH * np.sqrt(YOUNGS * ABOUT_Z * SHEAR * TORSION)
    assert found.factors[0] == pytest.approx(known, rel=0.01)


def test_a_cantilever_tips_over_sideways():
    """A force at the tip: 4.013 sqrt(E Iz G J) / L^2; Timoshenko, Gere (1961), 6.4."""
    built = frames.straight(COUNT)
    loads = Loads.none(built)
    loads.nodal[COUNT, 2] = -1.0
    known = 4.013 * np.sqrt(YOUNGS * ABOUT_Z * SHEAR * TORSION) / LENGTH**2
    assert first(built, {0: RIGID}, loads).factors[0] == pytest.approx(known, rel=0.01)


@pytest.mark.parametrize(("hinge", "known"), [(False, np.pi**2), (True, 4 * 1.36275**2)])
def test_a_shallow_arch_of_two_and_three_hinges(hinge, known):
    """Thrust by E I / (S / 2)^2, S the length of the arch.

    Two hinges: pi^2, Pi, Bradford, Uy (2002), in-plane stability of arches. Three: it sinks evenly
    at 4 u^2 with tan u - u = 4 u^3 / 3, the limit of shallow ones of (tan u - u) / u^3 =
    4 (tan a - a) / a^3 in Timoshenko, Gere (1961), 7.5.
    """
    radius, half, count = 20_000.0, np.pi / 12, 2 * COUNT
    at = np.pi / 2 + np.linspace(half, -half, count + 1)
    points = radius * np.stack([np.cos(at), 0 * at, np.sin(at)], axis=1)
    springs = np.full((count, 12), np.inf)
    springs[COUNT - 1, 10] = 0.0 if hinge else np.inf
    built = frames.polyline(points, springs=springs)
    middle = 0.5 * (points[1:] + points[:-1])
    loads = Loads.none(built)
    loads.spread[:] = -middle / np.linalg.norm(middle, axis=1)[:, None]
    held = {node: "y rx rz" for node in range(count + 1)}
    held |= dict.fromkeys((0, count), "x y z rx rz")
    found = first(built, held, loads)
    stiff = YOUNGS * frames.ABOUT_Y / (radius * half) ** 2
    assert found.factors[0] == pytest.approx(known * stiff / radius, rel=0.01)


def test_a_shallow_dome_of_hinged_bars():
    """The top goes down where N = E A tan^2 of the bars' slope, all taken as linear."""
    radius, rise, sides = 4000.0, 100.0, 3
    built = frames.dome(sides, radius, rise)
    loads = Loads.none(built)
    loads.nodal[0, 2] = -1.0
    found = first(built, {node: "x y z" for node in range(1, sides + 1)}, loads)
    slope = np.arctan2(rise, radius)
    known = sides * YOUNGS * AREA * np.tan(slope) ** 2 * np.sin(slope)
    assert found.factors[0] == pytest.approx(known, rel=1e-6)


@pytest.mark.parametrize(("rise", "snaps"), [(60.0, True), (400.0, False)])
def test_a_shallow_dome_of_three_hinged_arches(rise, snaps):
    """Six ribs of eight elements, hinged at their feet and in the crown.

    The crown goes through where N = E A tan^2 of the slope; where that is more than Euler's load,
    the ribs buckle first, sideways as they are weakest there, all at once.
    """
    sides, radius, about = 6, 3000.0, 2.2e6
    whole = frames.dome(sides, radius, rise)
    sizes = {"area": AREA, "about_y": about, "about_z": 0.5 * about}
    whole = frames.frame(whole.nodes, whole.members, springs=frames.hinged(sides), **sizes)
    loads = Loads.none(whole)
    loads.nodal[0, 2] = -1.0
    # The ribs hold the crown's turns by nothing but their torsion.
    held = {node: "x y z" for node in range(1, sides + 1)} | {0: "rx ry rz"}
    found = first(whole.divided(COUNT), held, loads.divided(whole, COUNT))
    slope, length = np.arctan2(rise, radius), np.hypot(radius, rise)
    euler = np.pi**2 * YOUNGS * 0.5 * about / length**2
    through = YOUNGS * AREA * np.tan(slope) ** 2
    assert (through < euler) == snaps
    known = sides * np.sin(slope) * min(euler, through)
    assert found.factors[0] == pytest.approx(known, rel=0.01)


def test_modes_of_a_large_frame_are_those_of_a_dense_one(monkeypatch):
    side, count = 5, 4
    x, y = np.meshgrid(np.arange(side), np.arange(side), indexing="ij")
    height = 0.1 * (x * (side - 1 - x) + y * (side - 1 - y))
    nodes = 1000.0 * np.stack([x, y, height], axis=-1).reshape(-1, 3)
    number = np.arange(side**2).reshape(side, side)
    pairs = [(number[:-1], number[1:]), (number[:, :-1], number[:, 1:])]
    members = np.concatenate([np.stack([a.ravel(), b.ravel()], axis=1) for a, b in pairs])
    built = frames.frame(nodes, members)
    border = np.unique([*number[0], *number[-1], *number[:, 0], *number[:, -1]])
    loads = Loads.none(built)
    loads.spread[:, 2] = -1.0
    system = frames.system(built, dict.fromkeys(border.tolist(), "x y z"))
    under = response(system, loads)
    dense = buckling(system, under, count).factors
    monkeypatch.setattr("solver.frame.buckling._FEW", 0)
    assert buckling(system, under, count).factors == pytest.approx(dense, rel=1e-6)


def test_moments_turn_by_half_of_a_rigid_rotation():
    """Those of beams are semi-tangential: turned by theta they change by half of theta x M."""
    built = frames.straight(1)
    length = built.lengths[0]
    torque, (y1, z1, y2, z2) = 5.0, (7.0, -11.0, 13.0, 17.0)
    shear = np.array([0.0, (z1 + z2) / length, -(y1 + y2) / length])
    moments = np.array([[-torque, y1, z1], [torque, y2, z2]])
    ends = np.concatenate([shear, moments[0], -shear, moments[1]])
    added = geometric(built, ends[None])[0]
    assert np.array_equal(added, added.T)
    for turn in np.eye(3):
        moved = np.concatenate([np.zeros(3), turn, np.cross(turn, [length, 0, 0]), turn])
        forces = (added @ moved).reshape(2, 2, 3)
        np.testing.assert_allclose(forces[:, 1], np.cross(turn, moments) / 2, atol=1e-12)
