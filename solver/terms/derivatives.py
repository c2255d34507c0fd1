"""Whether the derivatives of a term are those of its residuals."""

from __future__ import annotations

import numpy as np

from solver.mesh.quadmesh import FloatArray
from solver.terms.base import Term


def derivative_error(term: Term, x: FloatArray, step: float = 1e-5) -> float:
    """Largest difference between a term's Jacobian and central differences of its residuals.

    Rounding and curvature leave some 1e-9 of it where edges are about 1 long, as in the ``start``
    of a problem. For tests: it takes time.

    Args:
        term: any term; one that follows the shape is taken with the data that it has.
        x: the flat vector where it is asked, best one that is not a solution.
        step: of the differences.
    """
    jacobian, unknowns = term.linearise(x).jacobian, term.unknowns
    worst = 0.0
    for column in range(unknowns.shape[1]):
        for element, unknown in enumerate(unknowns[:, column]):
            ahead, back = x.copy(), x.copy()
            ahead[unknown] += step
            back[unknown] -= step
            change = (
                term.linearise(ahead).residual[element] - term.linearise(back).residual[element]
            )
            error = np.abs(change / (2 * step) - jacobian[element, :, column]).max()
            worst = max(worst, float(error))
    return worst
