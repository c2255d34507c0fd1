"""View provider of a net: its quads and edges in Coin nodes, coloured by a measure."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui
import numpy as np
from pivy import coin

from freecad_ortho import answers, convert, preferences
from freecad_ortho.objects.constraints import reference_surface
from freecad_ortho.objects.net import colour_field
from freecad_ortho.objects.properties import Stateless, ensure
from freecad_ortho.resources import icon
from freecad_ortho.view import legends, scene
from freecad_ortho.view.colour_map import ColourRange, Painting, is_quick, painting, plain
from freecad_ortho.view.legend import Legend
from freecad_ortho.view.net_properties import PROPERTIES
from freecad_ortho.view.overlay_shapes import OVERLAYS
from freecad_ortho.view.overlays import Overlays
from freecad_ortho.view.reflection import ReflectionLines
from solver.errors import OrthoError
from solver.mesh.closest import TriangleSurface
from solver.mesh.connectivity import Connectivity
from solver.mesh.local_origin import LocalOrigin
from solver.mesh.quadmesh import FloatArray, QuadMesh

_FLAT_LINES, _SHADED, _WIREFRAME = "Flat Lines", "Shaded", "Wireframe"

# Properties of the view provider that change the colours.
_COLOURING = (
    "FaceColor",
    "LineColor",
    "LineWidth",
    "LowestDecade",
    "HighestDecade",
    "AutomaticRange",
    "LowestValue",
    "HighestValue",
    "Legend",
    "ReflectionLines",
    "Visibility",
)
_GAP = "Gap to reference"
# Edges that carry the colours are this much wider.
_COLOURED_LINES = 2.5


class NetView(Stateless):
    """Proxy of a net's view provider; holds Coin nodes and nothing that would need saving."""

    def __init__(self, view_object: Any) -> None:
        ensure(view_object, PROPERTIES)
        view_object.FaceColor = preferences.colour("NetColour")
        view_object.Proxy = self
        # A selected net keeps the colours of its faces; a frame says that it is selected.
        view_object.SelectionStyle = "BoundBox"

    def attach(self, view_object: Any) -> None:
        """Build the nodes; FreeCAD calls this on creation and when a document opens."""
        ensure(view_object, PROPERTIES)
        self.ViewObject = view_object
        self.Object = view_object.Object
        self._mesh: QuadMesh | None = None
        self._explanation: Painting | None = None
        self._build_scene()
        view_object.addDisplayMode(self._mode(self._faces, self._edges), _FLAT_LINES)
        view_object.addDisplayMode(self._mode(self._faces), _SHADED)
        view_object.addDisplayMode(self._mode(self._edges), _WIREFRAME)
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

    def doubleClicked(self, view_object: Any) -> bool:
        """Begin to edit the net."""
        feature = view_object.Object
        return bool(FreeCADGui.getDocument(feature.Document.Name).setEdit(feature.Name))

    def setEdit(self, view_object: Any, mode: int = 0) -> bool | None:
        """Open the panel for live editing; modes other than the default one are FreeCAD's."""
        if mode != 0:
            return None
        self._edit_panel = answers.ask("edit net", view_object)
        return self._edit_panel is not None

    def unsetEdit(self, view_object: Any, mode: int = 0) -> bool | None:
        """End live editing; doing it again changes nothing."""
        panel, self._edit_panel = getattr(self, "_edit_panel", None), None
        if panel is None:
            return None
        panel.end()
        return True

    def updateData(self, feature: Any, name: str) -> None:
        """Follow a property of the net."""
        if not hasattr(self, "_mesh"):
            return
        if name in ("Faces", "FaceSizes"):
            self._read_faces()
        elif name == "Vertices" and self._mesh is not None:
            points = convert.array(feature.Vertices)
            if len(points) == len(self._mesh.vertices):
                self.show_stored()
            else:
                self._read_faces()
        elif name in ("ColourMap", "NetType", "DiagonalNet", "CloseTo", "LastReport"):
            self._colour()

    def onChanged(self, view_object: Any, name: str) -> None:
        """Follow a property of the view provider."""
        if not hasattr(self, "_mesh"):
            return
        if name in _COLOURING:
            self._colour()
        if name in OVERLAYS or name == "Visibility":
            self._draw_overlays()

    def show_vertices(self, points: FloatArray) -> None:
        """Show the net with other positions, (V, 3) in mm, without touching the net itself."""
        if self._mesh is None:
            return
        near = self._origin.near(points)
        self._mesh = self._mesh.with_vertices(near)
        self._coordinates.point.setValues(0, len(near), near)
        if is_quick(colour_field(self.Object)):
            self._colour()
        self._draw_overlays(moving=True)

    def show_mesh(self, mesh: QuadMesh | None) -> None:
        """Show another mesh, in mm, without touching the net itself; None shows nothing."""
        self._mesh = None
        for shape in (self._face_set, self._line_set):
            shape.coordIndex.deleteValues(0)
        if mesh is not None:
            self._origin = LocalOrigin.of_mesh(mesh)
            self._mesh = self._origin.near_mesh(mesh)
            self._stand.translation = tuple(self._origin.shift.tolist())
            self._coordinates.point.deleteValues(0)
            self._coordinates.point.setValues(0, len(mesh.vertices), self._mesh.vertices)
            net = mesh.connectivity
            scene.set_polygons(self._face_set, net.half_edges[:, 0], net.face_sizes)
            # Larger faces may have recesses.
            kind = coin.SoShapeHints.UNKNOWN_FACE_TYPE if net.mixed else coin.SoShapeHints.CONVEX
            self._hints.faceType = kind
            scene.set_indices(self._line_set, mesh.connectivity.edges)
        self._colour()
        self._draw_overlays()

    def show_stored(self) -> None:
        """Show the mesh that the net has."""
        if self._mesh is None or not self._has_faces_of(self._mesh.connectivity):
            self._read_faces()
            return
        self.show_vertices(convert.array(self.Object.Vertices))
        self._colour()
        self._draw_overlays()

    def _has_faces_of(self, net: Connectivity) -> bool:
        """Whether the faces that the net has are these."""
        sizes = net.face_sizes.tolist() if net.mixed else []
        same = sizes == convert.sizes_of(self.Object)
        return same and net.half_edges[:, 0].tolist() == self.Object.Faces

    def _build_scene(self) -> None:
        # Coin's coordinates have seven digits: far from the origin they lie about a point nearby.
        self._stand = coin.SoTranslation()
        self._coordinates = coin.SoCoordinate3()
        self._material = coin.SoMaterial()
        self._face_binding = coin.SoMaterialBinding()
        self._face_set = coin.SoIndexedFaceSet()
        self._line_colour = coin.SoMaterial()
        self._line_binding = coin.SoMaterialBinding()
        self._line_style = coin.SoDrawStyle()
        self._line_set = coin.SoIndexedLineSet()
        self._legend = Legend()
        self._overlays = Overlays()
        self._reflection = ReflectionLines()
        self._hints = hints = coin.SoShapeHints()
        hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        hints.creaseAngle = 0.0
        push_back = coin.SoPolygonOffset()
        # Light from the camera would darken the colours that the scale explains.
        unlit = scene.unlit()
        self._faces = coin.SoSeparator()
        colours = (self._material, self._face_binding)
        for child in (unlit, hints, *colours, self._reflection.root, push_back, self._face_set):
            self._faces.addChild(child)
        self._edges = coin.SoSeparator()
        colours = (self._line_colour, self._line_binding)
        for child in (unlit, *colours, self._line_style, self._line_set):
            self._edges.addChild(child)

    def _mode(self, *shapes: Any) -> coin.SoSeparator:
        group = coin.SoSeparator()
        group.addChild(scene.nearer())
        group.addChild(self._stand)
        group.addChild(self._coordinates)
        for shape in shapes:
            group.addChild(shape)
        if self._faces in shapes:
            group.addChild(self._legend.root)
        group.addChild(self._overlays.root)
        return group

    def _read_faces(self) -> None:
        """Fill the nodes anew; an incomplete net (while it is being read) shows nothing."""
        self.show_mesh(convert.whole_mesh(self.Object))

    def explains(self) -> bool:
        """Tell whether the net is seen in colours that need a scale."""
        return self._explanation is not None and self.ViewObject.Visibility

    def show_legend(self, shown: bool, name: str = "") -> None:
        """Show the scale of the colours or not, with a name where there are other nets."""
        painted = self._explanation
        if painted is None or not shown:
            self._legend.hide()
            return
        title = FreeCAD.Qt.translate("Ortho", colour_field(self.Object))
        self._legend.show(f"{title}: {name}" if name else title, painted.note, painted.scale)

    def _colour(self) -> None:
        if self._mesh is None:
            self._explanation = None
            legends.changed(self.Object)
            return
        if self.ViewObject.ReflectionLines:
            self._reflection.show(self._mesh)
        else:
            self._reflection.hide()
        painted = self._painting(self._mesh)
        binding = coin.SoMaterialBinding
        self._face_binding.value = (
            binding.PER_VERTEX_INDEXED if painted.per_vertex else binding.PER_FACE
        )
        _set_colours(self._material, painted.faces)
        lines = painted.edges
        self._line_binding.value = binding.OVERALL if lines is None else binding.PER_FACE
        plain_line = np.array([self.ViewObject.LineColor[:3]])
        _set_colours(self._line_colour, plain_line if lines is None else lines)
        widening = 1.0 if lines is None else _COLOURED_LINES
        self._line_style.lineWidth = widening * self.ViewObject.LineWidth
        explained = painted.scale is not None and not self.ViewObject.ReflectionLines
        self._explanation = painted if explained and self.ViewObject.Legend else None
        legends.changed(self.Object)

    def _draw_overlays(self, moving: bool = False) -> None:
        view = self.ViewObject
        chosen = [name for name in OVERLAYS if getattr(view, name)] if view.Visibility else []
        try:
            self._overlays.show(self._mesh, chosen, moving)
        except OrthoError as error:
            FreeCAD.Console.PrintWarning(f"{self.Object.Label}: {error}\n")

    def _painting(self, mesh: QuadMesh) -> Painting:
        view = self.ViewObject
        name = colour_field(self.Object)
        if name == "None":
            return plain(mesh, view.FaceColor)
        decades = (view.LowestDecade, view.HighestDecade)
        chosen = ColourRange(view.AutomaticRange, view.LowestValue, view.HighestValue, decades)
        try:
            reference = reference_surface(self.Object, mesh) if name == _GAP else None
            if reference is not None and self._origin.far:
                near = self._origin.near(reference.vertices)
                reference = TriangleSurface(near, reference.triangles)
            return painting(mesh, name, chosen, view.FaceColor, reference)
        except OrthoError as error:
            # A view has no one to raise to: the net stays visible, and the reason is said.
            FreeCAD.Console.PrintWarning(f"{self.Object.Label}: {error}\n")
            return plain(mesh, view.FaceColor)


def _set_colours(material: Any, rows: FloatArray) -> None:
    material.diffuseColor.deleteValues(len(rows))
    material.diffuseColor.setValues(0, len(rows), rows)
