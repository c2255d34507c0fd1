"""What the user chooses about lamellas, checked on the way in."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from freecad_ortho.fabrication.sizes import check_options, check_size, size
from freecad_ortho.fabrication.systems.shared_options import (
    CLEARANCE,
    OVERHANG,
    STOCK,
    plate_thickness,
)
from freecad_ortho.fabrication.workshop import Workshop
from solver.errors import InputError
from solver.option import Option, Range

STRIPS = ("auto", "developable", "twisted")
PATTERNS = ("auto", "straight", "arc", "free")
POSITIONS = ("standing", "lying", "tilted")
BORDER_CUTS = ("square", "along")
DIAGONALS = ("none", "auto", "first", "second")
# Distance of a hole's centre from an edge, in diameters (EN 1993-1-8, table 3.3).
EDGE_DISTANCE = 1.2


@dataclass(frozen=True)
class LamellaSettings:
    """Strips of this width and thickness along the parameter lines.

    Args:
        width: of the strips, mm.
        thickness: of the plate, mm.
        clearance: added to the width and the depth of slots, and between layers, mm.
        position: "standing" normal to the surface, "lying" tangential to it, or "tilted" by the
            angle of its family, as the lines of a pseudo-geodesic net want it.
        layers: 1: half-lap slots at each crossing, family u open above, v below; 2: u above the
            surface, v below; lying ones have a bolt hole at each crossing.
        hole: diameter of the bolt holes of two layers, mm.
        overhang: beyond the last vertex, mm; by default half the width.
        strip: "developable": exact, of plane faces; "twisted": rulings square to the axis;
            "auto": developable where the rulings leave room for the width.
        pattern: "straight", "arc" or "free"; "auto": what the net allows.
        smooth: solids with smooth ruled sides instead of faceted ones.
        stock: length that lamellas are cut from, mm; longer ones are spliced between crossings with
            plates and bolts of ``hole``. None for one piece a line.
        trim: cut off at each end of that length, mm.
        saw: width of the saw cut behind a piece, mm.
        cutter: diameter of the milling cutter that slots have round corners for, in flat patterns,
            mm; None for sharp corners, as lasers and water cut them.
        cleats: angles join lamellas at their last crossings, standing ones in two layers at all of
            them, with bolts of ``hole``.
        diagonals: along which family of them a third layer lies: "first", between the sides along
            u and v, "second", or "auto", those nearer to straight; "none" without one.
        lifted: level of the middle of that layer above the net, mm; filled in.
        feet: what stands on feet, as ``Feet`` names it; filled in where these are built too.
        steel_cleats: whether cleats are of steel, as lamellas are of wood or the like; filled in.
        on_wood: whether bolts need the washers of wood; filled in.
        border_cut: at the border of the surface strips end "square" before it, or "along" it where
            that leaves their crossings room, square through the plate.

    Raises:
        InputError: a size that cannot be used, or choices that exclude each other.
    """

    width: float = 80.0
    thickness: float = 5.0
    clearance: float = 1.0
    position: str = "standing"
    layers: int = 1
    hole: float = 9.0
    overhang: float | None = None
    strip: str = "auto"
    pattern: str = "auto"
    smooth: bool = False
    stock: float | None = None
    trim: float = Workshop.trim
    saw: float = Workshop.saw
    border_cut: str = "square"
    cutter: float | None = None
    cleats: bool = False
    diagonals: str = "none"
    feet: str = ""
    lifted: float = 0.0
    steel_cleats: bool = False
    on_wood: bool = False

    options: ClassVar[tuple[Option, ...]] = (
        size("width", 80.0, "the strips are this wide"),
        plate_thickness(5.0),
        CLEARANCE,
        Option(
            "position",
            "standing",
            "choice",
            "the strips stand on the surface, lie in it, or tilt as the net wants it",
            POSITIONS,
        ),
        Option(
            "layers",
            1,
            "count",
            "one layer has slots where strips cross, two have bolt holes",
            written="1|2",
            within=Range(1, 2),
        ),
        size("hole", 9.0, "the bolt holes have this diameter"),
        OVERHANG,
        Option("strip", "auto", "choice", "the strips are made of plane faces or twisted", STRIPS),
        Option("pattern", "auto", "choice", "the axes unroll to lines of this kind", PATTERNS),
        Option("smooth", False, "flag", "the solids are smooth instead of faceted"),
        STOCK,
        Option("trim", Workshop.trim, "length", "the stock loses this much at each end"),
        Option("saw", Workshop.saw, "length", "a saw cut behind a piece is this wide"),
        Option(
            "border_cut",
            "square",
            "choice",
            "the strips end square before the border, or along it",
            BORDER_CUTS,
        ),
        Option(
            "cutter",
            None,
            "length",
            "slots have round corners for a milling cutter of this diameter",
            absent="sharp corners",
        ),
        Option("cleats", False, "flag", "angles with bolts join strips where these end"),
        Option(
            "diagonals",
            "none",
            "choice",
            "a third layer lies along these diagonals, which brace the net",
            DIAGONALS,
        ),
    )

    def __post_init__(self) -> None:
        check_options(self, self.options)
        if self.stock is not None:
            check_size("stock between its trimmed ends", self.longest)
        self._check_together()

    @property
    def longest(self) -> float:
        """Of the pieces that the stock gives, mm; infinite without stock."""
        return math.inf if self.stock is None else self.stock - 2 * self.trim - self.saw

    def _check_together(self) -> None:
        if not self.standing and self.layers == 1:
            raise InputError("layers: lying lamellas cannot cross in one layer; take layers 2")
        if self.position == "tilted" and self.layers == 2:
            raise InputError(
                "layers: tilted lamellas lean over each other in two layers; take layers 1"
            )
        if self.diagonals != "none":
            self._check_diagonals()
        if self.smooth and self.strip == "developable":
            raise InputError(
                "strip: smooth solids follow rulings square to the axis; take strip twisted"
            )
        if self.thickness >= self.width:
            raise InputError(
                f"lamella thickness: {self.thickness:g} mm is not less than the width of "
                f"{self.width:g} mm; swap them or take other sizes"
            )
        if self.layers == 1 and self.clearance >= self.width / 2:
            raise InputError(
                f"clearance: slots of half the width and {self.clearance:g} mm are deeper than "
                f"three quarters of {self.width:g} mm; take a clearance below {self.width / 2:g} mm"
            )
        if self.cleats and not self.standing:
            raise InputError(
                "cleats: lying lamellas are held by a bolt at every crossing, their last ones too; "
                "leave cleats out"
            )
        if self.feet and (self.layers == 2 or self.position != "standing"):
            raise InputError(
                "cleats: feet carry lamellas that stand in one layer, by fins beside them; take "
                "position standing and layers 1"
            )
        if (self.cleats or self.feet) and self.smooth:
            raise InputError(
                "smooth: legs of cleats lie on faceted lamellas, smooth ones leave them; leave "
                "smooth out"
            )
        if (self.cleats or self.feet) and self.width < 2 * EDGE_DISTANCE * self.hole:
            raise InputError(
                f"hole: cleats with holes of {self.hole:g} mm need lamellas at least "
                f"{2 * EDGE_DISTANCE * self.hole:.3g} mm wide, these are {self.width:g} mm; take a "
                "smaller hole or wider lamellas"
            )
        if not self.standing and self.width < 2 * EDGE_DISTANCE * self.hole:
            raise InputError(
                f"hole: {self.hole:g} mm in the middle of {self.width:g} mm is nearer to the edges "
                f"than {EDGE_DISTANCE:g} diameters; take a hole of at most "
                f"{self.width / 2 / EDGE_DISTANCE:.3g} mm"
            )

    def _check_diagonals(self) -> None:
        if self.position == "tilted" or (self.standing and self.layers == 2):
            raise InputError(
                "diagonals: a third layer lies on standing lamellas in one layer or on two lying "
                "ones; take position standing with layers 1, or position lying with layers 2"
            )
        if self.standing and self.smooth:
            raise InputError(
                "smooth: angles that hold the third layer lie on faceted lamellas, smooth ones "
                "leave them; leave smooth or diagonals out"
            )
        if self.width < 2 * EDGE_DISTANCE * self.hole:
            raise InputError(
                f"hole: {self.hole:g} mm for the third layer's bolts needs lamellas "
                f"{2 * EDGE_DISTANCE * self.hole:.3g} mm wide, these are {self.width:g} mm; take a "
                "smaller hole or wider lamellas"
            )

    @property
    def across(self) -> float:
        """How wide the section is along the surface, mm."""
        return self.thickness if self.standing else self.width

    @property
    def high(self) -> float:
        """How high it is, of all layers, mm."""
        return self.width if self.standing else self.layers * self.thickness

    @property
    def standing(self) -> bool:
        """Whether the strips stand on the surface, upright or tilted."""
        return self.position != "lying"

    def levels(self, family: str) -> tuple[float, float]:
        """Levels of the lower and upper edge along the rulings, mm from the axis."""
        if self.layers == 1 or not self.standing:
            return -self.width / 2, self.width / 2
        if family == "v":
            return -self.width - self.clearance / 2, -self.clearance / 2
        return self.clearance / 2, self.width + self.clearance / 2

    def level_of(self, family: str) -> float:
        """Distance of the axis of a lying lamella from the surface, mm; v below, all else above."""
        if self.lifted:
            return self.lifted
        return (self.thickness + self.clearance) / 2 * (-1 if family == "v" else 1)

    @property
    def reach(self) -> float:
        """Width about the axis inside which rulings must not meet, mm."""
        return 2 * max(abs(level) for level in self.levels("u"))
