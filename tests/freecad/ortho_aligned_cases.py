"""A face on which a net is aligned by its panel, for suites in FreeCAD's window."""

import FreeCAD
import FreeCADGui
from ortho_aligned_tools import roof
from ortho_suite_cases import PanelCase
from ortho_suite_tools import wait

from freecad_ortho.objects import making
from freecad_ortho.panels import aligned_panel
from freecad_ortho.sources import aligning

# Seconds that a net may take on a busy machine.
LONG = 120


class AlignedCase(PanelCase):
    def setUp(self):
        super().setUp()
        self.watch_panel(aligned_panel, "AlignedPanel")
        self.document = FreeCAD.newDocument("Aligned")
        self.sheet = self.document.addObject("Part::Feature", "Sheet")
        self.sheet.Shape = roof()
        self.document.recompute()
        wait()
        # What another test made is not at hand.
        making._made.clear()
        self.made = 0
        make = aligning.aligned

        def counted(*arguments, **options):
            self.made += 1
            return make(*arguments, **options)

        self.replace(aligning, "aligned", counted)

    def opened_on(self, *names):
        FreeCADGui.Selection.clearSelection()
        for name in names:
            FreeCADGui.Selection.addSelection(self.sheet, name)
        return self.opened("AlignedNet")

    def until_made(self, panel):
        self.assertTrue(wait(lambda: panel.made is not None, LONG), panel.message.text())
