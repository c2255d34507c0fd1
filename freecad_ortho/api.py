"""What macros, toolbar commands and the command line call.

The first half needs no FreeCAD. The functions on documents (``import_net`` and its kin) live in
:mod:`freecad_ortho.documents` and are found here too, so that a macro imports one module; without
FreeCAD they can be looked up, and say that they need it where they are called.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from freecad_ortho.building import build_surface
from freecad_ortho.calls import list_keywords
from freecad_ortho.fabricating import fabricate, write_fabrication
from freecad_ortho.mesh_files import ReadMesh, read_mesh
from freecad_ortho.stand_in import stand_in
from freecad_ortho.standing import check_structure, size_structure, write_structural_check
from freecad_ortho.step_faces import net_from_step
from freecad_ortho.tolerating import tolerances
from solver import optimise, start_optimisation, write_mesh
from solver.analysis.check import check
from solver.formfinding import find_form
from solver.mesh.diagonal import diagonal_meshes
from solver.mesh.primitives import primitive
from solver.mesh.remesh import quads_from_triangles
from solver.multinet import Quadric, elliptic_net, multi_net
from solver.offset.offset_mesh import offset_mesh
from solver.unroll.patch import flattened

if TYPE_CHECKING:
    from freecad_ortho.documents import (
        add_arches,
        add_beams,
        add_bent_panels,
        add_drawing_page,
        add_drawing_pages,
        add_edge_beam,
        add_elliptic_net,
        add_feet,
        add_fem_analysis,
        add_flat_patterns,
        add_lamellas,
        add_louvres,
        add_multi_net,
        add_nodes,
        add_panels,
        add_patches,
        add_primitive,
        add_source,
        add_structural_check,
        add_structure,
        bake,
        change_flat_patterns,
        change_net,
        change_source,
        change_structural_check,
        change_structure,
        drag_net,
        dragging,
        export_fabrication,
        export_net,
        flip_net,
        form_net,
        import_net,
        keep_outcome,
        net_along_curvature,
        net_from_faces,
        open_example,
        optimise_again,
        optimise_net,
        quads_from_mesh,
        save_picture,
        set_net,
        show_net,
        size_structural_check,
        update_structures,
        weld_nets,
        write_check_files,
    )

__all__ = [
    "Quadric",
    "ReadMesh",
    "add_arches",
    "add_beams",
    "add_bent_panels",
    "add_drawing_page",
    "add_drawing_pages",
    "add_edge_beam",
    "add_elliptic_net",
    "add_feet",
    "add_fem_analysis",
    "add_flat_patterns",
    "add_lamellas",
    "add_louvres",
    "add_multi_net",
    "add_nodes",
    "add_panels",
    "add_patches",
    "add_primitive",
    "add_source",
    "add_structural_check",
    "add_structure",
    "bake",
    "build_surface",
    "change_flat_patterns",
    "change_net",
    "change_source",
    "change_structural_check",
    "change_structure",
    "check",
    "check_structure",
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
    "net_along_curvature",
    "net_from_faces",
    "net_from_step",
    "offset_mesh",
    "open_example",
    "optimise",
    "optimise_again",
    "optimise_net",
    "primitive",
    "quads_from_mesh",
    "quads_from_triangles",
    "read_mesh",
    "save_picture",
    "set_net",
    "show_net",
    "size_structural_check",
    "size_structure",
    "start_optimisation",
    "tolerances",
    "update_structures",
    "weld_nets",
    "write_check_files",
    "write_fabrication",
    "write_mesh",
    "write_structural_check",
]


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
