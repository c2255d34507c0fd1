"""What macros, toolbar commands and the command line call.

The first half needs no FreeCAD. The functions on documents (``import_net`` and its kin) live in
:mod:`freecad_ortho.documents` and are found here too, so that a macro imports one module; without
FreeCAD they can be looked up, and say that they need it where they are called.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from freecad_ortho.calls import list_keywords
from freecad_ortho.mesh_files import read_mesh_file
from freecad_ortho.stand_in import stand_in
from freecad_ortho.step_faces import net_from_step
from freecad_ortho.units import MILLIMETRES, millimetres_per
from solver import QuadMesh, optimise, start_optimisation, write_mesh
from solver.analysis.check import check
from solver.errors import InputError
from solver.formfinding import find_form
from solver.io.polygons import quads_of
from solver.mesh.diagonal import diagonal_meshes
from solver.mesh.local_origin import LocalOrigin
from solver.mesh.primitives import primitive
from solver.mesh.remesh import quads_from_triangles
from solver.multinet import Quadric, elliptic_net, multi_net
from solver.offset.offset_mesh import offset_mesh
from solver.unroll.patch import flattened

if TYPE_CHECKING:
    # Of the standard library from Python 3.11 on.
    from typing_extensions import Unpack

    from freecad_ortho.documents import (
        add_beams,
        add_bent_panels,
        add_drawing_page,
        add_drawing_pages,
        add_elliptic_net,
        add_flat_patterns,
        add_lamellas,
        add_louvres,
        add_multi_net,
        add_nodes,
        add_panels,
        add_patches,
        add_primitive,
        add_source,
        add_structure,
        bake,
        change_flat_patterns,
        change_net,
        change_source,
        change_structure,
        drag_net,
        dragging,
        export_fabrication,
        export_net,
        flip_net,
        form_net,
        import_net,
        keep_outcome,
        net_from_faces,
        open_example,
        optimise_net,
        quads_from_mesh,
        save_picture,
        set_net,
        show_net,
        update_structures,
        weld_nets,
    )
    from freecad_ortho.fabrication import Limits, Structure
    from freecad_ortho.keywords import Sizes, WorkshopSettings

DEFAULT_UNIT = "mm"
# A mesh without a unit that is smaller than this in mm may well be in metres.
_SMALL = 100.0

__all__ = [
    "LoadedMesh",
    "Quadric",
    "add_beams",
    "add_bent_panels",
    "add_drawing_page",
    "add_drawing_pages",
    "add_elliptic_net",
    "add_flat_patterns",
    "add_lamellas",
    "add_louvres",
    "add_multi_net",
    "add_nodes",
    "add_panels",
    "add_patches",
    "add_primitive",
    "add_source",
    "add_structure",
    "bake",
    "change_flat_patterns",
    "change_net",
    "change_source",
    "change_structure",
    "check",
    "diagonal_meshes",
    "drag_net",
    "dragging",
    "elliptic_net",
    "export_fabrication",
    "export_net",
    "fabricate",
    "find_form",
    "flattened",
    "flip_net",
    "form_net",
    "import_net",
    "keep_outcome",
    "multi_net",
    "net_from_faces",
    "net_from_step",
    "offset_mesh",
    "open_example",
    "optimise",
    "optimise_net",
    "primitive",
    "quads_from_mesh",
    "quads_from_triangles",
    "read_mesh",
    "save_picture",
    "set_net",
    "show_net",
    "start_optimisation",
    "update_structures",
    "weld_nets",
    "write_fabrication",
    "write_mesh",
]


@dataclass(frozen=True)
class LoadedMesh:
    """A mesh from a file.

    Attributes:
        mesh: positions in the file's unit.
        unit: mm, cm, m, in or ft.
        remarks: what was mended or is unusual, in plain words.
    """

    mesh: QuadMesh
    unit: str
    remarks: tuple[str, ...]

    @cached_property
    def origin(self) -> LocalOrigin:
        """Point near the mesh where it is far from the origin, in the file's unit."""
        return LocalOrigin.of_mesh(self.mesh)

    @cached_property
    def near(self) -> QuadMesh:
        """The mesh about that point; the mesh itself where it is not far."""
        return self.origin.near_mesh(self.mesh)


def read_mesh(path: str | os.PathLike[str], unit: str | None = None, up: str = "z") -> LoadedMesh:
    """Read a quad mesh; its unit is the one given, else the one the file names, else mm.

    Args:
        path: an OBJ, PLY, OFF, JSON or VTK file.
        unit: of its coordinates.
        up: ``z``, or ``y`` for a file whose y points up: it is turned about x.

    Raises:
        InputError: the file is missing or is not a usable quad mesh.
    """
    data = read_mesh_file(path, up)
    if not unit and data.unit and data.unit not in MILLIMETRES:
        where = f", line {data.unit_line}" if data.unit_line else ""
        raise InputError(
            f"{os.fspath(path)}{where}: the unit '{data.unit}' is not known; say it as one of "
            f"{', '.join(MILLIMETRES)}"
        )
    chosen = unit or data.unit or DEFAULT_UNIT
    millimetres_per(chosen)
    mesh, remarks = quads_of(data, path)
    width = float(np.ptp(mesh.vertices[mesh.connectivity.referenced], axis=0).max())
    if not (unit or data.unit) and width < _SMALL:
        remarks.append(
            f"no unit is said, taken as mm: the mesh is {width:.2g} mm wide; if that is wrong say "
            "the unit (--unit m, or unit of imported meshes in FreeCAD's preferences)"
        )
    return LoadedMesh(mesh, chosen, tuple(remarks))


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
        sizes: settings of the systems by name (``height=200, thickness=12, gap=10``), see
            :class:`freecad_ortho.keywords.Sizes`; lengths in mm, each is of one of the systems at
            least.

    Raises:
        InputError: a parameter that cannot be used or does not fit the net.
    """
    from freecad_ortho import fabrication

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
    )


def write_fabrication(
    structure: Structure,
    folder: str | os.PathLike[str],
    progress: Callable[[float, str], None] | None = None,
    *,
    workers: int | None = None,
    executor: Executor | None = None,
    project: str = "",
    origin: str | Sequence[float] = "local",
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
        origin: what coordinates in the files are measured from: ``local`` for the round point near
            a net that is far from the origin, ``keep`` for the model's own origin, or a point, mm.
        workshop: settings of ``fabrication.Workshop`` (``sheet="3000x1500", kerf=0.2``), mm.

    Returns:
        The files.

    Raises:
        InputError: settings that cannot be used, a part that does not fit sheet or stock.
        OutputError: the folder cannot be written.
    """
    from freecad_ortho import fabrication

    chosen = fabrication.Workshop.of(workshop)
    with fabrication.local_pool(None if executor else workers) as pool:
        return fabrication.write(
            structure.measured_from(origin),
            folder,
            progress,
            workshop=chosen,
            executor=executor or pool,
            project=project,
        )


def __getattr__(name: str) -> Any:
    """Find the functions on FreeCAD documents without importing FreeCAD before it is needed."""
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    try:
        from freecad_ortho import documents
    except ModuleNotFoundError as error:
        if error.name != "FreeCAD":
            raise
        return stand_in(name)
    return getattr(documents, name)


def __dir__() -> list[str]:
    """Names of all functions, those on documents too."""
    return sorted({*globals(), *__all__})


list_keywords(__all__, globals())
