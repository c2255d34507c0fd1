"""D figure 6: multi-net regularisation smooths a mesh and keeps its shape, fairness loses it.

The demo roof with every vertex moved at random by a tenth of an edge (a) is made orthogonal without
a regulariser (b), with E_multi (c) and with E_fair of the same weight (d); no other guide helps.

Run it from the root of the project: ``python -m examples.multi_net_regulariser``.
"""

from __future__ import annotations

import numpy as np

from examples.demo_roof import demo_roof
from solver import NetOptions, QuadMesh
from solver.nets import NETS
from solver.problem import Problem
from solver.run import Optimisation
from solver.terms.fairness import Fairness
from solver.terms.multi import multi_net

WEIGHT = 1.0


def rough_roof(amount: float = 0.1) -> tuple[QuadMesh, QuadMesh]:
    """The demo roof and the same with noise of that many mean edges."""
    roof = QuadMesh(*demo_roof())
    moves = np.random.default_rng(1).normal(size=roof.vertices.shape)
    noise = amount * roof.mean_edge / np.sqrt(3) * moves
    return roof, roof.with_vertices(roof.vertices + noise)


def orthogonal(mesh: QuadMesh, fairness: float = 0.0, multi: float = 0.0) -> QuadMesh:
    """Minimise E_ortho + fairness E_fair + multi E_multi, the weights set to zero in the end."""
    free = np.zeros(len(mesh.vertices), dtype=bool)
    problem = NETS["orthogonal"].recipe(Problem("orthogonal", mesh, free), NetOptions())
    problem.guide(multi_net(mesh.connectivity), multi)
    problem.guide(Fairness(mesh.connectivity.line_triples), fairness)
    return Optimisation(problem, accept_start=False).run().mesh


def roughness(mesh: QuadMesh) -> float:
    """Root mean square of the second differences along parameter lines, in mean edges."""
    left, here, right = (mesh.vertices[k] for k in mesh.connectivity.line_triples.T)
    return float(np.sqrt(((2 * here - left - right) ** 2).sum(axis=1).mean()) / mesh.mean_edge)


def rise(mesh: QuadMesh) -> float:
    """Root mean square distance from the best plane, in mean edges."""
    arms = mesh.vertices - mesh.vertices.mean(axis=0)
    return float(np.linalg.svd(arms, compute_uv=False)[2] / np.sqrt(len(arms)) / mesh.mean_edge)


if __name__ == "__main__":
    roof, start = rough_roof()
    kept = {
        name: rise(orthogonal(start, **{name: WEIGHT})) / rise(roof)
        for name in ("multi", "fairness")
    }
    more = 100 * (kept["multi"] - kept["fairness"])
    print(f"multi-nets keep {more:.0f} % more of the roof's rise than fairness does")
