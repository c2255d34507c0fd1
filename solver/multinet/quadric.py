"""Central quadrics anywhere in space, and the affine maps between confocal ones."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray
from solver.option import POSITIVE, Option

# Parts of 1 below which 1 + t s counts as zero: the rounding of one sum and one product.
_ROUNDING = 32 * np.finfo(np.float64).eps
_BISECTIONS = 200
# In mm, as all options.
SEMI_AXES = Option(
    "semi_axes",
    (9000.0, 6500.0, 4000.0),
    "length",
    "The semi-axes of the quadric are this long",
    written="A,B,C",
    within=POSITIVE,
)


class Quadric:
    """Points x with (x - centre)^T S (x - centre) = 1, S = R diag(s) R^T; immutable.

    Args:
        curvatures: (3,) eigenvalues s of S, 1 / semi-axis^2, negative along an imaginary axis, zero
            along a cylinder; at least one is positive.
        rotation: (3, 3) orthogonal matrix R whose columns are the axes; None for those of space.
        centre: (3,) centre, in the model's unit.

    Raises:
        InputError: values that are no quadric.
    """

    def __init__(
        self,
        curvatures: ArrayLike,
        rotation: ArrayLike | None = None,
        centre: ArrayLike = (0.0, 0.0, 0.0),
    ) -> None:
        self._curvatures = _numbers("curvatures", curvatures, (3,))
        self._rotation = _numbers("rotation", np.eye(3) if rotation is None else rotation, (3, 3))
        self._centre = _numbers("centre", centre, (3,))
        if not np.allclose(self.rotation @ self.rotation.T, np.eye(3), atol=1e-12):
            raise InputError(
                "quadric: expected orthonormal axes, got a matrix that is no rotation; normalise it"
            )
        if not (self.curvatures > 0).any():
            raise InputError(
                "quadric: expected at least one positive eigenvalue, got "
                f"{self.curvatures.tolist()}, which has no real points; change a sign"
            )

    @property
    def curvatures(self) -> FloatArray:
        """(3,) eigenvalues of S."""
        return self._curvatures

    @property
    def rotation(self) -> FloatArray:
        """(3, 3) the axes as columns."""
        return self._rotation

    @property
    def centre(self) -> FloatArray:
        """(3,) where the axes cross, in the model's unit."""
        return self._centre

    @classmethod
    def ellipsoid(
        cls, semi_axes: ArrayLike, rotation: ArrayLike | None = None, centre: ArrayLike = (0, 0, 0)
    ) -> Quadric:
        """Ellipsoid with three semi-axes, in the model's unit."""
        return cls._from_semi_axes(semi_axes, (1, 1, 1), rotation, centre)

    @classmethod
    def one_sheeted(
        cls, semi_axes: ArrayLike, rotation: ArrayLike | None = None, centre: ArrayLike = (0, 0, 0)
    ) -> Quadric:
        """One-sheeted hyperboloid around its third axis."""
        return cls._from_semi_axes(semi_axes, (1, 1, -1), rotation, centre)

    @classmethod
    def two_sheeted(
        cls, semi_axes: ArrayLike, rotation: ArrayLike | None = None, centre: ArrayLike = (0, 0, 0)
    ) -> Quadric:
        """Two-sheeted hyperboloid along its first axis."""
        return cls._from_semi_axes(semi_axes, (1, -1, -1), rotation, centre)

    @classmethod
    def _from_semi_axes(
        cls,
        semi_axes: ArrayLike,
        signs: tuple[int, int, int],
        rotation: ArrayLike | None,
        centre: ArrayLike,
    ) -> Quadric:
        lengths = np.asarray(semi_axes, dtype=np.float64)
        SEMI_AXES.check(tuple(lengths.tolist()), unit="")
        return cls(np.array(signs) / lengths**2, rotation, centre)

    @property
    def kind(self) -> str:
        """Plain name of the quadric."""
        positive, negative = (self.curvatures > 0).sum(), (self.curvatures < 0).sum()
        names = {3: "ellipsoid", 2: "one-sheeted hyperboloid", 1: "two-sheeted hyperboloid"}
        return names[positive] if positive + negative == 3 else "cylinder"

    @property
    def admissible(self) -> tuple[float, float]:
        """Smallest and largest t for which sqrt(t S + I) is real; the quadric is flat at both."""
        largest, smallest = self.curvatures.max(), self.curvatures.min()
        return float(-1.0 / largest), float(-1.0 / smallest) if smallest < 0 else float("inf")

    def to_frame(self, points: FloatArray) -> FloatArray:
        """(..., 3) coordinates along the axes, from the centre."""
        return np.asarray((points - self.centre) @ self.rotation)

    def from_frame(self, coordinates: FloatArray) -> FloatArray:
        """(..., 3) points from coordinates along the axes."""
        return np.asarray(coordinates @ self.rotation.T + self.centre)

    def value(self, points: FloatArray) -> FloatArray:
        """(...) the form (x - centre)^T S (x - centre); 1 on the quadric."""
        return np.asarray((self.to_frame(points) ** 2 * self.curvatures).sum(axis=-1))

    def distance(self, points: FloatArray) -> FloatArray:
        """(...) distance from the quadric to first order, in the model's unit."""
        gradient = 2 * np.linalg.norm(self.to_frame(points) * self.curvatures, axis=-1)
        return np.abs(self.value(points) - 1.0) / np.where(gradient > 0, gradient, 1.0)

    def factors(self, t: FloatArray) -> FloatArray:
        """(..., 3) square roots of 1 + t s along the axes.

        Raises:
            InputError: a t outside the admissible range.
        """
        squares = 1.0 + np.asarray(t, dtype=np.float64)[..., None] * self.curvatures
        squares = np.where(np.abs(squares) < _ROUNDING, 0.0, squares)
        if not (squares >= 0).all():
            low, high = self.admissible
            worst = np.asarray(t)[(squares < 0).any(axis=-1)].flat[0]
            raise InputError(
                f"t: expected {low:.6g} <= t <= {high:.6g} for this {self.kind}, got {worst:.6g}; "
                "narrow the range"
            )
        return np.sqrt(squares)

    def normalised(self, points: FloatArray) -> FloatArray:
        """Scale points near the quadric from its centre onto it, exactly.

        Raises:
            InputError: a point in a direction in which the quadric has none.
        """
        value = self.value(points)
        if not (value > 0).all():
            bad = int(np.argmin(value))
            raise InputError(
                f"curve: point {bad} cannot be brought onto the {self.kind} (the line from the "
                "centre misses it); keep the curve on one sheet and near the quadric"
            )
        return self.from_frame(self.to_frame(points) / np.sqrt(value)[..., None])

    def hits(self, origin: ArrayLike, direction: ArrayLike) -> FloatArray:
        """(k, 3) points where a line meets the quadric, k up to two, in the line's direction.

        Args:
            origin: (3,) a point of the line, in the model's unit.
            direction: (3,) its direction, any length.
        """
        start = self.to_frame(np.asarray(origin, dtype=np.float64))
        along = np.asarray(direction, dtype=np.float64) @ self.rotation
        # c + 2 b k + a k^2 = 0 for the places k on the line.
        a = float(self.curvatures @ along**2)
        b = float(self.curvatures @ (start * along))
        c = float(self.curvatures @ start**2) - 1.0
        root = b * b - a * c
        if root < 0 or (a == 0 and b == 0):
            return np.zeros((0, 3))
        # The sum that does not cancel, and the other place from the product of both.
        q = -(b + np.copysign(np.sqrt(root), b))
        places = [q / a] if a else []
        places += [c / q] if q else []
        return self.from_frame(start + np.sort(places)[:, None] * along)

    def project(self, points: ArrayLike) -> FloatArray:
        """(..., 3) nearest points of the quadric.

        The foot point p of x satisfies x = (I + t S) p; between the ends of the admissible range
        the equation for t is monotone, so bisection finds its one root. A point in a symmetry
        plane that has two feet gets one of them.
        """
        frame = self.to_frame(np.asarray(points, dtype=np.float64))
        # A point exactly in a symmetry plane may have its feet outside it: leave by a hair.
        hair = 1e-12 / np.sqrt(np.abs(self.curvatures).max())
        frame = np.where(frame == 0.0, hair * (self.curvatures != 0), frame)
        s = self.curvatures
        low, high = self.admissible
        reach = np.linalg.norm(frame, axis=-1) / np.sqrt(s.max()) + abs(low)
        lower = np.full(frame.shape[:-1], low)
        upper = np.minimum(
            np.full(frame.shape[:-1], high), low + 4 * reach + 4 * reach**2 * s.max()
        )
        for _ in range(_BISECTIONS):
            middle = 0.5 * (lower + upper)
            foot = frame / (1.0 + middle[..., None] * s)
            outside = (foot**2 * s).sum(axis=-1) > 1.0
            lower, upper = np.where(outside, middle, lower), np.where(outside, upper, middle)
        foot = frame / (1.0 + upper[..., None] * s)
        return self.normalised(self.from_frame(foot))


def _numbers(name: str, given: ArrayLike, shape: tuple[int, ...]) -> FloatArray:
    """A copy in numbers of this shape."""
    value = np.array(given, dtype=np.float64)
    if value.shape != shape or not np.isfinite(value).all():
        raise InputError(
            f"quadric: expected {name} of shape {shape} with finite numbers, got {value.tolist()}"
        )
    return value
