"""A net that is made from numbers, from other nets or from CAD faces, and follows them."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import replace
from hashlib import sha256
from typing import TYPE_CHECKING, Any

import FreeCAD
import numpy as np

from freecad_ortho import answers, convert
from freecad_ortho.objects import cad_faces, outdated, places
from freecad_ortho.objects.net import NET_PROPERTIES, Net
from freecad_ortho.objects.option_properties import properties, read, write
from freecad_ortho.objects.properties import (
    HIDDEN,
    OUTPUT,
    READ_ONLY,
    Property,
    ensure,
)
from freecad_ortho.sources import Made, Source, source
from solver.errors import InputError, OrthoError
from solver.mesh.mirror import reversed_orientation

if TYPE_CHECKING:
    from solver.mesh.quadmesh import QuadMesh

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

_PROPERTIES = (
    *NET_PROPERTIES,
    Property(
        "App::PropertyString",
        "MadeBy",
        "Source",
        QT_TRANSLATE_NOOP("App::Property", "What the net is made by"),
        flags=OUTPUT | READ_ONLY,
    ),
    Property(
        "App::PropertyBool",
        "FollowSource",
        "Source",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Make the net anew when its source changes; off once its vertices were moved",
        ),
        default=True,
    ),
    Property(
        "App::PropertyBool",
        "Outdated",
        "Source",
        QT_TRANSLATE_NOOP(
            "App::Property", "The source has changed since the vertices were moved; optimise again"
        ),
        flags=OUTPUT | READ_ONLY,
    ),
    Property(
        "App::PropertyString",
        "MadeFrom",
        "Source",
        QT_TRANSLATE_NOOP("App::Property", "Stands for the net as its source made it last"),
        flags=OUTPUT | READ_ONLY | HIDDEN,
    ),
    Property(
        "App::PropertyStringList",
        "Remarks",
        "Source",
        QT_TRANSLATE_NOOP("App::Property", "What is to be known about the net as it was made"),
        flags=OUTPUT | READ_ONLY,
    ),
)
_NETS = Property(
    "App::PropertyLinkList",
    "Nets",
    "Source",
    QT_TRANSLATE_NOOP("App::Property", "Nets that this one is made of"),
)
_FACES = Property(
    "App::PropertyLinkSubList",
    "CadFaces",
    "Source",
    QT_TRANSLATE_NOOP("App::Property", "Faces that the net is sampled from and stays linked to"),
)


class SourceNet(Net):
    """Proxy of a net that follows a source; all that is needed to make it stands in properties."""

    properties = _PROPERTIES

    def __init__(self, feature: FreeCAD.DocumentObject, kind: str) -> None:
        super().__init__(feature)
        feature.MadeBy = kind
        ensure(feature, _own_properties(source(kind)))

    def onDocumentRestored(self, feature: FreeCAD.DocumentObject) -> None:
        """Give an object from an older document the properties that came later."""
        super().onDocumentRestored(feature)
        formers = _formers(feature)
        ensure(feature, _own_properties(source(feature.MadeBy)))
        set_values(feature, formers)
        if feature.Outdated:
            outdated.watch()
            feature.touch()

    def onChanged(self, feature: FreeCAD.DocumentObject, name: str) -> None:
        """Lock the placement of a net that left its source: it would move nothing any more."""
        if name == "FollowSource" and "Placement" in feature.PropertiesList:
            status = "-ReadOnly" if feature.FollowSource else "ReadOnly"
            feature.setPropertyStatus("Placement", status)

    def execute(self, feature: FreeCAD.DocumentObject) -> None:
        """Make the net anew; on an error the last one stays.

        One whose vertices were moved since stays as well: it is told from what its source would
        make of it now, and marked.

        Raises:
            OrthoError: what is wrong and what to do; FreeCAD shows it and marks the object.
        """
        try:
            if feature.FollowSource:
                remake(feature)
            elif _has_source(feature):
                _compare(feature)
        except OrthoError as error:
            # The report view shows where an exception came from; the inner frames help nobody.
            raise type(error)(str(error)) from None


def create(
    document: FreeCAD.Document,
    kind: str,
    values: Mapping[str, Any],
    nets: Sequence[FreeCAD.DocumentObject] = (),
    faces: Sequence[tuple[FreeCAD.DocumentObject, str]] = (),
    label: str | None = None,
) -> FreeCAD.DocumentObject:
    """Add a net that follows a source; its mesh is made at once.

    Args:
        document: where to.
        kind: name of the source.
        values: its options, plain values in mm and degrees.
        nets: nets that it is made of.
        faces: shapes and names of their faces that it is sampled from.
        label: name in the tree.

    Raises:
        InputError: values that make no net.
    """
    made = source(kind).make(values, **inputs(nets, faces, nets[0] if nets else None))
    name = "MultiNet" if kind == "multi-net" else "Net"
    feature = document.addObject("App::FeaturePython", name)
    SourceNet(feature, kind)
    feature.Label = label or kind[0].upper() + kind[1:]
    if nets:
        feature.Nets = list(nets)
        feature.Origin = nets[0].Origin
        places.join_container(feature, nets[0])
    if faces:
        feature.CadFaces = list(faces)
    set_values(feature, values)
    _store(feature, made)
    if FreeCAD.GuiUp:
        answers.ask("show net with a source", feature.ViewObject)
    return feature


def is_source_net(feature: object) -> bool:
    """Tell whether a document object is a net that follows a source."""
    return isinstance(getattr(feature, "Proxy", None), SourceNet)


def remake(feature: FreeCAD.DocumentObject) -> None:
    """Make the mesh from the properties.

    Raises:
        OrthoError: the properties make no net; nothing was changed.
    """
    _store(feature, _made(feature))


def is_outdated(net: FreeCAD.DocumentObject) -> bool:
    """Tell whether a net was moved away from a source that has changed since."""
    return is_source_net(net) and net.Outdated


def starting_mesh(net: FreeCAD.DocumentObject) -> QuadMesh:
    """What optimising begins with: the net as it is, an outdated one as its source makes it now.

    Raises:
        OrthoError: the net is empty, or the source makes no net.
    """
    return _turned(net, _made(net).mesh) if is_outdated(net) else convert.quad_mesh(net)


def _has_source(feature: FreeCAD.DocumentObject) -> bool:
    """Tell whether all that the net is made of is still there."""
    try:
        require_inputs(source(feature.MadeBy), *_links(feature))
    except InputError:
        return False
    return True


def _compare(feature: FreeCAD.DocumentObject) -> None:
    """Mark a net whose source makes another mesh than the one that was moved."""
    now, before = _word(_made(feature).mesh), feature.Outdated
    if not feature.MadeFrom:
        # From an older document, which did not say.
        feature.MadeFrom = now
    feature.Outdated = now != feature.MadeFrom
    if feature.Outdated == before:
        return
    report = json.loads(feature.LastReport or "{}") | {"outdated": feature.Outdated}
    feature.LastReport = json.dumps(report)
    if feature.Outdated:
        outdated.watch()
        words = FreeCAD.Qt.translate(
            "Ortho", "{} stays as it is, though its source has changed: optimise it again"
        )
        FreeCAD.Console.PrintWarning(words.format(feature.Label) + "\n")


def _turned(feature: FreeCAD.DocumentObject, mesh: QuadMesh) -> QuadMesh:
    """A mesh of the source's with that side up which the net has chosen."""
    return reversed_orientation(mesh) if feature.Flipped else mesh


def _word(mesh: QuadMesh) -> str:
    """A word that is another for another mesh."""
    # A part that is moved takes faces and net along, but for rounding; and -0 is 0.
    points = np.round(mesh.vertices, 6) + 0.0
    return sha256(points.tobytes() + mesh.faces.tobytes()).hexdigest()


def _links(feature: FreeCAD.DocumentObject) -> tuple[Sequence[Any], Sequence[Any]]:
    """The nets and the CAD faces that a net is made of."""
    nets = feature.Nets if "Nets" in feature.PropertiesList else ()
    faces = cad_faces.faces_of(feature.CadFaces) if "CadFaces" in feature.PropertiesList else ()
    return nets, faces


def _made(feature: FreeCAD.DocumentObject) -> Made:
    entry, links = source(feature.MadeBy), _links(feature)
    # What it was made of may have been deleted since.
    require_inputs(entry, *links)
    made = entry.make(values_of(feature), **inputs(*links, feature))
    if not links[1]:
        return made
    # Faces are sampled where they stand in the document, which may not be where the net is.
    here = places.container(feature).inverse()
    return replace(made, mesh=places.moved_mesh(made.mesh, here))


def values_of(feature: FreeCAD.DocumentObject) -> dict[str, Any]:
    """The options of a net's source, plain values in mm and degrees."""
    return {option.name: read(feature, option) for option in source(feature.MadeBy).options}


def set_values(feature: FreeCAD.DocumentObject, values: Mapping[str, Any]) -> None:
    """Write options into the properties; plain values in mm and degrees."""
    entry = source(feature.MadeBy)
    for name, value in values.items():
        write(feature, entry.option(name), value)


def inputs(
    nets: Sequence[FreeCAD.DocumentObject],
    faces: Sequence[tuple[FreeCAD.DocumentObject, str]],
    beside: FreeCAD.DocumentObject | None = None,
) -> dict[str, Any]:
    """What a source takes besides its options.

    Args:
        nets: nets that are changed or joined.
        faces: CAD faces that are sampled, where they stand in the document.
        beside: an object in whose coordinates the meshes of the nets are given, by default the
            first net.
    """
    result: dict[str, Any] = {}
    if nets:
        target = nets[0] if beside is None else beside
        result["meshes"] = [
            places.moved_mesh(convert.quad_mesh(net), places.between(target, net)) for net in nets
        ]
    if faces:
        result["surfaces"] = [cad_faces.parametric_surface(*face) for face in faces]
    return result


def _store(feature: FreeCAD.DocumentObject, made: Made) -> None:
    convert.store_mesh(feature, _turned(feature, made.mesh))
    feature.MadeFrom, feature.Outdated = _word(made.mesh), False
    said = outdated.notice(feature)
    feature.Remarks = [*made.remarks, *([said] if said else [])]


def _formers(feature: FreeCAD.DocumentObject) -> dict[str, Any]:
    """Values of options that an older document has by their former names; these leave it."""
    found = {}
    for option in source(feature.MadeBy).options:
        then = option.former and replace(option, name=option.former.name)
        if then is None or not set(then.parts) <= set(feature.PropertiesList):
            continue
        found[option.name] = option.former.now(read(feature, then))
        for part in then.parts:
            feature.removeProperty(part)
    return found


def _own_properties(entry: Source) -> list[Property]:
    """The properties that hold a source's options and links."""
    made = [item for option in entry.options for item in properties(option, "Parameters")]
    made += [_NETS] if entry.needs in ("net", "nets") else []
    return made + ([_FACES] if entry.needs == "faces" else [])


def require_inputs(
    entry: Source,
    nets: Sequence[FreeCAD.DocumentObject],
    faces: Sequence[tuple[FreeCAD.DocumentObject, str]],
) -> None:
    """Raise InputError unless a source is given what it needs."""
    wanted = 1 if entry.needs in ("net", "nets") else 0
    if len(nets) < wanted or (entry.needs != "nets" and len(nets) > wanted):
        raise InputError(
            f"{entry.name}: expected {wanted or 'no'} net{'s' * (wanted != 1)}"
            f"{' or more' * (entry.needs == 'nets')}, got {len(nets)}; select them"
        )
    if (entry.needs == "faces") != bool(faces):
        words = "at least one CAD face" if entry.needs == "faces" else "no CAD faces"
        raise InputError(f"{entry.name}: expected {words}, got {len(faces)}; select them")
