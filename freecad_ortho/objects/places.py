"""Where document objects stand: in the parts that contain them, and moved by hand.

The vertices of a net are in the coordinates of the Part that contains it, so it moves with that
Part. A structure is built where its net is; its own Placement moves it from there. What is written
to files has everything where it is seen.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import FreeCAD
import numpy as np

from freecad_ortho import convert
from freecad_ortho.fabrication import Place
from solver.errors import InputError
from solver.mesh.local_origin import LocalOrigin

if TYPE_CHECKING:
    from freecad_ortho.fabrication import Place
    from solver.mesh.quadmesh import FloatArray, QuadMesh


def container(feature: FreeCAD.DocumentObject) -> FreeCAD.Placement:
    """Placement of the coordinates that an object lies in: of all parts around it, multiplied."""
    place = FreeCAD.Placement()
    part = feature.getParentGeoFeatureGroup()
    while part is not None:
        place = part.Placement.multiply(place)
        part = part.getParentGeoFeatureGroup()
    return place


def is_link(feature: object) -> bool:
    """Tell whether an object is a link: it shows another one, where it stands itself."""
    linked = getattr(feature, "getLinkedObject", None)
    return linked is not None and linked() is not feature


def refuse_link(feature: object) -> None:
    """Raise InputError where an object is a link: what is made of one would stand elsewhere."""
    if is_link(feature):
        name, linked = feature.Label, feature.getLinkedObject().Label
        raise InputError(
            f"{name}: is a link to {linked}, and nothing is made of links; take {linked}, or for a "
            "second place a copy of it"
        )


def between(feature: FreeCAD.DocumentObject, other: FreeCAD.DocumentObject) -> FreeCAD.Placement:
    """Takes coordinates that ``other`` lies in to those that ``feature`` lies in."""
    return container(feature).inverse().multiply(container(other))


def moved(points: FloatArray, place: FreeCAD.Placement) -> FloatArray:
    """(N, 3) points moved by a placement; where that does nothing they keep every bit."""
    if place.isIdentity():
        return points
    rotation, origin = convert.placing(place)
    return points @ rotation.T + origin


def moved_mesh(mesh: QuadMesh, place: FreeCAD.Placement) -> QuadMesh:
    """A mesh moved by a placement; itself where that does nothing."""
    return mesh if place.isIdentity() else mesh.with_vertices(moved(mesh.vertices, place))


def join_container(feature: FreeCAD.DocumentObject, model: FreeCAD.DocumentObject) -> None:
    """Put a new object into the part or group of the one that it was made of."""
    group = model.getParentGroup() or model.getParentGeoFeatureGroup()
    if group is not None:
        group.addObject(feature)


def built_at(structure: FreeCAD.DocumentObject, shift: FloatArray) -> FreeCAD.Placement:
    """Where the shape of a structure stands while nobody has moved it.

    Args:
        structure: the structure.
        shift: (3,) what was taken off its net's coordinates, mm.
    """
    return between(structure, structure.Net).multiply(_translation(shift))


def by_hand(structure: FreeCAD.DocumentObject) -> FreeCAD.Placement:
    """How far a structure was moved from where it was built."""
    return structure.Placement.multiply(structure.BuiltAt.inverse())


def seen(structure: FreeCAD.DocumentObject, shift: FloatArray) -> Place:
    """Where the parts of a structure stand in the document, moved by hand or not."""
    place = container(structure).multiply(by_hand(structure)).multiply(built_at(structure, shift))
    return Place() if place.isIdentity() else Place(*convert.placing(place))


def origin(net: FreeCAD.DocumentObject) -> FloatArray:
    """(3,) what was taken off the coordinates of a net's file, mm."""
    return convert.array([net.Origin])[0]


def document_origin(document: FreeCAD.Document, mesh: QuadMesh, scale: float) -> LocalOrigin:
    """What to take off the coordinates of a mesh that comes into a document.

    Nets of one site keep their places beside each other: what was taken off one net there is taken
    off the next where that brings it near.

    Args:
        document: where to.
        mesh: the mesh as its file has it.
        scale: mm of one unit of the file.
    """
    own = LocalOrigin.of_mesh(mesh)
    if not own.far:
        return own
    for item in document.Objects:
        if "Origin" in item.PropertiesList and "Faces" in item.PropertiesList:
            other = LocalOrigin(origin(item)).scaled(1.0 / scale)
            if other.far and not LocalOrigin.of_mesh(other.near_mesh(mesh)).far:
                return other
    return own


def _translation(way: FloatArray) -> FreeCAD.Placement:
    return FreeCAD.Placement(FreeCAD.Vector(*np.asarray(way).tolist()), FreeCAD.Rotation())
