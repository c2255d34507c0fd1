"""A source of one's own is known by its entry: what it makes, and what the command line says."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.__main__ import main
from freecad_ortho.sources import GROUPS, SOURCES, source
from solver.errors import InputError
from tests.own_source import RAMP


@pytest.fixture
def own(monkeypatch):
    monkeypatch.setitem(SOURCES, RAMP.name, RAMP)
    monkeypatch.setitem(GROUPS, "primitive", (*GROUPS["primitive"], RAMP.name))


def test_it_makes_its_net_in_any_unit(own):
    made = source("ramp").make({"slope": 45.0})
    assert np.ptp(made.mesh.vertices, axis=0) == pytest.approx([6000, 6000, 6000])
    assert made.remarks == ("rises by 6000 mm",)
    assert source("ramp").make({"slope": 45.0}, "m").remarks == ("rises by 6 m",)
    with pytest.raises(InputError, match=r"^ramp: has sampling, width, slope, placement, not 'up'"):
        source("ramp").make({"up": 1})


def test_the_command_line_knows_it(own, tmp_path, capsys):
    with pytest.raises(SystemExit):
        main(["primitive", "--help"])
    assert "ramp: Square that rises in one direction" in capsys.readouterr().out
    path = tmp_path / "ramp.obj"
    command = ["primitive", "ramp", "--sampling", "4x3", "--set", "slope=45", "--unit", "m"]
    assert main([*command, "-o", str(path)]) == 0
    mesh = api.read_mesh(path).mesh
    assert len(mesh.faces) == 6 and np.ptp(mesh.vertices[:, 2]) == pytest.approx(6)
