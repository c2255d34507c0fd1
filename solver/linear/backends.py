"""Symmetric systems whose sparsity never changes.

The analysis of the sparsity is done once; each call factors new numbers. ``scipy`` stands for the
method of :mod:`solver.linear.multifrontal`, on LAPACK from scipy. The package ``rslab`` takes large
systems where it is installed: it uses all cores.
"""

from __future__ import annotations

import importlib.util
from collections.abc import Callable
from typing import Protocol

from solver.errors import InputError
from solver.linear.guarded import GuardedRslab
from solver.linear.multifrontal import Multifrontal
from solver.linear.sparsity import Sparsity
from solver.mesh.quadmesh import FloatArray
from solver.option import one_of

BACKENDS = ("scipy", "rslab")

# Unknowns from which on the threads of rslab outweigh its overhead.
_RSLAB_PAYS = 60_000


class SymmetricSolver(Protocol):
    """Solves A x = b for matrices of one sparsity.

    Attributes:
        remark: what is out of the ordinary about how it does so, "" for nothing.
    """

    remark: str

    def factor(self, lower: FloatArray) -> Callable[[FloatArray], FloatArray]:
        """Factor the lower triangle (nnz,); return the function that solves for right sides (n,).

        Raises:
            SingularSystemError: the matrix cannot be factored.
        """


def symmetric_solver(sparsity: Sparsity, backend: str) -> SymmetricSolver:
    """Return the solver that ``backend`` names.

    Raises:
        InputError: the named backend is unknown or not installed.
    """
    one_of("sparse solver", backend, BACKENDS)
    if backend == "rslab" and not _rslab_installed():
        raise InputError("sparse solver: rslab is not installed; pip install rslab, or use scipy")
    return GuardedRslab(sparsity) if backend == "rslab" else Multifrontal(sparsity)


def default_backend(unknowns: int) -> str:
    """Name of the solver that is fastest for so many unknowns, of those that are installed."""
    return "rslab" if unknowns >= _RSLAB_PAYS and _rslab_installed() else "scipy"


def _rslab_installed() -> bool:
    return importlib.util.find_spec("rslab") is not None
