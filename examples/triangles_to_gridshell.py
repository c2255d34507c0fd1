"""D figure 16: triangles -> quads -> asymptotic net with its feet on the ground -> lamellas.

A vault that is nearly minimal, as triangles, becomes quads along its curvature lines; the diagonal
mesh of these is nearly asymptotic. It is optimised while the points on the ground stay on it.
The lamellas along its lines unroll straight. Needs the library pyQuadriFlow for the quads.

Run it from the root of the project: ``python -m examples.triangles_to_gridshell [PICTURE.png]``.
"""

from __future__ import annotations

import sys

import numpy as np

from examples.drawing import WOOD, Panel, draw
from examples.strips import fans, straight_strips
from solver import InputError, QuadMesh, optimise
from solver.analysis import measures
from solver.mesh.coarsen import compact
from solver.mesh.diagonal import diagonal_meshes
from solver.mesh.grid import grid_faces
from solver.mesh.remesh import quads_from_triangles
from solver.nets.constraints import Constraints, PlaneGlide


def vault(m: int = 41, n: int = 61) -> tuple[np.ndarray, np.ndarray]:
    """Points (m) and triangles of a vault that widens towards both ends, feet at z = 0."""
    x, angle = np.meshgrid(np.linspace(-1, 1, m), np.linspace(0, np.pi, n), indexing="ij")
    radius = 1 + 0.35 * x**2
    points = 4 * np.stack([x, -radius * np.cos(angle), radius * np.sin(angle)], axis=2)
    quads = grid_faces(m, n)
    return points.reshape(-1, 3), np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def gridshell(quads: QuadMesh) -> tuple[QuadMesh, QuadMesh, np.ndarray]:
    """Diagonal mesh, the asymptotic net made of it, and the numbers of its feet."""
    part = diagonal_meshes(quads).first
    start = compact(part, part.faces)
    feet = np.flatnonzero(np.abs(start.vertices[:, 2]) < 1e-6)
    ground = Constraints(glide=(PlaneGlide(2, 0.0, feet),))
    return start, optimise(start, "asymptotic", constraints=ground).mesh, feet


if __name__ == "__main__":
    try:
        quads = quads_from_triangles(*vault(), faces=400).mesh
    except InputError as error:
        sys.exit(f"error: {error}")
    start, net, feet = gridshell(quads)
    assert max(measures.asymptotic(net).max(), measures.orthogonality(net).max()) < 1e-10
    lift = np.abs(net.vertices[feet, 2]).max()
    strips, flat, off = straight_strips(net, 0.12)
    assert off < 1e-9
    print(f"exactly asymptotic, the feet leave the ground by {lift:.0e} m at most")
    if len(sys.argv) > 1:
        stages = [Panel("triangles", fans(*vault(13, 19))), Panel("quads", quads)]
        stages += [Panel("diagonal mesh", start), Panel("asymptotic net", net)]
        stages += [Panel("lamellas", strips, colour=WOOD), Panel("unrolled", flat, -90, 90, WOOD)]
        draw(stages, sys.argv[1], size=4.6, high=0.72)
