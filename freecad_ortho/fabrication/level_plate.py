"""Folded plates as they lie on a sheet: unrolled, their ends level, with texts beside the bends."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from freecad_ortho.fabrication.folded import FoldedPlate
from freecad_ortho.fabrication.pattern import Bend, FlatPattern, Mark, fitted_text_size
from solver.mesh.quadmesh import FloatArray


@dataclass(frozen=True, eq=False)
class LevelPlate:
    """An unrolled plate whose line begins and ends at one height; mm from the corner of its box.

    Attributes:
        outline: (N, 2) counter-clockwise seen from the right.
        axis: (K + 1, 2) the unrolled line.
        middles: (K, 2) the unrolled middles of the plates between its bends.
        bends: at the nodes inside.
        height: of the lowest of these plates.
    """

    outline: FloatArray
    axis: FloatArray
    middles: FloatArray
    bends: tuple[Bend, ...]
    height: float

    @classmethod
    def of(cls, plate: FoldedPlate) -> LevelPlate:
        """Turn a plate; one whose line returns to its start stays as it is unrolled."""
        along = plate.axis[-1] - plate.axis[0]
        length = float(np.linalg.norm(along))
        along = along / length if length > 0 else np.array([1.0, 0.0])
        turn = np.array([along, [-along[1], along[0]]]).T
        low = (plate.outline @ turn).min(axis=0)
        return cls(
            plate.outline @ turn - low,
            plate.axis @ turn - low,
            plate.middles @ turn - low,
            tuple(Bend(bend.points @ turn - low, bend.angle_deg) for bend in plate.bends),
            plate.height,
        )

    def mark(
        self, text: str, step: int, ahead: float, width: float, height: float, largest: float
    ) -> Mark:
        """A text along the line.

        Args:
            text: a single line.
            step: number of the plate on which it stands.
            ahead: of its middle, in lengths of the plate.
            width: that it may have, in these.
            height: that it may have, in heights of the lowest plate.
            largest: size of the text, mm.
        """
        length = float(np.linalg.norm(self._steps[step]))
        size = fitted_text_size(text, width * length, height * self.height, largest)
        return Mark(self._place(step, ahead)[None], text, size, self._angles[step])

    def pattern(
        self, name: str, marks: Sequence[Mark], ahead: float, width: float, height: float
    ) -> FlatPattern:
        """The flat pattern, with the name on the longest plate; the rest as for :meth:`mark`."""
        lengths = np.linalg.norm(self._steps, axis=1)
        longest = int(lengths.argmax())
        return FlatPattern(
            self.outline,
            tuple(marks),
            self._place(longest, ahead),
            fitted_text_size(name, width * float(lengths[longest]), height * self.height),
            axis=self.axis,
            bends=self.bends,
            label_angle=self._angles[longest],
            seen="right",
        )

    @property
    def _steps(self) -> FloatArray:
        return np.diff(self.axis, axis=0)

    @property
    def _angles(self) -> list[float]:
        angles: list[float] = np.degrees(np.arctan2(*self._steps.T[::-1])).tolist()
        return angles

    def _place(self, step: int, ahead: float) -> FloatArray:
        place: FloatArray = self.middles[step] + ahead * self._steps[step]
        return place
