"""Close views of details for the documentation. Run by FreeCAD with a window.

``scripts/docs_details.py`` starts it and says in ORTHO_DOCS which details it wants where.
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
import docs_details  # noqa: E402
import numpy as np  # noqa: E402
import Part  # noqa: E402

from freecad_ortho import convert  # noqa: E402

PLATE, STEEL = (0.72, 0.78, 0.45), (0.55, 0.65, 0.76)
COLOURS = {
    "node": (0.85, 0.58, 0.28),
    "end-plate": PLATE,
    "foot-plate": PLATE,
    "foot": (0.85, 0.58, 0.28),
    "edge beam": (0.75, 0.5, 0.45),
    "pressure-plate": (0.85, 0.58, 0.28),
    "cap": (0.6, 0.6, 0.62),
    "adapter": (0.85, 0.58, 0.28),
    "panel": (0.72, 0.84, 0.86),
}
FAMILIES = {"u": (0.55, 0.65, 0.76), "v": (0.85, 0.72, 0.5)}


def draw(name: str) -> None:
    """Show what is near the place of a detail, in the colours of the kinds of parts."""
    detail = docs_details.DETAILS[name]
    document = FreeCAD.newDocument("Detail")
    made = docs_details.built(detail)
    centre = docs_details.place_of(detail, docs_details.net()) + [0.0, 0.0, detail.above]
    demo_document.CAMERA = detail.camera
    panels = [part for part in made.parts if part.kind == "panel"]
    near = [part for part in panels if np.abs(part.points - centre).max(axis=1).min() < 500]
    nearest = max(near, key=lambda part: towards(part, detail.camera), default=None)
    clip = Part.makeSphere(detail.reach, FreeCAD.Vector(*centre))
    if detail.sliced:
        size = 2 * detail.reach
        corner = FreeCAD.Vector(*(centre - [size / 2, 0.0, size / 2]))
        clip = clip.common(Part.makeBox(size, size, size, corner))
    for part in made.parts:
        low, high = part.points.min(axis=0), part.points.max(axis=0)
        outside = (low > centre + detail.reach).any() or (high < centre - detail.reach).any()
        if outside or (detail.bare and part is nearest):
            continue
        solid = convert.part_shape(part.solid()).common(clip)
        if part.family == "v":
            solid.translate(FreeCAD.Vector(0, 0, detail.lifted))
        if solid.Volume < 1.0:
            continue
        shown = document.addObject("Part::Feature", "Shown")
        shown.Shape = solid
        colour = FAMILIES.get(part.family, STEEL) if part.kind == "lamella" else STEEL
        shown.ViewObject.ShapeColor = COLOURS.get(part.kind, colour)
        shown.ViewObject.LineWidth, shown.ViewObject.PointSize = 2.0, 1.0
    document.recompute()
    view = FreeCADGui.getDocument(document.Name).ActiveView
    around = 0.75 * detail.reach * np.concatenate([np.eye(3)[:2], -np.eye(3)[:2]])
    demo_document.aim(view, centre + around)
    demo_document.light(view)
    demo_document.picture(view, f"{ORDER['folder']}/{name}.png")
    FreeCAD.closeDocument(document.Name)


def towards(part: object, camera: tuple[float, float, float]) -> float:
    """How far the middle of a part is towards the camera."""
    return float(part.points.mean(axis=0) @ np.array(camera))


def draw_all() -> None:
    """One picture a name."""
    for name in ORDER["names"]:
        draw(name)


demo_document.draw_and_end(draw_all)
