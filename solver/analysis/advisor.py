"""Net advisor: which nets a mesh is near to, and which its shape can carry at all."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

from solver.analysis.curvature import angle_defects, inner_vertices
from solver.analysis.start import bent_lines, twisted_lines
from solver.mesh.local_origin import LocalOrigin, resolution
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.nets import NETS, Measure, Net
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
        net: name of the net.
        diagonal: whether the star property is asked of the diagonal net.
        distance: mean of the net's measures, the largest of its parts, dimensionless.
        beyond: the same without right angles of the edges, which nearly every net asks for:
            what tells this net from others.
        possible: whether a mesh of this shape can be near such a net.
        cause: one word for the reason, empty where there is none: ``bulges``, ``bends``,
            ``bent``, ``bulging``, ``diagonal`` or ``oblique``.
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
    not, and those of which others are special cases at the end.

    Args:
        mesh: the mesh.
        known: measures of it by name, so that they are not taken twice.
        coarse: how far apart its coordinates could lie, in mean edges, where it came from: a net
            whose coordinates are rounded to that is still that net. By default as it lies.
    """
    zero = _zero(mesh, coarse)
    mesh = LocalOrigin.of_mesh(mesh).near_mesh(mesh)
    shape = _Shape(mesh, known or {})
    found = [
        shape.advice(net, diagonal)
        for net in NETS.values()
        if net.any_faces or not mesh.connectivity.mixed
        for diagonal in net.variants
        if shape.tells(net, diagonal)
    ]
    return sorted(found, key=lambda one: _order(one, zero))


class _Shape:
    """What is to be known of a mesh to compare it with nets."""

    def __init__(self, mesh: QuadMesh, known: Mapping[str, FloatArray]) -> None:
        self._mesh = mesh
        self._known = known
        self._means: dict[tuple[str, bool], float] = {}
        self._positive, self._negative, self._twisted = 0.0, 0.0, None
        if not mesh.connectivity.mixed:
            self._positive, self._negative = _curved_shares(mesh)
            self._twisted = twisted_lines(mesh)

    def tells(self, net: Net, diagonal: bool) -> bool:
        """Whether the mesh alone says how far it is from a net."""
        needed = any(measure.place_of(diagonal) == "vertex" for measure in net.measures)
        return bool(net.measures) and (not needed or bool(len(self._mesh.connectivity.stars)))

    def advice(self, net: Net, diagonal: bool) -> Advice:
        """How the mesh relates to a net."""
        means = {
            measure: self._mean(measure, diagonal and bool(measure.across))
            for measure in net.measures
        }
        distance = max(means.values())
        # Right angles across the diagonals are nothing that other nets ask for.
        own = [mean for measure, mean in means.items() if diagonal or not measure.square]
        doubt = self._doubt(net, diagonal)
        return Advice(net.name, diagonal, distance, max(own, default=distance), *doubt)

    def _mean(self, measure: Measure, diagonal: bool) -> float:
        key = measure.name, diagonal
        if key not in self._means:
            values = None if diagonal else self._known.get(measure.name)
            values = measure.on(self._mesh, diagonal) if values is None else values
            counted = values[~measure.left_out(self._mesh, diagonal)]
            self._means[key] = float(counted.mean()) if len(counted) else 0.0
        return self._means[key]

    def _doubt(self, net: Net, diagonal: bool) -> tuple[bool, str, str]:
        """Whether the mesh can be near a net, and the cause and reason where it may not."""
        if net.shape in ("minimal", "saddle") and self._positive > _MOST:
            return False, "bulges", _bulges(self._positive)
        bent = bent_lines(self._mesh, diagonal) if net.shape == "saddle" else None
        if bent is not None:
            return False, bent.cause, str(bent)
        if net.shape == "developable" and self._positive + self._negative > _MOST:
            return True, "bends", _BENDS
        if net.along_curvature and self._twisted is not None:
            return False, self._twisted.cause, str(self._twisted)
        return True, "", ""


def _zero(mesh: QuadMesh, coarse: float | None) -> float:
    """A mesh that is less than this from a net on average is that net."""
    return max(_IS, resolution(mesh) if coarse is None else coarse)


def _order(advice: Advice, zero: float) -> tuple[bool, bool, bool, bool, bool, float, float]:
    there, doubtful = advice.distance < zero, bool(advice.cause)
    net = NETS[advice.net]
    last = net.general and not (there and net.telling)
    # Of nets that it is, what is left is rounding.
    how_far = (0.0, 0.0) if last and there else (advice.beyond, advice.distance)
    return last, not there, not advice.possible, doubtful, net.general, *how_far


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
