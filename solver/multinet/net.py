"""The smooth form of a multi-net, from which any sampling is an exact multi-net."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from solver.errors import InputError
from solver.mesh.grid import grid_mesh, refuse_sampling
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.multinet.quadric import Quadric
from solver.option import Option

# Takes (n,) curve parameters, returns (n, 3) points near a quadric.
Curve = Callable[[FloatArray], FloatArray]
# Points at which lengths are measured.
_FINE = 513

SPACING = Option(
    "spacing",
    "length",
    "choice",
    "Lines stand at even distances, or at equal steps of the parameters",
    ("length", "parameter"),
)


@dataclass(frozen=True, eq=False)
class MultiNet:
    """phi(s, t) = sqrt((t - base) S + I) c(s), in the frame of a quadric.

    Eq. 1 holds for any s and t, because for two points p, q of the curve and two maps D, E,
    ``|E q - D p|^2 - |D q - E p|^2 = q^T (E^2 - D^2) q - p^T (E^2 - D^2) p``, E^2 - D^2 is a
    multiple of S, and p^T S p = q^T S q. Points of the curve are therefore scaled onto the quadric
    to the last digit, and nothing else matters.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, section 3.2.

    Attributes:
        quadric: the quadric Q of the curve.
        curve: c(s) for 0 <= s <= 1.
        base: the t at which the net passes through the curve itself.
        closed: the curve returns to its start at s = 1.
        t_range: default ends of t, or None where the user has to give them.
    """

    quadric: Quadric
    curve: Curve
    base: float = 0.0
    closed: bool = False
    t_range: tuple[float, float] | None = None

    @property
    def admissible(self) -> tuple[float, float]:
        """Smallest and largest t; at both the net lies in a plane."""
        low, high = self.quadric.admissible
        return low + self.base, high + self.base

    def points(self, s: FloatArray, t: FloatArray) -> FloatArray:
        """(M, N, 3) points phi(s_i, t_j).

        Raises:
            InputError: a t outside the admissible range, or a curve that leaves the quadric.
        """
        t = np.asarray(t, dtype=np.float64)
        low, high = self.admissible
        slack = 1e-12 * (abs(low) + abs(self.base))
        bad = ~((t >= low - slack) & (t <= high + slack))
        if bad.any():
            raise InputError(
                f"t: expected {low:.6g} <= t <= {high:.6g} for this {self.quadric.kind}, got "
                f"{t[bad][0]:.6g}; narrow the range"
            )
        factors = self.quadric.factors(np.clip(t, low, high) - self.base)
        start = self.quadric.normalised(np.asarray(self.curve(np.asarray(s, dtype=np.float64))))
        frame = self.quadric.to_frame(start)[:, None, :] * factors[None, :, :]
        return self.quadric.from_frame(frame)

    def mesh(self, s: FloatArray, t: FloatArray) -> QuadMesh:
        """Multi-net with vertex (i, j) at phi(s_i, t_j), number i * N + j."""
        return grid_mesh(self.points(s, t), closed_u=self.closed)

    def sampled(
        self,
        m: int,
        n: int,
        t_range: tuple[float, float] | None = None,
        spacing: str = "length",
    ) -> QuadMesh:
        """Multi-net of M x N vertices.

        Args:
            m: vertices along the curve.
            n: vertices along t.
            t_range: first and last t; by default that of the net.
            spacing: ``length`` for edges of even length in the mean, ``parameter`` for equal steps
                of s and t.

        Raises:
            InputError: too few samples, or a range that is empty or not admissible.
        """
        s, t = self.parameters(m, n, t_range, spacing)
        return self.mesh(s, t)

    def parameters(
        self,
        m: int,
        n: int,
        t_range: tuple[float, float] | None = None,
        spacing: str = "length",
    ) -> tuple[FloatArray, FloatArray]:
        """(M,) and (N,) parameters of :meth:`sampled`."""
        first, last = self._range(t_range)
        SPACING.check(spacing)
        refuse_sampling(m, n, closed_u=self.closed)
        count = m + self.closed
        if spacing == "parameter":
            s, t = np.linspace(0, 1, count), np.linspace(first, last, n)
        else:
            s, t = self._even_s(count, (first, last)), self._even_t(n, (first, last))
        return s[:m], t

    def _range(self, t_range: tuple[float, float] | None) -> tuple[float, float]:
        chosen = self.t_range if t_range is None else t_range
        low, high = self.admissible
        if chosen is None:
            raise InputError(
                f"t: expected a range, got none; choose one between {low:.6g} and {high:.6g}"
            )
        first, last = float(chosen[0]), float(chosen[1])
        slack = 1e-12 * (abs(low) + abs(self.base))
        if not (low - slack <= first < last <= high + slack) or not np.isfinite(last):
            raise InputError(
                f"t: expected {low:.6g} <= T0 < T1 <= {high:.6g} for this {self.quadric.kind}, got "
                f"{first:.6g} to {last:.6g}; narrow the range"
            )
        return first, last

    def _even_s(self, count: int, ends: tuple[float, float]) -> FloatArray:
        fine = np.linspace(0, 1, _FINE)
        lines = self.points(fine, np.linspace(*ends, 5))
        return _even(fine, np.linalg.norm(np.diff(lines, axis=0), axis=2).mean(axis=1), count)

    def _even_t(self, count: int, ends: tuple[float, float]) -> FloatArray:
        # Clustered at the ends, where the factors behave like square roots.
        angle = np.linspace(0, np.pi, _FINE)
        fine = ends[0] + (ends[1] - ends[0]) * np.sin(0.5 * angle) ** 2
        lines = self.points(np.linspace(0, 1, 9), fine)
        return _even(fine, np.linalg.norm(np.diff(lines, axis=1), axis=2).mean(axis=0), count)


def _even(fine: FloatArray, lengths: FloatArray, count: int) -> FloatArray:
    """Parameters that divide a length into equal parts; the ends stay exact."""
    whole = np.append(0.0, np.cumsum(lengths))
    result = np.interp(np.linspace(0, whole[-1], count), whole, fine)
    result[0], result[-1] = fine[0], fine[-1]
    return result
