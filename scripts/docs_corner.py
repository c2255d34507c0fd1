"""A close view of beams and panels for the documentation. Run by FreeCAD with a window.

``scripts/docs_pictures.py`` starts it and says in ORTHO_DOCS which mesh and which picture.
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
import Part  # noqa: E402

from freecad_ortho import api, convert  # noqa: E402

# Plates thicker than those of the demo, so that their joints are seen.
HEIGHT, THICKNESS, PANEL, GAP = 300.0, 60.0, 40.0, 40.0


def draw() -> None:
    """Show beams with panels on some of them, from near."""
    document = FreeCAD.newDocument("Corner")
    net = api.import_net(ORDER["mesh"], document)
    beams = api.add_beams(net, height=HEIGHT, thickness=THICKNESS)
    panels = api.add_panels(net, thickness=PANEL, gap=GAP, beams=beams)
    shown = document.addObject("Part::Feature", "Shown")
    shown.Shape = Part.makeCompound([panels.Shape.Solids[k] for k in ORDER["panels"]])
    shown.ViewObject.ShapeColor = panels.ViewObject.ShapeColor
    for item in (shown, beams):
        item.ViewObject.LineWidth = 3.0
        item.ViewObject.PointSize = 1.0
    panels.ViewObject.Visibility = False
    document.recompute()
    view = FreeCADGui.getDocument(document.Name).ActiveView
    demo_document.aim(view, convert.array(net.Vertices))
    demo_document.light(view)
    demo_document.picture(view, ORDER["picture"])


demo_document.draw_and_end(draw)
