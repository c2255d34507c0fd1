"""Compensation for the width of the cut: the tool's middle runs outside of the part."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad_ortho.fabrication.pattern import FlatPattern, Hole, polygon_area
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray

# Corners stay sharp up to this many half kerfs from the part; needles are cut off there.
_MITRE_LIMIT = 5.0


def compensated(name: str, pattern: FlatPattern, kerf: float) -> FlatPattern:
    """Return the path of the tool's middle: outlines grow by half the kerf, openings shrink.

    Args:
        name: of the part, for messages.
        pattern: true outline.
        kerf: width of the cut, mm; 0 returns the pattern itself.

    Raises:
        InputError: the kerf closes a slot, a cutout or a hole.
    """
    if kerf == 0:
        return pattern
    small = [hole.diameter for hole in pattern.holes if hole.diameter <= kerf]
    if small:
        raise InputError(f"kerf: {kerf:g} mm closes a hole of {small[0]:g} mm in {name}")
    return replace(
        pattern,
        outline=_moved(name, pattern.outline, kerf / 2),
        cutouts=tuple(_moved(name, cutout, -kerf / 2) for cutout in pattern.cutouts),
        holes=tuple(Hole(hole.centre, hole.diameter - kerf) for hole in pattern.holes),
    )


def _moved(name: str, polygon: FloatArray, distance: float) -> FloatArray:
    from shapely import Polygon
    from shapely.geometry.polygon import orient

    corners = {"join_style": "mitre", "mitre_limit": _MITRE_LIMIT}
    moved = Polygon(polygon).buffer(distance, **corners)
    whole = moved.geom_type == "Polygon" and not moved.is_empty and not moved.interiors
    # What moves back to something else has closed a slot, or a corner of one, on the way.
    lost = abs(moved.buffer(-distance, **corners).area - abs(polygon_area(polygon)))
    if not whole or lost > 4 * distance**2:
        raise InputError(
            f"kerf: {2 * abs(distance):g} mm closes a slot of {name}; take a finer tool or more "
            "clearance"
        )
    return np.array(orient(moved).exterior.coords)[:-1]
