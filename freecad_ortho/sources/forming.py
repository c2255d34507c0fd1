"""Form-finding as a source: membranes and cable nets in equilibrium."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from freecad_ortho.sources.source import Made, Source
from solver.analysis.upright import side_remark
from solver.errors import InputError
from solver.formfinding import (
    CableNet,
    FormFound,
    Membrane,
    Tension,
    VertexLoads,
    family_densities,
    find_form,
    supported,
)
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import QuadMesh
from solver.option import Former, Option
from solver.sentence import Sentence

Vector = tuple[float, float, float]
_NONE = (0.0, 0.0, 0.0)
# So many supports are named to someone who named another vertex.
_NAMED = 8


def found(
    mesh: QuadMesh,
    *,
    kind: str,
    supports: str,
    lift: str,
    density: float,
    border_density: float,
    stress: float,
    border_force: float,
    vertex_load: Vector,
    area_load: Vector,
    edge_load: Vector,
    pressure: float,
    tolerance: float = 1e-10,
    max_iterations: int = 500,
) -> tuple[FormFound, list[str]]:
    """The form of the options, and what is to be said about the loads on the start.

    Args:
        mesh: the start.
        kind: and the options after it: those of ``FORM``.
        supports: vertices that are held.
        lift: how far some of them go up first.
        density: of the cables.
        border_density: of those at the border, 0 for the same.
        stress: of the membrane.
        border_force: in the cable at its border.
        vertex_load: at each vertex.
        area_load: of the faces.
        edge_load: of the edges.
        pressure: along the normals.
        tolerance: of ``solver.formfinding.find_form``.
        max_iterations: likewise.

    Raises:
        InputError: no such supports, or values of which there is no form.
    """
    held = supported(mesh, supports.replace(" ", ""))
    mesh = lifted(mesh, held, lift)
    side = side_remark(mesh, vertex_load, area_load, edge_load)
    tension: Tension = CableNet(family_densities(mesh, density, density, border_density or None))
    if kind == "membrane":
        if lift.strip():
            mesh = find_form(mesh, held, tension).mesh
        tension = Membrane(stress, border_force)
    loads = VertexLoads(vertex_load, area_load, edge_load, pressure)
    form = find_form(mesh, held, tension, loads, tolerance=tolerance, max_iterations=max_iterations)
    return form, [] if side is None else [side]


def _formed(meshes: Sequence[QuadMesh], unit: str, **options: Any) -> Made:
    form, remarks = found(meshes[0], **options)
    if not form.converged:
        raise InputError(f"form-finding: {form.message}")
    pull = np.linalg.norm(form.reactions, axis=1).max()
    words = Sentence(
        "in equilibrium, unbalanced {:.0e}; largest support force {:.3g}", form.unbalanced, pull
    )
    return Made(form.mesh, (words, *remarks))


def lifted(mesh: QuadMesh, held: BoolArray, text: str) -> QuadMesh:
    """Raise supports before the form is found.

    Args:
        mesh: the start.
        held: (V,) which vertices are supports.
        text: ``I:Z; I:Z ...``: numbers of supports and how far each goes up, in the mesh's unit.

    Raises:
        InputError: not such pairs, or a vertex that is no support.
    """
    points = mesh.vertices.copy()
    for pair in filter(None, (word.strip() for word in text.split(";"))):
        # Documents of earlier versions may have a comma.
        number, _, height = pair.replace(",", ":").partition(":")
        try:
            vertex, rise = int(number), float(height)
        except ValueError:
            raise InputError(
                f"lift: expected VERTEX:HEIGHT such as 0:1500; 20:1500, got '{pair[:40]}'"
            ) from None
        if not 0 <= vertex < len(points) or not held[vertex]:
            supports = np.flatnonzero(held)
            known = ", ".join(map(str, supports[:_NAMED])) + ", ..." * (len(supports) > _NAMED)
            raise InputError(f"lift: vertex {vertex} is no support; these are: {known}")
        if not np.isfinite(rise):
            raise InputError(f"lift: vertex {vertex} cannot be raised by {height}; mend it")
        points[vertex, 2] += rise
    return mesh.with_vertices(points)


FORM = Source(
    "form-finding",
    "A membrane or cable net in equilibrium with its supports and loads",
    (
        Option("kind", "cables", "choice",
               "The net is made of cables, or is a membrane of one stress",
               ("cables", "membrane")),
        Option("supports", "boundary", "text",
               "These are held: boundary, corners or vertices as 0,5,12",
               written="boundary|corners|I,J,K"),
        Option("lift", "", "text",
               "These supports are raised first, VERTEX:HEIGHT in mm as 0:1500; 20:900",
               written="I:Z[;I:Z...]", brief="supports to raise first by Z, as '0:1.5;20:1.5'"),
        Option("density", 1.0, "number", "The cables have this force density, force / length"),
        Option("border_density", 0.0, "number",
               "Border cables have this force density; 0 is the same",
               former=Former("border")),
        Option("stress", 1.0, "number", "The membrane has this stress, force / length"),
        Option("border_force", 0.0, "number", "The membrane's border cable has this force",
               former=Former("cable")),
        Option("vertex_load", _NONE, "number",
               "Each vertex carries this load, a force along x, y and z"),
        Option("area_load", _NONE, "number", "The faces carry this load, force / mm2",
               brief="load of the faces, force / area"),
        Option("edge_load", _NONE, "number", "The edges carry this load, force / mm",
               brief="load of the edges, force / length", former=Former("beam_load")),
        Option("pressure", 0.0, "number",
               "The faces carry this pressure along their normals, force / mm2",
               brief="pressure along the normals, force / area"),
    ),
    _formed,
    "net",
)  # fmt: skip
