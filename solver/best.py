"""The best shape of a run, found with as little judging as can be."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from solver.candidate import Candidate


class Best:
    """Keeps the best shape that a run came by.

    Judging costs about as much as the terms do, so shapes on the way are only noted, and judged
    where the end of an attempt is no solution: one of them may be sound where the end has folded.

    Args:
        worth: a shape that is no solution replaces another when its worst residual is smaller by
            this factor.
    """

    def __init__(self, worth: float) -> None:
        self._worth = worth
        self._best: Candidate | None = None
        self._noted: list[Callable[[], Candidate]] = []
        self._worst = np.inf

    def note(self, worst: float, judge: Callable[[], Candidate]) -> None:
        """Note a shape on the way by its largest residual, and how to judge it."""
        if worst < self._worth * self._worst:
            self._worst = worst
            self._noted.append(judge)

    def consider(self, candidate: Candidate) -> Candidate:
        """Weigh the shape at the end of an attempt against all before; return the best."""
        if not candidate.valid:
            self.so_far()
        self._noted.clear()
        self._weigh(candidate)
        best = self._best or candidate
        self._worst = 0.0 if best.valid else best.worst
        return best

    def so_far(self) -> Candidate | None:
        """The best of the shapes considered and noted, None where there are none."""
        for judge in self._noted:
            if self._best is None or not self._best.valid:
                self._weigh(judge())
        self._noted.clear()
        return self._best

    def _weigh(self, candidate: Candidate) -> None:
        best = self._best
        if best is not None and not candidate.valid and candidate.sound == best.sound:
            # Where the net is out of reach, a little less of it is not worth wandering for.
            if candidate.worst > self._worth * best.worst:
                return
        if best is None or candidate.rank > best.rank:
            self._best = candidate
