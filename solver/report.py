"""What the solver says: a record after each step, a report at the end."""

from __future__ import annotations

from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np

from solver.analysis.form import Form
from solver.mesh.quadmesh import QuadMesh
from solver.tuning import Tuning

CONVERGED = "converged"
COLLAPSED = "collapsed"
STALLED = "stalled"
STOPPED = "stopped"


@dataclass(frozen=True)
class StepRecord:
    """State after one step.

    Attributes:
        step: number of the step, from 1, counted over all attempts.
        attempt: number of the attempt, from 1.
        energy: weighted sum of squares after the step.
        residuals: largest absolute residual of each constraint, dimensionless.
        step_length: largest move of a coordinate, in mean edges.
        damping: Levenberg-Marquardt damping of the step.
        fade: factor on the guides during the step, 1 at the start, 0 at the end.
        seconds: duration of the step.
        solve_seconds: the part spent in factorisations and solves.
    """

    step: int
    attempt: int
    energy: float
    residuals: dict[str, float]
    step_length: float
    damping: float
    fade: float
    seconds: float
    solve_seconds: float

    @property
    def worst(self) -> float:
        """Largest residual of all constraints."""
        return max(self.residuals.values(), default=0.0)


@dataclass(frozen=True)
class Spread:
    """Largest and mean absolute value of a measure."""

    max: float
    mean: float


@dataclass(frozen=True)
class Repeated:
    """Kinds of parts of a net.

    Attributes:
        of: panels, edges or nodes.
        kinds: how many there are.
        asked: how many there might be, None for as few as can be found.
        alike: how far a part may be from the shape of its kind, in model units, of nodes in
            degrees; ``largest_miss`` is how far one is at most.
        kinds_before: how many there were in the net that was reached before.
        counts: how many parts there are of each kind.
        kind: the kind of each face, edge or vertex, from 0; -1 for vertices of no face.
        is_reached: there are no more kinds than was asked.
    """

    of: str
    kinds: int
    asked: int | None
    alike: float
    largest_miss: float
    kinds_before: int
    counts: list[int]
    kind: list[int]
    is_reached: bool


@dataclass(frozen=True)
class Report:
    """Outcome of an optimisation in numbers; ``as_dict`` is the contract of ``report.json``.

    Attributes:
        net: name of the net.
        status: converged; collapsed, where it is the net but nothing is left of its shape; stalled;
            or stopped.
        message: one sentence: what happened and what to do next.
        warnings: what stood in the way before the first step, one sentence each.
        variables: unknowns as the paper counts them, auxiliary ones included.
        constraints: equations as the paper counts them.
        iterations: steps of all attempts.
        attempts: how many sets of guides were tried.
        seconds: of set-up and steps; ``seconds_per_iteration`` and ``solve_seconds_per_iteration``
            are medians.
        residuals: largest and mean of each measure of the net, on the mesh that is returned.
        details: what the net found besides its shape, such as force densities, in model units.
        edge_ratio: shortest edge / mean edge.
        edge_ratio_start: the same of the input.
        flipped_faces: faces that lie against their neighbours or have a corner turned inside out.
        exempt_faces: faces at singular vertices that are not asked for right angles; in diagonal
            variants the vertices around which a face of the diagonal meshes lies.
        moved: mean and largest distance from the input, in mean edges of the input.
        form: how much of what was drawn is left; in ``report.json`` its numbers stand beside the
            others: ``off_surface`` with ``max``, ``mean`` and ``percent``, ``border``,
            ``area_ratio``, ``height_ratio``, ``zigzag``, ``gap``.
        within: how far from the design surface it may be, in model units, where that was asked.
        repetition: the kinds of parts, where few of them were asked for.
        mean_edge: of the input, in model units.
        size: lengths of the bounding box along x, y and z, in model units.
        size_start: the same of the input.
        origin: point about which was computed, in model units: zero near the origin, a round number
            near the input far from it.
        seconds_setup: pattern, numbering and symbolic analysis.
        solver: name of the sparse solver.
        remarks: where the mesh meets itself without being joined, and by how much it came apart.
        history: a record for each step.
        tuning: the numbers of the solver, for what is said of the result.
    """

    net: str
    status: str
    message: str
    warnings: list[str]
    vertices: int
    faces: int
    variables: int
    constraints: int
    iterations: int
    attempts: int
    seconds: float
    seconds_setup: float
    seconds_per_iteration: float
    solve_seconds_per_iteration: float
    residuals: dict[str, Spread]
    details: dict[str, float | list[float]]
    edge_ratio: float
    edge_ratio_start: float
    flipped_faces: int
    exempt_faces: int
    moved: Spread
    form: Form
    within: float | None
    repetition: Repeated | None
    mean_edge: float
    size: list[float]
    size_start: list[float]
    origin: list[float] = field(default_factory=lambda: [0.0, 0.0, 0.0])
    solver: str = ""
    remarks: list[str] = field(default_factory=list)
    history: list[StepRecord] = field(default_factory=list, repr=False)
    tuning: Tuning = field(default_factory=Tuning, repr=False)

    @property
    def is_within(self) -> bool:
        """Whether it is as near to the design surface as was asked, if anything was."""
        return self.within is None or self.form.off_surface.max <= self.within

    @property
    def is_repeated(self) -> bool:
        """Whether there are as few kinds of parts as was asked, if anything was."""
        return self.repetition is None or self.repetition.is_reached

    @property
    def flat(self) -> bool:
        """Whether flat faces were asked for, exactly or to a length."""
        return not {"planarity", "flatness"}.isdisjoint(self.residuals)

    @property
    def far(self) -> bool:
        """Tell whether the shape is so far from the input that it should be said."""
        before, after, tuning = np.array(self.size_start), np.array(self.size), self.tuning
        moved = self.moved.max * self.mean_edge > tuning.moved_of_all * np.linalg.norm(before)
        resized = (np.abs(after - before) > tuning.resized * before).any()
        return bool(self.moved.max > tuning.moved and (moved or resized))

    def as_dict(self) -> dict[str, Any]:
        """Return plain numbers and strings for JSON, without history and tuning."""
        data = asdict(self)
        del data["history"], data["tuning"]
        data.update(data.pop("form"), is_within=self.is_within, is_repeated=self.is_repeated)
        return data


@dataclass(frozen=True)
class Outcome:
    """The mesh that an optimisation found and its report."""

    mesh: QuadMesh
    report: Report


def with_article(net: str) -> str:
    """Name of a net after "a" or "an"."""
    return f"{'an' if net[0] in 'aeio' else 'a'} {net}"
