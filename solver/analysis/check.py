"""All measures of a bare mesh at once."""

from __future__ import annotations

from typing import Any

import numpy as np

from solver.analysis import measures
from solver.analysis.advisor import advice_as_dict
from solver.candidate import spread_of
from solver.errors import InputError
from solver.mesh.connectivity import IntArray
from solver.mesh.grid import grid_of
from solver.mesh.local_origin import LocalOrigin, resolution
from solver.mesh.quadmesh import FloatArray, QuadMesh, refuse_other
from solver.mesh.seams import seams
from solver.multinet.inverse import multi_net_residual_of
from solver.nets import Measure, all_measures

# Violations of Eq. 1 up to this part of size^2 count as zero.
MULTI_NET = 1e-10
# Lines of each family that are asked first whether a mesh is a multi-net.
_LINES = 65


def check(mesh: QuadMesh) -> dict[str, Any]:
    """Measure a mesh against every net, about a local origin where it is far from the origin.

    Returns:
        Plain numbers for JSON: counts, ``corners_of_faces`` (how many faces have how many corners;
        where some have other than four, only what can be asked of them is measured), ``measures``
        with ``max``, ``mean`` and ``worst`` (the number of the face, edge or star centre) and
        ``exempt`` (how many are left out, as they lie at singular vertices) each,
        ``planarity_gap`` (largest distance between the diagonals of a face) in the mesh's unit,
        ``edge_ratio``, ``flipped_faces``, ``size`` (lengths of the bounding box) and ``mean_edge``
        in the mesh's unit, ``advice`` on which net to optimise for, ``multi_net``, None where the
        mesh is not of grid type, and ``remarks`` on where it meets itself without being joined.
    """
    refuse_other(mesh)
    coarse = resolution(mesh)
    mesh = LocalOrigin.of_mesh(mesh).near_mesh(mesh)
    net = mesh.connectivity
    used = mesh.vertices[net.referenced]
    asked = all_measures(net.mixed)
    values = {name: measure.on(mesh) for name, measure in asked.items()}
    return {
        "vertices": len(mesh.vertices),
        "faces": net.face_count,
        "corners_of_faces": {
            str(n): int(k) for n, k in enumerate(np.bincount(net.face_sizes)) if k
        },
        "edges": len(net.edges),
        "boundary_vertices": int(net.boundary_vertices.sum()),
        "irregular_vertices": int((~net.regular & ~net.boundary_vertices & net.referenced).sum()),
        "corners": int(net.corners.sum()),
        "components": int(net.components.max()) + 1,
        "size": (used.max(axis=0) - used.min(axis=0)).tolist(),
        "mean_edge": mesh.mean_edge,
        "planarity_gap": float(measures.diagonal_distances(mesh).max()),
        "edge_ratio": measures.edge_ratio(mesh),
        "flipped_faces": int(measures.flipped(mesh).sum()),
        "advice": advice_as_dict(mesh, values, coarse),
        "measures": {name: _entry(mesh, values[name], measure) for name, measure in asked.items()},
        "multi_net": _multi_net(mesh, max(MULTI_NET, coarse)),
        "remarks": seams(mesh).remarks(),
    }


def _entry(
    mesh: QuadMesh, values: FloatArray, measure: Measure
) -> dict[str, float | int | str | None]:
    left_out, where = measure.left_out(mesh), measure.place
    spread = spread_of(values[~left_out])
    worst = int(np.argmax(np.where(left_out, -1.0, values))) if not left_out.all() else None
    if where == "vertex" and worst is not None:
        worst = int(mesh.connectivity.stars[worst, 0])
    return {
        "max": spread.max,
        "mean": spread.mean,
        "worst": worst,
        "where": where,
        "exempt": int(left_out.sum()),
    }


def _multi_net(mesh: QuadMesh, zero: float) -> dict[str, Any] | None:
    """How far a mesh of grid type is from a multi-net; None for other meshes.

    ``worst`` is the largest violation of Eq. 1 / size^2 over all rectangles of parameter lines, and
    ``corners`` the opposite corners of that rectangle. On large grids that are no multi-nets by far
    only some lines are asked: ``at_least`` is true then. Violations up to ``zero`` count as none.
    """
    if mesh.connectivity.mixed:
        return None
    try:
        numbers = grid_of(mesh).numbers
    except InputError:
        return None
    some = numbers[np.ix_(*(_spread_out(count) for count in numbers.shape))]
    thinned = some.size < numbers.size
    found = multi_net_residual_of(mesh.vertices[some])
    if thinned and found.worst <= zero:
        some, thinned = numbers, False
        found = multi_net_residual_of(mesh.vertices[numbers])
    i, j, k, line = found.rectangle
    return {
        "is_multi_net": found.worst <= zero,
        "worst": found.worst,
        "at_least": thinned,
        "corners": [int(some[i, j]), int(some[k, line])],
    }


def _spread_out(count: int) -> IntArray:
    """Numbers of the lines that are asked, the outermost among them."""
    return np.unique(np.linspace(0, count - 1, min(count, _LINES)).round().astype(np.int64))
