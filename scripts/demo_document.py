"""The demo's model as a FreeCAD document, and pictures of it."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
import Mesh
import numpy as np
import Part
from pivy import coin
from PySide import QtCore, QtGui

from freecad_ortho import api, convert
from freecad_ortho.step_faces import is_step
from freecad_ortho.triangles import read_triangles
from freecad_ortho.units import millimetres_per
from freecad_ortho.view.colour_scale import ColourScale
from solver.analysis.fields import field
from solver.errors import OrthoError
from solver.mesh.quadmesh import FloatArray

# Twice the size of the preview, so that scaling down smooths the edges.
WIDTH, HEIGHT = 3200, 2000
# Where the camera stands, seen from the middle of the model.
CAMERA = (0.7, -1.0, 0.72)
# Height of the view, a long lens, and the part of the sheet that the model fills.
OPENING = 0.45
MARGIN = 0.9
# The part of the roof that is shown with its panels on; the rest shows the beams.
CLAD = 0.6


def draw_and_end(draw: Callable[[], None]) -> None:
    """Draw once FreeCAD's window stands, then end FreeCAD whatever happens."""

    def drawn() -> None:
        try:
            draw()
        finally:
            for name in list(FreeCAD.listDocuments()):
                FreeCAD.closeDocument(name)
            QtGui.QApplication.quit()

    QtCore.QTimer.singleShot(500, drawn)


def build(order: dict[str, Any]) -> dict[str, Any]:
    """Make the document's objects and save it."""
    document = FreeCAD.newDocument("Demo")
    drawn, drawn_points = as_drawn(order, document)
    net = api.import_net(order["net"], document, unit=order["unit"])
    net.Label = "Principal mesh"
    sizes = {"height": order["height"], "thickness": order["thickness"]}
    # Along the border of a surface panels have nothing to lie on without it.
    edge = [api.add_edge_beam(net, **sizes)] if order["is_surface"] else []
    beams = api.add_beams(net, **sizes)
    panels = api.add_panels(net, order["panel_thickness"], gap=order["gap"], beams=beams)
    document.recompute()
    for feature in (drawn, net):
        feature.ViewObject.Visibility = False
    view = FreeCADGui.getDocument(document.Name).ActiveView
    aim(view, np.concatenate([drawn_points, convert.array(net.Vertices)]))
    document.saveAs(order["model"])
    bars = [beams, *edge]
    return {"view": view, "drawn": drawn, "net": net, "bars": bars, "panels": panels}


def as_drawn(
    order: dict[str, Any], document: FreeCAD.Document
) -> tuple[FreeCAD.DocumentObject, FloatArray]:
    """What the demo began with, as an object, and points (N, 3) all over it, in mm."""
    path, unit = order["source"], order["unit"]
    if not order["is_surface"]:
        mesh = api.import_net(path, document, unit=unit)
        mesh.Label = "As drawn"
        return mesh, convert.array(mesh.Vertices)
    points, triangles, _ = read_triangles(path)
    if is_step(path):
        surface = document.addObject("Part::Feature", "Surface")
        surface.Shape = Part.read(path)
    else:
        points = points * millimetres_per(unit)
        surface = document.addObject("Mesh::Feature", "Surface")
        surface.Mesh = Mesh.Mesh(points[triangles].reshape(-1, 3).tolist())
    surface.Label = "Design surface"
    return surface, points


def aim(view: Any, points: FloatArray) -> None:
    """Look at points, (N, 3), from the corner, as near as the picture's border lets us."""
    view.setCameraType("Perspective")
    back = np.array(CAMERA) / np.linalg.norm(CAMERA)
    right = np.cross([0.0, 0.0, 1.0], back)
    right /= np.linalg.norm(right)
    frame = np.array([right, np.cross(back, right), back])
    seen = points @ frame.T
    slopes = MARGIN * np.tan(OPENING / 2) * np.array([WIDTH / HEIGHT, 1.0])
    # A point at (x, z) is inside the border where |x - centre| <= slope * (distance - z).
    most = (seen[:, :2] + slopes * seen[:, 2:]).max(axis=0)
    least = (seen[:, :2] - slopes * seen[:, 2:]).min(axis=0)
    distance = ((most - least) / (2 * slopes)).max()
    position = np.array([*(most + least) / 2, distance]) @ frame
    camera = view.getCameraNode()
    rows = (float(x) for row in frame for x in (*row, 0.0))
    camera.orientation.setValue(coin.SbRotation(coin.SbMatrix(*rows, 0, 0, 0, 1)))
    camera.position.setValue(*map(float, position))
    camera.heightAngle = OPENING
    depths = distance - seen[:, 2]
    camera.nearDistance = float(depths.min() / 2)
    camera.farDistance = float(depths.max() * 2)
    camera.focalDistance = float(depths.mean())


def light(view: Any) -> None:
    """Add a light from above: FreeCAD's own comes from the camera and leaves the far side dark."""
    sun = coin.SoDirectionalLight()
    sun.direction = (-0.35, 0.3, -0.9)
    sun.intensity = 0.25
    view.getSceneGraph().insertChild(sun, 0)


def picture(view: Any, path: str) -> None:
    """Save what is visible."""
    FreeCADGui.updateGui()
    view.saveImage(path, WIDTH, HEIGHT, "White")
    if not Path(path).exists():
        raise OrthoError("FreeCAD rendered no picture; does OpenGL work here?")


def picture_before(model: dict[str, Any], path: str, decades: tuple[int, int]) -> None:
    """Show the surface, or the mesh coloured by planarity, as it was drawn."""
    drawn = model["drawn"]
    for feature in (*model["bars"], model["panels"]):
        feature.ViewObject.Visibility = False
    if hasattr(drawn, "ColourMap"):
        drawn.ColourMap = "Planarity"
        drawn.ViewObject.LowestDecade, drawn.ViewObject.HighestDecade = decades
        drawn.ViewObject.Legend = drawn.ViewObject.Upside = False
    drawn.ViewObject.LineWidth = 3.0
    drawn.ViewObject.Visibility = True
    picture(model["view"], path)
    drawn.ViewObject.Visibility = False


def picture_after(model: dict[str, Any], path: str, decades: tuple[int, int]) -> None:
    """Show the beams, and the panels on the left part of the roof coloured by planarity."""
    mesh = convert.quad_mesh(model["net"])
    middles = mesh.vertices[mesh.faces].mean(axis=1)
    right = np.cross([0.0, 0.0, 1.0], CAMERA)
    across = middles @ right
    clad = across <= np.quantile(across, CLAD)
    # A panel is called after its face; at the border of a surface there may be none, or two.
    panels = model["panels"]
    faces = [int(re.sub(r"\D", "", name)) for name in panels.PartNames]
    pairs = zip(faces, panels.Shape.Solids, strict=True)
    shown_ones = [(face, solid) for face, solid in pairs if clad[face]]
    shades = ColourScale.of_decades(*decades).colours(field(mesh, "Planarity"))
    shown = panels.Document.addObject("Part::Feature", "Shown")
    shown.Shape = Part.makeCompound([solid for _, solid in shown_ones])
    # Six faces or more a panel, one colour each.
    shown.ViewObject.DiffuseColor = [
        (*map(float, shades[face]), 0.0) for face, solid in shown_ones for _ in solid.Faces
    ]
    shown.ViewObject.LineColor = (0.12, 0.18, 0.32)
    shown.ViewObject.LineWidth = 1.0
    shown.ViewObject.PointSize = 1.0
    panels.ViewObject.Visibility = False
    for bar in model["bars"]:
        bar.ViewObject.Visibility = True
    picture(model["view"], path)


def run(order: dict[str, Any]) -> None:
    """Write the model and the pictures that the order names."""
    model = build(order)
    light(model["view"])
    decades = tuple(order["decades"])
    picture_before(model, order["pictures"]["before"], decades)
    picture_after(model, order["pictures"]["after"], decades)
