"""From a mesh and settings to all parts of a structure."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from freecad_ortho.fabrication.beams import BeamGeometry, beam_geometry, beam_parts
from freecad_ortho.fabrication.panels import PanelGeometry, panel_geometry, panel_parts
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.settings import (
    STEEL_DENSITY,
    BeamSettings,
    PanelSettings,
    positive,
)
from solver.errors import InputError
from solver.mesh.quadmesh import QuadMesh
from solver.offset.axes import Axes, torsion_free_axes

if TYPE_CHECKING:
    import cadquery

Progress = Callable[[float, str], None]

# Twist above which a beam is visibly not a plane plate, degrees.
_TWIST_WORTH_SAYING = 0.01
_HEIGHT_WORTH_SAYING = 0.05
# The CAD kernel tells points apart that are 1e-7 mm from each other; far longer edges lose that.
_LONGEST_EDGE = 1e6


@dataclass(frozen=True, eq=False)
class Structure:
    """All parts: the beams in the order of the edges, then the panels in the order of the faces.

    Attributes:
        mesh: the mesh, mm.
        axes: at its vertices.
        beams: settings, None without beams.
        panels: settings, None without panels.
        density: kg/m3.
        parts: beams, then panels.
        beam_geometry: corners of the beams as arrays, relative to the mesh's mean vertex.
        panel_geometry: corners of the panels as arrays, relative to the mesh's mean vertex.
    """

    mesh: QuadMesh
    axes: Axes
    beams: BeamSettings | None
    panels: PanelSettings | None
    density: float
    parts: tuple[Part, ...]
    beam_geometry: BeamGeometry | None
    panel_geometry: PanelGeometry | None

    def compound(self, progress: Progress | None = None) -> cadquery.Compound:
        """Return one shape with the solids in the order of ``parts``, mm."""
        from freecad_ortho.fabrication.solids import compound

        return compound(self.solids(progress))

    def solids(self, progress: Progress | None = None) -> list[cadquery.Solid]:
        """Return the solids in the order of ``parts``, mm; built once."""
        result = []
        for number, part in enumerate(self.parts):
            if progress is not None and number % 64 == 0:
                progress(number / len(self.parts), f"solid {number + 1} of {len(self.parts)}")
            result.append(part.solid())
        return result

    def report(self) -> dict[str, Any]:
        """Return counts, accuracy, masses and remarks, ready for JSON; lengths in mm."""
        beams = [part for part in self.parts if part.kind == "beam"]
        panels = [part for part in self.parts if part.kind == "panel"]
        result: dict[str, Any] = {
            "unit": "mm",
            "systems": [name for name, some in (("beams", beams), ("panels", panels)) if some],
            "counts": {
                "vertices": len(self.mesh.vertices),
                "edges": len(self.mesh.connectivity.edges),
                "faces": len(self.mesh.faces),
                "beams": len(beams),
                "panels": len(panels),
            },
            "planarity_gap_max_mm": float(_diagonal_distances(self.mesh).max()),
            "lean_max_deg": float(self.axes.lean_deg.max()),
            "density_kg_m3": self.density,
            "volume_mm3": sum(part.volume for part in self.parts),
            "mass_kg": sum(part.mass for part in self.parts),
        }
        if self.beams is not None:
            result["beams"] = self._beam_report(self.beams, beams)
        if self.panels is not None:
            result["panels"] = self._panel_report(self.panels, panels)
        result["messages"] = self._messages(result)
        return result

    def _beam_report(self, settings: BeamSettings, parts: list[Part]) -> dict[str, Any]:
        assert self.beam_geometry is not None
        twist = [part.twist_deg for part in parts]
        return {
            "height_mm": settings.height,
            "thickness_mm": settings.thickness,
            "offset": settings.offset,
            "twist_max": float(self.axes.twist.max()),
            "twist_max_deg": max(twist),
            "twist_max_mm": float(self.beam_geometry.twist_mm.max()),
            "twist_worst": parts[int(np.argmax(twist))].name,
            "height_min_mm": min(part.height for part in parts),
            "height_max_mm": max(part.height for part in parts),
            "height_deviation_max": float(np.abs(self.axes.heights - 1).max()),
            **_sums(parts),
        }

    def _panel_report(self, settings: PanelSettings, parts: list[Part]) -> dict[str, Any]:
        assert self.panel_geometry is not None
        geometry = self.panel_geometry
        clear = float(geometry.clear.min())
        return {
            "thickness_mm": settings.thickness,
            "gap_mm": settings.gap,
            "offset": settings.offset if self.beams is None else "on the beams",
            "clear_gap_min_mm": clear if np.isfinite(clear) else None,
            "sides_shrunk_more": int((geometry.sides > settings.gap / 2 * (1 + 1e-9)).sum()),
            "lift_max_mm": float(geometry.lift.max()),
            **_sums(parts),
        }

    def _messages(self, report: dict[str, Any]) -> list[str]:
        messages = []
        beams, panels = report.get("beams"), report.get("panels")
        if beams and beams["twist_max_deg"] > _TWIST_WORTH_SAYING:
            messages.append(
                f"beams: {beams['twist_worst']} twists by {beams['twist_max_deg']:.3g} degrees and "
                f"leaves its plane by {beams['twist_max_mm']:.3g} mm; optimise the mesh to planar "
                "faces first"
            )
        if beams and beams["height_deviation_max"] > _HEIGHT_WORTH_SAYING:
            messages.append(
                f"beams: heights run from {beams['height_min_mm']:.1f} to "
                f"{beams['height_max_mm']:.1f} mm instead of {beams['height_mm']:g} mm; a "
                "principal net gives more even heights"
            )
        if panels and panels["sides_shrunk_more"]:
            messages.append(
                f"panels: {panels['sides_shrunk_more']} sides shrunk by more than half the gap, "
                "because the plates lean together there"
            )
        gap = report["planarity_gap_max_mm"]
        if panels and gap > 0.1:
            messages.append(
                f"panels: faces are up to {gap:.3g} mm from planar, the plates are their best "
                "planes; optimise the mesh first"
            )
        return messages


def build(
    mesh_mm: QuadMesh,
    beams: BeamSettings | None,
    panels: PanelSettings | None,
    density: float = STEEL_DENSITY,
    progress: Progress | None = None,
) -> Structure:
    """Work out all parts of a structure; the solids are built when first asked for.

    Args:
        mesh_mm: the mesh, in mm.
        beams: settings of the beams, None for none.
        panels: settings of the panels, None for none.
        density: kg/m3, of beams and panels alike.
        progress: called with a fraction and words; may raise to stop.

    Raises:
        InputError: no system asked for, a bad density, or a size that does not fit the mesh.
    """
    if beams is None and panels is None:
        raise InputError("system: expected beams, panels or both, got neither; choose one")
    positive("density", density, "kg/m3")
    _refuse_long_edges(mesh_mm)
    say = progress or (lambda fraction, words: None)
    # Near the origin no digits are lost, wherever the model is.
    centre = mesh_mm.vertices[mesh_mm.connectivity.referenced].mean(axis=0)
    mesh = mesh_mm.with_vertices(mesh_mm.vertices - centre)
    say(0.0, "axes")
    axes = torsion_free_axes(mesh)
    parts: list[Part] = []
    of_beams = of_panels = None
    if beams is not None:
        say(0.2, "beams")
        of_beams = beam_geometry(mesh, axes, beams)
        parts += beam_parts(mesh, axes, beams, of_beams, density, centre)
    if panels is not None:
        say(0.6, "panels")
        base = mesh
        if beams is not None:
            base = mesh.with_vertices(mesh.vertices + beams.levels[1] * axes.offsets)
        of_panels = panel_geometry(base, panels, of_beams)
        parts += panel_parts(mesh, panels, of_panels, density, centre)
    say(1.0, f"{len(parts)} parts")
    return Structure(mesh_mm, axes, beams, panels, density, tuple(parts), of_beams, of_panels)


def _refuse_long_edges(mesh: QuadMesh) -> None:
    longest = float(mesh.edge_lengths.max())
    if longest > _LONGEST_EDGE:
        edge = int(mesh.edge_lengths.argmax())
        first, second = mesh.connectivity.edges[edge]
        raise InputError(
            f"mesh: edge {edge} (vertices {first} and {second}) is {longest / 1e6:.3g} km long; "
            "check the unit"
        )


def _sums(parts: list[Part]) -> dict[str, float]:
    return {
        "length_mm": sum(part.length for part in parts),
        "area_mm2": sum(part.area for part in parts),
        "volume_mm3": sum(part.volume for part in parts),
        "mass_kg": sum(part.mass for part in parts),
    }


def _diagonal_distances(mesh: QuadMesh) -> Any:
    """(F,) distance between the diagonals of each face, the model's unit."""
    corner = mesh.vertices[mesh.faces]
    return np.abs(np.einsum("fk,fk->f", corner[:, 1] - corner[:, 0], mesh.face_normals))
