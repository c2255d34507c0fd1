"""Live editing: drag vertices of a net, see it follow, and end with the exact net."""

from __future__ import annotations

from collections.abc import Generator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from solver.errors import InputError, refuse_unknown
from solver.gauss_newton import Descent
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.nets.constraints import Constraints
from solver.optimise import Settings, start_optimisation
from solver.report import Outcome, StepRecord
from solver.terms.pull import Pull

if TYPE_CHECKING:
    # Of the standard library from Python 3.11 on.
    from typing_extensions import Unpack


class Session:
    """Holds a problem between drags: pattern, symbolic analysis and last shape are kept.

    Args:
        mesh: the start. A settled result depends on it and on where the handles are, not on the
            way that they were dragged: it is what one call of ``solver.optimise`` with these
            handles finds. Only where several nets fit the same handles, as with a sheet that can
            buckle to either side, it is the one in sight.
        handles: vertices that may be dragged; they start where they are.
        net: name of the net.
        settings: as for ``solver.optimise``; the handles of its ``constraints`` are replaced.

    Raises:
        InputError: no handle, or one that does not exist.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, Interactive Design.
    """

    def __init__(
        self,
        mesh: QuadMesh,
        handles: Sequence[int],
        net: str = "principal",
        **settings: Unpack[Settings],
    ) -> None:
        refuse_unknown("session", settings, Settings.__annotations__)
        # Kinds of parts are looked for when nothing is dragged.
        settings.pop("repeat", None)
        if not len(handles):
            raise InputError("handles: none given; name the vertices that may be dragged")
        for vertex in handles:
            if not 0 <= vertex < len(mesh.vertices):
                raise InputError(
                    f"handle: vertex {vertex} does not exist; vertices are numbered 0 to "
                    f"{len(mesh.vertices) - 1}"
                )
        self.targets = {int(vertex): mesh.vertices[vertex].copy() for vertex in handles}
        self._begin = np.array(list(self.targets.values()))
        # The plan reads these targets too: what it poses later is drawn to where they are then.
        wanted = settings.get("constraints") or Constraints()
        settings["constraints"] = replace(wanted, handles=self.targets)
        self._run = start_optimisation(mesh, net, **settings)
        self._first = self._run.descent
        self._frames = 0

    @property
    def vertices(self) -> FloatArray:
        """(V, 3) current positions in model units."""
        return self._run.origin.back_mesh(self._run.shape).vertices

    def drag(self, targets: Mapping[int, ArrayLike], steps: int = 1) -> StepRecord:
        """Move handles and take a few steps from the last shape.

        While handles move, the mesh follows them, nearly a net. While they rest, each call brings
        it nearer to the exact net that :meth:`settle` will find.

        Args:
            targets: new positions, in model units, of some of the handles.
            steps: how many Gauss-Newton steps to take.

        Returns:
            The record of the last step; ``vertices`` has the shape.

        Raises:
            InputError: a vertex that is no handle, or a position that is not finite.
        """
        wanted = {}
        for vertex, place in targets.items():
            position = np.asarray(place, dtype=np.float64)
            if vertex not in self.targets:
                raise InputError(
                    f"handle: vertex {vertex} is not one of {sorted(self.targets)}; start a "
                    "session with it"
                )
            if position.shape != (3,) or not np.isfinite(position).all():
                raise InputError(f"handle: the target of vertex {vertex} is not a point; mend it")
            wanted[vertex] = position
        moved = any(not np.array_equal(self.targets[v], place) for v, place in wanted.items())
        self.targets.update(wanted)
        if moved or self._run.finished:
            self._hold()
            self._aim(np.array(list(self.targets.values())))
        for _ in range(max(1, steps)):
            record = self._frame(follow=moved)
        return record

    def settle(self) -> Outcome:
        """Find the exact net for the present handles, on from the shape in sight."""
        settling = self.settling()
        while True:
            try:
                next(settling)
            except StopIteration as end:
                outcome: Outcome = end.value
                return outcome

    def settling(self) -> Generator[StepRecord, None, Outcome]:
        """Settle one step at a time, for a caller that has other things to do in between.

        Yields the record of each step; the outcome is the generator's return value. It may be left
        unfinished: the next drag goes on from the shape reached.
        """
        if not self._run.finished and self._run.attempts == 1:
            self._continue(self._run.descent)
        yield from self._steps()
        if self._run.descent.restless:
            # What was in sight had not come to rest and depends on the way: solve afresh.
            self._continue(self._at_start())
            self._aim(self._begin)
            yield from self._steps()
        return self._run.outcome()

    def _steps(self) -> Generator[StepRecord, None, None]:
        """All steps to the exact net."""
        while not self._run.finished:
            record = self._run.step()
            self._frames = len(self._run.history)
            yield record

    def _frame(self, follow: bool) -> StepRecord:
        """One step of the descent, without asking whether it was the last."""
        left = self._run.max_steps - self._frames
        self._frames += 1
        return self._run.descent.step(self._frames, left, self._run.attempts, follow)

    def _hold(self) -> None:
        """Go on from the shape in sight, with handles that have moved."""
        descent = self._run.descent
        if self._run.finished or self._run.attempts > 1:
            descent = self._at_start()
            descent.stand_at(self._run.shape)
        descent.hold()
        self._continue(descent)

    def _at_start(self) -> Descent:
        """The first attempt from the start of the session; its equations are laid out already."""
        return Descent(self._first.layout, self._first.attempt)

    def _continue(self, descent: Descent) -> None:
        """Count steps and look for the best shape from here on."""
        descent.count_afresh()
        self._run, self._frames = self._run.afresh(descent), 0

    def _aim(self, begin: FloatArray) -> None:
        """Draw the handles to their targets, from the (n, 3) points ``begin`` on."""
        problem = self._first.problem
        goals = np.array(list(self.targets.values()))
        begin, goals = (
            (self._run.origin.near(places) - problem.centre) / problem.scale
            for places in (begin, goals)
        )
        vertices = np.array(list(self.targets), dtype=np.int64)
        self._run.descent.retarget(Pull(vertices, begin, goals=goals))
