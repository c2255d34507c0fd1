"""A surface carried on beyond its border, so that a net may overhang it.

Each border vertex gets spokes that run outwards along the surface's own polynomial; at outward
corners a fan of them. No spoke is longer than where it would meet that of another border vertex
(the medial axis), so strips of inward corners, slits and openings do not run into each other.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from solver.align.jets import fitted
from solver.align.triangle_mesh import TriangleMesh
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, unit_rows

# A corner that turns outwards by more gets spokes at this angle.
_FAN = np.radians(25.0)
# Of the way to where the spokes of two border vertices meet.
_OF_THE_WAY = 0.85
# Only border vertices whose normals are alike stand in each other's way.
_ALIKE = 0.3
_BLOCK = 500


def extended(
    mesh: TriangleMesh,
    width: float,
    step: float,
    radius: float,
    degree: int = 3,
    margin: float | None = None,
) -> tuple[TriangleMesh, int]:
    """Add strips of triangles along the border.

    Args:
        mesh: the surface.
        width: how far it goes on, where nothing is in the way.
        step: length of the new triangles, about.
        radius: of the fit that says how it goes on.
        degree: of that fit, 2 where the surface is noisy.
        margin: width of the first strip, where nothing is in the way; by default ``step``.

    Returns:
        the larger surface, whose first triangles and points are those of ``mesh``; those of the
        first strip follow. And how many triangles both have.
    """
    spokes = _Spokes.of(mesh)
    reach = np.minimum(width, _OF_THE_WAY * _room(mesh, spokes))
    jets = fitted(mesh, spokes.rim, radius, degree)
    first, second = ((spokes.directions * jets.axes[spokes.at, k]).sum(axis=1) for k in range(2))
    length = np.hypot(first, second)
    first, second = first / length, second / length
    rings = max(2, int(np.ceil(width / step)))
    numbers, points = [spokes.rim[spokes.at]], [mesh.points]
    count, total = len(reach), len(mesh.points)
    near = np.minimum(step if margin is None else margin, reach / 2)
    for ring in range(rings):
        out = near + (reach - near) * (ring / (rings - 1))
        points.append(jets.beside(spokes.at, out * first, out * second))
        numbers.append(total + np.arange(count))
        total += count
    one, two = spokes.neighbours.T
    triangles = [mesh.triangles]
    for inner, outer in pairwise(numbers):
        triangles.append(np.stack([inner[one], outer[one], outer[two]], axis=1))
        apart = inner[one] != inner[two]
        triangles.append(np.stack([inner[one], outer[two], inner[two]], axis=1)[apart])
    both = len(triangles[0]) + len(triangles[1]) + len(triangles[2])
    return TriangleMesh(np.concatenate(points), np.concatenate(triangles)), both


@dataclass(frozen=True, eq=False)
class _Spokes:
    """Where the border goes on, and in which directions.

    Attributes:
        rim: (R,) border vertices.
        at: (S,) row of ``rim`` of each spoke.
        directions: (S, 3) unit vectors in tangent planes.
        neighbours: (K, 2) spokes that follow each other along the border.
    """

    rim: IntArray
    at: IntArray
    directions: FloatArray
    neighbours: IntArray

    @classmethod
    def of(cls, mesh: TriangleMesh) -> _Spokes:
        """Spokes of all border vertices of a surface."""
        after = mesh.next_rim()
        rim = np.array(sorted(after))
        before = {after[vertex]: vertex for vertex in after}
        here = mesh.points[rim]
        following = mesh.points[[after[v] for v in rim.tolist()]] - here
        leading = here - mesh.points[[before[v] for v in rim.tolist()]]
        normals = mesh.vertex_normals[rim]
        along, came = unit_rows(following), unit_rows(leading)
        outwards = unit_rows(np.cross(along + came, normals))
        start = unit_rows(np.cross(came, normals))
        turn = np.arctan2((np.cross(came, along) * normals).sum(axis=1), (came * along).sum(axis=1))
        at: list[int] = []
        directions: list[FloatArray] = []
        first: dict[int, int] = {}
        last: dict[int, int] = {}
        for row, vertex in enumerate(rim.tolist()):
            first[vertex] = len(at)
            if turn[row] > _FAN:
                side = np.cross(normals[row], start[row])
                for angle in np.linspace(0, turn[row], int(np.ceil(turn[row] / _FAN)) + 1):
                    at.append(row)
                    directions.append(np.cos(angle) * start[row] + np.sin(angle) * side)
            else:
                at.append(row)
                directions.append(outwards[row])
            last[vertex] = len(at) - 1
        pairs = []
        for vertex in rim.tolist():
            pairs += [(k, k + 1) for k in range(first[vertex], last[vertex])]
            pairs.append((last[vertex], first[after[vertex]]))
        return cls(rim, np.array(at), unit_rows(np.array(directions)), np.array(pairs))


def _room(mesh: TriangleMesh, spokes: _Spokes) -> FloatArray:
    """(S,) how far each spoke runs before another border vertex is as near as its own."""
    rim, normals = mesh.points[spokes.rim], mesh.vertex_normals[spokes.rim]
    room = np.full(len(spokes.at), np.inf)
    for start in range(0, len(room), _BLOCK):
        at = spokes.at[start : start + _BLOCK]
        apart = rim[None] - rim[at][:, None]
        ahead = np.einsum("nmk,nk->nm", apart, spokes.directions[start : start + _BLOCK])
        square = (apart * apart).sum(axis=2)
        meets = (ahead > 1e-3 * np.sqrt(square)) & (normals[at] @ normals.T > _ALIKE)
        found = np.divide(square, 2 * ahead, out=np.full_like(square, np.inf), where=meets)
        room[start : start + _BLOCK] = found.min(axis=1)
    return room
