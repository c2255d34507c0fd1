"""The gallery: figures 4, 5, 10, 11, 15 and 16 in numbers; the scripts are examples."""

from __future__ import annotations

import importlib.util
import re
import subprocess
import sys

import numpy as np
import pytest

from examples.drawn_multi_net import DRAWN, ELLIPSOID, dragged
from examples.drawn_multi_net import net as drawn_net
from examples.minimal_gridshell import diagonal, membrane
from examples.six_multi_nets import AXES, six_nets
from examples.triangles_to_gridshell import gridshell, vault
from scripts.docs_gallery import EXAMPLES
from solver.analysis import measures
from solver.mesh.grid import grid_mesh
from solver.mesh.remesh import LIBRARY
from solver.multinet import EllipticSystem
from tests.conftest import ROOT

needs_library = pytest.mark.skipif(
    importlib.util.find_spec(LIBRARY) is None, reason=f"{LIBRARY} is not installed"
)


def test_every_figure_of_the_gallery_is_short_and_has_its_picture():
    page = (ROOT / "docs" / "gallery.md").read_text(encoding="utf-8")
    for name in EXAMPLES:
        script = ROOT / "examples" / f"{name}.py"
        assert len(script.read_text(encoding="utf-8").splitlines()) <= 60, name
        assert f"pictures/gallery/{name}.png" in page
        assert f"examples/{name}.py" in page


@pytest.mark.parametrize(
    ("example", "low", "high"),
    [
        ("six_multi_nets", 1e-16, 1e-14),
        ("drawn_multi_net", 1e-16, 1e-14),
        ("moebius_of_principal_net", 5e-4, 1e-3),
        ("torsion_free_roof", 1e-16, 1e-10),
        ("minimal_gridshell", 0.17, 0.21),
        pytest.param("triangles_to_gridshell", 0, 1e-12, marks=needs_library),
    ],
)
def test_an_example_prints_its_number(tmp_path, example, low, high):
    pytest.importorskip("matplotlib")
    picture = tmp_path / "picture.png"
    command = [sys.executable, "-m", f"examples.{example}", str(picture)]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=100)
    assert run.returncode == 0, run.stderr
    printed = re.findall(r"\d[\d.]*(?:e-\d+)?", run.stdout)
    assert len(printed) == 1
    assert low <= float(printed[0]) <= high
    assert picture.read_bytes().startswith(b"\x89PNG")


def test_figure_4_shows_each_role_of_each_quadric():
    system = EllipticSystem(*AXES)
    nets = six_nets()
    assert len(nets) == 6
    expected = [(0, 13), (0, 13), (1, 13), (1, 15), (2, 19), (2, 19)]
    for (name, mesh), (moving, lines) in zip(nets.items(), expected, strict=True):
        assert not measures.flipped(mesh).any(), name
        assert measures.edge_ratio(mesh) > 0.1, name
        values = system.coordinates(mesh.vertices)[:, moving]
        assert len(np.unique(np.round(values, 8))) == lines, name
    assert len(nets["(b) and is reflected"].faces) == 4 * len(nets["(a) lambda moves"].faces)


def test_figure_5_follows_the_dragged_point_only():
    before, after = drawn_net(DRAWN), drawn_net(dragged())
    moved = np.linalg.norm(before.vertices - after.vertices, axis=1).reshape(33, 15)
    assert moved.max() > 0.3
    # The ends stay; t is spaced evenly anew between them.
    assert moved[np.ix_([0, -1], [0, -1])].max() < 1e-9
    assert not measures.flipped(after).any()
    feet = ELLIPSOID.project(DRAWN)
    assert np.linalg.norm(before.vertices - feet[0], axis=1).min() < 0.2


def test_figure_15_starts_nearly_asymptotic():
    film = membrane()
    assert measures.asymptotic(diagonal(film)).max() < 0.02
    assert measures.asymptotic(film).max() > 0.05


def test_figure_16_feet_stay_on_the_ground():
    """The steps after the remeshing, on quads along the curvature lines of the vault."""
    quads = grid_mesh(vault()[0].reshape(41, 61, 3)[::2, ::3])
    start, net, feet = gridshell(quads)
    assert measures.orthogonality(start).max() > 0.1
    assert len(feet) == 18
    assert np.abs(net.vertices[feet, 2]).max() < 1e-12
    assert np.abs(net.vertices[feet] - start.vertices[feet]).max() > 1e-3
    assert max(measures.asymptotic(net).max(), measures.orthogonality(net).max()) < 1e-10
    assert not measures.flipped(net).any()
    assert measures.edge_ratio(net) > 0.5


@pytest.mark.skipif(importlib.util.find_spec(LIBRARY) is not None, reason="library installed")
def test_figure_16_says_what_it_needs():
    command = [sys.executable, "-m", "examples.triangles_to_gridshell"]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=100)
    assert run.returncode == 1
    assert "pip install pyQuadriFlow" in run.stderr and run.stderr.count("\n") == 1
