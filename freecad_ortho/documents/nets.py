"""Nets in documents: reading and optimising them."""

from __future__ import annotations

import json
import os
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import FreeCAD

from freecad_ortho import convert
from freecad_ortho.documents.common import document_or_new, require_net, transaction
from freecad_ortho.objects import net as net_object
from freecad_ortho.units import millimetres_per

if TYPE_CHECKING:
    from solver.mesh.quadmesh import FloatArray

# The result of a run that a task panel has just watched, for the one call that records it.
_ready: dict[tuple[Any, ...], Any] = {}


def import_net(
    path: str | os.PathLike[str],
    document: FreeCAD.Document | str | None = None,
    unit: str | None = None,
) -> FreeCAD.DocumentObject:
    """Read an OBJ file with quads and add a Net to a document.

    Args:
        path: the OBJ file.
        document: a document or its name; without it the active one, or a new one.
        unit: ``mm``, ``cm``, ``m``, ``in`` or ``ft``; without it what the file says.

    Returns:
        The new Net, in mm.

    Raises:
        InputError: the file does not hold a usable quad mesh.
    """
    from freecad_ortho import api

    loaded = api.read_mesh(path, unit)
    target = document_or_new(document, Path(path).stem)
    with transaction(target, FreeCAD.Qt.translate("Ortho", "Import quad mesh")):
        mesh = loaded.mesh.scaled(millimetres_per(loaded.unit))
        net = net_object.create(target, mesh, Path(path).stem)
        net.Unit = loaded.unit
        net.SourceFile = os.fspath(path)
        target.recompute()
    for remark in loaded.remarks:
        FreeCAD.Console.PrintWarning(f"{net.Label}: {remark}\n")
    return net


def optimise_net(target: FreeCAD.DocumentObject, /, close_to: Any = None, **settings: Any) -> Any:
    """Optimise a Net in its document; structures on it follow.

    A Net that was made by a source keeps the result and no longer follows that source.

    Args:
        target: the Net.
        close_to: a surface to stay near: a shape, ``(shape, "Face1")``, a list of these, or a Net
            that was sampled from faces.
        settings: as for :func:`freecad_ortho.api.optimise` (``net``, ``fairness``, ...).

    Returns:
        The outcome, its mesh in mm; the report is also in the Net's ``LastReport``.

    Raises:
        InputError: settings that do not fit the mesh; the Net is unchanged.
    """
    from freecad_ortho import api

    require_net(target)
    mesh = convert.quad_mesh(target)
    if close_to is not None:
        settings["constraints"] = _close_to(close_to, settings.get("constraints"))
    outcome = _ready.pop(_key(target, settings, mesh.vertices), None)
    if outcome is None:
        outcome = api.optimise(mesh, **settings)
    with transaction(target.Document, FreeCAD.Qt.translate("Ortho", "Optimise")):
        convert.store_vertices(target, outcome.mesh.vertices)
        target.LastReport = json.dumps(outcome.report.as_dict())
        target.Document.recompute()
    return outcome


def _close_to(surface: Any, constraints: Any) -> Any:
    """Constraints with closeness to CAD faces, which stand as fine triangles."""
    from freecad_ortho.objects import cad_faces
    from solver import Constraints

    faces = getattr(surface, "CadFaces", None) or surface
    triangles = cad_faces.surface_triangles(cad_faces.faces_of(faces))
    return replace(constraints or Constraints(), close_to=triangles)


def keep_outcome(
    target: FreeCAD.DocumentObject, settings: dict[str, Any], start: FloatArray, outcome: Any
) -> None:
    """Hand in what :func:`optimise_net` would compute from here, when it has been computed already.

    Args:
        target: the Net.
        settings: exactly the settings of the coming call.
        start: (V, 3) positions of the Net that the run began with.
        outcome: the result of the run.
    """
    _ready.clear()
    _ready[_key(target, settings, start)] = outcome


def _key(
    target: FreeCAD.DocumentObject, settings: dict[str, Any], start: FloatArray
) -> tuple[Any, ...]:
    chosen = json.dumps(settings, sort_keys=True, default=str)
    return target.Document.Name, target.Name, chosen, start.tobytes()
