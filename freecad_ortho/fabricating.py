"""From a net to parts, and from parts to files: one call each."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from freecad_ortho import fabrication
from freecad_ortho.fabrication import Limits, Structure
from freecad_ortho.fabrication.report.way import StagesBefore
from freecad_ortho.keywords import Sizes, WorkshopSettings
from freecad_ortho.mesh_files import DEFAULT_UNIT
from freecad_ortho.structural.check import StructuralCheck
from freecad_ortho.structural.numbers import check_numbers
from freecad_ortho.units import millimetres_per
from solver.errors import InputError
from solver.mesh.local_origin import LocalOrigin
from solver.mesh.quadmesh import FloatArray, QuadMesh, refuse_other

if TYPE_CHECKING:
    # Of the standard library from Python 3.11 on.
    from typing_extensions import Unpack


def fabricate(
    mesh: QuadMesh,
    system: str = "beams+panels",
    *,
    unit: str = DEFAULT_UNIT,
    family: str = "both",
    lines: Sequence[int] | None = None,
    material: str = "steel",
    density: float | None = None,
    limits: Limits | None = None,
    progress: Callable[[float, str], None] | None = None,
    border: Sequence[ArrayLike] = (),
    **sizes: Unpack[Sizes],
) -> Structure:
    """Turn an optimised net into the parts of one or more systems.

    Args:
        mesh: the net, in ``unit``.
        system: names of systems joined by "+".
        unit: unit of the mesh's coordinates.
        family: parameter lines to build on: "u", "v" or "both".
        lines: numbers of the lines in these families, None for all.
        material: name of a preset for everything (``"steel"``), of single systems after their names
            (``"panels=glass"``), or both (``"steel,panels=glass"``).
        density: kg/m3, for the masses; by default the material's. Not of systems whose material is
            named for them alone.
        limits: what the parts are held against.
        progress: called with a fraction and words; may raise to stop.
        border: closed polylines (N, 3) in ``unit`` along which parts are trimmed, such as those of
            ``read_mesh(path).border``.
        sizes: settings of the systems by name (``height=200, thickness=12, gap=10``), see
            :class:`freecad_ortho.keywords.Sizes`; lengths in mm, each is of one of the systems at
            least.

    Raises:
        InputError: a parameter that cannot be used or does not fit the net.
    """
    refuse_other(mesh)
    materials = fabrication.materials_of(material, system.split("+"), density)
    scale, origin = millimetres_per(unit), LocalOrigin.of_mesh(mesh)
    shift = origin.scaled(scale).shift
    return fabrication.build(
        origin.near_mesh(mesh).scaled(scale),
        fabrication.systems_of(system, sizes, materials),
        material=materials,
        limits=limits,
        selection=fabrication.Selection(family, None if lines is None else tuple(lines)),
        progress=progress,
        place=fabrication.Place(origin=shift),
        origin=shift,
        border=[scale * origin.near(line) for line in _lines(border)],
    )


def _lines(border: Sequence[ArrayLike]) -> list[FloatArray]:
    """Closed polylines (N, 3).

    Raises:
        InputError: anything else.
    """
    lines = [np.asarray(line, dtype=np.float64) for line in border]
    for line in lines:
        if line.ndim != 2 or line.shape[1] != 3 or len(line) < 3 or not np.isfinite(line).all():
            raise InputError(
                f"border: expected closed polylines (N, 3) of three points or more, got one of "
                f"shape {line.shape}; mend it or leave it out"
            )
    return lines


def write_fabrication(
    structure: Structure,
    folder: str | os.PathLike[str],
    progress: Callable[[float, str], None] | None = None,
    *,
    workers: int | None = None,
    executor: Executor | None = None,
    project: str = "",
    way: StagesBefore | None = None,
    origin: str | Sequence[float] = "local",
    check: StructuralCheck | Mapping[str, Any] | str | os.PathLike[str] | None = None,
    **workshop: Unpack[WorkshopSettings],
) -> list[Path]:
    """Write solids, flat patterns, lists and reports, all or none.

    Args:
        structure: from ``fabricate``.
        folder: made when missing; other files in it stay.
        progress: called with a fraction and words; whatever it raises stops the writing.
        workers: processes on this machine to share the work on parts.
        executor: any ``concurrent.futures`` executor to do so instead, e.g. that of a cluster.
        project: what the readable report is headed by, such as the name of the mesh.
        way: how the net came to be, which the reports begin with.
        origin: what coordinates in the files are measured from: ``local`` for the round point near
            a net that is far from the origin, ``keep`` for the model's own origin, or a point, mm.
        check: of ``check_structure`` on the same net, or the ``check.json`` that it wrote, which
            the reports tell.
        workshop: settings of ``fabrication.Workshop`` (``sheet="3000x1500", kerf=0.2``), mm.

    Returns:
        The files.

    Raises:
        InputError: settings that cannot be used, a part that does not fit sheet or stock.
        OutputError: the folder cannot be written.
    """
    chosen = fabrication.Workshop.of(workshop)
    told = None if check is None else _told(check, len(structure.mesh.connectivity.edges))
    with fabrication.local_pool(None if executor else workers) as pool:
        return fabrication.write(
            structure.measured_from(origin),
            folder,
            progress,
            workshop=chosen,
            executor=executor or pool,
            project=project,
            way=way,
            check=told,
        )


def _told(
    check: StructuralCheck | Mapping[str, Any] | str | os.PathLike[str], edges: int
) -> Mapping[str, Any]:
    """Numbers of a structural check of a net with so many edges.

    Raises:
        InputError: no such check, or one of another net.
    """
    if isinstance(check, (str, os.PathLike)):
        found = _read_check(check)
    else:
        found = check_numbers(check) if isinstance(check, StructuralCheck) else check
    if found["members"] != edges:
        raise InputError(
            f"check: is of a net with {found['members']} edges, and this one has {edges}; check "
            "this one"
        )
    return found


def _read_check(path: str | os.PathLike[str]) -> Mapping[str, Any]:
    name = os.fspath(path)
    try:
        found = json.loads(Path(path).read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise InputError(
            f"check: {name} cannot be read as JSON ({error}); give the check.json of a structural "
            "check"
        ) from error
    if not isinstance(found, dict) or "governing_members" not in found:
        raise InputError(f"check: {name} is no check.json of a structural check; give one")
    return found
