"""A third layer of lamellas, lying along one family of diagonals on those of both families.

Along geodesic diagonals, as a web has them, they unroll straight and brace the quads. On standing
lamellas each is held by angles, see ``ties``; on two lying layers one bolt passes all three.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.edge_beam.geometry import EdgeGeometry
from freecad_ortho.fabrication.systems.lamellas.axis import Lamella, lamella_on
from freecad_ortho.fabrication.systems.lamellas.crossings import At, at_vertices
from freecad_ortho.fabrication.systems.lamellas.direction import IS_NET, StripPattern
from freecad_ortho.fabrication.systems.lamellas.ends import reaches
from freecad_ortho.fabrication.systems.lamellas.layers import gap_above_edge, gap_between
from freecad_ortho.fabrication.systems.lamellas.settings import DIAGONALS, LamellaSettings
from solver.analysis.lines import bends, off_tilt
from solver.errors import InputError
from solver.mesh.combed import Combed
from solver.mesh.diagonal_lines import diagonal_lines
from solver.mesh.lines import ParameterLine

# Rounds in which the layer is lifted until it is clear of what it lies on.
_ROUNDS = 4


@dataclass(frozen=True, eq=False)
class ThirdLayer:
    """The lamellas along diagonals.

    Attributes:
        settings: theirs, with their level.
        family: of the diagonals, 0 or 1, see ``diagonal_lines``.
        lamellas: one a line.
        below: by each of their vertices, which lamellas of both families they cross there.
    """

    settings: LamellaSettings
    family: int
    lamellas: list[Lamella]
    below: At

    @property
    def crossed(self) -> set[int]:
        """Vertices at which they lie on others."""
        return {vertex for one in self.lamellas for vertex in one.vertices if vertex in self.below}


def third_layer(
    site: Site, settings: LamellaSettings, pattern: StripPattern, grid: Sequence[Lamella]
) -> ThirdLayer:
    """Lay lamellas along one family of diagonals on those of a grid, clear of them.

    Raises:
        InputError: diagonals that cannot be told apart or built, see ``_refuse``.
    """
    _refuse(site, settings)
    family, straight = _chosen(site, settings)
    below = at_vertices(grid)
    lines = [
        line
        for line in diagonal_lines(site.mesh.connectivity, family)
        if any(vertex in below for vertex in line.vertices.tolist())
    ]
    kind = "straight" if straight else "free"
    own = replace(pattern, kind=kind, radius=np.inf)
    level = _least_level(settings)
    lying = replace(settings, position="lying", layers=2, cleats=False, feet="", lifted=level)
    for _ in range(_ROUNDS):
        lamellas = _laid(site, lying, own, lines)
        gap = _least_gap(lamellas, grid, below, lying, settings.standing)
        if gap >= settings.clearance / 2:
            break
        lying = replace(lying, lifted=lying.lifted + settings.clearance - gap)
    return ThirdLayer(lying, family, lamellas, below)


def _refuse(site: Site, settings: LamellaSettings) -> None:
    if site.trimming is not None or site.geometry_of("edge-beam", EdgeGeometry) is not None:
        raise InputError(
            "diagonals: lamellas along them are not cut at a trimmed border or an edge beam; leave "
            "one of both out"
        )
    if settings.pattern == "arc":
        raise InputError("diagonals: they lie, and unroll straight or free, not to arcs")


def _chosen(site: Site, settings: LamellaSettings) -> tuple[int, bool]:
    """Which family of diagonals, and whether its lines are geodesic, so that they unroll straight.

    Raises:
        InputError: families that cannot be told apart, or straight ones asked of lines that bend.
    """
    combed = Combed(site.mesh.connectivity)
    if not combed.families or not len(combed.stars):
        raise InputError(
            "diagonals: the families of this net's lines are exchanged around an inner vertex, or "
            "it has no inner one, so its diagonals cannot be told apart; take diagonals none"
        )
    corners = combed.diagonal_stars
    misses = [
        float(off_tilt(*bends(site.mesh, combed.stars, corners[:, [3 + k, 1 + k]]), 0.0).max())
        for k in (0, 1)
    ]
    wanted = settings.diagonals
    family = int(np.argmin(misses)) if wanted == "auto" else DIAGONALS.index(wanted) - 2
    if settings.pattern == "free":
        return family, False
    return family, misses[family] <= IS_NET


def _least_level(settings: LamellaSettings) -> float:
    """Of the layer's middle above the net, mm."""
    if settings.standing:
        return settings.width / 2 + settings.clearance + settings.thickness / 2
    return 1.5 * (settings.thickness + settings.clearance)


def _laid(
    site: Site, settings: LamellaSettings, pattern: StripPattern, lines: Sequence[ParameterLine]
) -> list[Lamella]:
    beyond = reaches(site.mesh, pattern.axes, lines, settings)
    return [
        lamella_on(site, line, settings, pattern, f"L-D{line.number:03d}", ends)
        for line, ends in zip(lines, beyond, strict=True)
    ]


def _least_gap(
    lamellas: Sequence[Lamella],
    grid: Sequence[Lamella],
    below: At,
    settings: LamellaSettings,
    standing: bool,
) -> float:
    """Least distance of the layer from what it lies on, mm; below 0 where they share space."""
    least = np.inf
    for vertex, here in at_vertices(lamellas).items():
        for index, station in here:
            upper = lamellas[index], station
            for other, there in below.get(vertex, []):
                lower = grid[other], there
                gap = gap_above_edge(upper, lower) if standing else gap_between(upper, lower)
                least = min(least, gap)
    return float(least) if np.isfinite(least) else settings.clearance
