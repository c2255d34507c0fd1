"""The same frames by another program: PyNiteFEA."""

import numpy as np
from Pynite import FEModel3D

from solver.frame.model import Loads
from solver.frame.response import response
from tests.solver.frame import frames
from tests.solver.frame.frames import AREA, RIGID, SHEAR, TORSION, YOUNGS

ABOUT = 2.2e6


def test_a_shell_moves_and_is_held_as_pynite_says():
    side = 6
    x, y = np.meshgrid(np.arange(side), np.arange(side), indexing="ij")
    height = 0.08 * (x * (side - 1 - x) + y * (side - 1 - y)) + 0.02 * x * y
    nodes = 1000.0 * np.stack([x, y, height], axis=-1).reshape(-1, 3)
    number = np.arange(side**2).reshape(side, side)
    pairs = [(number[:-1], number[1:]), (number[:, :-1], number[:, 1:])]
    members = np.concatenate([np.stack([a.ravel(), b.ravel()], axis=1) for a, b in pairs])
    built = frames.frame(nodes, members, about_y=ABOUT, about_z=ABOUT)
    held = dict.fromkeys(np.unique([number[0], number[-1]]).tolist(), "x y z")
    held[0] = RIGID
    loads = Loads.none(built)
    loads.spread[:] = [0.2, 0.0, -1.5]
    loads.nodal[14, :3] = [500.0, -300.0, -2000.0]
    found = response(frames.system(built, held), loads)

    other = FEModel3D()
    other.add_material("steel", YOUNGS, SHEAR, 0.3, 0.0)
    other.add_section("tube", AREA, ABOUT, ABOUT, TORSION)
    for node, place in enumerate(nodes):
        other.add_node(str(node), *place)
    for node, words in held.items():
        other.def_support(str(node), *(name in words.split() for name in RIGID.split()))
    for member, (one, two) in enumerate(members):
        other.add_member(str(member), str(one), str(two), "steel", "tube")
        for direction, size in (("FX", 0.2), ("FZ", -1.5)):
            other.add_member_dist_load(str(member), direction, size, size)
    for direction, size in zip(("FX", "FY", "FZ"), loads.nodal[14, :3], strict=True):
        other.add_node_load("14", direction, size)
    other.analyze_linear()
    theirs = [other.nodes[str(node)] for node in range(len(nodes))]
    moved = np.array([[n.DX["Combo 1"], n.DY["Combo 1"], n.DZ["Combo 1"]] for n in theirs])
    pushed = np.array(
        [[n.RxnFX["Combo 1"], n.RxnFY["Combo 1"], n.RxnFZ["Combo 1"]] for n in theirs]
    )
    assert np.abs(found.displacements[:, :3] - moved).max() < 1e-6 * np.abs(moved).max()
    assert np.abs(found.reactions[:, :3] - pushed).max() < 1e-6 * np.abs(pushed).max()
    thrust = [other.members[str(k)].axial(0.0, "Combo 1") for k in range(len(members))]
    # Compression is positive there.
    ours = found.forces_at(built, 0.0)[:, 0]
    assert np.abs(ours + np.array(thrust)).max() < 1e-6 * np.abs(ours).max()
