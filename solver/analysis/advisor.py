"""Net advisor: which nets a mesh is near to, and which its shape can carry at all."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from functools import partial
from typing import Any

import numpy as np

from solver.analysis import measures
from solver.analysis.spheres import cmc
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.report import with_article

# A mesh that is less than this from a net on average is that net.
_IS = 1e-10
# A variant of a net that starts this many times closer deserves a warning.
CLOSER = 10.0
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
        own: mean of the measure that tells this net from others.
        possible: whether a mesh of this shape can be near such a net.
        reason: why not, or what will happen to the shape, in one sentence.
    """

    net: str
    diagonal: bool
    distance: float
    own: float
    possible: bool
    reason: str

    @property
    def title(self) -> str:
        """Words of the command line that ask for this net."""
        return f"{self.net} --diagonal" if self.diagonal else self.net


_STAR_NETS: dict[str, Callable[..., FloatArray]] = {
    "geodesic": measures.geodesic,
    "asymptotic": measures.asymptotic,
    "cmc": cmc,
}


def advise(mesh: QuadMesh, known: Mapping[str, FloatArray] | None = None) -> list[Advice]:
    """Compare a mesh with every net and diagonal net, the nearest possible one first.

    ``known`` may hold measures of the mesh by name, so that they are not taken twice.
    """
    taken = dict(known or {})

    def value(name: str, measure: Callable[[QuadMesh], FloatArray]) -> FloatArray:
        return taken[name] if name in taken else measure(mesh)

    orthogonal = float(value("orthogonality", measures.orthogonality).mean())
    flat = float(value("planarity", measures.planarity).mean())
    curved = _curved_shares(mesh)

    def advice(net: str, diagonal: bool, values: FloatArray) -> Advice:
        own = float(values.mean())
        planar = net in ("circular", "conical")
        distance = max(own, flat if planar else orthogonal)
        return Advice(net, diagonal, distance, own, *_possible(net, *curved))

    found = [
        advice("principal", False, value("planarity", measures.planarity)),
        advice("circular", False, value("circular", measures.circular)),
        advice("chebyshev", False, value("chebyshev", measures.chebyshev)),
    ]
    if len(mesh.connectivity.stars):
        found.append(advice("conical", False, value("conical", measures.conical)))
        for net, measure in _STAR_NETS.items():
            found.append(advice(net, False, value(net, partial(measure, diagonal=False))))
            found.append(advice(net, True, measure(mesh, diagonal=True)))
    return sorted(found, key=lambda one: (not one.possible, one.distance, one.own))


def advice_as_dict(mesh: QuadMesh, known: Mapping[str, FloatArray] | None = None) -> dict[str, Any]:
    """Return advice as plain data.

    Returns:
        ``nets`` (one each), ``recommendation`` (one sentence), and ``already``: whether the mesh is
        the recommended net.
    """
    found = advise(mesh, known)
    best = found[0]
    already = best.distance < _IS
    if already:
        recommendation = f"the mesh is {with_article(best.title)} net already"
    else:
        recommendation = (
            f"optimise for {best.title}: the mesh is {best.distance:.1e} from it on average"
            + (f"; {best.reason}" if best.reason else "")
        )
    nets = [asdict(advice) for advice in found]
    return {"nets": nets, "recommendation": recommendation, "already": already}


def closer_variant(mesh: QuadMesh, net: str, diagonal: bool) -> str | None:
    """Return a warning where the other variant of a net starts ten times closer."""
    if net not in _STAR_NETS or not len(mesh.connectivity.stars):
        return None
    asked = float(_STAR_NETS[net](mesh, diagonal=diagonal).mean())
    other = float(_STAR_NETS[net](mesh, diagonal=not diagonal).mean())
    if asked <= CLOSER * other:
        return None
    words = "without --diagonal" if diagonal else "with --diagonal"
    return (
        f"{net}: the start is {asked:.1e} from this net but {other:.1e} from the other variant; "
        f"try {words}"
    )


def _possible(net: str, positive: float, negative: float) -> tuple[bool, str]:
    """Whether a shape with such shares of its vertices curved can be near a net, and why not."""
    if net == "asymptotic" and positive > _MOST:
        return False, (
            f"{100 * positive:.0f} % of the inner vertices lie where the Gauss curvature is "
            "positive, where a surface has no asymptotic lines"
        )
    if net in ("geodesic", "chebyshev") and positive + negative > _MOST:
        return True, "the shape is doubly curved and will be bent towards a developable surface"
    return True, ""


def _curved_shares(mesh: QuadMesh) -> tuple[float, float]:
    """Shares of inner vertices with positive and with negative Gauss curvature."""
    net = mesh.connectivity
    inner = ~net.boundary_vertices & net.referenced
    if not inner.any():
        return 0.0, 0.0
    angles = measures.face_angles(mesh)
    total = np.bincount(net.faces.ravel(), angles.ravel(), minlength=net.vertex_count)
    defect = 2 * np.pi - total[inner]
    return float((defect > _FLAT).mean()), float((defect < -_FLAT).mean())
