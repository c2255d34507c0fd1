"""The outline of a ribbon's flat pattern, with slots cut from its edges."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_ortho.fabrication.systems.lamellas.ribbon import Ribbon
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray


@dataclass(frozen=True, eq=False)
class Slot:
    """A slot for the lamella that crosses.

    Attributes:
        station: of the ribbon where it is.
        direction: (2,) unit vector in the pattern from its floor to its mouth.
        floor: distance of the floor's middle from the station along ``direction``, mm.
        width: mm.
        upward: true when it opens at the upper edge.
    """

    station: int
    direction: FloatArray
    floor: float
    width: float
    upward: bool

    def sides(self, ribbon: Ribbon) -> FloatArray:
        """(2, 2) corners of the floor in the pattern, the one behind first."""
        across = np.array([self.direction[1], -self.direction[0]])
        across = across if self.upward else -across
        middle = ribbon.strip.flat_points[self.station] + self.floor * self.direction
        return np.stack([middle - 0.5 * self.width * across, middle + 0.5 * self.width * across])


@dataclass(frozen=True, eq=False)
class Notch:
    """A slot where it meets its edge of the ribbon.

    Attributes:
        floor: (2, 2) corners of its floor, the one behind first.
        mouth: (2, 2) where its sides meet the edge.
        faces: numbers of the faces on whose edge that is, for both sides.
    """

    floor: FloatArray
    mouth: FloatArray
    faces: tuple[int, int]


def notch(ribbon: Ribbon, slot: Slot, name: str, other: str) -> Notch:
    """Find where the sides of a slot meet the edge that it opens to.

    Args:
        ribbon: that the slot is cut from.
        slot: where and how wide.
        name: of the lamella, for the message.
        other: of the one that crosses.

    Raises:
        InputError: a side of the slot misses the edge.
    """
    edge = ribbon.edge(ribbon.upper if slot.upward else ribbon.lower)
    floor = slot.sides(ribbon)
    faces, mouths = [], []
    for corner in floor:
        face, place = _hit(edge, corner, slot.direction, slot.station)
        if face < 0:
            raise InputError(
                f"lamellas: the slot of {name} for {other} runs out at the end; take a larger "
                "overhang or a smaller thickness"
            )
        faces.append(face)
        mouths.append(place)
    return Notch(floor, np.stack(mouths), (faces[0], faces[1]))


def outline(ribbon: Ribbon, slots: list[Slot], notches: list[Notch], name: str) -> FloatArray:
    """(N, 2) outline in the pattern, counter-clockwise: lower edge forwards, upper edge back.

    Raises:
        InputError: two slots run into each other.
    """
    sides = []
    for upward, level in ((False, ribbon.lower), (True, ribbon.upper)):
        edge = ribbon.edge(level)
        chosen = [cut for slot, cut in zip(slots, notches, strict=True) if slot.upward is upward]
        sides.append(_notched(edge, chosen, name))
    return np.concatenate([sides[0], sides[1][::-1]])


def _hit(
    edge: FloatArray, corner: FloatArray, direction: FloatArray, near: int
) -> tuple[int, FloatArray]:
    """Face and place where a ray meets an edge of the ribbon; face -1 where it does not."""
    steps, arms = np.diff(edge, axis=0), edge[:-1] - corner
    across = direction[0] * steps[:, 1] - direction[1] * steps[:, 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        share = (arms[:, 0] * direction[1] - arms[:, 1] * direction[0]) / across
        reach = (arms[:, 0] * steps[:, 1] - arms[:, 1] * steps[:, 0]) / across
    fits = (share >= 0) & (share < 1) & (reach > 0)
    if not fits.any():
        return -1, corner
    candidates = np.flatnonzero(fits)
    face = int(candidates[np.argmin(np.abs(candidates + 0.5 - near))])
    return face, edge[face] + share[face] * steps[face]


def _notched(edge: FloatArray, notches: list[Notch], name: str) -> FloatArray:
    """(N, 2) one edge of the ribbon, forwards, with its notches."""
    path = [edge[0]]
    face, reached = 0, 0.0
    for cut in notches:
        start, end = cut.faces
        place = float(np.linalg.norm(cut.mouth[0] - edge[start]))
        if (start, place) <= (face, reached):
            raise InputError(
                f"lamellas: slots of {name} run into each other or over its end; take thinner "
                "lamellas or leave out parameter lines"
            )
        path += [*edge[face + 1 : start + 1], cut.mouth[0], *cut.floor, cut.mouth[1]]
        face, reached = end, float(np.linalg.norm(cut.mouth[1] - edge[end]))
    path += list(edge[face + 1 :])
    return np.array(path)
