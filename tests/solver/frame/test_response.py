"""Linear response of frames against closed forms."""

import numpy as np
import pytest

from solver.errors import InputError
from solver.frame.model import Frame, Loads, Supports
from solver.frame.response import imbalance, response
from solver.frame.system import FrameSystem
from tests.solver.frame import frames
from tests.solver.frame.frames import ABOUT_Y, ABOUT_Z, AREA, RIGID, SHEAR, TORSION, YOUNGS

LENGTH, FORCE, SPREAD = 3000.0, 1000.0, 2.0


def exactly(value):
    return pytest.approx(value, rel=1e-9)


@pytest.mark.parametrize("shear_area", [np.inf, 700.0])
def test_a_cantilever_bends_as_the_theory_of_beams_says(shear_area):
    built = frames.straight(1, shear_area_y=shear_area, shear_area_z=shear_area)
    loads = Loads.none(built)
    loads.nodal[1] = [500.0, FORCE, -FORCE, 7e4, 0, 0]
    loads.spread[0] = [0.0, 0.0, -SPREAD]
    found = response(frames.system(built, {0: RIGID}), loads)
    moved = found.displacements[1]
    soft = LENGTH / (SHEAR * shear_area)
    deep = FORCE * LENGTH**3 / (3 * YOUNGS * ABOUT_Y) + FORCE * soft
    deep += SPREAD * LENGTH**4 / (8 * YOUNGS * ABOUT_Y) + 0.5 * SPREAD * LENGTH * soft
    assert moved[2] == exactly(-deep)
    assert moved[1] == exactly(FORCE * LENGTH**3 / (3 * YOUNGS * ABOUT_Z) + FORCE * soft)
    assert moved[0] == exactly(500 * LENGTH / (YOUNGS * AREA))
    assert moved[3] == exactly(7e4 * LENGTH / (SHEAR * TORSION))
    root = found.forces_at(built, 0.0)[0]
    moment = FORCE * LENGTH + SPREAD * LENGTH**2 / 2
    whole = [500, FORCE, -FORCE - SPREAD * LENGTH, 7e4, moment, FORCE * LENGTH]
    assert root == exactly(np.array(whole))


def test_signs_of_forces_in_sections():
    built = frames.straight(1)
    loads = Loads.none(built)
    loads.spread[0, 2] = -SPREAD
    found = response(frames.system(built, {0: "x y z rx", 1: "y z"}), loads)
    n, vy, vz, t, my, mz = found.forces_at(built, 0.5)[0]
    # Tension at the lower side, where z is negative: a moment about y that is negative.
    assert my == exactly(-SPREAD * LENGTH**2 / 8)
    assert np.abs([n, vy, vz, t, mz]).max() < 1e-9 * abs(my)
    assert found.forces_at(built, 0.0)[0, 2] == exactly(-SPREAD * LENGTH / 2)
    assert found.reactions[:, 2] == exactly(np.array([SPREAD, SPREAD]) * LENGTH / 2)


def test_a_beam_fixed_at_both_ends():
    built = frames.straight(2)
    loads = Loads.none(built)
    loads.spread[:, 2] = -SPREAD
    found = response(frames.system(built, {0: RIGID, 2: RIGID}), loads)
    assert found.displacements[1, 2] == exactly(-SPREAD * LENGTH**4 / (384 * YOUNGS * ABOUT_Y))
    assert found.forces_at(built, 0.0)[0, 4] == exactly(SPREAD * LENGTH**2 / 12)
    assert found.forces_at(built, 1.0)[0, 4] == exactly(-SPREAD * LENGTH**2 / 24)


def test_a_portal_sways_as_the_slope_deflection_method_says():
    """Fixed feet, equal columns and beam, a force at the eaves; columns stretch and shorten.

    Unknowns are sway, turn of the corners, and how far one goes up and the other down. Moments at
    the ends of a bar are 2 E I / L (2 a + b - 3 c) for turns a, b of its ends and c of its chord.
    """
    height, span = 3000.0, 6000.0
    nodes = [[0, 0, 0], [0, 0, height], [span, 0, height], [span, 0, 0]]
    built = frames.frame(nodes, [(0, 1), (1, 2), (2, 3)], up=(0, 1, 0))
    loads = Loads.none(built)
    loads.nodal[1, 0] = loads.nodal[2, 0] = FORCE / 2
    found = response(frames.system(built, dict.fromkeys((0, 3), RIGID)), loads)
    column, beam = YOUNGS * ABOUT_Z / height, YOUNGS * ABOUT_Z / span
    rows = [
        [12 * column / height**2, -6 * column / height, 0.0],
        [-6 * column / height, 4 * column + 6 * beam, -12 * beam / span],
        [0.0, -12 * beam / span, YOUNGS * AREA / height + 24 * beam / span**2],
    ]
    sway, turn, lift = np.linalg.solve(rows, [FORCE / 2, 0.0, 0.0])
    assert found.displacements[1, [0, 4, 2]] == exactly(np.array([sway, turn, lift]))
    foot = 2 * column * (3 * sway / height - turn)
    assert abs(found.reactions[0, 4]) == exactly(foot)


def test_the_crown_of_a_star_dome_goes_down_as_published():
    """0.20641184 in by the linear theory: Levy, Spillers (2003), 2.4.2."""
    system, loads = frames.star_dome()
    found = response(system, loads)
    assert found.displacements[0, 2] == pytest.approx(-0.20641184, rel=1e-4)


def test_bars_of_a_space_truss_carry_by_tension_and_compression_alone():
    built = frames.dome(6, 4000.0, 1000.0)
    loads = Loads.none(built)
    loads.nodal[0, 2] = -FORCE
    held = {node: "x y z" for node in range(1, 7)}
    found = response(frames.system(built, held), loads)
    length = float(np.hypot(4000, 1000))
    sine = 1000 / length
    assert found.forces_at(built, 0.5)[:, 0] == exactly(np.full(6, -FORCE / (6 * sine)))
    assert np.abs(found.forces_at(built, 0.5)[:, 1:]).max() < 1e-9 * FORCE
    deep = FORCE * length / (6 * YOUNGS * AREA * sine**2)
    assert found.displacements[0, 2] == exactly(-deep)


def richardson(values):
    """The limit of values at 1, 2 times as many pieces, whose errors fall as the square."""
    return values[1] + (values[1] - values[0]) / 3


def arc(count, radius, angle):
    at = np.linspace(0, angle, count + 1)
    return radius * np.stack([np.cos(at), np.sin(at), 0 * at], axis=1)


def test_a_ring_under_radial_load_shortens_and_does_not_bend():
    """A quarter whose ends slide along their radii: u = q R^2 / (E A), N = -q R."""
    radius, thrusts, moves = 5000.0, [], []
    for count in (80, 160):
        points = arc(count, radius, np.pi / 2)
        built = frames.polyline(points)
        middle = 0.5 * (points[1:] + points[:-1])
        loads = Loads.none(built)
        loads.spread[:] = -SPREAD * middle / np.linalg.norm(middle, axis=1)[:, None]
        held = {0: "y z rx ry rz", count: "x z rx ry rz"}
        found = response(frames.system(built, held), loads)
        thrusts.append(found.forces_at(built, 0.5)[count // 2, 0])
        moves.append(found.displacements[0, 0])
    assert richardson(thrusts) == pytest.approx(-SPREAD * radius, rel=1e-6)
    assert richardson(moves) == pytest.approx(-SPREAD * radius**2 / (YOUNGS * AREA), rel=1e-6)


def test_a_quarter_ring_that_sticks_out_bends_and_twists():
    """P R^3 (pi / (4 E I) + (3 pi / 4 - 2) / (G J)) at the tip: Roark, curved beams in bow."""
    radius, moves = 2000.0, []
    for count in (80, 160):
        built = frames.polyline(arc(count, radius, np.pi / 2))
        loads = Loads.none(built)
        loads.nodal[count, 2] = -FORCE
        moves.append(response(frames.system(built, {0: RIGID}), loads).displacements[count, 2])
    bent = np.pi / (4 * YOUNGS * ABOUT_Y) + (3 * np.pi / 4 - 2) / (SHEAR * TORSION)
    assert richardson(moves) == pytest.approx(-FORCE * radius**3 * bent, rel=1e-6)


def test_a_support_slides_in_any_direction_and_springs_give_way():
    """A bar along x on a plane that leans by 30 degrees, pushed against it."""
    built = frames.straight(1)
    lean = np.radians(30.0)
    along = np.array([np.cos(lean), 0.0, np.sin(lean)])
    across = np.array([-np.sin(lean), 0.0, np.cos(lean)])
    directions = np.broadcast_to(np.eye(3), (2, 3, 3)).copy()
    directions[1] = [along, [0.0, 1.0, 0.0], across]
    fixed = np.array([[1, 1, 1, 1, 1, 1], [0, 1, 1, 0, 0, 0]], dtype=bool)
    springs = np.zeros((2, 6))
    springs[1, 0] = 250.0
    loads = Loads.none(built)
    loads.nodal[1, :3] = 1e4 * along
    found = response(FrameSystem(built, Supports(fixed, springs, directions)), loads)
    moved = found.displacements[1, :3]
    assert abs(moved @ across) < 1e-12 * np.linalg.norm(moved)
    # The bar resists along x and z; the spring along the plane.
    stiff = YOUNGS * AREA / LENGTH * along[0] ** 2
    stiff += 3 * YOUNGS * ABOUT_Y / LENGTH**3 * along[2] ** 2
    assert moved @ along == exactly(1e4 / (stiff + 250.0))
    assert imbalance(built, loads, found.reactions) < 1e-12


def test_a_spring_at_an_end_lies_between_hinge_and_clamp():
    """M = q L^2 / 8 / (1 + 3 E I / (c L)) at a clamp that turns by M / c."""
    for spring in (0.0, 1e8, 5e9, np.inf):
        springs = np.full((1, 12), np.inf)
        springs[0, 4] = spring
        built = frames.straight(1, springs=springs)
        loads = Loads.none(built)
        loads.spread[0, 2] = -SPREAD
        found = response(frames.system(built, {0: RIGID, 1: "x y z"}), loads)
        soft = 3 * YOUNGS * ABOUT_Y / LENGTH / spring if spring else np.inf
        moment = SPREAD * LENGTH**2 / 8 / (1 + soft)
        assert found.forces_at(built, 0.0)[0, 4] == pytest.approx(moment, rel=1e-9, abs=1e-3)


def test_a_divided_frame_moves_as_the_whole_one():
    nodes = [[0, 0, 0], [3000, 200, 900], [5000, 2500, 1200], [3500, -2600, 800]]
    springs = np.full((3, 12), np.inf)
    springs[1, 4:6] = 0.0
    built = frames.frame(nodes, [(0, 1), (1, 2), (1, 3)], springs=springs)
    loads = Loads.none(built)
    loads.spread[:] = [1.0, -2.0, -5.0]
    held = dict.fromkeys((0, 2, 3), RIGID)
    whole = response(frames.system(built, held), loads)
    cut = built.divided(3)
    parts = response(frames.system(cut, held), loads.divided(built, 3))
    assert np.allclose(parts.displacements[:4], whole.displacements, rtol=1e-9, atol=1e-12)
    middle = parts.forces_at(cut, 0.5)[1::3]
    assert np.allclose(middle, whole.forces_at(built, 0.5), rtol=1e-8, atol=1e-6)
    assert imbalance(built, loads, whole.reactions) < 1e-12


@pytest.mark.parametrize(
    ("held", "said"),
    [
        ({}, "supports: there are none"),
        ({0: "x y z"}, "supports: a mechanism: nodes 1, 2, 3 move freely"),
        ({0: "x y z", 3: "x y z"}, "supports: a mechanism: nodes .* freely"),
    ],
)
def test_a_mechanism_is_refused_by_naming_what_moves(held, said):
    with pytest.raises(InputError, match=said) as found:
        frames.system(frames.straight(3), held)
    assert "\n" not in str(found.value)


def test_one_node_of_many_that_moves_is_the_one_named():
    """Bars with hinges in one plane: their node moves out of it."""
    nodes = [[0, 0, 0], [1000, 0, 0], [2000, 0, 0], [1000, 800, 0]]
    built = frames.frame(nodes, [(0, 1), (1, 2), (1, 3)], springs=frames.hinged(3))
    with pytest.raises(InputError, match="a mechanism: node 1 moves freely"):
        frames.system(built, dict.fromkeys((0, 2, 3), "x y z"))


def test_a_part_that_hangs_loose_is_refused():
    nodes = [[0, 0, 0], [1000, 0, 0], [0, 500, 0], [1000, 500, 0]]
    built = frames.frame(nodes, [(0, 1), (2, 3)])
    with pytest.raises(InputError, match="a part with nodes 2, 3 hangs loose"):
        frames.system(built, {0: RIGID})


def test_what_makes_no_frame_is_refused():
    one = frames.straight(1)
    with pytest.raises(InputError, match="area: member 0 has 0, so no stiffness"):
        frames.straight(1, area=0.0)
    with pytest.raises(InputError, match="member 1: has no length between nodes 1 and 2"):
        frames.polyline([[0, 0, 0], [1, 0, 0], [1, 0, 0]])
    with pytest.raises(InputError, match="member 0: its section is turned by a direction along"):
        frames.system(frames.straight(1, up=(1.0, 0, 0)), {0: RIGID})
    with pytest.raises(InputError, match="members: expected numbers of nodes from 0 to 1"):
        Frame(one.nodes, np.array([[0, 2]]), one.stiffness, one.up, one.springs)
    springs = np.full((1, 12), np.inf)
    springs[0, [3, 9]] = 0.0
    with pytest.raises(InputError, match="member 0: moves freely between its nodes"):
        frames.system(frames.straight(1, springs=springs), {0: RIGID})


def test_a_moment_on_a_joint_that_turns_nothing_is_refused():
    built = frames.dome(6, 4000.0, 1000.0)
    springs = frames.hinged(6)
    springs[:, 9] = 0.0
    loads = Loads.none(built)
    loads.nodal[0, 5] = 1e5
    standing = FrameSystem(
        Frame(built.nodes, built.members, built.stiffness, built.up, springs),
        Supports.at(7, {node: "x y z" for node in range(1, 7)}),
    )
    with pytest.raises(InputError, match="the moment at node 0 turns joints that nothing holds"):
        response(standing, loads)
