"""A function for each system: :func:`add_structure` with the settings of that system spelled out.

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
    Length = float | str | FreeCAD.Units.Quantity
    Feature = FreeCAD.DocumentObject


def add_beams(
    net: Feature,
    height: Length = 200.0,
    thickness: Length = 20.0,
    offset: str = "centre",
    *,
    section: str = "plate",
    section_width: Length = 60.0,
    flange_thickness: Length | None = None,
    ends: str = "mitred",
    hub_diameter: Length | None = None,
    clearance: Length = 1.0,
    no_boundary_beams: bool = False,
    least_length: Length = 100.0,
    rounded: bool = False,
    bolt: str = "M16",
    bolts: int = 2,
    hub_wall: Length | None = None,
    family: str = "both",
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
            ``"through-u"`` or ``"through-v"``.
        hub_diameter: of the hubs that beams end before; by default 100 mm, of those that they are
            bolted to what each needs.
        clearance: of slots and hubs.
        no_boundary_beams: leaves the boundary without beams.
        least_length: shorter beams at the border of the surface are left out.
        rounded: solids have the rounded corners and roots of a section of the catalogue.
        bolt: size of the bolts of end plates, cover plates and cones, ``"M12"`` to ``"M30"``.
        bolts: above each other, 1 or 2; a cone has one.
        hub_wall: thickness of the walls that these clamp; by default as thick as the bolts.
        family: parameter lines that are built on.
        lines: numbers of these lines; empty for all.
        material: of all parts.
        density: kg/m3, 0 for the material's own.
    """
    return _added("beams", locals())


def add_edge_beam(
    net: Feature,
    *,
    edge_section: str = "plate",
    edge_height: Length | None = None,
    edge_width: Length | None = None,
    edge_wall: Length = 5.0,
    height: Length = 200.0,
    thickness: Length = 20.0,
    offset: str = "centre",
    clearance: Length = 1.0,
    stock: Length | None = None,
    rounded: bool = False,
    family: str = "both",
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
        clearance: that is left before it.
        stock: length that longer pieces are cut into.
        rounded: solids have the rounded corners and roots of a section of the catalogue.
        family: parameter lines that the beams are on.
        lines: numbers of these lines; empty for all.
        material: of all parts.
        density: kg/m3, 0 for the material's own.
    """
    return _added("edge-beam", locals())


def add_feet(
    net: Feature,
    *,
    foot_at: str = "corners",
    foot_height: Length = 600.0,
    post_diameter: Length = 88.9,
    post_wall: Length = 5.0,
    foot_plate: Length = 15.0,
    anchor: str = "M16",
    height: Length = 200.0,
    offset: str = "centre",
    clearance: Length = 1.0,
    family: str = "both",
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
        clearance: between beams and caps.
        family: parameter lines that are built on.
        lines: numbers of these lines; empty for all.
        material: of all parts.
        density: kg/m3, 0 for the material's own.
    """
    return _added("feet", locals())


def add_nodes(
    net: Feature,
    beams: Feature | None = None,
    *,
    node: str = "hub",
    hub_diameter: Length | None = None,
    bore: Length = 0.0,
    socket_depth: Length = 30.0,
    height: Length = 200.0,
    thickness: Length = 20.0,
    offset: str = "centre",
    clearance: Length = 1.0,
    no_boundary_beams: bool = False,
    bolt: str = "M16",
    bolts: int = 2,
    hub_wall: Length | None = None,
    family: str = "both",
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
        clearance: of slots and hubs.
        no_boundary_beams: no beams run along the boundary.
        bolt: size of the bolts, ``"M12"`` to ``"M30"``.
        bolts: above each other, 1 or 2.
        hub_wall: thickness of the walls of bolted hubs; by default as thick as the bolts.
        family: parameter lines that are built on.
        lines: numbers of these lines; empty for all.
        material: of all parts.
        density: kg/m3, 0 for the material's own.
    """
    return _added("nodes", locals())


def add_panels(
    net: Feature,
    thickness: Length | None = None,
    gap: Length = 8.0,
    offset: str = "above",
    beams: Feature | None = None,
    *,
    panel_edge: str = "square",
    at_hubs: str = "cut",
    clearance: Length = 1.0,
    least_width: Length = 60.0,
    slivers: str = "join",
    frame: str = "none",
    frame_width: Length = 50.0,
    edge_cover: Length = 15.0,
    gasket: Length = 5.0,
    bite: Length = 12.0,
    bending: str = "none",
    fold: Length = 0.0,
    bend_radius: Length | None = None,
    k_factor: float = 0.0,
    family: str = "both",
    lines: Sequence[int] = (),
    material: str = "steel",
    density: float = 0.0,
) -> Feature:
    """Add a flat panel in every face of a Net.

    Args:
        net: the Net.
        thickness: of the panels; by default 12 mm, or that of the build-up that ``material`` names.
        gap: between two panels.
        offset: ``"above"`` the net, ``"centre"`` or ``"below"``, where they lie on no beams.
        beams: a Structure of beams on the same Net that the panels lie on.
        panel_edge: ``"square"``, or ``"bevel"``: along the beams.
        at_hubs: ``"cut"`` corners off beside hubs, or ``"lift"`` panels over them.
        clearance: to hubs.
        least_width: narrower pieces at the border of the surface are slivers.
        slivers: ``"join"`` makes them part of neighbours where they fit, ``"leave-out"`` does not.
        frame: ``"plate"``: pressure plates and caps hold them, ``"silicone"``: adapters that they
            are glued onto, or ``"none"``.
        frame_width: of pressure plates; the joint is that less twice the edge cover.
        edge_cover: how far panels reach under pressure plates.
        gasket: thickness of gaskets.
        bite: of structural silicone.
        fold: depth by which edges of metal panels are folded down.
        bend_radius: inside of these folds, by default the thickness.
        k_factor: of these folds, 0 for that of DIN 6935.
        bending: ``"cold"``: flat panels are pressed into faces that are not planar.
        family: parameter lines that the beams are on.
        lines: numbers of these lines; empty for all.
        material: of all parts.
        density: kg/m3, 0 for the material's own.
    """
    return _added("panels", locals())


def add_louvres(
    net: Feature,
    *,
    thickness: Length | None = None,
    gap: Length = 8.0,
    louvre_axis: str = "u",
    tilt: float = 0.0,
    least_width: Length = 60.0,
    family: str = "both",
    lines: Sequence[int] = (),
    material: str = "steel",
    density: float = 0.0,
) -> Feature:
    """Add a slat on the midpoints of every face of a Net.

    Args:
        net: the Net.
        thickness: of the slats; by default 12 mm, or that of the build-up.
        gap: between two slats.
        louvre_axis: ``"u"`` or ``"v"``: the lines that they turn about.
        tilt: by how much they are turned, degrees.
        least_width: narrower pieces at the border of the surface are left out.
        family: parameter lines that are built on.
        lines: numbers of these lines; empty for all.
        material: of all parts.
        density: kg/m3, 0 for the material's own.
    """
    return _added("louvres", locals())


def add_lamellas(
    net: Feature,
    *,
    width: Length = 80.0,
    thickness: Length = 5.0,
    clearance: Length = 1.0,
    position: str = "standing",
    layers: int = 1,
    hole: Length = 9.0,
    overhang: Length | None = None,
    strip: str = "auto",
    pattern: str = "auto",
    smooth: bool = False,
    stock: Length | None = None,
    trim: Length = 10.0,
    saw: Length = 3.0,
    border_cut: str = "square",
    cutter: Length | None = None,
    family: str = "both",
    lines: Sequence[int] = (),
    material: str = "steel",
    density: float = 0.0,
) -> Feature:
    """Add a strip that unrolls flat along every parameter line of a Net.

    Args:
        net: the Net.
        width: of the strips.
        thickness: of the plates.
        clearance: of the slots, and between layers.
        position: ``"standing"`` on the surface, ``"lying"`` in it, or ``"tilted"``.
        layers: 1: slots where strips cross; 2: bolts.
        hole: diameter of the bolt holes.
        overhang: beyond the last vertex, by default half the width.
        strip: ``"developable"``, ``"twisted"`` or ``"auto"``.
        pattern: ``"straight"``, ``"arc"``, ``"free"`` or ``"auto"``.
        smooth: solids with smooth sides.
        stock: length that longer strips are spliced from.
        trim: what that loses at each end.
        saw: width of a saw cut.
        border_cut: at the border of the surface, ``"square"`` before it or ``"along"`` it.
        cutter: diameter of the milling cutter that slots have round corners for.
        family: parameter lines that are built on.
        lines: numbers of these lines; empty for all.
        material: of all parts.
        density: kg/m3, 0 for the material's own.
    """
    return _added("lamellas", locals())


def add_bent_panels(
    net: Feature,
    *,
    thickness: Length = 3.0,
    gap: Length = 10.0,
    sheet: str | None = None,
    spacing: Length = 10.0,
    grain: str = "none",
    kerf: Length = 0.0,
    least_width: Length = 60.0,
    family: str = "both",
    lines: Sequence[int] = (),
    material: str = "steel",
    density: float = 0.0,
) -> Feature:
    """Add one bent plate in every row of faces of a Net.

    Args:
        net: the Net.
        thickness: of the plates.
        gap: between two plates.
        sheet: size of the sheets that what is larger is cut for, ``"3000x1500"`` in mm.
        spacing: that is kept from the rim of a sheet.
        grain: whether parts may turn on a sheet.
        kerf: width of the cut.
        least_width: narrower pieces at the border of the surface are left out.
        family: parameter lines whose rows are built.
        lines: numbers of these lines; empty for all.
        material: of all parts.
        density: kg/m3, 0 for the material's own.
    """
    return _added("bent-panels", locals())


def add_patches(
    net: Feature,
    *,
    thickness: Length = 3.0,
    gap: Length = 10.0,
    sheet: str | None = None,
    spacing: Length = 10.0,
    grain: str = "none",
    kerf: Length = 0.0,
    least_width: Length = 60.0,
    distortion: float = 1.0,
    family: str = "both",
    lines: Sequence[int] = (),
    material: str = "steel",
    density: float = 0.0,
) -> Feature:
    """Make a Net of sheets that are cut flat and bent into place.

    Args:
        net: the Net.
        thickness: of the sheets.
        gap: between two patches.
        sheet: size of the sheets that what is larger is cut for, ``"3000x1500"`` in mm.
        spacing: that is kept from the rim of a sheet.
        grain: whether parts may turn on a sheet.
        kerf: width of the cut.
        least_width: narrower pieces at the border of the surface are left out.
        distortion: of an edge up to which a patch is built, percent.
        family: parameter lines that are built on.
        lines: numbers of these lines; empty for all.
        material: of all parts.
        density: kg/m3, 0 for the material's own.
    """
    return _added("patches", locals())


def _added(system: str, settings: dict[str, Any]) -> Feature:
    """The Structure; plates that may be build-ups are as thick as their material unless told."""
    if system in ("panels", "louvres") and settings["thickness"] is None:
        del settings["thickness"]
    return add_structure(settings.pop("net"), system, **settings)
