"""Meshes that many tests use."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from freecad_ortho import api
from solver import QuadMesh

ROOT = Path(__file__).resolve().parents[1]
SHARED = ROOT.parent / "shared" / "meshes"


def shared_mesh(name: str) -> QuadMesh:
    path = SHARED / f"{name}.obj"
    if not path.is_file():
        pytest.skip(f"{path} is missing: the meshes of the paper's authors are not shipped")
    return api.read_mesh(path).mesh


def shared_input(name: str) -> Path:
    """A small file that was once read wrongly."""
    path = SHARED.with_name("inputs") / name
    if not path.is_file():
        pytest.skip(f"{path} is missing: it is not shipped")
    return path


def demo_roof() -> QuadMesh:
    return api.read_mesh(ROOT / "examples" / "data" / "demo_roof.obj").mesh


def grid_faces(rows: int, columns: int) -> np.ndarray:
    """Quads of a grid whose vertex (i, j) has number i * columns + j."""
    corner = np.arange(rows * columns).reshape(rows, columns)
    quads = [corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:], corner[:-1, 1:]]
    return np.stack(quads, axis=2).reshape(-1, 4)


def wavy_grid(rows: int, columns: int, shear: float = 0.2, height: float = 0.15) -> QuadMesh:
    """A sheared grid over a wave: neither orthogonal nor planar anywhere."""
    i, j = np.meshgrid(np.arange(rows, dtype=float), np.arange(columns, dtype=float), indexing="ij")
    x, y = i + shear * j, j.copy()
    z = height * rows * np.sin(2.2 * x / rows + 0.3) * np.cos(1.9 * y / columns - 0.2)
    return QuadMesh(np.stack([x, y, z], axis=2).reshape(-1, 3), grid_faces(rows, columns))


def surface_of_revolution(meridians: int = 9, parallels: int = 7) -> QuadMesh:
    """Part of a barrel sampled along meridians and parallels: exactly principal."""
    angle = np.linspace(0.0, 1.8, meridians)[:, None]
    height = np.linspace(-1.0, 1.3, parallels)[None, :]
    radius = 3.0 - 0.5 * height**2
    points = np.stack([radius * np.cos(angle), radius * np.sin(angle), height + 0 * angle], axis=2)
    return QuadMesh(points.reshape(-1, 3), grid_faces(meridians, parallels))


@pytest.fixture
def barrel() -> QuadMesh:
    return surface_of_revolution()


@pytest.fixture
def wave() -> QuadMesh:
    return wavy_grid(9, 8)
