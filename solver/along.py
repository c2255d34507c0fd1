"""An attempt of the last phase: steps along the nets, from one that was reached."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

from solver.candidate import Candidate
from solver.gauss_newton import largest_residuals
from solver.mesh.quadmesh import QuadMesh
from solver.nearest import NearestNet
from solver.problem import Problem
from solver.repetition import Repetition
from solver.report import StepRecord


@dataclass(eq=False)
class Along:
    """Steps along the nets, one at a time.

    Attributes:
        moving: what takes them.
        reached: judges where it stands, exactly on the net.
        most: steps that it takes at most.
        taken: steps so far.
    """

    moving: NearestNet | Repetition
    reached: Callable[[], Candidate]
    most: float = float("inf")
    taken: int = 0

    @property
    def problem(self) -> Problem:
        """The net along which it moves."""
        return self.moving.problem

    @property
    def mesh(self) -> QuadMesh:
        """Current shape, about the problem's origin."""
        return self.moving.mesh

    @property
    def over(self) -> bool:
        """Whether no further step helps, or as many were taken as it may."""
        return self.moving.finished or self.taken >= self.most

    def step(self, number: int, steps_left: int, attempt: int) -> StepRecord:
        """Take one step and return its record.

        Args:
            number: of the step, for the record.
            steps_left: how many may be taken, which makes no difference here.
            attempt: number of the attempt, for the record.
        """
        begin, damping = time.perf_counter(), self.moving.damping
        length, solving = self.moving.step()
        self.taken += 1
        parts = self.moving.point.linearisations
        return StepRecord(
            step=number,
            attempt=attempt,
            energy=self.moving.wishes,
            residuals=largest_residuals(self.problem.constraints, parts),
            step_length=length,
            damping=damping,
            fade=0.0,
            seconds=time.perf_counter() - begin,
            solve_seconds=solving,
        )

    def is_over(self, record: StepRecord, tolerance: float, steps_left: int) -> bool:
        """Whether nothing more is to be had, whatever the last step did."""
        return self.over
