"""Examples: documents that are built when they are opened, by the functions a macro would call."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import FreeCAD
import numpy as np

from freecad_ortho.documents.nets import import_net, optimise_net
from freecad_ortho.documents.sheet_systems import add_panels
from freecad_ortho.documents.structures import add_structure
from freecad_ortho.documents.systems import add_beams
from freecad_ortho.objects import net as net_object
from freecad_ortho.packages import HOME
from solver import QuadMesh
from solver.formfinding import CableNet, Membrane, VertexLoads, find_form, supported
from solver.mesh.coarsen import compact
from solver.mesh.diagonal import diagonal_meshes
from solver.mesh.grid import grid_mesh
from solver.mesh.primitives import rectangle
from solver.multinet import elliptic_net, reflected
from solver.multinet.presets import preset
from solver.option import one_of

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

_METRE = 1000.0


@dataclass(frozen=True)
class Example:
    """A document that can be built.

    Attributes:
        title: name of the document and of the menu entry, marked for translation.
        tip: what it shows, one sentence, marked for translation.
        build: fills an empty document.
    """

    title: str
    tip: str
    build: Callable[[FreeCAD.Document], None]


def open_example(name: str) -> FreeCAD.Document:
    """Build an example in a new document and show it.

    Args:
        name: one of ``EXAMPLES``.

    Raises:
        InputError: no such example.
        OrthoError: it cannot be built; no document is left behind.
    """
    one_of("example", name, EXAMPLES)
    example = EXAMPLES[name]
    document = FreeCAD.newDocument(name)
    document.Label = FreeCAD.Qt.translate("Ortho_Examples", example.title)
    try:
        example.build(document)
    except BaseException:
        FreeCAD.closeDocument(document.Name)
        raise
    document.recompute()
    # How it came about is no work of the user's that Undo should take away piece by piece.
    document.clearUndos()
    if FreeCAD.GuiUp:
        from freecad_ortho.view import picture

        picture.look(picture.three_d_view(document))
    return document


def _roof(document: FreeCAD.Document) -> None:
    net = import_net(HOME / "examples" / "data" / "demo_roof.obj", document)
    optimise_net(net, net="principal")
    add_panels(net, beams=add_beams(net))


def _gridshell(document: FreeCAD.Document) -> None:
    flat = rectangle(17, 17, length=16.0 * _METRE, width=16.0 * _METRE)
    held = supported(flat, "boundary")
    points = flat.vertices.copy()
    x, y = points[held, 0] / (8 * _METRE), points[held, 1] / (8 * _METRE)
    points[held, 2] = 3.0 * _METRE * (x**2 - y**2)
    start = find_form(flat.with_vertices(points), held, CableNet()).mesh
    film = find_form(start, held, Membrane()).mesh
    part = diagonal_meshes(film).first
    net = net_object.create(document, compact(part, part.faces), "Net")
    optimise_net(net, net="asymptotic")
    add_structure(net, "lamellas", width=60.0, thickness=4.0, strip="twisted")


def _multi_nets(document: FreeCAD.Document) -> None:
    def net(moving: str, curve: str, m: int, n: int, t: tuple[float, float] | None) -> QuadMesh:
        chosen = preset(curve)
        axes = (9.0, 5.0, 2.0)
        smooth = elliptic_net(axes, moving, chosen.curve, unfolded=True, closed=chosen.closed)
        return smooth.sampled(m, n, t)

    meshes = {
        "Wave": reflected(net("lambda", "wave", 11, 8, (-1.2, 4.0)), "xy"),
        "Arch": net("mu", "arch", 19, 9, None),
        "Loop": net("mu", "loop", 24, 9, None),
        "Vault": net("nu", "arch", 17, 13, None),
    }
    for number, (label, mesh) in enumerate(meshes.items()):
        low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
        place = np.array([11.0 * (number % 2), -11.0 * (number // 2), 0.0])
        moved = (mesh.vertices - 0.5 * (low + high)) * (8.0 / (high - low).max()) + place
        net = net_object.create(document, mesh.with_vertices(_METRE * moved), label)
        _show_orthogonality(net, legend=number == 0)


def _sheets(document: FreeCAD.Document) -> None:
    u, v = np.meshgrid(np.linspace(-1, 1, 21), np.linspace(-0.8, 0.8, 17), indexing="ij")
    x, y = u + 0.1 * v, v - 0.1 * u
    points = np.stack([x, y, 0.4 * x**2 + 0.2 * y**2 + 0.1 * x * y], axis=2)
    for number, name in enumerate(("geodesic", "chebyshev")):
        shifted = points + [0.0, 2.0 * number, 0.0]
        net = net_object.create(document, grid_mesh(_METRE * shifted), name.capitalize())
        optimise_net(net, net=name, fix="corners", fairness=10.0)
        _show_orthogonality(net, legend=number == 0)


def _dome(document: FreeCAD.Document) -> None:
    flat = rectangle(17, 15, length=16.0 * _METRE, width=14.0 * _METRE)
    held = supported(flat, "boundary")
    # A net that hangs under its weight, upside down.
    dome = find_form(flat, held, CableNet(), VertexLoads(vertex=(0.0, 0.0, 110.0))).mesh
    net = net_object.create(document, dome, "Net")
    optimise_net(net, net="principal")
    add_panels(net, thickness=20.0)


def _show_orthogonality(net: FreeCAD.DocumentObject, legend: bool) -> None:
    net.ColourMap = "Orthogonality"
    if FreeCAD.GuiUp:
        net.ViewObject.LineWidth = 1.0
        net.ViewObject.Legend = legend


EXAMPLES = {
    "Roof": Example(
        QT_TRANSLATE_NOOP("Ortho_Examples", "Roof of beams and panels"),
        QT_TRANSLATE_NOOP(
            "Ortho_Examples", "A canopy made orthogonal and planar, with flat beams and panels"
        ),
        _roof,
    ),
    "Gridshell": Example(
        QT_TRANSLATE_NOOP("Ortho_Examples", "Minimal gridshell"),
        QT_TRANSLATE_NOOP(
            "Ortho_Examples", "A soap film and an asymptotic net on it: laths that unroll straight"
        ),
        _gridshell,
    ),
    "MultiNets": Example(
        QT_TRANSLATE_NOOP("Ortho_Examples", "Orthogonal multi-nets"),
        QT_TRANSLATE_NOOP(
            "Ortho_Examples", "Four nets that are orthogonal exactly, in all their rectangles"
        ),
        _multi_nets,
    ),
    "Sheets": Example(
        QT_TRANSLATE_NOOP("Ortho_Examples", "Developable sheets"),
        QT_TRANSLATE_NOOP(
            "Ortho_Examples", "One curved sheet made developable in two ways, corners held"
        ),
        _sheets,
    ),
    "Dome": Example(
        QT_TRANSLATE_NOOP("Ortho_Examples", "Hanging net turned over"),
        QT_TRANSLATE_NOOP(
            "Ortho_Examples", "A form-found dome, then flat panels that meet at right angles"
        ),
        _dome,
    ),
}
