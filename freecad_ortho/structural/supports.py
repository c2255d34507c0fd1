"""Supports of a net from their words: ``boundary``, ``corners:fixed+3,17:sliding``."""

from __future__ import annotations

import numpy as np

from solver.errors import InputError
from solver.frame.model import Supports
from solver.mesh.connectivity import BoolArray, Connectivity, IntArray
from solver.mesh.quadmesh import FloatArray

# What kinds of supports hold: displacements and rotations along and about x, y, z.
_HELD = {
    "pinned": (True, True, True, False, False, False),
    "fixed": (True,) * 6,
    "sliding": (False, False, True, False, False, False),
}
_SPRINGS = "springs="


def supports_of(text: str, net: Connectivity) -> Supports:
    """Supports of the vertices of a net.

    Args:
        text: places, each with a kind after a colon (pinned, where none is said), joined by "+".
        net: its vertices.

    Raises:
        InputError: no such place, vertex or kind.
    """
    fixed = np.zeros((net.vertex_count, 6), dtype=bool)
    springs = np.zeros((net.vertex_count, 6))
    for entry in text.split("+"):
        place, _, kind = (word.strip() for word in entry.partition(":"))
        at = _vertices(place, net)
        kind = kind or "pinned"
        if kind.startswith(_SPRINGS):
            springs[at, :3] = _stiffness(kind)
        elif kind in _HELD:
            fixed[at] |= np.array(_HELD[kind])
        else:
            raise InputError(
                f"supports: expected {', '.join(_HELD)} or {_SPRINGS}X/Y/Z in kN/mm after ':', "
                f"got '{kind[:40]}'"
            )
    return Supports.upright(fixed, springs)


def _vertices(place: str, net: Connectivity) -> IntArray | BoolArray:
    if place in ("boundary", "corners"):
        found = (net.boundary_vertices if place == "boundary" else net.corners) & net.referenced
        if not found.any():
            raise InputError(f"supports: the net has no {place}; name vertices by their numbers")
        return found
    try:
        numbers = np.array([int(number) for number in place.split(",")])
    except ValueError:
        raise InputError(
            f"supports: expected boundary, corners or numbers of vertices, got '{place[:40]}'"
        ) from None
    bad = [n for n in numbers.tolist() if not (0 <= n < net.vertex_count and net.referenced[n])]
    if bad:
        raise InputError(
            f"supports: there is no vertex {bad[0]} in the net; it has {net.vertex_count}, counted "
            "from 0"
        )
    return numbers


def _stiffness(kind: str) -> FloatArray:
    try:
        found = np.array([float(number) for number in kind.removeprefix(_SPRINGS).split("/")])
    except ValueError:
        found = np.zeros(0)
    if found.shape != (3,) or not (np.isfinite(found) & (found >= 0)).all():
        raise InputError(
            f"supports: expected {_SPRINGS}X/Y/Z, three stiffnesses in kN/mm, got '{kind[:40]}'"
        )
    return 1000.0 * found
