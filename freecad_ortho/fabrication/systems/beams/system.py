"""The system of beams: settings, parts and report."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.sizes import OFFSETS, check_offset, check_size, offset_levels
from freecad_ortho.fabrication.systems.beams.geometry import BeamGeometry, beam_geometry
from freecad_ortho.fabrication.systems.beams.parts import beam_parts
from freecad_ortho.fabrication.systems.system import Option, System, SystemParts, sums

# Twist above which a beam is visibly not a plane plate, degrees.
_TWIST_WORTH_SAYING = 0.01
_HEIGHT_WORTH_SAYING = 0.05


@dataclass(frozen=True)
class Beams(System):
    """A plate of this height and thickness along every edge.

    Args:
        height: mm between the mesh and its parallel mesh; each beam's own height follows the
            parallel mesh and differs from it by the deviation in the report.
        thickness: plate thickness, mm.
        offset: along the axes the beams occupy ``[0, height]`` (above), half to each side (centre)
            or ``[-height, 0]`` (below) of the mesh.

    Raises:
        InputError: a length that is not positive and finite, or an unknown offset.
    """

    height: float
    thickness: float
    offset: str = "centre"

    name: ClassVar[str] = "beams"
    options: ClassVar[tuple[Option, ...]] = (
        Option("height", 200.0, "of the beams"),
        Option("thickness", 12.0, "of the plates"),
        Option("offset", "centre", "where the plates lie", str, "|".join(OFFSETS)),
    )

    def __post_init__(self) -> None:
        check_size("beam height", self.height)
        check_size("beam thickness", self.thickness)
        check_offset(self.offset)

    @property
    def levels(self) -> tuple[float, float]:
        """Lower and upper level along the axes, mm from the mesh."""
        return offset_levels(self.offset, self.height)

    def build(self, site: Site) -> SystemParts:
        """Work out the beams on the chosen edges.

        Raises:
            InputError: an edge without length, or a height or thickness that does not fit an edge.
        """
        geometry = beam_geometry(site.mesh, site.axes, self.levels, self.thickness)
        parts = beam_parts(site, geometry, self.thickness)
        report = self._report(site, geometry, parts)
        return SystemParts(parts, report, _messages(report), geometry)

    def _report(
        self, site: Site, geometry: BeamGeometry, parts: tuple[Part, ...]
    ) -> dict[str, Any]:
        chosen = site.chosen_edges
        twist = np.where(chosen, site.axes.twist, -1.0)
        heights = geometry.height[chosen]
        return {
            "height_mm": self.height,
            "thickness_mm": self.thickness,
            "offset": self.offset,
            "twist_max": float(twist.max()),
            "twist_max_deg": max(part.measures.twist_deg or 0.0 for part in parts),
            "twist_max_mm": float(geometry.twist_mm[chosen].max()),
            "twist_worst": parts[int(np.argmax(twist[chosen]))].name,
            "height_min_mm": float(heights.min()),
            "height_max_mm": float(heights.max()),
            "height_deviation_max": float(np.abs(site.axes.heights[chosen] - 1).max()),
            **sums(parts),
        }


def _messages(report: dict[str, Any]) -> tuple[str, ...]:
    messages = []
    if report["twist_max_deg"] > _TWIST_WORTH_SAYING:
        messages.append(
            f"beams: {report['twist_worst']} twists by {report['twist_max_deg']:.3g} degrees and "
            f"leaves its plane by {report['twist_max_mm']:.3g} mm; optimise the mesh to planar "
            "faces first"
        )
    if report["height_deviation_max"] > _HEIGHT_WORTH_SAYING:
        messages.append(
            f"beams: heights run from {report['height_min_mm']:.1f} to "
            f"{report['height_max_mm']:.1f} mm instead of {report['height_mm']:g} mm; a "
            "principal net gives more even heights"
        )
    return tuple(messages)
