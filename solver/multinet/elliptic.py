"""Multi-nets in elliptic coordinates: axis-aligned cylinders in the system of confocal quadrics."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray
from solver.multinet.net import MultiNet
from solver.multinet.quadric import SEMI_AXES, Quadric
from solver.option import one_of

COORDINATES = ("lambda", "mu", "nu")
# (n,) parameters to (n,) values of the first and the second of the two coordinates that stay.
CoordinateCurve = Callable[[FloatArray], tuple[FloatArray, FloatArray]]


@dataclass(frozen=True)
class EllipticSystem:
    """Confocal quadrics x^2/(a + k) + y^2/(b + k) + z^2/(c + k) = 1.

    Through a point pass an ellipsoid (k = lambda), a one-sheeted (mu) and a two-sheeted (nu)
    hyperboloid, -a <= nu <= -b <= mu <= -c <= lambda. Semi-axes are square roots of a, b, c: these
    are areas, in the square of the model's unit.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, equation 3.

    Raises:
        InputError: unless a > b > c > 0.
    """

    a: float
    b: float
    c: float

    def __post_init__(self) -> None:
        if not np.isfinite([self.a, self.b, self.c]).all() or not self.a > self.b > self.c > 0:
            raise InputError(
                f"axes: expected a > b > c > 0, got {self.a:g}, {self.b:g}, {self.c:g}; "
                "sort them, and keep them apart"
            )

    @property
    def squares(self) -> FloatArray:
        """(3,) a, b, c."""
        return np.array([self.a, self.b, self.c])

    def bounds(self, coordinate: str) -> tuple[float, float]:
        """Smallest and largest value of lambda, mu or nu."""
        one_of("moving", coordinate, COORDINATES)
        limits = {"lambda": (-self.c, float("inf")), "mu": (-self.b, -self.c)}
        return limits.get(coordinate, (-self.a, -self.b))

    def unfolded(self, coordinate: str, place: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Coordinate value and (n, 3) signed factors for a place on its unfolded line.

        From 0 to 1 the place runs through the whole range of mu or nu, and beyond 1 or below 0 it
        goes on smoothly behind the coordinate plane, with the sign of that axis changed. Lambda is
        ``-c + (a - c) place^2``.

        Returns:
            Values (n,), and sqrt(abs(e + value)) with sign for e = a, b, c.
        """
        squares = self.squares
        if coordinate == "lambda":
            values = -self.c + (self.a - self.c) * place**2
            factors = np.sqrt(np.abs(squares + values[:, None]))
            factors[:, 2] = np.sqrt(self.a - self.c) * place
            return values, factors
        low, high = self.bounds(coordinate)
        sine, cosine = np.sin(0.5 * np.pi * place), np.cos(0.5 * np.pi * place)
        # Places that mean a coordinate plane lie in it to the last digit.
        sine = np.where(np.abs(sine) < 1e-15, 0.0, sine)
        cosine = np.where(np.abs(cosine) < 1e-15, 0.0, cosine)
        values = low + (high - low) * sine**2
        factors = np.sqrt(np.abs(squares + values[:, None]))
        first = 1 if coordinate == "mu" else 0
        factors[:, first] = np.sqrt(high - low) * sine
        factors[:, first + 1] = np.sqrt(high - low) * cosine
        return values, factors

    def points(self, values: ArrayLike, signs: ArrayLike = (1, 1, 1)) -> FloatArray:
        """(..., 3) points from (..., 3) values of lambda, mu, nu and signs of x, y, z.

        Raises:
            InputError: a value outside its range.
        """
        values = np.asarray(values, dtype=np.float64)
        for k, name in enumerate(COORDINATES):
            self._check(name, values[..., k])
        squares = self.squares
        product = np.prod(squares[:, None] + values[..., None, :], axis=-1) / self._denominators
        return np.asarray(np.asarray(signs) * np.sqrt(np.maximum(product, 0.0)))

    def coordinates(self, points: ArrayLike) -> FloatArray:
        """(..., 3) values of lambda, mu, nu of points.

        They are the roots of a cubic: eigenvalues of the symmetric matrix x x^T - diag(a, b, c).
        """
        x = np.asarray(points, dtype=np.float64)
        matrix = x[..., :, None] * x[..., None, :] - np.diag(self.squares)
        roots = np.linalg.eigvalsh(matrix)[..., ::-1]
        low = np.array([self.bounds(name)[0] for name in COORDINATES])
        high = np.array([self.bounds(name)[1] for name in COORDINATES])
        return np.clip(roots, low, high)

    @property
    def _denominators(self) -> FloatArray:
        a, b, c = self.a, self.b, self.c
        return np.array([(a - b) * (a - c), (b - a) * (b - c), (c - a) * (c - b)])

    def _check(self, name: str, values: FloatArray) -> None:
        low, high = self.bounds(name)
        slack = 1e-12 * self.a
        bad = ~((values >= low - slack) & (values <= high + slack))
        if bad.any():
            raise InputError(
                f"{name}: expected {low:.6g} <= {name} <= {high:.6g}, got "
                f"{np.asarray(values)[bad].flat[0]:.6g}; keep the curve in that range"
            )

    def base_curve(self, base: float, factors: tuple[FloatArray, FloatArray]) -> FloatArray:
        """(n, 3) points with the moving coordinate at ``base`` and signed factors of the others."""
        own = np.sqrt(np.abs(self.squares + base))
        return own * factors[0] * factors[1] / np.sqrt(np.abs(self._denominators))


def refuse_unsorted(semi_axes: ArrayLike) -> None:
    """Refuse (3,) semi-axes that are not positive, or do not fall.

    Raises:
        InputError: saying what came.
    """
    lengths = tuple(np.asarray(semi_axes, dtype=np.float64).tolist())
    SEMI_AXES.check(lengths, unit="")
    if not lengths[0] > lengths[1] > lengths[2]:
        raise InputError(
            "semi axes: expected three different ones, the largest first, got "
            f"{', '.join(f'{length:g}' for length in lengths)}; sort them, and keep them apart, as "
            "two equal ones make a rotational surface"
        )


def others(moving: str) -> tuple[str, str]:
    """The two coordinates that stay, in the order lambda, mu, nu."""
    first, second = (name for name in COORDINATES if name != moving)
    return first, second


def elliptic_net(
    axes: ArrayLike,
    moving: str,
    curve: CoordinateCurve,
    *,
    unfolded: bool = False,
    closed: bool = False,
) -> MultiNet:
    """Multi-net in which one elliptic coordinate is t and a curve gives the other two.

    Args:
        axes: a > b > c > 0 of the confocal system (squares of the semi-axes for lambda = 0).
        moving: lambda, mu or nu: the coordinate in the role of t.
        curve: two functions of s in one, for the two other coordinates in the order lambda, mu, nu.
        unfolded: the curve gives places as in :meth:`EllipticSystem.unfolded`, not values.
        closed: the curve returns to its start at s = 1.

    Returns:
        A net whose parameter t is the value of the moving coordinate.

    Raises:
        InputError: bad axes, or a value outside its range (when the net is sampled).
    """
    system = EllipticSystem(*np.asarray(axes, dtype=np.float64).tolist())
    low, high = system.bounds(moving)
    span = system.a - system.c if np.isinf(high) else high - low
    base = low + 0.5 * span
    quadric = Quadric(1.0 / (system.squares + base))

    def on_quadric(s: FloatArray) -> FloatArray:
        factors = []
        for name, given in zip(others(moving), curve(s), strict=True):
            given = np.broadcast_to(np.asarray(given, dtype=np.float64), s.shape)
            if unfolded:
                factors.append(system.unfolded(name, given)[1])
            else:
                system._check(name, given)
                factors.append(_factors(system, given))
        return system.base_curve(base, (factors[0], factors[1]))

    # By default clear of both ends, where the net is flat and may fold.
    ends = (low + 0.1 * span, low + (1.0 if np.isinf(high) else 0.9) * span)
    return MultiNet(quadric, on_quadric, base, closed, ends)


def _factors(system: EllipticSystem, values: FloatArray) -> FloatArray:
    """Square roots of e + value, zero to the last digit where a value is meant to be a limit."""
    shifted = system.squares + np.asarray(values)[:, None]
    shifted = np.where(np.abs(shifted) < 1e-14 * system.a, 0.0, shifted)
    return np.sqrt(np.abs(shifted))
