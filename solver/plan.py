"""Which problems are tried for a net, and in which order."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from solver.mesh.bend import central_directions, doubly_curved, unbent
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import QuadMesh
from solver.nets import NETS, Easier, Net
from solver.nets.constraints import Constraints, SurfaceGlide, add_constraints
from solver.nets.options import NetOptions
from solver.nets.settings import Weights, add_guides
from solver.problem import Problem
from solver.terms.evenness import Evenness

# Edges and faces of guarded nets are kept from collapsing and crossing over with this weight.
_GUARD = 0.1
# Weights of evenness in the first attempts of sheets: of such that are bent in one direction, of
# doubly curved ones, which have to give up a curvature, and of such from which it has been taken.
_SHEETS, _DOMES, _BENT = (0.3, 3.0), (30.0, 3.0, 0.3), (3.0, 30.0, 0.3)
# Third differences of a start, in mean edges, up to which it has no noise to be smoothed away.
_SMOOTH = 0.05


@dataclass(frozen=True)
class Plan:
    """A net with all that was said about it, ready to be posed from any start.

    Attributes:
        net: what is wanted.
        fixed: (V,) true for vertices that must not move.
        weights: of the guides in the first attempt.
    """

    net: Net
    fixed: BoolArray
    options: NetOptions
    constraints: Constraints
    weights: Weights

    def problems(self, mesh: QuadMesh) -> list[Problem]:
        """Return the net from the mesh, then ways round where that leads nowhere, then the rest."""
        if self.net.way.bent:
            return self._sheets(mesh)
        ladder = self._ladder()
        if not self.net.way.easier:
            return [self.pose(mesh, ladder)]
        others = [self._easier(mesh, ladder, stage) for stage in self.net.way.easier]
        return [self.pose(mesh, ladder[:1]), *others, self.pose(mesh, ladder[1:])]

    def single(self, mesh: QuadMesh) -> Problem:
        """Return the net from the mesh with the guides of its first attempt only."""
        bent = self.net.way.bent
        return self.pose(mesh, (self._of_sheet(mesh)[0] if bent else self._ladder())[:1])

    def pose(self, mesh: QuadMesh, attempts: Sequence[Weights], net: Net | None = None) -> Problem:
        """Pose this net, or another with the same options, from a start."""
        net = net or self.net
        empty = Problem(net.name, mesh, self.fixed, may_flatten=self._may_flatten)
        problem = net.recipe(empty, self.options)
        add_constraints(problem, self.constraints, attempts[0].closeness)
        return add_guides(problem, attempts)

    @property
    def _may_flatten(self) -> bool:
        """Whether a plane was asked for: by a net of sheets, or by saying where vertices are."""
        wanted = self.constraints
        surface = any(isinstance(glide, SurfaceGlide) for glide in wanted.glide)
        return bool(self.net.flat or wanted.handles or wanted.close_to is not None or surface)

    def _ladder(self) -> list[Weights]:
        """Weights of the attempts, the first ones as asked for."""
        first, *rest = self.weights.ladder()
        if self.net.way.guarded:
            guarded = [replace(one, edge_guard=_GUARD, face_guard=_GUARD) for one in (first, *rest)]
            # Some differ by their guards only.
            return list(dict.fromkeys(guarded))
        return [first, *self._even(self.net.way.evenness), *rest]

    def _even(self, weights: Sequence[float]) -> list[Weights]:
        return [self.weights.even(weight) for weight in weights]

    def _sheets(self, mesh: QuadMesh) -> list[Problem]:
        """The net from the mesh as it is and from the mesh bent in one direction only."""
        own, first, double = self._of_sheet(mesh)
        bent = []
        if not self.fixed.any() and self.constraints == Constraints():
            ladder = [*self._even(_BENT), *self.weights.ladder()]
            bent = [self.pose(unbent(mesh, way), ladder) for way in central_directions(mesh)]
        before, after = self.pose(mesh, own[:first]), self.pose(mesh, own[first:])
        if double and self.net.way.rigid:
            return [*bent, before, after]
        return [before, *bent, after]

    def _of_sheet(self, mesh: QuadMesh) -> tuple[list[Weights], int, bool]:
        """Weights for a sheet as it is, how many come before bending it, whether it is a dome."""
        double = doubly_curved(mesh)
        rest = self.weights.ladder()
        even = self._even(_DOMES if double else _SHEETS)
        if not double and not self.net.way.rigid and _unevenness(mesh) < _SMOOTH:
            return [rest[0], *even, *rest[1:]], 1, double
        return [*even, *rest], 1 if double else len(_SHEETS), double

    def _easier(self, mesh: QuadMesh, ladder: list[Weights], stage: Easier) -> Problem:
        smoother = [replace(one, fairness=stage.fairness * one.fairness) for one in ladder]
        if stage.evenness:
            smoother = [one.even(stage.evenness) for one in smoother[:2]]
            ladder = smoother
        problem = self.pose(mesh, smoother, NETS[stage.net])
        problem.easier = lambda found: self.pose(found, ladder)
        return problem


def _unevenness(mesh: QuadMesh) -> float:
    """Root mean square of the third differences along parameter lines, in mean edges."""
    term = Evenness(mesh.connectivity.line_quadruples)
    residual = term.linearise(mesh.vertices.ravel()).residual
    return float(np.sqrt((residual**2).sum(axis=1).mean()) / mesh.mean_edge) if len(residual) else 0
