"""View provider of a structural check: members in colours, where they are or where they move to."""

from __future__ import annotations

from typing import Any

import FreeCAD
from pivy import coin

from freecad_ortho import answers
from freecad_ortho.objects.properties import Property, Stateless, ensure
from freecad_ortho.resources import icon
from freecad_ortho.view import context_menu, legends, refresh, scene
from freecad_ortho.view.check_combination import COMBINATIONS_FROM, GOVERNING, choices
from freecad_ortho.view.check_diagram import (
    DIAGRAMS,
    DIAGRAMS_FROM,
    NONE,
    DiagramAreas,
    ordinates,
)
from freecad_ortho.view.check_shapes import COLOURINGS, DRAWN_FROM, SHAPES, Drawn, Look, drawn
from freecad_ortho.view.frame_lines import FrameLines
from freecad_ortho.view.legend import Legend
from freecad_ortho.view.swinging import Swinging

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

_LINES = "Wireframe"
_GROUP = "Structural check"
_PROPERTIES = (
    Property(
        "App::PropertyEnumeration",
        "ColourBy",
        _GROUP,
        QT_TRANSLATE_NOOP("App::Property", "What the colours of the members say"),
        choices=COLOURINGS,
    ),
    Property(
        "App::PropertyEnumeration",
        "DrawnShape",
        _GROUP,
        QT_TRANSLATE_NOOP("App::Property", "Shape that is drawn: the frame, or how it moves"),
        choices=SHAPES,
    ),
    Property(
        "App::PropertyInteger",
        "BucklingMode",
        _GROUP,
        QT_TRANSLATE_NOOP("App::Property", "Buckling shape that is drawn; 1 is the first"),
        default=1,
    ),
    Property(
        "App::PropertyFloat",
        "Enlarged",
        _GROUP,
        QT_TRANSLATE_NOOP(
            "App::Property", "Displacements are drawn so many times as large; 0: as it fits"
        ),
        default=0.0,
    ),
    Property(
        "App::PropertyEnumeration",
        "Diagram",
        _GROUP,
        QT_TRANSLATE_NOOP(
            "App::Property", "Force that is drawn across the members, red where positive"
        ),
        choices=DIAGRAMS,
    ),
    Property(
        "App::PropertyFloat",
        "DiagramScale",
        _GROUP,
        QT_TRANSLATE_NOOP(
            "App::Property", "So many mm are drawn for a kN or kNm of the diagram; 0: as it fits"
        ),
        default=0.0,
    ),
    Property(
        "App::PropertyEnumeration",
        "Combination",
        _GROUP,
        QT_TRANSLATE_NOOP(
            "App::Property", "Combination whose forces and displacements are drawn, first order"
        ),
        choices=(GOVERNING,),
    ),
    Property(
        "App::PropertyBool",
        "Legend",
        _GROUP,
        QT_TRANSLATE_NOOP("App::Property", "Show the scale of the colours"),
        default=True,
    ),
    Property(
        "App::PropertyFloat",
        "LineWidth",
        _GROUP,
        QT_TRANSLATE_NOOP("App::Property", "Width of the members, in pixels"),
        default=4.0,
    ),
)
_DRAWING = (
    "ColourBy",
    "DrawnShape",
    "BucklingMode",
    "Enlarged",
    "Diagram",
    "DiagramScale",
    "Combination",
    "Legend",
    "LineWidth",
    "Visibility",
)


class CheckView(Stateless):
    """Proxy of the view provider of a structural check."""

    def __init__(self, view_object: Any) -> None:
        ensure(view_object, _PROPERTIES)
        view_object.Proxy = self

    def attach(self, view_object: Any) -> None:
        """Build the nodes; FreeCAD calls this on creation and when a document opens."""
        refresh.connect()
        ensure(view_object, _PROPERTIES)
        self.ViewObject, self.Object = view_object, view_object.Object
        self._lines, self._legend, self._diagram = FrameLines(), Legend(), DiagramAreas()
        self._swinging = Swinging(self._lines, view_object.Object)
        self._explanation: Drawn | None = None
        group = coin.SoSeparator()
        for child in (scene.nearer(), self._lines.root, self._diagram.root, self._legend.root):
            group.addChild(child)
        view_object.addDisplayMode(group, _LINES)
        self._draw()

    def getDisplayModes(self, view_object: Any) -> list[str]:
        """Name the display modes."""
        return [_LINES]

    def getDefaultDisplayMode(self) -> str:
        """The only one."""
        return _LINES

    def setDisplayMode(self, mode: str) -> str:
        """Show the mode of that name."""
        return mode

    def getIcon(self) -> str:
        """Icon in the tree: the same picture as on the command."""
        return icon("structural_check")

    def doubleClicked(self, view_object: Any) -> bool:
        """Open the settings of the check."""
        answers.ask("edit structural check", view_object.Object)
        return True

    def setupContextMenu(self, view_object: Any, menu: Any) -> None:
        """Offer settings, pictures and files in the tree."""
        for words, action in (
            (translate("Ortho", "Edit settings"), lambda: self.doubleClicked(view_object)),
            (translate("Ortho", "Utilisation"), lambda: self._show("Utilisation", "As drawn")),
            (translate("Ortho", "Axial forces"), lambda: self._show("Axial force", "As drawn")),
            (
                translate("Ortho", "Deflected shape"),
                lambda: self._show("Displacement", "Deflected"),
            ),
            (translate("Ortho", "Next diagram of forces"), self.next_diagram),
            (translate("Ortho", "Next combination"), self.next_combination),
            (translate("Ortho", "Next buckling shape"), self.next_mode),
            (translate("Ortho", "Let the shape swing"), self.swing),
            (
                translate("Ortho", "Find the lightest section"),
                lambda: answers.ask("size check", self.Object),
            ),
            (translate("Ortho", "Write files"), lambda: answers.ask("write check", self.Object)),
            (
                translate("Ortho", "Analysis of the FEM workbench"),
                lambda: answers.ask("analyse check", self.Object),
            ),
        ):
            context_menu.offer(menu, words, action)

    def updateData(self, feature: Any, name: str) -> None:
        """Follow the results, in whatever order they change: undo has one of its own."""
        if name in (*DRAWN_FROM, *DIAGRAMS_FROM, *COMBINATIONS_FROM) and hasattr(self, "_lines"):
            self._draw()

    def onChanged(self, view_object: Any, name: str) -> None:
        """Follow a property of the view provider."""
        if name in _DRAWING and hasattr(self, "_lines"):
            self._draw()

    def onDelete(self, view_object: Any, parts: Any) -> bool:
        """Let nothing swing any more; FreeCAD asks whether it may be deleted."""
        self._swinging.stop()
        return True

    def next_mode(self) -> None:
        """Draw the buckling shape after the one that is drawn, after the last the first."""
        view, count = self.ViewObject, len(self.Object.BucklingFactors)
        shown = view.DrawnShape == "Buckling"
        if shown and count:
            view.BucklingMode = view.BucklingMode % count + 1
        self._show("Displacement", "Buckling")

    def next_diagram(self) -> None:
        """Draw the force after the one that is drawn, after the last none; on the frame itself."""
        view = self.ViewObject
        view.Diagram = DIAGRAMS[(DIAGRAMS.index(view.Diagram) + 1) % len(DIAGRAMS)]
        self._show("None", "As drawn")

    def next_combination(self) -> None:
        """Draw the combination after the one that is drawn, after the last what governs."""
        view, all_of_them = self.ViewObject, choices(self.Object)
        number = all_of_them.index(view.Combination) + 1
        view.Combination = all_of_them[number % len(all_of_them)]
        message = f"{self.Object.Label}: {view.Combination}"
        FreeCAD.Console.PrintMessage(f"{message}\n")

    def swing(self) -> None:
        """Let the drawn shape swing to both sides, or stand still again."""
        if self.ViewObject.DrawnShape == "As drawn":
            self._show("Displacement", "Buckling" if self.Object.BucklingFactors else "Deflected")
        self._swinging.toggle()

    def explains(self) -> bool:
        """Tell whether colours are seen that need a scale."""
        return self._explanation is not None and self.ViewObject.Visibility

    def show_legend(self, shown: bool, name: str = "") -> None:
        """Show the scale of the colours or not, with a name where there are others."""
        found = self._explanation
        if found is None or found.scale is None or not shown:
            self._legend.hide()
            return
        self._legend.show(
            f"{found.title}: {name}" if name else found.title, found.note, found.scale
        )

    def _show(self, colours: str, shape: str) -> None:
        self.ViewObject.ColourBy = colours
        self.ViewObject.DrawnShape = shape

    def _draw(self) -> None:
        view = self.ViewObject
        self._swinging.stop()
        if self._choices_changed():
            # Drawn already, with the new choices.
            return
        look = Look(
            view.ColourBy, view.DrawnShape, view.BucklingMode, view.Enlarged, view.Combination
        )
        found = drawn(self.Object, look)
        self._lines.show(found, view.LineWidth)
        # Where the frame is drawn as it moves there is nothing for ordinates to stand on.
        drawn_still = found is not None and found.moved is None
        force = view.Diagram if drawn_still else NONE
        self._diagram.show(ordinates(self.Object, force, view.DiagramScale, view.Combination))
        explained = found is not None and found.scale is not None and view.Legend
        self._explanation = found if explained else None
        legends.changed(self.Object)

    def _choices_changed(self) -> bool:
        """Let the combinations of the check be chosen; keep the one that is where it still is."""
        view, found = self.ViewObject, choices(self.Object)
        if view.getEnumerationsOfProperty("Combination") == found:
            return False
        chosen = view.Combination
        view.Combination = found
        if chosen in found:
            view.Combination = chosen
        return True
