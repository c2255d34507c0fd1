"""Nets in documents: reading and optimising them."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import FreeCAD

from freecad_ortho import convert, mend_class_checks
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


def optimise_net(target: FreeCAD.DocumentObject, /, **settings: Any) -> Any:
    """Optimise a Net in its document; structures on it follow.

    Args:
        target: the Net.
        settings: as for :func:`freecad_ortho.api.optimise` (``net``, ``fairness``, ...).

    Returns:
        The outcome, its mesh in mm; the report is also in the Net's ``LastReport``.

    Raises:
        InputError: settings that do not fit the mesh; the Net is unchanged.
    """
    from freecad_ortho import api

    require_net(target)
    mend_class_checks()
    mesh = convert.quad_mesh(target)
    outcome = _ready.pop(_key(target, settings, mesh.vertices), None)
    if outcome is None:
        outcome = api.optimise(mesh, **settings)
    with transaction(target.Document, FreeCAD.Qt.translate("Ortho", "Optimise")):
        convert.store_vertices(target, outcome.mesh.vertices)
        target.LastReport = json.dumps(outcome.report.as_dict())
        target.Document.recompute()
    return outcome


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
