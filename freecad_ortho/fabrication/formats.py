"""The files for other programs that are written where they are asked for."""

from __future__ import annotations

from dataclasses import dataclass
from importlib.util import find_spec

from solver.option import one_of


@dataclass(frozen=True)
class Format:
    """One such file, or a folder of them.

    Attributes:
        name: as it is asked for.
        file: its name in the folder; a folder of files with the names that the pattern after the
            slash stands for, ``saw-list/*``.
        package: the Python package that writes it, by the name it is imported by; empty where none
            is needed.
        installed_as: the same as pip calls it.
        contents: what is in it, a sentence without its full stop.
    """

    name: str
    file: str
    package: str
    installed_as: str
    contents: str

    @property
    def missing(self) -> bool:
        """Whether its package is not there."""
        return bool(self.package) and find_spec(self.package) is None

    @property
    def place(self) -> str:
        """The file, or the folder of the files."""
        return self.file.partition("/")[0]


FORMATS = {
    each.name: each
    for each in (
        Format(
            *("ifc", "structure.ifc", "ifcopenshell", "ifcopenshell"),
            "IFC 4 holds all parts, with quantities and properties",
        ),
        Format(
            *("glb", "structure.glb", "trimesh", "trimesh"),
            "glTF holds all parts, with names and colours, for viewers",
        ),
        Format(
            *("xlsx", "lists.xlsx", "xlsxwriter", "XlsxWriter"),
            "one workbook holds all lists, and masses with a column for prices",
        ),
        Format(
            *("labels", "labels.pdf", "reportlab", "reportlab"),
            "each part has a label with a QR code of its name",
        ),
        Format(
            *("saw", "saw-list/*", "", ""),
            "bars are listed with lengths and angles of both ends, and how to read them",
        ),
        Format(
            *("nc1", "nc1/*", "", ""),
            "each part has a file for machines that saw, drill and cut steel (DSTV)",
        ),
        Format(
            *("btlx", "structure.btlx", "", ""),
            "BTLx says how parts of timber are cut, drilled and marked",
        ),
        Format(
            *("3dm", "structure.3dm", "rhino3dm", "rhino3dm"),
            "Rhino gets parts, the net, its lines and axes, on layers",
        ),
        Format(
            *("assembly", "assembly/*", "", ""),
            "these lists have order of assembly, weights, what meets at nodes, points to be "
            "surveyed",
        ),
        Format(
            *("drawings", "drawings.pdf", "reportlab", "reportlab"),
            "plan, sheets, a typical node and typical parts are drawn with dimensions, to scale",
        ),
    )
}


def formats_of(words: str) -> tuple[Format, ...]:
    """Formats by their names, which commas part, each once and in the order of the table.

    Raises:
        InputError: an unknown name.
    """
    names = [word.strip().lower() for word in words.split(",") if word.strip()]
    for name in names:
        one_of("write", name, FORMATS)
    return tuple(each for name, each in FORMATS.items() if name in names)
