"""The system of beams: parts and report."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.beams.border import stub_words
from freecad_ortho.fabrication.systems.beams.fins import FinPlates
from freecad_ortho.fabrication.systems.beams.geometry import BeamGeometry, NoRoom
from freecad_ortho.fabrication.systems.beams.laying_out import LaidOut, laid_out
from freecad_ortho.fabrication.systems.beams.lines import chosen_runs
from freecad_ortho.fabrication.systems.beams.messages import misfit_report, remarks, smaller_bolts
from freecad_ortho.fabrication.systems.beams.parts import edge_beams, line_beams
from freecad_ortho.fabrication.systems.beams.room import what_helps
from freecad_ortho.fabrication.systems.beams.sections import Section
from freecad_ortho.fabrication.systems.beams.settings import BeamSettings
from freecad_ortho.fabrication.systems.beams.spliced_parts import SplicedBeams
from freecad_ortho.fabrication.systems.system import SystemParts, sums
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray
from solver.mesh.lines import ParameterLines


@dataclass(frozen=True)
class Beams(BeamSettings):
    """Beams of this height and thickness along the edges or the parameter lines.

    Settings are those of ``BeamSettings``.
    """

    def build(self, site: Site) -> SystemParts:
        """Work out the beams on the chosen edges and lines.

        Raises:
            InputError: sizes that do not fit the net, or a net whose faces are not planar or whose
                lines have no families where that is needed.
        """
        if not self.boundary_beams:
            # Lines that run on along the border would be left with gaps.
            site = replace(site, lines=ParameterLines(site.mesh.connectivity))
        if (rolled := self.rolled) is not None:
            site = replace(site, material=rolled.material(site.material))
        try:
            laid = laid_out(self, site)
        except NoRoom as refusal:

            def fits(change: dict[str, Any]) -> bool:
                try:
                    laid_out(replace(self, **change), site)
                except InputError:
                    return False
                return True

            given = {"thickness": self.sizes.thickness, "hub_diameter": self.hub_diameter}
            if self.ends == "hub":
                given["hub_diameter"] = self.across
            help_words = what_helps({**vars(self), **given}, fits)
            raise InputError(f"{refusal}; {help_words}") from None
        return SystemParts(()) if laid is None else self._made(site, laid)

    def _made(self, site: Site, laid: LaidOut) -> SystemParts:
        """Parts, report and messages of beams that have room."""
        section, geometry, border, misfit = self.profile, laid.geometry, laid.border, laid.misfit
        wanted, folded, bolted = laid.wanted, laid.folded, geometry.bolted
        parts = edge_beams(site, geometry, section, wanted & ~folded, border, misfit)
        broken = None if border is None else border.cut
        if isinstance(bolted, FinPlates):
            broken = ~bolted.running.ends | (False if broken is None else broken)
        lines = chosen_runs(site, folded & laid.built, broken)
        if isinstance(bolted, FinPlates):
            assert isinstance(section, Section)
            making = SplicedBeams(site, geometry, section, bolted, border)
            folded_parts, splices = making.made(lines, self.splice_every)
            geometry = replace(geometry, folded=making.names)
            geometry, doubts = replace(geometry, splices=splices), list[str]()
        else:
            folded_parts, doubts = line_beams(
                site, geometry, self.sizes.thickness, lines, laid.laps, border
            )
        parts += folded_parts
        report = self._report(site, geometry, parts, wanted)
        report |= {} if misfit is None else misfit_report(misfit)
        if border is not None:
            report |= {
                "trimmed": int(border.cut[wanted].any(axis=1).sum()),
                "left_out": laid.stubs,
            }
            doubts += stub_words(laid.stubs, self.least_length)
        doubts += smaller_bolts(bolted, self.bolt, int(geometry.meeting.sum()))
        messages = (*remarks(report, parts), *self.unheeded, *doubts)
        return SystemParts(parts, report, messages, geometry)

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
