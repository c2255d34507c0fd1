"""The system of panels: settings, parts and report."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.sizes import OFFSETS, check_offset, check_size, offset_levels
from freecad_ortho.fabrication.systems.beams.frames import beam_frames
from freecad_ortho.fabrication.systems.panels.geometry import (
    PanelGeometry,
    panel_geometry,
)
from freecad_ortho.fabrication.systems.panels.parts import panel_parts
from freecad_ortho.fabrication.systems.system import System, SystemParts, sums
from freecad_ortho.option import Option
from solver.analysis.measures import diagonal_distances
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray, QuadMesh

EDGES = ("square", "bevel")

# Distance between diagonals above which a face is visibly not planar, mm.
_GAP_WORTH_SAYING = 0.1
# Mean height of the faces' unit normals from which on a net has an upper and a lower side.
_CLEARLY = 0.2


@dataclass(frozen=True)
class Panels(System):
    """A plate of this thickness in every face.

    Args:
        thickness: plate thickness, mm.
        gap: joint between neighbours measured on the mesh, mm; each side shrinks by half of it.
        offset: along the face normal the panels occupy ``[0, thickness]`` (above), half to each
            side (centre) or ``[-thickness, 0]`` (below); with beams they lie on top instead.
        edge: "square" to the panel, or "bevel": parallel to the beams, towards the node axes.

    Raises:
        InputError: a length that is not positive and finite, or an unknown offset.
    """

    thickness: float
    gap: float
    offset: str = "centre"
    edge: str = "square"

    name: ClassVar[str] = "panels"
    options: ClassVar[tuple[Option, ...]] = (
        Option("thickness", 12.0, "length", "the plates are this thick"),
        Option(
            "panel_thickness",
            None,
            "length",
            "the panels are this thick, by default as thick as the plates",
        ),
        Option("gap", 10.0, "length", "the joint between two panels is this wide"),
        Option(
            "offset",
            "centre",
            "choice",
            "the parts lie above the net, about it or below it",
            OFFSETS,
        ),
        Option(
            "panel_edge",
            "square",
            "choice",
            "the sides of the panels are square, or bevelled along the beams",
            EDGES,
        ),
    )

    def __post_init__(self) -> None:
        check_size("panel thickness", self.thickness)
        check_size("gap", self.gap)
        check_offset(self.offset)
        if self.edge not in EDGES:
            raise InputError(f"panel edge: expected one of {', '.join(EDGES)}, got '{self.edge}'")

    @classmethod
    def of(cls, values: Mapping[str, Any]) -> Panels:
        """Make the settings from options; panels are as thick as the beams unless told."""
        plate = values["panel_thickness"]
        plate = values["thickness"] if plate is None else plate
        return cls(plate, values["gap"], values["offset"], values["panel_edge"])

    @property
    def levels(self) -> tuple[float, float]:
        """Lower and upper level along the face normal, mm from the mesh."""
        return offset_levels(self.offset, self.thickness)

    def build(self, site: Site) -> SystemParts:
        """Work out the panels, on the beams where there are some.

        Raises:
            InputError: a face that the gap leaves nothing of.
        """
        mesh, beams = site.mesh, None
        if "beams" in site.done:
            beams = site.done["beams"].geometry
            mesh = mesh.with_vertices(mesh.vertices + beams.levels[1] * site.axes.offsets)
        inward = _inward(site) if self.edge == "bevel" else None
        geometry = panel_geometry(mesh, self.levels, self.gap, beams, inward)
        gaps = diagonal_distances(site.mesh)
        parts = panel_parts(site, geometry, self.thickness, gaps)
        report = self._report(geometry, parts, beams is not None)
        messages = _messages(report, float(gaps.max()))
        if beams is not None and _faces_down(site.mesh):
            messages += (
                "panels: they lie under the beams, because the upper side of the net faces down; "
                "turn it over (Flip net, or orient on the command line)",
            )
        return SystemParts(parts, report, messages, geometry)

    def _report(
        self, geometry: PanelGeometry, parts: tuple[Part, ...], on_beams: bool
    ) -> dict[str, Any]:
        clear = float(geometry.clear.min())
        return {
            "thickness_mm": self.thickness,
            "gap_mm": self.gap,
            "offset": "on the beams" if on_beams else self.offset,
            "clear_gap_min_mm": clear if np.isfinite(clear) else None,
            "edge": self.edge,
            "sides_shrunk_more": int((geometry.sides > self.gap / 2 * (1 + 1e-9)).sum())
            if self.edge == "square"
            else 0,
            "lift_max_mm": float(geometry.lift.max()),
            **sums(parts),
        }


def _faces_down(mesh: QuadMesh) -> bool:
    """Tell whether the upper side faces down; a wall or a closed shape has none that does."""
    areas = mesh.face_area_vectors
    return float(areas[:, 2].sum()) < -_CLEARLY * float(np.linalg.norm(areas, axis=1).sum())


def _inward(site: Site) -> FloatArray:
    """(F, 4, 3) normals of the beams' planes at the sides of each face, into the face."""
    net = site.mesh.connectivity
    left = beam_frames(site.mesh, site.axes).left[net.face_edges]
    on_left = net.edge_faces[net.face_edges, 0] == np.arange(len(net.faces))[:, None]
    return np.where(on_left[:, :, None], left, -left)


def _messages(report: dict[str, Any], gap: float) -> tuple[str, ...]:
    messages = []
    if report["sides_shrunk_more"]:
        messages.append(
            f"panels: {report['sides_shrunk_more']} sides shrunk by more than half the gap, "
            "because the plates lean together there"
        )
    if gap > _GAP_WORTH_SAYING:
        messages.append(
            f"panels: faces are up to {gap:.3g} mm from planar, the plates are their best "
            "planes; optimise the mesh first"
        )
    return tuple(messages)
