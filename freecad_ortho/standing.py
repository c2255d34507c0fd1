"""From a net to a structural check, and from the check to files: one call each."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from freecad_ortho.keywords import DesignSettings
from freecad_ortho.mesh_files import DEFAULT_UNIT
from freecad_ortho.structural.check import StructuralCheck, check_model
from freecad_ortho.structural.combinations import combinations_of
from freecad_ortho.structural.design import Design
from freecad_ortho.structural.files import write_check
from freecad_ortho.structural.model import model_of
from freecad_ortho.structural.sizing import Sizing, least, sections_of
from freecad_ortho.units import millimetres_per
from solver.mesh.local_origin import LocalOrigin
from solver.mesh.quadmesh import QuadMesh

if TYPE_CHECKING:
    # Of the standard library from Python 3.11 on.
    from typing_extensions import Unpack


def check_structure(
    mesh: QuadMesh,
    *,
    unit: str = DEFAULT_UNIT,
    combinations: str | os.PathLike[str] | Sequence[str] | None = None,
    progress: Callable[[float, str], None] | None = None,
    **design: Unpack[DesignSettings],
) -> StructuralCheck:
    """Check a grid shell as a frame of members on the edges of its net.

    Args:
        mesh: the net, z upwards, in ``unit``.
        unit: of its coordinates.
        combinations: of the load cases: a JSON file, or lines as ``"strength: 1.35 self-weight +
            1.5 snow"``; those of EN 1990 by default.
        progress: called with a fraction and words; may raise to stop.
        design: members, supports and loads by name (``section="tube:100x60x5", snow=1.5,
            wind=["0.6@x"]``), see :class:`freecad_ortho.keywords.DesignSettings`; kN and m,
            lengths in mm.

    Raises:
        InputError: what cannot be used: a mechanism, a loose part, no supports, no loads.
    """
    chosen = Design.of(design)
    near = LocalOrigin.of_mesh(mesh).near_mesh(mesh).scaled(millimetres_per(unit))
    model = model_of(near, chosen)
    return check_model(model, combinations_of(combinations, model.cases), progress)


def size_structure(
    mesh: QuadMesh,
    sections: str,
    *,
    unit: str = DEFAULT_UNIT,
    combinations: str | os.PathLike[str] | Sequence[str] | None = None,
    progress: Callable[[float, str], None] | None = None,
    **design: Unpack[DesignSettings],
) -> Sizing:
    """Find the lightest section with which a grid shell passes ``check_structure``.

    All members have the same one.

    Args:
        mesh: the net, z upwards, in ``unit``.
        sections: a list (tubes, plates, glulam) or names of sections joined by "+".
        unit: of its coordinates.
        combinations: as of ``check_structure``.
        progress: called with a fraction and words; may raise to stop.
        design: as of ``check_structure``, but the section.

    Raises:
        InputError: what cannot be used.
    """

    def check(name: str) -> StructuralCheck:
        chosen: DesignSettings = {**design, "section": name, "second_order": False}
        found = check_structure(mesh, unit=unit, combinations=combinations, **chosen)
        # Balance in the deformed shape takes longest, and only what holds without it needs it.
        if not design.get("second_order") or found.fails_first_order:
            return found
        chosen["second_order"] = True
        return check_structure(mesh, unit=unit, combinations=combinations, **chosen)

    return least(sections_of(sections, design.get("material", "")), check, progress)


def write_structural_check(
    check: StructuralCheck | Sizing, folder: str | os.PathLike[str], project: str = ""
) -> list[Path]:
    """Write a check's tables, its model for other programs and a page to read, all or none.

    Args:
        check: from ``check_structure`` or ``size_structure``.
        folder: made when missing; other files in it stay.
        project: what the page is headed by, such as the name of the net.

    Returns:
        The files.

    Raises:
        OutputError: the folder cannot be written.
    """
    if isinstance(check, Sizing):
        return write_check(check.check, folder, project, check.tries)
    return write_check(check, folder, project)
