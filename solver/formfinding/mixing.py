"""Acceleration of a fixed-point iteration."""

from __future__ import annotations

import numpy as np

from solver.mesh.quadmesh import FloatArray

_MEMORY = 8


class Mixing:
    """Anderson's mixing of the last steps of x -> g(x).

    The next x is the combination of the last images g that would have the smallest step g - x if
    the iteration were affine. Plain iteration of a membrane creeps along its own surface, where
    little pulls; mixed, it arrives.

    Source: Anderson (1965), Iterative procedures for nonlinear integral equations.
    """

    def __init__(self) -> None:
        self._images: list[FloatArray] = []
        self._steps: list[FloatArray] = []

    def __call__(self, point: FloatArray, image: FloatArray) -> FloatArray:
        """Next point from the present one and its image, any shape."""
        step = (image - point).ravel()
        if self._steps and np.linalg.norm(step) > 10 * np.linalg.norm(self._steps[-1]):
            # The past misleads: start anew.
            self._images, self._steps = [], []
        self._images = [*self._images[-_MEMORY:], image.ravel()]
        self._steps = [*self._steps[-_MEMORY:], step]
        if len(self._steps) < 2:
            return image
        steps = np.stack(self._steps, axis=1)
        images = np.stack(self._images, axis=1)
        changes = np.diff(steps, axis=1)
        gram = changes.T @ changes
        gram += 1e-14 * np.trace(gram) * np.eye(len(gram))
        weights = np.linalg.solve(gram, changes.T @ step)
        return np.asarray(self._images[-1] - np.diff(images, axis=1) @ weights).reshape(image.shape)
