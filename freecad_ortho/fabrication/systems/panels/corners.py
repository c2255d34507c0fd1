"""Corners of panels that are cut off, each by a line across it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from solver.errors import InputError
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray

# A corner that is cut at all loses at least this much along its bisector, mm.
_LEAST = 1.0
# Part of a side that may go.
_MOST = 0.95


@dataclass(frozen=True, eq=False)
class PanelCorners:
    """Lines across the corners of panels, in the planes of their outlines.

    Attributes:
        inwards: (F, 4, 2) unit directions from the corners into the panels.
        begins: (F, 4) how far along them from the outlines' origins the panels begin, mm; -inf
            where a corner stays.
    """

    inwards: FloatArray
    begins: FloatArray

    @property
    def cut(self) -> BoolArray:
        """(F, 4) true where a corner is cut off."""
        return np.isfinite(self.begins)

    def through(self, *rings: FloatArray) -> PanelCorners:
        """Lines that cut the corner off every one of these outlines (F, 4, 2) or off none."""
        tips = np.stack([np.einsum("fcd,fcd->fc", ring, self.inwards) for ring in rings])
        cut = self.begins > tips.min(axis=0)
        through = np.maximum(self.begins, tips.max(axis=0) + _LEAST)
        return replace(self, begins=np.where(cut, through, -np.inf))

    def shares(self, ring: FloatArray) -> tuple[FloatArray, FloatArray]:
        """(F, 4) parts of each side of an outline (F, 4, 2) that go at its start and at its end."""
        ahead = np.roll(ring, -1, axis=1) - ring
        missing = np.where(
            self.cut, self.begins - np.einsum("fcd,fcd->fc", ring, self.inwards), 0.0
        )
        arms = ahead, -np.roll(ahead, 1, axis=1)
        start, last = (
            missing / np.where(self.cut, np.einsum("fcd,fcd->fc", arm, self.inwards), 1.0)
            for arm in arms
        )
        return start, np.roll(last, -1, axis=1)

    def trimmed(self, ring: FloatArray) -> FloatArray:
        """(F, 4, 2, 2) both ends of what is left of the sides of an outline (F, 4, 2)."""
        ahead = np.roll(ring, -1, axis=1) - ring
        start, end = self.shares(ring)
        return np.stack(
            [ring + start[..., None] * ahead, ring + (1 - end)[..., None] * ahead], axis=2
        )

    def outline(self, face: int, trimmed: FloatArray) -> FloatArray:
        """(N, 2) one panel from its sides (4, 2, 2): corners that are cut off are two points."""
        points: list[FloatArray] = []
        for k in range(len(trimmed)):
            if self.cut[face, k]:
                points.append(trimmed[k - 1, 1])
            points.append(trimmed[k, 0])
        return np.array(points)

    def sides(self, face: int) -> list[int | None]:
        """The side of a face that each side of one panel's outline lies on, None at a cut."""
        return [
            side
            for k in range(self.begins.shape[1])
            for side in ((None, k) if self.cut[face, k] else (k,))
        ]

    def spared(self, faces: BoolArray) -> PanelCorners:
        """Lines that leave the chosen panels (F,) whole."""
        return replace(self, begins=np.where(faces[:, None], -np.inf, self.begins))

    def gone(self, *rings: FloatArray) -> BoolArray:
        """(F,) true where the lines leave too little of a side of one of these outlines."""
        taken = np.array([np.add(*self.shares(ring)) for ring in rings])
        return np.asarray((taken > _MOST).any(axis=(0, 2)))

    def refuse_meeting(self, numbers: IntArray, *rings: FloatArray) -> None:
        """Refuse cuts that leave nothing of a side of one of the faces with these numbers (F,).

        Raises:
            InputError: naming the face.
        """
        gone = self.gone(*rings)
        if gone.any():
            raise InputError(
                f"at hubs: corners cut off leave nothing of a side of the panel in face "
                f"{numbers[gone.argmax()]}; take smaller hubs"
            )


def uncut(count: int, size: int = 4) -> PanelCorners:
    """All corners of so many faces with ``size`` of them stay."""
    return PanelCorners(np.zeros((count, size, 2)), np.full((count, size), -np.inf))
