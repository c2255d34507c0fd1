"""From structures in a document to the parts that fabrication makes of them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from hashlib import sha256
from typing import TYPE_CHECKING, Any

import numpy as np

from freecad_ortho import __version__, convert
from freecad_ortho.fabrication import (
    SYSTEMS,
    Limits,
    Material,
    Selection,
    Structure,
    System,
    build,
    material,
)
from freecad_ortho.objects import outdated, places
from freecad_ortho.objects.kinds import (
    AT_EDGE_BEAM,
    BEAMS,
    EDGE_BEAM,
    NODES,
    ON_BEAMS,
    TITLES,
    is_structure,
)
from freecad_ortho.objects.limit_properties import limits_of
from freecad_ortho.objects.net import is_net
from freecad_ortho.objects.system_properties import system_of
from solver.errors import InputError

if TYPE_CHECKING:
    import FreeCAD

    from solver.mesh.quadmesh import FloatArray, QuadMesh

_REMEDY = "select structures of different systems on the same net"


def structure(features: Sequence[FreeCAD.DocumentObject], placed: bool = False) -> Structure:
    """Build the parts of structures that stand on one net.

    Args:
        features: structures of different systems.
        placed: for files: as they stand in the document, and measured from where the net's file is.

    Raises:
        InputError: not structures, structures that do not go together, or sizes that do not fit.
    """
    order = _ordered(features)
    whole = build(
        order.mesh,
        order.systems,
        material=order.materials,
        limits=order.limits,
        selection=order.selection,
        border=order.border,
    )
    chosen = _warned(whole.only(*order.wanted), outdated.notice(features[0]))
    return _placed(chosen, features) if placed else chosen


def _warned(whole: Structure, words: str) -> Structure:
    """The parts with a remark for their report, if there is one."""
    if not words:
        return whole
    name, first = next(iter(whole.results.items()))
    told = replace(first, messages=(*first.messages, words))
    return replace(whole, results={**whole.results, name: told})


def _placed(whole: Structure, features: Sequence[FreeCAD.DocumentObject]) -> Structure:
    """The parts where they are seen in the document, in the coordinates of the net's file."""
    seen = [places.seen(feature, whole.shift) for feature in features]
    for feature, place in zip(features, seen, strict=True):
        if not place.near(seen[0]):
            raise InputError(
                f"structures: {features[0].Label} and {feature.Label} were moved apart; give them "
                "the same Placement or export them one after the other"
            )
    origin = places.origin(features[0].Net)
    far = seen[0].origin if whole.shift.any() else np.zeros(3)
    return replace(whole, place=seen[0].less(-origin), origin=origin + far)


def fingerprint(features: Sequence[FreeCAD.DocumentObject], *more: Any) -> str:
    """A word that is another where :func:`structure` would give other parts.

    Args:
        features: structures of different systems.
        more: what else matters; with a ``repr`` that says all.

    Raises:
        InputError: as :func:`structure`, as far as the geometry does not matter.
    """
    order = _ordered(features)
    net = order.mesh.connectivity
    word = sha256(order.mesh.vertices.tobytes() + net.half_edges[:, 0].tobytes())
    if net.mixed:
        word.update(net.face_sizes.tobytes())
    for line in order.border:
        word.update(line.tobytes())
    # Another version of the workbench may build the same in another way.
    settings = (
        __version__,
        order.systems,
        order.materials,
        order.limits,
        order.selection,
        order.wanted,
    )
    word.update(repr((settings, more)).encode())
    return word.hexdigest()


@dataclass(frozen=True, eq=False)
class _Order:
    """All that the properties of structures say, as fabrication takes it."""

    mesh: QuadMesh
    systems: list[System]
    materials: dict[str, Material]
    limits: dict[str, Limits]
    selection: Selection
    wanted: list[str]
    border: tuple[FloatArray, ...]


def _ordered(features: Sequence[FreeCAD.DocumentObject]) -> _Order:
    net = _common_net(features)
    by_system = _by_system(features)
    carrier = _carrier(by_system, net)
    nodes = _nodes_beside(by_system, net)
    wanted = list(by_system)
    if carrier is not None:
        by_system["beams"] = carrier
    if nodes is not None:
        by_system["nodes"] = nodes
    edge_beam = _edge_beam_beside(by_system, net)
    if edge_beam is not None:
        by_system["edge-beam"] = edge_beam
    ordered = [name for name in SYSTEMS if name in by_system]
    lines = _agreed(features, "lines", lambda feature: (feature.Family, tuple(feature.Lines)))
    return _Order(
        convert.quad_mesh(net),
        [system_of(by_system[name], name) for name in ordered],
        {name: material_of(by_system[name]) for name in ordered},
        {name: limits_of(by_system[name]) for name in ordered},
        Selection(lines[0].lower(), lines[1] or None),
        [name for name in ordered if name in wanted],
        convert.border(net) if _agreed(features, "trimming", _is_trimmed) else (),
    )


def _is_trimmed(feature: FreeCAD.DocumentObject) -> bool:
    return bool(feature.Trimmed)


def material_of(feature: FreeCAD.DocumentObject) -> Material:
    """The material of the parts of a structure."""
    return material(feature.Material, feature.Density or None)


def _by_system(features: Sequence[FreeCAD.DocumentObject]) -> dict[str, FreeCAD.DocumentObject]:
    found: dict[str, FreeCAD.DocumentObject] = {}
    for feature in features:
        system = TITLES[feature.System]
        if system in found:
            raise InputError(
                f"structures: {found[system].Label} and {feature.Label} are both {system}; "
                f"{_REMEDY}"
            )
        found[system] = feature
    return found


def _carrier(
    by_system: dict[str, FreeCAD.DocumentObject], net: FreeCAD.DocumentObject
) -> FreeCAD.DocumentObject | None:
    """The beams that the others lie on, None where they lie on the net."""
    beams = by_system.get("beams")
    carriers = [by_system[name].OnBeams for name in ON_BEAMS if name in by_system]
    if beams is not None:
        for name in ON_BEAMS:
            if name in by_system and by_system[name].OnBeams is not beams:
                raise InputError(
                    f"{by_system[name].Label}: does not lie on {beams.Label}; export them one "
                    "after the other or set 'OnBeams'"
                )
        return None
    found = [carrier for carrier in carriers if carrier is not None]
    if any(carrier is not found[0] for carrier in carriers if found):
        raise InputError("structures: lie on different beams; export them one after the other")
    _check_carrier(found[0] if found else None, net)
    return found[0] if found else None


def _nodes_beside(
    by_system: dict[str, FreeCAD.DocumentObject], net: FreeCAD.DocumentObject
) -> FreeCAD.DocumentObject | None:
    """The nodes that panels stay clear of where these are built without them."""
    panels = by_system.get("panels")
    if panels is None or panels.OnNodes is None or "nodes" in by_system:
        return None
    nodes = panels.OnNodes
    known = is_structure(nodes) and nodes.System == NODES
    if not known or nodes.Net is not net or nodes.OnBeams is not panels.OnBeams:
        raise InputError(
            f"{panels.Label}: '{nodes.Label}' is not a structure of nodes on the same net and "
            "beams; choose another for 'OnNodes' or leave it empty"
        )
    return nodes


def _edge_beam_beside(
    by_system: dict[str, FreeCAD.DocumentObject], net: FreeCAD.DocumentObject
) -> FreeCAD.DocumentObject | None:
    """The edge beam that beams, nodes and panels end at where these are built without it."""
    own = by_system.get("edge-beam")
    links = {name: by_system[name].AtEdgeBeam for name in AT_EDGE_BEAM if name in by_system}
    wanted = own or next(iter(links.values()), None)
    for name, link in links.items():
        if link is not wanted:
            label = by_system[name].Label
            raise InputError(
                f"{label}: knows of another edge beam than the others; set the same 'AtEdgeBeam' "
                "for all, or export them one after the other"
            )
    if wanted is None or wanted is own:
        return None
    if not (is_structure(wanted) and wanted.System == EDGE_BEAM and wanted.Net is net):
        raise InputError(
            f"structures: '{wanted.Label}' is not an edge beam on {net.Label}; choose another for "
            "'AtEdgeBeam' or leave it empty"
        )
    return wanted


def _agreed(
    features: Sequence[FreeCAD.DocumentObject],
    name: str,
    read: Callable[[FreeCAD.DocumentObject], Any],
) -> Any:
    """What all structures have in common."""
    values = [read(feature) for feature in features]
    for feature, value in zip(features, values, strict=True):
        if value != values[0]:
            raise InputError(
                f"structures: {features[0].Label} and {feature.Label} differ in their {name}; "
                "set the same or export them one after the other"
            )
    return values[0]


def _common_net(features: Sequence[FreeCAD.DocumentObject]) -> FreeCAD.DocumentObject:
    if not features:
        raise InputError(f"structures: none given; {_REMEDY}")
    for feature in features:
        places.refuse_link(feature)
        if not is_structure(feature):
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


def _check_carrier(carrier: FreeCAD.DocumentObject | None, net: FreeCAD.DocumentObject) -> None:
    """Refuse panels on something other than beams on the same net."""
    if carrier is None:
        return
    places.refuse_link(carrier)
    beams = is_structure(carrier) and carrier.System == BEAMS
    if not beams or carrier.Net is not net:
        raise InputError(
            f"structures: '{carrier.Label}' is not a structure of beams on {net.Label}; "
            "choose another for 'OnBeams' or leave it empty"
        )
