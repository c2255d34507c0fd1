"""Frames for tests: one section, sizes as of a small steel tube, N and mm."""

import numpy as np

from solver.frame.model import Frame, Loads, Stiffness, Supports, rigid_joints
from solver.frame.system import FrameSystem

AREA, ABOUT_Y, ABOUT_Z, TORSION = 1684.0, 2.2e6, 0.9e6, 2.0e6
YOUNGS, SHEAR = 210e3, 81e3
RIGID = "x y z rx ry rz"


def frame(nodes, members, up=(0.0, 0.0, 1.0), springs=None, panels=None, **other):
    sizes = {
        "area": AREA, "about_y": ABOUT_Y, "about_z": ABOUT_Z, "torsion": TORSION,
        "youngs": YOUNGS, "shear": SHEAR,
    }  # fmt: skip
    count = len(members)
    ups = np.array(np.broadcast_to(np.asarray(up, dtype=float), (count, 3)))
    given = {} if panels is None else {"panels": panels}
    return Frame(
        np.asarray(nodes, dtype=float),
        np.asarray(members),
        Stiffness.same(count, **(sizes | other)),
        ups,
        rigid_joints(count) if springs is None else springs,
        **given,
    )


def polyline(points, up=(0.0, 0.0, 1.0), **other):
    count = len(points) - 1
    members = np.stack([np.arange(count), np.arange(1, count + 1)], axis=1)
    return frame(points, members, up, **other)


def straight(count, length=3000.0, **other):
    return polyline(np.linspace(0, length, count + 1)[:, None] * [1.0, 0.0, 0.0], **other)


def hinged(count, ends="both"):
    """Springs of members whose ends turn freely, but for twisting at the first."""
    springs = np.full((count, 12), np.inf)
    springs[:, 9:] = 0.0
    if ends == "both":
        springs[:, 4:6] = 0.0
    return springs


def system(built, held):
    return FrameSystem(built, Supports.at(len(built.nodes), held))


def dome(sides, radius, rise):
    """Bars with hinges from a ring that is held to a node in the middle, number 0."""
    angles = 2 * np.pi * np.arange(sides) / sides
    ring = np.stack([radius * np.cos(angles), radius * np.sin(angles), 0 * angles], axis=1)
    nodes = np.concatenate([[[0.0, 0.0, rise]], ring])
    members = [(0, k + 1) for k in range(sides)]
    return frame(nodes, members, springs=hinged(sides))


def star_dome():
    """The 24 bars of Levy, Spillers (2003), Analysis of geometrically nonlinear structures, 2.4.2.

    Inches and pounds; crown, ring and feet; the load of 220.46 lb on the crown is one.
    """
    ring, feet = np.radians(60 * np.arange(6)), np.radians(60 * np.arange(6) + 30)
    rows = [(0.0, 0.0, 3.2346)]
    rows += [(9.8425 * np.cos(a), 9.8425 * np.sin(a), 2.4472) for a in ring]
    rows += [(19.685 * np.cos(a), 19.685 * np.sin(a), 0.0) for a in feet]
    bars = [(0, 1 + k) for k in range(6)]
    bars += [(1 + k, 1 + (k + 1) % 6) for k in range(6)]
    bars += [(1 + k, 7 + n % 6) for k in range(6) for n in (k - 1, k)]
    sizes = {"area": 0.0155, "youngs": 3e7, "shear": 1.15e7}
    thin = {"about_y": 1e-4, "about_z": 1e-4, "torsion": 1e-4}
    built = frame(rows, bars, springs=hinged(24), **sizes, **thin)
    loads = Loads.none(built)
    loads.nodal[0, 2] = -220.46
    return system(built, {node: "x y z" for node in range(7, 13)}), loads
