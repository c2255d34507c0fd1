"""D figure 10: a multi-net, optimised to be principal, stays principal under a Moebius map.

Circles go to circles under a Moebius map. The faces of a principal mesh are circular to second
order in the mesh size, so that their images are planar and orthogonal to that order.

Run it from the root of the project: ``python -m examples.moebius_of_principal_net [PICTURE.png]``.
"""

from __future__ import annotations

import sys

import numpy as np

from examples.drawing import Panel, draw
from solver import QuadMesh, optimise
from solver.analysis import measures
from solver.mesh.subdivide import catmull_clark
from solver.mesh.transform import moebius
from solver.multinet import elliptic_net
from solver.multinet.presets import preset


def principal_net(samples: int = 29) -> QuadMesh:
    """A multi-net of samples x samples vertices in elliptic coordinates, made principal."""
    arch = preset("arch")
    net = elliptic_net([9.0, 4.0, 1.0], "lambda", arch.curve, unfolded=True)
    return optimise(net.sampled(samples, samples, (0.0, 6.0)), "principal").mesh


def image(mesh: QuadMesh) -> QuadMesh:
    """Moebius image, the centre of inversion one diameter above the middle of the mesh."""
    arms = mesh.vertices - mesh.vertices.mean(axis=0)
    normal = np.linalg.svd(arms, full_matrices=False)[2][2]
    diameter = 2 * np.linalg.norm(arms, axis=1).max()
    return moebius(mesh, mesh.vertices.mean(axis=0) + diameter * normal)


def deviation(mesh: QuadMesh) -> float:
    """Worst orthogonality or planarity of a face."""
    return float(max(measures.orthogonality(mesh).max(), measures.planarity(mesh).max()))


if __name__ == "__main__":
    net = principal_net()
    bent = image(net)
    print(f"a Moebius image deviates by {deviation(bent):.1e} from principal")
    if len(sys.argv) > 1:
        shiny = Panel("as a mirror", catmull_clark(net, 3), 25, 20, "#9fb4c7", mirror=True)
        panels = [Panel("principal net", net, 25, 20), Panel("its Moebius image", bent, 25, 20)]
        draw([*panels, shiny], sys.argv[1])
