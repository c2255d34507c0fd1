"""The system of beams: settings, parts and report."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np

from freecad_ortho.fabrication.bolts import bolt_of
from freecad_ortho.fabrication.part import Part, part_names
from freecad_ortho.fabrication.profiles import profile
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.sizes import check_options, check_size, offset_levels
from freecad_ortho.fabrication.systems.beams.ball_tubes import TubesOnBalls, with_tubes
from freecad_ortho.fabrication.systems.beams.balls import BallJoints, smallest_angles
from freecad_ortho.fabrication.systems.beams.border import BorderEnds, stub_words
from freecad_ortho.fabrication.systems.beams.cover_plates import CoverPlates
from freecad_ortho.fabrication.systems.beams.end_plates import EndPlates
from freecad_ortho.fabrication.systems.beams.fins import FinPlates, runs_through
from freecad_ortho.fabrication.systems.beams.frames import Around, Frames, around_axes, beam_frames
from freecad_ortho.fabrication.systems.beams.geometry import (
    BeamGeometry,
    Cuts,
    beam_geometry,
    clear_of_through,
    coped,
    hub_distance,
    mitred,
    square,
)
from freecad_ortho.fabrication.systems.beams.lines import Crossings, chosen_runs, half_laps
from freecad_ortho.fabrication.systems.beams.messages import misfit_report, remarks, smaller_bolts
from freecad_ortho.fabrication.systems.beams.options import (
    COPED,
    OPTIONS,
    PLAIN_HUB,
    SPLICED,
)
from freecad_ortho.fabrication.systems.beams.parts import edge_beams, line_beams
from freecad_ortho.fabrication.systems.beams.rolled import RolledSection
from freecad_ortho.fabrication.systems.beams.running import Running
from freecad_ortho.fabrication.systems.beams.sections import SECTIONS, BeamSizes, Section
from freecad_ortho.fabrication.systems.beams.spliced_parts import SplicedBeams
from freecad_ortho.fabrication.systems.beams.web_holes import refuse_short
from freecad_ortho.fabrication.systems.edge_beam.hubs import without_hubs
from freecad_ortho.fabrication.systems.system import System, SystemParts, sums
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray
from solver.mesh.lines import ParameterLines
from solver.mesh.quadmesh import FloatArray
from solver.option import Option

Bolted = EndPlates | CoverPlates | BallJoints


@dataclass(frozen=True)
class Beams(System):
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
        if self.ends == "cone" and self._rolled is None:
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
        if (rolled := self._rolled) is None:
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
    def of(cls, values: Mapping[str, Any]) -> Beams:
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

    def build(self, site: Site) -> SystemParts:
        """Work out the beams on the chosen edges and lines.

        Raises:
            InputError: sizes that do not fit the net, or a net whose faces are not planar or whose
                lines have no families where that is needed.
        """
        if not self.boundary_beams:
            # Lines that run on along the border would be left with gaps.
            site = replace(site, lines=ParameterLines(site.mesh.connectivity))
        section = self.profile
        rolled = section if isinstance(section, RolledSection) else None
        if rolled is not None:
            site = replace(site, material=rolled.material(site.material))
        frames = beam_frames(site.mesh, site.axes)
        built = np.ones(len(site.mesh.connectivity.edges), dtype=bool)
        if not self.boundary_beams:
            built = ~site.mesh.connectivity.boundary_edges
        border = BorderEnds.of(site, frames, self.levels, section.overall_width / 2)
        if border is not None:
            built &= border.within
        wanted = site.chosen_edges & built
        if not wanted.any():
            return SystemParts(())
        around = around_axes(site.mesh, site.axes, frames.along, built)
        bolted = self._bolted(site, frames, built)
        cuts, folded, laps = self._cuts(site, frames, around, built, bolted)
        width = section.overall_width
        stubs: tuple[str, ...] = ()
        if border is not None:
            left = border.lengths(site.mesh.edge_lengths, cuts, width / 2)
            short = built & border.cut.any(axis=1) & (left < self.least_length)
            names = part_names("B", len(built))
            stubs = tuple(names[edge] for edge in np.flatnonzero(short & wanted))
            built, wanted = built & ~short, wanted & ~short
            border = replace(border, cut=border.cut & built[:, None])
            around = around_axes(site.mesh, site.axes, frames.along, built)
            cuts, folded, laps = self._cuts(site, frames, around, built, bolted)
            cuts = cuts.where(np.stack([built, built], axis=1), square(frames, 0 * frames.slope))
            frames, cuts = border.applied(frames, cuts, site.mesh.edge_lengths, width / 2)
        geometry = beam_geometry(site.mesh, self.levels, width, frames, cuts, wanted)
        meeting = wanted[:, None] & ~(np.zeros(2, bool) if border is None else border.cut)
        if isinstance(bolted, FinPlates):
            meeting &= ~bolted.running.ends
        geometry = replace(geometry, meeting=meeting, bolted=bolted)
        if bolted is not None:
            geometry = replace(geometry, hub_radii=_hub_radii(site, around, bolted))
        if isinstance(section, Section):
            refuse_short(geometry, section, site.mesh.connectivity.edges)
        misfit = None
        if rolled is not None:
            misfit = rolled.misfit(site, geometry, meeting)
            geometry = replace(geometry, height=np.full_like(geometry.height, rolled.height))
            if isinstance(bolted, BallJoints):
                geometry = with_tubes(geometry, rolled.height, site.mesh.connectivity.edges)
        parts = edge_beams(site, geometry, section, wanted & ~folded, border, misfit)
        broken = None if border is None else border.cut
        if isinstance(bolted, FinPlates):
            broken = ~bolted.running.ends | (False if broken is None else broken)
        lines = chosen_runs(site, folded & built, broken)
        if isinstance(bolted, FinPlates):
            assert isinstance(section, Section)
            making = SplicedBeams(site, geometry, section, bolted, border)
            folded_parts, splices = making.made(lines, self.splice_every)
            geometry = replace(geometry, folded=making.names)
            geometry, doubts = replace(geometry, splices=splices), list[str]()
        else:
            folded_parts, doubts = line_beams(
                site, geometry, self.sizes.thickness, lines, laps, border
            )
        parts += folded_parts
        report = self._report(site, geometry, parts, wanted)
        report |= {} if misfit is None else misfit_report(misfit)
        if border is not None:
            report |= {"trimmed": int(border.cut[wanted].any(axis=1).sum()), "left_out": stubs}
            doubts += stub_words(stubs, self.least_length)
        doubts += smaller_bolts(bolted, self.bolt, int(geometry.meeting.sum()))
        messages = (*remarks(report, parts), *self.unheeded, *doubts)
        return SystemParts(parts, report, messages, geometry)

    @property
    def profile(self) -> Section | RolledSection:
        """The cross section."""
        if (rolled := self._rolled) is not None:
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
    def _rolled(self) -> RolledSection | None:
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

    def _cuts(
        self,
        site: Site,
        frames: Frames,
        around: Around,
        built: BoolArray,
        bolted: Bolted | None,
    ) -> tuple[Cuts, BoolArray, Crossings | None]:
        """Where beams end, which edges are parts of folded plates, and their half laps."""
        width = self.profile.overall_width
        none, all_edges = np.zeros(len(built), dtype=bool), np.ones(len(built), dtype=bool)
        if self.ends == "mitred":
            return mitred(frames, around), none, None
        if self.ends == "hub":
            distance = self.across / 2 + self.clearance
            cuts = square(frames, hub_distance(site.mesh, around, width, distance))
            hubs = ~without_hubs(site, self.across)[site.mesh.connectivity.edges]
            return cuts.where(hubs, mitred(frames, around)), none, None
        if bolted is not None and not isinstance(bolted, FinPlates):
            radii = _hub_radii(site, around, bolted)[site.mesh.connectivity.edges]
            cuts = square(frames, radii + bolted.setback)
            if isinstance(bolted, BallJoints):
                cuts = Cuts(radii + bolted.setback, 0 * cuts.slope)
            return cuts.where(radii > 0, mitred(frames, around)), none, None
        if self.ends == "lapped":
            laps = half_laps(site, around, self.sizes.thickness, self.clearance)
            return mitred(frames, around), all_edges, laps
        gaps = clear_of_through(around, width, self.clearance)
        if isinstance(bolted, FinPlates):
            edges, runs = site.mesh.connectivity.edges, bolted.running.ends
            radii = _hub_radii(site, around, bolted)[edges]
            cuts = square(frames, np.where(radii > 0, radii + bolted.setback, gaps))
            cuts = cuts.where((radii > 0) | ~bolted.running.stars[edges], mitred(frames, around))
            cuts = square(frames, 0 * gaps).where(runs, cuts)
            return cuts, np.asarray(runs.any(axis=1)), None
        through = runs_through(site.lines, self.ends)
        alone = around_axes(site.mesh, site.axes, frames.along, built & through)
        others = square(frames, gaps)
        if self.ends in COPED:
            others = coped(frames, around, through, width, self.clearance)
        cuts = mitred(frames, alone).where(np.stack([through, through], axis=1), others)
        return cuts, through if self.section == "plate" else none, None

    def _bolted(self, site: Site, frames: Frames, built: BoolArray) -> Bolted | None:
        """How the beams of edges that are built, (E,), are bolted; None where they are not."""
        if self.ends == "end-plate":
            return self.end_plates
        section, bolt, sizes = self.profile, bolt_of(self.bolt), self.sizes
        if self.ends == "cone":
            edges, count = site.mesh.connectivity.edges, len(site.mesh.vertices)
            apart = smallest_angles(frames.along, edges, built, count)
            return BallJoints(bolt, sizes.height, sizes.thickness, apart, self.hub_diameter)
        if self.ends not in ("cover-plate", *SPLICED) or isinstance(section, RolledSection):
            return None
        rise = frames.rise[built]
        plates = (
            *(bolt, self.bolts, sizes.thickness, section.overall_width, self.clearance),
            float(sizes.height * rise.min()) - sum(section.flanges),
            float(np.abs(frames.slope[built] / rise[:, None]).max()),
            self.hub_diameter,
        )
        if self.ends in SPLICED:
            return FinPlates(*plates, running=Running.of(site.lines, self.ends))
        return CoverPlates(*plates)

    def _report(
        self, site: Site, geometry: BeamGeometry, parts: tuple[Part, ...], chosen: BoolArray
    ) -> dict[str, Any]:
        heights = geometry.height[chosen]
        return {
            "height_mm": self.sizes.height,
            "thickness_mm": self.sizes.thickness,
            "offset": self.offset,
            "section": self.profile.name or self.section,
            "ends": self.ends,
            "clearance_mm": self.clearance,
            "twist_max": float(site.axes.twist[chosen].max()),
            "twist_max_deg": max(part.measures.twist_deg or 0.0 for part in parts),
            "twist_max_mm": float(geometry.twist_mm[chosen].max()),
            "twist_worst": max(parts, key=lambda part: part.measures.twist_deg or 0.0).name,
            "height_min_mm": float(heights.min()),
            "height_max_mm": float(heights.max()),
            "not_put_on": sum(bool(part.assembly) for part in parts),
            "height_deviation_max": float(np.abs(site.axes.heights[chosen] - 1).max()),
            **sums(parts),
        }


def _hub_radii(site: Site, around: Around, bolted: Bolted) -> FloatArray:
    """(V,) from the axes to what beams are bolted to, mm; 0 where there is nothing."""
    radii = bolted.radii(around, len(site.mesh.vertices))
    left_out = without_hubs(site, 2 * (radii + bolted.setback))
    return np.where(left_out, 0.0, radii)
