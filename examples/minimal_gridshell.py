"""D figure 15: flat mesh -> membrane -> diagonal mesh -> orthogonal asymptotic net.

The border of a flat net is bent into a saddle, a soap film is found in it, and its diagonal mesh,
which is close to asymptotic already, is optimised: straight lamellas, all nodes at right angles.

Run it from the root of the project: ``python -m examples.minimal_gridshell [PICTURE.png]``.
"""

from __future__ import annotations

import sys

import numpy as np

from examples.drawing import draw
from solver import QuadMesh, optimise
from solver.analysis import measures
from solver.formfinding import CableNet, Membrane, find_form, supported
from solver.mesh.coarsen import compact
from solver.mesh.diagonal import diagonal_meshes
from solver.mesh.primitives import rectangle


def membrane() -> QuadMesh:
    """A soap film over a square of 16 m, its border raised and lowered by 3 m."""
    flat = rectangle(17, 17, length=16.0, width=16.0)
    held = supported(flat, "boundary")
    points = flat.vertices.copy()
    x, y = points[held, 0] / 8, points[held, 1] / 8
    points[held, 2] = 3.0 * (x**2 - y**2)
    net = find_form(flat.with_vertices(points), held, CableNet()).mesh
    return find_form(net, held, Membrane()).mesh


def diagonal(mesh: QuadMesh) -> QuadMesh:
    """One of its diagonal meshes, without vertices that no face uses."""
    part = diagonal_meshes(mesh).first
    return compact(part, part.faces)


if __name__ == "__main__":
    film = membrane()
    start = diagonal(film)
    result = optimise(start, "asymptotic").mesh
    moved = float(np.linalg.norm(result.vertices - start.vertices, axis=1).max() / start.mean_edge)
    assert max(measures.asymptotic(result).max(), measures.orthogonality(result).max()) < 1e-10
    print(f"exactly asymptotic after vertices moved by at most {moved:.2f} mean edges")
    if len(sys.argv) > 1:
        stages = [("membrane", film), ("its diagonal mesh", start), ("asymptotic net", result)]
        draw(stages, sys.argv[1], title="From a flat mesh to a minimal gridshell")
