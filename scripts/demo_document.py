"""Run inside FreeCAD by demo.py: the model as a document, and pictures of it.

The order comes as JSON in the environment variable ORTHO_DEMO; the answer is the word ``done`` or
one line that says what went wrong, in the file that the order names.
"""

from __future__ import annotations

import json
import os
import traceback
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
import numpy as np
import Part
from pivy import coin

from freecad_ortho import api, convert
from freecad_ortho.view.colours import colours
from solver.analysis import measures
from solver.errors import OrthoError

# Twice the size of the preview, so that scaling down smooths the edges.
WIDTH, HEIGHT = 3200, 2000
# Where the camera stands, seen from the middle of the model.
CAMERA = (0.75, -1.0, 0.62)
# The part of the roof that is shown with its panels on; the rest shows the beams.
CLAD = 0.6


def build(order: dict[str, Any]) -> dict[str, Any]:
    """Make the document's objects and save it."""
    document = FreeCAD.newDocument("Demo")
    drawn = api.import_net(order["drawn"], document, unit=order["unit"])
    drawn.Label = "As drawn"
    net = api.import_net(order["principal"], document, unit=order["unit"])
    net.Label = "Principal mesh"
    beams = api.add_beams(net, height=order["height"], thickness=order["thickness"])
    panels = api.add_panels(net, thickness=order["thickness"], gap=order["gap"], beams=beams)
    document.recompute()
    for feature in (drawn, net):
        feature.ViewObject.Visibility = False
    view = FreeCADGui.getDocument(document.Name).ActiveView
    aim(view)
    document.saveAs(order["model"])
    return {"view": view, "drawn": drawn, "net": net, "beams": beams, "panels": panels}


def aim(view: Any) -> None:
    """Look at everything that is visible from the corner, with perspective."""
    view.setCameraType("Perspective")
    camera = view.getCameraNode()
    back = np.array(CAMERA) / np.linalg.norm(CAMERA)
    right = np.cross([0.0, 0.0, 1.0], back)
    right /= np.linalg.norm(right)
    up = np.cross(back, right)
    camera.orientation.setValue(
        coin.SbRotation(
            coin.SbMatrix(*(float(x) for row in (right, up, back) for x in (*row, 0.0)), 0, 0, 0, 1)
        )
    )
    view.fitAll()


def picture(view: Any, path: str) -> None:
    """Save what is visible."""
    aim(view)
    FreeCADGui.updateGui()
    view.saveImage(path, WIDTH, HEIGHT, "White")
    if not Path(path).exists():
        raise OrthoError("FreeCAD rendered no picture; does OpenGL work here?")


def picture_before(model: dict[str, Any], path: str, decades: tuple[int, int]) -> None:
    """Show the mesh as drawn, coloured by planarity."""
    drawn = model["drawn"]
    for name in ("beams", "panels"):
        model[name].ViewObject.Visibility = False
    drawn.ColourMap = "Planarity"
    drawn.ViewObject.LowestDecade, drawn.ViewObject.HighestDecade = decades
    drawn.ViewObject.Legend = False
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
    clad = np.flatnonzero(across <= np.quantile(across, CLAD))
    solids = model["panels"].Shape.Solids
    shades = colours(measures.planarity(mesh), *decades)
    shown = model["panels"].Document.addObject("Part::Feature", "Shown")
    shown.Shape = Part.makeCompound([solids[k] for k in clad])
    # Six faces a panel, one colour each.
    shown.ViewObject.DiffuseColor = [
        (*map(float, shades[k]), 0.0) for k in clad for _ in solids[k].Faces
    ]
    shown.ViewObject.LineColor = (0.12, 0.18, 0.32)
    shown.ViewObject.LineWidth = 1.0
    shown.ViewObject.PointSize = 1.0
    model["panels"].ViewObject.Visibility = False
    model["beams"].ViewObject.Visibility = True
    picture(model["view"], path)


def run(order: dict[str, Any]) -> None:
    """Do what was ordered."""
    model = build(order)
    decades = tuple(order["decades"])
    picture_before(model, order["pictures"]["before"], decades)
    picture_after(model, order["pictures"]["after"], decades)


def main() -> None:
    """Answer, then leave FreeCAD without being asked whether to save."""
    order = json.loads(os.environ["ORTHO_DEMO"])
    try:
        run(order)
        answer = "done"
    except OrthoError as error:
        answer = str(error)
    except Exception as error:  # whatever it is, the demo has to hear of it
        traceback.print_exc()
        answer = f"FreeCAD: {type(error).__name__}: {error}"
    Path(order["result"]).write_text(answer, encoding="utf-8")
    os._exit(0)


main()
