"""Nets in documents that are made by a source: primitives, multi-nets, faces, form-finding ..."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import FreeCAD

from freecad_ortho import convert
from freecad_ortho.documents.again import require_same_vertices
from freecad_ortho.documents.common import document_or_new, progress, require_net, transaction
from freecad_ortho.documents.nets import optimise_within
from freecad_ortho.objects import cad_faces, places, source_net
from freecad_ortho.objects import net as net_object
from freecad_ortho.objects.making import Inputs
from freecad_ortho.objects.strokes import strokes_of
from freecad_ortho.sources import GROUPS, source
from solver.errors import InputError
from solver.mesh.local_origin import LocalOrigin
from solver.mesh.remesh import quads_from_triangles
from solver.option import one_of

if TYPE_CHECKING:
    # Of the standard library from Python 3.11 on.
    from typing_extensions import Unpack

    from freecad_ortho.option_keywords import (
        ChangeOptions,
        CurvatureOptions,
        EllipticNetOptions,
        FaceOptions,
        FormOptions,
        MovingWord,
        MultiNetOptions,
        PrimitiveOptions,
        SourceOptions,
    )

Face = tuple[FreeCAD.DocumentObject, str]


def add_source(
    name: str,
    /,
    nets: FreeCAD.DocumentObject | Sequence[FreeCAD.DocumentObject] = (),
    faces: Sequence[Face] = (),
    strokes: Sequence[Face] = (),
    document: FreeCAD.Document | str | None = None,
    **options: Unpack[SourceOptions],
) -> FreeCAD.DocumentObject:
    """Add a net made by any source; it follows its options and what it is made of.

    Args:
        name: of the source, one of :data:`freecad_ortho.sources.SOURCES`.
        nets: nets that it is made of, for sources that need some; they are hidden.
        faces: shapes and names of their faces, for sources that need some; the shapes are hidden.
        strokes: shapes and names of their edges, or wires and sketches, that lines of the net run
            along, for the source ``along curvature``.
        document: a document or its name; without it that of the nets or faces, the active or a new
            one.
        options: of the source; lengths as numbers of mm, quantities or texts such as ``"2 m"``.

    Returns:
        The new Net, in mm.

    Raises:
        InputError: an unknown source or option, or values that make no net; the document is
            unchanged.
    """
    entry = source(name)
    chosen = list(nets) if isinstance(nets, (list, tuple)) else [nets]
    for net in chosen:
        require_net(net)
    inputs = Inputs(chosen, cad_faces.faces_of(faces), strokes_of(strokes))
    inputs.require(entry)
    values = convert.option_values(entry, options)
    owner = next(iter(inputs.owners), None)
    target = owner.Document if owner is not None else document_or_new(document, "Net")
    with transaction(target, entry.name.capitalize()):
        feature = source_net.create(target, name, values, inputs)
        target.recompute()
        # As FreeCAD does with what a shape is made of: both would be drawn into each other.
        for item in inputs.owners:
            item.Visibility = False
    _say_remarks(feature)
    return feature


def change_source(
    target: FreeCAD.DocumentObject,
    /,
    nets: Sequence[FreeCAD.DocumentObject] | None = None,
    faces: Sequence[Face] | None = None,
    strokes: Sequence[Face] | None = None,
    **options: Unpack[SourceOptions],
) -> None:
    """Give a net that follows a source other options; vertices that were moved are made anew.

    Those of a net with ``OptimiseAgain`` are optimised again then, as before.

    Args:
        target: a net made by :func:`add_source` or its kin.
        nets: other nets that it is made of.
        faces: other faces that it is sampled from.
        strokes: other edges, wires and sketches that its lines run along; ``()`` for none.
        options: of its source; those not given stay.

    Raises:
        InputError: values that make no net; the document is unchanged.
    """
    places.refuse_link(target)
    if not source_net.is_source_net(target):
        label = getattr(target, "Label", target)
        raise InputError(f"net: {label} follows no source; add a primitive, for one")
    entry = source(target.MadeBy)
    values = convert.option_values(entry, options)
    with transaction(target.Document, FreeCAD.Qt.translate("Ortho", "Change source")):
        inputs = source_net.inputs_of(target, nets=nets, faces=faces, strokes=strokes)
        inputs.require(entry)
        with source_net.as_before_on_failure(target):
            source_net.set_values(target, values)
            source_net.set_inputs(target, inputs)
            again = target.OptimiseAgain and not target.FollowSource
            if again:
                require_same_vertices(target)
            source_net.remake(target)
        if again:
            optimise_within(target)
        else:
            target.FollowSource = True
            target.Document.recompute()
    _say_remarks(target)


def add_primitive(
    name: str,
    *,
    document: FreeCAD.Document | str | None = None,
    **options: Unpack[PrimitiveOptions],
) -> FreeCAD.DocumentObject:
    """Add a net that is known exactly: ``sphere``, ``catenoid``, ``enneper`` and others.

    Args:
        name: of the primitive.
        document: where to, or its name; without it the active or a new one.
        options: ``sampling=(M, N)``, ``placement`` and the primitive's own; lengths as numbers of
            mm, quantities or texts such as ``"2 m"``.

    Raises:
        InputError: no such primitive or option; the document is unchanged.
    """
    one_of("primitive", name, GROUPS["primitive"])
    return add_source(name, document=document, **options)


def add_multi_net(
    points: Any = (),
    *,
    document: FreeCAD.Document | str | None = None,
    **options: Unpack[MultiNetOptions],
) -> FreeCAD.DocumentObject:
    """Add the multi-net of a polyline on a quadric.

    Args:
        points: (n, 3) points in the frame of the quadric, in mm; they are set onto it.
        document: where to, or its name; without it the active or a new one.
        options: ``t_range`` in mm2, the others as in the panel; ``reflect`` names mirror planes.

    Raises:
        InputError: no curve on the quadric, or t outside its range; the document is unchanged.
    """
    return add_source("multi-net", document=document, points=points, **options)


def add_elliptic_net(
    moving: MovingWord = "lambda",
    *,
    document: FreeCAD.Document | str | None = None,
    **options: Unpack[EllipticNetOptions],
) -> FreeCAD.DocumentObject:
    """Add a multi-net in elliptic coordinates.

    Args:
        moving: ``lambda``, ``mu`` or ``nu``: the coordinate in the role of t.
        document: where to, or its name; without it the active or a new one.
        options: ``curve`` is a preset, or ``formulas`` with ``first_formula`` and
            ``second_formula``; ``t_range`` in mm2.

    Raises:
        InputError: a value outside its range; the document is unchanged.
    """
    return add_source("elliptic multi-net", document=document, moving=moving, **options)


def net_from_faces(
    faces: Any,
    *,
    document: FreeCAD.Document | str | None = None,
    **options: Unpack[FaceOptions],
) -> FreeCAD.DocumentObject:
    """Add a net sampled from CAD faces along their parameter lines, joined where they meet.

    Args:
        faces: a shape (all its faces), ``(shape, "Face1")``, or a list of these.
        document: where to, or its name; without it that of the faces.
        options: ``sampling=(M, N)`` or ``edge="1 m"``; ``u_part`` and ``v_part`` are the first and
            the last part of a face, from 0 to 1.

    Raises:
        InputError: no faces, or a face that cannot be sampled so; the document is unchanged.
    """
    chosen = cad_faces.faces_of(faces)
    return add_source("faces", faces=chosen, document=document, **options)


def net_along_curvature(
    faces: Any,
    strokes: Any = (),
    *,
    document: FreeCAD.Document | str | None = None,
    **options: Unpack[CurvatureOptions],
) -> FreeCAD.DocumentObject:
    """Add a net on CAD faces along their lines of curvature, or at 45 degrees to them.

    The net overhangs the border of the faces by up to a face, or follows it; ``close_to`` keeps it
    near them when it is optimised.

    Args:
        faces: a shape (all its faces), ``(shape, "Face1")``, or a list of these.
        strokes: what lines of the net run along, whatever curvature says there: ``(shape,
            "Edge1")``, a wire or a sketch, or a list of these.
        document: where to, or its name; without it that of the faces.
        options: ``net`` (``principal``, ``developable``, ``asymptotic``, ``cmc`` or ``stress``),
            ``edge="1.2 m"``, ``ratio``, ``border`` (``trim`` or ``follow``); ``singularities``
            (rows of x, y, z in mm and 3, 5 or 6 lines, ``"none"`` or ``"auto"``) and
            ``drawn_strokes`` (lists of points in mm).

    Raises:
        InputError: no faces, faces that have no such net, or a stroke that is off the faces; the
            document is unchanged.
    """
    chosen = cad_faces.faces_of(faces)
    return add_source(
        "along curvature",
        faces=chosen,
        strokes=strokes_of(strokes),
        document=document,
        **options,
    )


def form_net(
    net: FreeCAD.DocumentObject,
    *,
    document: FreeCAD.Document | str | None = None,
    **options: Unpack[FormOptions],
) -> FreeCAD.DocumentObject:
    """Add the membrane or cable net in equilibrium that starts from a net.

    Args:
        net: the start; its supports are held.
        document: where to, or its name; without it that of the net.
        options: ``kind``, ``supports``, ``lift``, ``density``, loads and others of the source
            ``form-finding``.

    Raises:
        InputError: no supports, or no equilibrium; the document is unchanged.
    """
    return add_source("form-finding", net, document=document, **options)


def change_net(
    net: FreeCAD.DocumentObject,
    change: str,
    *,
    document: FreeCAD.Document | str | None = None,
    **options: Unpack[ChangeOptions],
) -> FreeCAD.DocumentObject:
    """Add a net made from another: ``subdivide``, ``diagonal mesh``, ``mirror`` and others.

    Args:
        net: the net; it stays, hidden, and the new one follows it.
        change: name of the source.
        document: where to, or its name; without it that of the net.
        options: of the change; lengths as numbers of mm, quantities or texts such as ``"2 m"``.

    Raises:
        InputError: no such change, or it does not fit the net; the document is unchanged.
    """
    return add_source(change, net, document=document, **options)


def weld_nets(
    nets: Sequence[FreeCAD.DocumentObject], tolerance: Any = 1.0
) -> FreeCAD.DocumentObject:
    """Add one net of several whose borders meet, or of one whose border meets itself.

    Args:
        nets: at least one.
        tolerance: vertices nearer than this become one, unless an edge there is not twice as long.

    Raises:
        InputError: no net, or edges with more than two faces; the document is unchanged.
    """
    return add_source("weld", list(nets), tolerance=tolerance)


def quads_from_mesh(
    mesh: FreeCAD.DocumentObject | str | os.PathLike[str],
    faces: int | None = None,
    edge: Any = None,
    seed: int = 0,
    time_limit: float = 60.0,
    corner: float = 40.0,
    unit: str | None = None,
    document: FreeCAD.Document | str | None = None,
) -> FreeCAD.DocumentObject:
    """Add a net of quads in place of triangles, border and corners kept.

    Args:
        mesh: a Mesh object, or an STL, OBJ, PLY, OFF or GLB file.
        faces: wanted number of quads.
        edge: wanted edge length instead.
        seed: another number gives another layout.
        time_limit: seconds that the library may take.
        corner: border vertices that turn by more than this (degrees) are kept as corners.
        unit: of a file's coordinates; without it what the file says, else mm.
        document: where to; without it that of the mesh, the active or a new one.

    Raises:
        InputError: a soup of triangles, the library missing, hanging or failing; the document is
            unchanged.
    """
    label = getattr(mesh, "Label", None) or Path(str(mesh)).stem
    points, triangles = cad_faces.triangles_of(mesh, unit)
    taken = LocalOrigin.of(points)
    length = None if edge is None else convert.millimetres(edge, "edge")
    with progress(FreeCAD.Qt.translate("Ortho", "Remeshing to quads")) as move:
        made = quads_from_triangles(
            taken.near(points),
            triangles,
            faces=faces,
            edge=length,
            seed=seed,
            time_limit=time_limit,
            corner=corner,
            waiting=None if move is None else lambda part: move(part, ""),
        )
    owner = None if isinstance(mesh, (str, os.PathLike)) else mesh
    target = owner.Document if owner is not None else document_or_new(document, label)
    with transaction(target, FreeCAD.Qt.translate("Ortho", "Quads from triangles")):
        mesh_made = made.mesh if owner is None else taken.back_mesh(made.mesh)
        net = net_object.create(target, mesh_made, f"{label} quads")
        if owner is not None:
            owner.Visibility = False
        else:
            net.SourceFile = os.fspath(mesh)
            net.Origin = convert.vectors(taken.shift[None])[0]
        if FreeCAD.GuiUp:
            net.ViewObject.IrregularVertices = True
        target.recompute()
    FreeCAD.Console.PrintMessage(
        f"{net.Label}: {len(made.mesh.faces)} quads, {len(made.irregular)} irregular vertices, "
        f"border within {made.border_gap:.2g} mm\n"
    )
    for remark in made.remarks:
        FreeCAD.Console.PrintWarning(f"{net.Label}: {remark}\n")
    return net


def _say_remarks(net: FreeCAD.DocumentObject) -> None:
    for remark in net.Remarks:
        FreeCAD.Console.PrintMessage(f"{net.Label}: {remark}\n")
