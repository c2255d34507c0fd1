"""Between the model and the pixels of a 3D view: what is under the mouse, where it aims."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import FreeCADGui
import numpy as np
from pivy import coin

from solver.mesh.quadmesh import FloatArray

# Of vertices under the mouse, those further behind than this part of the scene are hidden.
_BEHIND = 0.02
# Pixels between vertices that are seen in the same place.
_SAME_PLACE = 3.0


@dataclass(frozen=True)
class Ray:
    """A half line into the scene, (3,) each; the direction is a unit vector."""

    origin: FloatArray
    direction: FloatArray


@dataclass(frozen=True)
class Screen:
    """How a view shows the model at one moment.

    Attributes:
        matrix: (4, 4), a row (x, y, z, 1) times it gives what the screen shows, from -1 to 1.
        size: width and height in pixels; pixels count from the lower left corner.
    """

    matrix: FloatArray
    size: tuple[int, int]

    @classmethod
    def of_event(cls, callback: Any) -> Screen:
        """The view in which the event of a SoEventCallback happened.

        Points are in the coordinates of what is drawn beside that node: those of the parts that
        contain it are followed.
        """
        action = callback.getAction()
        # An event on its way through the scene knows the camera but no transformations.
        model = coin.SoGetMatrixAction(action.getViewportRegion())
        model.apply(action.getCurPath())
        volume = coin.SoViewVolumeElement.get(action.getState())
        region = _pair(action.getViewportRegion().getViewportSizePixels())
        matrices = (model.getMatrix().getValue(), volume.getMatrix().getValue())
        seen = np.array(matrices[0]) @ np.array(matrices[1])
        return cls(seen, (int(region[0]), int(region[1])))

    def pixels(self, points: FloatArray) -> tuple[FloatArray, FloatArray]:
        """(N, 2) pixels and (N,) depths (small is near) of (N, 3) points.

        Points behind the camera are infinitely far away.
        """
        ones = np.ones((len(points), 1))
        seen = np.hstack([points, ones]) @ self.matrix
        ahead = seen[:, 3] > 0
        flat = seen[:, :3] / np.where(ahead, seen[:, 3], 1.0)[:, None]
        places = 0.5 * (flat[:, :2] + 1.0) * np.array(self.size)
        places[~ahead] = np.inf
        return places, flat[:, 2]

    def ray(self, pixel: FloatArray) -> Ray:
        """The half line of all points that lie under a pixel, from the near end of the view."""
        x, y = 2.0 * np.asarray(pixel, dtype=np.float64) / np.array(self.size) - 1.0
        ends = np.array([[x, y, -1.0, 1.0], [x, y, 1.0, 1.0]]) @ np.linalg.inv(self.matrix)
        near, far = ends[:, :3] / ends[:, 3:]
        way = far - near
        return Ray(near, way / np.linalg.norm(way))

    def vertex_at(self, pixel: FloatArray, points: FloatArray, reach: float) -> int | None:
        """Number of the nearest vertex within ``reach`` pixels, or of the one that hides it."""
        places, depths = self.pixels(points)
        distance = np.linalg.norm(places - np.asarray(pixel), axis=1)
        near = np.flatnonzero(distance <= reach)
        if not len(near):
            return None
        # What hides a vertex lies before it in the same place; neighbours of one that is seen at a
        # flat angle lie before it too, but beside it.
        best = places[near[np.argmin(distance[near])]]
        near = near[np.linalg.norm(places[near] - best, axis=1) <= _SAME_PLACE]
        spread = np.ptp(depths[np.isfinite(places[:, 0])])
        front = near[depths[near] <= depths[near].min() + _BEHIND * spread]
        return int(front[np.argmin(distance[front])])

    def vertices_in(self, one: FloatArray, other: FloatArray, points: FloatArray) -> list[int]:
        """Numbers of the vertices in the rectangle between two pixels, hidden ones too."""
        places, _ = self.pixels(points)
        low, high = np.minimum(one, other), np.maximum(one, other)
        return np.flatnonzero(((places >= low) & (places <= high)).all(axis=1)).tolist()


def mouse_of(callback: Any) -> FloatArray:
    """(2,) pixel at which the event of a SoEventCallback happened."""
    return _pair(callback.getEvent().getPosition(callback.getAction().getViewportRegion()))


def views(document: str) -> list[Any]:
    """The 3D views of the document with that name."""
    found: list[Any] = FreeCADGui.getDocument(document).mdiViewsOfType("Gui::View3DInventor")
    return found


def redraw() -> None:
    """Have changed 3D views drawn before the next timer goes off.

    Left to itself Coin tells FreeCAD of changes when nothing else is to do.
    """
    coin.SoDB.getSensorManager().processDelayQueue(True)


def _pair(pair: Any) -> FloatArray:
    """Make an array (2,) of a SbVec2s, whose ``getValue`` newer Coin bindings cannot unpack."""
    return np.array([pair[0], pair[1]], dtype=np.float64)
