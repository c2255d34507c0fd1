"""Takes the pictures of scripts/docs_screens.py. Run by FreeCAD with a window."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

sys.path.append(os.environ["ORTHO_SUITE_FOLDER"])

FOLDER = Path(os.environ["ORTHO_SUITE_SCRATCH"])
# Of the 3D view, in pixels; a panel that is higher makes the picture higher.
VIEW = (740, 420)
# Commands that open a panel by themselves and are no part of the tutorial.
SOURCES = (
    "MultiNet",
    "Primitive",
    "EllipticNet",
    "FaceNet",
    "AlignedNet",
    "QuadsFromMesh",
    "FormNet",
)
CHANGES = ("Derived", "Refine", "Transform", "Offset", "Weld")


def look(name: str) -> None:
    """Save the open task panel, if any, and the 3D view beside it."""
    from ortho_suite_tools import wait

    wait(seconds=0.5)
    view = three_d_view()
    panel = task_panel()
    height = max(VIEW[1], bottom(panel) if panel else 0)
    width = VIEW[0] + (panel.width() if panel else 0)
    sheet = QtGui.QImage(width, height, QtGui.QImage.Format_RGB32)
    sheet.fill(QtGui.QColor("white"))
    painter = QtGui.QPainter(sheet)
    if panel:
        painter.drawPixmap(0, 0, panel.grab())
    if view:
        path = str(FOLDER / "view.tmp.png")
        view.saveImage(path, VIEW[0], height, "White")
        painter.drawImage(width - VIEW[0], 0, QtGui.QImage(path))
        Path(path).unlink()
    painter.end()
    sheet.save(str(FOLDER / f"{name}.png"))


def three_d_view():
    """The 3D view of the active document, None where there is none."""
    if FreeCAD.ActiveDocument is None:
        return None
    views = FreeCADGui.ActiveDocument.mdiViewsOfType("Gui::View3DInventor")
    return views[0] if views else None


def task_panel():
    """The form of the open task panel with its title, as it stands in the window."""
    if not FreeCADGui.Control.activeDialog():
        return None
    boxes = FreeCADGui.getMainWindow().findChildren(QtGui.QDialogButtonBox)
    buttons = next(box for box in boxes if box.isVisible())
    for area in FreeCADGui.getMainWindow().findChildren(QtGui.QScrollArea):
        if area.isVisible() and area.isAncestorOf(buttons):
            return area.widget()
    return buttons.parentWidget()


def bottom(panel) -> int:
    """Where the boxes of a task panel end, in pixels from its top; below it is empty."""
    boxes = [each for each in panel.children() if isinstance(each, QtGui.QWidget)]
    return max(each.geometry().bottom() for each in boxes if each.isVisible()) + 8


def stand(room: float = 1.35) -> None:
    """Look at everything from the standard direction, with room for the colour scale."""
    from freecad_ortho.view import picture

    view = three_d_view()
    if view:
        picture.look(view)
        view.getCameraNode().scaleHeight(room)


def tutorial() -> None:
    """The tutorial's steps, each seen from the standard direction."""
    from ortho_tutorial import Tutorial

    def seen(name: str) -> None:
        if name == "drag":
            three_d_view().getCameraNode().scaleHeight(1.2)
        elif name in ("surface", "aligned"):
            stand(1.0)
        elif name != "open":  # which is seen as it opens
            stand(1.35 if story.net.Visibility else 0.75)
        look(name)

    story = Tutorial(seen)
    story.open_surface()
    story.align(1200.0)
    list(story.optimise(stop=False))
    for command, name in (("Beams", "trimmed-beams"), ("Panels", "trimmed")):
        story.structure(command, name)
    close()
    story.open_mesh()
    story.check()
    list(story.optimise())
    story.drag()
    story.colour()
    for command in ("Beams", "Panels"):
        story.structure(command, command.lower())
    document = story.document
    near("panels-near")
    story.flat_patterns("sheets", on_sheets=True)
    story.only(document.FlatPatterns)
    from_above(document.FlatPatterns, 0.1)
    look("sheets-alone")
    story.export(FOLDER / "run" / "files")
    close()
    story.open_gridshell()
    document = story.document
    story.change_structure(document.Lamellas, "lamellas", [("Width", 80.0)])
    near("lamellas-near")
    story.select(document.Lamellas)
    story.flat_patterns("strips", on_sheets=False)
    story.only(document.FlatPatterns)
    from_above(document.FlatPatterns, 0.1)
    look("strips-alone")
    close()


def standing() -> None:
    """The tutorial's structural check; what it comes to is in ``verdicts.txt`` for the page."""
    from ortho_tutorial import Tutorial

    from freecad_ortho import api

    def seen(name: str) -> None:
        stand(0.8)
        look(name)
        for check in story.document.findObjects(Name="StructuralCheck"):
            with (FOLDER / "verdicts.txt").open("a", encoding="utf-8") as stream:
                stream.write(f"{name}: {check.CheckedSection}: {check.Verdict}\n")

    story = Tutorial(lambda name: None)
    story.open_mesh()
    api.optimise_net(story.net)
    api.add_beams(story.net)
    api.add_panels(story.net)
    story.look = seen
    story.check_structure(1.5)
    story.draw_forces()
    story.balance_deformed()
    story.size()
    close()


def near(name: str) -> None:
    """Look at the middle from near."""
    stand(0.3)
    look(name)


def from_above(feature, share: float) -> None:
    """Look from above at a share of a flat object, its first corner."""
    view = FreeCADGui.activeView()
    view.viewTop()
    view.fitAll()
    box = feature.Shape.BoundBox
    camera = view.getCameraNode()
    high = share * max(box.YLength, box.XLength * VIEW[1] / VIEW[0])
    place = camera.position.getValue()
    wide = high * VIEW[0] / VIEW[1]
    camera.position = (box.XMin + 0.48 * wide, box.YMax - 0.45 * high, place[2])
    camera.height = high


def others() -> None:
    """Panel and result of every other command."""
    import ortho_suite_tools as tools

    from freecad_ortho import api

    for command in SOURCES:
        FreeCAD.newDocument("Sources")
        if command in ("FaceNet", "AlignedNet"):
            sheet = FreeCAD.ActiveDocument.addObject("Part::Cylinder", "Cylinder")
            sheet.Radius, sheet.Height = 3000, 5000
            FreeCAD.ActiveDocument.recompute()
            FreeCADGui.Selection.addSelection(sheet, "Face1")
        elif command == "FormNet":
            api.add_primitive("rectangle", sampling=(13, 13), length=12e3, width=12e3)
        elif command == "QuadsFromMesh":
            import Mesh

            FreeCAD.ActiveDocument.addObject("Mesh::Feature", "Scan").Mesh = Mesh.createSphere(
                3000.0, 20
            )
            FreeCADGui.Selection.addSelection(FreeCAD.ActiveDocument.Scan)
        both(command)
    for command in CHANGES:
        FreeCAD.newDocument("Changes")
        nets = [api.add_primitive("translational", length="24 m", width="16 m", rise="3 m")]
        if command == "Weld":
            nets.append(api.change_net(nets[0], "transform", move=("24 m", 0, 0)))
            nets[0].Visibility = True
        for net in nets:
            FreeCADGui.Selection.addSelection(net)
        both(command)
    for command in ("Louvres", "Nodes", "BentPanels"):
        net = api.import_net(tools.wavy_mesh())
        api.optimise_net(net)
        if command == "Nodes":
            api.add_beams(net)
        FreeCADGui.Selection.addSelection(net)
        both(command, room=0.3 if command == "Nodes" else 1.0)
    FreeCADGui.Selection.addSelection(api.add_primitive("cylinder", angles=(0, 180)))
    both("Patches")


def files_and_pages() -> None:
    """What asks for a file or a size, and pages of paper; each dialog is seen as it is answered."""
    import ortho_suite_tools as tools
    from ortho_dialog_tools import Answers

    from freecad_ortho import api

    with Answers(tools.wavy_mesh(), look=shots("ImportNet-dialog")):
        FreeCADGui.runCommand("Ortho_ImportNet")
    stand()
    look("ImportNet")
    net = FreeCAD.ActiveDocument.Net
    picture = FOLDER / "SavePicture.png"
    with Answers(str(picture), "900 x 600", look=shots("SavePicture-dialog")):
        FreeCADGui.runCommand("Ortho_SavePicture")
    api.optimise_net(net)
    beams = api.add_beams(net)
    flat = api.add_flat_patterns(beams, sheet=("3 m", "1.5 m"))
    FreeCADGui.Selection.addSelection(flat)
    FreeCADGui.runCommand("Ortho_DrawingPage")
    tools.wait(seconds=2.0)
    FreeCADGui.runCommand("Std_ViewFitAll")
    tools.wait(seconds=1.0)
    FreeCADGui.getMainWindow().centralWidget().grab().save(str(FOLDER / "DrawingPage.png"))
    bake_and_update(net, beams)
    close()


def bake_and_update(net, beams) -> None:
    """What waits has a mark in the tree; plain copies stand there in groups."""
    import ortho_suite_tools as tools

    from freecad_ortho import api, preferences

    preferences.group().SetFloat("AtOnceSeconds", 0.0)
    place = net.Vertices[17]
    api.drag_net(net, {17: (place.x, place.y, place.z + 500)})
    preferences.group().RemFloat("AtOnceSeconds")
    tools.wait(seconds=0.5)
    tree("UpdateStructures-before")
    FreeCADGui.runCommand("Ortho_UpdateStructures")
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(beams)
    FreeCADGui.runCommand("Ortho_Bake")
    tools.wait(seconds=0.5)
    tree("Bake")


def tree(name: str) -> None:
    """Save what the tree shows."""
    trees = FreeCADGui.getMainWindow().findChildren(QtGui.QTreeWidget)
    max(trees, key=lambda each: each.isVisible()).grab().save(str(FOLDER / f"{name}.png"))


def shots(name: str):
    """Save each dialog that comes up, numbered."""
    count = []

    def shot(dialog) -> None:
        count.append(dialog)
        dialog.grab().save(str(FOLDER / f"{name}-{len(count)}.png"))

    return shot


def both(command: str, room: float = 1.35) -> None:
    """Open a command's panel, look, press OK, look, close the document."""
    from ortho_suite_tools import press, wait

    if not FreeCADGui.isCommandActive(f"Ortho_{command}"):
        FreeCAD.Console.PrintWarning(f"{command} is grey\n")
    FreeCADGui.runCommand(f"Ortho_{command}")
    wait(seconds=0.5)
    stand()
    look(f"{command}-panel")
    if FreeCADGui.Control.activeDialog():
        press("Ok")
        wait(seconds=1.0)
    if FreeCADGui.Control.activeDialog():
        FreeCADGui.Control.closeDialog()
    stand(room)
    look(command)
    close()


def close() -> None:
    """Close all documents."""
    FreeCADGui.Selection.clearSelection()
    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)


def run() -> None:
    """Take all pictures, then end FreeCAD whatever happens."""
    try:
        FreeCADGui.activateWorkbench("OrthoWorkbench")
        for part in (tutorial, standing, others, files_and_pages):
            if part.__name__ in os.environ.get("ORTHO_SCREENS", part.__name__):
                part()
    finally:
        close()
        QtGui.QApplication.quit()


QtCore.QTimer.singleShot(1000, run)
