"""D figure 15: flat mesh -> membrane -> diagonal mesh -> orthogonal asymptotic net -> lamellas.

The border of a flat net is bent into a saddle, a soap film is found in it, and its diagonal mesh,
which is close to asymptotic already, is optimised: all nodes at right angles, and lamellas along
the lines that unroll straight.

Run it from the root of the project: ``python -m examples.minimal_gridshell [PICTURE.png]``.
"""

from __future__ import annotations

import sys

import numpy as np

from examples.drawing import WOOD, Panel, draw
from examples.strips import straight_strips
from solver import QuadMesh, optimise
from solver.analysis import measures
from solver.formfinding import CableNet, Membrane, find_form, supported
from solver.mesh.coarsen import compact
from solver.mesh.diagonal import diagonal_meshes
from solver.mesh.primitives import rectangle


def flat_mesh() -> QuadMesh:
    """A square of 16 m."""
    return rectangle(17, 17, length=16.0, width=16.0)


def membrane() -> QuadMesh:
    """A soap film over a square of 16 m, its border raised and lowered by 3 m."""
    flat = flat_mesh()
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
    strips, flat, off = straight_strips(result, 0.35)
    assert max(measures.asymptotic(result).max(), measures.orthogonality(result).max(), off) < 1e-9
    print(f"exactly asymptotic after vertices moved by at most {moved:.2f} mean edges")
    if len(sys.argv) > 1:
        stages = [Panel("flat mesh", flat_mesh(), -60, 40), Panel("membrane", film)]
        stages += [Panel("its diagonal mesh", start), Panel("asymptotic net", result)]
        stages += [Panel("lamellas", strips, colour=WOOD), Panel("unrolled", flat, -90, 90, WOOD)]
        draw(stages, sys.argv[1], size=4.6, high=0.72)
