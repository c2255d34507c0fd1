"""Report of an optimisation: numbers, and one sentence that says what to do next."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import cast

import numpy as np

from solver.analysis.form import form_of
from solver.analysis.start import Remark
from solver.candidate import Candidate, spread_of
from solver.mesh.closest import TriangleSurface
from solver.mesh.local_origin import LocalOrigin
from solver.mesh.quadmesh import QuadMesh
from solver.mesh.seams import seams
from solver.nets import NETS
from solver.problem import Problem
from solver.report import (
    COLLAPSED,
    CONVERGED,
    STALLED,
    STOPPED,
    Outcome,
    Repeated,
    Report,
    StepRecord,
    with_article,
)
from solver.tuning import Tuning


@dataclass(frozen=True)
class RunSummary:
    """How a run went.

    Attributes:
        original: the net from its start.
        status: how it ended; ``stopped`` while it goes on.
        history: a record for each step.
        attempts: how many were made.
        max_steps: how many steps there were to be at most.
        seconds_setup: before the first step.
        backend: name of the sparse solver.
        backend_says: what is out of the ordinary about how it does so, "" for nothing.
        remarks: what stood in the way before the first step.
        held: what keeps vertices from moving freely, such as "fixed vertices".
        origin: what coordinates were measured from.
        surface: the design surface, about the origin.
        within: how far from it the net may be at most, in model units.
        given_up: attempts were given up, as they came nearer too slowly.
        repetition: kinds of parts, where few were asked for and the net was reached.
    """

    original: Problem
    status: str
    history: Sequence[StepRecord]
    attempts: int
    max_steps: int
    seconds_setup: float
    backend: str
    backend_says: str
    remarks: Sequence[Remark]
    held: Sequence[str]
    origin: LocalOrigin
    surface: TriangleSurface | None
    within: float | None
    given_up: bool
    repetition: Repeated | None = None


def summarise(run: RunSummary, best: Candidate) -> Outcome:
    """Put how a run went, and the best shape of it, into an :class:`Outcome`."""
    problem, history = run.original, run.history
    start = problem.mesh
    used = start.connectivity.referenced
    moved = np.linalg.norm(best.mesh.vertices - start.vertices, axis=1)[used] / start.mean_edge
    form = form_of(start, best.mesh, run.surface)
    report = Report(
        net=problem.net,
        status=run.status,
        message=_message(run, best),
        warnings=[*map(str, run.remarks), *filter(None, [run.backend_says])],
        vertices=len(start.vertices),
        faces=start.connectivity.face_count,
        variables=problem.variables,
        constraints=problem.equations,
        iterations=len(history),
        attempts=run.attempts,
        seconds=run.seconds_setup + sum(record.seconds for record in history),
        seconds_setup=run.seconds_setup,
        seconds_per_iteration=_median([record.seconds for record in history]),
        solve_seconds_per_iteration=_median([record.solve_seconds for record in history]),
        residuals=best.residuals,
        details=best.details,
        edge_ratio=best.edge_ratio,
        edge_ratio_start=best.edge_ratio_start,
        flipped_faces=best.flipped,
        exempt_faces=run.original.exempt,
        moved=spread_of(moved),
        form=form,
        within=run.within,
        repetition=run.repetition,
        mean_edge=start.mean_edge,
        size=_size(best.mesh),
        size_start=_size(start),
        origin=cast(list[float], run.origin.shift.tolist()),
        solver=run.backend,
        remarks=[
            *_crumpled(run, best),
            *_drawn_along(run, form.border / start.mean_edge),
            *_remarks(start, best.mesh, best.tuning),
            *_left_out(run.original),
        ],
        history=list(history),
        tuning=best.tuning,
    )
    return Outcome(run.origin.back_mesh(best.mesh), report)


def _message(run: RunSummary, best: Candidate) -> str:
    steps = len(run.history)
    if run.status == CONVERGED:
        if not steps:
            return f"the mesh is {with_article(run.original.net)} net already: worst {_worst(best)}"
        return f"{run.original.net} net reached: worst {_worst(best)} after {steps} steps"
    remedies = _remedies(run, best)
    advice = "; try: " + "; ".join(remedies) if remedies else ""
    if run.status == COLLAPSED:
        part = best.thickness / best.thickness_start
        left = "nothing" if best.gone else f"{part:.2f} of the thickness"
        return (
            f"{run.original.net} net reached as {_remains(best)} only: after {steps} steps "
            f"{left} is left of the shape{advice}"
        )
    verb = "ended" if run.status == STOPPED else "no further progress"
    where = f" at {best.worst_place}" if best.worst_place else ""
    return f"{verb} after {steps} steps, worst {_worst(best)}{where}{advice}"


def _remedies(run: RunSummary, best: Candidate) -> list[str]:
    """What to try, by what was asked and what came of it."""
    remedies = [remark.remedy for remark in run.remarks]
    if not best.sound:
        trouble = []
        if best.kept < best.tuning.shrunk:
            trouble.append(f"the shortest edge shrank to {best.kept:.2f} of its start ratio")
        if best.flipped > best.flipped_start:
            some = "1 face is" if best.flipped == 1 else f"{best.flipped} faces are"
            trouble.append(f"{some} folded")
        remedies.append(" and ".join(trouble) + ": raise fairness or closeness")
    if not any(remark.cause == "border" for remark in run.remarks):
        remedies += [f"fewer {what} give the net room" for what in run.held]
    if run.status == STOPPED and len(run.history) >= run.max_steps:
        remedies.insert(0, f"more than {run.max_steps} steps")
    if run.status == COLLAPSED and not remedies:
        remedies.append("a border that is fixed or glides, or a surface to stay close to")
        net = NETS.get(run.original.net)
        if net is not None and net.shape in ("minimal", "saddle"):
            remedies.append("a saddle: where a surface bulges it has no such lines")
    if run.status == STALLED and run.given_up:
        remedies.append(
            "a net that asks for less, or a start nearer to it (it is rigid but for bending, and "
            "came nearer so slowly that hundreds of steps more would be needed)"
        )
    if run.status == STALLED and not remedies:
        remedies.append("more fairness, or a start mesh nearer to the net")
    return remedies


def _remains(best: Candidate) -> str:
    """What a shape without thickness, or with little of it, is called."""
    if not best.gone:
        return "a flatter one"
    mesh = best.mesh
    points = mesh.vertices[mesh.connectivity.referenced]
    extents = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)
    return "a line" if extents[1] < best.tuning.line * extents[0] else "a plane"


def _crumpled(run: RunSummary, best: Candidate) -> list[str]:
    """That a net, however exact, is none to build from."""
    tuning = best.tuning
    # Lines that were drawn straight between creases bend evenly by zero; such a roof stays as it
    # is.
    if not run.history and best.smoothness > -tuning.crumpling:
        return []
    if best.smoothness >= tuning.crumpled and best.roughened <= tuning.crumpling:
        return []
    return [
        f"lines zigzag (evenness {best.smoothness:.2f}, where 1 is smooth): look at it "
        "before anything is built of it; a start that is smooth and whose lines run as those "
        "of the net do, or more fairness, gives another"
    ]


def _drawn_along(run: RunSummary, border: float) -> list[str]:
    """That a net left its border to be on its surface, and which start would not.

    Args:
        run: that is over.
        border: how far the border is from where it was, in mean edges.
    """
    lines = NETS[run.original.net].lines if run.original.net in NETS else ""
    most = run.original.tuning.border_left
    if not lines or run.surface is None or run.original.may_resize or border <= most:
        return []
    return [
        f"the border is up to {border:.1f} mean edges from where it was drawn, as the net runs "
        "along other lines of the surface than the start; a start along these keeps it (align, in "
        f"FreeCAD Net along curvature, with lines for {lines})"
    ]


def _left_out(problem: Problem) -> list[str]:
    """Where no right angles are asked, and why."""
    if not problem.exempt:
        return []
    few = problem.exempt == 1
    return [
        f"{problem.exempt} {'place' if few else 'places'} next to inner vertices where more or "
        f"fewer than four faces meet {'is' if few else 'are'} not asked for right angles, which a "
        "smooth surface does not have there (singular: include asks it all the same)"
    ]


def _remarks(start: QuadMesh, end: QuadMesh, tuning: Tuning) -> list[str]:
    """Where the start meets itself without being joined, and what became of that."""
    found = seams(start)
    opened = found.opened(start, end)
    said = found.remarks()
    if opened > tuning.opened:
        said.append(f"what meets without being joined came apart by up to {opened:.2g} mean edges")
    return said


def _worst(best: Candidate) -> str:
    if not best.residuals:
        return "residual 0"
    name = max(best.residuals, key=lambda key: best.residuals[key].max)
    return f"{name} {best.residuals[name].max:.1e}"


def _size(mesh: QuadMesh) -> list[float]:
    """Lengths of the bounding box of all faces."""
    used = mesh.vertices[mesh.connectivity.referenced]
    return cast(list[float], (used.max(axis=0) - used.min(axis=0)).tolist())


def _median(values: list[float]) -> float:
    return float(np.median(values)) if values else 0.0
