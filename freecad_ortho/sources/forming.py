"""Form-finding as a source: membranes and cable nets in equilibrium."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from freecad_ortho.sources.source import Made, Source
from solver.analysis.upright import side_remark
from solver.errors import InputError
from solver.formfinding import (
    CableNet,
    Loads,
    Membrane,
    Tension,
    family_densities,
    find_form,
    supported,
)
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import QuadMesh
from solver.option import Option

Vector = tuple[float, float, float]
_NONE = (0.0, 0.0, 0.0)
# So many supports are named to someone who named another vertex.
_NAMED = 8


def _formed(
    meshes: Sequence[QuadMesh],
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
) -> Made:
    mesh = meshes[0]
    held = supported(mesh, supports.replace(" ", ""))
    mesh = lifted(mesh, held, lift)
    densities = family_densities(mesh, density, density, border_density or None)
    tension: Tension = CableNet(densities)
    loads = Loads(vertex_load, area_load, edge_load, pressure)
    if kind == "membrane":
        if lift.strip():
            mesh = find_form(mesh, held, tension).mesh
        tension = Membrane(stress, border_force)
    found = find_form(mesh, held, tension, loads)
    if not found.converged:
        raise InputError(f"form-finding: {found.message}")
    side = side_remark(mesh, vertex_load, area_load, edge_load)
    pull = np.linalg.norm(found.reactions[held], axis=1).max()
    return Made(
        found.mesh,
        (
            f"{found.message}, unbalanced {found.unbalanced:.0e}; largest support force {pull:.3g}",
            *([] if side is None else [side]),
        ),
    )


def lifted(mesh: QuadMesh, held: BoolArray, text: str, name: str = "lift") -> QuadMesh:
    """Raise supports before the form is found.

    Args:
        mesh: the start.
        held: (V,) which vertices are supports.
        text: ``I,Z;I,Z ...``: numbers of supports and how far each goes up, in the mesh's unit.
        name: what the option is called where it was given.

    Raises:
        InputError: not such pairs, or a vertex that is no support.
    """
    points = mesh.vertices.copy()
    for pair in filter(None, (word.strip() for word in text.split(";"))):
        # Documents of earlier versions have a colon.
        number, _, height = pair.replace(":", ",").partition(",")
        try:
            vertex, rise = int(number), float(height)
        except ValueError:
            raise InputError(
                f"{name}: expected VERTEX,HEIGHT such as 0,1500; 20,1500, got '{pair[:40]}'"
            ) from None
        if not 0 <= vertex < len(points) or not held[vertex]:
            supports = np.flatnonzero(held)
            known = ", ".join(map(str, supports[:_NAMED])) + ", ..." * (len(supports) > _NAMED)
            raise InputError(f"{name}: vertex {vertex} is no support; these are: {known}")
        if not np.isfinite(rise):
            raise InputError(f"{name}: vertex {vertex} cannot be raised by {height}; mend it")
        points[vertex, 2] += rise
    return mesh.with_vertices(points)


FORM = Source(
    "form-finding",
    "A membrane or cable net in equilibrium with its supports and loads",
    (
        Option("kind", "cables", "choice", "Cables of given force density, or constant stress",
               ("cables", "membrane")),
        Option("supports", "boundary", "text", "Held: boundary, corners or vertices as 0,5,12"),
        Option("lift", "", "text", "Supports to raise first, VERTEX,HEIGHT in mm as 0,1500;20,900"),
        Option("density", 1.0, "number", "Force density of the cables, force / length"),
        Option("border_density", 0.0, "number", "Force density of border cables; 0: the same"),
        Option("stress", 1.0, "number", "Stress of the membrane, force / length"),
        Option("border_force", 0.0, "number", "Force in the membrane's border cable"),
        Option("vertex_load", _NONE, "number", "Load at each vertex, force"),
        Option("area_load", _NONE, "number", "Load of the faces, force / mm2"),
        Option("edge_load", _NONE, "number", "Load of the edges, force / mm"),
        Option("pressure", 0.0, "number", "Pressure along the normals, force / mm2"),
    ),
    _formed,
    "net",
)  # fmt: skip
