"""Coin nodes of the handles: one marker set for all, drawn over everything else."""

from __future__ import annotations

from collections.abc import Sequence

import FreeCADGui
import numpy as np
from pivy import coin

from freecad_ortho.view import scene
from solver.mesh.quadmesh import FloatArray

_SIZE = 9
HANDLE, CHOSEN, HOVERED, HELD = 0, 1, 2, 3
_COLOURS = np.array([(0.95, 0.60, 0.10), (0.85, 0.10, 0.12), (1.0, 0.95, 0.45), (0.20, 0.45, 0.85)])
_PULL = (0.85, 0.10, 0.12)


class Handles:
    """Markers on vertices, lines from vertices to where they are drawn, and a frame.

    Attributes:
        root: node to add to a scene; nothing in it can be picked by FreeCAD.
    """

    def __init__(self) -> None:
        self.root = coin.SoAnnotation()
        self._marker_points, self._markers = coin.SoCoordinate3(), coin.SoMarkerSet()
        self._markers.markerIndex = FreeCADGui.getMarkerIndex("CIRCLE_FILLED", _SIZE)
        self._markers.numPoints = 0
        self._colours = coin.SoMaterial()
        binding = coin.SoMaterialBinding()
        binding.value = coin.SoMaterialBinding.PER_VERTEX
        self._line_points, self._lines = coin.SoCoordinate3(), coin.SoLineSet()
        for child in (scene.unpickable(), scene.unlit(), self._pulls(), self._frame()):
            self.root.addChild(child)
        for child in (self._colours, binding, self._marker_points, self._markers):
            self.root.addChild(child)

    def show(self, points: FloatArray, kinds: Sequence[int]) -> None:
        """Put a marker at each of the (N, 3) points, coloured by its kind."""
        self._markers.numPoints = 0
        if len(points):
            self._marker_points.point.setNum(len(points))
            self._marker_points.point.setValues(0, len(points), points)
            shades = _COLOURS[list(kinds)]
            self._colours.diffuseColor.setNum(len(shades))
            self._colours.diffuseColor.setValues(0, len(shades), shades)
        self._markers.numPoints = len(points)

    def show_lines(self, starts: FloatArray, ends: FloatArray) -> None:
        """Draw a line from each start to its end, (N, 3) both."""
        self._lines.numVertices.deleteValues(0)
        if len(starts):
            points = np.stack([starts, ends], axis=1).reshape(-1, 3)
            self._line_points.point.setNum(len(points))
            self._line_points.point.setValues(0, len(points), points)
            self._lines.numVertices.setValues(0, len(starts), [2] * len(starts))

    def show_frame(self, one: FloatArray, other: FloatArray) -> None:
        """Draw a rectangle between two corners of the window, from -1 to 1."""
        (a, b), (c, d) = one, other
        corners = [(a, b, 0), (c, b, 0), (c, d, 0), (a, d, 0), (a, b, 0)]
        self._frame_points.point.setValues(0, len(corners), corners)
        self._frame_switch.whichChild = coin.SO_SWITCH_ALL

    def hide_frame(self) -> None:
        """Show no rectangle."""
        self._frame_switch.whichChild = coin.SO_SWITCH_NONE

    def _pulls(self) -> coin.SoSeparator:
        colour = coin.SoBaseColor()
        colour.rgb = _PULL
        style = coin.SoDrawStyle()
        style.lineWidth = 2.0
        self._lines.numVertices.deleteValues(0)
        separator = coin.SoSeparator()
        for child in (colour, style, self._line_points, self._lines):
            separator.addChild(child)
        return separator

    def _frame(self) -> coin.SoSwitch:
        self._frame_switch, self._frame_points = coin.SoSwitch(), coin.SoCoordinate3()
        colour = coin.SoBaseColor()
        colour.rgb = (0.2, 0.45, 0.85)
        separator = coin.SoSeparator()
        start = (coin.SoResetTransform(), scene.window_camera(), colour)
        for child in (*start, self._frame_points, coin.SoLineSet()):
            separator.addChild(child)
        skip = scene.left_out_of_fitting()
        skip.addChild(separator)
        self._frame_switch.addChild(skip)
        self.hide_frame()
        return self._frame_switch
