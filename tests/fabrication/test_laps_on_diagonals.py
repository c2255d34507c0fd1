"""Half-lap slots leave room for what passes them, on nets whose lines cross aslant."""

from itertools import product

import numpy as np
import pytest

from freecad_ortho.fabrication import Beams, Lamellas, build
from freecad_ortho.fabrication.step import read_step, write_step
from solver.errors import InputError
from solver.mesh.diagonal import diagonal_meshes
from tests.meshes import grid, helicoid


def shared_by_laps(folder, parts):
    """Volumes, mm3, that the solids as written share at each crossing of two families."""
    write_step(folder / "parts.step", parts)
    solids = dict(read_step(folder / "parts.step"))
    families = [[part for part in parts if part.family == family] for family in "uv"]
    return {
        (one.name, other.name): solids[one.name].intersect(solids[other.name]).Volume()
        for one, other in product(*families)
        if set(one.vertices) & set(other.vertices)
    }


@pytest.mark.parametrize("which", ["first", "second"])
def test_solids_that_lap_share_nothing(tmp_path, which):
    """The CAD kernel cuts the solids that were written, at the default clearance."""
    net = getattr(diagonal_meshes(helicoid(rows=5, columns=6)), which).scaled(1000.0)
    sizes = {"width": 60.0, "thickness": 10.0, "strip": "twisted", "pattern": "free"}
    shared = shared_by_laps(tmp_path, build(net, [Lamellas(**sizes)]).parts)
    assert len(shared) >= 10
    assert max(shared.values()) < 0.01


def saddle(turned=0.0, radius=2500.0):
    """Its lines along the principal directions or aslant to them, in mm."""
    s, t = np.meshgrid(*2 * [np.linspace(-1000, 1000, 3)], indexing="ij")
    x, y = s * np.cos(turned) - t * np.sin(turned), s * np.sin(turned) + t * np.cos(turned)
    return grid(x, y, (x**2 - y**2) / (2 * radius))


@pytest.mark.parametrize(("strip", "turned"), [("twisted", 0.15), ("developable", 0.0)])
def test_lamellas_that_bend_away_from_each_other_have_deeper_slots(tmp_path, strip, turned):
    """One rises on both sides of a crossing where the other falls: floors must not meet."""
    sizes = {"width": 80.0, "thickness": 10.0, "strip": strip, "pattern": "free"}
    parts = build(saddle(turned), [Lamellas(**sizes)]).parts
    shared = shared_by_laps(tmp_path, parts)
    assert len(shared) == 9
    assert max(shared.values()) < 0.01


def test_slots_take_lamellas_that_cross_beside_their_bend_lines(tmp_path):
    """Lines curved in plan on a saddle: rulings slant by 20 degrees, plates bend by 20 there."""
    s, t = np.meshgrid(*2 * [np.linspace(-1500, 1500, 3)], indexing="ij")
    x, y = s + 2e-4 * t**2, t + 2e-4 * s**2
    sizes = {"width": 120.0, "thickness": 6.0, "clearance": 0.2, "strip": "developable"}
    parts = build(grid(x, y, 1.5e-4 * x * y), [Lamellas(pattern="free", **sizes)]).parts
    shared = shared_by_laps(tmp_path, parts)
    assert len(shared) == 9
    assert max(shared.values()) < 0.01


def test_lamellas_that_bend_too_sharply_for_their_slots_are_refused_by_name():
    sizes = {"width": 84.0, "thickness": 80.0, "overhang": 400.0}
    with pytest.raises(InputError, match=r"L-U00\d and L-V00\d bend so sharply.*thinner or wider"):
        build(saddle(radius=700.0), [Lamellas(strip="twisted", pattern="free", **sizes)])


def test_lapped_beams_share_nothing(tmp_path, roof):
    """Ridges and valleys with planar faces."""
    parts = build(roof, [Beams(200, 20, ends="lapped")]).parts
    shared = shared_by_laps(tmp_path, parts)
    assert len(shared) == 70
    assert max(shared.values()) < 0.01
