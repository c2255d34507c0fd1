"""Coin nodes that several pictures begin with."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import FreeCAD
import numpy as np
from pivy import coin

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray

# Part of the depth of a scene: far above rounding, too little to be seen through anything.
_NEARER = 2e-5
_INK, _PAPER = "0.1 0.1 0.12", "1 1 1"


def unpickable() -> coin.SoPickStyle:
    """What follows is only shown and does not catch the mouse."""
    made = coin.SoPickStyle()
    made.style = coin.SoPickStyle.UNPICKABLE
    return made


def unlit() -> coin.SoLightModel:
    """What follows has its plain colours."""
    made = coin.SoLightModel()
    made.model = coin.SoLightModel.BASE_COLOR
    return made


def framed(words: str, size: int) -> Any:
    """Words on a light plate, which are read over whatever lies behind them.

    Args:
        words: one line.
        size: of the letters, pixels.
    """
    made = coin.SoType.fromName("SoFrameLabel").createInstance()
    made.set(f'string "{words}" name "Sans" size {size} textColor {_INK} backgroundColor {_PAPER}')
    return made


def nearer(by: float = _NEARER) -> coin.SoDepthBuffer:
    """What follows is seen where it lies in the same surface as something else.

    Args:
        by: part of the depth of the scene.
    """
    made = coin.SoDepthBuffer()
    made.range = (0.0, 1.0 - by)
    # What is drawn later in the same place is seen, as without this node.
    made.function = coin.SoDepthBuffer.LEQUAL
    return made


def heard(
    events: coin.SoEventCallback,
    pressed: Callable[[Any, Any], None],
    moved: Callable[[Any, Any], None],
    typed: Callable[[Any, Any], None],
) -> list[tuple[Any, Any]]:
    """Have a node call for buttons and moves of the mouse and for keys; give what takes it back."""
    kinds = (coin.SoMouseButtonEvent, coin.SoLocation2Event, coin.SoKeyboardEvent)
    return [
        (kind.getClassTypeId(), events.addEventCallback(kind.getClassTypeId(), method))
        for kind, method in zip(kinds, (pressed, moved, typed), strict=True)
    ]


def window_camera() -> coin.SoOrthographicCamera:
    """What follows has its corners of the window at -1 and +1, whatever the window's shape."""
    camera = coin.SoOrthographicCamera()
    camera.viewportMapping = coin.SoCamera.LEAVE_ALONE
    camera.aspectRatio = 1.0
    camera.height = 2.0
    camera.position = (0, 0, 1)
    camera.nearDistance, camera.farDistance = 0.5, 1.5
    return camera


def standing(place: FreeCAD.Placement) -> coin.SoTransform:
    """What follows is in coordinates that stand so in the scene."""
    made = coin.SoTransform()
    made.translation = tuple(place.Base)
    made.rotation = coin.SbRotation(*place.Rotation.Q)
    return made


def set_indices(shape: Any, rows: IntArray) -> None:
    """Write (N, k) numbers of points into an indexed shape, each row closed by -1."""
    ends = np.full((len(rows), 1), -1)
    indices = np.hstack([rows, ends]).ravel().astype(np.int32)
    shape.coordIndex.setValues(0, len(indices), indices)


def set_polygons(shape: Any, corners: IntArray, sizes: IntArray) -> None:
    """Write polygons, the (H,) numbers of their points in turn, (F,) how many each has."""
    indices = np.insert(corners, np.cumsum(sizes), -1).astype(np.int32)
    shape.coordIndex.setValues(0, len(indices), indices)


def set_points(coordinates: coin.SoCoordinate3, points: FloatArray) -> None:
    """Give coordinates (N, 3) and no others."""
    coordinates.point.deleteValues(len(points))
    if len(points):
        coordinates.point.setValues(0, len(points), points)


def left_out_of_fitting() -> coin.SoGroup:
    """A group whose children do not count when the view is fitted to all."""
    # FreeCAD's own kind of node, which pivy does not know by name.
    group = coin.SoType.fromName("SoSkipBoundingGroup").createInstance()
    group.getField("mode").set("EXCLUDE_BBOX")
    return group
