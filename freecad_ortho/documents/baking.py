"""Plain FreeCAD objects out of nets and structures, which need nothing of this workbench."""

from __future__ import annotations

from typing import TYPE_CHECKING

import FreeCAD

from freecad_ortho import convert
from freecad_ortho.documents.common import transaction
from freecad_ortho.objects import places
from freecad_ortho.objects import structure as structure_object
from freecad_ortho.objects.net import is_net
from solver.errors import InputError
from solver.mesh.local_origin import LocalOrigin

if TYPE_CHECKING:
    from collections.abc import Sequence


def bake(
    features: FreeCAD.DocumentObject | Sequence[FreeCAD.DocumentObject],
) -> list[FreeCAD.DocumentObject]:
    """Copy nets and structures as plain objects, in groups beside the originals.

    A structure becomes one Part feature a part, with the part's name; a net becomes a Mesh and a
    Part feature of its edges. The copies follow nothing and open without this workbench.

    Args:
        features: a Net, a Structure, or several in one document.

    Returns:
        One group for each.

    Raises:
        InputError: neither a net nor a structure, or one that is empty; nothing was changed.
    """
    chosen = list(features) if isinstance(features, (list, tuple)) else [features]
    if not chosen:
        raise InputError("bake: nothing is selected; select nets or structures")
    for feature in chosen:
        _refuse_unfit(feature)
    with transaction(chosen[0].Document, FreeCAD.Qt.translate("Ortho", "Bake")):
        return [_baked(feature) for feature in chosen]


def _refuse_unfit(feature: FreeCAD.DocumentObject) -> None:
    places.refuse_link(feature)
    if is_net(feature):
        convert.quad_mesh(feature)
    elif not structure_object.is_structure(feature):
        name = getattr(feature, "Label", feature)
        raise InputError(f"bake: {name} is neither a net nor a structure; select one of these")
    elif len(feature.Shape.Solids) != len(feature.PartNames) or not feature.PartNames:
        raise InputError(f"bake: {feature.Label} has no parts; recompute it first")


def _baked(feature: FreeCAD.DocumentObject) -> FreeCAD.DocumentObject:
    document = feature.Document
    group = document.addObject("App::DocumentObjectGroup", "Baked")
    group.Label = FreeCAD.Qt.translate("Ortho", "{} (baked)").format(feature.Label)
    places.join_container(group, feature)
    if is_net(feature):
        group.addObjects(_plain_net(feature))
    else:
        for name, solid in zip(feature.PartNames, feature.Shape.Solids, strict=True):
            part = document.addObject("Part::Feature", name)
            part.Label = name
            part.Shape = solid
            group.addObject(part)
    # They follow nothing, so there is nothing to recompute and no mark to bear.
    for item in (*group.Group, group):
        item.purgeTouched()
    return group


def _plain_net(net: FreeCAD.DocumentObject) -> list[FreeCAD.DocumentObject]:
    import Mesh
    import Part

    quads = convert.quad_mesh(net)
    # FreeCAD's meshes have seven digits: far from the origin they lie about a point nearby.
    local = LocalOrigin.of_mesh(quads)
    quads, place = local.near_mesh(quads), FreeCAD.Placement()
    place.Base = convert.vectors(local.shift[None])[0]
    corners = convert.vectors(quads.vertices)
    triangles = [
        [corners[vertex] for vertex in triangle]
        for triangle in quads.connectivity.triangles.tolist()
    ]
    mesh = net.Document.addObject("Mesh::Feature", "Mesh")
    mesh.Label = FreeCAD.Qt.translate("Ortho", "{} mesh").format(net.Label)
    mesh.Mesh = Mesh.Mesh(triangles)
    mesh.Placement = place
    edges = net.Document.addObject("Part::Feature", "Edges")
    edges.Label = FreeCAD.Qt.translate("Ortho", "{} edges").format(net.Label)
    edges.Shape = Part.makeCompound(
        [
            Part.makeLine(corners[first], corners[second])
            for first, second in quads.connectivity.edges.tolist()
        ]
    )
    edges.Placement = place
    return [mesh, edges]
