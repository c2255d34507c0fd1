"""Judging a shape as a result: constraints met, nothing collapsed, nothing folded."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.analysis.measures import (
    area,
    edge_ratio,
    flipped,
    sharpest_crease,
    smoothness,
    thickness,
)
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.problem import Detail, Problem
from solver.report import Spread
from solver.tuning import Tuning


@dataclass(frozen=True)
class Candidate:
    """A shape and what it is worth.

    Attributes:
        problem: the net as it was posed.
        x: the flat vector of the shape, of that problem.
        mesh: the shape in model units.
        worst_place: face, edge or vertex with the largest residual of all.
        details: shared unknowns in model units, such as force densities.
        residuals: largest and mean value of each measure of the net.
        edge_ratio: shortest / mean edge; ``edge_ratio_start`` the same of the input.
        crease: sharpest angle between neighbouring faces, in degrees; ``crease_start`` likewise.
        thickness: smallest extent over the largest; ``thickness_start`` likewise.
        area_ratio: area over that of the input.
        smoothness: how evenly lines bend; ``smoothness_start`` the same of the input.
        flipped: number of folded faces; ``flipped_start`` the same of the input.
        may_flatten: a plane is as good as any other shape.
        may_resize: an area is as good as any other.
        met: every measure is within the tolerance on every face or star.
        tuning: from where on a shape is shrunk, creased or flattened.
    """

    problem: Problem
    x: FloatArray
    mesh: QuadMesh
    details: dict[str, Detail]
    worst_place: str
    residuals: dict[str, Spread]
    edge_ratio: float
    edge_ratio_start: float
    crease: float
    crease_start: float
    thickness: float
    thickness_start: float
    area_ratio: float
    smoothness: float
    smoothness_start: float
    flipped: int
    flipped_start: int
    may_flatten: bool
    may_resize: bool
    met: bool
    tuning: Tuning

    @property
    def kept(self) -> float:
        """Edge ratio relative to the input's."""
        return self.edge_ratio / self.edge_ratio_start if self.edge_ratio_start > 0 else 1.0

    @property
    def sound(self) -> bool:
        """Nothing collapsed and no face folded that was not folded at the start."""
        return self.kept >= self.tuning.shrunk and self.flipped <= self.flipped_start

    @property
    def valid(self) -> bool:
        """A solution of the net."""
        return self.met and self.sound

    @property
    def good(self) -> bool:
        """A solution that no further attempt needs to improve."""
        roomy = self.kept >= self.tuning.cramped
        spoilt = self.creased or self.flattened or self.resized or self.uneven
        return self.valid and roomy and not spoilt

    @property
    def flattened(self) -> bool:
        """The shape was given up for a plane, which is every net but not what was drawn."""
        thick = self.thickness_start >= self.tuning.thick
        return thick and self.thickness < self.tuning.flattened * self.thickness_start

    @property
    def gone(self) -> bool:
        """Nothing but a plane or a line is left of the shape, and that was not asked for."""
        solid = self.thickness_start >= self.tuning.solid and not self.may_flatten
        return solid and self.thickness < self.tuning.gone * self.thickness_start

    def dearer_than(self, other: Candidate) -> bool:
        """Whether lines bend less evenly, or short edges are shorter, than those of another."""
        return max(other.smoothness - self.smoothness, other.kept - self.kept) > self.tuning.dear

    @property
    def creased(self) -> bool:
        """Sharp creases appeared that the input did not have; folded faces are ``flipped``."""
        tuning = self.tuning
        return self.crease > max(tuning.creased, tuning.creasing * self.crease_start)

    @property
    def resized(self) -> bool:
        """The surface grew or shrank to another one than was drawn."""
        least = self.tuning.whole
        return not self.may_resize and not least <= self.area_ratio <= 1 / least

    @property
    def uneven(self) -> bool:
        """The lines zigzag, and those of the input did not."""
        return self.roughened > self.tuning.uneven

    @property
    def roughened(self) -> float:
        """How much less evenly lines bend than those of the input, or than is smooth."""
        return max(min(self.smoothness_start, self.tuning.even) - self.smoothness, 0.0)

    @property
    def worst(self) -> float:
        """Largest of all measures."""
        return max((spread.max for spread in self.residuals.values()), default=0.0)

    @property
    def rank(self) -> tuple[bool, bool, bool, bool, float, float]:
        """Sorts candidates: solutions first, good, sound, nearer to the form, smaller residuals."""
        likeness = self.likeness if self.valid else 0.0
        return (self.valid, not self.flattened, self.good, self.sound, likeness, -self.worst)

    @property
    def likeness(self) -> float:
        """Part of the input's area, evenness and edges that is left: the least, to a hundredth."""
        area = 1.0 if self.may_resize else min(self.area_ratio, 1 / max(self.area_ratio, 1e-9))
        unlike = self.tuning.unlike
        return round(min(1.0 - unlike + unlike * self.kept, area, 1.0 - self.roughened), 2)


def judge(
    problem: Problem, x: FloatArray, tolerance: float, original: Problem | None = None
) -> Candidate:
    """Measure the shape at the flat vector ``x``, against the start of the original problem."""
    start = original or problem
    mesh = problem.mesh_at(x)
    scalars = x[3 * len(mesh.vertices) :]
    values = {name: measure(mesh, scalars) for name, measure in problem.measures.items()}
    residuals = {name: spread_of(array) for name, array in values.items()}
    return Candidate(
        problem=problem,
        x=x,
        mesh=mesh,
        details={name: tell(mesh, scalars) for name, tell in problem.details.items()},
        worst_place=_worst_place(problem, values),
        residuals=residuals,
        edge_ratio=edge_ratio(mesh),
        edge_ratio_start=start.edge_ratio_start,
        crease=sharpest_crease(mesh),
        crease_start=start.crease_start,
        thickness=thickness(mesh),
        thickness_start=start.thickness_start,
        area_ratio=area(mesh) / start.area_start,
        smoothness=smoothness(mesh),
        smoothness_start=start.smoothness_start,
        flipped=int(flipped(mesh).sum()),
        flipped_start=start.flipped_start,
        may_flatten=start.may_flatten,
        may_resize=start.may_resize,
        met=all(spread.max <= tolerance for spread in residuals.values()),
        tuning=problem.tuning,
    )


def _worst_place(problem: Problem, values: dict[str, FloatArray]) -> str:
    filled = {name: array for name, array in values.items() if len(array)}
    if not filled:
        return ""
    name = max(filled, key=lambda key: float(filled[key].max()))
    return problem.places[name](int(np.argmax(filled[name])))


def spread_of(values: FloatArray) -> Spread:
    """Largest and mean of absolute values; zero where there are none."""
    if not len(values):
        return Spread(0.0, 0.0)
    size = np.abs(values)
    return Spread(float(size.max()), float(size.mean()))
