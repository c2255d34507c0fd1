"""Rows of panels, edges and nodes along the lines of one family: what repeats on simple surfaces.

Surfaces of revolution and their kin repeat along one family of lines: panels between two of these
lines, edges across such a row, edges along such a line and nodes on it. So these rows are where a
search for few kinds begins.
"""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import breadth_first_order, connected_components

from solver.mesh.connectivity import Connectivity, IntArray
from solver.mesh.quadmesh import QuadMesh


def rows_along(mesh: QuadMesh, of: str, family: int, pieces: int = 1) -> IntArray:
    """(N,) number of the row of each panel, edge or node, rows cut into pieces of equal length.

    Args:
        mesh: of two families of lines at least.
        of: panels, edges or nodes.
        family: along whose lines rows run.
        pieces: of each row.
    """
    net = mesh.connectivity
    along = net.edge_families == family
    if of == "nodes":
        count, pairs = len(mesh.vertices), net.edges[along]
    elif of == "edges":
        count, pairs = len(net.edges), _edges_in_rows(net, along)
    else:
        count, pairs = len(net.faces), net.edge_faces[~along & ~net.boundary_edges]
    links = coo_array((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), shape=(count, count))
    links = (links + links.T).tocsr()
    _, row = connected_components(links, directed=False)
    if pieces == 1:
        return np.asarray(row, dtype=np.int64)
    degree, found = np.diff(links.indptr), np.zeros(count, dtype=np.int64)
    order = np.argsort(row, kind="stable")
    for part in np.split(order, np.flatnonzero(np.diff(row[order])) + 1):
        # From one end; a closed row has none and begins anywhere.
        begin = part[np.argmin(degree[part])]
        walked = breadth_first_order(links, begin, directed=False, return_predecessors=False)
        found[walked] = row[begin] * pieces + np.arange(len(walked)) * pieces // len(walked)
    return np.unique(found, return_inverse=True)[1].reshape(-1)


def families(mesh: QuadMesh) -> int:
    """How many families of lines there are; one where irregular vertices join them."""
    return int(mesh.connectivity.edge_families.max()) + 1


def _edges_in_rows(net: Connectivity, along: np.ndarray) -> IntArray:
    """(n, 2) edges across a row that are opposite in a face, edges along a line that follow."""
    sides = net.face_edges
    opposite = np.concatenate([sides[:, [0, 2]], sides[:, [1, 3]]])
    opposite = opposite[~along[opposite[:, 0]]]
    number = {tuple(edge): k for k, edge in enumerate(net.edges.tolist())}
    lines = [
        (number[min(a, b), max(a, b)], number[min(b, c), max(b, c)])
        for a, b, c in net.line_triples.tolist()
    ]
    following = np.array(lines, dtype=np.int64).reshape(-1, 2)
    return np.concatenate([opposite, following[along[following[:, 0]]]])
