"""All measures of a bare mesh at once."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from solver.analysis import measures
from solver.analysis.advisor import advice_as_dict
from solver.analysis.spheres import cmc
from solver.candidate import spread_of
from solver.mesh.quadmesh import FloatArray, QuadMesh

# Name, function, and what one value belongs to.
MEASURES: tuple[tuple[str, Callable[[QuadMesh], FloatArray], str], ...] = (
    ("orthogonality", measures.orthogonality, "face"),
    ("planarity", measures.planarity, "face"),
    ("circular", measures.circular, "face"),
    ("conical", measures.conical, "vertex"),
    ("asymptotic", measures.asymptotic, "vertex"),
    ("cmc", cmc, "vertex"),
    ("geodesic", measures.geodesic, "vertex"),
    ("chebyshev", measures.chebyshev, "edge"),
)


def check(mesh: QuadMesh) -> dict[str, Any]:
    """Measure a mesh against every net.

    Returns:
        Plain numbers for JSON: counts, ``measures`` with ``max``, ``mean`` and ``worst`` (the
        number of the face, edge or star centre) each, ``edge_ratio``, ``flipped_faces``, ``size``
        (lengths of the bounding box) and ``mean_edge`` in the mesh's unit, and ``advice`` on
        which net to optimise for.
    """
    net = mesh.connectivity
    used = mesh.vertices[net.referenced]
    return {
        "vertices": len(mesh.vertices),
        "faces": len(mesh.faces),
        "edges": len(net.edges),
        "boundary_vertices": int(net.boundary_vertices.sum()),
        "irregular_vertices": int((~net.regular & ~net.boundary_vertices & net.referenced).sum()),
        "corners": int(net.corners.sum()),
        "components": int(net.components.max()) + 1,
        "size": (used.max(axis=0) - used.min(axis=0)).tolist(),
        "mean_edge": mesh.mean_edge,
        "edge_ratio": measures.edge_ratio(mesh),
        "flipped_faces": int(measures.flipped(mesh).sum()),
        "advice": advice_as_dict(mesh),
        "measures": {name: _entry(mesh, measure, where) for name, measure, where in MEASURES},
    }


def _entry(
    mesh: QuadMesh, measure: Callable[[QuadMesh], FloatArray], where: str
) -> dict[str, float | int | str | None]:
    values = measure(mesh)
    spread = spread_of(values)
    worst = int(np.argmax(values)) if len(values) else None
    if where == "vertex" and worst is not None:
        worst = int(mesh.connectivity.stars[worst, 0])
    return {"max": spread.max, "mean": spread.mean, "worst": worst, "where": where}
