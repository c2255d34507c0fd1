"""Marks on the face, edge or vertex that somebody asked to see."""

from __future__ import annotations

from typing import Any

import FreeCAD
from pivy import coin

from freecad_ortho.view import scene
from freecad_ortho.view.handles import CHOSEN, Handles
from solver.mesh.quadmesh import FloatArray


class PlaceMarks:
    """Markers at a few points of a 3D view, drawn over everything else.

    Args:
        view: the 3D view.
        stands: where the coordinates of the points stand in it.
    """

    def __init__(self, view: Any, stands: FreeCAD.Placement) -> None:
        self._scene = view.getSceneGraph()
        self._handles = Handles()
        self._root = coin.SoSeparator()
        self._root.addChild(scene.standing(stands))
        self._root.addChild(self._handles.root)
        self._scene.addChild(self._root)

    def show(self, points: FloatArray) -> None:
        """Mark the (N, 3) points, in mm, and nothing else."""
        self._handles.show(points, [CHOSEN] * len(points))

    def remove(self) -> None:
        """Take the marks out of the view; doing it again changes nothing."""
        if self._scene.findChild(self._root) >= 0:
            self._scene.removeChild(self._root)
