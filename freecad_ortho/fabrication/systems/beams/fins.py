"""Fins welded to beams that run through, to whose webs the others are bolted by cover plates.

Beams of one family run through and are spliced between nodes; each of the other family ends before
a fin, a plate in its own plane that stands on the side of the beam that runs through. The same
cover plates join webs and fins, and splices.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from freecad_ortho.fabrication.systems.beams.cover_plates import CoverPlates
from freecad_ortho.fabrication.systems.beams.frames import Around
from freecad_ortho.fabrication.systems.beams.running import Running
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.lines import ParameterLines
from solver.mesh.quadmesh import FloatArray

# Radii are multiples of this, mm.
_STEP = 5.0
# Room for a weld between a beam that runs through and the cover plates, mm.
_WELD = 10.0


@dataclass(frozen=True)
class FinPlates(CoverPlates):
    """Sizes of fins and of all cover plates of a structure.

    Args:
        running: what runs through where.
    """

    running: Running = field(kw_only=True, compare=False)

    @property
    def splice_room(self) -> float:
        """Length of an edge in whose middle a splice has room, with a wrench beside it, mm."""
        skew = self.steep * self.height / 2
        return 2 * (self.half_length + self.web + self.bolt.wrench + skew)

    def needed(self, left: FloatArray, right: FloatArray) -> FloatArray:
        """How far fins have to reach from the axis, mm.

        Args:
            left: (N,) angle to the beam that runs through on the left, radians; pi where there is
                none.
            right: (N,) the same on the right.
        """
        angles = np.stack([left, right])
        beside = angles < np.pi
        sine, cosine = np.sin(angles), np.cos(angles)
        sine = np.where(beside, sine, 1.0)

        def reach(out: float, room: float, lean: FloatArray) -> FloatArray:
            """Where a point this far out of the web is as far from the sides of the others."""
            return np.where(beside, (self.web / 2 + room + out * lean) / sine, 0.0)

        tip = self.length - self.bolt.washer - self.grip
        face = self.web / 2 + self.thickness
        out = face + max(tip, self.bolt.washer + self.bolt.head)
        covers = reach(face, _WELD, np.abs(cosine)).max(axis=0) + self.half_length
        wrench = reach(out, self.bolt.wrench, np.abs(cosine)).max(axis=0) + self.back
        # Bolts come from the side on which there is more room.
        way = reach(
            face + self.length + self.bolt.head, self.bolt.corners / 2, np.maximum(cosine, 0)
        )
        way_in = way.min(axis=0) + self.back
        return np.asarray(np.maximum(np.maximum(covers, wrench), way_in) + self._skew)

    def radii(self, around: Around, count: int) -> FloatArray:
        """(V,) from the axis of each of the vertices to the ends of its fins or arms, mm.

        Raises:
            InputError: cover plates that meet in stars of the diameter that is given.
        """
        butting, left, right = self._beside(around)
        starred = replace(around, left=np.where(self.running.stars[around.vertex], around.left, -1))
        radii = np.zeros(count)
        if (starred.left >= 0).any():
            radii = np.where(self.running.stars, super().radii(starred, count), 0.0)
        if self.diameter is not None:
            radii[around.vertex[butting]] = self.diameter / 2
            return radii
        reach = np.zeros(count)
        np.maximum.at(reach, around.vertex[butting], self.needed(left, right))
        return np.asarray(radii + np.ceil(reach / _STEP - 1e-9) * _STEP)

    def _beside(self, around: Around) -> tuple[IntArray, FloatArray, FloatArray]:
        """Half-edges (N,) with fins, angles to what runs through on their left and right."""
        runs = self.running.half_edges
        ends = np.flatnonzero((around.left >= 0) & ~runs & ~self.running.stars[around.vertex])
        left = np.where(runs[around.left[ends]], around.angle[ends], np.pi)
        right = np.where(runs[around.right[ends]], around.angle[around.right[ends]], np.pi)
        met = np.minimum(left, right) < np.pi
        return ends[met], left[met], right[met]


def runs_through(lines: ParameterLines, ends: str) -> BoolArray:
    """(E,) the edges of the family that ``ends`` names by its last letter.

    Raises:
        InputError: a net without two families of lines.
    """
    if (lines.edge_family < 0).any():
        raise InputError(
            f"ends: {ends} needs a net with two families of lines, which this one has not "
            "because of irregular vertices; take mitred, hub or lapped ends"
        )
    return np.asarray(lines.edge_family == "uv".index(ends[-1]))


def fin_cut(half: float, left: float, right: float) -> tuple[float, float]:
    """Where a fin begins: its distance from the axis, mm, and what that changes by to the left.

    It is cut straight, parallel to the axis, and touches the beam that runs through and folds
    there; the gap beside that is filled by the weld.

    Args:
        half: half the thickness of fin and beam, mm.
        left: angle to the beam that runs through on the left, radians; pi or more for none.
        right: the same on the right.
    """
    slopes = [
        sign * np.cos(angle) / np.sin(angle)
        for angle, sign in ((left, 1), (right, -1))
        if angle < np.pi
    ]
    slope = float(np.mean(slopes))

    def least(side: float) -> float:
        """Where the sides of what runs through are, this far to the left."""
        lines = [
            (half + side * sign * np.cos(angle)) / np.sin(angle)
            for angle, sign in ((left, 1), (right, -1))
            if angle < np.pi
        ]
        # Beyond the fold each side counts for itself: towards the fin it is the outer of both.
        outer = left + right <= np.pi
        return float(max(lines) if outer else min(lines))

    places = [-half, half]
    if len(slopes) == 2:
        one, two = slopes
        rise = half / np.sin(right) - half / np.sin(left)
        if abs(one - two) > 1e-12 and abs(rise / (one - two)) < half:
            places.append(float(rise / (one - two)))
    return max(least(side) - slope * side for side in places), slope
