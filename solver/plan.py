"""Which problems are tried for a net, and in which order."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from solver.mesh.bend import central_directions, unbent
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import QuadMesh
from solver.nets import CONTINUED, DEVELOPABLE, RECIPES
from solver.nets.constraints import Constraints, add_constraints
from solver.nets.options import NetOptions
from solver.nets.settings import Weights, add_guides
from solver.problem import Problem


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
        ladder = self.weights.ladder()
        others = self._ways_round(mesh, ladder)
        if not others:
            return [self.pose(mesh, ladder)]
        return [self.pose(mesh, ladder[:1]), *others, self.pose(mesh, ladder[1:])]

    def pose(self, mesh: QuadMesh, attempts: Sequence[Weights], net: str | None = None) -> Problem:
        """Pose this net, or another with the same options, from a start."""
        name = net or self.net
        problem = RECIPES[name](Problem(name, mesh, self.fixed), self.options)
        add_constraints(problem, self.constraints, attempts[0].closeness)
        return add_guides(problem, attempts)

    def _ways_round(self, mesh: QuadMesh, ladder: list[Weights]) -> list[Problem]:
        if self.net in CONTINUED:
            return [self._easier(mesh, ladder, *stage) for stage in CONTINUED[self.net]]
        free = not self.fixed.any() and self.constraints == Constraints()
        if self.net in DEVELOPABLE and free:
            ways = central_directions(mesh)
            return [self.pose(unbent(mesh, way), ladder) for way in ways]
        return []

    def _easier(self, mesh: QuadMesh, ladder: list[Weights], net: str, fairness: float) -> Problem:
        smoother = [replace(one, fairness=fairness * one.fairness) for one in ladder]
        problem = self.pose(mesh, smoother, net)
        problem.easier = lambda found: self.pose(found, ladder)
        return problem
