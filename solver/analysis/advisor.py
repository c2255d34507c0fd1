"""Net advisor: which nets a mesh is near to, and which its shape can carry at all."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from functools import partial
from typing import Any

from solver.analysis import measures
from solver.analysis.curvature import angle_defects, inner_vertices
from solver.analysis.start import CURVATURE_LINES, STAR_NETS, twisted_lines
from solver.mesh.local_origin import LocalOrigin, resolution
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.report import with_article

# A mesh that is less than this from a net on average is that net.
_IS = 1e-10
# Angle defects below this, in radians, count as flat.
_FLAT = 1e-4
# Share of curved vertices on the wrong side that rules a net out.
_MOST = 0.5


@dataclass(frozen=True)
class Advice:
    """How a mesh relates to one net.

    Attributes:
        net: name of the recipe.
        diagonal: whether the star property is asked of the diagonal net.
        distance: mean of the net's measures, the largest of its parts, dimensionless.
        beyond: the same without orthogonality, which nearly every net asks for: what tells this
            net from others.
        possible: whether a mesh of this shape can be near such a net.
        cause: one word for the reason, empty where there is none: ``bulges``, ``bends``,
            ``diagonal`` or ``oblique``.
        reason: why not, or what will happen to the shape, in one sentence.
    """

    net: str
    diagonal: bool
    distance: float
    beyond: float
    possible: bool
    cause: str
    reason: str

    @property
    def title(self) -> str:
        """Words of the command line that ask for this net."""
        return f"{self.net} --diagonal" if self.diagonal else self.net


def advise(
    mesh: QuadMesh, known: Mapping[str, FloatArray] | None = None, coarse: float | None = None
) -> list[Advice]:
    """Compare a mesh with every net and diagonal net, the nearest possible one first.

    Nets that it is already come before all others, those that would bend it after those that would
    not.

    Args:
        mesh: the mesh.
        known: measures of it by name, so that they are not taken twice.
        coarse: how far apart its coordinates could lie, in mean edges, where it came from: a net
            whose coordinates are rounded to that is still that net. By default as it lies.
    """
    zero = _zero(mesh, coarse)
    mesh = LocalOrigin.of_mesh(mesh).near_mesh(mesh)
    taken = dict(known or {})

    def value(name: str, measure: Callable[[QuadMesh], FloatArray]) -> FloatArray:
        return taken[name] if name in taken else measure(mesh)

    orthogonal = float(value("orthogonality", measures.orthogonality).mean())
    flat = float(value("planarity", measures.planarity).mean())
    positive, negative = _curved_shares(mesh)
    twisted = twisted_lines(mesh)

    def advice(net: str, diagonal: bool, values: FloatArray) -> Advice:
        planar = net in ("circular", "conical")
        beyond = max(float(values.mean()), flat if planar else 0.0)
        distance = beyond if planar else max(beyond, orthogonal)
        possible, cause, reason = True, "", ""
        if net == "asymptotic" and positive > _MOST:
            possible, cause, reason = False, "bulges", _bulges(positive)
        elif net in ("geodesic", "chebyshev") and positive + negative > _MOST:
            cause, reason = "bends", _BENDS
        elif net in CURVATURE_LINES and twisted is not None:
            possible, cause, reason = False, twisted.cause, str(twisted)
        return Advice(net, diagonal, distance, beyond, possible, cause, reason)

    found = [
        advice("principal", False, value("planarity", measures.planarity)),
        advice("circular", False, value("circular", measures.circular)),
        advice("chebyshev", False, value("chebyshev", measures.chebyshev)),
    ]
    if len(mesh.connectivity.stars):
        found.append(advice("conical", False, value("conical", measures.conical)))
        for net, measure in STAR_NETS.items():
            found.append(advice(net, False, value(net, partial(measure, diagonal=False))))
            found.append(advice(net, True, measure(mesh, diagonal=True)))
    return sorted(found, key=lambda one: _order(one, zero))


def _zero(mesh: QuadMesh, coarse: float | None) -> float:
    """A mesh that is less than this from a net on average is that net."""
    return max(_IS, resolution(mesh) if coarse is None else coarse)


def _order(advice: Advice, zero: float) -> tuple[bool, bool, bool, float, float]:
    there = advice.distance < zero
    return not there, not advice.possible, bool(advice.cause), advice.beyond, advice.distance


def advice_as_dict(
    mesh: QuadMesh, known: Mapping[str, FloatArray] | None = None, coarse: float | None = None
) -> dict[str, Any]:
    """Return advice as plain data.

    Args:
        mesh: the mesh.
        known: measures of it by name, as for :func:`advise`.
        coarse: distance of its coordinates, as there.

    Returns:
        ``nets`` (one each), ``recommendation`` (one sentence), and ``already``: whether the mesh is
        the recommended net.
    """
    found = advise(mesh, known, coarse)
    best = found[0]
    already = best.distance < _zero(mesh, coarse)
    if already:
        recommendation = f"the mesh is {with_article(best.title)} net already"
    else:
        recommendation = (
            f"optimise for {best.title}: the mesh is {best.distance:.1e} from it on average"
            + (f"; {best.reason}" if best.reason else "")
        )
    nets = [asdict(advice) for advice in found]
    return {"nets": nets, "recommendation": recommendation, "already": already}


_BENDS = "the shape is doubly curved and will be bent towards a developable surface"


def _bulges(share: float) -> str:
    return (
        f"{100 * share:.0f} % of the inner vertices lie where the Gauss curvature is positive, "
        "where a surface has no asymptotic lines"
    )


def _curved_shares(mesh: QuadMesh) -> tuple[float, float]:
    """Shares of inner vertices with positive and with negative Gauss curvature."""
    defect = angle_defects(mesh)[inner_vertices(mesh)]
    if not len(defect):
        return 0.0, 0.0
    return float((defect > _FLAT).mean()), float((defect < -_FLAT).mean())
