"""What the last phase of an optimisation lowers, how long it goes on, and what it has to keep."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from solver.analysis.form import off_surface
from solver.analysis.measures import slant
from solver.candidate import Candidate
from solver.mesh.closest import TriangleSurface
from solver.problem import Problem
from solver.report import COLLAPSED, CONVERGED
from solver.tuning import Tuning
from solver.wishes import Wish, drawn, limit_in_reach, missing, nearness, pull_of


@dataclass(frozen=True)
class Aim:
    """Which of all the nets that there are is wanted.

    Attributes:
        surface: the design surface, about the origin. Where the net is reached, the last phase
            moves along the nets to the one nearest to it.
        within: how far from it the result may be, in model units. Where it is farther, another last
            phase weighs what is beyond that.
        nearest: of all such nets the one nearest to the surface is what was asked for.
        early: a net that is not good is first led on by the last phase, then by other attempts.
        late: a good net is led on too, as one near to the surface is wanted.
        righted: a net that is not good, or whose corners are far from upright, is led on to one
            more like the start.
        thick: no flatter net than the start is what was asked for, near to a surface or not.
    """

    surface: TriangleSurface | None = None
    within: float | None = None
    nearest: bool = False
    early: bool = False
    late: bool = True
    righted: bool = False
    thick: bool = False

    @property
    def meant(self) -> bool:
        """Whether it is the surface that is wanted, so that no flatter net will do."""
        return self.thick or (self.surface is not None and self.late)


def wishes_of(
    problem: Problem,
    original: Problem,
    surface: TriangleSurface | None,
    evenness: float,
    within: float | None,
    near: bool,
    early: bool,
    righted: bool = False,
) -> list[Wish]:
    """Handles at their goals where there are any, else the surface.

    Args:
        problem: of the net from which the last phase sets out.
        original: as posed from the start.
        surface: the design surface, about the origin.
        evenness: weight of lines that bend evenly.
        within: distance from the surface from which on it weighs more.
        near: the net nearly is on the surface.
        early: other attempts would follow.
        righted: corners are to turn upright.
    """
    pull = pull_of(problem)
    if pull is not None:
        return drawn(problem, original.mesh, pull)
    assert surface is not None
    return nearness(problem, original.mesh, surface, evenness, within, near, early, righted)


def has_a_wish(net: Candidate, original: Problem, surface: TriangleSurface | None) -> bool:
    """Whether there is a surface to come near to, or handles that were lost on the way."""
    problem = net.problem
    if pull_of(problem) is None:
        return surface is not None
    before = missing(problem, problem.at(original.mesh)).max()
    return bool(missing(problem, net.x).max() > problem.tuning.lost * before)


def far_off(net: Candidate, surface: TriangleSurface | None) -> float:
    """What it lowers: the largest distance from the surface, without one that of handles."""
    if surface is None:
        return float(missing(net.problem, net.x).max(initial=0.0))
    return float(off_surface(net.mesh, surface).max())


class AlongCourse(NamedTuple):
    """How the last phase goes from a net.

    Attributes:
        evenness: weight of lines that bend evenly.
        near: the net nearly is on the surface.
        sharp: another attempt follows that lowers the largest distance,
        late: and so it does here, but only after most of the steps: lines have to turn even first.
        righted: corners are to turn upright, and the border holds.
    """

    evenness: float
    near: bool = False
    sharp: bool = False
    late: bool = False
    righted: bool = False


def course_from(
    net: Candidate, far: float, original: Problem, handles: bool, rough: bool, early: bool
) -> AlongCourse:
    """How the last phase goes from a net: the farther it is, the more even lines weigh.

    Args:
        net: from which it sets out.
        far: how far off the surface it is, in model units.
        original: as posed from the start.
        handles: it is these that are pulled, not the surface that is wanted.
        rough: the net was not made for the surface, or is free enough to come near by itself.
        early: other attempts would follow.
    """
    tuning = net.tuning
    if early:
        return AlongCourse(tuning.along_early)
    if handles or rough:
        return AlongCourse(tuning.along_evenness)
    if limit_in_reach(far, original.mesh, original.tuning) is not None:
        return AlongCourse(tuning.along_near, near=True)
    if far <= tuning.long_way * float(np.linalg.norm(np.ptp(original.mesh.vertices, axis=0))):
        return AlongCourse(tuning.along_evenness, sharp=True)
    # Lines that are less even have no more to lose than is allowed.
    uneven = net.smoothness < min(net.smoothness_start, tuning.even + tuning.uneven)
    return AlongCourse(tuning.along_rough, late=True) if uneven else AlongCourse(tuning.along_far)


def is_sound(found: Candidate, before: Candidate) -> bool:
    """Whether it kept what made the net before it good."""
    creased = found.creased and not before.creased
    uneven = found.uneven and not before.uneven
    return found.valid and found.kept >= found.tuning.still_roomy and not creased and not uneven


def is_whole(found: Candidate, before: Candidate) -> bool:
    """Whether it kept the area of the net before it."""
    return found.area_ratio >= found.tuning.still_whole * before.area_ratio


def is_enough(found: Candidate) -> bool:
    """Whether other attempts are needless after a last phase that came early."""
    least = found.tuning.alike
    return found.good and least <= found.area_ratio <= 1 / least


def is_upright(net: Candidate) -> bool:
    """Whether no corner of a face is far from upright."""
    return slant(net.mesh) <= net.tuning.slanted


def is_as_whole(found: Candidate, before: Candidate) -> bool:
    """Whether it has the start's area, or is no farther from it than the net before it."""
    least = min(found.tuning.alike, _whole(before))
    return _whole(found) >= least


def faithful(net: Candidate, far: float) -> float:
    """What is left of the start: area, even lines, edges, upright corners, place; 1 is all of it.

    Args:
        net: that was reached.
        far: how far it is off the start, as part of its size.
    """
    edges = 1.0 - max(net.tuning.roomy - net.kept, 0.0)
    beyond = max(slant(net.mesh) - net.tuning.slanted, 0.0) / (90.0 - net.tuning.slanted)
    return _whole(net) * (1.0 - net.roughened) * edges * (1.0 - beyond) * (1.0 - far)


def _whole(net: Candidate) -> float:
    """Area over that of the start, or its inverse where it grew."""
    return min(net.area_ratio, 1.0 / max(net.area_ratio, 1e-9))


def verdict(net: Candidate, meant: bool) -> str:
    """Whether a net is what was asked for.

    Args:
        net: that was reached.
        meant: no flatter one than the start was asked for.
    """
    thick = net.thickness_start >= net.tuning.thick
    lost = meant and thick and net.thickness < net.tuning.still_thick * net.thickness_start
    return COLLAPSED if net.gone or lost else CONVERGED


def most_steps(tuning: Tuning, done: int, wanted: bool, hoped: bool) -> int:
    """How many steps it takes.

    Args:
        tuning: the numbers of the solver.
        done: steps before it.
        wanted: to be near is what was asked for.
        hoped: it comes early.
    """
    least = tuning.nearest_steps if wanted else tuning.along_steps
    return max(done, tuning.early_steps if hoped else least)
