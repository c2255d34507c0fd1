"""Which problems are tried for a net, and in which order."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from solver.mesh.bend import central_directions, doubly_curved, unbent
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import QuadMesh
from solver.nets import CONTINUED, DEVELOPABLE, GUARDED, RECIPES, RIGID, Stage
from solver.nets.constraints import Constraints, add_constraints
from solver.nets.options import NetOptions
from solver.nets.settings import Weights, add_guides
from solver.problem import Problem

# Edges and faces of guarded nets are kept from collapsing and crossing over with this weight.
_GUARD = 0.1
# Weights of evenness in the first attempts of sheets, and in those after the first of other nets.
_SHEETS = (0.3, 3.0)
_EVENNESS = {"asymptotic": (3.0, 30.0), "cmc": (3.0, 30.0)}


@dataclass(frozen=True)
class Plan:
    """A net with all that was said about it, ready to be posed from any start.

    Attributes:
        net: name of the recipe.
        fixed: (V,) true for vertices that must not move.
        weights: of the guides in the first attempt.
    """

    net: str
    fixed: BoolArray
    options: NetOptions
    constraints: Constraints
    weights: Weights

    def problems(self, mesh: QuadMesh) -> list[Problem]:
        """Return the net from the mesh, then ways round where that leads nowhere, then the rest."""
        ladder = self._ladder()
        if self.net in DEVELOPABLE:
            return self._sheets(mesh, ladder)
        if self.net not in CONTINUED:
            return [self.pose(mesh, ladder)]
        others = [self._easier(mesh, ladder, stage) for stage in CONTINUED[self.net]]
        return [self.pose(mesh, ladder[:1]), *others, self.pose(mesh, ladder[1:])]

    def single(self, mesh: QuadMesh) -> Problem:
        """Return the net from the mesh with the weights as they are."""
        return self.pose(mesh, self._ladder()[:1])

    def pose(self, mesh: QuadMesh, attempts: Sequence[Weights], net: str | None = None) -> Problem:
        """Pose this net, or another with the same options, from a start."""
        name = net or self.net
        problem = RECIPES[name](Problem(name, mesh, self.fixed), self.options)
        add_constraints(problem, self.constraints, attempts[0].closeness)
        return add_guides(problem, attempts)

    def _ladder(self) -> list[Weights]:
        """Weights of the attempts, the first ones as asked for."""
        first, *rest = self.weights.ladder()
        if self.net in DEVELOPABLE:
            return [*self._even(_SHEETS), first, *rest]
        if self.net in GUARDED:
            ladder = [first, *rest]
            return [replace(one, edge_guard=_GUARD, face_guard=_GUARD) for one in ladder]
        return [first, *self._even(_EVENNESS.get(self.net, (1.0,))), *rest]

    def _even(self, weights: Sequence[float]) -> list[Weights]:
        return [self.weights.even(weight) for weight in weights]

    def _sheets(self, mesh: QuadMesh, ladder: list[Weights]) -> list[Problem]:
        """The net from the mesh as it is and from the mesh bent in one direction only."""
        even = len(_SHEETS)
        bent = []
        if not self.fixed.any() and self.constraints == Constraints():
            firmest_first = [*ladder[:even][::-1], *ladder[even:]]
            bent = [self.pose(unbent(mesh, way), firmest_first) for way in central_directions(mesh)]
        whole = [self.pose(mesh, ladder[:even]), *bent, self.pose(mesh, ladder[even:])]
        if bent and self.net in RIGID and doubly_curved(mesh):
            return [*bent, *whole[:1], *whole[-1:]]
        return whole

    def _easier(self, mesh: QuadMesh, ladder: list[Weights], stage: Stage) -> Problem:
        smoother = [replace(one, fairness=stage.fairness * one.fairness) for one in ladder]
        if stage.evenness:
            smoother = [one.even(stage.evenness) for one in smoother[:2]]
            ladder = smoother
        problem = self.pose(mesh, smoother, stage.net)
        problem.easier = lambda found: self.pose(found, ladder)
        return problem
