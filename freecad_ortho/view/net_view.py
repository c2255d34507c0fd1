"""View provider of a net: its quads and edges in Coin nodes, coloured by a measure."""

from __future__ import annotations

from typing import Any

import FreeCAD
import numpy as np
from pivy import coin

from freecad_ortho import convert
from freecad_ortho.objects.properties import Property, Stateless, ensure
from freecad_ortho.resources import icon
from freecad_ortho.view import colours
from freecad_ortho.view.legend import Legend
from solver.analysis import measures
from solver.mesh.connectivity import Connectivity
from solver.mesh.quadmesh import FloatArray, QuadMesh

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

_FLAT_LINES, _SHADED, _WIREFRAME = "Flat Lines", "Shaded", "Wireframe"

_PROPERTIES = (
    Property(
        "App::PropertyColor",
        "FaceColor",
        "Net",
        QT_TRANSLATE_NOOP("App::Property", "Colour of the faces where no colour map is shown"),
        default=(0.80, 0.84, 0.88),
    ),
    Property(
        "App::PropertyColor",
        "LineColor",
        "Net",
        QT_TRANSLATE_NOOP("App::Property", "Colour of the edges"),
        default=(0.15, 0.17, 0.20),
    ),
    Property(
        "App::PropertyFloat",
        "LineWidth",
        "Net",
        QT_TRANSLATE_NOOP("App::Property", "Width of the edges in pixels"),
        default=1.5,
    ),
    Property(
        "App::PropertyInteger",
        "LowestDecade",
        "Colour map",
        QT_TRANSLATE_NOOP("App::Property", "Blue at and below 10 to this power"),
        default=-6,
    ),
    Property(
        "App::PropertyInteger",
        "HighestDecade",
        "Colour map",
        QT_TRANSLATE_NOOP("App::Property", "Red at and above 10 to this power"),
        default=-1,
    ),
    Property(
        "App::PropertyBool",
        "Legend",
        "Colour map",
        QT_TRANSLATE_NOOP("App::Property", "Show the colour scale in the 3D view"),
        default=True,
    ),
)


class NetView(Stateless):
    """Proxy of a net's view provider; holds Coin nodes and nothing that would need saving."""

    def __init__(self, view_object: Any) -> None:
        ensure(view_object, _PROPERTIES)
        view_object.Proxy = self
        # A selected net keeps the colours of its faces; a frame says that it is selected.
        view_object.SelectionStyle = "BoundBox"

    def attach(self, view_object: Any) -> None:
        """Build the nodes; FreeCAD calls this on creation and when a document opens."""
        ensure(view_object, _PROPERTIES)
        self.ViewObject = view_object
        self.Object = view_object.Object
        self._mesh: QuadMesh | None = None
        self._build_nodes()
        view_object.addDisplayMode(self._mode(self._faces, self._edges), _FLAT_LINES)
        view_object.addDisplayMode(self._mode(self._faces), _SHADED)
        view_object.addDisplayMode(self._mode(self._edges), _WIREFRAME)
        self._read_style()
        self._read_faces()

    def getDisplayModes(self, view_object: Any) -> list[str]:
        """Name the display modes."""
        return [_FLAT_LINES, _SHADED, _WIREFRAME]

    def getDefaultDisplayMode(self) -> str:
        """Faces with edges."""
        return _FLAT_LINES

    def setDisplayMode(self, mode: str) -> str:
        """Show the mode of that name."""
        return mode

    def getIcon(self) -> str:
        """Icon in the tree."""
        return icon("net")

    def updateData(self, feature: Any, name: str) -> None:
        """Follow a property of the net."""
        if not hasattr(self, "_mesh"):
            return
        if name == "Faces":
            self._read_faces()
        elif name == "Vertices" and self._mesh is not None:
            points = convert.array(feature.Vertices)
            if len(points) == len(self._mesh.vertices):
                self.show_vertices(points)
            else:
                self._read_faces()
        elif name == "ColourMap":
            self._colour()

    def onChanged(self, view_object: Any, name: str) -> None:
        """Follow a property of the view provider."""
        if not hasattr(self, "_mesh"):
            return
        if name in ("FaceColor", "LineColor", "LineWidth"):
            self._read_style()
        if name in ("FaceColor", "LowestDecade", "HighestDecade", "Legend", "Visibility"):
            self._colour()

    def show_vertices(self, points: FloatArray) -> None:
        """Show the net with other positions, (V, 3) in mm, without touching the net itself."""
        if self._mesh is None:
            return
        self._mesh = self._mesh.with_vertices(points)
        self._coordinates.point.setValues(0, len(points), points)
        self._colour()

    def show_stored(self) -> None:
        """Show the positions that the net has."""
        self.show_vertices(convert.array(self.Object.Vertices))

    def _build_nodes(self) -> None:
        self._coordinates = coin.SoCoordinate3()
        self._material = coin.SoMaterial()
        binding = coin.SoMaterialBinding()
        binding.value = coin.SoMaterialBinding.PER_FACE
        self._face_set = coin.SoIndexedFaceSet()
        self._line_colour = coin.SoBaseColor()
        self._line_style = coin.SoDrawStyle()
        self._line_set = coin.SoIndexedLineSet()
        self._legend = Legend()
        hints = coin.SoShapeHints()
        hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        hints.faceType = coin.SoShapeHints.CONVEX
        hints.creaseAngle = 0.0
        push_back = coin.SoPolygonOffset()
        # Light from the camera would darken the colours that the scale explains.
        unlit = coin.SoLightModel()
        unlit.model = coin.SoLightModel.BASE_COLOR
        self._faces = coin.SoSeparator()
        for node in (unlit, hints, self._material, binding, push_back, self._face_set):
            self._faces.addChild(node)
        self._edges = coin.SoSeparator()
        for node in (unlit, self._line_colour, self._line_style, self._line_set):
            self._edges.addChild(node)

    def _mode(self, *shapes: Any) -> coin.SoGroup:
        group = coin.SoGroup()
        group.addChild(self._coordinates)
        for shape in shapes:
            group.addChild(shape)
        if self._faces in shapes:
            group.addChild(self._legend.root)
        return group

    def _read_style(self) -> None:
        view = self.ViewObject
        self._line_colour.rgb = tuple(view.LineColor[:3])
        self._line_style.lineWidth = view.LineWidth

    def _read_faces(self) -> None:
        """Fill the nodes anew; an incomplete net (while it is being read) shows nothing."""
        faces = np.array(self.Object.Faces, dtype=np.int64)
        points = convert.array(self.Object.Vertices)
        self._mesh = None
        for shape in (self._face_set, self._line_set):
            shape.coordIndex.deleteValues(0)
        if len(faces) == 0 or len(faces) % 4 or faces.max() >= len(points):
            self._legend.hide()
            return
        connectivity = Connectivity(faces.reshape(-1, 4), len(points))
        self._mesh = QuadMesh(points, connectivity)
        self._coordinates.point.deleteValues(0)
        self._coordinates.point.setValues(0, len(points), points)
        _set_indices(self._face_set, connectivity.faces)
        _set_indices(self._line_set, connectivity.edges)
        self._colour()

    def _colour(self) -> None:
        view = self.ViewObject
        self._legend.hide()
        if self._mesh is None:
            return
        name = self.Object.ColourMap
        measure = _MEASURES.get(name)
        shades = np.tile(view.FaceColor[:3], (len(self._mesh.faces), 1))
        if measure is not None:
            values = measure(self._mesh)
            shades = colours.colours(values, view.LowestDecade, view.HighestDecade)
            if view.Legend:
                title = FreeCAD.Qt.translate("Ortho", name)
                note = f"max {values.max():.1e}"
                self._legend.show(title, note, view.LowestDecade, view.HighestDecade)
        shades = shades * colours.shading(self._mesh.face_normals)[:, None]
        self._material.diffuseColor.setValues(0, len(shades), shades)


_MEASURES = {
    "Planarity": measures.planarity,
    "Orthogonality": measures.orthogonality,
}


def _set_indices(shape: Any, rows: Any) -> None:
    """Write (N, k) vertex numbers into an indexed shape, each row closed by -1."""
    ends = np.full((len(rows), 1), -1)
    indices = np.hstack([rows, ends]).ravel().astype(np.int32)
    shape.coordIndex.setValues(0, len(indices), indices)
