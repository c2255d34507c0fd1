"""Balance in the deformed shape: second-order response, and the way to a limit load."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.sparse import diags_array
from scipy.sparse.linalg import SuperLU

from solver.errors import OrthoError, SingularSystemError
from solver.frame import corotational
from solver.frame.corotational import Ends
from solver.frame.model import Frame, Loads
from solver.frame.response import Response, at_nodes
from solver.frame.system import FrameSystem, factored, turns
from solver.mesh.quadmesh import FloatArray

# Most Newton steps of a load, what is left of it at the end, and the smallest part of it that is
# put on at a time.
_STEPS, _LEFT, _LEAST = 15, 1e-8, 1 / 64
# Steps in which the arc of a path is wished to be found.
_WISHED = 5


@dataclass(frozen=True, eq=False)
class SecondOrder:
    """What balances a load in the deformed shape.

    Attributes:
        response: displacements and forces.
        factor: part of the load that is carried, in stable balance, 1 for all of it.
    """

    response: Response
    factor: float


@dataclass(frozen=True, eq=False)
class EquilibriumPath:
    """States of balance one after the other.

    Attributes:
        factors: (S,) of the load.
        displacements: (S, N, 6) in the model's directions, rotations summed up.
    """

    factors: FloatArray
    displacements: FloatArray

    @property
    def limit(self) -> float | None:
        """The first largest factor, by a parabola; None where the load grows to the end."""
        falls = np.flatnonzero(np.diff(self.factors) < 0)
        if not len(falls) or falls[0] == 0:
            return None
        top = int(falls[0])
        moved = self.displacements[top - 1 : top + 2, :, :3]
        steps = np.linalg.norm(np.diff(moved, axis=0).reshape(2, -1), axis=1)
        along = np.array([-steps[0], 0.0, steps[1]])
        a, b, c = np.polyfit(along, self.factors[top - 1 : top + 2], 2)
        return float(c - b**2 / (4 * a))


def imperfect(frame: Frame, shape: FloatArray, size: float) -> Frame:
    """The frame, free of stress, with its nodes moved along a shape.

    Args:
        frame: the frame.
        shape: (N, 6) or (N, 3), its largest displacement one.
        size: largest displacement.
    """
    return replace(frame, nodes=frame.nodes + size * shape[:, :3])


def second_order(system: FrameSystem, loads: Loads) -> SecondOrder:
    """Response with balance in the deformed shape, by Newton's method.

    Loads keep their directions. Where not all of the load can be carried, what can is returned,
    within 1/64 of the load.

    Args:
        system: the supported frame, members divided where they are to bow.
        loads: on it.
    """
    moving = _Moving(system, loads)
    done, step = 0.0, 1.0
    while done < 1.0 and step >= _LEAST:
        before = moving.state
        if moving.balanced(min(done + step, 1.0)):
            done = min(done + step, 1.0)
        else:
            moving.state = before
            step /= 2
    if not done:
        raise OrthoError(
            "second order: not even 1/64 of the load is carried; the frame is too weak for it"
        )
    return SecondOrder(moving.response(done), done)


def followed(system: FrameSystem, loads: Loads, steps: int, first: float) -> EquilibriumPath:
    """States of balance along the path of a load that grows from zero, past its limit.

    Args:
        system: the supported frame.
        loads: of which the factor is found.
        steps: number of states.
        first: factor of the first one.

    Raises:
        OrthoError: the path is lost; take smaller steps.

    Source: Crisfield (1981), A fast incremental/iterative solution procedure that handles
    snap-through; here with steps at right angles to the arc.
    """
    moving = _Moving(system, loads)
    factors, shapes = [0.0], [np.zeros((len(system.frame.nodes), 6))]
    way = moving.direction() * first
    arc = float(np.linalg.norm(moving.scale * way))
    factor = first
    for _ in range(steps):
        found = moving.onto_path(factors[-1], factor, way)
        if found is None:
            raise OrthoError("second order: the path of balance is lost; take smaller steps")
        now, way, rounds = found
        factors.append(now)
        shapes.append(moving.displacements())
        ahead = moving.direction()
        arc *= float(np.clip(np.sqrt(_WISHED / rounds), 0.5, 1.5))
        size = arc / float(np.linalg.norm(moving.scale * ahead))
        size = float(np.copysign(size, (moving.scale**2 * ahead) @ way))
        way = size * ahead
        factor = now + size
    return EquilibriumPath(np.array(factors), np.array(shapes))


class _Moving:
    """A frame on its way.

    Attributes:
        state: displacements (N, 3), rotations (N, 3, 3) and the sum of all turns (N, 3).
        scale: (n,) to compare displacements and turns.
    """

    def __init__(self, system: FrameSystem, loads: Loads) -> None:
        frame = system.frame
        self._system = system
        self._load, self._given = at_nodes(system, loads)
        self._axes, self._lengths = frame.axes, frame.lengths
        self._spans = frame.nodes[frame.members[:, 1]] - frame.nodes[frame.members[:, 0]]
        self._spread = np.einsum("mij,mj->mi", self._axes, loads.spread)
        self._turn = turns(frame, system.supports, np.broadcast_to(np.eye(3), self._axes.shape))
        self._springs = system.supports.springs.ravel()
        count = len(frame.nodes)
        rotations = np.broadcast_to(np.eye(3), (count, 3, 3)).copy()
        self.state = (np.zeros((count, 3)), rotations, np.zeros((count, 3)))
        turning = system.free % 6 >= 3
        self.scale = np.where(turning, float(frame.lengths.mean()), 1.0)

    def _ends(self) -> Ends:
        frame, (moved, turned, _) = self._system.frame, self.state
        # From where each member starts: far from the origin short stiff ones would lose digits.
        places = moved[frame.members.T]
        places[1] += self._spans
        return Ends(places, turned[frame.members.T])

    def _forces(self) -> tuple[FloatArray, FloatArray]:
        """Forces (6 N,) by which members and springs resist, and (M, 12) in members' axes."""
        system = self._system
        k = system.joined.stiffness
        whole, own = corotational.forces(self._ends(), self._axes, self._lengths, k)
        held = self._springs * system.along_supports(self.displacements()).ravel()
        panels = system.frame.panels.forces(system.frame.nodes, self.state[0])
        resisted = system.gathered(whole, self._turn) + system.gathered_panels(panels)
        return resisted + held, own

    def _factored(self) -> SuperLU:
        system = self._system
        k = corotational.tangent(self._ends(), self._axes, self._lengths, system.joined.stiffness)
        springs = diags_array(self._springs, format="csc")
        panels = system.frame.panels.tangent(system.frame.nodes, self.state[0])
        matrix = system.assembled(k, self._turn) + system.assembled_panels(panels)
        matrix = (matrix + system.idle + springs).tocsc()
        return factored(matrix[system.free][:, system.free].tocsc())

    def _move(self, step: FloatArray) -> None:
        whole = np.zeros(6 * len(self._system.frame.nodes))
        whole[self._system.free] = step
        own = self._system.own(whole.reshape(-1, 6))
        moved, turned, summed = self.state
        turned = corotational.turned_by(own[:, 3:], turned)
        self.state = (moved + own[:, :3], turned, summed + own[:, 3:])

    def direction(self) -> FloatArray:
        """(n,) movement for one more of the load."""
        return np.asarray(self._factored().solve(self._load[self._system.free]))

    def balanced(self, factor: float) -> bool:
        """Move until a part of the load is balanced; whether that was found."""
        free = self._system.free
        load = factor * self._load[free]
        # Of the whole load: of a small part of it rounding may leave more.
        size = float(np.linalg.norm(self._load[free])) or 1.0
        for _ in range(_STEPS):
            inner, _ = self._forces()
            left = load - inner[free]
            if not np.isfinite(left).all():
                return False
            try:
                if np.linalg.norm(left) <= _LEFT * size:
                    return _positive(self._factored())
                self._move(self._factored().solve(left))
            except SingularSystemError:
                return False
        return False

    def onto_path(
        self, before: float, factor: float, way: FloatArray
    ) -> tuple[float, FloatArray, int] | None:
        """Move along a way from where the factor was ``before``, then onto the path of balance.

        Returns:
            The factor there, the way that was gone, and in how many rounds.
        """
        free, load = self._system.free, self._load[self._system.free]
        self._move(way)
        total, weight = way.copy(), self.scale**2
        for rounds in range(1, _STEPS):
            inner, _ = self._forces()
            left = factor * load - inner[free]
            if np.linalg.norm(left) <= _LEFT * np.linalg.norm(load) * max(abs(factor), 1e-3):
                return factor, total, rounds
            solver = self._factored()
            more, rest = solver.solve(load), solver.solve(left)
            change = -float((weight * total) @ rest) / float((weight * total) @ more)
            step = rest + change * more
            factor += change
            total = total + step
            self._move(step)
        return None

    def displacements(self) -> FloatArray:
        """(N, 6) in the model's directions."""
        return np.concatenate([self.state[0], self.state[2]], axis=1)

    def response(self, factor: float) -> Response:
        """Forces and movements; the loads along members turn with them."""
        inner, own = self._forces()
        system = self._system
        held = self._springs * system.along_supports(self.displacements()).ravel()
        fixed = system.supports.fixed.ravel()
        reactions = np.where(fixed, inner - factor * self._load, -held)
        return Response(
            self.displacements(),
            own - factor * self._given,
            factor * self._spread,
            system.own(reactions.reshape(-1, 6)),
        )


def _positive(factors: SuperLU) -> bool:
    """Whether a symmetric matrix is positive: its pivots, if they were taken in order, are."""
    if not np.array_equal(factors.perm_r, factors.perm_c):
        return False
    return bool((factors.U.diagonal() > 0).all())
