"""E_multi: orthogonality of every pair of neighbouring faces taken as one quad."""

from __future__ import annotations

from solver.mesh.connectivity import Connectivity
from solver.terms.orthogonality import Orthogonality


def multi_net(connectivity: Connectivity) -> Orthogonality:
    """Equal diagonals of each one-by-two patch of faces.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, sections 3.3 and 4
    (E_multi).
    """
    return Orthogonality(connectivity.double_patches[:, [0, 2, 1, 3]], name="multi-net")
