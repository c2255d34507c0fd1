"""What the workshop cuts from and with: sheets, bars, the width of the cut."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from freecad_ortho.fabrication.datum import Datum
from freecad_ortho.fabrication.drawing_form import PAPERS, DrawingForm
from freecad_ortho.fabrication.dxf_form import LAYOUTS, TEXTS, VERSIONS, DxfForm
from freecad_ortho.fabrication.equal import TOLERANCE_MM
from freecad_ortho.fabrication.formats import FORMATS, Format, formats_of
from freecad_ortho.fabrication.label_form import LabelForm, label_form
from freecad_ortho.fabrication.prices import Prices, read_prices
from freecad_ortho.fabrication.sizes import check_options, positive
from solver.errors import InputError
from solver.option import Option, Range

GRAINS = ("none", "along")
NESTINGS = ("boxes", "outlines")
HARDWARE = ("list", "solids")
IFC_ASSEMBLIES = ("systems", "lines", "rings")
IFC_PARTS = ("facets", "exact")
RHINO_PARTS = ("meshes", "solids")
STEP_FILES = ("one", "systems", "in-place")
# Tubes that differ by more percent are not one section by any standard.
_WIDEST = 20.0
# No sheet, bar or cut is longer, mm.
_LONGEST = 1e6
# Parts that differ by more are not equal for any workshop, mm.
_LOOSEST = 20.0


@dataclass(frozen=True)
class Workshop:
    """Sizes of the material and of the cut, mm.

    Args:
        sheet: width and height of the sheets that plates are cut from, None for no nesting.
        spacing: clear distance between parts on a sheet, and from its rim.
        grain: "none" lets parts turn, "along" keeps their length along the sheet's width.
        nesting: "boxes" packs the parts' boxes: fast, and always the same; "outlines" packs their
            outlines with an optional library, which searches for some seconds a sheet.
        seed: of that search.
        stock: length of bars and strips, None for 6 m or as many metres as the longest part needs.
        saw: width of the saw cut behind each part of a bar, the last one too.
        trim: length cut off at each end of a bar.
        rest: shortest rest of a bar that is kept.
        section_tolerance: by which heights of tubes may differ from the middle one and still be one
            section, percent. Hot finished hollow sections are rolled to 1 % (EN 10210-2).
        kerf: width of the cut that flat patterns are compensated for, 0 for true outlines.
        dxf: drawings with "blocks", "flat" without, or one file for each of the different "parts".
        dxf_version: "r2010", or "r12" for old readers.
        dxf_text: names and marks as "text", as single "strokes", or "none".
        step: solids in "one" file, or in one for each of the "systems"; "in-place" ones in one file
            without places, each where it is built in.
        step_tolerance: distance within which solids agree that are written once and placed several
            times; 0 writes each by itself.
        hardware: bolts, gaskets and setting blocks are in the "list" alone, or drawn as "solids" in
            STEP files too.
        equal: distance within which parts are equal, cut from one drawing, mm.
        write: names of ``formats.FORMATS`` to be written besides, with commas between them.
        site_origin: where the model's origin is on site: east, north and height in metres, with
            commas between them; empty for zero.
        site_rotation: by which the model's x axis is turned from east, counter-clockwise, degrees.
        paper: of drawings, "a4" to "a0".
        prices: name of a file, see ``read_prices``; what it has no price for is filled in by hand.
        stock_lengths: lengths, mm, with commas between them; each bar is the shortest of these and
            of ``stock`` on which its parts have room.
        sheet_sizes: sizes as ``WxH``, with commas between them, likewise.
        date: in the title block of drawings, as it is written there; empty for none, as with a
            clock the same structure would not give the same file.
        label_sheet: a name or a description of ``label_form``.
        ifc_assemblies: of IFC hold the parts of "systems", of "lines" of the net or of "rings".
        ifc_parts: bent sides in IFC as "facets" within 0.05 mm, or "exact".
        rhino_parts: in Rhino's files as "meshes", or as "solids" where their sides are plane.

    Raises:
        InputError: a size that cannot be used, an unknown word.
    """

    sheet: tuple[float, float] | None = None
    spacing: float = 10.0
    grain: str = "none"
    nesting: str = "boxes"
    seed: int = 0
    stock: float | None = None
    saw: float = 3.0
    trim: float = 10.0
    rest: float = 500.0
    section_tolerance: float = 1.5
    kerf: float = 0.0
    dxf: str = "blocks"
    dxf_version: str = "r2010"
    dxf_text: str = "text"
    step: str = "one"
    step_tolerance: float = 0.0
    hardware: str = "list"
    equal: float = TOLERANCE_MM
    write: str = ""
    site_origin: str = ""
    site_rotation: float = 0.0
    paper: str = "a3"
    date: str = ""
    prices: str = ""
    stock_lengths: str = ""
    sheet_sizes: str = ""
    label_sheet: str = "3x8"
    ifc_assemblies: str = "systems"
    ifc_parts: str = "facets"
    rhino_parts: str = "meshes"

    options: ClassVar[tuple[Option, ...]] = (
        Option("sheet", None, "text", "parts are nested on sheets of this size", written="WxH"),
        Option(
            *("spacing", 10.0, "length", "parts keep so far from each other and from the rim"),
            title="Clear distance",
        ),
        Option(
            *("grain", "none", "choice", "parts may turn on the sheet as its grain says", GRAINS),
            shown={"none": "parts may turn", "along": "along the sheet"},
        ),
        Option(
            *("nesting", "boxes", "choice", "boxes pack fast, outlines densely", NESTINGS),
            title="Packing",
            shown={"boxes": "by boxes (fast)", "outlines": "by outlines (dense)"},
        ),
        Option("seed", 0, "count", "another number begins another search for a dense nesting"),
        Option(
            *("stock", None, "length"),
            "bars and strips are this long; longer lamellas are spliced",
            title="Stock length",
            absent="as long as it takes",
        ),
        Option(
            *("saw", 3.0, "length", "the saw cut behind each part of a bar is this wide"),
            title="Saw cut",
        ),
        Option(*("trim", 10.0, "length", "bars lose this much at each end"), title="Trimmed ends"),
        Option(
            *("rest", 500.0, "length", "rests of bars from this length on are kept"),
            title="Least rest",
        ),
        Option(
            *("section_tolerance", 1.5, "percent", "tubes of one section differ so much in height"),
            within=Range(0.0, _WIDEST),
        ),
        Option("kerf", 0.0, "length", "outlines grow by half this width of a cut", absent="none"),
        Option(
            *("dxf", "blocks", "choice", "parts are blocks, plain lines or files", LAYOUTS),
            title="DXF drawings",
            shown={
                "blocks": "a block for each part",
                "flat": "plain lines",
                "parts": "a file for each part",
            },
        ),
        Option(
            *("dxf_version", "r2010", "choice", "drawings are of this version", tuple(VERSIONS)),
            title="DXF version",
            shown={"r2010": "R2010", "r12": "R12"},
        ),
        Option(
            *("dxf_text", "text", "choice", "names and marks are written so", TEXTS),
            title="Names and marks",
            shown={"text": "as text", "strokes": "as single strokes", "none": "not at all"},
        ),
        Option(
            *("step", "one", "choice"),
            "solids share a file, have one a system, or lie in one without places",
            STEP_FILES,
            title="STEP files",
            shown={
                "one": "one for all parts",
                "systems": "one for each system",
                "in-place": "one, in place",
            },
        ),
        Option(
            *("step_tolerance", 0.0, "length"),
            "solids that agree within this are one product of the file with several places",
            title="Equal in STEP",
            absent="none",
            within=Range(0.0, TOLERANCE_MM),
        ),
        Option(
            *("hardware", "list", "choice"),
            "bolts, gaskets and setting blocks are listed, or drawn as solids too",
            HARDWARE,
            title="Hardware in STEP",
            shown={"list": "in the list only", "solids": "as solids too"},
        ),
        Option(
            *("equal", TOLERANCE_MM, "length"),
            "parts that agree within this are equal: one drawing, with how many are cut from it",
            within=Range(0.0, _LOOSEST, above=True),
        ),
        Option(
            *("write", "", "text", f"files are made for other programs too: {', '.join(FORMATS)}"),
            written="NAME,...",
        ),
        Option(
            *("site_origin", "", "text", "the model's origin is there on site, in metres"),
            written="EAST,NORTH,HEIGHT",
        ),
        Option("site_rotation", 0.0, "angle", "the model's x axis is turned so far from east"),
        Option("paper", "a3", "choice", "drawings are of this size", tuple(PAPERS)),
        Option("date", "", "text", "drawings have this date in their title block"),
        Option(
            *("prices", "", "text", "these rows of item, unit and price give the lists' costs"),
            written="FILE",
        ),
        Option(
            *("stock_lengths", "", "text"),
            "bars come in these lengths too, mm; the shortest that will do is taken",
            written="L,...",
        ),
        Option(
            *("sheet_sizes", "", "text"),
            "sheets come in these sizes too, mm; the smallest that will do is taken",
            written="WxH,...",
        ),
        Option(
            *("label_sheet", "3x8", "text"),
            "labels are printed on this sheet: columns x rows, a4 or letter-3x10",
            written="COLSxROWS",
        ),
        Option(
            *("ifc_assemblies", "systems", "choice"),
            "assemblies in IFC hold the parts of a system, of a line or of a ring",
            IFC_ASSEMBLIES,
            title="Assemblies in IFC",
            shown={"systems": "by system", "lines": "by line", "rings": "by ring"},
        ),
        Option(
            *("ifc_parts", "facets", "choice"),
            "bent sides in IFC are facets, or exact for programs that read those",
            IFC_PARTS,
            title="Parts in IFC",
            shown={"facets": "facets", "exact": "exact"},
        ),
        Option(
            *("rhino_parts", "meshes", "choice"),
            "parts in 3DM are meshes, or solids where their sides are plane",
            RHINO_PARTS,
            title="Parts in 3DM",
            shown={"meshes": "meshes", "solids": "solids"},
        ),
    )

    def __post_init__(self) -> None:
        for side in self.sheet or ():
            positive("sheet", side, "mm")
        check_options(self, (option for option in self.options if option.name != "sheet"))
        self._refuse_endless()
        if self.step == "in-place" and self.step_tolerance > 0:
            raise InputError(
                "step: solids that are in-place share no product; leave the step tolerance out, or "
                "take step one"
            )
        _ = self.dxf_form, self.formats, self.datum, self.drawing_form, self.price_list
        _ = self.lengths_in_store, self.sizes_in_store, self.label_form

    def _refuse_endless(self) -> None:
        lengths = {"sheet": max(self.sheet or (0.0,)), "stock": self.stock or 0.0}
        lengths |= {
            name: getattr(self, name) for name in ("spacing", "saw", "trim", "rest", "kerf")
        }
        for name, length in lengths.items():
            if length > _LONGEST:
                raise InputError(
                    f"{name}: {length:g} mm is no size of a workshop; take 1 km at most"
                )

    @property
    def dxf_form(self) -> DxfForm:
        """How drawings are written."""
        return DxfForm(self.dxf, self.dxf_version, self.dxf_text)

    @property
    def drawing_form(self) -> DrawingForm:
        """How drawings for the office are made."""
        return DrawingForm(self.paper, self.date)

    @property
    def label_form(self) -> LabelForm:
        """How many labels a page has, and where."""
        return label_form(self.label_sheet)

    @property
    def formats(self) -> tuple[Format, ...]:
        """Files for other programs."""
        return formats_of(self.write)

    @property
    def price_list(self) -> Prices:
        """What things cost, empty without a file."""
        return read_prices(self.prices) if self.prices else {}

    @property
    def lengths_in_store(self) -> tuple[float, ...]:
        """Lengths of bars besides the longest, mm, the shortest first."""
        words = [word.strip() for word in self.stock_lengths.split(",") if word.strip()]
        try:
            found = sorted({float(word) for word in words})
        except ValueError:
            found = [-1.0]
        if found and not (found[0] > 0 and math.isfinite(found[-1])):
            raise InputError(
                "stock lengths: expected mm with commas between them, as 6000,8000, got "
                f"'{self.stock_lengths[:40]}'"
            )
        return tuple(found)

    @property
    def sizes_in_store(self) -> tuple[tuple[float, float], ...]:
        """Sizes of sheets besides the one that is nested on, mm, the smallest first."""
        words = [word for word in self.sheet_sizes.split(",") if word.strip()]
        found = {sheet_size(word) for word in words}
        for side in (side for size in found for side in size):
            positive("sheet sizes", side, "mm")
        return tuple(sorted(found, key=lambda size: (size[0] * size[1], size)))

    @property
    def datum(self) -> Datum:
        """Where the model is on site."""
        return Datum.of(self.site_origin, self.site_rotation)

    @classmethod
    def of(cls, values: Mapping[str, Any]) -> Workshop:
        """Make the settings from values of some of ``options``; a sheet may be a text ``WxH``.

        Raises:
            InputError: a value that cannot be used.
        """
        given = dict(values)
        known = [option.name for option in cls.options]
        for name in given:
            if name not in known:
                raise InputError(
                    f"{name}: the workshop has no such size; it has {', '.join(known)}"
                )
        if isinstance(given.get("sheet"), str):
            given["sheet"] = sheet_size(given["sheet"])
        return cls(**given)


# What flat patterns are laid out by.
ON_SHEETS = tuple(
    option
    for option in Workshop.options
    if option.name in ("spacing", "grain", "nesting", "seed", "kerf")
)


def sheet_size(text: str) -> tuple[float, float]:
    """Width and height of ``3000x1500``, mm.

    Raises:
        InputError: not two numbers.
    """
    match = re.fullmatch(r"\s*(\d+\.?\d*)\s*[xX]\s*(\d+\.?\d*)\s*", text)
    if match is None:
        raise InputError(f"sheet: expected WxH in mm, e.g. 3000x1500, got '{text[:40]}'")
    return float(match[1]), float(match[2])
