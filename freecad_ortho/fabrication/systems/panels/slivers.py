"""Slivers at the border: pieces too narrow for a panel become part of a neighbour's.

The neighbour's plane goes on over the sliver. Where that is above the sliver's own plane nothing
below is in the way, and the panel stands off what carried the sliver by a few millimetres; where it
would be below, or far above, the sliver cannot join it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from freecad_ortho.fabrication.plate_limits import CORNER, PlateLimits, as_cut, turns_of
from freecad_ortho.fabrication.systems.panels.blunt import blunted
from freecad_ortho.fabrication.systems.panels.geometry import PanelGeometry
from freecad_ortho.fabrication.systems.panels.trimmed import Trimmed, piece_of
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    import shapely

# Planes that differ by less, mm, are one; one that is further above is that of another panel.
_SAME, _FAR = 0.05, 5.0
# By how much what bridges the joint to a neighbour overlaps it, mm.
_OVERLAP = 1.0


@dataclass(eq=False)
class PanelPieces:
    """What the border leaves of panels, as it changes.

    Attributes:
        whole: (F,) faces with whole panels.
        wide: by face, the pieces that become panels.
        narrow: by name, the others and their faces.
        joined: by name of a sliver, the face whose panel it is a part of, and how far that stands
            above it, mm.
        limits: of the panels' material, None where nothing is known of that.
        slivers: the faces of all that were narrow, by name.
    """

    whole: BoolArray
    wide: dict[int, list[Trimmed]]
    narrow: dict[str, tuple[int, Trimmed]]
    joined: dict[str, tuple[int, float]] = field(default_factory=dict)
    limits: PlateLimits | None = None
    slivers: dict[str, int] = field(default_factory=dict)

    @property
    def made(self) -> BoolArray:
        """(F,) faces with panels."""
        made = self.whole.copy()
        for face, some in self.wide.items():
            made[face] = bool(some)
        return made

    @property
    def covered(self) -> tuple[IntArray, FloatArray]:
        """(F,) of faces without a panel of their own the one whose panel goes on there, else -1.

        And how far above, mm.
        """
        onto, above = np.full(len(self.whole), -1), np.zeros(len(self.whole))
        for name, (other, high) in self.joined.items():
            if not self.made[self.slivers[name]]:
                onto[self.slivers[name]], above[self.slivers[name]] = other, high
        return onto, above

    def can_be(self, piece: Trimmed, rings: Sequence[FloatArray]) -> bool:
        """Tell whether a piece of a panel with these outlines (N, 2) can be made."""
        return self.limits is None or blunted(piece, rings, self.limits) is not None


def join_slivers(
    pieces: PanelPieces, geometry: PanelGeometry, rings: Sequence[FloatArray], across: IntArray
) -> None:
    """Join slivers with the neighbours along whose panels they are longest.

    Args:
        pieces: changed.
        geometry: of panels with square sides.
        rings: sides (F, 4, 2, 2) of the lower, upper and whole outline.
        across: (F, 4) face across each side, -1 at the boundary.
    """
    for name, (face, sliver) in list(pieces.narrow.items()):
        for side, bridge in _bridges(sliver, geometry, face, across):
            other = int(across[face, side])
            if not pieces.made[other]:
                continue
            above = _fitted(pieces, geometry, rings, (face, other), (sliver, bridge))
            if above is not None:
                pieces.joined[name] = other, above
                del pieces.narrow[name]
                break


def _bridges(
    sliver: Trimmed, geometry: PanelGeometry, face: int, across: IntArray
) -> Iterator[tuple[int, list[FloatArray]]]:
    """The sides of its face that a sliver has a part of, and what bridges the joints there."""
    ahead = np.roll(sliver.outline, -1, axis=0) - sliver.outline
    length = np.linalg.norm(ahead, axis=1)
    told = geometry.corners.sides(face)
    own = [None if side < 0 else told[side] for side in sliver.sides.tolist()]
    sides = {side for side in own if side is not None and across[face, side] >= 0}
    parts = {side: [k for k, each in enumerate(own) if each == side] for side in sides}
    for side in sorted(parts, key=lambda side: -float(length[parts[side]].sum())):
        reach = float(geometry.sides[face, side]) + _OVERLAP
        other = int(across[face, side])
        reach += float(geometry.sides[other, across[other].tolist().index(face)])
        found = []
        for k in parts[side]:
            start, end = sliver.outline[k], sliver.outline[k] + ahead[k]
            out = reach * np.array([ahead[k, 1], -ahead[k, 0]]) / length[k]
            found.append(np.array([start, start + out, end + out, end]))
        yield side, found


def _fitted(
    pieces: PanelPieces,
    geometry: PanelGeometry,
    rings: Sequence[FloatArray],
    faces: tuple[int, int],
    parts: tuple[Trimmed, list[FloatArray]],
) -> float | None:
    """Join a sliver and its bridges with the panel of the second face, where they fit on.

    Returns:
        How far the panel stands above the sliver's plane, mm; None where it stays as it is.
    """
    import shapely

    face, other = faces
    sliver, bridges = parts
    ground, height = _seen(geometry, face, other, sliver.outline)
    above = float(-height.min())
    if height.max() > _SAME or above > _FAR:
        return None
    added = [shapely.Polygon(ground, [_seen(geometry, face, other, c)[0] for c in sliver.cutouts])]
    added += [shapely.Polygon(_seen(geometry, face, other, bridge)[0]) for bridge in bridges]
    outlines = [geometry.corners.outline(other, ring[other]) for ring in rings]
    there = pieces.wide.get(other)
    plates = [_polygon(each) for each in there] if there else [shapely.Polygon(outlines[2])]
    shared = [plate.intersection(shapely.union_all(added)).area for plate in plates]
    number = int(np.argmax(shared))
    whole = shapely.union_all([plates[number], *added])
    if shared[number] <= 0 or whole.geom_type != "Polygon":
        return None
    larger = piece_of(outlines, whole.simplify(_SAME))
    if pieces.limits is not None and turns_of(as_cut(larger.outline)).min() < -CORNER:
        # Brittle plates break at corners that are cut into them.
        return None
    if not pieces.can_be(larger, outlines):
        return None
    pieces.wide[other] = list(there or [])
    pieces.wide[other][number : number + 1] = [larger]
    return above


def _polygon(piece: Trimmed) -> shapely.Polygon:
    import shapely

    return shapely.Polygon(piece.outline, piece.cutouts)


def _seen(
    geometry: PanelGeometry, face: int, other: int, points: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Points (N, 2) of a panel's lower side in the plane of another's, and how far above it."""
    planes, levels = geometry.planes, geometry.levels[0]
    flat = np.column_stack([points, np.full(len(points), levels[face])])
    local = planes.middle[face] + flat @ planes.frame[face] - planes.middle[other]
    seen = local @ planes.frame[other].T
    return seen[:, :2], seen[:, 2] - levels[other]
