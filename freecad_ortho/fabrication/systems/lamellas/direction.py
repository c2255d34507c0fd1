"""Which pattern the lamellas of a net can have, and along which directions they stand."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.lamellas.settings import LamellaSettings
from solver.analysis.lines import common_tilt, family_bends, off_tilt, tilt
from solver.analysis.measures import asymptotic, geodesic
from solver.analysis.spheres import cmc, common_radius
from solver.errors import InputError
from solver.mesh.combed import Combed
from solver.mesh.lines import FAMILIES
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.unroll.axes import strip_axes, tilted_axes

# Largest measure of a net, in mean edges, at which it is taken for asymptotic, CMC or geodesic.
IS_NET = 1e-3
# Largest measure with which an exact pattern can still be asked for.
_NEAR_NET = 0.1
# Sine of the angle to the surface below which strips lie rather than tilt.
_LOWEST = 0.2


@dataclass(frozen=True, eq=False)
class StripPattern:
    """What the patterns of a structure are meant to be.

    Attributes:
        kind: "straight", "arc" or "free".
        radius: of the arcs, signed, positive towards the normals; inf for straight ones.
        axes: (V, 3) unit directions that the strips stand along at the vertices.
        tilts: of tilted strips, by family, the angle between surface and strip in radians.
    """

    kind: str
    radius: float
    axes: FloatArray
    tilts: Mapping[str, float] = field(default_factory=dict)


def pattern_of(site: Site, settings: LamellaSettings) -> StripPattern:
    """Find out, or check, what patterns the net of a site allows.

    Raises:
        InputError: the net is too far from what the wanted pattern needs.
    """
    return pattern_on(site.mesh, settings, site.selection.family)


def pattern_on(mesh: QuadMesh, settings: LamellaSettings, family: str = "both") -> StripPattern:
    """Find out, or check, what patterns a net allows.

    Args:
        mesh: the net.
        settings: of the lamellas.
        family: of the lines along which they are made, "u", "v" or "both".

    Raises:
        InputError: the net is too far from what the wanted pattern needs.
    """
    if settings.position == "tilted":
        return _tilted(mesh, settings)
    measured = _measured(mesh, settings.standing, family)
    kind, radius = settings.pattern, math.inf
    if kind == "auto":
        fitting = [name for name in measured if measured[name] <= IS_NET]
        kind = fitting[0] if fitting else "free"
    elif kind != "free":
        net = {"straight": "asymptotic" if settings.standing else "geodesic", "arc": "cmc"}[kind]
        if kind not in measured:
            raise InputError(
                "pattern: lying lamellas unroll straight or free, not to arcs; let them stand"
            )
        if measured[kind] > _NEAR_NET:
            raise InputError(
                f"pattern: {kind} lamellas need a net that is {net}; this one misses it by "
                f"{measured[kind]:.2g} mean edges, at most {_NEAR_NET:g} will do; optimise for "
                f"{net} first or take pattern free"
            )
    if kind == "arc":
        radius = common_radius(mesh)
    axes = strip_axes(mesh, radius if kind != "free" and settings.standing else None)
    return StripPattern(kind, radius, axes)


def _tilted(mesh: QuadMesh, settings: LamellaSettings) -> StripPattern:
    """The pattern of tilted strips: straight, where the net is pseudo-geodesic.

    Raises:
        InputError: lines that run both ways, an arc, or a net that is far from that.
    """
    if not Combed(mesh.connectivity).oriented:
        raise InputError(
            "position: the lines of this net cannot be told apart or run both ways, so that no "
            "side to tilt to is the same for all; take position standing or lying"
        )
    if settings.pattern == "arc":
        raise InputError("pattern: tilted lamellas unroll straight or free, not to arcs")
    miss = float(tilt(mesh).max(initial=0.0)) if len(mesh.connectivity.stars) else math.inf
    if settings.pattern == "straight" and miss > _NEAR_NET:
        raise InputError(
            "pattern: straight tilted lamellas need a net that is pseudo-geodesic; this one misses "
            f"it by {miss:.2g} radians, at most {_NEAR_NET:g} will do; optimise for "
            "pseudo-geodesic first or take pattern free"
        )
    straight = settings.pattern == "straight" or (settings.pattern == "auto" and miss <= IS_NET)
    tilts = {
        name: common_tilt(*family_bends(mesh, family)) if math.isfinite(miss) else math.pi / 2
        for family, name in enumerate(FAMILIES)
    }
    for name, angle in tilts.items():
        if math.sin(angle) < _LOWEST:
            raise InputError(
                f"position: strips along {name} would tilt to {math.degrees(angle):.0f} degrees, "
                "nearly into the surface, where slots cut them through; let them lie in layers 2"
            )
    axes = tilted_axes(mesh, (tilts["u"], tilts["v"]))
    return StripPattern("straight" if straight else "free", math.inf, axes, tilts)


def straight_families(mesh: QuadMesh, standing: bool) -> list[str]:
    """Families whose lines alone are asymptotic, or geodesic where strips lie, as of some webs."""
    combed = Combed(mesh.connectivity)
    if not combed.families or not len(combed.stars):
        return []
    return [name for name in FAMILIES if _miss(mesh, standing, name) <= IS_NET]


def _miss(mesh: QuadMesh, standing: bool, family: str) -> float:
    """Largest part of the turns of a family of lines that bends strips along it, in radians."""
    bends = family_bends(mesh, FAMILIES.index(family))
    return float(off_tilt(*bends, math.pi / 2 if standing else 0.0).max())


def _measured(mesh: QuadMesh, standing: bool, family: str) -> dict[str, float]:
    """Largest measure of the net behind each pattern, best first where several fit."""
    if not len(mesh.connectivity.stars):
        return {"straight": math.inf}
    alone = family in straight_families(mesh, standing)
    whole = asymptotic if standing else geodesic
    straight = _miss(mesh, standing, family) if alone else float(whole(mesh).max())
    return (
        {"straight": straight, "arc": float(cmc(mesh).max())}
        if standing
        else {"straight": straight}
    )
