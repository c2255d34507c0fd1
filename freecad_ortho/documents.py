"""The document functions behind :mod:`freecad_ortho.api`: from a macro, a command or a script.

Each one is undone in one step. Lengths are numbers of mm, FreeCAD quantities, or texts such as
``"0.2 m"``. Errors in what was given are :class:`solver.errors.InputError` and leave the document
as it was.
"""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import FreeCAD

from freecad_ortho import convert, mend_class_checks
from freecad_ortho.fabrication import BeamSettings, PanelSettings
from freecad_ortho.fabrication.packages import missing_package_named
from freecad_ortho.objects import build
from freecad_ortho.objects import net as net_object
from freecad_ortho.objects import structure as structure_object
from freecad_ortho.units import millimetres_per
from solver.errors import InputError

if TYPE_CHECKING:
    from solver.mesh.quadmesh import FloatArray

    Length = float | str | FreeCAD.Units.Quantity

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
    target = _document(document, Path(path).stem)
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


def add_beams(
    net: FreeCAD.DocumentObject,
    height: Length = 200.0,
    thickness: Length = 12.0,
    offset: str = "centre",
) -> FreeCAD.DocumentObject:
    """Add a Structure with a beam on every edge of a Net.

    Args:
        net: the Net.
        height: height of the beams.
        thickness: thickness of the plates.
        offset: ``above``, ``centre`` or ``below`` the net.

    Raises:
        InputError: sizes that do not fit the mesh; the document is unchanged.
    """
    require_net(net)
    settings = BeamSettings(
        height=convert.millimetres(height, "height"),
        thickness=convert.millimetres(thickness, "thickness"),
        offset=offset,
    )
    return _add_structure(
        net,
        structure_object.BEAMS,
        FreeCAD.Qt.translate("Ortho", "Beams"),
        Height=settings.height,
        Thickness=settings.thickness,
        Offset=settings.offset.capitalize(),
    )


def add_panels(
    net: FreeCAD.DocumentObject,
    thickness: Length = 12.0,
    gap: Length = 10.0,
    offset: str = "above",
    beams: FreeCAD.DocumentObject | None = None,
) -> FreeCAD.DocumentObject:
    """Add a Structure with a panel in every face of a Net.

    Args:
        net: the Net.
        thickness: thickness of the panels.
        gap: width of the joint between neighbours.
        offset: ``above``, ``centre`` or ``below`` the net; on beams they lie on top of these.
        beams: a Structure of beams on the same Net that the panels lie on.

    Raises:
        InputError: sizes that do not fit the mesh; the document is unchanged.
    """
    require_net(net)
    settings = PanelSettings(
        thickness=convert.millimetres(thickness, "thickness"),
        gap=convert.millimetres(gap, "gap"),
        offset=offset,
    )
    return _add_structure(
        net,
        structure_object.PANELS,
        FreeCAD.Qt.translate("Ortho", "Panels"),
        Thickness=settings.thickness,
        Gap=settings.gap,
        Offset=settings.offset.capitalize(),
        OnBeams=beams,
    )


def export_fabrication(
    structures: FreeCAD.DocumentObject | Sequence[FreeCAD.DocumentObject],
    folder: str | os.PathLike[str],
) -> list[Path]:
    """Write STEP, DXF, parts list and report of structures on one net.

    Args:
        structures: a Structure, or beams and panels of the same Net.
        folder: made if it is not there.

    Returns:
        The files written.

    Raises:
        InputError: nothing to export, or structures that do not go together.
        OutputError: the folder cannot be written; nothing half-written is left behind.
        OrthoError: Esc was pressed; the folder is as it was.
    """
    from freecad_ortho import api

    chosen = list(structures) if isinstance(structures, (list, tuple)) else [structures]
    structure = build.structure(chosen)
    with (
        missing_package_named(),
        _progress(FreeCAD.Qt.translate("Ortho", "Writing fabrication files")) as progress,
    ):
        api.write_fabrication(structure, folder, progress)
    return sorted(path for path in Path(folder).iterdir() if path.is_file())


def save_picture(
    path: str | os.PathLike[str],
    document: FreeCAD.Document | None = None,
    width: int = 1600,
    height: int = 1000,
    background: str = "White",
) -> None:
    """Save a rendered picture of a document, seen from the front above, fitted to the picture.

    Args:
        path: a PNG file.
        document: without it the active one.
        width: in pixels.
        height: in pixels.
        background: a colour name, ``Current`` or ``Transparent``.

    Raises:
        InputError: FreeCAD runs without a window, or no document is open.
    """
    if not FreeCAD.GuiUp:
        raise InputError(
            "picture: FreeCAD runs without a window; run the script with 'freecad' "
            "(under xvfb-run on a machine without a screen), not with 'freecadcmd'"
        )
    from freecad_ortho.view import picture

    picture.save(os.fspath(path), _open_document(document), width, height, background)


@contextmanager
def transaction(document: FreeCAD.Document, title: str) -> Iterator[None]:
    """Make what happens inside one undo step, and nothing at all if it fails.

    Inside a transaction that is already open it becomes part of that one.
    """
    if document.HasPendingTransaction:
        yield
        return
    document.openTransaction(title)
    try:
        yield
    except BaseException:
        document.abortTransaction()
        raise
    document.commitTransaction()


def require_net(feature: Any) -> None:
    """Raise InputError unless a document object is a Net."""
    if not net_object.is_net(feature):
        name = getattr(feature, "Label", feature)
        raise InputError(f"net: expected a Net, got {name}; import a quad mesh first")


@contextmanager
def _progress(title: str) -> Iterator[Callable[[float, str], None] | None]:
    """Show how far long work is where there is a window."""
    if not FreeCAD.GuiUp:
        yield None
        return
    from freecad_ortho.view import progress

    with progress.shown(title) as move:
        yield move


def _add_structure(
    net: FreeCAD.DocumentObject, system: str, title: str, **properties: Any
) -> FreeCAD.DocumentObject:
    document = net.Document
    with transaction(document, title):
        feature = structure_object.create(document, system, Net=net, **properties)
        try:
            structure_object.rebuild(feature)
        except BaseException:
            # Aborting takes it away too, but only where the document records undo steps.
            document.removeObject(feature.Name)
            raise
        feature.purgeTouched()
        # As Part does with what a shape is made of: otherwise both are drawn into each other.
        net.Visibility = False
    return feature


def _key(
    target: FreeCAD.DocumentObject, settings: dict[str, Any], start: FloatArray
) -> tuple[Any, ...]:
    chosen = json.dumps(settings, sort_keys=True, default=str)
    return target.Document.Name, target.Name, chosen, start.tobytes()


def _document(document: FreeCAD.Document | str | None, label: str) -> FreeCAD.Document:
    if isinstance(document, str):
        return FreeCAD.getDocument(document)
    return document or FreeCAD.ActiveDocument or FreeCAD.newDocument(label)


def _open_document(document: FreeCAD.Document | None) -> FreeCAD.Document:
    chosen = document or FreeCAD.ActiveDocument
    if chosen is None:
        raise InputError("document: none is open; open or create one first")
    return chosen
