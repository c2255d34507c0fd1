"""E_multi: orthogonality of rectangles of several faces, taken as one quad."""

from __future__ import annotations

from solver.mesh.connectivity import Connectivity
from solver.terms.orthogonality import Orthogonality


def multi_net(connectivity: Connectivity, rows: int = 1, columns: int = 2) -> Orthogonality:
    """Equal diagonals of each rectangle of ``rows`` x ``columns`` faces, both ways round.

    A rectangle of more than one row ends where a parameter line meets the boundary or an irregular
    vertex.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, sections 3.3 and 4
    (E_multi).
    """
    if sorted((rows, columns)) == [1, 2]:
        corners = connectivity.face_pairs[:, [0, 2, 1, 3]]
    else:
        corners = connectivity.rectangles(rows, columns)
    return Orthogonality(corners, name="multi-net")
