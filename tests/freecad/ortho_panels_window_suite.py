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
from PySide import QtCore, QtGui

from freecad_ortho import api
from freecad_ortho.fabrication.formats import FORMATS
from freecad_ortho.panels import structure_edit_panel, workshop_panels
from freecad_ortho.panels.fields import LengthField
from freecad_ortho.panels.option_fields import OptionField
from freecad_ortho.panels.quantity import QuantityBox
from freecad_ortho.sources import source
from freecad_ortho.window import dialogs
from solver.option import Option, Range

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


class TestUnits(WindowCase):
    """Lengths are those that were given, whatever the user's units can show."""

    def setUp(self):
        super().setUp()
        group = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Units")
        before = group.GetInt("UserSchema", 0)
        self.addCleanup(FreeCAD.Units.setSchema, before)
        self.addCleanup(group.SetInt, "UserSchema", before)
        group.SetInt("UserSchema", 5)
        FreeCAD.Units.setSchema(5)

    def test_a_field_knows_when_it_is_deleted(self):
        """PySide takes what comes to lie in its place for it otherwise."""
        field = LengthField(12.0).widget
        field.deleteLater()
        QtCore.QCoreApplication.sendPostedEvents(field, QtCore.QEvent.DeferredDelete)
        with self.assertRaises(RuntimeError):
            field.text()

    def test_defaults_are_shown_and_stored_exactly_in_us_building_units(self):
        net = api.import_net(tools.wavy_mesh())
        api.optimise_net(net)
        FreeCADGui.runCommand("Ortho_Beams")
        wait()
        height = tools.field("Height")
        wait(lambda: height.text() == "200 mm", 5)
        self.assertEqual(height.text(), "200 mm")
        self.assertEqual(tools.field("Thickness").text(), "20 mm")
        press("Ok")
        beams = net.Document.Beams
        self.assertEqual((beams.Height.Value, beams.Thickness.Value), (200.0, 20.0))
        FreeCADGui.runCommand("Ortho_FlatPatterns")
        wait()
        press("Ok")
        self.assertIn("sheet=(3000.0, 1500.0,), spacing=10.0", self.lines[-1])

    def test_what_is_typed_stays_when_the_field_comes_into_sight_again(self):
        field = LengthField(12.0)
        for typed, expected in (
            ("250 mm", 250.0),
            ('3/4"', 19.05),
            ("1 m", 1000.0),
            ("1,5 cm", 15.0),
            ("33.3333333 mm", 33.3333333),
            ("2", 50.8),
        ):
            field.widget.show()
            wait(seconds=0.05)
            self.type(field.widget, typed)
            self.assertAlmostEqual(field.millimetres, expected, delta=1e-9)
            for _ in range(2):
                self.key(field.widget, QtCore.Qt.Key_Return)
                self.assertAlmostEqual(field.millimetres, expected, delta=1e-9)
            field.widget.hide()
            wait(seconds=0.05)
            field.widget.show()
            wait(seconds=0.05)
            self.assertAlmostEqual(field.millimetres, expected, delta=1e-9)
        field.widget.deleteLater()

    def test_what_is_no_length_or_beyond_the_limits_leaves_the_last_one(self):
        field = LengthField(12.0)
        for typed in ("two", "", "-4 mm", "nan"):
            self.type(field.widget, typed)
            self.key(field.widget, QtCore.Qt.Key_Return)
            self.assertEqual((field.millimetres, field.widget.text()), (12.0, "12 mm"), typed)
        # As far as it was one.
        self.type(field.widget, "3 kg")
        self.key(field.widget, QtCore.Qt.Key_Return)
        self.assertEqual((field.millimetres, field.widget.text()), (3.0, "3 mm"))
        field.widget.deleteLater()

    def test_a_number_without_a_unit_is_in_that_of_the_number_before(self):
        area = QuantityBox("mm^2", -16e6)
        FreeCAD.Units.setSchema(0)
        area.exact = -16e6
        self.assertEqual(area.text(), "-16.00 m^2")
        self.type(area, "0.5")
        self.assertEqual(area.exact, 0.5e6)
        area.exact = 2e6
        area.stepBy(3)
        self.assertEqual(area.exact, 5e6)
        FreeCAD.Units.setSchema(5)
        length = LengthField(20.0)
        self.assertEqual(length.widget.text(), "20 mm")
        self.type(length.widget, "25")
        self.assertEqual(length.millimetres, 25.0)

    def test_the_words_for_an_absent_number_go_when_one_is_typed(self):
        field = LengthField(0.0, absent="automatic")
        self.assertEqual((field.widget.text(), field.millimetres), ("automatic", 0.0))
        self.type(field.widget, "3 m")
        self.assertEqual(field.millimetres, 3000.0)
        self.type(field.widget, "0")
        self.key(field.widget, QtCore.Qt.Key_Return)
        self.assertEqual((field.widget.text(), field.millimetres), ("automatic", 0.0))

    def type(self, box, text):
        """Choose everything in a field and type over it, key by key."""
        box.selectAll()
        self.key(box, QtCore.Qt.Key_Backspace)
        for letter in text:
            self.key(box, 0, letter)

    def key(self, box, key, letter=""):
        for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
            event = QtGui.QKeyEvent(kind, key, QtCore.Qt.NoModifier, letter)
            QtGui.QApplication.sendEvent(box, event)

    def test_what_the_units_would_show_as_nothing_is_shown_in_mm(self):
        for length, words in ((1.0, "1 mm"), (0.5, "0.5 mm"), (0.0, "0")):
            field = LengthField(length)
            field.widget.show()
            wait(seconds=0.05)
            self.assertEqual(field.widget.text(), words)
            self.assertEqual(field.millimetres, length)
            field.widget.deleteLater()

    def test_what_a_calculation_left_is_shown_as_nothing_and_kept(self):
        FreeCAD.Units.setSchema(0)
        field = LengthField(-2.8e-7)
        field.widget.show()
        wait(seconds=0.05)
        self.assertEqual(field.widget.text(), "0.00 mm")
        self.assertEqual(field.millimetres, -2.8e-7)
        field.widget.deleteLater()

    def test_sources_begin_with_their_own_numbers(self):
        for name in ("sphere", "catenoid", "helicoid", "offset", "inversion"):
            for option in source(name).options:
                shown = OptionField(option, option.default)
                if shown.widget is not None:
                    shown.widget.show()
                    wait(seconds=0.02)
                    self.assertEqual(shown.value, option.default, f"{name} {option.name}")
                    shown.widget.deleteLater()

    def test_a_field_ends_where_the_range_of_its_option_does(self):
        for option, most in (
            (Option("part", 0.1, "number", "Part", within=Range(0.0, 0.5)), 0.5),
            (Option("bolts", 2, "count", "Bolts", within=Range(1, 2)), 2),
            (Option("tilt", 0.0, "angle", "Tilt", within=Range(-90.0, 90.0)), 90.0),
        ):
            field = OptionField(option, option.default)
            ends = [field.widget.property(end) for end in ("minimum", "maximum")]
            self.assertEqual(ends, [option.range.least, most], option.name)
            self.assertIn(f" … {most:g})", field.widget.toolTip())
            field.widget.deleteLater()


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
