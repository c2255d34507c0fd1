"""Coin nodes of a frame: coloured members, and thin lines where they are when they are moved."""

from __future__ import annotations

import numpy as np
from pivy import coin

from freecad_ortho.view import scene
from freecad_ortho.view.check_shapes import Drawn
from solver.mesh.local_origin import LocalOrigin
from solver.mesh.quadmesh import FloatArray

_THIN, _GREY = 1.0, (0.62, 0.65, 0.69)


class FrameLines:
    """Members as lines.

    Attributes:
        root: node to add to a scene.
    """

    def __init__(self) -> None:
        self.root = coin.SoSeparator()
        self._stand = coin.SoTranslation()
        self._points, self._material = coin.SoCoordinate3(), coin.SoMaterial()
        self._style, self._lines = coin.SoDrawStyle(), coin.SoIndexedLineSet()
        self._start, self._ghost_points = coin.SoSwitch(), coin.SoCoordinate3()
        self._ghost = coin.SoIndexedLineSet()
        self._near: FloatArray = np.zeros((0, 3))
        self._moved: FloatArray | None = None
        binding, colour, thin = coin.SoMaterialBinding(), coin.SoBaseColor(), coin.SoDrawStyle()
        binding.value = coin.SoMaterialBinding.PER_FACE
        colour.rgb, thin.lineWidth = _GREY, _THIN
        ghost = coin.SoSeparator()
        for child in (scene.unpickable(), colour, thin, self._ghost_points, self._ghost):
            ghost.addChild(child)
        self._start.addChild(ghost)
        own = (self._material, binding, self._style, self._points, self._lines)
        for child in (self._stand, scene.unlit(), self._start, *own):
            self.root.addChild(child)

    def show(self, drawn: Drawn | None, width: float) -> None:
        """Draw a frame, or nothing.

        Args:
            drawn: the frame.
            width: of its lines, pixels.
        """
        for lines in (self._lines, self._ghost):
            lines.coordIndex.deleteValues(0)
        self._start.whichChild = coin.SO_SWITCH_NONE
        if drawn is None:
            self._moved = None
            return
        # Coin's coordinates have seven digits: far from the origin they lie about a point nearby.
        origin = LocalOrigin.of(drawn.points)
        self._near, self._moved = origin.near(drawn.points), drawn.moved
        self._stand.translation = tuple(origin.shift.tolist())
        self._style.lineWidth = width
        self._material.diffuseColor.deleteValues(len(drawn.colours))
        self._material.diffuseColor.setValues(0, len(drawn.colours), drawn.colours)
        self.sway(1.0)
        scene.set_indices(self._lines, drawn.lines)
        if drawn.moved is not None:
            scene.set_points(self._ghost_points, self._near)
            scene.set_indices(self._ghost, drawn.lines)
            self._start.whichChild = coin.SO_SWITCH_ALL

    def sway(self, part: float) -> None:
        """Draw a part of the way that nodes move, from -1 to 1."""
        scene.set_points(
            self._points, self._near if self._moved is None else self._near + part * self._moved
        )
