"""Fields for numbers with and without a unit: nothing that was given or typed is changed."""

import FreeCAD
import FreeCADGui
import ortho_suite_tools as tools
from ortho_suite_cases import WindowCase
from ortho_suite_tools import press, wait
from PySide import QtCore, QtGui

from freecad_ortho import api
from freecad_ortho.panels.fields import LengthField
from freecad_ortho.panels.option_fields import OptionField
from freecad_ortho.panels.quantity import QuantityBox
from freecad_ortho.sources import source
from solver.option import Option, Range


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
        length = LengthField(200.0)
        length.widget.show()
        wait(seconds=0.05)
        self.type(length.widget, "250")
        self.assertEqual(length.millimetres, 250.0)
        length.widget.deleteLater()
        FreeCAD.Units.setSchema(5)
        absent = LengthField(0.0, absent="automatic")
        self.type(absent.widget, "2")
        self.assertEqual(absent.millimetres, 50.8)
        length = LengthField(20.0)
        self.assertEqual(length.widget.text(), "20 mm")
        self.type(length.widget, "25")
        self.assertEqual(length.millimetres, 25.0)

    def test_the_words_for_an_absent_number_go_when_one_is_typed(self):
        field = LengthField(0.0, absent="automatic")
        self.assertEqual((field.widget.text(), field.millimetres), ("automatic", 0.0))
        for length, words in ((120.0, "120 mm"), (0.0, "automatic")):
            field.millimetres = length
            field.widget.show()
            wait(seconds=0.05)
            self.assertEqual((field.widget.text(), field.millimetres), (words, length))
        field.widget.setValue(250.0)
        self.assertEqual((field.widget.text(), field.millimetres), ("250 mm", 250.0))
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
