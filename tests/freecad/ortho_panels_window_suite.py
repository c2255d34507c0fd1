"""All task panels as FreeCAD shows them at first: nothing is cut off, in any language."""

import gc
import json

import FreeCAD
import FreeCADGui
import ortho_suite_tools as tools
from ortho_panel_tools import (
    PANELS,
    broad,
    cut_off,
    document_for_panels,
    form,
    open_panel,
    untold,
    width,
)
from ortho_suite_cases import WindowCase
from ortho_suite_tools import press, wait
from PySide import QtGui

from freecad_ortho import api
from freecad_ortho.fabrication.formats import FORMATS
from freecad_ortho.panels import structure_edit_panel, workshop_panels
from freecad_ortho.window import dialogs

LANGUAGES = ("English", "German", "French")
# Lists at the top of these panels choose what fields there are.
CHANGING = ("Primitive", "Derived", "Refine", "Transform", "Optimise")


class TestWidths(WindowCase):
    def setUp(self):
        super().setUp()
        self.addCleanup(FreeCADGui.setLocale, "English")
        # So low that each panel needs a scroll bar, which takes from its width.
        main = FreeCADGui.getMainWindow()
        self.addCleanup(main.resize, main.size())
        main.resize(main.width(), 500)

    def test_no_text_is_cut_off(self):
        found, document = [], document_for_panels()
        for language in LANGUAGES:
            FreeCADGui.setLocale(language)
            for command in PANELS:
                panel = open_panel(document, command)
                for state in self.states(command, panel):
                    words = cut_off(panel)
                    if words:
                        found.append(f"{language}, {command} {state}: {'; '.join(words)}")
                self.close()
        self.assertFalse(found, "\n".join(found))

    def test_long_names_widen_nothing_and_numbers_say_what_they_are(self):
        found, document = [], document_for_panels()
        for item in document.Objects:
            item.Label = f"{item.Label} whose name is far longer than a task panel is wide at first"
        for command in PANELS:
            panel = open_panel(document, command)
            if panel.width() > width():
                found.append(f"{command} ({panel.width()} > {width()}): {broad(panel)}")
            found += [f"{command}: no sentence on {words}" for words in untold(panel)]
            self.close()
        self.assertFalse(found, "\n".join(found))

    def states(self, command, panel):
        """The panel with everything unfolded, and with each of its choices in turn."""
        for each in panel.findChildren(QtGui.QToolButton):
            if each.isVisible() and each.isCheckable() and not each.isChecked():
                each.click()
        wait(seconds=0.05)
        yield ""
        if command in CHANGING:
            boxes = [box for box in panel.findChildren(QtGui.QComboBox) if box.isVisible()]
            for k in range(boxes[0].count()):
                boxes[0].setCurrentIndex(k)
                QtGui.QApplication.processEvents()
                yield boxes[0].itemText(k)

    def close(self):
        if FreeCADGui.ActiveDocument.getInEdit():
            FreeCADGui.ActiveDocument.resetEdit()
        if FreeCADGui.Control.activeDialog():
            FreeCADGui.Control.closeDialog()
        self.assertTrue(wait(lambda: not self.buttons(), 10))
        # What is left of a panel goes at any time; FreeCAD ended when that was one of its fields.
        gc.collect()

    def buttons(self):
        boxes = FreeCADGui.getMainWindow().findChildren(QtGui.QDialogButtonBox)
        return [box for box in boxes if box.isVisible()]


class TestSettings(WindowCase):
    """A double click on a structure opens what it was made with."""

    def setUp(self):
        super().setUp()
        self.net = api.import_net(tools.wavy_mesh())
        api.optimise_net(self.net)
        self.document = self.net.Document
        self.watch_panel(structure_edit_panel, "StructureEditPanel")

    def opened(self, structure):
        self.assertTrue(structure.ViewObject.Proxy.doubleClicked(structure.ViewObject))
        wait()
        return self.panel

    def test_every_structure_opens_its_own_and_changes_nothing_by_ok(self):
        beams = api.add_structure(self.net, "beams", height=150.0, ends="hub")
        made = {
            "beams": beams,
            "panels": api.add_panels(self.net, beams=beams),
            "nodes": api.add_structure(self.net, "nodes", beams=beams),
            "lamellas": api.add_structure(self.net, "lamellas", family="u", lines=[0, 2]),
            "louvres": api.add_structure(self.net, "louvres"),
        }
        steps, self.lines[:] = self.document.UndoCount, []
        for system, structure in made.items():
            before = [getattr(structure, name) for name in structure.PropertiesList]
            panel = self.opened(structure)
            self.assertEqual(panel._system, system)
            self.assertEqual(panel.settings(), {}, system)
            press("Ok")
            after = [getattr(structure, name) for name in structure.PropertiesList]
            for old, new in zip(before, after, strict=True):
                if isinstance(old, (bool, int, float, str, list)):
                    self.assertEqual(new, old)
        self.assertEqual((self.document.UndoCount, self.lines, self.errors), (steps, [], []))

    def test_the_menu_of_the_tree_opens_them_too(self):
        view, menu = api.add_structure(self.net, "louvres").ViewObject, QtGui.QMenu()
        view.Proxy.setupContextMenu(view, menu)
        (entry,) = menu.actions()
        self.assertEqual(entry.text(), "Edit settings")
        entry.trigger()
        wait()
        self.assertEqual(self.panel._system, "louvres")

    def test_three_buttons_are_no_wider_than_the_panel(self):
        self.addCleanup(FreeCADGui.setLocale, "English")
        beams = api.add_structure(self.net, "beams")
        for language in LANGUAGES:
            FreeCADGui.setLocale(language)
            self.opened(beams)
            # FreeCAD 1.0 lays a long form out more than once.
            wait(lambda: form().width() <= width(), 5)
            self.assertLessEqual(form().width(), width(), language)
            FreeCADGui.Control.closeDialog()
            wait()

    def test_apply_shows_cancel_restores_and_ok_is_one_step_that_replays(self):
        beams = api.add_beams(self.net, height=150.0)
        panels = api.add_panels(self.net, beams=beams)
        volumes, steps = (beams.Shape.Volume, panels.Shape.Volume), self.document.UndoCount
        self.assertEqual(self.opened(beams).fields["height"].value, 150.0)
        self.panel.fields["height"].value = 300.0
        press("Apply")
        self.assertEqual(beams.Height.Value, 300.0)
        self.assertGreater(beams.Shape.Volume, 1.9 * volumes[0])
        press("Cancel")
        self.assertEqual((beams.Height.Value, self.document.UndoCount), (150.0, steps))
        self.assertEqual((beams.Shape.Volume, panels.Shape.Volume), volumes)
        self.assertEqual({item.State[0] for item in (beams, panels)}, {"Up-to-date"})
        self.opened(beams)
        self.panel.fields["height"].value = 300.0
        press("Apply")
        self.panel.fields["height"].value = 150.0
        self.panel.fields["thickness"].value = 20.0
        lifted = panels.Shape.BoundBox.ZMax
        press("Ok")
        self.assertEqual((beams.Height.Value, beams.Thickness.Value), (150.0, 20.0))
        self.assertLess(panels.Shape.BoundBox.ZMax, lifted)
        self.assertEqual((self.document.UndoCount, self.errors), (steps + 1, []))
        changed = beams.Shape.Volume
        self.document.undo()
        self.assertEqual((beams.Shape.Volume, panels.Shape.Volume), volumes)
        self.replay()
        self.assertEqual(beams.Shape.Volume, changed)

    def test_a_section_of_the_catalogue_may_be_chosen_or_typed(self):
        beams = api.add_beams(self.net)
        for word in ("HEB160", "tube:80x40x4", "I"):
            self.opened(beams)
            self.panel.fields["section"].value = word
            press("Ok")
            self.assertEqual(beams.Section, word)
            self.assertEqual(self.opened(beams).fields["section"].value, word)
            press("Cancel")
        self.assertEqual(self.errors, [])

    def test_a_build_up_may_be_chosen_or_typed(self):
        panels = api.add_panels(self.net)
        for word, thickness in (("glass:8+1.52+8", 17.52), ("toughened-glass:6/12/44.2", 26.76)):
            self.opened(panels)
            self.panel.material.choose(word)
            press("Ok")
            self.assertEqual(panels.Material, word.capitalize())
            self.assertAlmostEqual(panels.Thickness.Value, thickness)
        self.assertEqual(self.errors, [])

    def test_sizes_that_do_not_fit_are_said_and_leave_it_as_it_was(self):
        beams = api.add_beams(self.net)
        volume, steps = beams.Shape.Volume, self.document.UndoCount
        self.opened(beams)
        self.panel.fields["thickness"].value = 1e5
        for button in ("Apply", "Ok"):
            press(button)
            self.assertIn("thickness", self.errors.pop())
            self.assertTrue(FreeCADGui.Control.activeDialog())
        press("Cancel")
        self.assertEqual((beams.Shape.Volume, beams.Thickness.Value), (volume, 20.0))
        self.assertEqual((self.document.UndoCount, beams.State), (steps, ["Up-to-date"]))


class TestStock(WindowCase):
    def test_the_length_of_the_lamellas_is_the_one_of_the_panel(self):
        net = api.import_net(tools.wavy_mesh())
        api.optimise_net(net)
        lamellas = api.add_structure(
            net, "lamellas", family="u", lines=[0], width=60.0, stock="6 m"
        )
        folder = str(tools.SCRATCH / "panel-stock")
        self.replace(dialogs, "ask_folder", lambda: folder)
        self.watch_panel(workshop_panels, "ExportPanel")
        for shown, typed in ((6000.0, 3000.0), (3000.0, 0.0), (0.0, 0.0)):
            FreeCADGui.runCommand("Ortho_ExportFabrication")
            wait()
            stock = self.panel.fields["stock"]
            self.assertEqual(stock.value or 0.0, shown)
            stock.value = typed
            press("Ok")
            self.assertEqual((self.errors, lamellas.Stock.Value), ([], typed))
        self.assertEqual(FreeCAD.ActiveDocument.UndoNames[:2], ["Stock length"] * 2)

    def test_what_is_lost_on_bars_is_asked_for_and_only_said_where_it_is_not_the_usual(self):
        net = api.import_net(tools.wavy_mesh())
        api.optimise_net(net)
        api.add_structure(net, "beams", section="hollow", thickness=5)
        folder = tools.SCRATCH / "panel-bars"
        self.replace(dialogs, "ask_folder", lambda: str(folder))
        self.watch_panel(workshop_panels, "ExportPanel")
        lines = []
        changes = {"saw": 4.0, "trim": 25.0, "rest": 900.0, "section_tolerance": 3.0}
        changes |= {"step": "systems", "site_origin": "1000,2000,30", "site_rotation": 15.0}
        changes |= {"stock_lengths": "3000,12000", "equal": 1.0}
        changes |= {"paper": "a1", "date": "1 May", "label_sheet": "4x10", "rhino_parts": "solids"}
        changes |= {"ifc_assemblies": "lines", "ifc_parts": "exact"}
        # All files for other programs, those too whose package is missing here.
        ticked = tuple(FORMATS)
        for changed in (False, True):
            FreeCADGui.runCommand("Ortho_ExportFabrication")
            wait()
            if changed:
                for name, value in changes.items():
                    self.panel.fields[name].value = value
                for name in ticked:
                    self.panel.formats[name].setChecked(True)
            press("Ok")
            self.assertEqual(self.errors, [])
            lines.append(self.lines[-1])
        written = f"write={','.join(ticked)!r}"
        for name in (*(f"{name}={value!r}" for name, value in changes.items()), written):
            self.assertNotIn(name.partition("=")[0], lines[0])
            self.assertIn(name, lines[1])
        report = json.loads((folder / "report.json").read_text())
        for each in FORMATS.values():
            about = [words for words in report["messages"] if words.startswith(each.file)]
            said = any("is missing" in words for words in about)
            self.assertEqual((each.name, (folder / each.place).exists()), (each.name, not said))
        stock = report["stock"]
        self.assertEqual((stock["saw_mm"], stock["trim_mm"]), (4.0, 25.0))


class TestFlatPatterns(WindowCase):
    def opened(self, flat):
        self.assertTrue(flat.ViewObject.Proxy.doubleClicked(flat.ViewObject))
        wait()
        return self.panel

    def test_a_double_click_opens_their_settings_and_ok_is_one_step_that_replays(self):
        net = api.import_net(tools.wavy_mesh())
        api.optimise_net(net)
        flat = api.add_flat_patterns(api.add_structure(net, "panels"), kerf=1, spacing=25)
        self.watch_panel(workshop_panels, "FlatPatternsPanel")
        panel = self.opened(flat)
        self.assertFalse(panel.on_sheets.isChecked())
        self.assertEqual(panel.fields["kerf"].value, 1.0)
        panel.on_sheets.setChecked(True)
        panel.width.millimetres, panel.height.millimetres = 4000.0, 2100.0
        panel.fields["spacing"].value = 30.0
        panel.fields["grain"].value = "along"
        document, steps = net.Document, net.Document.UndoCount
        press("Ok")
        self.assertEqual(self.errors, [])
        self.assertEqual(document.UndoCount, steps + 1)
        self.assertEqual((flat.Spacing.Value, flat.Grain, flat.Kerf.Value), (30.0, "Along", 1.0))
        self.assertGreater(flat.SheetCount, 0)
        self.assertEqual(len([i for i in document.Objects if i.TypeId == flat.TypeId]), 2)
        panel = self.opened(flat)
        self.assertEqual((panel.on_sheets.isChecked(), panel.fields["spacing"].value), (True, 30.0))
        panel.on_sheets.setChecked(False)
        panel.fields["kerf"].value = 0.0
        press("Ok")
        self.assertEqual((flat.SheetCount, flat.Kerf.Value), (0, 0.0))
        panel = self.opened(flat)
        panel.on_sheets.setChecked(True)
        panel.width.millimetres = panel.height.millimetres = 100.0
        press("Ok")
        self.assertEqual(len(self.errors), 1)
        self.assertEqual((flat.SheetWidth.Value, flat.State), (0.0, ["Up-to-date"]))
        press("Cancel")


class TestVerdicts(WindowCase):
    """Whoever builds with a mesh that is no net is told what fails, not only in a property."""

    def built(self, net, command):
        wrong = []
        self.replace(FreeCAD.Console, "PrintWarning", wrong.append)
        FreeCADGui.runCommand(command)
        wait()
        press("Ok")
        wait()
        self.assertEqual(self.errors, [])
        return FreeCADGui.getMainWindow().statusBar().currentMessage(), "".join(wrong)

    def test_parts_that_fail_are_counted_in_the_report_view_and_the_status_bar(self):
        net = api.import_net(tools.wavy_mesh())
        status, wrong = self.built(net, "Ortho_Panels")
        self.assertIn("30 parts", status)
        self.assertIn("exceed a limit", status)
        self.assertIn(status, wrong)
        folder = tools.SCRATCH / "panel-verdicts"
        self.replace(dialogs, "ask_folder", lambda: str(folder))
        self.built(net, "Ortho_ExportFabrication")
        failed = len(json.loads((folder / "report.json").read_text())["verdict"]["failed"])
        self.assertIn(f"{failed} of 30 parts exceed a limit", self.said[-1])

    def test_what_is_right_is_counted_without_a_warning(self):
        net = api.import_net(tools.wavy_mesh())
        api.optimise_net(net)
        status, wrong = self.built(net, "Ortho_Beams")
        self.assertIn("parts", status)
        self.assertNotIn("exceed", status)
        self.assertEqual(wrong, "")


class TestSheets(WindowCase):
    def test_files_are_nested_as_the_flat_patterns_are(self):
        net = api.import_net(tools.wavy_mesh())
        api.optimise_net(net)
        panels = api.add_structure(net, "panels")
        api.add_flat_patterns(panels, sheet=(4000, 2100), spacing=20, grain="along", kerf=2)
        folder = tools.SCRATCH / "panel-sheets"
        self.replace(dialogs, "ask_folder", lambda: str(folder))
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(panels)
        FreeCADGui.runCommand("Ortho_ExportFabrication")
        wait()
        press("Ok")
        self.assertEqual(self.errors, [])
        self.assertIn("sheet=(4000.0, 2100.0", self.lines[-1])
        self.assertIn("grain='along'", self.lines[-1])
        self.assertTrue(list((folder / "sheets").glob("*.dxf")))
