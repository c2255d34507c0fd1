"""The document functions behind :mod:`freecad_ortho.api`: from a macro, a command or a script.

Each one is undone in one step. Lengths are numbers of mm, FreeCAD quantities, or texts such as
``"0.2 m"``. Errors in what was given are :class:`solver.errors.InputError` and leave the document
as it was.
"""

import FreeCAD

from freecad_ortho.calls import list_keywords
from freecad_ortho.documents.again import optimise_again
from freecad_ortho.documents.baking import bake
from freecad_ortho.documents.display import show_net
from freecad_ortho.documents.drawing_pages import add_drawing_page, add_drawing_pages
from freecad_ortho.documents.examples import open_example
from freecad_ortho.documents.fem_analyses import add_fem_analysis
from freecad_ortho.documents.flat_patterns import add_flat_patterns, change_flat_patterns
from freecad_ortho.documents.nets import (
    drag_net,
    dragging,
    export_net,
    flip_net,
    import_net,
    keep_outcome,
    optimise_net,
    set_net,
)
from freecad_ortho.documents.pictures import save_picture
from freecad_ortho.documents.sheet_systems import (
    add_arches,
    add_bent_panels,
    add_lamellas,
    add_louvres,
    add_panels,
    add_patches,
)
from freecad_ortho.documents.sources import (
    add_elliptic_net,
    add_multi_net,
    add_primitive,
    add_source,
    change_net,
    change_source,
    form_net,
    net_along_curvature,
    net_from_faces,
    quads_from_mesh,
    weld_nets,
)
from freecad_ortho.documents.structural_checks import (
    add_structural_check,
    change_structural_check,
    size_structural_check,
    write_check_files,
)
from freecad_ortho.documents.structures import (
    add_structure,
    change_structure,
    export_fabrication,
    update_structures,
)
from freecad_ortho.documents.systems import add_beams, add_edge_beam, add_feet, add_nodes

if FreeCAD.GuiUp:
    # What is made in the window asks for its view.
    import freecad_ortho.view.providers  # noqa: F401

__all__ = [
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
    "change_flat_patterns",
    "change_net",
    "change_source",
    "change_structural_check",
    "change_structure",
    "drag_net",
    "dragging",
    "export_fabrication",
    "export_net",
    "flip_net",
    "form_net",
    "import_net",
    "keep_outcome",
    "net_along_curvature",
    "net_from_faces",
    "open_example",
    "optimise_again",
    "optimise_net",
    "quads_from_mesh",
    "save_picture",
    "set_net",
    "show_net",
    "size_structural_check",
    "update_structures",
    "weld_nets",
    "write_check_files",
]

list_keywords(__all__, globals())
