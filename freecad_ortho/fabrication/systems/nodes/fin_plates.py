"""Fins on beams that run through, and the cover plates of the others and of splices."""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.systems.beams.fins import FinPlates, fin_cut
from freecad_ortho.fabrication.systems.beams.geometry import Splice
from freecad_ortho.fabrication.systems.nodes.hubs import gaps_after
from freecad_ortho.fabrication.systems.nodes.star_plates import StarMaking
from freecad_ortho.fabrication.systems.nodes.stars import Star
from freecad_ortho.words import counted
from solver.mesh.quadmesh import FloatArray


class FinMaking(StarMaking):
    """Fins one after the other, then the cover plates of splices."""

    kind: ClassVar[str] = "through"
    holds: ClassVar[str] = "webs, fins and splices"
    covers: FinPlates

    def meets(self, star: Star, number: int) -> bool:
        """Whether a beam ends on one that runs through and is wanted too."""
        return self._starred(star) or min(self._beside(star, number)) < np.pi

    def splice_plates(self) -> tuple[Part, ...]:
        """Two cover plates for each splice, and note its bolts."""
        made = []
        for splice in self.beams.splices:
            middle, away = self._splice(splice)
            plates = splice.name
            mark = " ".join(piece.rpartition("-")[2] for piece in splice.pieces)
            for side in ("left", "right"):
                name = f"{plates}-{side}"
                made.append(self.cover(name, splice.edge, middle, side, mark, ()))
            # Lines may run against their edges.
            ahead = 1 if self._forwards(splice) else -1
            for piece, sign in zip(splice.pieces, (-ahead, ahead), strict=True):
                self.bolt_through(splice.edge, middle + away * [sign, 1], plates, piece)
        return tuple(made)

    def more(self) -> dict[str, float]:
        """What the report says of these nodes alone."""
        stars, turned = self._irregular()
        return {
            "splices": len(self.beams.splices),
            "stars": stars,
            "turned": turned,
            "weld_gap_mm": round(self.weld_gap, 3),
        }

    def remarks(self) -> tuple[str, ...]:
        """Where lines end or give way within the net."""
        stars, turned = self._irregular()
        if not stars:
            return ()
        return (
            f"nodes: lines end at {counted(stars, 'vertex', 'vertices')} where stars of plates "
            f"join them; {counted(turned, 'edge')} where lines that run through give way to others",
        )

    def _irregular(self) -> tuple[int, int]:
        """How many vertices have stars, and how many beams run through at one of their ends."""
        joined, running = self.beams.hub_radii > 0, self.covers.running
        turned = running.turned & self.beams.built
        return int((running.stars & joined).sum()), int(turned.sum())

    def _starred(self, star: Star) -> bool:
        """Whether no beam runs through a vertex, so that all are bolted to a star of plates."""
        return bool(self.covers.running.stars[star.vertex])

    def _splice(self, splice: Splice) -> tuple[FloatArray, FloatArray]:
        """The middle of a splice along its beam and up, and its bolts (N, 2) from there."""
        low, high = (float(level[splice.edge]) for level in self.levels)
        middle = np.array([self.beams.lengths[splice.edge] / 2, (low + high) / 2])
        return middle, np.array([[self.covers.back, up] for up in self.covers.heights])

    def _forwards(self, splice: Splice) -> bool:
        """Whether the line of a splice runs along its edge."""
        [line] = [
            line
            for line in self.site.lines.all
            if line.family == self.families[splice.edge] and line.number == self.lines[splice.edge]
        ]
        place = int(np.flatnonzero(line.edges == splice.edge)[0])
        first = self.site.mesh.connectivity.edges[splice.edge, 0]
        return bool(line.vertices[place] == first)

    def _beside(self, star: Star, number: int) -> tuple[float, float]:
        """Angles from a beam to those that run through on its left and right; pi for none."""
        gaps = gaps_after(star.turn)
        left, right = float(gaps[number]), float(gaps[number - 1])
        after = int(star.half_edges[(number + 1) % len(gaps)])
        before = int(star.half_edges[number - 1])
        runs = self.covers.running.half_edges
        return (left if runs[after] else np.pi), (right if runs[before] else np.pi)

    def _start(self, star: Star, number: int, place: tuple[int, int]) -> tuple[float, float, float]:
        if self._starred(star):
            return super()._start(star, number, place)
        edge, end = place
        half, slant = self.covers.web / 2, np.hypot(1.0, float(self.beams.slopes[edge, end]))
        left, right = self._beside(star, number)
        middle, slope = fin_cut(half, left, right)
        for side, angle, sign in ((half, left, 1.0), (-half, right, -1.0)):
            if angle < np.pi:
                begins = (half + side * sign * np.cos(angle)) / np.sin(angle)
                self.weld_gap = max(self.weld_gap, float(middle + slope * side - begins))
        # The right of a beam is the left of its fin at the other end.
        over = -half * slope if end == 0 else half * slope
        return slant * middle, slant * (middle + over), slant * (middle - over)

    def _doubts(self, star: Star, arm: int, beam: str) -> list[str]:
        """What keeps the bolts of a beam from being put in and tightened."""
        if self._starred(star):
            return super()._doubts(star, arm, beam)
        left, right = self._beside(star, arm)
        needed = float(self.covers.needed(np.array([left]), np.array([right]))[0])
        radius = float(self.beams.hub_radii[star.vertex])
        if radius >= needed - 1e-9:
            return []
        return [
            f"the bolts of beam {beam} cannot be put in and tightened beside the beam that runs "
            f"through: fins {needed:.0f} mm long leave room for {self.covers.bolt.name}, these "
            f"have {radius:g} mm"
        ]
