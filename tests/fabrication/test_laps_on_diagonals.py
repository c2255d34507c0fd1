"""Half-lap slots leave room for what passes them, on nets whose lines cross aslant."""

from itertools import product

import pytest

from freecad_ortho.fabrication import Lamellas, build
from freecad_ortho.fabrication.step import read_step, write_step
from solver.mesh.diagonal import diagonal_meshes
from tests.meshes import helicoid


@pytest.mark.parametrize("which", ["first", "second"])
def test_solids_that_lap_share_nothing(tmp_path, which):
    """The CAD kernel cuts the solids that were written, at the default clearance."""
    net = getattr(diagonal_meshes(helicoid(rows=5, columns=6)), which).scaled(1000.0)
    sizes = {"width": 60.0, "thickness": 10.0, "strip": "twisted", "pattern": "free"}
    parts = build(net, [Lamellas(**sizes)]).parts
    write_step(tmp_path / "lamellas.step", parts)
    solids = dict(read_step(tmp_path / "lamellas.step"))
    families = [[part for part in parts if part.family == family] for family in "uv"]
    laps = [
        (one.name, other.name)
        for one, other in product(*families)
        if set(one.vertices) & set(other.vertices)
    ]
    assert len(laps) >= 10
    for one, other in laps:
        assert solids[one].intersect(solids[other]).Volume() < 0.01, (one, other)
