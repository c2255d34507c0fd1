"""What is to be said of panels, in plain words."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, Protocol

import numpy as np

from freecad_ortho.fabrication.material import Material
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.systems.panels.geometry import PanelGeometry
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import FloatArray, QuadMesh

# Distance between diagonals above which a face is visibly not planar, mm.
_GAP_WORTH_SAYING = 0.1
# Mean height of the faces' unit normals from which on a net has an upper and a lower side.
_CLEARLY = 0.2
UNDER_BEAMS = (
    "panels: they lie under the beams, because the upper side of the net faces down; turn it over "
    "(Flip net, or orient on the command line)"
)


class PanelSettings(Protocol):
    """What a report repeats of the settings of panels."""

    @property
    def thickness(self) -> float:
        """Of the plates, mm."""

    @property
    def joint(self) -> float:
        """Between neighbours, mm."""

    @property
    def offset(self) -> str:
        """Where they lie without beams."""

    @property
    def edge(self) -> str:
        """How their sides are cut."""


def report_of(
    settings: PanelSettings,
    geometry: PanelGeometry,
    made: BoolArray,
    bearing: FloatArray | None,
    parts: Sequence[Part],
) -> dict[str, Any]:
    """What is reported of panels in faces (F,) that have one, with their least bearings (F,)."""
    on_beams = bearing is not None
    clear = float(geometry.clear[made].min())
    return {
        "thickness_mm": settings.thickness,
        "gap_mm": settings.joint,
        "offset": "on the beams" if on_beams else settings.offset,
        "clear_gap_min_mm": clear if np.isfinite(clear) else None,
        "edge": settings.edge,
        "sides_shrunk_more": int((geometry.sides[made] > settings.joint / 2 * (1 + 1e-9)).sum())
        if settings.edge == "square"
        else 0,
        "lift_max_mm": float(geometry.lift[made].max()),
        "corners_cut": int(geometry.corners.cut[made].sum()),
        "lifted_over_hubs": int(geometry.over_hubs[made].sum()),
        "bearing_min_mm": None if bearing is None else float(bearing[made].min()),
        "not_put_on": sum(bool(part.assembly) for part in parts),
    }


def faces_down(mesh: QuadMesh) -> bool:
    """Tell whether the upper side faces down; a wall or a closed shape has none that does."""
    areas = mesh.face_area_vectors
    return float(areas[:, 2].sum()) < -_CLEARLY * float(np.linalg.norm(areas, axis=1).sum())


def messages_of(report: dict[str, Any], gap: float, material: Material) -> tuple[str, ...]:
    """Messages on panels, from their report and how far faces are from planar, mm."""
    messages = []
    bearing = report["bearing_min_mm"]
    if bearing is not None and bearing < material.bearing:
        wider = "thicker beams or a section with flanges"
        if bearing > 0:
            # Half of what beams are wider is on either side, and panels rise a little on them.
            more = math.ceil(2.2 * (material.bearing - bearing) - 1e-6)
            wider = f"beams {more} mm thicker or a section that much wider"
        messages.append(
            f"panels: they bear on the beams by {bearing:.3g} mm at the narrowest, "
            f"{material.name} needs {material.bearing:g} mm; take a smaller gap, {wider}"
        )
    if report["corners_cut"] and report["lifted_over_hubs"]:
        messages.append(
            f"panels: {report['lifted_over_hubs']} are lifted over hubs, as corners cut off beside "
            "them would leave nothing of a side"
        )
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


def gap_words(width: float, cover: float, joint: float, gap: float) -> tuple[str, ...]:
    """A message where a gap was given beside a frame that makes the joint, mm."""
    return (
        f"panels: pressure plates of {width:g} mm that cover {cover:g} mm on both sides make "
        f"joints of {joint:g} mm; the gap of {gap:g} mm that was given does not count",
    )
