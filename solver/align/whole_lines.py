"""Feature lines that have to lie on whole lines of a map."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_array, vstack

from solver.align.cut import Cut
from solver.align.features import Features
from solver.align.field import QUARTER
from solver.align.seams import SeamMap
from solver.align.triangle_mesh import TriangleMesh, components, following
from solver.mesh.connectivity import IntArray


@dataclass(frozen=True, eq=False)
class WholeLines:
    """Coordinates that are alike along runs of edges, and whole.

    Attributes:
        rows: (N,) rows of the layout's matrix: the coordinates; behind them those of the
            differences u - v of the copies, and of the sums u + v.
        runs: (N,) number of the run that each belongs to.
        count: of runs; the value of each is a whole number.
    """

    rows: IntArray
    runs: IntArray
    count: int

    @classmethod
    def none(cls) -> WholeLines:
        """No edge has to."""
        empty = np.zeros(0, dtype=np.int64)
        return cls(empty, empty, 0)

    @classmethod
    def along(cls, mesh: TriangleMesh, cut: Cut, layout: SeamMap, features: Features) -> WholeLines:
        """Runs of feature lines.

        Along an edge that runs with u it is v that stays the same.
        """
        if not len(features.edges):
            return cls.none()
        half = mesh.edges[features.edges, 0]
        triangle = half // 3
        first, second = ((features.along * mesh.axes[triangle, k]).sum(axis=1) for k in (0, 1))
        turned = np.arctan2(second, first) - cut.angles[triangle]
        eighths = np.round(turned / (QUARTER / 2)).astype(np.int64) % 4
        diagonal = features.across & (eighths % 2 == 1)
        with_u = np.round(turned / QUARTER).astype(np.int64) % 2 == 0
        # Along a diagonal that runs up, u - v stays the same; else u + v.
        ahead = layout.matrix.shape[0] + np.where(eighths == 1, 0, layout.matrix.shape[0] // 2)
        copies = layout.copies.ravel()
        one, two = (
            np.where(diagonal, ahead + copies[corner], 2 * copies[corner] + with_u)
            for corner in (half, following(half))
        )
        used, numbers = np.unique(np.concatenate([one, two]), return_inverse=True)
        runs = components(len(used), *np.split(numbers, 2))
        return cls(used, runs, int(runs.max()) + 1)

    def held(self, matrix: csr_array) -> csr_array:
        """(N, unknowns) what is whole, of the unknowns of a layout's matrix."""
        first, second = matrix[0::2], matrix[1::2]
        return csr_array(csr_array(vstack([matrix, first - second, first + second]))[self.rows])

    def snapped(self, matrix: csr_array, reals: int, unknowns: np.ndarray, grid: int) -> None:
        """Bring unknowns that are nearly whole multiples of ``grid`` to these, in place."""
        rows = self.rows[self.rows < matrix.shape[0]]
        if not len(rows):
            return
        some = matrix[rows].tocoo()
        columns = np.unique(some.col[some.col < 2 * reals])
        unknowns[columns] = np.round(unknowns[columns] / grid) * grid
