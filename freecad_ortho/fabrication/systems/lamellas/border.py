"""Lamellas at the border of a surface: what is left of their lines, and where they end.

Beside an edge beam they end before it, square, so far back that their corners keep the clearance.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.beams.border import BorderEnds
from freecad_ortho.fabrication.systems.beams.frames import beam_frames
from freecad_ortho.fabrication.systems.beams.lines import line_runs
from freecad_ortho.fabrication.systems.edge_beam.geometry import EdgeGeometry
from freecad_ortho.fabrication.systems.lamellas.axis import Lamella
from freecad_ortho.fabrication.systems.lamellas.settings import LamellaSettings
from freecad_ortho.fabrication.systems.lamellas.splices import (
    Joint,
    piece_between,
    square_end,
)
from solver.mesh.lines import ParameterLine
from solver.mesh.quadmesh import FloatArray, unit_rows

# A crossing is at least so many thicknesses before the end of a lamella, and this far, mm.
_THICKNESSES, _BEYOND = 3.0, 5.0
# Part of its last edge that a lamella takes up at most.
_MOST = 0.95
_SHOWN = 5
# Places of a section at which it is seen how near it comes, as parts of its half.
_CORNERS = np.linspace(-1.0, 1.0, 5)
# A border that runs along a lamella cuts it no more slanted than this, mm along per mm across.
_STEEPEST = 2.0


@dataclass(frozen=True, eq=False)
class LamellaSpan:
    """A part of a line on which a lamella is built.

    Attributes:
        line: from the last vertex before the border to the first one after it, or to its own end.
        suffix: of the lamella's name.
        cut: whether its first and last edge end at the border.
        short: whether it ends there before a vertex that lies too near to an edge beam.
    """

    line: ParameterLine
    suffix: str
    cut: tuple[bool, bool]
    short: tuple[bool, bool] = (False, False)


class LamellaBorder:
    """The border, as lamellas see it."""

    def __init__(self, site: Site, settings: LamellaSettings) -> None:
        self._site = site
        self._settings = settings
        frames = beam_frames(site.mesh, site.axes)
        self._edge_beam = site.geometry_of("edge-beam", EdgeGeometry)
        self._ends = BorderEnds.at_border(site, frames)
        if self._edge_beam is not None:
            half, level = settings.across / 2, settings.high / 2
            self._ends = BorderEnds.of(site, frames, (-level, level), half) or self._ends
        self._edges = site.mesh.connectivity.edges
        self.left_out: list[str] = []
        self.trimmed = 0
        self.over = 0.0

    @property
    def _least(self) -> float:
        """How far a lamella goes on beyond a crossing at least, mm."""
        return _THICKNESSES * self._settings.thickness + _BEYOND

    def runs(self, lines: Sequence[ParameterLine]) -> list[LamellaSpan]:
        """What is left of lines; pieces without a vertex within the border are left out."""
        found = []
        for line in lines:
            runs = line_runs(line, self._ends.within, self._ends.cut, self._edges)
            for number, run in enumerate(runs):
                ends = [(int(run.edges[k]), int(run.vertices[k])) for k in (0, -1)]
                cut = [not run.closed and self._cuts(edge, vertex) for edge, vertex in ends]
                suffix = chr(ord("a") + number) if number else ""
                whole = self._shortened(LamellaSpan(run, suffix, (cut[0], cut[1])))
                if len(whole.line.edges) < 2 and any(cut):
                    self.left_out.append(f"{line.family.upper()}{line.number:03d}{suffix}")
                else:
                    found.append(whole)
        return found

    def _shortened(self, run: LamellaSpan) -> LamellaSpan:
        """Without vertices so near to an edge beam that nothing can cross there."""
        if self._edge_beam is None or len(run.line.edges) < 2:
            return run
        short = [run.cut[end] and self._room(run, end) < self._least for end in (0, 1)]
        if sum(short) >= len(run.line.edges):
            return run
        some = slice(int(short[0]), -1 if short[1] else None)
        line = replace(
            run.line, vertices=run.line.vertices[some], edges=run.line.edges[some], closed=False
        )
        return replace(run, line=line, short=(short[0], short[1])) if any(short) else run

    def _room(self, run: LamellaSpan, end: int) -> float:
        """From the last vertex within to the border or the edge beam before it, mm."""
        edge, side = self._end(run, end)
        place = float(self._ends.places[edge, side])
        length = float(self._site.mesh.edge_lengths[edge])
        return (place if side else 1.0 - place) * length - self._slanted(edge, side)

    def _end(self, run: LamellaSpan, end: int) -> tuple[int, int]:
        """The last edge of a run, and which of its ends lies outwards."""
        edge, vertex = int(run.line.edges[-end]), int(run.line.vertices[-end])
        return edge, int(self._edges[edge, 1] == vertex)

    def _slanted(self, edge: int, side: int) -> float:
        """What of its length a lamella loses that ends square, mm."""
        slanted = self._settings.across / 2 * abs(float(self._ends.slant[edge, side]))
        if self._edge_beam is None:
            return slanted
        return slanted + self._settings.high / 2 * abs(float(self._ends.lean[edge, side]))

    def _cuts(self, edge: int, vertex: int) -> bool:
        return bool(self._ends.cut[edge, int(self._edges[edge, 1] == vertex)])

    def trim(self, lamella: Lamella, run: LamellaSpan, settings: LamellaSettings) -> Lamella:
        """The lamella on a run, cut where it comes to the border."""
        if not any(run.cut):
            return lamella
        self.trimmed += 1
        joints = [
            self._joint(lamella, run, end, settings) if run.cut[end] else None for end in (0, 1)
        ]
        return piece_between(lamella, joints[0], joints[1], "", settings)

    def _joint(
        self, lamella: Lamella, run: LamellaSpan, end: int, settings: LamellaSettings
    ) -> Joint | None:
        """Where an end of a lamella is cut, its whole section within the border; None nowhere."""
        edge, side = self._end(run, end)
        length = float(self._site.mesh.edge_lengths[edge])
        place = float(self._ends.places[edge, side])
        share = place if side else 1.0 - place
        least = self._least
        beyond = min(max(self._room(run, end), least), _MOST * length)
        face = lamella.stations[-2] if end else lamella.stations[0]
        if run.short[end]:
            beyond = _MOST * length - least
        elif self._edge_beam is not None:
            before = self._before(lamella, face, end)
            beyond = max(before, settings.thickness) if before < length else beyond
        else:
            self.over = max(self.over, beyond - share * length)
        left = float(lamella.ribbon.strip.lengths[face]) - beyond
        # Beside others at an irregular vertex it may end before the border.
        if left <= 0:
            return None
        joint = Joint(face, beyond if end else left, False)
        if settings.border_cut == "square" or self._edge_beam is not None:
            return joint
        # Of the way to the border only what the plate's thickness takes.
        slanted = settings.thickness / 2 * abs(float(self._square_to(edge, side, settings)))
        wanted = share * length - slanted
        left = float(lamella.ribbon.strip.lengths[face]) - wanted
        along = replace(joint, place=wanted if end else left)
        ruling, skew = self._ruling(lamella, along, edge, side)
        fits = skew <= _STEEPEST and wanted - settings.width / 2 * skew >= least
        if not fits or not 0 < along.place < lamella.ribbon.strip.lengths[face]:
            return joint
        return replace(along, ruling=ruling)

    def _before(self, lamella: Lamella, face: int, end: int) -> float:
        """How far beyond its last vertex the corners of a lamella come to an edge beam, mm."""
        assert self._edge_beam is not None
        ribbon, strip = lamella.ribbon, lamella.ribbon.strip
        up = strip.across[0][face]
        beside = np.cross(strip.along[face], up)
        ahead = strip.along[face] if end else -strip.along[face]
        levels, sides = (part.ravel() for part in np.meshgrid(_CORNERS, _CORNERS))
        levels = ribbon.lower + (ribbon.upper - ribbon.lower) * (1 + levels) / 2
        sides = self._settings.thickness / 2 * sides
        start = strip.points[face if end else face + 1]
        corners = start + levels[:, None] * up + sides[:, None] * beside
        nearest = np.inf
        for _, _, low, high in self._edge_beam.blocked(corners[None], ahead[None]):
            met = (low < high) & (high > 0)
            nearest = min(nearest, float(low[met].min(initial=np.inf)))
        # A piece between joints keeps half of its own clearance from them.
        return nearest + self._settings.clearance / 2

    def _square_to(self, edge: int, side: int, settings: LamellaSettings) -> float:
        """How far the border moves along an edge per mm of the plate's thickness."""
        both = self._ends.slant if settings.standing else self._ends.lean
        return float(both[edge, side])

    def _ruling(
        self, lamella: Lamella, joint: Joint, edge: int, side: int
    ) -> tuple[FloatArray, float]:
        """Direction (3,) in which the border cuts a strip, and how far it leaves the square cut.

        The border is the surface that the axes along it span; mm along the strip per mm across it.
        """
        site = self._site
        place = float(self._ends.places[edge, side])
        ends = site.axes.offsets[self._edges[edge]]
        axis = (1 - place) * ends[0] + place * ends[1]
        strip = lamella.ribbon.strip
        _, square = square_end(strip, joint)
        ahead = strip.along[joint.face]
        tangent = None if site.trimming is None else site.trimming.along(edge, place)
        if tangent is None:
            return square, np.inf
        normal = np.cross(tangent, axis)
        skew = float(square @ normal) / float(ahead @ normal)
        return unit_rows((square - skew * ahead)[None])[0], abs(skew)

    def words(self) -> list[str]:
        """What is to be said."""
        said = []
        if self.left_out:
            shown = ", ".join(self.left_out[:_SHOWN])
            shown += " ..." if len(self.left_out) > _SHOWN else ""
            said.append(
                f"lamellas: left out at the border what crosses no other: {shown}, "
                f"{len(self.left_out)} in all"
            )
        if self.over > 0:
            said.append(
                f"lamellas: some end up to {self.over:.3g} mm over the border, as they cross "
                "others right before it"
            )
        return said
