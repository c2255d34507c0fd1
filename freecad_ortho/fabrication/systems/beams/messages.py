"""What is said about beams that are not as one expects."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from freecad_ortho.fabrication.part import Part, part_names
from freecad_ortho.fabrication.stock import different_tubes
from freecad_ortho.fabrication.systems.beams.cover_plates import CoverPlates
from solver.mesh.quadmesh import FloatArray

# Twist above which a beam is visibly not a plane plate, degrees.
_TWIST_WORTH_SAYING = 0.01
_HEIGHT_WORTH_SAYING = 0.05
# Heights of hot finished sections are rolled to 1 % (EN 10210-2, table 4).
_ROLLED_TO = 0.01


def remarks(report: Mapping[str, Any], parts: Sequence[Part]) -> tuple[str, ...]:
    """What is out of the ordinary of beams, by their section of the report."""
    found = []
    if report["twist_max_deg"] > _TWIST_WORTH_SAYING:
        found.append(
            f"beams: {report['twist_worst']} twists by {report['twist_max_deg']:.3g} degrees and "
            f"leaves its plane by {report['twist_max_mm']:.3g} mm; optimise the mesh to planar "
            "faces first"
        )
    misfit = report.get("misfit_max_mm")
    if misfit is not None and misfit > _ROLLED_TO * report["height_mm"]:
        found.append(
            f"beams: upper sides of {report['section']} meet, lower sides lie up to "
            f"{misfit:.1f} mm apart, at {report['misfit_worst']}; a principal net gives more even "
            "heights"
        )
    if misfit is None and report["height_deviation_max"] > _HEIGHT_WORTH_SAYING:
        found.append(
            f"beams: heights run from {report['height_min_mm']:.1f} to "
            f"{report['height_max_mm']:.1f} mm instead of {report['height_mm']:g} mm; a "
            "principal net gives more even heights"
        )
    tubes = different_tubes(parts)
    if len(tubes) > 1:
        heights = ", ".join(
            f"{len(group)} of {group[0].width:.1f} to {group[-1].width:.1f}" for group in tubes
        )
        found.append(
            f"beams: {len(tubes)} different tubes, by their height in mm: {heights}; a net of "
            "constant height needs one"
        )
    return tuple(found)


def smaller_bolts(joints: object, wanted: str, ends: int) -> tuple[str, ...]:
    """A message where webs had no room for the bolts that were wanted at so many ends of beams."""
    if not isinstance(joints, CoverPlates) or joints.bolt.name == wanted:
        return ()
    return (
        f"beams: the lowest web is {joints.low:.1f} mm high and has no room for {joints.count} of "
        f"{wanted} above each other, so all {ends} bolted ends have {joints.bolt.name}; higher "
        f"beams have {wanted}",
    )


def misfit_report(misfit: FloatArray) -> dict[str, Any]:
    """How far lower sides lie apart at most, (V,) mm, and where."""
    worst = int(misfit.argmax())
    names = part_names("N", len(misfit))
    return {"misfit_max_mm": float(misfit[worst]), "misfit_worst": names[worst]}
