"""The demo roof is the roof that its formula and its description promise."""

import importlib.util
from pathlib import Path

import numpy as np
import pytest

from solver.io.obj import read_obj

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"


@pytest.fixture(scope="module")
def roof():
    spec = importlib.util.spec_from_file_location("demo_roof", EXAMPLES / "demo_roof.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.demo_roof()


def diagonals(vertices, faces):
    first = vertices[faces[:, 2]] - vertices[faces[:, 0]]
    second = vertices[faces[:, 3]] - vertices[faces[:, 1]]
    return first, second


def test_file_equals_formula(roof):
    vertices, faces = roof
    data = read_obj(EXAMPLES / "data" / "demo_roof.obj")
    assert data.unit == "mm"
    assert data.polygons == faces.tolist()
    np.testing.assert_allclose(data.vertices, vertices, rtol=0, atol=1e-6)


def test_size(roof):
    vertices, faces = roof
    assert faces.shape == (480, 4)
    assert len(vertices) == 525
    length, width, rise = np.ptp(vertices, axis=0)
    assert (length, width, rise) == pytest.approx((26_400, 20_000, 5_400), rel=1e-3)


def test_starts_far_from_principal(roof):
    vertices, faces = roof
    first, second = diagonals(vertices, faces)
    lengths = np.linalg.norm([first, second], axis=-1)
    orthogonality = np.abs(lengths[0] - lengths[1]) / lengths.mean(axis=0)
    assert 0.1 < orthogonality.max() < 0.3
    normal = np.cross(first, second)
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    side = vertices[faces[:, 1]] - vertices[faces[:, 0]]
    planarity = np.abs((side * normal).sum(axis=1)) / lengths.mean(axis=0)
    assert 5e-3 < planarity.max() < 5e-2


def test_faces_look_up(roof):
    first, second = diagonals(*roof)
    assert np.cross(first, second)[:, 2].min() > 0


def test_doubly_curved_with_both_signs(roof):
    vertices, faces = roof
    defect = np.full(len(vertices), 2 * np.pi)
    uses = np.zeros(len(vertices), dtype=int)
    for corner in range(4):
        at, following, before = (faces[:, (corner + k) % 4] for k in (0, 1, 3))
        out, back = vertices[following] - vertices[at], vertices[before] - vertices[at]
        cosine = (out * back).sum(axis=1) / np.linalg.norm([out, back], axis=-1).prod(axis=0)
        np.subtract.at(defect, at, np.arccos(cosine))
        np.add.at(uses, at, 1)
    inner = defect[uses == 4]
    assert inner.max() > 1e-3
    assert inner.min() < -1e-3


def test_border_is_not_planar(roof):
    vertices, faces = roof
    edges = np.sort(np.concatenate([faces[:, [k, (k + 1) % 4]] for k in range(4)]), axis=1)
    unique, count = np.unique(edges, axis=0, return_counts=True)
    border = vertices[np.unique(unique[count == 1])]
    assert len(border) == 2 * (24 + 20)
    thickness = np.linalg.svd(border - border.mean(axis=0), compute_uv=False)[-1]
    assert thickness / np.sqrt(len(border)) > 500
