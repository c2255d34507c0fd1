"""Task panels that ask what parts are cut from: for flat patterns, and for all files."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import FreeCAD
from PySide import QtGui

from freecad_ortho import preferences
from freecad_ortho.documents.structures import lost_on_bars
from freecad_ortho.fabrication.formats import FORMATS
from freecad_ortho.fabrication.workshop import ON_SHEETS, Workshop
from freecad_ortho.objects.flat_patterns import is_flat_patterns
from freecad_ortho.objects.option_properties import read
from freecad_ortho.panels.fields import (
    ChoiceField,
    LengthField,
    NumberField,
    form_rows,
    sentence,
    shortened,
)
from freecad_ortho.panels.option_fields import OptionField, add_option
from freecad_ortho.panels.work_panel import WorkPanel
from freecad_ortho.resources import icon
from freecad_ortho.window import context, dialogs, messages

translate = FreeCAD.Qt.translate

_OPTIONS = {option.name: option for option in Workshop.options}
# What counts for parts on sheets only, and what is asked besides.
_SHEETS = tuple(option.name for option in ON_SHEETS if option.name != "kerf")
_BARS = ("stock", "saw", "trim", "rest", "section_tolerance")
_FILES = ("dxf", "dxf_version", "dxf_text", "step", "step_tolerance", "hardware", "equal")
_COSTS = ("stock_lengths", "sheet_sizes", "prices")
_PAPER = ("paper", "date", "label_sheet", "ifc_assemblies", "ifc_parts", "rhino_parts")
_SITE = ("site_origin", "site_rotation")


class _WorkshopPanel(WorkPanel):
    """Sheet, spacing and kerf.

    Attributes:
        fields: by the name of the workshop's option.
    """

    def __init__(
        self, structures: list[FreeCAD.DocumentObject], title: str, picture: str, nested: bool
    ) -> None:
        self._document = structures[0].Document.Name
        self._names = [item.Name for item in structures]
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(title)
        self.form.setWindowIcon(QtGui.QIcon(icon(picture)))
        labels = QtGui.QLabel(", ".join(item.Label for item in structures))
        labels.setWordWrap(True)
        self.rows = form_rows(self.form)
        self.rows.addRow(translate("Ortho", "Structures"), labels)
        self.fields: dict[str, OptionField] = {}
        self._add_sheet_fields(nested)
        self._ask("kerf")

    @property
    def structures(self) -> list[FreeCAD.DocumentObject]:
        """The structures, without those that have gone meanwhile."""
        if self._document not in FreeCAD.listDocuments():
            return []
        document = FreeCAD.getDocument(self._document)
        found = [document.getObject(name) for name in self._names]
        return [item for item in found if item is not None]

    def settings(self) -> dict[str, Any]:
        """What was chosen, by the names that the document functions have for it."""
        settings: dict[str, Any] = {}
        if self.fields["kerf"].value:
            settings["kerf"] = self.fields["kerf"].value
        if self.on_sheets.isChecked():
            settings["sheet"] = (self.width.millimetres, self.height.millimetres)
            settings |= {name: self.fields[name].value for name in _SHEETS}
        return settings

    def _show(self, patterns: FreeCAD.DocumentObject) -> None:
        """Show the settings of flat patterns."""
        self._take("kerf", patterns)
        if patterns.SheetWidth.Value > 0.0:
            self.on_sheets.setChecked(True)
            self.width.millimetres = patterns.SheetWidth.Value
            self.height.millimetres = patterns.SheetHeight.Value
            for name in _SHEETS:
                self._take(name, patterns)

    def _take(self, name: str, patterns: FreeCAD.DocumentObject) -> None:
        self.fields[name].value = read(patterns, _OPTIONS[name])

    def _ask(self, *names: str) -> None:
        """Add a row for each of some options."""
        for name in names:
            self.fields[name] = OptionField(_OPTIONS[name], _OPTIONS[name].default)
            add_option(self.rows, self.fields[name])

    def possible(self) -> bool:
        """Tell whether any structure is still there."""
        return bool(self.structures)

    def _add_sheet_fields(self, nested: bool) -> None:
        self.on_sheets = QtGui.QCheckBox(translate("Ortho", "Nest on sheets"))
        self.rows.addRow(self.on_sheets)
        self.width, self.height = LengthField(3000.0), LengthField(1500.0)
        self.on_sheets.setToolTip(translate("Ortho", "Parts are nested on sheets."))
        self.width.widget.setToolTip(translate("Ortho", "The sheets are this wide."))
        self.height.widget.setToolTip(translate("Ortho", "The sheets are this high."))
        self.rows.addRow(translate("Ortho", "Sheet width"), self.width.widget)
        self.rows.addRow(translate("Ortho", "Sheet height"), self.height.widget)
        self._ask(*_SHEETS)
        for field in (self.width, self.height, *self.fields.values()):
            field.widget.setEnabled(nested)
            self.on_sheets.toggled.connect(field.widget.setEnabled)
        self.on_sheets.setChecked(nested)


class FlatPatternsPanel(_WorkshopPanel):
    """Asks how flat patterns are laid out: new ones, or some that are there."""

    def __init__(
        self,
        structures: list[FreeCAD.DocumentObject],
        edited: FreeCAD.DocumentObject | None = None,
    ) -> None:
        title = translate("Ortho", "Flat patterns")
        shown = title if edited is None else shortened(edited.Label)
        super().__init__(structures, shown, "flat_patterns", nested=edited is None)
        self._edited = None if edited is None else edited.Name
        if edited is not None:
            self._show(edited)

    @property
    def edited(self) -> FreeCAD.DocumentObject | None:
        """The flat patterns that are changed, None where there are none."""
        if self._edited is None or self._document not in FreeCAD.listDocuments():
            return None
        return FreeCAD.getDocument(self._document).getObject(self._edited)

    def possible(self) -> bool:
        """Tell whether what is laid out is still there."""
        return super().possible() and (self._edited is None or self.edited is not None)

    def work(self) -> bool:
        """Lay the patterns out."""
        if self._edited is None:
            context.run("add_flat_patterns", self.structures, **self.settings())
        else:
            settings = {"sheet": (0.0, 0.0), "kerf": 0.0, **self.settings()}
            context.run("change_flat_patterns", self.edited, **settings)
        return True


class ExportPanel(_WorkshopPanel):
    """Asks what the fabrication files are made for, and where they go."""

    def __init__(self, structures: list[FreeCAD.DocumentObject]) -> None:
        title = translate("Ortho", "Export fabrication files")
        super().__init__(structures, title, "export", nested=False)
        self._take_over(structures)
        self._ask(*_BARS)
        lengths = [item.Stock.Value for item in structures if "Stock" in item.PropertiesList]
        self._given = max(lengths, default=0.0)
        # What lamellas were cut for comes first.
        self._usual = {name: option.default for name, option in _OPTIONS.items()}
        self._usual |= lost_on_bars(structures)
        for name in _BARS[1:]:
            self.fields[name].value = self._usual[name]
        self.fields["stock"].value = self._given
        self._ask(*_FILES)
        self._add_formats()
        self._ask(*_PAPER, *_COSTS, *_SITE)
        self.workers = NumberField(translate("Ortho", "Workers"), preferences.workers(), whole=True)
        self.workers.widget.setToolTip(translate("Ortho", "So many processes share the work."))
        self.rows.addRow(translate("Ortho", "Workers"), self.workers.widget)
        measured = {
            "local": translate("Ortho", "near the net"),
            "keep": translate("Ortho", "those of its file"),
        }
        self.origin = ChoiceField(measured, "local")
        self.origin.widget.setToolTip(
            translate(
                "Ortho",
                "A net that came from far away lies about a point nearby, where CAD kernels keep "
                "their accuracy; its file's coordinates are put back on demand.",
            )
        )
        if any(item.Net is not None and item.Net.Origin.Length for item in structures):
            self.rows.addRow(translate("Ortho", "Coordinates"), self.origin.widget)

    def _add_formats(self) -> None:
        """A box to tick for each file for another program; what is not installed cannot be."""
        titles = {
            "labels": translate("Ortho", "Labels"),
            "saw": translate("Ortho", "Saw list"),
            "assembly": translate("Ortho", "Assembly"),
            "drawings": translate("Ortho", "Drawings"),
        }
        self.formats = {name: QtGui.QCheckBox(titles.get(name, name.upper())) for name in FORMATS}
        missing = translate("Ortho", "The Python package {} is not installed.")
        boxes = QtGui.QWidget()
        grid = QtGui.QGridLayout(boxes)
        grid.setContentsMargins(0, 0, 0, 0)
        for number, (name, box) in enumerate(self.formats.items()):
            each = FORMATS[name]
            box.setEnabled(not each.missing)
            contents = sentence(translate("Ortho", each.contents))
            box.setToolTip(missing.format(each.installed_as) if each.missing else contents)
            grid.addWidget(box, number // 2, number % 2)
        self.rows.addRow(translate("Ortho", "Also write"), boxes)

    def _take_over(self, structures: list[FreeCAD.DocumentObject]) -> None:
        """Begin with the sheets of the flat patterns that the same structures have already."""
        wanted = set(self._names)
        for item in structures[0].InList:
            if is_flat_patterns(item) and {each.Name for each in item.Structures} == wanted:
                self._show(item)

    def settings(self) -> dict[str, Any]:
        """What was chosen, as ``freecad_ortho.api.export_fabrication`` takes it.

        Raises:
            InputError: the workers are not a number.
        """
        settings = super().settings()
        stock = self.fields["stock"].value or 0.0
        if stock or self._given:
            settings["stock"] = stock
        asked = (*_BARS[1:], *_FILES, *_PAPER, *_COSTS, *_SITE)
        chosen: dict[str, Any] = {name: self.fields[name].value for name in asked}
        chosen["write"] = ",".join(name for name, box in self.formats.items() if box.isChecked())
        settings |= {name: value for name, value in chosen.items() if value != self._usual[name]}
        if (self.workers.number or 1) > 1:
            settings["workers"] = self.workers.number
        if self.origin.word != "local":
            settings["origin"] = self.origin.word
        return settings

    def work(self) -> bool:
        """Write the files into the folder that the user chooses."""
        settings = self.settings()
        folder = dialogs.ask_folder()
        if folder is None:
            return False
        context.run("export_fabrication", self.structures, folder, **settings)
        said = translate("Ortho", "Fabrication files written to {}").format(folder)
        verdict = json.loads((Path(folder) / "report.json").read_text(encoding="utf-8"))["verdict"]
        failed = len(verdict["failed"])
        if failed:
            more = translate("Ortho", "{} of {} parts exceed a limit, see report.html")
            said += "; " + more.format(failed, failed + verdict["passed"])
        messages.show_status(said, wrong=bool(failed))
        return True
