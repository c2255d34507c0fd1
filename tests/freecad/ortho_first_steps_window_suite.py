"""The first steps of a user: macro, examples, preferences, languages, packages. By FreeCAD."""

import sys
import xml.etree.ElementTree as ElementTree
import zipfile
from pathlib import Path
from unittest import mock

import FreeCAD
import FreeCADGui
import numpy as np
import ortho_suite_tools as tools
from ortho_suite_cases import WindowCase
from ortho_suite_tools import press, wait
from PySide import QtCore, QtGui

from freecad_ortho import api, commands, packages, preferences, resources
from freecad_ortho.commands import open_file, requirements
from freecad_ortho.documents.examples import EXAMPLES
from freecad_ortho.objects.net import is_net
from freecad_ortho.panels import installer
from freecad_ortho.window import dialogs
from solver.errors import InputError

PREFIX = "Ortho_Example_"


class FirstStepsCase(WindowCase):
    def tearDown(self):
        super().tearDown()
        self.assertEqual(self.errors, [])

    def recorded(self, command, and_press=None):
        self.lines.clear()
        FreeCADGui.runCommand(command)
        wait()
        if and_press:
            press(and_press)
        return list(self.lines)


class TestReadme(FirstStepsCase):
    def test_first_macro(self):
        text = (tools.ROOT / "README.md").read_text(encoding="utf-8")
        macro = text.split("```python\n")[1].split("```")[0]
        home = tools.SCRATCH / "home of a reader"
        home.mkdir()
        roof = tools.ROOT / "examples" / "data" / "demo_roof.obj"
        (home / "roof.obj").write_bytes(roof.read_bytes())
        with mock.patch.dict("os.environ", HOME=str(home)):
            exec(macro, {"__name__": "__main__"})
        self.assertLess(macro.count("\n"), 13)
        names = {path.name for path in (home / "roof-files").iterdir()}
        self.assertLessEqual({"structure.step", "flat.dxf", "parts.csv", "report.json"}, names)
        self.assertGreater(QtGui.QImage(str(home / "roof.png")).width(), 1000)


class TestExamples(FirstStepsCase):
    def test_each_opens_from_the_menu_and_is_recorded(self):
        self.assertGreaterEqual(len(EXAMPLES), 5)
        for command in commands.examples():
            with self.subTest(command):
                (line,) = self.recorded(command)
                name = command.removeprefix(PREFIX)
                self.assertTrue(line.endswith(f"\nfreecad_ortho.api.open_example({name!r})"))
                self.check(FreeCAD.ActiveDocument)
                tools.close_all()

    def check(self, document):
        nets = [item for item in document.Objects if is_net(item)]
        self.assertTrue(nets)
        self.assertEqual(document.UndoCount, 0)
        for item in document.Objects:
            self.assertEqual(item.State, ["Up-to-date"])
            # The first thing that a new user sees is no warning.
            self.assertEqual(set(getattr(item, "Verdicts", ["ok"])), {"ok"}, item.Label)
            if hasattr(item, "Shape"):
                self.assertTrue(all(solid.isValid() for solid in item.Shape.Solids))
        path = str(tools.SCRATCH / f"example-{document.Name}.png")
        FreeCADGui.activeDocument().activeView().saveImage(path, 800, 500, "White")
        self.assertGreater(QtGui.QImage(path).width(), 0)

    def test_an_unknown_one_is_said(self):
        with self.assertRaisesRegex(InputError, "expected Roof"):
            api.open_example("Castle")
        self.assertFalse(FreeCAD.listDocuments())

    def test_one_that_fails_leaves_no_document(self):
        def fail(document):
            raise InputError("no")

        broken = {"Broken": mock.Mock(title="Broken", tip="", build=fail)}
        with mock.patch.dict(EXAMPLES, broken), self.assertRaises(InputError):
            api.open_example("Broken")
        self.assertFalse(FreeCAD.listDocuments())


class TestMetadata(FirstStepsCase):
    def test_freecad_reads_it(self):
        metadata = FreeCAD.Metadata(str(tools.ROOT / "package.xml"))
        (workbench,) = metadata.Content["workbench"]
        self.assertEqual(workbench.Classname, type(FreeCADGui.activeWorkbench()).__name__)
        self.assertTrue(metadata.supportsCurrentFreeCAD())
        self.assertTrue((tools.ROOT / metadata.Icon).is_file())
        self.assertEqual(metadata.License[0]["name"], "LGPL-2.1-or-later")
        self.assertTrue(metadata.Maintainer and metadata.Author and metadata.Description)


class TestPreferences(FirstStepsCase):
    def setUp(self):
        super().setUp()
        self.forget()
        self.addCleanup(self.forget)

    def forget(self):
        for name in (
            *preferences.LENGTHS,
            "ImportUnit",
            "ImportUp",
            "SparseSolver",
            "Workers",
            "AtOnceSeconds",
        ):
            preferences.group().RemFloat(name)
            preferences.group().RemInt(name)
        for name in preferences.COLOURS:
            preferences.group().RemUnsigned(name)
        preferences.group().RemBool("AskForPackages")

    def page(self):
        return FreeCADGui.PySideUic.loadUi(resources.form("preferences"))

    def test_the_page_begins_with_the_values_of_the_code(self):
        page = self.page()
        for name, value in preferences.LENGTHS.items():
            self.assertEqual(page.findChild(QtGui.QDoubleSpinBox, name).value(), value)
        for name, value in preferences.COLOURS.items():
            colour = page.findChild(QtGui.QWidget, name).property("color")
            for shown, wanted in zip(colour.getRgbF()[:3], value, strict=True):
                self.assertAlmostEqual(shown, wanted, delta=1 / 255)
        for name, choices in (
            ("ImportUnit", preferences.IMPORT_UNITS),
            ("SparseSolver", preferences.SPARSE_SOLVERS),
        ):
            box = page.findChild(QtGui.QComboBox, name)
            shown = [box.itemText(k) for k in range(box.count())]
            self.assertEqual(shown[1:], list(choices[1:]))
        ups = page.findChild(QtGui.QComboBox, "ImportUp")
        shown = tuple(ups.itemText(k) for k in range(ups.count()))
        self.assertEqual(shown, preferences.IMPORT_UPS)
        seconds = page.findChild(QtGui.QDoubleSpinBox, "AtOnceSeconds").value()
        self.assertEqual(seconds, preferences.at_once())
        page.deleteLater()

    def test_what_is_chosen_on_the_page_is_what_the_code_reads(self):
        self.filled = False
        QtCore.QTimer.singleShot(500, self.fill_page)
        FreeCADGui.showPreferences("Ortho")
        self.assertTrue(self.filled)
        self.assertEqual(preferences.length("BeamHeight"), 333.0)
        self.assertEqual(preferences.length("PanelGap"), 8.0)
        self.assertEqual(preferences.import_unit(), "m")
        self.assertEqual(preferences.solver_settings(), {"backend": "scipy"})
        for shown, wanted in zip(preferences.colour("NetColour"), (1.0, 0.2, 0.0), strict=True):
            self.assertAlmostEqual(shown, wanted, places=6)
        self.assertEqual(preferences.workers(), 7)
        self.assertFalse(preferences.asks_for_packages())

    def fill_page(self):
        """Fill FreeCAD's preference dialog, which waits for an answer, and press OK."""
        dialog = QtGui.QApplication.activeModalWidget()
        if dialog is None:  # a busy machine has not opened it yet
            QtCore.QTimer.singleShot(500, self.fill_page)
            return
        try:
            picture = str(tools.SCRATCH / "preferences.png")
            dialog.grab().save(picture)
            dialog.findChild(QtGui.QDoubleSpinBox, "BeamHeight").setValue(333.0)
            dialog.findChild(QtGui.QComboBox, "ImportUnit").setCurrentIndex(3)
            dialog.findChild(QtGui.QComboBox, "SparseSolver").setCurrentIndex(2)
            red = QtGui.QColor(255, 51, 0)
            dialog.findChild(QtGui.QWidget, "NetColour").setProperty("color", red)
            dialog.findChild(QtGui.QSpinBox, "Workers").setValue(7)
            dialog.findChild(QtGui.QCheckBox, "AskForPackages").setChecked(False)
            self.filled = True
        finally:
            buttons = dialog.findChild(QtGui.QDialogButtonBox)
            buttons.button(QtGui.QDialogButtonBox.Ok).click()

    def test_every_preference_is_used(self):
        group = preferences.group()
        for number, name in enumerate(preferences.LENGTHS):
            group.SetFloat(name, 31.0 + number)
        group.SetInt("ImportUnit", preferences.IMPORT_UNITS.index("cm"))
        for name in preferences.COLOURS:
            group.SetUnsigned(name, 0x336699FF)
        with mock.patch.object(dialogs, "ask_mesh_file", lambda: tools.wavy_mesh()):
            FreeCADGui.runCommand("Ortho_ImportNet")
        document = FreeCAD.ActiveDocument
        self.assertEqual(document.Net.Unit, "cm")
        group.SetInt("ImportUnit", 0)
        group.SetInt("SparseSolver", preferences.SPARSE_SOLVERS.index("scipy"))
        outcome = api.optimise_net(document.Net, max_steps=1)
        self.assertEqual(outcome.report.as_dict()["solver"], "scipy")
        document.undo()
        document.Net.Vertices = [point * 0.1 for point in document.Net.Vertices]
        for command in ("Ortho_Beams", "Ortho_Panels"):
            FreeCADGui.runCommand(command)
            wait()
            press("Ok")
        beams, panels = document.Beams, document.Panels
        sizes = [beams.Height, beams.Thickness, panels.Thickness, panels.Gap]
        self.assertEqual([size.Value for size in sizes], [31.0, 32.0, 33.0, 34.0])
        group.SetInt("Workers", 2)
        folder = tools.SCRATCH / "two-workers"
        with mock.patch.object(dialogs, "ask_folder", lambda: str(folder)):
            (line,) = self.recorded("Ortho_ExportFabrication", and_press="Ok")
        self.assertIn("workers=2", line)
        self.assertTrue((folder / "structure.step").is_file())
        for view, name in (
            (document.Net.ViewObject, "FaceColor"),
            (beams.ViewObject, "ShapeColor"),
            (panels.ViewObject, "ShapeColor"),
        ):
            for shown, wanted in zip(getattr(view, name), (0.2, 0.4, 0.6), strict=False):
                self.assertAlmostEqual(shown, wanted, places=5)

    def test_files_whose_y_points_up_are_turned_however_they_come_in(self):
        lying = np.ptp(tools.vertices(api.import_net(tools.wavy_mesh())), axis=0)
        preferences.group().SetInt("ImportUp", preferences.IMPORT_UPS.index("y"))
        document = FreeCAD.ActiveDocument
        with mock.patch.object(dialogs, "ask_mesh_file", lambda: tools.wavy_mesh()):
            (line,) = self.recorded("Ortho_ImportNet")
        self.assertIn("up='y'", line)
        self.assertTrue(open_file.insert(tools.wavy_mesh(), document.Name))
        for net in document.Objects[1:]:
            turned = np.ptp(tools.vertices(net), axis=0)
            np.testing.assert_allclose(turned, lying[[0, 2, 1]], rtol=1e-9)
        self.assertEqual(len(document.Objects), 3)


class TestLanguages(FirstStepsCase):
    def test_what_is_compiled_is_what_is_written(self):
        for language in ("de", "fr"):
            translator = QtCore.QTranslator()
            self.assertTrue(translator.load(f"Ortho_{language}", resources.TRANSLATIONS))
            words = ElementTree.parse(Path(resources.TRANSLATIONS) / f"Ortho_{language}.ts")
            stale = [
                message.findtext("source")
                for context in words.getroot().iter("context")
                for message in context.iter("message")
                if message.find("translation").get("type") is None
                and translator.translate(context.findtext("name"), message.findtext("source"))
                != message.findtext("translation")
            ]
            self.assertEqual(stale, [], "run scripts/translations.py")

    def test_freecad_switches_to_them(self):
        self.addCleanup(FreeCADGui.setLocale, "English")
        for language, words in (("German", "Träger"), ("French", "Poutres")):
            FreeCADGui.setLocale(language)
            wait()
            self.assertEqual(FreeCAD.Qt.translate("Ortho_Beams", "Beams"), words)


def wheel(folder, name):
    """Write an installable package that holds one number."""
    folder.mkdir(parents=True, exist_ok=True)
    info = f"{name}-1.0.dist-info"
    with zipfile.ZipFile(folder / f"{name}-1.0-py3-none-any.whl", "w") as archive:
        archive.writestr(f"{name}.py", "answer = 42\n")
        archive.writestr(f"{info}/METADATA", f"Metadata-Version: 2.1\nName: {name}\nVersion: 1.0\n")
        archive.writestr(f"{info}/WHEEL", "Wheel-Version: 1.0\nTag: py3-none-any\n")
        archive.writestr(f"{info}/RECORD", "")
    return folder


class TestInstaller(FirstStepsCase):
    """With packages from a folder of the test's own, in place of an index."""

    def setUp(self):
        super().setUp()
        self.source = wheel(tools.SCRATCH / "wheels", "ortho_probe")
        self.target = tools.SCRATCH / self.id().rpartition(".")[2]
        settings = {
            "PIP_NO_INDEX": "1",
            "PIP_FIND_LINKS": str(self.source),
            "PIP_CONFIG_FILE": "/dev/null",
        }
        patch = mock.patch.dict("os.environ", settings)
        patch.start()
        self.addCleanup(patch.stop)

    def window(self, *names):
        python = tools.ROOT / ".venv" / "bin" / "python"
        window = installer.Installer(list(names), self.target, python)
        self.addCleanup(window.close)
        window.show()
        return window

    def test_installs_into_the_folder_and_python_finds_it(self):
        window = self.window("ortho_probe")
        self.assertIn("ortho_probe", window.message.text())
        window.install()
        self.assertTrue(window.running)
        self.assertTrue(wait(lambda: not window.running, 60))
        self.assertTrue((self.target / "ortho_probe.py").is_file(), window.message.text())
        self.assertIn("Installed", window.message.text())

    def test_says_why_it_failed(self):
        window = self.window("ortho_no_such_package")
        window.install()
        self.assertTrue(wait(lambda: not window.running, 60))
        self.assertIn("ortho_no_such_package", window.message.text())
        self.assertFalse(self.target.exists())

    def test_stop_leaves_nothing(self):
        window = self.window("ortho_probe")
        window.install()
        window.reject()
        self.assertTrue(wait(lambda: not window.running, 10))
        self.assertIn("Nothing was installed", window.message.text())
        self.assertTrue(window.isVisible())
        self.assertFalse(self.target.exists())

    def test_without_python_it_says_what_to_do(self):
        window = self.window("ortho_probe")
        window.python = None
        with mock.patch.object(installer, "own_python", lambda: None):
            window.install()
        self.assertIn("Install pip", window.message.text())
        self.assertFalse(window.running)

    def test_offered_once_and_only_when_something_is_missing(self):
        shown = []
        with (
            mock.patch.object(requirements, "show_installer", shown.append),
            mock.patch.object(requirements, "_offered", False),
        ):
            requirements.offer_missing()
            self.assertEqual(shown, [])
            with mock.patch.object(packages, "missing", lambda: ["cadquery"]):
                requirements.offer_missing()
                requirements.offer_missing()
                self.assertEqual(shown, [["cadquery"]])
                self.assertTrue(FreeCADGui.isCommandActive("Ortho_InstallPackages"))
        self.assertFalse(FreeCADGui.isCommandActive("Ortho_InstallPackages"))

    def test_packages_go_where_freecad_looks(self):
        folder = requirements.add_on_folder()
        self.assertTrue(str(folder).startswith(FreeCAD.getUserAppDataDir()))
        python = f"py{sys.version_info.major}{sys.version_info.minor}"
        old = tuple(int(part) for part in FreeCAD.Version()[:2]) < (0, 21)
        self.assertEqual(folder.name, "AdditionalPythonPackages" if old else python)
