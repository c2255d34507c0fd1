"""From model to paper: a scale, and what of the model is where."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.mesh.quadmesh import FloatArray


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
