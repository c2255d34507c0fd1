"""Between points in space and places on the screen, as a 3D view shows them."""

from __future__ import annotations

from typing import Any

import numpy as np

from freecad_ortho.view.pixel_pair import pixel_pair
from solver.mesh.quadmesh import FloatArray


class Lens:
    """The projection of a view in a viewport.

    Args:
        view: the 3D view.
        viewport: Coin's viewport region.
    """

    def __init__(self, view: Any, viewport: Any) -> None:
        aspect = viewport.getViewportAspectRatio()
        volume = view.getCameraNode().getViewVolume(aspect)
        if aspect < 1.0:
            # As Coin does it itself: an upright window shows more, not less.
            volume.scale(1.0 / aspect)
        # Row vectors: points times this matrix.
        self._matrix = np.array(volume.getMatrix().getValue(), dtype=np.float64)
        self._size = pixel_pair(viewport.getViewportSizePixels())

    def pixels(self, points: FloatArray) -> FloatArray:
        """(n, 2) places in pixels from the lower left, of (n, 3) points in mm."""
        rows = np.asarray(points, dtype=np.float64).reshape(-1, 3)
        image = np.column_stack([rows, np.ones(len(rows))]) @ self._matrix
        return 0.5 * (image[:, :2] / image[:, 3:] + 1.0) * self._size

    def ray(self, pixel: FloatArray) -> tuple[FloatArray, FloatArray]:
        """(3,) point in front and (3,) unit direction of what a place on the screen shows."""
        place = 2.0 * np.asarray(pixel, dtype=np.float64) / self._size - 1.0
        ends = np.array([[*place, -1.0, 1.0], [*place, 1.0, 1.0]]) @ np.linalg.inv(self._matrix)
        near, far = ends[:, :3] / ends[:, 3:]
        return near, (far - near) / np.linalg.norm(far - near)
