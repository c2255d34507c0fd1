"""Marks on the face, edge or vertex that somebody asked to see."""

from __future__ import annotations

from typing import Any

from freecad_ortho.view.handles import CHOSEN, Handles
from solver.mesh.quadmesh import FloatArray


class PlaceMarks:
    """Markers at a few points of a 3D view, drawn over everything else.

    Args:
        view: the 3D view.
    """

    def __init__(self, view: Any) -> None:
        self._scene = view.getSceneGraph()
        self._handles = Handles()
        self._scene.addChild(self._handles.root)

    def show(self, points: FloatArray) -> None:
        """Mark the (N, 3) points, in mm, and nothing else."""
        self._handles.show(points, [CHOSEN] * len(points))

    def remove(self) -> None:
        """Take the marks out of the view; doing it again changes nothing."""
        if self._scene.findChild(self._handles.root) >= 0:
            self._scene.removeChild(self._handles.root)
