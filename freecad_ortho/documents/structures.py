"""Structures in documents: adding them to nets and writing what a workshop needs."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import FreeCAD

from freecad_ortho import convert
from freecad_ortho.documents.common import progress, require_net, transaction
from freecad_ortho.fabrication import Beams, Panels
from freecad_ortho.fabrication.packages import missing_package_named
from freecad_ortho.objects import build
from freecad_ortho.objects import structure as structure_object

if TYPE_CHECKING:
    Length = float | str | FreeCAD.Units.Quantity


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
    settings = Beams(
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
    settings = Panels(
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
        progress(FreeCAD.Qt.translate("Ortho", "Writing fabrication files")) as say,
    ):
        api.write_fabrication(structure, folder, say)
    return sorted(path for path in Path(folder).iterdir() if path.is_file())


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
