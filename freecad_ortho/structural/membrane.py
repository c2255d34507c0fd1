"""Form and force: how far a shell carries by axial forces, as a stress net of its form would."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_ortho.structural.model import Model
from solver.frame.model import Loads
from solver.frame.response import Response
from solver.linear.least_squares import smallest_solution
from solver.mesh.quadmesh import FloatArray
from solver.statics import equilibrium_system


@dataclass(frozen=True)
class MembraneForces:
    """The axial forces of a frame beside those of a net that carries the same load by these alone.

    Attributes:
        left: part of the load that no axial forces balance in this form; 0 for a stress net under
            its load.
        carried: part of the load that the axial forces of the frame balance; the rest is bent off.
        apart: how far the axial forces of the frame are from the nearest ones that balance the load
            as well as any, by the size of these.
        needed: size of these by that of the frame's own. It is large in forms that nearly have
            forces without any load: those that balance the load then pull in one direction and
            push in the other, and a frame rather bends a little than takes them up.
    """

    left: float
    carried: float
    apart: float
    needed: float


def membrane(model: Model, loads: Loads, found: Response) -> MembraneForces | None:
    """Compare force densities, N / L, of the frame and of the nearest state without bending.

    All loads are gathered at the nodes, half of what lies on a member at each end. None where no
    node is both free and loaded, or members are not on the net.

    Args:
        model: the frame on its net.
        loads: of one combination.
        found: the frame's response to it.
    """
    frame, net = model.frame, model.mesh.connectivity
    if len(frame.members) > len(model.families):
        return None
    supported = model.supports.fixed | (model.supports.springs > 0)
    held = np.asarray(supported[:, :3].any(axis=1))
    free = ~held & net.referenced
    at_nodes = _gathered(model, loads)[free].ravel()
    size = float(np.linalg.norm(at_nodes))
    if not size:
        return None
    matrix, _ = equilibrium_system(net, frame.nodes, np.zeros(len(frame.nodes)), held)
    density = found.forces_at(frame, 0.5)[:, 0] / frame.lengths
    missing = at_nodes - matrix @ density
    nearest = density + smallest_solution(matrix, missing)
    wanted = float(np.linalg.norm(nearest * frame.lengths))
    taken = float(np.linalg.norm(density * frame.lengths))
    apart = float(np.linalg.norm((nearest - density) * frame.lengths))
    return MembraneForces(
        left=float(np.linalg.norm(at_nodes - matrix @ nearest)) / size,
        carried=max(0.0, 1.0 - float(np.linalg.norm(missing)) / size),
        apart=apart / (wanted or 1.0),
        needed=wanted / (taken or 1.0),
    )


def _gathered(model: Model, loads: Loads) -> FloatArray:
    """(N, 3) forces on the nodes, those along members half at each end."""
    frame = model.frame
    half = 0.5 * loads.spread * frame.lengths[:, None]
    forces = loads.nodal[:, :3].copy()
    for end in (0, 1):
        np.add.at(forces, frame.members[:, end], half)
    return forces
