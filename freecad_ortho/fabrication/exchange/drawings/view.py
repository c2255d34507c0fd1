"""From model to paper: a scale, and what of the model is where."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.mesh.quadmesh import FloatArray

# What is seen of a net from above is enough where it is as much of what one side shows.
_ENOUGH = 0.75


@dataclass(frozen=True, eq=False)
class View:
    """A plane of the model on paper.

    Attributes:
        scale: 1 to so many.
        middle: (2,) of the model, mm.
        at: (2,) where that is on paper, mm.
    """

    scale: int
    middle: FloatArray
    at: FloatArray

    def __call__(self, points: FloatArray) -> FloatArray:
        """(..., 2) points of the model on paper, mm."""
        return np.asarray((points - self.middle) / self.scale + self.at)

    @property
    def words(self) -> str:
        """As title blocks say it."""
        return f"1:{self.scale}"


def box_of(points: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Low and high corner (2,) of points (n, 2)."""
    return points.min(axis=0), points.max(axis=0)


def millimetres(value: float) -> str:
    """As dimensions say a length."""
    return f"{value:.1f}"


def eye(normals: FloatArray) -> tuple[str, FloatArray]:
    """From where a net is seen, and rows (3, 3) to the right, up and towards the eye.

    From above, but for what stands so upright that much less of it would be seen.

    Args:
        normals: (F, 3) of faces, as long as these are large.
    """
    x, y, z = np.abs(normals).sum(axis=0).tolist()
    if z >= _ENOUGH * max(x, y):
        return "seen from above", np.eye(3)
    if y >= x:
        return "seen along y", np.array([[1.0, 0, 0], [0, 0, 1.0], [0, -1.0, 0]])
    return "seen against x", np.array([[0, 1.0, 0], [0, 0, 1.0], [1.0, 0, 0]])
