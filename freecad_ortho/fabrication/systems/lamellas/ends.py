"""How far lamellas reach beyond the ends of their lines."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from freecad_ortho.fabrication.systems.lamellas.settings import LamellaSettings
from solver.errors import InputError
from solver.mesh.lines import ParameterLine
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows
from solver.unroll.strip import Strip

# Angle between neighbours, radians, below which no cutting back keeps them apart.
_NARROW = 0.05


def reaches(
    mesh: QuadMesh,
    axes: FloatArray,
    lines: Sequence[ParameterLine],
    settings: LamellaSettings,
) -> list[tuple[float, float]]:
    """Length beyond the first and last vertex of each line, mm.

    Where at most two lines of different families meet, they cross there and reach over each other
    by the overhang. Where more lines end, as at an irregular vertex, each is cut back (less than
    nothing) until its plate is clear of its neighbours. ``axes`` (V, 3) are the unit directions
    that the strips stand along.
    """
    at_vertex: dict[int, list[tuple[int, FloatArray]]] = {}
    for number, line in enumerate(lines):
        path = np.append(line.vertices, line.vertices[0]) if line.closed else line.vertices
        along = unit_rows(np.diff(mesh.vertices[path], axis=0))
        for vertex, direction in zip(path[:-1].tolist(), along, strict=True):
            at_vertex.setdefault(vertex, []).append((number, direction))
        for vertex, direction in zip(path[1:].tolist(), -along, strict=True):
            at_vertex.setdefault(vertex, []).append((number, direction))
    overhang = settings.width / 2 if settings.overhang is None else settings.overhang
    # The last slot of a tilted one runs towards its end.
    tilted = settings.position == "tilted" and settings.overhang is None
    slanted = settings.width / 2 if tilted else 0.0

    def reach(number: int, vertex: int, direction: FloatArray) -> float:
        there = at_vertex[vertex]
        others = {other for other, _ in there if other != number}
        families = {lines[other].family for other in others}
        if len(others) <= 1 and (lines[number].family not in families or not families):
            return overhang + slanted * _cotangent(axes[vertex], direction)
        axis = axes[vertex]
        level = unit_rows(np.array([each - (each @ axis) * axis for _, each in there]))
        own = next(k for k, (_, each) in enumerate(there) if each is direction)
        cosine = max(float(level[own] @ level[k]) for k in range(len(there)) if k != own)
        angle = max(math.acos(min(cosine, 1.0)), _NARROW)
        # The end is square to the edge, and the edge not to the axis that the ends share.
        lean = abs(float(axis @ direction))
        room = settings.thickness / 2 / math.tan(angle / 2) + settings.clearance
        return -(room + settings.width / 2 * lean) / math.sqrt(max(1 - lean**2, _NARROW))

    result = []
    for number, line in enumerate(lines):
        first, last = int(line.vertices[0]), int(line.vertices[-1])
        ends = [
            next(d for other, d in at_vertex[vertex][::step] if other == number)
            for vertex, step in ((first, 1), (last, -1))
        ]
        result.append((reach(number, first, ends[0]), reach(number, last, ends[1])))
    return result


def _cotangent(axis: FloatArray, direction: FloatArray) -> float:
    """Of the angle between two unit vectors, without its sign."""
    lean = abs(float(axis @ direction))
    return lean / math.sqrt(max(1 - lean**2, _NARROW))


def lengthened(strip: Strip, beyond: tuple[float, float], name: str) -> Strip:
    """The strip with its ends moved along its first and last edge.

    A positive length adds a station, a negative one moves the end's.

    Raises:
        InputError: an end is cut back by more than its edge.
    """
    for end, more in zip((0, -1), beyond, strict=True):
        if more <= -0.9 * strip.lengths[end]:
            raise InputError(
                f"lamellas: an end of {name} is cut back by {-more:.3g} mm, but its edge is only "
                f"{strip.lengths[end]:.3g} mm long; take a smaller thickness or coarser lines"
            )
    moves = np.array([[-beyond[0]], [beyond[1]]])
    ends = strip.points[[0, -1]] + moves * strip.along[[0, -1]]
    rulings = strip.rulings[[0, -1]]
    kept = slice(0 if beyond[0] > 0 else 1, None if beyond[1] > 0 else -1)
    points = np.concatenate([ends[:1], strip.points[kept], ends[1:]])
    return Strip(points, np.concatenate([rulings[:1], strip.rulings[kept], rulings[1:]]))
