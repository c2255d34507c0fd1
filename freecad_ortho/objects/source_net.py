"""A net that is made from numbers, from other nets or from CAD faces, and follows them."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from hashlib import sha256
from typing import TYPE_CHECKING, Any

import FreeCAD
import numpy as np

from freecad_ortho import answers, convert
from freecad_ortho.objects import cad_faces, outdated, places, strokes
from freecad_ortho.objects.making import Inputs, Making
from freecad_ortho.objects.net import NET_PROPERTIES, NetProxy
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
    from solver.mesh.quadmesh import FloatArray, QuadMesh

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
        "OptimiseAgain",
        "Source",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Optimise again at once, as before, when the source of a net that was moved changes",
        ),
        flags=OUTPUT,
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
_STROKES = Property(
    "App::PropertyLinkSubList",
    "Strokes",
    "Source",
    QT_TRANSLATE_NOOP("App::Property", "Edges, wires and sketches that lines of the net run along"),
)
# Properties that say what a net is made of, by the names that macros have for it.
_LINKS = {"nets": "Nets", "faces": "CadFaces", "strokes": "Strokes"}


class SourceNet(NetProxy):
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
        make of it now, and marked, or optimised again.

        Raises:
            OrthoError: what is wrong and what to do; FreeCAD shows it and marks the object.
        """
        try:
            if feature.FollowSource:
                remake(feature)
            elif _has_source(feature):
                _compare(feature)
                if feature.Outdated and feature.OptimiseAgain:
                    answers.ask("optimise again", feature)
        except OrthoError as error:
            # The report view shows where an exception came from; the inner frames help nobody.
            raise type(error)(str(error)) from None


# How a net is optimised is known above the objects.
answers.promise("freecad_ortho.documents.again")


def create(
    document: FreeCAD.Document,
    kind: str,
    values: Mapping[str, Any],
    inputs: Inputs,
    label: str | None = None,
) -> FreeCAD.DocumentObject:
    """Add a net that follows a source; its mesh is made at once.

    Args:
        document: where to.
        kind: name of the source.
        values: its options, plain values in mm and degrees.
        inputs: what it is made of.
        label: name in the tree.

    Raises:
        InputError: values that make no net.
    """
    made = _shown(Making.of(source(kind), values, inputs), kind)
    name = "MultiNet" if kind == "multi-net" else "Net"
    feature = document.addObject("App::FeaturePython", name)
    SourceNet(feature, kind)
    feature.Label = label or kind[0].upper() + kind[1:]
    if inputs.nets:
        feature.Origin = inputs.nets[0].Origin
        places.join_container(feature, inputs.nets[0])
    set_inputs(feature, inputs)
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
    return made_mesh(net) if is_outdated(net) else convert.quad_mesh(net)


def made_mesh(net: FreeCAD.DocumentObject) -> QuadMesh:
    """What the source of a net makes now.

    Raises:
        OrthoError: it makes no net.
    """
    return _turned(net, _made(net).mesh)


def _has_source(feature: FreeCAD.DocumentObject) -> bool:
    """Tell whether all that the net is made of is still there."""
    try:
        inputs_of(feature).require(source(feature.MadeBy))
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
    if not feature.Outdated:
        return
    outdated.watch()
    if not feature.OptimiseAgain:
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


def inputs_of(feature: FreeCAD.DocumentObject, **others: Any) -> Inputs:
    """What a net is made of.

    Args:
        feature: the net.
        others: ``nets``, ``faces`` or ``strokes`` in place of what it is linked to; None leaves it.

    Raises:
        InputError: a face or an edge that has gone.
    """
    found = {word: getattr(feature, name, None) or () for word, name in _LINKS.items()}
    found |= {word: links for word, links in others.items() if links is not None}
    return Inputs(
        list(found["nets"]),
        cad_faces.faces_of(found["faces"]),
        strokes.strokes_of(found["strokes"]),
    )


def set_inputs(feature: FreeCAD.DocumentObject, inputs: Inputs) -> None:
    """Link a net to what it is made of."""
    for word, name in _LINKS.items():
        if name in feature.PropertiesList:
            setattr(feature, name, list(getattr(inputs, word)))


def _made(feature: FreeCAD.DocumentObject) -> Made:
    entry, inputs = source(feature.MadeBy), inputs_of(feature)
    # What it was made of may have been deleted since.
    inputs.require(entry)
    made = _shown(Making.of(entry, values_of(feature), inputs, feature), feature.Label)
    if not inputs.faces:
        return made
    # Faces are sampled where they stand in the document, which may not be where the net is.
    here = places.container(feature).inverse()
    border = tuple(places.moved(line, here) for line in made.border)
    return replace(made, mesh=places.moved_mesh(made.mesh, here), border=border)


def _shown(making: Making, label: str) -> Made:
    """Make a net; where that takes long, the window shows how far it is and Esc stops it."""
    stages = making.entry.stages
    if not stages or making.at_hand or not FreeCAD.GuiUp:
        return making.made()
    with answers.ask("show progress", label) as move:
        return making.made(lambda stage: move(stages.index(stage) / len(stages), stage))


@contextmanager
def as_before_on_failure(feature: FreeCAD.DocumentObject) -> Iterator[None]:
    """Give a net its options and links back where a change of them fails, also without undo."""
    values = values_of(feature)
    links = {name: getattr(feature, name, None) for name in _LINKS.values()}
    try:
        yield
    except BaseException:
        set_values(feature, values)
        for name, before in links.items():
            if before is not None:
                setattr(feature, name, before)
        raise


def values_of(feature: FreeCAD.DocumentObject) -> dict[str, Any]:
    """The options of a net's source, plain values in mm and degrees."""
    return {option.name: read(feature, option) for option in source(feature.MadeBy).options}


def set_values(feature: FreeCAD.DocumentObject, values: Mapping[str, Any]) -> None:
    """Write options into the properties; plain values in mm and degrees."""
    entry = source(feature.MadeBy)
    for name, value in values.items():
        write(feature, entry.option(name), value)


def _store(feature: FreeCAD.DocumentObject, made: Made) -> None:
    convert.store_mesh(feature, _turned(feature, made.mesh))
    convert.store_border(feature, made.border or _passed_on(feature))
    feature.MadeFrom, feature.Outdated = _word(made.mesh), False
    said = outdated.notice(feature)
    feature.Remarks = [*made.remarks, *([said] if said else [])]


def _passed_on(feature: FreeCAD.DocumentObject) -> list[FloatArray]:
    """The border of the net that a net is made of, where it stays on the same surface."""
    if not source(feature.MadeBy).stays:
        return []
    (net,) = feature.Nets
    way = places.between(feature, net)
    return [places.moved(line, way) for line in convert.border(net)]


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
    made += [_FACES] if entry.needs == "faces" else []
    return made + ([_STROKES] if entry.strokes else [])
