"""From parameter lines to ribbons: which rulings, which ends."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.sizes import rounded_down
from freecad_ortho.fabrication.systems.lamellas.bolts import least_edge
from freecad_ortho.fabrication.systems.lamellas.direction import StripPattern
from freecad_ortho.fabrication.systems.lamellas.ends import lengthened
from freecad_ortho.fabrication.systems.lamellas.ribbon import Ribbon
from freecad_ortho.fabrication.systems.lamellas.settings import LamellaSettings
from solver.errors import InputError
from solver.mesh.connectivity import IntArray
from solver.mesh.lines import ParameterLine
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows
from solver.unroll.axes import arc_turns
from solver.unroll.measures import (
    StripMeasures,
    fitted_circle,
    straightness,
    strip_measures,
)
from solver.unroll.nearest_turns import nearest_turns
from solver.unroll.planes import developable_strip
from solver.unroll.strip import Strip
from solver.unroll.twisted import twisted_strip

# Degrees that a lamella may lean for its pattern before one along the normals is looked at, and the
# most that it may lean at all.
_LEAN, _LEAN_OVER = 10.0, 45.0
# Share of the former that rulings use where a pattern is only nearly what it should be: the plate
# leans more between them.
_SPARE_LEAN = 0.8
# Share of the length up to which a pattern along the normals is preferred to one that leans: edges
# that are straight but for their last digits say nothing about how a strip should stand.
NEARLY = 1e-4
# Share of the length up to which a pattern counts as exact.
_EXACT = 1e-6
# Where rulings close in on each other the strip bends sharply: left to choose, it is made of plane
# faces only if its rulings would meet no nearer than at this many times its width.
_ROOM = 2.0
# ... and if its rulings stand at more than 30 degrees to the axis, or they would run into slots.
_SLANT = 0.5


@dataclass(frozen=True, eq=False)
class Lamella:
    """A lamella before it is cut.

    Attributes:
        name: part name.
        family: "u", "v" or "".
        line: number in its family.
        vertices: of the line; ``stations`` has where the ribbon has them.
        stations: (N,) station of each vertex.
        ribbon: with overhangs; of a closed line from the start of the edge on which it is cut to
            the end of that edge.
        measures: of the strip between the line's ends.
        pattern: "straight", "arc" or "free": what its own pattern is.
        aim: what the patterns of the structure are.
        twisted: true where its faces may twist.
        closed: true where the first face of the ribbon is the last one too, to be cut there.
        bolts: of spliced ends and cleats: a face of the ribbon and (N, 2) places in the pattern.
        legs: where legs of cleats end on it: the number of the face, and the share of its length.
    """

    name: str
    family: str
    line: int
    vertices: tuple[int, ...]
    stations: tuple[int, ...]
    ribbon: Ribbon
    measures: StripMeasures
    pattern: str
    aim: str
    twisted: bool
    closed: bool
    bolts: tuple[tuple[int, FloatArray], ...] = ()
    legs: tuple[float, ...] = ()

    @property
    def exact(self) -> bool:
        """Whether its pattern is what those of the structure are meant to be."""
        straight = self.aim == "straight"
        miss = self.measures.straightness if straight else self.measures.radius_spread
        return self.pattern == self.aim and miss <= NEARLY * self.measures.length


def lamella_on(
    site: Site,
    line: ParameterLine,
    settings: LamellaSettings,
    pattern: StripPattern,
    name: str,
    beyond: tuple[float, float],
) -> Lamella:
    """Make the ribbon of one parameter line, ``beyond`` its ends by these lengths in mm.

    Raises:
        InputError: its rulings meet inside the width, or its edges have no length.
    """
    vertices = _from_cut(site.mesh, line, settings) if line.closed else line.vertices
    points, directions = site.mesh.vertices[vertices], pattern.axes[vertices]
    if not settings.standing:
        points = points + settings.level_of(line.family) * directions
    path, upright = points, directions
    if line.closed:
        path = np.concatenate([points[-1:], points, points[:1]])
        upright = np.concatenate([directions[-1:], directions, directions[:1]])
    if not settings.standing:
        upright = _lateral(path, upright)
    inner = slice(1, -1) if line.closed else slice(None)
    maker = _Maker(path, upright, inner, settings, site.material.least_radius(settings.thickness))
    kind = pattern.kind
    made = None
    if kind != "free":
        turns = _turns(points, pattern.radius, line.closed)
        on_boundary = bool(site.mesh.connectivity.boundary_edges[line.edges].any())
        made = maker.exact(turns, name, vertices, on_boundary, kind)
        if made is not None and on_boundary and _miss(made, kind) > _EXACT:
            kind = "free"
    if made is None:
        made, kind = maker.made(None, name, vertices), "free"
    strip, twisted, measures = made
    lower, upper = settings.levels(line.family)
    stations = np.arange(len(vertices)) + 1
    if not line.closed:
        strip = lengthened(strip, beyond, name)
        stations = stations if beyond[0] > 0 else stations - 1
    ribbon = Ribbon(strip, lower, upper, settings.thickness)
    return Lamella(
        name,
        line.family,
        line.number,
        tuple(vertices.tolist()),
        tuple(stations.tolist()),
        ribbon,
        measures,
        kind,
        pattern.kind,
        twisted,
        line.closed,
    )


def _from_cut(mesh: QuadMesh, line: ParameterLine, settings: LamellaSettings) -> IntArray:
    """Vertices of a closed line, from the end of the edge on which it is cut to its start.

    Neighbouring lines are cut on opposite sides, on an edge that takes a splice where there is one.
    """
    points = mesh.vertices[line.vertices]
    lengths = np.linalg.norm(np.roll(points, -1, axis=0) - points, axis=1)
    count = len(lengths)
    wanted = count // 2 - 1 if line.number % 2 else count - 1
    away = np.abs(np.arange(count) - wanted)
    away = np.minimum(away, count - away) + np.where(lengths < least_edge(settings), count, 0)
    return np.roll(line.vertices, -int(away.argmin()) - 1)


Made = tuple[Strip, bool, StripMeasures]


@dataclass(frozen=True, eq=False)
class _Maker:
    """Makes the strip of one line.

    Attributes:
        points: (K, 3) of the axis.
        upright: (K, 3) unit directions that the strip shall contain.
        inner: those points that are vertices of the net.
        settings: what is wanted.
        least_radius: to which the material bends, mm.
    """

    points: FloatArray
    upright: FloatArray
    inner: slice
    settings: LamellaSettings
    least_radius: float

    def exact(
        self, turns: FloatArray, name: str, vertices: IntArray, on_boundary: bool, kind: str
    ) -> Made | None:
        """Strip, whether it may twist, and measures; None where the line must go without.

        At the boundary the net asks nothing of a line: there, where its pattern could only be
        exact with a strip that leans far over, it is as near as a strip that leans little can make
        it, or left free. So is one elsewhere that would lie where it should stand, if the pattern
        was left to choose.

        Raises:
            InputError: no strip has the pattern that was asked for, or only one that leans over.
        """
        try:
            made = self.made(turns, name, vertices)
        except InputError:
            if on_boundary:
                return None
            raise
        lean = made[2].lean_deg
        if lean <= _LEAN and (not on_boundary or _miss(made, kind) <= _EXACT):
            return made
        upright = self._upright(name, vertices)
        if upright is not None and _miss(upright, kind) <= NEARLY:
            return upright
        if on_boundary:
            closed = len(turns) > len(self.points) - 2
            return None if closed else self._nearest(turns, name, vertices)
        if lean > _LEAN_OVER and self.settings.pattern != "auto":
            raise InputError(
                f"pattern: {name} would lean {lean:.0f} degrees from the normals to unroll "
                f"{'straight' if kind == 'straight' else 'to an arc'}; optimise the net first or "
                "take pattern free"
            )
        return None if lean > _LEAN_OVER else made

    def _nearest(self, turns: FloatArray, name: str, vertices: IntArray) -> Made | None:
        """The strip whose pattern comes nearest to the wanted one without leaning too far."""
        nearest = nearest_turns(self.points, self.upright, turns, math.radians(_SPARE_LEAN * _LEAN))
        try:
            made = self.made(nearest, name, vertices)
        except InputError:
            return None
        return made if made[2].lean_deg <= _LEAN else None

    def _upright(self, name: str, vertices: IntArray) -> Made | None:
        """The strip along the normals, None where plane faces are wanted and cannot make it."""
        try:
            return self.made(None, name, vertices)
        except InputError:
            return None

    def made(self, turns: FloatArray | None, name: str, vertices: IntArray) -> Made:
        """Strip, whether it may twist, and measures; developable where that is wanted or fits.

        Raises:
            InputError: a developable strip is wanted and its rulings meet inside the width.
        """
        if self.settings.strip != "twisted" and not self.settings.smooth:
            try:
                strip = developable_strip(
                    self.points, self.upright, turns, width=self.settings.reach
                )
            except InputError as error:
                if self.settings.strip == "developable":
                    raise InputError(f"lamellas: {name}: {error}; take strip twisted") from error
            else:
                measures = self._measure(strip)
                if self.settings.strip == "developable":
                    self._refuse_meeting(strip, name, vertices)
                    return strip, False, measures
                if self._fits(strip, measures):
                    return strip, False, measures
        follow = self.settings.position == "tilted"
        strip = twisted_strip(self.points, self.upright, turns, follow=follow)
        return strip, True, self._measure(strip)

    def _fits(self, strip: Strip, measures: StripMeasures) -> bool:
        """Whether plane faces make a strip that a workshop can make.

        A single plane would lean at both its ends, into those that are cut back beside it.
        """
        return bool(
            len(self.points) > 2
            and measures.admissible_width >= _ROOM * self.settings.reach
            and measures.smallest_bend_radius >= self.least_radius
            and np.sin(strip.slant).min() >= _SLANT
            and measures.lean_deg <= _LEAN
        )

    def _refuse_meeting(self, strip: Strip, name: str, vertices: IntArray) -> None:
        allowed, edge = strip.admissible_width()
        if allowed <= self.settings.reach:
            near = vertices[min(edge, len(vertices) - 1)]
            width = self.settings.width * allowed / self.settings.reach
            raise InputError(
                f"lamellas: the rulings of {name} meet {allowed / 2:.3g} mm from its axis, near "
                f"vertex {near}; a width below {rounded_down(width)} mm would do, or take strip "
                "twisted"
            )

    def _measure(self, strip: Strip) -> StripMeasures:
        """Measures of a strip; straightness and radius at the vertices of the net only."""
        found = strip_measures(strip, self.settings.width, self.upright)
        points = strip.flat_points[self.inner]
        radius, spread = fitted_circle(points)
        return replace(
            found, straightness=straightness(points), radius=radius, radius_spread=spread
        )


def _miss(made: Made, kind: str) -> float:
    """How far a strip's pattern is from straight or an arc, as a share of its length."""
    measures = made[2]
    miss = measures.straightness if kind == "straight" else measures.radius_spread
    return miss / measures.length


def _turns(points: FloatArray, radius: float, closed: bool) -> FloatArray:
    if not closed:
        return arc_turns(points, radius)
    turns = arc_turns(np.concatenate([points, points[:1]]), radius, closed=True)
    return np.roll(turns, 1)


def _lateral(points: FloatArray, normals: FloatArray) -> FloatArray:
    """(K, 3) directions square to the axis in the surface, on its left."""
    along = unit_rows(np.diff(points, axis=0))
    mean = np.concatenate([along[:1], unit_rows(along[:-1] + along[1:]), along[-1:]])
    return unit_rows(np.cross(normals, mean))
