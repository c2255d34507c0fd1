"""The lines that run along the diagonals of faces, of one family from corner to opposite corner."""

from __future__ import annotations

import numpy as np

from solver.errors import InputError
from solver.mesh.combed import Combed
from solver.mesh.connectivity import Connectivity
from solver.mesh.lines import ParameterLine

# The letter of such lines, beside u and v.
DIAGONAL = "d"


def diagonal_lines(net: Connectivity, family: int) -> tuple[ParameterLine, ...]:
    """Lines along the diagonals of faces, on from face to opposite face at each star.

    Those that only cut off a corner at the border, and so cross no line inside, are left out.

    Args:
        net: of a mesh whose families of lines can be told apart.
        family: 0 for diagonals between the sides along u and v, 1 for the others.

    Returns:
        Lines of the family "d", numbered by their smallest vertex inside; ``edges`` are empty, as
        they run along none.

    Raises:
        InputError: the families are exchanged around an inner vertex.
    """
    combed = Combed(net)
    if not combed.families:
        raise InputError(
            "diagonals: around an inner vertex of the net its families are exchanged, so its "
            "diagonals cannot be told apart; leave them out"
        )
    stars = combed.diagonal_stars
    beside = {
        centre: (before, after)
        for centre, before, after in stars[:, [0, 3 + family, 1 + family]].tolist()
    }
    lines: list[list[int]] = []
    rings: list[bool] = []
    seen: set[int] = set()
    for start in sorted(beside):
        if start in seen:
            continue
        ahead, closed = _walk(start, beside[start][1], beside)
        behind = [] if closed else _walk(start, beside[start][0], beside)[0]
        path = [*behind[::-1], start, *ahead]
        seen.update(path)
        if not closed and path[0] > path[-1]:
            path.reverse()
        lines.append(path)
        rings.append(closed)
    none = np.empty(0, dtype=np.int64)
    return tuple(
        ParameterLine(DIAGONAL, number, np.array(path, dtype=np.int64), none, closed)
        for number, (path, closed) in enumerate(zip(lines, rings, strict=True))
    )


def _walk(start: int, onward: int, beside: dict[int, tuple[int, int]]) -> tuple[list[int], bool]:
    """Vertices after ``start`` until the line ends, and whether it came back to its start."""
    path, before, here = [onward], start, onward
    while here in beside:
        one, two = beside[here]
        if before not in (one, two):
            break
        before, here = here, two if before == one else one
        if here == start:
            return path, True
        path.append(here)
    return path, False
