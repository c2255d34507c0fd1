"""Quantities spread over a mesh, for colour maps and plots: one value a face, vertex or edge."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from weakref import WeakKeyDictionary

import numpy as np

from solver.align.reach import carried_to
from solver.analysis.curvature import gauss_curvature, mean_curvature
from solver.analysis.forces import edge_forces
from solver.analysis.kinds import ALIKE, ALIKE_DEG, NODES, PANELS, kinds_within
from solver.errors import InputError
from solver.mesh.closest import TriangleSurface
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows
from solver.nets import NETS, Measure, all_measures
from solver.offset.axes import torsion_free_axes
from solver.option import one_of

FACES, VERTICES, EDGES = "faces", "vertices", "edges"


@dataclass(frozen=True, eq=False)
class Field:
    """Values of one quantity.

    Attributes:
        place: what a value belongs to: faces, vertices or edges.
        values: (N,) one each; NaN where the quantity is not defined (curvature at the boundary,
            right angles at singular vertices).
        dimension: power of the model's length in it: 1 for a length, -2 for Gauss curvature.
        unit: "degrees", or empty for a number or a length.
        signed: zero is special, both signs matter.
        decades: a residual, best seen by its power of ten.
    """

    place: str
    values: FloatArray
    dimension: int = 0
    unit: str = ""
    signed: bool = False
    decades: bool = False


Compute = Callable[[QuadMesh, TriangleSurface | None], Field]


def field(mesh: QuadMesh, name: str, reference: TriangleSurface | None = None) -> Field:
    """Compute a quantity of the mesh.

    Args:
        mesh: the mesh.
        name: one of :func:`fields`.
        reference: surface that the gap is measured to.

    Raises:
        InputError: unknown name, or a gap without a reference.
    """
    known = fields()
    one_of("field", name, known)
    return known[name](mesh, reference)


def residuals() -> dict[str, Compute]:
    """Every measure of every net, then those that a diagonal net has of its own."""
    found: dict[str, Compute] = {
        measure.title: partial(_residual, measure, False) for measure in all_measures().values()
    }
    for net in NETS.values():
        for measure in net.measures if True in net.variants else ():
            if measure.across:
                found[f"{measure.title} diagonals"] = partial(_residual, measure, True)
    return found


def fields() -> dict[str, Compute]:
    """Everything that :func:`field` computes, by name."""
    return residuals() | _OTHERS


def turning_radii(mesh: QuadMesh) -> FloatArray:
    """(V,) smallest radius of circles through three neighbours on a parameter line; NaN at ends.

    The radius to which a strip along a line of the net is bent, in the model's unit; infinite on
    straight lines.
    """
    before, here, after = mesh.vertices[mesh.connectivity.line_triples].transpose(1, 0, 2)
    chord = np.linalg.norm(after - before, axis=1)
    sine = np.linalg.norm(np.cross(unit_rows(here - before), unit_rows(after - here)), axis=1)
    with np.errstate(divide="ignore"):
        radius = chord / (2 * sine)
    result = np.full(len(mesh.vertices), np.inf)
    middle = mesh.connectivity.line_triples[:, 1]
    np.minimum.at(result, middle, radius)
    result[np.setdiff1d(np.arange(len(result)), middle)] = np.nan
    return result


def _residual(
    measure: Measure, diagonal: bool, mesh: QuadMesh, reference: TriangleSurface | None
) -> Field:
    found = np.where(measure.left_out(mesh, diagonal), np.nan, measure.on(mesh, diagonal))
    place = measure.place_of(diagonal)
    if place != "vertex":
        return Field(FACES if place == "face" else EDGES, found, decades=True)
    net = mesh.connectivity
    values = np.full(len(mesh.vertices), np.nan)
    values[(net.diagonal_stars if diagonal else net.stars)[:, 0]] = found
    return Field(VERTICES, values, decades=True)


# Surfaces that were carried on for nets that overhang them: a net is drawn many times a second.
_LARGER: WeakKeyDictionary[TriangleSurface, TriangleSurface] = WeakKeyDictionary()


def _reaching(mesh: QuadMesh, reference: TriangleSurface) -> TriangleSurface:
    """The reference, gone on beyond its border where the mesh overhangs it."""
    ground = _LARGER.get(reference, reference)
    larger = carried_to(mesh, ground)
    if larger is not None:
        _LARGER[reference] = ground = larger
    return ground


def _gap(mesh: QuadMesh, reference: TriangleSurface | None) -> Field:
    if reference is None:
        raise InputError("gap to reference: the net has no reference surface; choose one first")
    feet, _ = _reaching(mesh, reference).closest(mesh.vertices)
    return Field(VERTICES, np.linalg.norm(mesh.vertices - feet, axis=1), dimension=1)


def _twist(mesh: QuadMesh, reference: TriangleSurface | None) -> Field:
    twist = torsion_free_axes(mesh).twist
    return Field(EDGES, np.degrees(np.arcsin(np.clip(twist, 0, 1))), unit="degrees")


def _kinds(mesh: QuadMesh, of: str, place: str) -> Field:
    """The number of the kind of each part from 1, the most frequent first."""
    within = ALIKE_DEG if of == NODES else ALIKE * mesh.mean_edge
    kind = kinds_within(mesh, of, within).kind
    return Field(place, np.where(kind < 0, np.nan, kind + 1.0))


_OTHERS: dict[str, Compute] = {
    "Gauss curvature": lambda mesh, reference: Field(
        VERTICES, gauss_curvature(mesh), dimension=-2, signed=True
    ),
    "Mean curvature": lambda mesh, reference: Field(
        VERTICES, mean_curvature(mesh), dimension=-1, signed=True
    ),
    "Edge length": lambda mesh, reference: Field(EDGES, mesh.edge_lengths, dimension=1),
    "Bending radius": lambda mesh, reference: Field(VERTICES, turning_radii(mesh), dimension=1),
    "Twist": _twist,
    "Gap to reference": _gap,
    "Kinds of panels": lambda mesh, reference: _kinds(mesh, PANELS, FACES),
    "Kinds of edges": lambda mesh, reference: _kinds(mesh, "edges", EDGES),
    "Kinds of nodes": lambda mesh, reference: _kinds(mesh, NODES, VERTICES),
    "Force": lambda mesh, reference: Field(EDGES, edge_forces(mesh), signed=True),
}
