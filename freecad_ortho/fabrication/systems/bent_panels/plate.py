"""A row as a bent plate: its strip, inset from its neighbours, its solid and its flat pattern."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from freecad_ortho.fabrication.pattern import (
    Bend,
    FlatPattern,
    Mark,
    fitted_text_size,
    overlaps_itself,
)
from freecad_ortho.fabrication.ruled import RuledBody
from freecad_ortho.fabrication.ruled_sides import Side
from freecad_ortho.fabrication.systems.bent_panels.rows import Row
from freecad_ortho.fabrication.systems.lamellas.ribbon import FLAT, Ribbon
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.unroll.strip import Strip

if TYPE_CHECKING:
    import shapely

# Share of an end face that must be left.
_LEFT_OVER = 0.05


@dataclass(frozen=True, eq=False)
class BentPlate:
    """A row of faces as a plate that is bent at its inner edges.

    Attributes:
        row: its faces; the part has its name.
        ribbon: its strip along the middles of the inner edges, which are its rulings.
        reach: (K + 1,) half the length of each inner edge.
        rails: (2, K + 1) where the plate ends along each ruling, right side then left.
        ends: (2, 2) by which share of its end face each side is shortened, at start and end.
    """

    row: Row
    ribbon: Ribbon
    reach: FloatArray
    rails: FloatArray
    ends: FloatArray

    @property
    def length(self) -> float:
        """Along the middle, from line to line of the net, mm."""
        return float(self.ribbon.strip.lengths.sum())

    @cached_property
    def corners(self) -> FloatArray:
        """(2, K + 1, 3) of the middle of the plate, right side then left."""
        strip = self.ribbon.strip
        return self._shortened(strip.points + self.rails[..., None] * strip.rulings)

    @cached_property
    def flat(self) -> FloatArray:
        """(2, K + 1, 2) the same in the pattern."""
        strip = self.ribbon.strip
        return self._shortened(strip.flat_points + self.rails[..., None] * strip.flat_rulings)

    @property
    def outline(self) -> FloatArray:
        """(N, 2) around the pattern."""
        right, left = self.flat
        return np.concatenate([right, left[::-1]])

    def refold_miss(self) -> float:
        """Largest distance of the plate folded from its pattern to the plate in space, mm."""
        points, rulings = np.moveaxis(self.ribbon.strip.refolded(), 1, 0)
        folded = self._shortened(points + self.rails[..., None] * rulings)
        return float(np.linalg.norm(folded - self.corners, axis=2).max())

    def _shortened(self, points: FloatArray) -> FloatArray:
        result = points.copy()
        for end, beside, share in ((0, 1, self.ends[0]), (-1, -2, self.ends[1])):
            step = points[:, beside] - points[:, end]
            result[:, end] = points[:, end] + share[:, None] * step
        return result

    def body(self) -> RuledBody:
        """The solid; on inner edges the corners lie in the mitre planes of the faces."""
        middle = self.corners.reshape(-1, 3)
        half = np.tile(self.ribbon.mitres, (2, 1))
        corners = np.concatenate([middle - half, middle + half])
        count, rungs = len(middle), len(middle) // 2
        around = [*range(rungs), *range(count - 1, rungs - 1, -1)]
        sides: list[Side] = []
        blocks = []
        for face in range(rungs - 1):
            loop = (face, face + 1, rungs + face + 1, rungs + face)
            upper = tuple(corner + count for corner in loop)
            sides += [upper, loop[::-1]]
            blocks.append(corners[[*loop, *upper]])
        for start, end in zip(around, around[1:] + around[:1], strict=True):
            sides.append((start, end, end + count, start + count))
        return RuledBody(corners, tuple(sides), blocks=tuple(blocks))

    def placed(self, points: FloatArray) -> FloatArray:
        """Points (..., 2) of the strip's own plane in the flat pattern, which runs along x."""
        ends = self.flat.mean(axis=0)[[0, -1]]
        chord = ends[1] - ends[0]
        if np.linalg.norm(chord) < 0.1 * self.ribbon.strip.lengths.sum():
            chord = np.array([1.0, 0.0])
        x, y = chord / np.linalg.norm(chord)
        turn = np.array([[x, -y], [y, x]])
        return np.asarray(points @ turn - (self.flat @ turn).reshape(-1, 2).min(axis=0))

    def placed_within(self, outline: shapely.Polygon) -> shapely.Polygon:
        """A polygon of the strip's own plane in the flat pattern."""
        import shapely

        return shapely.transform(outline, self.placed)

    def pattern(self, beside: tuple[str, str], face: int) -> FlatPattern:
        """The flat pattern with its name in a face of the row.

        Args:
            beside: names of the rows on the right and left of that face.
            face: its number in the row.

        Raises:
            InputError: it overlaps itself.
        """
        if overlaps_itself(self.outline):
            raise InputError(
                f"bent-panels: the flat pattern of {self.row.name} overlaps itself; take the other "
                "family, or cut the mesh"
            )
        turned = self.placed(self.flat)
        right, left = turned
        bends = tuple(
            Bend(turned[:, rung], -float(np.degrees(angle)))
            for rung, angle in enumerate(self.ribbon.strip.bends)
            if abs(angle) > FLAT
        )
        corner = turned[:, face : face + 2]
        along = corner[:, 1] - corner[:, 0]
        wide = float(np.linalg.norm(corner[1].mean(axis=0) - corner[0].mean(axis=0)))
        long = float(np.linalg.norm(along, axis=1).min())
        size = fitted_text_size(self.row.name, 0.8 * long, 0.4 * wide)
        return FlatPattern(
            outline=np.concatenate([right, left[::-1]]),
            marks=tuple(_names(corner, beside, long, wide)),
            label=corner.reshape(-1, 2).mean(axis=0),
            label_size=size,
            bends=bends,
            label_angle=float(np.degrees(np.arctan2(*along.mean(axis=0)[::-1]))),
            seen="above",
        )


def plate_of(
    mesh: QuadMesh, row: Row, thickness: float, gap: float, insets: FloatArray
) -> BentPlate:
    """Make the plate of a row.

    Args:
        mesh: near the origin, mm.
        row: of faces.
        thickness: of the plate, half to each side of the net, mm.
        gap: to what is beside the row, mm; half of it lies beyond the net's boundary too.
        insets: (F, 4) by how much more than half of the gap each side of a face moves inwards, mm.

    Raises:
        InputError: a gap that leaves nothing of a face.
    """
    left, right = mesh.vertices[row.rungs[:, 0]], mesh.vertices[row.rungs[:, 1]]
    length = np.linalg.norm(left - right, axis=1)
    if length.min() <= 1e-9 * mesh.mean_edge:
        vertex = int(row.rungs[int(length.argmin()), 0])
        raise InputError(f"bent-panels: {row.name} has no width at vertex {vertex}")
    strip = Strip(0.5 * (left + right), (left - right) / length[:, None])
    reach = length / 2
    flat = strip.flat_points + np.stack([-reach, reach])[..., None] * strip.flat_rulings
    moved = gap / 2 + insets[row.faces[:, None], (row.first_sides[:, None] + [1, 3]) % 4].T
    steps = np.diff(flat, axis=1)
    run = np.linalg.norm(steps, axis=2)
    sines = [
        _sine(steps / run[..., None], strip.flat_rulings[k : len(reach) - 1 + k]) for k in (0, 1)
    ]
    ahead, behind = (moved / np.maximum(sine, 1e-6) for sine in sines)
    taken = np.zeros((2, len(reach)))
    taken[:, :-1] = ahead
    taken[:, 1:] = np.maximum(taken[:, 1:], behind)
    rails = np.stack([taken[0] - reach, reach - taken[1]])
    ends = np.zeros((2, 2))
    for end, beside, face, side in ((0, 1, 0, 0), (-1, -2, -1, 2)):
        back = gap / 2 + insets[row.faces[face], (row.first_sides[face] + side) % 4]
        arms = (
            strip.flat_points[beside]
            + rails[:, beside, None] * strip.flat_rulings[beside]
            - strip.flat_points[end]
        )
        ruling = strip.flat_rulings[end]
        ends[end] = back / np.abs(arms[:, 0] * ruling[1] - arms[:, 1] * ruling[0])
    _refuse(row, rails, ends, gap)
    ribbon = Ribbon(strip, -float(reach.max()), float(reach.max()), thickness)
    return BentPlate(row, ribbon, reach, rails, ends)


def _refuse(row: Row, rails: FloatArray, ends: FloatArray, gap: float) -> None:
    narrow = rails[1] <= rails[0]
    left = 1 - (ends.sum(axis=0) if len(row.faces) == 1 else ends.max(axis=0))
    if narrow.any() or left.min() < _LEFT_OVER:
        face = int(row.faces[min(int(narrow.argmax()), len(row.faces) - 1)])
        raise InputError(
            f"gap: {gap:g} mm and what leaning neighbours need leave nothing of {row.name} near "
            f"face {face}; take a smaller gap or thinner plates"
        )


def _sine(directions: FloatArray, rulings: FloatArray) -> FloatArray:
    """Sines of the angles between (2, K, 2) sides and (K, 2) rulings."""
    return np.abs(directions[..., 0] * rulings[:, 1] - directions[..., 1] * rulings[:, 0])


def _names(corner: FloatArray, beside: tuple[str, str], long: float, wide: float) -> list[Mark]:
    """Names of the neighbours along the right and left side of a face (2, 2, 2)."""
    marks = []
    for side, text in enumerate(beside):
        if text:
            size = fitted_text_size(text, 0.6 * long, 0.15 * wide, 12.0)
            step = corner[side, 1] - corner[side, 0]
            inward = corner[1 - side].mean(axis=0) - corner[side].mean(axis=0)
            place = corner[side].mean(axis=0) + inward * (size / wide)
            marks.append(Mark(place[None], text, size, float(np.degrees(np.arctan2(*step[::-1])))))
    return marks
