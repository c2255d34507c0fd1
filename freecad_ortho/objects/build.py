"""From structures in a document to the parts that fabrication makes of them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from freecad_ortho import convert
from freecad_ortho.fabrication import Beams, Panels, Structure, System, build, material
from freecad_ortho.objects import structure as structure_object
from freecad_ortho.objects.net import is_net
from solver.errors import InputError

if TYPE_CHECKING:
    import FreeCAD

_REMEDY = "select one structure of beams, one of panels on them, or one of each on the same net"


def structure(features: Sequence[FreeCAD.DocumentObject]) -> Structure:
    """Build the parts of structures that stand on one net.

    Args:
        features: one structure of beams, one of panels, or both.

    Raises:
        InputError: not structures, structures that do not go together, or sizes that do not fit.
    """
    net = _common_net(features)
    beams = _only(features, structure_object.BEAMS)
    panels = _only(features, structure_object.PANELS)
    below = None if panels is None else panels.OnBeams
    if beams is not None and panels is not None and below is not beams:
        raise InputError(
            f"{panels.Label}: does not lie on {beams.Label}; export them one after the other or "
            "set 'OnBeams'"
        )
    carrier = beams if panels is None else below
    _check_carrier(carrier, net)
    systems: list[System] = [] if carrier is None else [_beams(carrier)]
    if panels is not None:
        systems.append(_panels(panels))
    whole = build(convert.quad_mesh(net), systems, material=material(density=features[0].Density))
    return whole.only(Panels.name) if beams is None and carrier is not None else whole


def _beams(feature: FreeCAD.DocumentObject) -> Beams:
    return Beams(feature.Height.Value, feature.Thickness.Value, feature.Offset.lower())


def _panels(feature: FreeCAD.DocumentObject) -> Panels:
    return Panels(feature.Thickness.Value, feature.Gap.Value, feature.Offset.lower())


def _common_net(features: Sequence[FreeCAD.DocumentObject]) -> FreeCAD.DocumentObject:
    if not features:
        raise InputError(f"structures: none given; {_REMEDY}")
    for feature in features:
        if not structure_object.is_structure(feature):
            raise InputError(f"structures: {feature.Label} is not a structure; {_REMEDY}")
        if feature.Net is None:
            raise InputError(f"{feature.Label}: stands on no net; set its property 'Net'")
        if not is_net(feature.Net):
            raise InputError(
                f"{feature.Label}: stands on {feature.Net.Label}, which is no net; set its "
                "property 'Net' to one"
            )
    net = features[0].Net
    for feature in features:
        if feature.Net is not net:
            raise InputError(
                f"structures: {features[0].Label} and {feature.Label} stand on different nets; "
                "export them one after the other"
            )
    return net


def _only(features: Sequence[FreeCAD.DocumentObject], system: str) -> FreeCAD.DocumentObject | None:
    chosen = [feature for feature in features if system == feature.System]
    if len(chosen) > 1:
        labels = " and ".join(feature.Label for feature in chosen)
        raise InputError(f"structures: {labels} are both {system.lower()}; {_REMEDY}")
    return chosen[0] if chosen else None


def _check_carrier(carrier: FreeCAD.DocumentObject | None, net: FreeCAD.DocumentObject) -> None:
    """Refuse panels on something other than beams on the same net."""
    if carrier is None:
        return
    beams = structure_object.is_structure(carrier) and carrier.System == structure_object.BEAMS
    if not beams or carrier.Net is not net:
        raise InputError(
            f"panels: '{carrier.Label}' is not a structure of beams on {net.Label}; "
            "choose another for 'OnBeams' or leave it empty"
        )
