"""A round point near a mesh that lies far from the origin: all work is done about it.

Five million metres from the origin a coordinate is rounded to a nanometre, and whatever squares it
or subtracts it loses digits that a net needs. About a point nearby nothing is lost.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray, QuadMesh

# A mesh is far from the origin along an axis where it is so many times its size away.
_FAR = 1e3


@dataclass(frozen=True, eq=False)
class LocalOrigin:
    """What is taken off coordinates before work, and put back after it.

    It is zero along every axis along which the mesh is not far from the origin, so that such
    coordinates keep every bit. Where it is not zero it is a round number within five times the
    mesh's size: taking it off is exact in floating point, and so is putting it back to a coordinate
    that has not changed.

    Args:
        shift: (3,) the point, in the unit of the coordinates.
    """

    shift: FloatArray

    @classmethod
    def of(cls, points: FloatArray) -> LocalOrigin:
        """The local origin of (N, 3) points."""
        if not len(points):
            return cls(np.zeros(3))
        low, high = points.min(axis=0), points.max(axis=0)
        size = float(np.linalg.norm(high - low))
        middle = 0.5 * low + 0.5 * high
        far = np.abs(middle) > _FAR * size
        if size == 0.0 or not far.any():
            return cls(np.zeros(3))
        step = 10.0 ** math.ceil(math.log10(size))
        return cls(np.where(far, np.round(middle / step) * step, 0.0))

    @classmethod
    def of_mesh(cls, mesh: QuadMesh) -> LocalOrigin:
        """The local origin of a mesh; vertices that belong to no face do not count."""
        return cls.of(mesh.vertices[mesh.connectivity.referenced])

    @property
    def far(self) -> bool:
        """Whether there is anything to take off."""
        return bool(self.shift.any())

    def near(self, points: FloatArray) -> FloatArray:
        """Coordinates about the local origin."""
        return points - self.shift if self.far else points

    def back(self, points: FloatArray) -> FloatArray:
        """The same coordinates where they came from."""
        return points + self.shift if self.far else points

    def near_mesh(self, mesh: QuadMesh) -> QuadMesh:
        """The mesh about the local origin; itself where it is not far."""
        return mesh.with_vertices(self.near(mesh.vertices)) if self.far else mesh

    def back_mesh(self, mesh: QuadMesh) -> QuadMesh:
        """The mesh where it came from."""
        return mesh.with_vertices(self.back(mesh.vertices)) if self.far else mesh

    def scaled(self, factor: float) -> LocalOrigin:
        """The same point in another unit."""
        return LocalOrigin(self.shift * factor)


def measured_from(choice: str | Sequence[float], local: FloatArray) -> FloatArray:
    """(3,) what coordinates in files are to be measured from.

    Args:
        choice: ``keep`` for the model's own origin, ``local``, or a point.
        local: (3,) the local origin.

    Raises:
        InputError: neither a word nor a point.
    """
    words = {"keep": np.zeros(3), "local": local}
    try:
        point = words[choice] if isinstance(choice, str) else np.asarray(choice, dtype=np.float64)
    except (KeyError, ValueError, TypeError):
        point = np.zeros(0)
    if point.shape != (3,) or not np.isfinite(point).all():
        raise InputError(f"origin: expected keep, local or a point of three, got {choice!r}")
    return point


def resolution(mesh: QuadMesh) -> float:
    """Distance of neighbouring floating-point numbers where a mesh lies, in mean edges."""
    return float(np.spacing(np.abs(mesh.vertices).max()) / mesh.mean_edge)
