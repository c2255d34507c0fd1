"""The system of edge beams: settings, parts and report."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np

from freecad_ortho.fabrication.profiles import Profile, names, profile
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.sizes import (
    check_options,
    offset_levels,
    size,
)
from freecad_ortho.fabrication.systems.edge_beam.geometry import EdgeGeometry, edge_geometry
from freecad_ortho.fabrication.systems.edge_beam.parts import bends, edge_parts
from freecad_ortho.fabrication.systems.edge_beam.path import joints_of, paths_of
from freecad_ortho.fabrication.systems.edge_beam.rolled import RolledEdge
from freecad_ortho.fabrication.systems.edge_beam.rulings import SHEET
from freecad_ortho.fabrication.systems.edge_beam.sections import SECTIONS, EdgeSection
from freecad_ortho.fabrication.systems.edge_beam.strip import strip_parts
from freecad_ortho.fabrication.systems.shared_options import (
    CLEARANCE,
    HEIGHT,
    OFFSET,
    ROUNDED,
    STOCK,
    plate_thickness,
)
from freecad_ortho.fabrication.systems.system import System, SystemParts, sums
from freecad_ortho.words import counted
from solver.errors import InputError
from solver.option import Option

# Pieces are at least this long, mm, and twice as long as wide.
_LEAST = 100.0
_STANDS = "would run through the edge beam; build them one after the other"


@dataclass(frozen=True)
class EdgeBeam(System):
    """A beam along the border of the surface, or of a net that has none: its upper side on the net.

    It is made of straight pieces, mitred where they meet: at the edges of the net, where the border
    turns, and where it would leave a piece by more than half its width. A strip is bent there.

    Args:
        section: plate, tube, round or strip, or one of the catalogue, which has sizes of its own.
        section_height: mm; by default as high as the beams; a round tube is as high as wide.
        width: mm; by default a plate or strip is as thick as the plates, a tube 60 mm wide.
        wall: of tubes, mm.
        height: of the beams that end at it, mm.
        thickness: of the plates, mm.
        offset: of the beams.
        clearance: that they leave before it, mm.
        stock: longer pieces are cut into equal lengths, mm; strips are 6 m long by default.
        rounded: solids have the rounded corners and roots of a section of the catalogue; masses
            always do.

    Raises:
        InputError: a length that is not positive and finite, or an unknown choice.
    """

    section: str = "plate"
    section_height: float | None = None
    width: float | None = None
    wall: float = 5.0
    height: float = 200.0
    thickness: float = 20.0
    offset: str = "centre"
    clearance: float = 1.0
    stock: float | None = None
    rounded: bool = False

    trims: ClassVar[bool] = True
    name: ClassVar[str] = "edge-beam"
    excludes: ClassVar[Mapping[str, str]] = dict.fromkeys(
        ("louvres", "bent-panels", "patches"), _STANDS
    )
    options: ClassVar[tuple[Option, ...]] = (
        Option(
            "edge_section",
            "plate",
            "choice",
            "the edge beam has this cross section, or one of the catalogue such as HEB160",
            SECTIONS,
            examples=names(),
        ),
        Option(
            "edge_height",
            None,
            "length",
            "the edge beam is this high, by default as high as the beams",
        ),
        Option(
            "edge_width",
            None,
            "length",
            "the edge beam is this wide, by default as thick as the plates or 60 mm",
        ),
        size("edge_wall", 5.0, "the walls of a tube along the edge are this thick"),
        HEIGHT,
        plate_thickness(20.0),
        OFFSET,
        CLEARANCE,
        STOCK,
        ROUNDED,
    )

    def __post_init__(self) -> None:
        check_options(
            self,
            self.options,
            section="edge_section",
            section_height="edge_height",
            width="edge_width",
            wall="edge_wall",
        )
        _ = self.profile

    @classmethod
    def of(cls, values: Mapping[str, Any]) -> EdgeBeam:
        """Make the settings from options."""
        given = dict(values)
        words = {"section": "section", "section_height": "height", "width": "width", "wall": "wall"}
        return cls(**{own: given.pop(f"edge_{word}") for own, word in words.items()}, **given)

    def beside(self, others: Mapping[str, System]) -> EdgeBeam:
        """The same at the level of the beams or lamellas that it is built with, in the middle."""
        beams, lamellas = others.get("beams"), others.get("lamellas")
        if beams is None and lamellas is not None:
            return replace(self, height=getattr(lamellas, "high", self.height), offset="centre")
        # A section of the catalogue has a height of its own.
        height = getattr(getattr(beams, "sizes", None), "height", self.height)
        return replace(self, height=height, offset=getattr(beams, "offset", self.offset))

    @property
    def profile(self) -> EdgeSection:
        """The cross section.

        Raises:
            InputError: sizes or a name that make no section.
        """
        if self.section not in SECTIONS:
            return RolledEdge.of(self._bought, self.rounded)
        width = self.width
        if width is None:
            width = self.thickness if self.section in ("plate", "strip") else 60.0
        height = self.height if self.section_height is None else self.section_height
        if self.section == "round":
            height = width
        return EdgeSection(self.section, height, width, self.wall)

    @property
    def _bought(self) -> Profile:
        """The section of the catalogue."""
        if self.section.isalpha():
            raise InputError(
                f"edge section: expected {', '.join(SECTIONS)} or one of the catalogue such as "
                f"HEB160 or tube:100x60x5, got '{self.section}'"
            )
        return profile(self.section)

    def build(self, site: Site) -> SystemParts:
        """Work out the pieces.

        Raises:
            InputError: a width that does not fit the border.
        """
        section = self.profile
        if isinstance(section, RolledEdge):
            site = replace(site, material=section.bought.made_of(site.material))
        least = max(_LEAST, 2 * section.width)
        ways = [(path, joints_of(path, least, section.width / 2)) for path in paths_of(site)]
        # Fewer than three pieces do not go round.
        kept = [(path, joints) for path, joints in ways if len(joints) > 2]
        if not kept:
            return SystemParts(())
        top = offset_levels(self.offset, self.height)[1]
        sizes = section.width, section.height, top, self.clearance
        bent = section.kind == "strip"
        stock = (self.stock or SHEET) if bent else None
        geometry = edge_geometry(site, kept, *sizes, stock=stock)
        report = self._report(geometry, section)
        if bent:
            parts, table, of_strips = strip_parts(site, geometry, section)
            report |= of_strips
        else:
            parts, table = edge_parts(site, geometry, section, self.stock)
        report |= sums(parts)
        messages = []
        if len(kept) < len(ways):
            messages.append(
                f"edge-beam: none along {counted(len(ways) - len(kept), 'opening')}, too small for "
                f"pieces of {least:g} mm; take a narrower edge beam"
            )
        return SystemParts(parts, report, tuple(messages), geometry, tables=(table,))

    def _report(self, geometry: EdgeGeometry, section: EdgeSection) -> dict[str, Any]:
        angles = bends(geometry)
        return {
            "section": section.words,
            "ways": int(geometry.way.max()) + 1,
            "pieces": len(geometry.length),
            "piece_min_mm": float(geometry.length.min()),
            "piece_max_mm": float(geometry.length.max()),
            "bend_max_deg": float(angles[:, 0].max()),
            "lowered_max_mm": float(geometry.drop.max()),
            "bends": [np.round(row, 3).tolist() for row in angles],
        }
