"""A function for each system of sheets and strips: :func:`add_structure`, its settings spelled out.

Lengths are numbers of mm, quantities or texts such as ``"0.2 m"``; ``family``, ``lines``,
``material`` and ``density`` are those of :func:`add_structure`. Each raises InputError for sizes
that do not fit the net, and then the document is unchanged.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import FreeCAD

from freecad_ortho.documents.systems import added

if TYPE_CHECKING:
    from freecad_ortho.option_keywords import (
        AtHubsWord,
        BendingWord,
        BorderCutWord,
        DiagonalsWord,
        FamilyWord,
        FrameWord,
        GrainWord,
        LouvreAxisWord,
        OffsetWord,
        PanelEdgeWord,
        PatternWord,
        PositionWord,
        SliversWord,
        StripWord,
        ThroughWord,
    )

    Length = float | str | FreeCAD.Units.Quantity
    Feature = FreeCAD.DocumentObject


def add_panels(
    net: Feature,
    thickness: Length | None = None,
    gap: Length = 8.0,
    offset: OffsetWord = "centre",
    beams: Feature | None = None,
    *,
    panel_thickness: Length | None = None,
    panel_edge: PanelEdgeWord = "square",
    at_hubs: AtHubsWord = "cut",
    clearance: Length | None = None,
    least_width: Length = 60.0,
    slivers: SliversWord = "join",
    frame: FrameWord = "none",
    frame_width: Length | None = None,
    edge_cover: Length | None = None,
    gasket: Length = 5.0,
    bite: Length = 12.0,
    bending: BendingWord = "none",
    fold: Length = 0.0,
    bend_radius: Length | None = None,
    k_factor: float = 0.0,
    family: FamilyWord = "both",
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
        panel_thickness: the same as ``thickness``, as it is called beside beams elsewhere.
        panel_edge: ``"square"``, or ``"bevel"``: along the beams.
        at_hubs: ``"cut"`` corners off beside hubs, or ``"lift"`` panels over them.
        clearance: to hubs, by default 1 mm.
        least_width: narrower pieces at the border of the surface are slivers.
        slivers: ``"join"`` makes them part of neighbours where they fit, ``"leave-out"`` does not.
        frame: ``"plate"``: pressure plates and caps hold them, ``"silicone"``: adapters that they
            are glued onto, or ``"none"``.
        frame_width: of pressure plates, by default 50 mm; the joint is that less twice the edge
            cover.
        edge_cover: how far panels reach under pressure plates, by default 15 mm. Where neither is
            given both grow with the same joint where the material needs it.
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
    return added("panels", locals())


def add_arches(
    net: Feature,
    height: Length = 200.0,
    thickness: Length = 20.0,
    *,
    offset: OffsetWord = "centre",
    clearance: Length | None = None,
    overhang: Length | None = None,
    through: ThroughWord = "both",
    family: FamilyWord = "both",
    lines: Sequence[int] = (),
    material: str = "steel",
    density: float = 0.0,
) -> Feature:
    """Add a plate cut flat along every line of a Net that lies in a plane.

    Args:
        net: the Net, whose lines of one family or of both lie in planes of their own.
        height: of the plates, square to the line.
        thickness: of the plates.
        offset: ``"above"`` the net, ``"centre"`` or ``"below"``.
        clearance: in the width and depth of slots, by default what the material asks for.
        overhang: beyond the last vertices, by default half the height.
        through: ``"both"``: plates cross by half laps; ``"u"`` or ``"v"``: those of this family run
            through, the others are pieces between them.
        family: parameter lines that are built on.
        lines: numbers of these lines; empty for all.
        material: of all parts.
        density: kg/m3, 0 for the material's own.
    """
    return added("arches", locals())


def add_louvres(
    net: Feature,
    *,
    thickness: Length | None = None,
    panel_thickness: Length | None = None,
    gap: Length = 8.0,
    louvre_axis: LouvreAxisWord = "u",
    tilt: float = 0.0,
    least_width: Length = 60.0,
    family: FamilyWord = "both",
    lines: Sequence[int] = (),
    material: str = "steel",
    density: float = 0.0,
) -> Feature:
    """Add a slat on the midpoints of every face of a Net.

    Args:
        net: the Net.
        thickness: of the slats; by default 12 mm, or that of the build-up.
        panel_thickness: the same as ``thickness``, as it is called beside beams elsewhere.
        gap: between two slats.
        louvre_axis: ``"u"`` or ``"v"``: the lines that they turn about.
        tilt: by how much they are turned, degrees.
        least_width: narrower pieces at the border of the surface are left out.
        family: parameter lines that are built on.
        lines: numbers of these lines; empty for all.
        material: of all parts.
        density: kg/m3, 0 for the material's own.
    """
    return added("louvres", locals())


def add_lamellas(
    net: Feature,
    *,
    width: Length = 80.0,
    thickness: Length = 5.0,
    clearance: Length | None = None,
    position: PositionWord = "standing",
    layers: int = 1,
    hole: Length = 9.0,
    overhang: Length | None = None,
    strip: StripWord = "auto",
    pattern: PatternWord = "auto",
    smooth: bool = False,
    stock: Length | None = None,
    trim: Length = 10.0,
    saw: Length = 3.0,
    border_cut: BorderCutWord = "square",
    cutter: Length | None = None,
    cleats: bool = False,
    diagonals: DiagonalsWord = "none",
    family: FamilyWord = "both",
    lines: Sequence[int] = (),
    material: str = "steel",
    density: float = 0.0,
) -> Feature:
    """Add a strip that unrolls flat along every parameter line of a Net.

    Args:
        net: the Net.
        width: of the strips.
        thickness: of the plates.
        clearance: of the slots, and between layers; by default what the material asks for.
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
        cleats: angles with bolts join strips where these end.
        diagonals: a third layer along ``"first"`` or ``"second"`` ones, or ``"auto"``.
        family: parameter lines that are built on.
        lines: numbers of these lines; empty for all.
        material: of all parts.
        density: kg/m3, 0 for the material's own.
    """
    return added("lamellas", locals())


def add_bent_panels(
    net: Feature,
    *,
    thickness: Length = 3.0,
    gap: Length = 10.0,
    sheet: str | None = None,
    spacing: Length = 10.0,
    grain: GrainWord = "none",
    kerf: Length = 0.0,
    least_width: Length = 60.0,
    piece_length: Length | None = None,
    family: FamilyWord = "both",
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
        piece_length: rows are cut along lines of the net into pieces of at most this length.
        family: parameter lines whose rows are built.
        lines: numbers of these lines; empty for all.
        material: of all parts.
        density: kg/m3, 0 for the material's own.
    """
    return added("bent-panels", locals())


def add_patches(
    net: Feature,
    *,
    thickness: Length = 3.0,
    gap: Length = 10.0,
    sheet: str | None = None,
    spacing: Length = 10.0,
    grain: GrainWord = "none",
    kerf: Length = 0.0,
    least_width: Length = 60.0,
    distortion: float = 1.0,
    family: FamilyWord = "both",
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
    return added("patches", locals())
