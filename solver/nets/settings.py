"""What a user can set about any net, and the guides that all recipes share."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from solver.analysis.kinds import ALIKE_DEG, REPEATED
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import QuadMesh
from solver.option import POSITIVE, Option, Range
from solver.problem import Guide, Problem
from solver.terms.base import Term
from solver.terms.closeness import Closeness
from solver.terms.edge_guard import EdgeGuard
from solver.terms.edge_vectors import EdgeVectors
from solver.terms.evenness import Evenness
from solver.terms.face_guard import FaceGuard
from solver.terms.fairness import Fairness
from solver.terms.isometry import Isometry
from solver.terms.multi import multi_net
from solver.terms.umbrella import umbrellas
from solver.tuning import Tuning

# Guides that do not fade.
_LASTING = ("edge_guard", "face_guard")


# What may be said of parts that are to repeat; they follow once the net is reached.
REPETITION = (
    Option(
        "repeat",
        "none",
        "choice",
        "Few kinds are wanted of these parts, once the net is reached",
        choices=("none", *REPEATED),
        title="Few kinds",
        brief="parts of which few kinds are wanted: a last phase moves along the nets to one with "
        "fewer; nodes by the angles between their edges",
        shown={"none": "not asked for", **{word: word for word in REPEATED}},
        stored="RepeatedParts",
    ),
    Option(
        "kinds",
        None,
        "count",
        "There may be so many kinds; 0 is as few as can be found",
        title="Kinds",
        brief="how many kinds of them there may be; more than that, and the exit code is 1",
        absent="as few as can be found",
        stored="KindsAtMost",
    ),
    Option(
        "alike",
        None,
        "length",
        "Panels and lengths of edges may be this far from the shape of their kind",
        title="Alike within",
        brief="how far the corners of panels, or lengths of edges, may be from the shape of their "
        "kind",
        absent="1/1000 of an edge",
        stored="AlikeWithin",
    ),
    Option(
        "alike_angle",
        ALIKE_DEG,
        "angle",
        "Edges of nodes may be turned this far from the shape of their kind",
        title="Alike to",
        brief="how far edges of nodes may be turned from the shape of their kind",
        within=POSITIVE,
    ),
)


# What ends a run that does not come to an end by itself.
STEPS = Option(
    "max_steps",
    1000,
    "count",
    "All attempts together take so many steps at most",
    brief="of all attempts",
    within=Range(1),
)


# What may be said of the guides, and when a run is done; no weight is the one of ``Weights``.
WEIGHTS: dict[str, Option] = {
    option.name: option
    for option in (
        Option(
            "fairness",
            None,
            "weight",
            "More of it draws lines straighter on the way; 0.01 is usual",
            brief="weight of straight lines",
            stored="FairnessWeight",
        ),
        Option(
            "closeness",
            None,
            "weight",
            "More of it keeps vertices nearer to where they are; 0.003 is usual",
            brief="weight of staying put",
            stored="ClosenessWeight",
        ),
        Option(
            "multi",
            None,
            "weight",
            "More of it keeps pairs of faces orthogonal; 0.001 is usual",
            title="Multi-net",
            brief="weight of the multi-net guide",
            stored="MultiWeight",
        ),
        Option(
            "multi_patch",
            (1, 2),
            "count",
            "The multi-net guide keeps patches of so many faces along and across orthogonal",
            suffixes=("Rows", "Columns"),
            brief="faces along and across the patches of the multi-net guide",
            within=Range(1),
        ),
        Option(
            "evenness",
            None,
            "weight",
            "More of it bends lines more evenly on the way; none is usual",
            brief="weight of lines that bend evenly",
            stored="EvennessWeight",
        ),
        Option(
            "smooth_motion",
            None,
            "weight",
            "More of it moves neighbours more alike; 0.1 is usual",
            brief="weight of neighbours that move alike",
            stored="MotionWeight",
        ),
        Option(
            "edge_vectors",
            None,
            "weight",
            "More of it keeps direction and length of edges; 0.02 is usual",
            brief="weight of edges that keep direction and length",
            stored="EdgeVectorWeight",
        ),
        Option(
            "isometry",
            None,
            "weight",
            "Faces keep their shape the more of it there is, such as 10; none is usual",
            brief="weight of faces' own shape",
            stored="IsometryWeight",
        ),
        Option(
            "tolerance",
            1e-10,
            "weight",
            "Residuals up to this count as zero",
            stored="TargetTolerance",
            within=POSITIVE,
        ),
        Option(
            "within",
            None,
            "length",
            "The result may be this far off the surface, or the start where none is given",
            absent="not limited",
            brief="how far the result may be off the surface, or off the start where none is "
            "given; beyond it the exit code is 1",
        ),
        *REPETITION,
    )
}


@dataclass(frozen=True)
class Weights:
    """Start weights of the guides of an attempt; all but the guards fade to zero.

    Attributes:
        fairness: straight parameter lines (w1 of the paper).
        multi: orthogonality of neighbouring pairs of faces (w2 of the paper).
        closeness: vertices stay where they started.
        evenness: parameter lines that bend evenly.
        smooth_motion: the motion, not the shape, is drawn straight.
        edge_vectors: edges keep direction and length.
        isometry: faces keep their shape (w_iso of the paper's table 2); off unless asked for.
        edge_guard: edges much shorter than the shortest at the start are pushed back; it
            stays to the end, where no edge is that short any more.
        face_guard: opposite edges of a face are kept within some 70 degrees of each other; it
            stays to the end, too.
    """

    fairness: float = 1e-2
    multi: float = 1e-3
    closeness: float = 3e-3
    evenness: float = 0.0
    smooth_motion: float = 1e-1
    edge_vectors: float = 2e-2
    isometry: float = 0.0
    edge_guard: float = 0.0
    face_guard: float = 0.0

    def __post_init__(self) -> None:
        for name, value in vars(self).items():
            WEIGHTS.get(name, Option(name, 0.0, "weight", "")).check(value)

    def ladder(self, tuning: Tuning) -> list[Weights]:
        """Weights of successive attempts.

        First these; then, for meshes that fairness creases at their irregular vertices, the nearest
        net without smoothing; then, for meshes that collapse, ever more fairness.
        """
        nearest = replace(
            self,
            fairness=tuning.nearest_fairness * self.fairness,
            closeness=tuning.nearest_closeness * self.closeness,
            smooth_motion=0.0,
            edge_vectors=0.0,
        )
        fairer = replace(self, fairness=tuning.fairer * self.fairness)
        fairest = replace(self, fairness=tuning.fairer**2 * self.fairness)
        guarded = replace(nearest, edge_guard=tuning.guard)
        return [self, nearest, guarded, fairer, fairest]

    def of(self, guide: Guide) -> float:
        """Weight of a guide at the start; of one that is none of these its own."""
        name = "multi" if guide.term.name == "multi-net" else guide.term.name.replace(" ", "_")
        return float(vars(self).get(name, guide.weight))

    def even(self, evenness: float) -> Weights:
        """The same for nets that keep a start's noise as soon as they may: only smooth it."""
        return replace(self, evenness=evenness, smooth_motion=0.0, edge_vectors=0.0)


def add_guides(
    problem: Problem, ladder: Sequence[Weights], rectangle: tuple[int, int] = (1, 2)
) -> Problem:
    """Add the guides that all recipes share and that lead some attempt of a ladder.

    Args:
        problem: to which they are added.
        ladder: weights of its attempts.
        rectangle: faces along and across the patches of the multi-net guide.
    """
    net, start = problem.mesh.connectivity, problem.start
    points = start[: 3 * net.vertex_count].reshape(-1, 3)
    used, guarded = np.flatnonzero(net.referenced), problem.tuning.guarded
    guides: dict[str, Callable[[], Term]] = {
        "fairness": lambda: Fairness(net.line_triples),
        "multi": lambda: multi_net(net, *rectangle),
        "closeness": lambda: Closeness(used, points[used]),
        "evenness": lambda: Evenness(net.line_quadruples),
        "smooth_motion": lambda: Fairness(net.line_triples, start, "smooth motion"),
        "edge_vectors": lambda: EdgeVectors(net.edges, start),
        "isometry": lambda: Isometry(net.quads, points),
        "edge_guard": lambda: EdgeGuard(net.edges, guarded * problem.edge_ratio_start),
        "face_guard": lambda: FaceGuard(net.quads, problem.tuning.upright),
    }
    if net.mixed:
        # Pairs of faces are no rectangles there, and few lines can be drawn straight.
        del guides["multi"]
        guides["fairness"] = lambda: Fairness(net.line_triples, start)
        weights = [one.fairness for one in ladder]
        for ring in umbrellas(net, start, "fairness"):
            problem.guides.append(Guide(ring, weights[0]))
    for name, build in guides.items():
        weights = [getattr(one, name) for one in ladder]
        if any(weight > 0 for weight in weights):
            problem.guides.append(Guide(build(), weights[0], lasting=name in _LASTING))
    return problem


def fixed_vertices(mesh: QuadMesh, fix: str | Sequence[int | str]) -> BoolArray:
    """(V,) mask of vertices that ``none``, ``corners``, ``boundary`` and numbers name.

    Corners are boundary vertices where no parameter line runs along the boundary; on a boundary
    that is one smooth loop there are none.

    Args:
        mesh: whose vertices.
        fix: a text such as ``boundary`` or ``corners,5,12``, or a list of words and numbers.

    Raises:
        InputError: an unknown word or a number out of range.
    """
    around = mesh.connectivity
    mask = np.zeros(around.vertex_count, dtype=bool)
    chosen = []
    for part in fix.split(",") if isinstance(fix, str) else fix:
        word = part.strip().lower() if isinstance(part, str) else ""
        if word == "corners":
            mask |= _some(around.corners, word)
        elif word == "boundary":
            mask |= _some(around.boundary_vertices, word)
        elif word != "none":
            chosen.append(_number(part, fix))
    # Before they become an array, which has no room for numbers of any length.
    for number in chosen:
        if not 0 <= number < around.vertex_count:
            raise InputError(
                f"fix: vertex {number} does not exist; vertices are numbered 0 to "
                f"{around.vertex_count - 1}"
            )
    mask[chosen] = True
    return mask


def _some(mask: BoolArray, word: str) -> BoolArray:
    if not mask.any():
        raise InputError(f"fix: the mesh has no {word}; name vertices by number, or use none")
    return mask


def _number(part: str | int, whole: object) -> int:
    try:
        return int(part)
    except ValueError:
        raise InputError(
            f"fix: expected none, corners, boundary or vertex numbers such as 0,5,12, got '{whole}'"
        ) from None
