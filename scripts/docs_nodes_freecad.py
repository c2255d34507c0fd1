"""A close view of a node for the documentation. Run by FreeCAD with a window.

``scripts/docs_nodes.py`` starts it and says in ORTHO_DOCS which node and which picture.
"""

from __future__ import annotations

import json
import os
import sys

import FreeCAD
import FreeCADGui

ORDER = json.loads(os.environ["ORTHO_DOCS"])
sys.path[:0] = ORDER["paths"]

import freecad_ortho  # noqa: E402

freecad_ortho.use_own_packages()

import demo_document  # noqa: E402
import numpy as np  # noqa: E402
import Part  # noqa: E402

from freecad_ortho import api, convert  # noqa: E402

COLOURS = {
    "beam": (0.55, 0.65, 0.76),
    "node": (0.85, 0.58, 0.28),
    "end-plate": (0.72, 0.78, 0.45),
    "cover-plate": (0.72, 0.78, 0.45),
    "cone": (0.72, 0.78, 0.45),
    "sleeve": (0.62, 0.62, 0.64),
}
# How far one of the beams is pulled back, mm.
PULLED = 160.0


def draw() -> None:
    """Show what is near the node, in the colours of the kinds of parts."""
    document = FreeCAD.newDocument("Node")
    net = api.import_net(ORDER["mesh"], document)
    mesh = convert.quad_mesh(net)
    made = api.fabricate(mesh, "beams+nodes", node=ORDER["node"], **ORDER["beams"])
    centre = mesh.vertices[ORDER["vertex"]]
    near = [part for part in made.parts if ORDER["vertex"] in part.vertices]
    beams = [part for part in near if part.kind == "beam"]
    furthest = min(beams, key=lambda part: towards_camera(part, centre))
    away = furthest.points.mean(axis=0) - centre
    step = PULLED * away / np.linalg.norm(away)
    clip = Part.makeSphere(ORDER["reach"], FreeCAD.Vector(*centre))
    for part in near:
        solid = convert.part_shape(part.solid()).common(clip)
        if part.name.split("-")[0] == furthest.name.split("-")[0]:
            solid.translate(FreeCAD.Vector(*step))
        shown = document.addObject("Part::Feature", "Shown")
        shown.Shape = solid
        shown.ViewObject.ShapeColor = COLOURS[part.kind]
        shown.ViewObject.LineWidth, shown.ViewObject.PointSize = 2.0, 1.0
    net.ViewObject.Visibility = False
    document.recompute()
    view = FreeCADGui.getDocument(document.Name).ActiveView
    around = 0.6 * ORDER["reach"] * np.concatenate([np.eye(3)[:2], -np.eye(3)[:2]])
    demo_document.aim(view, centre + around)
    demo_document.light(view)
    demo_document.picture(view, ORDER["picture"])


def towards_camera(part: object, centre: np.ndarray) -> float:
    """How far the middle of a part is in front of a point."""
    return float((part.points.mean(axis=0) - centre) @ np.array(demo_document.CAMERA))


demo_document.draw_and_end(draw)
