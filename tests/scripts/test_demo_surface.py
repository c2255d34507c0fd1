"""The demo's surface is the one that its formula and the demo promise."""

import importlib.util

import numpy as np
import pytest

from freecad_ortho.step_faces import step_surfaces
from tests.conftest import ROOT

EXAMPLES = ROOT / "examples"


@pytest.fixture(scope="module")
def formula():
    spec = importlib.util.spec_from_file_location("demo_surface", EXAMPLES / "demo_surface.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.surface


def curvatures(formula, u, v, step=1e-3):
    """Mean and Gauss curvature of the formula at parameters, by differences."""

    def at(i, j):
        return formula(u + i * step, v + j * step)

    du, dv = (at(1, 0) - at(-1, 0)) / 2 / step, (at(0, 1) - at(0, -1)) / 2 / step
    duu, dvv = ((at(*k) - 2 * at(0, 0) + at(-k[0], -k[1])) / step**2 for k in ((1, 0), (0, 1)))
    duv = (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / 4 / step**2
    normal = np.cross(du, dv)
    normal /= np.linalg.norm(normal, axis=-1)[..., None]
    e, f, g = ((one * two).sum(-1) for one, two in ((du, du), (du, dv), (dv, dv)))
    ll, mm, nn = ((one * normal).sum(-1) for one in (duu, duv, dvv))
    area = e * g - f * f
    return (e * nn - 2 * f * mm + g * ll) / 2 / area, (ll * nn - mm * mm) / area


def test_the_file_is_the_formula(formula):
    pytest.importorskip("cadquery")
    (face,) = step_surfaces(EXAMPLES / "data" / "demo_roof.step")
    rng = np.random.default_rng(1)
    points = formula(*rng.uniform(-0.99, 0.99, (2, 50)))
    np.testing.assert_allclose(face.foot(points), points, atol=0.5)
    corners = face.grid(np.array(face.u), np.array(face.v)).reshape(-1, 3)
    wanted = formula(*np.array([[-1, -1, 1, 1], [-1, 1, -1, 1]]))
    apart = np.linalg.norm(corners[:, None] - wanted, axis=2).min(axis=1)
    assert apart.max() < 0.5


def test_it_bends_both_ways_and_has_round_points_inside(formula):
    u, v = np.meshgrid(*[np.linspace(-0.95, 0.95, 191)] * 2, indexing="ij")
    mean, gauss = curvatures(formula, u, v)
    assert gauss.max() > 0 > gauss.min()
    # Both curvatures are the same at an umbilic alone.
    differ = np.sqrt(np.maximum(mean**2 - gauss, 0.0)) / np.abs(mean).max()
    round_ones = np.argwhere(differ < 0.03)
    assert len(round_ones)
    assert np.abs(u[tuple(round_ones.T)]).max() < 0.8
    sides = np.unique(np.sign(u[tuple(round_ones.T)]))
    assert len(sides) == 2


def test_it_stands_above_the_ground_and_its_border_is_not_planar(formula):
    side = np.linspace(-1, 1, 101)
    ends = np.ones_like(side)
    border = np.concatenate(
        [formula(side, ends), formula(side, -ends), formula(ends, side), formula(-ends, side)]
    )
    assert border[:, 2].min() == pytest.approx(500.0)
    thickness = np.linalg.svd(border - border.mean(axis=0), compute_uv=False)[-1]
    assert thickness / np.sqrt(len(border)) > 500
