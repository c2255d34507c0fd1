"""Sections of the catalogue as IFC has them: IfcProfileDef with their sizes in mm."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from freecad_ortho.fabrication.profiles.profile import Profile
from freecad_ortho.fabrication.profiles.rolled import rolled_sizes

Make = Callable[..., Any]


def profile_definition(make: Make, profile: Profile) -> Any | None:
    """The entity of a section, y across and z up; None where IFC has none, as for polygons.

    Args:
        make: makes an entity of its class and attributes in their order.
        profile: of the catalogue.
    """
    head = ("AREA", profile.name, None)
    width, height, family = profile.width, profile.height, profile.series
    if not profile.standard:
        # A polygon of one's own.
        return None
    rolled = rolled_sizes(profile.name)
    if rolled is not None:
        plates = (rolled.web, rolled.flange, rolled.root)
        if family == "UPE":
            return make("IfcUShapeProfileDef", *head, height, width, *plates, None, None)
        if family == "tee":
            return make("IfcTShapeProfileDef", *head, height, width, *plates, *[None] * 4)
        return make("IfcIShapeProfileDef", *head, width, height, *plates, None, None)
    if not profile.rectangular:
        return None
    outer = profile.rings[0]
    if len(profile.rings) == 1:
        return make("IfcRectangleProfileDef", *head, width, height)
    if all(side.centre is not None for side in outer.sides):
        return make("IfcCircleHollowProfileDef", *head, height / 2, profile.wall)
    inner_radius, outer_radius = (float(ring.radii.max()) for ring in profile.rings[::-1])
    radii = inner_radius or None, outer_radius or None
    return make("IfcRectangleHollowProfileDef", *head, width, height, profile.wall, *radii)
