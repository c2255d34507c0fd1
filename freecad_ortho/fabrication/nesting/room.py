"""What of a sheet a part may take: all of it but the spacing at its rim, as its grain allows."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_ortho.fabrication.nesting.sheet import turned
from freecad_ortho.fabrication.workshop import Workshop
from solver.mesh.quadmesh import FloatArray


@dataclass(frozen=True)
class Room:
    """A rectangle that parts are laid into.

    Attributes:
        width: mm.
        height: mm.
        turns: whether parts may lie any way in it, not only with their length along its width.
    """

    width: float
    height: float
    turns: bool

    @classmethod
    def of(cls, workshop: Workshop, rim: float = 0.0) -> Room | None:
        """The room on a workshop's sheets, None without a sheet size.

        Args:
            workshop: sheet, spacing and grain.
            rim: by how much outlines still grow on each side, mm.
        """
        if workshop.sheet is None:
            return None
        width, height = (side - 2 * (workshop.spacing + rim) for side in workshop.sheet)
        return cls(width, height, workshop.grain == "none")

    def angles(self, outline: FloatArray) -> list[float]:
        """Angles, degrees, by which an outline (N, 2) may be turned so that its box is small."""
        if not self.turns:
            return [0.0]
        side = np.roll(outline, -1, axis=0) - outline
        turns = np.round(-np.degrees(np.arctan2(side[:, 1], side[:, 0])), 9) % 90
        return [0.0, *np.unique(turns).tolist()]

    def takes(self, box: FloatArray) -> bool:
        """Whether a box (2,) lies in it."""
        size = np.array([self.width, self.height]) * (1 + 1e-9)
        return bool((box <= size).all() or (self.turns and (box[::-1] <= size).all()))

    def holds(self, outline: FloatArray) -> bool:
        """Whether an outline (N, 2) lies in it."""
        return any(
            self.takes(np.ptp(turned(outline, angle), axis=0)) for angle in self.angles(outline)
        )
