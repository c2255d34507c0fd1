"""What beams are told, and what follows from that alone."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Self

from freecad_ortho.fabrication.bolts import bolt_of
from freecad_ortho.fabrication.profiles import profile
from freecad_ortho.fabrication.sizes import check_options, check_size, offset_levels
from freecad_ortho.fabrication.systems.beams.ball_tubes import TubesOnBalls
from freecad_ortho.fabrication.systems.beams.end_plates import EndPlates
from freecad_ortho.fabrication.systems.beams.options import (
    OPTIONS,
    PLAIN_HUB,
    SPLICED,
)
from freecad_ortho.fabrication.systems.beams.rolled import RolledSection
from freecad_ortho.fabrication.systems.beams.sections import SECTIONS, BeamSizes, Section
from freecad_ortho.fabrication.systems.system import System
from solver.errors import InputError
from solver.option import Option


@dataclass(frozen=True)
class BeamSettings(System):
    """Beams of this height and thickness along the edges or the parameter lines.

    Args:
        height: mm between the mesh and its parallel mesh; each beam's own height follows the
            parallel mesh and differs from it by the deviation in the report.
        thickness: of the plates, the walls of tubes or the webs, mm.
        offset: along the axes the beams occupy ``[0, height]`` (above), half to each side (centre)
            or ``[-height, 0]`` (below) of the mesh.
        section: plate, hollow, I or T, or one of the catalogue (``HEB160``, ``tube:100x60x5``, see
            ``fabrication.profiles.profile``), whose height and widths then are those of the beams.
        section_width: of tubes and flanges, mm.
        flange_thickness: mm, by default that of the web.
        ends: "mitred" against each other, cut square for a "hub", for an "end-plate" bolted to one
            or for a "cover-plate" on each side bolted to a star of plates, as round tubes with a
            "cone" for the bolt into a ball, or plates along whole lines that are "lapped" where
            they cross, half from above and half from below; with "through-u" the beams of family
            u run through and the others are cut square between them, with "coped-u" along their
            sides; with "spliced-u" they are in pieces, and the others bolted to fins on them.
        splice_every: after how many nodes beams that run through are spliced, 0 for not at all.
        hub_diameter: of the hubs, across their faces, mm; by default 100, with end plates as large
            as each has to be.
        clearance: between beam and hub, between plates in slots, and beside beams that run through,
            mm.
        boundary_beams: false to leave the edges of the boundary out.
        least_length: beams that are shorter at the border of the surface are left out, mm.
        rounded: whether solids have the rounded corners and roots of a section of the catalogue;
            masses always do.
        bolt: size of the bolts of end plates and cover plates.
        bolts: above each other, 1 or 2.
        hub_wall: thickness of the walls that these clamp, mm; by default as thick as the bolts.

    Raises:
        InputError: a length that is not positive and finite, or an unknown choice.
    """

    height: float
    thickness: float
    offset: str = "centre"
    section: str = "plate"
    section_width: float = 60.0
    flange_thickness: float | None = None
    ends: str = "mitred"
    splice_every: int = 4
    hub_diameter: float | None = None
    clearance: float = 1.0
    boundary_beams: bool = True
    least_length: float = 100.0
    rounded: bool = False
    bolt: str = "M16"
    bolts: int = 2
    hub_wall: float | None = None

    trims: ClassVar[bool] = True
    name: ClassVar[str] = "beams"
    options: ClassVar[tuple[Option, ...]] = OPTIONS

    def __post_init__(self) -> None:
        check_options(self, self.options)
        if self.ends == "hub":
            check_size("hub diameter", self.across)
        if self.ends == "end-plate":
            _ = self.end_plates
        if self.ends == "cone" and self.rolled is None:
            raise InputError(
                "ends: cones of ball nodes are those of round tubes, got section "
                f"{self.section}; take one such as chs:88.9x5, or other ends"
            )
        if self.ends == "cover-plate" and self.section not in ("plate", "I", "T"):
            raise InputError(
                f"ends: cover plates join webs of plates, got section {self.section}; take section "
                "plate, I or T, or other ends"
            )
        if self.ends in ("lapped", *SPLICED) and self.section != "plate":
            can = "lapped" if self.ends == "lapped" else "folded and spliced"
            raise InputError(
                f"ends: only plates can be {can}, got section {self.section}; take section plate "
                "or other ends"
            )
        if isinstance(self.profile, Section):
            self.profile.refuse_low(self.sizes.height)

    @property
    def sizes(self) -> BeamSizes:
        """What was given, or what a section of the catalogue has."""
        if (rolled := self.rolled) is None:
            return BeamSizes(self.height, self.thickness, self.section_width)
        return BeamSizes(rolled.height, rolled.profile.wall, rolled.overall_width)

    @property
    def unheeded(self) -> tuple[str, ...]:
        """Words on each size that was given beside a section with another of its own."""
        usual = {option.name: option.default for option in self.options}
        return tuple(
            f"beams: {self.section} has a {name.replace('_', ' ')} of {own:g} mm; the "
            f"{getattr(self, name):g} mm that were given do not count"
            for name, own in self.sizes._asdict().items()
            if getattr(self, name) not in (usual[name], own)
        )

    @classmethod
    def of(cls, values: Mapping[str, Any]) -> Self:
        """Make the settings from options."""
        given = dict(values)
        given["boundary_beams"] = not given.pop("no_boundary_beams")
        return cls(**given)

    @classmethod
    def slotted(cls, values: Mapping[str, Any]) -> bool:
        """Lapped ones are, where they cross."""
        return bool(values["ends"] == "lapped")

    @property
    def levels(self) -> tuple[float, float]:
        """Lower and upper level along the axes, mm from the mesh."""
        return offset_levels(self.offset, self.sizes.height)

    @property
    def across(self) -> float:
        """Diameter of plain hubs, mm."""
        return PLAIN_HUB if self.hub_diameter is None else self.hub_diameter

    @property
    def end_plates(self) -> EndPlates:
        """BeamSizes of the end plates and their hubs.

        Raises:
            InputError: a size that cannot be used.
        """
        return EndPlates(
            bolt_of(self.bolt),
            self.bolts,
            self.profile.overall_width,
            self.clearance,
            self.hub_diameter,
            self.hub_wall,
        )

    @property
    def profile(self) -> Section | RolledSection:
        """The cross section."""
        if (rolled := self.rolled) is not None:
            return rolled
        flange = self.thickness if self.flange_thickness is None else self.flange_thickness
        return Section(self.section, self.thickness, self.section_width, flange)

    @property
    def profile_name(self) -> str:
        """Name of the catalogue's section that the cross section is, or is nearest to."""
        if isinstance(section := self.profile, Section):
            return section.catalogue_name(self.height)
        return self.section

    @property
    def rolled(self) -> RolledSection | None:
        """The section where it is one of the catalogue."""
        if self.section in SECTIONS:
            return None
        if self.section.isalpha():
            raise InputError(
                f"section: expected {', '.join(SECTIONS)} or one of the catalogue such as HEB160 "
                f"or tube:100x60x5, got '{self.section}'"
            )
        section = RolledSection(profile(self.section), self.rounded)
        return TubesOnBalls.of(section) if self.ends == "cone" else section
