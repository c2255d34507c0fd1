"""A function for each system of bars and joints: :func:`add_structure`, its settings spelled out.

Lengths are numbers of mm, quantities or texts such as ``"0.2 m"``; ``family``, ``lines``,
``material`` and ``density`` are those of :func:`add_structure`. Each raises InputError for sizes
that do not fit the net, and then the document is unchanged.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import FreeCAD

from freecad_ortho.documents.structures import add_structure

if TYPE_CHECKING:
    from freecad_ortho.option_keywords import (
        AnchorWord,
        BoltWord,
        EndsWord,
        FamilyWord,
        NodeWord,
        OffsetWord,
    )

    Length = float | str | FreeCAD.Units.Quantity
    Feature = FreeCAD.DocumentObject


def add_beams(
    net: Feature,
    height: Length = 200.0,
    thickness: Length = 20.0,
    offset: OffsetWord = "centre",
    *,
    section: str = "plate",
    section_width: Length = 60.0,
    flange_thickness: Length | None = None,
    ends: EndsWord = "mitred",
    hub_diameter: Length | None = None,
    clearance: Length | None = None,
    no_boundary_beams: bool = False,
    least_length: Length = 100.0,
    rounded: bool = False,
    bolt: BoltWord = "M16",
    bolts: int = 2,
    hub_wall: Length | None = None,
    splice_every: int = 4,
    family: FamilyWord = "both",
    lines: Sequence[int] = (),
    material: str = "steel",
    density: float = 0.0,
) -> Feature:
    """Add beams on the edges or along the parameter lines of a Net.

    Args:
        net: the Net.
        height: along the axes.
        thickness: of the plates, of a tube's wall or the web.
        offset: ``"above"`` the net, ``"centre"`` or ``"below"``.
        section: ``"plate"``, ``"hollow"``, ``"I"`` or ``"T"``, or one of the catalogue such as
            ``"HEB160"`` or ``"tube:100x60x5"``, which has a height and widths of its own.
        section_width: of tubes and flanges.
        flange_thickness: by default that of the web.
        ends: ``"mitred"``, ``"hub"``, ``"end-plate"``, ``"cover-plate"``, ``"cone"``, ``"lapped"``,
            ``"through-u"``, ``"through-v"``, ``"coped-u"``, ``"coped-v"``, ``"spliced-u"`` or
            ``"spliced-v"``.
        hub_diameter: of the hubs that beams end before; by default 100 mm, of those that they are
            bolted to what each needs.
        clearance: of slots and hubs; by default 1 mm, of slots what the material asks for.
        no_boundary_beams: leaves the boundary without beams.
        least_length: shorter beams at the border of the surface are left out.
        rounded: solids have the rounded corners and roots of a section of the catalogue.
        bolt: size of the bolts of end plates, cover plates and cones, ``"M12"`` to ``"M30"``.
        bolts: above each other, 1 or 2; a cone has one.
        hub_wall: thickness of the walls that these clamp; by default as thick as the bolts.
        splice_every: spliced beams have a splice after so many nodes, 0 for none.
        family: parameter lines that are built on.
        lines: numbers of these lines; empty for all.
        material: of all parts.
        density: kg/m3, 0 for the material's own.
    """
    return added("beams", locals())


def add_edge_beam(
    net: Feature,
    *,
    edge_section: str = "plate",
    edge_height: Length | None = None,
    edge_width: Length | None = None,
    edge_wall: Length = 5.0,
    height: Length = 200.0,
    thickness: Length = 20.0,
    offset: OffsetWord = "centre",
    clearance: Length | None = None,
    stock: Length | None = None,
    rounded: bool = False,
    family: FamilyWord = "both",
    lines: Sequence[int] = (),
    material: str = "steel",
    density: float = 0.0,
) -> Feature:
    """Add a beam along the border of a Net; beams, nodes and panels on it end there from then on.

    Args:
        net: the Net.
        edge_section: ``"plate"``, ``"tube"`` or ``"round"``, or one of the catalogue such as
            ``"HEB160"``, which has a height and widths of its own.
        edge_height: of the section, by default that of the beams.
        edge_width: of the section, by default that of the plates, or 60 mm.
        edge_wall: of tubes.
        height: of the beams that end at it.
        thickness: of their plates.
        offset: ``"above"`` the net, ``"centre"`` or ``"below"``.
        clearance: that is left before it, by default 1 mm.
        stock: length that longer pieces are cut into.
        rounded: solids have the rounded corners and roots of a section of the catalogue.
        family: parameter lines that the beams are on.
        lines: numbers of these lines; empty for all.
        material: of all parts.
        density: kg/m3, 0 for the material's own.
    """
    return added("edge-beam", locals())


def add_feet(
    net: Feature,
    *,
    foot_at: str = "corners",
    foot_height: Length = 600.0,
    post_diameter: Length = 88.9,
    post_wall: Length = 5.0,
    foot_plate: Length = 15.0,
    anchor: AnchorWord = "M16",
    height: Length = 200.0,
    offset: OffsetWord = "centre",
    clearance: Length | None = None,
    family: FamilyWord = "both",
    lines: Sequence[int] = (),
    material: str = "steel",
    density: float = 0.0,
) -> Feature:
    """Put vertices of a Net on feet: base plates with anchor bolts, posts and caps.

    Args:
        net: the Net.
        foot_at: ``"corners"``, ``"boundary"``, or numbers of vertices, ``"0,12,40"``.
        foot_height: from the vertices down to the lower sides of the base plates.
        post_diameter: of the posts, round tubes.
        post_wall: of these.
        foot_plate: thickness of base plates and caps.
        anchor: size of the anchor bolts, ``"M16"``.
        height: of the beams above them.
        offset: ``"above"`` the net, ``"centre"`` or ``"below"``, of these beams.
        clearance: between beams and caps, by default 1 mm.
        family: parameter lines that are built on.
        lines: numbers of these lines; empty for all.
        material: of all parts.
        density: kg/m3, 0 for the material's own.
    """
    return added("feet", locals())


def add_nodes(
    net: Feature,
    beams: Feature | None = None,
    *,
    node: NodeWord = "hub",
    hub_diameter: Length | None = None,
    bore: Length = 0.0,
    socket_depth: Length = 30.0,
    height: Length = 200.0,
    thickness: Length = 20.0,
    offset: OffsetWord = "centre",
    clearance: Length | None = None,
    no_boundary_beams: bool = False,
    bolt: BoltWord = "M16",
    bolts: int = 2,
    hub_wall: Length | None = None,
    family: FamilyWord = "both",
    lines: Sequence[int] = (),
    material: str = "steel",
    density: float = 0.0,
) -> Feature:
    """Add a joint at each vertex of a Net.

    Args:
        net: the Net.
        beams: a Structure of beams that the nodes join, and take height, thickness, offset,
            clearance, hub diameter and bolts from; mitred ones end before hubs from then on.
        node: ``"hub"``, ``"bolted"``, ``"star"``, ``"ball"`` or ``"socket"``.
        hub_diameter: across the faces of a hub, of a star, a ball or a socket; by default 100 mm,
            of bolted hubs, stars and balls what each needs.
        bore: diameter of a hole along the axis of a hub, 0 for none.
        socket_depth: how deep plates stand in sockets.
        height: of beams, where none are given.
        thickness: of their plates.
        offset: ``"above"`` the net, ``"centre"`` or ``"below"``.
        clearance: of slots and hubs; by default 1 mm, of slots what the material asks for.
        no_boundary_beams: no beams run along the boundary.
        bolt: size of the bolts, ``"M12"`` to ``"M30"``.
        bolts: above each other, 1 or 2.
        hub_wall: thickness of the walls of bolted hubs; by default as thick as the bolts.
        family: parameter lines that are built on.
        lines: numbers of these lines; empty for all.
        material: of all parts.
        density: kg/m3, 0 for the material's own.
    """
    return added("nodes", locals())


def added(system: str, settings: dict[str, Any]) -> Feature:
    """The Structure; plates that may be build-ups are as thick as their material unless told."""
    if system in ("panels", "louvres") and settings["thickness"] is None:
        del settings["thickness"]
    return add_structure(settings.pop("net"), system, **settings)
