"""Large systems by the library rslab, whose failures and bad answers scipy makes good."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.sparse import csc_array
from scipy.sparse.linalg import splu

from solver.errors import SingularSystemError
from solver.isolated import Isolated, LibraryError
from solver.linear.rslab_factors import RslabFactors
from solver.linear.sparsity import Sparsity
from solver.mesh.quadmesh import FloatArray

# Largest backward error of a solution that is taken; a sound one is 1e-10 and below.
_BACKWARD = 1e-6
# Seconds that the library may take: at least, and for every unknown.
_SECONDS, _SECONDS_EACH = 60.0, 1e-3


class GuardedRslab:
    """LDL^T by rslab in a process of its own; after its first failure by SuperLU.

    Args:
        sparsity: of the lower triangle.
    """

    def __init__(self, sparsity: Sparsity) -> None:
        self._sparsity = sparsity
        self._library = Isolated(RslabFactors, sparsity.indptr, sparsity.indices)
        self._limit = _SECONDS + _SECONDS_EACH * sparsity.size
        self._factored: FloatArray | None = None
        self.remark = ""

    def factor(self, lower: FloatArray) -> Callable[[FloatArray], FloatArray]:
        """Factor the lower triangle (nnz,); return the function that solves for right sides (n,).

        Raises:
            SingularSystemError: the matrix cannot be factored.
        """
        if not self.remark:
            try:
                self._factor(lower)
                return lambda right: self._solve(lower, right)
            except LibraryError as error:
                self._give_up(str(error))
        return self._superlu(lower)

    def _factor(self, lower: FloatArray) -> None:
        self._factored = None
        if not self._library.call("factor", lower, time_limit=self._limit):
            raise _singular()
        self._factored = lower

    def _solve(self, lower: FloatArray, right: FloatArray) -> FloatArray:
        if not self.remark:
            try:
                if self._factored is not lower:
                    self._factor(lower)
                solution = self._library.call("solve", right, time_limit=self._limit)
                if self._holds(lower, solution, right):
                    return np.asarray(solution)
                self._give_up("its solution is wrong")
            except LibraryError as error:
                self._give_up(str(error))
        return self._superlu(lower)(right)

    def _holds(self, lower: FloatArray, solution: FloatArray, right: FloatArray) -> bool:
        """Whether a solution solves the system, as far as rounding lets it."""
        if not np.isfinite(right).all():
            return True
        matrix = self._matrix(lower)
        rest = np.abs(matrix @ solution - right).max(initial=0.0)
        scale = abs(matrix) @ np.abs(solution) + np.abs(right)
        return bool(rest <= _BACKWARD * scale.max(initial=0.0))

    def _give_up(self, why: str) -> None:
        self._library.close()
        self.remark = f"the library rslab failed ({why}), so scipy solved the systems"

    def _superlu(self, lower: FloatArray) -> Callable[[FloatArray], FloatArray]:
        try:
            factors = splu(
                self._matrix(lower),
                permc_spec="MMD_AT_PLUS_A",
                diag_pivot_thresh=0.0,
                options={"SymmetricMode": True},
            )
        except RuntimeError:
            raise _singular() from None
        return lambda right: np.asarray(factors.solve(right))

    def _matrix(self, lower: FloatArray) -> csc_array:
        """The whole symmetric matrix."""
        size, sparsity = self._sparsity.size, self._sparsity
        half = csc_array((lower, sparsity.indices, sparsity.indptr), shape=(size, size))
        diagonal = lower[sparsity.indptr[:-1]]
        places = np.arange(size + 1)
        return csc_array(half + half.T - csc_array((diagonal, places[:-1], places), half.shape))


def _singular() -> SingularSystemError:
    return SingularSystemError("linear system: the matrix is singular; raise the damping")
