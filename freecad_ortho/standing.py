"""From a net to a structural check, and from the check to files: one call each."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from freecad_ortho.keywords import DesignSettings
from freecad_ortho.mesh_files import DEFAULT_UNIT
from freecad_ortho.structural.check import StructuralCheck, check_model
from freecad_ortho.structural.combinations import combinations_of
from freecad_ortho.structural.design import Design
from freecad_ortho.structural.files import write_check
from freecad_ortho.structural.model import families_of, model_of
from freecad_ortho.structural.sizing import Sizing, least, sections_of
from freecad_ortho.structural.sizing_groups import (
    ALL,
    BANDS,
    bands_of,
    by_groups,
    refuse_unknown_grouping,
)
from freecad_ortho.units import millimetres_per
from solver.mesh.local_origin import LocalOrigin
from solver.mesh.quadmesh import QuadMesh, refuse_other

if TYPE_CHECKING:
    # Of the standard library from Python 3.11 on.
    from typing_extensions import Unpack


def check_structure(
    mesh: QuadMesh,
    *,
    unit: str = DEFAULT_UNIT,
    combinations: str | os.PathLike[str] | Sequence[str] | None = None,
    progress: Callable[[float, str], None] | None = None,
    groups: Sequence[str] | None = None,
    **design: Unpack[DesignSettings],
) -> StructuralCheck:
    """Check a grid shell as a frame of members on the edges of its net.

    Args:
        mesh: the net, z upwards, in ``unit``.
        unit: of its coordinates.
        combinations: of the load cases: a JSON file, or lines as ``"strength: 1.35 self-weight +
            1.5 snow"``; those of EN 1990 by default.
        progress: called with a fraction and words; may raise to stop.
        groups: name of the group of every edge that the section may speak of, by default its
            family: ``u``, ``v``, ``border`` or ``inner``.
        design: members, supports and loads by name (``section="tube:100x60x5", snow=1.5,
            wind=["0.6@x"]``), see :class:`freecad_ortho.keywords.DesignSettings`; kN and m,
            lengths in mm.

    Raises:
        InputError: what cannot be used: a mechanism, a loose part, no supports, no loads.
    """
    refuse_other(mesh)
    near = LocalOrigin.of_mesh(mesh).near_mesh(mesh).scaled(millimetres_per(unit))
    model = model_of(near, Design.of(design), groups)
    return check_model(model, combinations_of(combinations, model.cases), progress)


def size_structure(
    mesh: QuadMesh,
    sections: str,
    *,
    groups: str = "all",
    unit: str = DEFAULT_UNIT,
    combinations: str | os.PathLike[str] | Sequence[str] | None = None,
    progress: Callable[[float, str], None] | None = None,
    **design: Unpack[DesignSettings],
) -> Sizing:
    """Find the lightest section with which a grid shell passes ``check_structure``.

    Args:
        mesh: the net, z upwards, in ``unit``.
        sections: a list (tubes, plates, glulam) or names of sections joined by "+".
        groups: ``all`` members have the same one; or one for each of the ``families`` (u, v,
            border, inner), or for each of three ``bands`` of members by how far they are used.
        unit: of its coordinates.
        combinations: as of ``check_structure``.
        progress: called with a fraction and words; may raise to stop.
        design: as of ``check_structure``, but the section.

    Raises:
        InputError: what cannot be used.
    """
    refuse_other(mesh)
    refuse_unknown_grouping(groups)
    names, words = sections_of(sections, design.get("material", "")), families_of(mesh)

    def first_order(text: str) -> StructuralCheck:
        chosen: DesignSettings = {**design, "section": text, "second_order": False}
        common: Any = {"unit": unit, "combinations": combinations}
        return check_structure(mesh, groups=words, **common, **chosen)

    def check(text: str) -> StructuralCheck:
        found = first_order(text)
        # Balance in the deformed shape takes longest, and only what holds without it needs it.
        if not design.get("second_order") or found.fails_first_order:
            return found
        chosen: DesignSettings = {**design, "section": text, "second_order": True}
        return check_structure(mesh, unit=unit, combinations=combinations, groups=words, **chosen)

    if groups == ALL:
        return least(names, check, progress)
    if groups == BANDS:
        words = bands_of(first_order(names[0]))
    return by_groups(names, words, check, progress)


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
