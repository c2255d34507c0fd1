"""One call for every net."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, TypedDict

import numpy as np

from solver.align.reach import beyond, reaching
from solver.analysis.form import surface_of
from solver.analysis.kinds import ALIKE, ALIKE_DEG, NODES
from solver.analysis.measures import smoothness
from solver.analysis.start import coarse_faces, start_remarks
from solver.errors import InputError, refuse_unknown
from solver.last_phase import Aim
from solver.mesh.closest import TriangleSurface
from solver.mesh.local_origin import LocalOrigin
from solver.mesh.mixed import MixedConnectivity
from solver.mesh.quadmesh import QuadMesh, refuse_other
from solver.nets import Net, net_named, refuse_foreign
from solver.nets.constraints import Constraints, corners_that_stay, on_curves, settled
from solver.nets.options import NetOptions
from solver.nets.settings import STEPS, WEIGHTS, Weights
from solver.nets.supports import supports_of
from solver.plan import Plan
from solver.problem import Problem
from solver.repetition import Repeat
from solver.report import Outcome, StepRecord
from solver.run import Optimisation
from solver.tuning import Tuning

if TYPE_CHECKING:
    # Of the standard library from Python 3.11 on.
    from typing_extensions import Unpack

# In mean edges, how far off a surface is on it: files of triangles have seven digits.
_ON = 1e-5


class Settings(TypedDict, total=False):
    """What :func:`start_optimisation` can be told, by its name."""

    fairness: float | None
    closeness: float | None
    multi: float | None
    multi_patch: tuple[int, int]
    evenness: float | None
    smooth_motion: float | None
    edge_vectors: float | None
    isometry: float | None
    fix: str | Sequence[int | str]
    supports: str | Sequence[int | str]
    within: float | None
    repeat: str
    kinds: int | None
    alike: float | None
    alike_angle: float
    tolerance: float
    max_steps: int
    backend: str | None
    options: NetOptions | None
    constraints: Constraints | None
    tuning: Tuning | None


def optimise(
    mesh: QuadMesh,
    net: str = "principal",
    *,
    callback: Callable[[StepRecord], bool | None] | None = None,
    **settings: Unpack[Settings],
) -> Outcome:
    """Move the vertices of a mesh until it is the wanted net.

    Args:
        mesh: the start, in any unit; it is not changed.
        net: name of the net, see ``solver.nets.NETS``.
        callback: called after each step; returning True stops.
        settings: ``fairness``, ``closeness``, ``multi``, ``multi_patch``,
            ``evenness``, ``smooth_motion``, ``edge_vectors``, ``isometry``, ``fix``, ``supports``,
            ``within``, ``repeat``, ``kinds``, ``alike``, ``alike_angle``, ``tolerance``,
            ``max_steps``, ``backend``, ``options``, ``constraints``,
            ``tuning``, as for :func:`start_optimisation`.

    Returns:
        The best mesh found, with its report. A ``KeyboardInterrupt`` during a step stops the run
        in the same clean way as the callback does.

    Raises:
        InputError: a setting that cannot be used.
    """
    refuse_unknown("optimise", settings, Settings.__annotations__)
    return start_optimisation(mesh, net, **settings).run(callback)


def start_optimisation(
    mesh: QuadMesh,
    net: str = "principal",
    *,
    fairness: float | None = None,
    closeness: float | None = None,
    multi: float | None = None,
    multi_patch: tuple[int, int] = (1, 2),
    evenness: float | None = None,
    smooth_motion: float | None = None,
    edge_vectors: float | None = None,
    isometry: float | None = None,
    fix: str | Sequence[int | str] = "none",
    supports: str | Sequence[int | str] = "",
    within: float | None = None,
    repeat: str = "none",
    kinds: int | None = None,
    alike: float | None = None,
    alike_angle: float = ALIKE_DEG,
    tolerance: float = 1e-10,
    max_steps: int = 1000,
    backend: str | None = None,
    options: NetOptions | None = None,
    constraints: Constraints | None = None,
    tuning: Tuning | None = None,
) -> Optimisation:
    """Prepare an optimisation that the caller advances step by step.

    The work is done about a local origin where the mesh is far from the origin.

    Args:
        mesh: the start, in any unit; it is not changed.
        net: name of the net, see ``solver.nets.NETS``.
        fairness: start weight of straight parameter lines, by default that of every net.
        closeness: start weight of staying near the start.
        multi: start weight of orthogonality of neighbouring pairs of faces.
        multi_patch: faces along and across the patches that this guide keeps orthogonal.
        evenness: start weight of lines that bend evenly.
        smooth_motion: start weight of neighbours that move alike.
        edge_vectors: start weight of edges that keep direction and length.
        isometry: start weight of faces keeping their shape, for sheets that only bend; by default
            none.
        fix: ``none``, ``corners``, ``boundary``, vertex numbers or several of it (``boundary,5``);
            these vertices keep every bit.
        supports: of nets that carry loads ``boundary``, which slides along its own curve but for
            its corners, ``corners`` or vertex numbers, which stay; by default what is fixed, and
            where nothing is, what the net needs: the boundary of a stress net.
        within: how far from the design surface, or the start where none is given, the result may
            be, in model units: the report says whether it is.
        repeat: none, panels, edges or nodes, of which few kinds are wanted once the net is reached.
        kinds: how many there may be; None for as few as can be found.
        alike: how far a panel or an edge may be from the shape of its kind, in model units; by
            default a thousandth of the mean edge.
        alike_angle: how far an edge of a node may be turned from that, in degrees.
        tolerance: largest residual that counts as zero, dimensionless.
        max_steps: largest number of steps, over all attempts.
        backend: ``rslab`` or ``scipy``; by default the fastest installed.
        options: choices that only some nets have: diagonal variant, radius, length, reference.
        constraints: handles, gliding, a surface to stay near, symmetry.
        tuning: numbers of the solver other than its own, for experiments.

    Raises:
        InputError: a setting that cannot be used, or an option that the net does not have.
    """
    refuse_other(mesh)
    asked = net_named(net)
    if isinstance(mesh.connectivity, MixedConnectivity) and not asked.any_faces:
        mesh.connectivity.refuse(f"{net} net")
    refuse_no_end(tolerance, max_steps)
    WEIGHTS["within"].check(within, "")
    WEIGHTS["multi_patch"].check(multi_patch)
    if max(multi_patch) < 2:
        raise InputError(
            f"multi patch: expected two counts, one of them 2 or more, got {multi_patch}"
        )
    given = {
        "fairness": fairness,
        "closeness": closeness,
        "multi": multi,
        "evenness": evenness,
        "smooth_motion": smooth_motion,
        "edge_vectors": edge_vectors,
        "isometry": isometry,
    }
    weights = replace(
        Weights(), **{key: value for key, value in given.items() if value is not None}
    )
    tuning = tuning or Tuning()
    if evenness is None and fairness is None and _is_rough(asked, mesh, tuning):
        weights = replace(weights, evenness=tuning.calming)
    wish = _repeated(mesh, repeat, kinds, alike, alike_angle)
    origin = LocalOrigin.of_mesh(mesh)
    mesh = origin.near_mesh(mesh)
    chosen = options or NetOptions()
    refuse_foreign(asked, chosen.given)
    if chosen.reference is not None:
        # It counts by its shape, wherever it lies.
        reference = np.asarray(chosen.reference, dtype=np.float64)
        chosen = replace(chosen, reference=LocalOrigin.of(reference).near(reference))
    wanted = (constraints or Constraints()).about(origin)
    if wish is not None and wanted.handles:
        raise InputError(
            "repeat: nets with handles do not look for few kinds of parts; take the handles away"
        )
    standing = supports_of(mesh, asked, fix, supports)
    wanted, overhangs = _carried(asked, mesh, chosen, wanted)
    if standing.zigzag(mesh, overhangs):
        ground = (
            wanted.close_to
            if wanted.close_to is not None
            else (mesh.vertices, mesh.connectivity.triangles)
        )
        standing, slide = standing.on_surface(mesh, *ground)
        wanted = replace(wanted, glide=(*wanted.glide, slide))
    fixed = standing.fixed.copy()
    held = _held(asked, bool(standing.standing.any()), constraints)
    fixed[corners_that_stay(mesh, wanted)] = True
    wanted = settled(mesh, fixed, wanted)
    wanted = replace(wanted, glide=(*wanted.glide, *standing.glides(mesh, wanted)))
    surface = _surface(asked, mesh, wanted)
    asymptotic = asked.asymptotic(chosen)
    still = fixed | on_curves(mesh, wanted)
    remarks = start_remarks(mesh, net, chosen.diagonal, still, asymptotic)
    if surface is not None and within is not None:
        remarks = (*remarks, *filter(None, [coarse_faces(mesh, surface, within)]))

    # Whoever sets the fairness means it: one attempt with that weight, even from a finished net.
    once = fairness is not None
    plan = Plan(
        asked,
        mesh,
        fixed,
        chosen,
        wanted,
        weights,
        once,
        tuning,
        standing.standing,
        multi_patch,
    )
    _refuse_contradictions(plan.original)
    near = wanted.close_to is None or (surface is not None and _lies_on(mesh, surface))
    stay = not once and not wanted.handles and near
    late = asked.nearest or wanted.close_to is not None
    righted = asked.way.righted and not once
    return Optimisation(
        plan.original,
        plan.way,
        tolerance,
        max_steps,
        backend,
        stay,
        remarks,
        held,
        origin,
        aim=Aim(
            surface, within, asked.nearest, asked.way.early, late, righted and not late, asymptotic
        ),
        repeat=wish,
    )


def _repeated(
    mesh: QuadMesh, repeat: str, kinds: int | None, alike: float | None, alike_angle: float
) -> Repeat | None:
    """What is wanted of few kinds of parts, if anything is.

    Raises:
        InputError: no such parts, or what no net can have.
    """
    if repeat == "none":
        return None
    WEIGHTS["repeat"].check(repeat)
    WEIGHTS["alike"].check(alike, "")
    WEIGHTS["alike_angle"].check(alike_angle)
    lengths = ALIKE * mesh.mean_edge if alike is None else alike
    wish = Repeat(repeat, kinds, alike_angle if repeat == NODES else lengths)
    wish.refuse_impossible(mesh)
    return wish


def refuse_no_end(tolerance: float, max_steps: int) -> None:
    """Refuse what says when a run ends, where it says nothing.

    Raises:
        InputError: a tolerance or a number of steps that is none.
    """
    WEIGHTS["tolerance"].check(tolerance)
    STEPS.check(max_steps)


def _is_rough(asked: Net, mesh: QuadMesh, tuning: Tuning) -> bool:
    """Whether the start has noise that the net would keep."""
    return asked.way.calms and smoothness(mesh) < tuning.rough


def _surface(asked: Net, mesh: QuadMesh, wanted: Constraints) -> TriangleSurface | None:
    """The design surface, about the origin, where the last phase is to come near to one.

    Raises:
        InputError: it lies farther from the mesh than that is large.
    """
    if wanted.ground is None:
        early = asked.way.early or asked.way.righted
        return surface_of(mesh) if asked.nearest or early else None
    surface, points = wanted.ground, mesh.vertices[mesh.connectivity.referenced]
    far = float(np.linalg.norm(points - surface.closest(points)[0], axis=1).mean())
    size = float(np.linalg.norm(np.ptp(points, axis=0)))
    if far > size:
        raise InputError(
            f"close_to: the surface lies {far:.4g} from the mesh on average, which is only "
            f"{size:.4g} large; move one to the other, and mind the unit of both"
        )
    return surface


def _lies_on(mesh: QuadMesh, surface: TriangleSurface) -> bool:
    """Whether a mesh lies on a surface with its faces, as on roofs of flat ones."""
    corners = mesh.vertices[mesh.connectivity.triangles]
    places = np.concatenate([mesh.vertices[mesh.connectivity.referenced], corners.mean(axis=1)])
    feet = surface.closest(places)[0]
    return bool(np.linalg.norm(feet - places, axis=1).max() < _ON * mesh.mean_edge)


def _carried(
    asked: Net, mesh: QuadMesh, chosen: NetOptions, wanted: Constraints
) -> tuple[Constraints, bool]:
    """Have the design surface reach as far as the mesh does; tell whether it had to."""
    if wanted.close_to is not None:
        near = reaching(mesh, *wanted.close_to)
        return replace(wanted, close_to=near), near[0] is not wanted.close_to[0]
    if not asked.stays or wanted.handles:
        return wanted, False
    drawn = surface_of(mesh)
    turned = any(getattr(chosen, name) is not None for name in asked.turning)
    carried = beyond if turned else reaching
    return replace(wanted, close_to=carried(mesh, drawn.vertices, drawn.triangles)), False


def _held(net: Net, fixed: bool, wanted: Constraints | None) -> list[str]:
    """What a user holds, in the words in which it was asked for."""
    words = [net.held] if fixed else []
    return [*words, "gliding vertices"] if wanted is not None and wanted.glide else words


def _refuse_contradictions(problem: Problem) -> None:
    """Say which face, edge or vertex has nothing left to move and yet is not as it has to be."""
    if not problem.fixed.any() or not problem.free.any():
        return
    before: Counter[str] = Counter()
    for term in problem.constraints:
        first = before[term.name]
        before[term.name] += len(term.unknowns)
        stuck = np.flatnonzero(~problem.free[term.unknowns].any(axis=1))
        if not len(stuck):
            continue
        miss = np.abs(term.linearise(problem.start).residual[stuck]).max(axis=1)
        worst = int(np.argmax(miss))
        if miss[worst] > problem.tuning.contradiction:
            place = problem.places[term.name](first + int(stuck[worst]))
            raise InputError(
                f"fix: {place} cannot move at all, but its {term.name} is off by "
                f"{miss[worst]:.1e}; free one of its vertices"
            )
