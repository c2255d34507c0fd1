"""How a frame answers a load: movements, forces in members, reactions."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.frame import elements
from solver.frame.model import Frame, Loads
from solver.frame.system import FrameSystem
from solver.mesh.quadmesh import FloatArray


@dataclass(frozen=True, eq=False)
class Response:
    """What one load does, exact by the theory of beams.

    Attributes:
        displacements: (N, 6) of the nodes, in the model's directions.
        ends: (M, 12) forces and moments on the members' ends, in their own axes.
        spread: (M, 3) loads along the members, in their own axes.
        reactions: (N, 6) of the supports, in the model's directions.
    """

    displacements: FloatArray
    ends: FloatArray
    spread: FloatArray
    reactions: FloatArray

    def forces_at(self, frame: Frame, part: float) -> FloatArray:
        """(M, 6) N, Vy, Vz, T, My, Mz in sections a part of the way along the members.

        N is positive in tension; all are what the further part of the member does to the nearer,
        in the member's own axes: My > 0 pulls at the side of z, Mz > 0 at the side against y.
        """
        x = part * frame.lengths
        force, moment = self.ends[:, :3], self.ends[:, 3:6]
        result = np.empty((len(x), 6))
        result[:, :3] = -force - x[:, None] * self.spread
        result[:, 3] = -moment[:, 0]
        result[:, 4] = -moment[:, 1] - x * force[:, 2] - 0.5 * x**2 * self.spread[:, 2]
        result[:, 5] = -moment[:, 2] + x * force[:, 1] + 0.5 * x**2 * self.spread[:, 1]
        return result

    def __add__(self, other: Response) -> Response:
        """Both together, for what is linear."""
        return Response(
            self.displacements + other.displacements,
            self.ends + other.ends,
            self.spread + other.spread,
            self.reactions + other.reactions,
        )

    def __rmul__(self, factor: float) -> Response:
        """That of the load so many times."""
        return Response(
            factor * self.displacements,
            factor * self.ends,
            factor * self.spread,
            factor * self.reactions,
        )


def at_nodes(system: FrameSystem, loads: Loads) -> tuple[FloatArray, FloatArray]:
    """Forces (6 N,) on the nodes in the directions of supports, and (M, 12) those of the spread.

    Raises:
        InputError: a moment that nothing takes.
    """
    nodal = system.along_supports(loads.nodal)
    system.refuse_idle_moments(nodal[:, 3:])
    own = np.einsum("mij,mj->mi", system.frame.axes, loads.spread)
    ends = elements.spread_at_ends(system.frame, own)
    ends = np.einsum("mji,mj->mi", system.joined.follow, ends)
    return nodal.ravel() + system.gathered(ends), ends


def response(system: FrameSystem, loads: Loads) -> Response:
    """Linear response to a load.

    Args:
        system: the supported frame.
        loads: on its nodes and members.

    Raises:
        InputError: a moment that nothing takes.
    """
    force, given = at_nodes(system, loads)
    movement = np.zeros(len(force))
    movement[system.free] = system.solved(force[system.free])
    moved = system.at_members(movement)
    ends = np.einsum("mij,mj->mi", system.joined.stiffness, moved) - given
    springs = system.supports.springs.ravel()
    # What the supports do is what the members and the loads leave.
    nodal = system.along_supports(loads.nodal).ravel()
    resisted = system.gathered(ends) + system.panels @ movement
    reactions = np.where(system.supports.fixed.ravel(), resisted - nodal, -springs * movement)
    return Response(
        system.own(movement.reshape(-1, 6)),
        ends,
        np.einsum("mij,mj->mi", system.frame.axes, loads.spread),
        system.own(reactions.reshape(-1, 6)),
    )


def imbalance(frame: Frame, loads: Loads, reactions: FloatArray) -> float:
    """Largest sum of forces or of moments of loads and reactions / sum of their sizes.

    Moments are taken about the middle of the nodes.

    Args:
        frame: the frame.
        loads: on it.
        reactions: (N, 6) of its supports.
    """
    arms = frame.nodes - frame.nodes.mean(axis=0)
    middle = arms[frame.members].mean(axis=1)
    spread = loads.spread * frame.lengths[:, None]
    forces = np.concatenate([loads.nodal[:, :3], reactions[:, :3], spread])
    moments = np.concatenate(
        [
            loads.nodal[:, 3:] + np.cross(arms, loads.nodal[:, :3]),
            reactions[:, 3:] + np.cross(arms, reactions[:, :3]),
            np.cross(middle, spread),
        ]
    )
    found = 0.0
    for values in (forces, moments):
        size = float(np.abs(values).sum())
        if size:
            found = max(found, float(np.abs(values.sum(axis=0)).max()) / size)
    return found
