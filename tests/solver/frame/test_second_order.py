"""Balance in the deformed shape, against published limits and closed forms."""

import numpy as np
import pytest
from scipy.optimize import minimize_scalar, root

from solver.frame import corotational
from solver.frame.buckling import buckling
from solver.frame.corotational import Ends
from solver.frame.model import Loads, Supports
from solver.frame.response import imbalance, response
from solver.frame.second_order import followed, imperfect, second_order
from solver.frame.system import FrameSystem
from tests.solver.frame import frames
from tests.solver.frame.frames import ABOUT_Y, ABOUT_Z, AREA, RIGID, YOUNGS


@pytest.fixture(scope="module")
def bent():
    """A member far from where it was."""
    random = np.random.default_rng(0)
    built = frames.straight(1, up=(0.0, 1.0, 2.0))
    turn = corotational.turned_by(np.array([[0.3, -0.9, 0.5]]), np.eye(3)[None])
    places = (built.nodes @ turn[0].T)[built.members.T] + random.normal(size=(2, 1, 3)) * 30
    turned = [corotational.turned_by(0.2 * random.normal(size=(1, 3)), turn) for _ in (0, 1)]
    k = frames.system(built, {0: RIGID}).joined.stiffness
    return Ends(places, np.array(turned)), built.axes, built.lengths, k


def nudged(ends, unknown, size):
    end, c = divmod(unknown, 6)
    places, turned = ends.places.copy(), ends.turned.copy()
    if c < 3:
        places[end, 0, c] += size
    else:
        turned[end] = corotational.turned_by(size * np.eye(3)[c - 3][None], turned[end])
    return Ends(places, turned)


def test_the_tangent_is_the_derivative_of_the_forces(bent):
    ends, *rest = bent
    tangent = corotational.tangent(ends, *rest)[0]
    columns = []
    for unknown in range(12):
        size = 1e-2 if unknown % 6 < 3 else 1e-5
        up, down = (corotational.forces(nudged(ends, unknown, s), *rest)[0] for s in (size, -size))
        columns.append((up - down)[0] / (2 * size))
    numbers = np.array(columns).T
    scale = np.sqrt(np.abs(np.diag(tangent)))
    difference = (0.5 * (numbers + numbers.T) - tangent) / np.outer(scale, scale)
    assert np.abs(difference).max() < 1e-6


def test_forces_are_the_derivative_of_the_energy_that_is_strained_into_a_member(bent):
    ends, axes, lengths, k = bent
    strained = [6, 3, 4, 5, 9, 10, 11]
    stiffness = k[0][np.ix_(strained, strained)]

    def energy(place):
        inner = corotational.forces(place, axes, lengths, k)[1][0, strained]
        return 0.5 * inner @ np.linalg.pinv(stiffness) @ inner

    found = corotational.forces(ends, axes, lengths, k)[0][0]
    for unknown in range(12):
        size = 1e-3 if unknown % 6 < 3 else 1e-6
        up, down = (energy(nudged(ends, unknown, s)) for s in (size, -size))
        part = found[:3] if unknown % 6 < 3 else found[3:6]
        other = found[6:9] if unknown % 6 < 3 else found[9:12]
        scale = max(np.abs(part).max(), np.abs(other).max())
        assert (up - down) / (2 * size) == pytest.approx(found[unknown], abs=1e-5 * scale)


def test_forces_are_in_balance_and_rigid_motion_gives_none(bent):
    ends, axes, lengths, k = bent
    found = corotational.forces(ends, axes, lengths, k)[0][0]
    assert np.abs(found[:3] + found[6:9]).max() < 1e-9 * np.abs(found).max()
    arm = (ends.places[1] - ends.places[0])[0]
    moment = found[3:6] + found[9:12] + np.cross(arm, found[6:9])
    assert np.abs(moment).max() < 1e-9 * np.abs(found).max()
    turn = corotational.turned_by(np.array([[2.0, 1.0, -1.5]]), np.eye(3)[None])
    turned = np.stack([turn, turn])
    whole = np.array([[[0.0, 0, 0]], (turn[0] @ [3000.0, 0, 0])[None]])
    none = corotational.forces(Ends(whole, turned), axes, lengths, k)[0]
    assert np.abs(none).max() < 1e-6


def test_the_frame_of_lee_reaches_its_limit():
    """1.857: Lee, Manuel, Rossow (1968), Large deflections and stability of elastic frames;
    1.85 in Schweizerhof, Wriggers (1986), Consistent linearization for path following methods."""
    count, length = 10, 120.0
    rising = np.linspace(0, length, count + 1)
    column = np.stack([0 * rising, 0 * rising, rising], axis=1)
    beam = np.stack([rising[1:], 0 * rising[1:], 0 * rising[1:] + length], axis=1)
    built = frames.polyline(
        np.concatenate([column, beam]), up=(0.0, 1.0, 0.0),
        area=6.0, about_y=2.0, about_z=2.0, torsion=2.0, youngs=720.0, shear=277.0,
    )  # fmt: skip
    held = {node: "y rx rz" for node in range(2 * count + 1)}
    held |= dict.fromkeys((0, 2 * count), "x y z rx rz")
    loads = Loads.none(built)
    loads.nodal[count + count // 5, 2] = -1.0
    path = followed(frames.system(built, held), loads, 28, 0.3)
    assert path.limit == pytest.approx(1.857, rel=0.02)
    assert path.factors[-1] < path.limit


def test_springs_of_supports_resist():
    """w = F / (3 E I / L^3 + c) for a small load at the end of a cantilever."""
    built = frames.straight(1)
    bending = 3 * YOUNGS * ABOUT_Y / 3000.0**3
    fixed, springs = np.zeros((2, 6), dtype=bool), np.zeros((2, 6))
    fixed[0], springs[1, 2] = True, 2 * bending
    loads = Loads.none(built)
    loads.nodal[1, 2] = 3.0 * bending
    found = second_order(FrameSystem(built, Supports.upright(fixed, springs)), loads)
    assert found.factor == 1.0
    assert found.response.displacements[1, 2] == pytest.approx(1.0, rel=1e-4)


def test_a_star_dome_of_bars_snaps_through():
    """P(w) = n E A (L0 - L) / L0 h / L with h the height: von Mises (1923), bars of any strain."""
    radius, rise, sides = 4000.0, 300.0, 6
    built = frames.dome(sides, radius, rise)
    loads = Loads.none(built)
    loads.nodal[0, 2] = -1e3
    held = {node: "x y z" for node in range(1, sides + 1)}
    whole = float(np.hypot(radius, rise))

    def carried(height):
        length = np.hypot(radius, height)
        return sides * YOUNGS * AREA * (whole - length) / whole * height / length

    best = minimize_scalar(lambda height: -carried(height), bounds=(0, rise), method="bounded")
    path = followed(frames.system(built, held), loads, 30, carried(rise - 15) / 1e3)
    deep = path.displacements[:, 0, 2]
    assert deep[-1] < -1.5 * rise
    assert path.factors * 1e3 == pytest.approx(carried(rise + deep), rel=1e-6, abs=1e-2)
    assert path.limit * 1e3 == pytest.approx(carried(best.x), rel=0.02)


def test_the_star_dome_of_the_literature_gives_way_below_its_load():
    """Its limit is considerably below the load: Levy, Spillers (2003), 2.4.2.

    Along the whole path it is in balance as bars are whose crown and ring move evenly.
    """
    system, loads = frames.star_dome()
    built, feet = system.frame, system.frame.nodes[7]
    area, youngs = built.stiffness.area[0], built.stiffness.youngs[0]

    def pulled(one, two, start, end):
        """Force of a bar from ``one`` to ``two``, on ``one``."""
        whole, length = np.linalg.norm(start - end), np.linalg.norm(one - two)
        return youngs * area * (length - whole) / whole * (two - one) / length

    def left(unknowns, crown):
        radial, up = unknowns
        at = built.nodes[1] + [radial, 0.0, up]
        turn = np.radians(60.0)
        beside = np.array([at[0] * np.cos(turn), at[0] * np.sin(turn), at[2]])
        force = pulled(at, crown, built.nodes[1], built.nodes[0])
        force = force + 2 * pulled(at, beside, built.nodes[1], built.nodes[2])
        return (force + 2 * pulled(at, feet, built.nodes[1], feet))[[0, 2]]

    path = followed(system, loads, 12, 0.1)
    for factor, moved in zip(path.factors, path.displacements, strict=True):
        crown = built.nodes[0] + [0.0, 0.0, moved[0, 2]]
        radial, up = root(left, moved[1, [0, 2]], crown, tol=1e-14).x
        at = built.nodes[1] + [radial, 0.0, up]
        force = 6 * pulled(crown, at, built.nodes[0], built.nodes[1])[2]
        assert force == pytest.approx(factor * 220.46, rel=1e-6, abs=1e-6)
    assert path.factors[-1] < path.limit and 0.6 < path.limit < 0.7


def test_a_crooked_column_bows_as_the_perfect_one_would_not():
    """The bow grows by 1 / (1 - N / N_Euler), and the moment is N times the bow."""
    count, length, bow = 16, 3000.0, 3.0
    built = frames.straight(count)
    held = {0: "x y z rx", count: "y z"}
    loads = Loads.none(built)
    euler = np.pi**2 * YOUNGS * ABOUT_Z / length**2
    loads.nodal[count, 0] = -0.5 * euler
    perfect = frames.system(built, held)
    mode = buckling(perfect, response(perfect, loads), 1).shapes[0]
    crooked = imperfect(built, mode, bow)
    found = second_order(frames.system(crooked, held), loads)
    assert found.factor == 1.0
    moved = np.abs(found.response.displacements[count // 2, 1])
    assert moved == pytest.approx(bow, rel=0.01)
    moment = np.abs(found.response.forces_at(crooked, 1.0)[count // 2 - 1, 5])
    assert moment == pytest.approx(0.5 * euler * 2 * bow, rel=0.01)


def test_more_than_the_limit_is_carried_in_part():
    count = 8
    built = frames.straight(count)
    held = {0: "x y z rx", count: "y z"}
    loads = Loads.none(built)
    loads.nodal[count, 0] = -1.5 * np.pi**2 * YOUNGS * ABOUT_Z / 3000.0**2
    found = second_order(frames.system(built, held), loads)
    assert found.factor == pytest.approx(1 / 1.5, abs=0.03)


def test_a_small_load_is_answered_as_by_the_linear_theory():
    nodes = [[0, 0, 0], [3000, 200, 900], [5000, 2500, 1200], [3500, -2600, 800]]
    built = frames.frame(nodes, [(0, 1), (1, 2), (1, 3)])
    loads = Loads.none(built)
    loads.spread[:] = [0.001, -0.002, -0.005]
    loads.nodal[1, :3] = [10.0, -7.0, 3.0]
    system = frames.system(built, dict.fromkeys((0, 2, 3), RIGID))
    small, linear = second_order(system, loads).response, response(system, loads)
    assert np.allclose(small.displacements, linear.displacements, rtol=1e-3, atol=1e-8)
    assert np.allclose(small.ends, linear.ends, rtol=1e-3, atol=0.05)
    assert imbalance(built, loads, small.reactions) < 1e-5
