"""What is to be said of panels, in plain words."""

from __future__ import annotations

from typing import Any

from freecad_ortho.fabrication.material import Material

# Distance between diagonals above which a face is visibly not planar, mm.
_GAP_WORTH_SAYING = 0.1
UNDER_BEAMS = (
    "panels: they lie under the beams, because the upper side of the net faces down; turn it over "
    "(Flip net, or orient on the command line)"
)


def messages_of(report: dict[str, Any], gap: float, material: Material) -> tuple[str, ...]:
    """Messages on panels, from their report and how far faces are from planar, mm."""
    messages = []
    bearing = report["bearing_min_mm"]
    if bearing is not None and bearing < material.bearing:
        messages.append(
            f"panels: they bear on the beams by {bearing:.3g} mm at the narrowest, "
            f"{material.name} needs {material.bearing:g} mm; take a smaller gap, thicker beams or "
            "a section with flanges"
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
