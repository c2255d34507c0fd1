"""A net, and what it stands on, shown in a 3D view before it is an object of the document."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import FreeCAD
import numpy as np
from pivy import coin

from freecad_ortho.view import colours, scene
from freecad_ortho.view.overlay_shapes import Points, Shape
from freecad_ortho.view.overlays import shape_node
from solver.mesh.quadmesh import QuadMesh

_FACES = (0.55, 0.74, 0.90)
_LINES = (0.10, 0.22, 0.36)
_GROUND = (0.94, 0.80, 0.55)
# Part of the depth of the scene by which points come before the net.
_POINTS = 0.01


class Preview:
    """Nodes of our own at the root of a view's scene; the document knows nothing of them.

    Args:
        view: the 3D view.
        stands: where the coordinates of what is shown stand in it.
    """

    def __init__(self, view: Any, stands: FreeCAD.Placement) -> None:
        self._scene = view.getSceneGraph()
        self.root = coin.SoSeparator()
        self.root.addChild(scene.standing(stands))
        self._net = _Sheet(_FACES, _LINES, 0.0)
        self._ground = _Sheet(_GROUND, (0.75, 0.60, 0.35), 0.75)
        for sheet in (self._net, self._ground):
            self.root.addChild(sheet.root)
        self._marks = coin.SoSeparator()
        self.root.addChild(self._marks)
        self._scene.addChild(self.root)

    def show(self, mesh: QuadMesh | None) -> None:
        """Show a net, in mm, in place of the last one."""
        self._net.show(mesh)

    def show_ground(self, mesh: QuadMesh | None) -> None:
        """Show through what the net is drawn on."""
        self._ground.show(mesh)

    def show_marks(self, shapes: Sequence[Shape]) -> None:
        """Show lines and points on the net, in mm, in place of the last ones."""
        self._marks.removeAllChildren()
        for shape in shapes:
            # A point is as large as it is drawn, and half of it would lie below the net.
            depth = scene.nearer(_POINTS) if isinstance(shape, Points) else scene.nearer()
            mark = coin.SoSeparator()
            for child in (scene.unpickable(), depth, shape_node(shape)):
                mark.addChild(child)
            self._marks.addChild(mark)

    def remove(self) -> None:
        """Take everything out of the view; doing it again changes nothing."""
        if self._scene.findChild(self.root) >= 0:
            self._scene.removeChild(self.root)


class _Sheet:
    """Faces and edges of a mesh."""

    def __init__(self, faces: Any, lines: Any, transparency: float) -> None:
        self.root = coin.SoSeparator()
        self._colour = faces
        self._points = coin.SoCoordinate3()
        self._material = coin.SoMaterial()
        self._material.transparency = transparency
        self._faces, self._edges = coin.SoIndexedFaceSet(), coin.SoIndexedLineSet()
        hints = coin.SoShapeHints()
        hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        binding = coin.SoMaterialBinding()
        binding.value = coin.SoMaterialBinding.PER_FACE
        style, edge_colour = coin.SoDrawStyle(), coin.SoMaterial()
        style.lineWidth = 1.5 if transparency == 0 else 1.0
        edge_colour.diffuseColor = lines
        edge_colour.transparency = transparency
        shape = coin.SoSeparator()
        for child in (hints, self._material, binding, coin.SoPolygonOffset(), self._faces):
            shape.addChild(child)
        whole = coin.SoMaterialBinding()
        whole.value = coin.SoMaterialBinding.OVERALL
        for child in (
            scene.unpickable(), scene.unlit(), self._points, shape, edge_colour, whole, style,
        ):  # fmt: skip
            self.root.addChild(child)
        self.root.addChild(self._edges)

    def show(self, mesh: QuadMesh | None) -> None:
        for shape in (self._faces, self._edges):
            shape.coordIndex.deleteValues(0)
        if mesh is None:
            return
        self._points.point.deleteValues(0)
        self._points.point.setValues(0, len(mesh.vertices), mesh.vertices.tolist())
        shades = np.array(self._colour) * colours.shading(mesh.face_normals)[:, None]
        self._material.diffuseColor.deleteValues(0)
        self._material.diffuseColor.setValues(0, len(shades), shades.tolist())
        for shape, rows in ((self._faces, mesh.faces), (self._edges, mesh.connectivity.edges)):
            ends = np.full((len(rows), 1), -1)
            indices = np.hstack([rows, ends]).ravel().astype(np.int32)
            shape.coordIndex.setValues(0, len(indices), indices.tolist())
