"""A net on faces that meet at creases: lines along every crease and the border, evenly spaced.

A face with four corners becomes a grid. Any other is parted from a vertex in its middle to its
sides, one grid at each corner.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np
from scipy.spatial import cKDTree

from solver.align.facets import MOST, FlatFaces, Side, carried_on, faces, turning, zipped
from solver.align.features import Features, creased
from solver.align.field import GuidingField
from solver.align.parting import parted
from solver.align.patch_counts import counts_along
from solver.align.prepare import Work
from solver.align.remarks import turned_by
from solver.align.spread import spread
from solver.align.symmetry import Mirror, symmetric_net
from solver.align.triangle_mesh import TriangleMesh
from solver.analysis.measures import flipped, orthogonality
from solver.errors import InputError
from solver.mesh.intake import quad_mesh
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.sentence import Sentence

# The shortest edge of a net that is even enough, in mean edges.
_EVEN = 0.2
# Faces that are flat meet at a crease where they turn by more.
_FOLDED = np.radians(2.0)
# In edges, how far apart two faces may be that meet.
_HAIR = 1e-5
# Degrees between creases and lines of curvature from which on the creases count alone.
_ACROSS = 20.0
# In edges, how far beside a crease curvature is looked at.
_BESIDE = 1.5
# In edges, how far a crease is carried on where the surface does not turn.
_GAP = 1.5
# Faces may be parted into so many each, on average.
_PARTS = 4
# Cosines that corners of a principal net may have.
_UPRIGHT = 1e-6
# What becomes of flat panels with right corners, and with others.
_RIGHT = Sentence("panels are flat and their corners right as they are: no exact net moves them")
_ASKEW = Sentence(
    "panels are flat as they are, and stay so in a planar net (--net planar); creases are askew to "
    "each other, so that corners are not right, and an exact principal net leaves the roof"
)


def net_on_flat_faces(
    surface: TriangleMesh, mirrors: Sequence[Mirror], edge: float, remarks: list[str]
) -> QuadMesh | None:
    """A net on a surface of flat faces; None on others, with openings, or without an even net.

    Args:
        surface: as it was given.
        mirrors: planes in which the net is its own mirror image.
        edge: wanted edge length.
        remarks: gets a sentence where there is such a net.
    """
    if not 1 < faces(surface, turning(surface, _FOLDED)) <= MOST:
        return None
    surface = zipped(surface, _HAIR * edge)
    sharp = turning(surface, _FOLDED)
    count = faces(surface, sharp)
    made = parted(surface, sharp, edge)
    facets = None if made is None else FlatFaces.of(*made, edge, _PARTS * MOST)
    if made is None or facets is None or not facets.flat(made[0]):
        return None
    net = net_on_facets(made[0], facets, mirrors, edge)
    if net is not None:
        right = orthogonality(net).max() < _UPRIGHT
        made_of = Sentence(
            "the surface is made of {} flat faces: lines run along all creases between them and "
            "along the border, where the net ends",
            count,
        )
        remarks += [made_of, _RIGHT if right else _ASKEW]
    return net


def net_along_creases(
    surface: TriangleMesh,
    work: Work,
    guide: GuidingField,
    mirrors: Sequence[Mirror],
    edge: float,
    remarks: list[str],
) -> QuadMesh | None:
    """A net on faces that meet at creases, where these do not run along lines of curvature.

    Args:
        surface: without noise.
        work: the same made ready.
        guide: the directions of curvature.
        mirrors: planes in which the net is its own mirror image.
        edge: wanted edge length.
        remarks: gets a sentence where there is such a net.

    Returns:
        None where creases run along curvature, are none, or part the surface into faces that have
        openings or no even net.
    """
    turned = _turned(work, guide, edge)
    if turned < _ACROSS:
        return None
    sharp = carried_on(surface, creased(surface, edge), _GAP * edge)
    facets = FlatFaces.of(surface, sharp, edge)
    net = None if facets is None else net_on_facets(surface, facets, mirrors, edge)
    if facets is not None and net is not None:
        remarks.append(
            Sentence(
                "creases between {} faces run at {:.0f} degrees to the lines of curvature on "
                "average: lines run along all creases and along the border, where the net ends, in "
                "place of curvature. A net along curvature, which has flat panels, is one on each "
                "face alone (--faces)",
                len(facets.sides),
                turned,
            )
        )
    return net


def _turned(work: Work, guide: GuidingField, edge: float) -> float:
    """Mean angle in degrees between creases and curvature beside them; 0 without creases.

    On the crease itself what is fitted to both sides says nothing.
    """
    mesh = work.mesh
    creases = Features.creases(mesh, work.inner, edge)
    if not len(creases.edges):
        return 0.0
    middle = sum(mesh.points[side[creases.edges]] for side in mesh.ends) / 2
    beside = [
        np.cross(mesh.normals[half // 3], creases.along) for half in mesh.edges[creases.edges].T
    ]
    places = np.concatenate([middle + _BESIDE * edge * way for way in (beside[0], -beside[1])])
    off, rows = cKDTree(mesh.centres[: work.inner]).query(places)
    along = np.tile(creases.along, (2, 1))
    sound = (off < edge) & (cKDTree(middle).query(mesh.centres[rows])[0] > edge)
    if not sound.any():
        return 0.0
    return turned_by(mesh, guide, rows[sound], along[sound], np.ones(int(sound.sum())))


def net_on_facets(
    mesh: TriangleMesh, facets: FlatFaces, mirrors: Sequence[Mirror], edge: float
) -> QuadMesh | None:
    """A net whose lines run along all creases and the border; None where none is even enough.

    Args:
        mesh: the surface.
        facets: its faces.
        mirrors: planes in which the net is its own mirror image.
        edge: wanted edge length, on average.
    """
    net = _woven(mesh, facets, mirrors, edge)
    if net is not None:
        # Inside a face that is no grid edges are shorter than along its sides.
        other = _woven(mesh, facets, mirrors, edge * edge / net.mean_edge)
        if other is not None and abs(other.mean_edge - edge) < abs(net.mean_edge - edge):
            return other
    return net


def _woven(
    mesh: TriangleMesh, facets: FlatFaces, mirrors: Sequence[Mirror], edge: float
) -> QuadMesh | None:
    """Edges along creases and border are about as long as given."""
    counts = counts_along(facets, edge, facets.crossing(mesh, mirrors))
    if counts is None:
        return None
    weave = _Weave.of(facets, counts[0])
    for sides, ways in zip(facets.sides, counts[1], strict=True):
        weave.face(sides, ways)
    try:
        net = quad_mesh(_places(mesh, facets, weave, edge), weave.quads)[0]
        net = symmetric_net(net, mirrors, edge)
    except InputError:
        return None
    uneven = net.edge_lengths.min() < _EVEN * net.mean_edge
    return None if uneven or flipped(net).any() else net


@dataclass(eq=False)
class _Weave:
    """Quads as they are added, by numbers of vertices.

    Attributes:
        chains: vertices along each chain; ``count`` of all vertices so far.
        quads: four vertices each.
        marks: how many vertices and quads there were before the first face, and after each.
    """

    chains: list[list[int]]
    count: int
    quads: list[list[int]] = field(default_factory=list)
    marks: list[tuple[int, int]] = field(default_factory=list)

    @classmethod
    def of(cls, facets: FlatFaces, counts: list[int]) -> _Weave:
        """Number the vertices along chains: first their ends."""
        ends = sorted({int(v) for chain in facets.chains for v in chain.vertices[[0, -1]]})
        number = {vertex: k for k, vertex in enumerate(ends)}
        weave = cls([], len(ends))
        for chain, count in zip(facets.chains, counts, strict=True):
            first, last = (number[int(chain.vertices[k])] for k in (0, -1))
            weave.chains.append([first, *weave.fresh(count - 1), last])
        weave.marks.append((weave.count, 0))
        return weave

    def fresh(self, count: int) -> list[int]:
        """Numbers of new vertices."""
        self.count += count
        return list(range(self.count - count, self.count))

    def face(self, sides: list[Side], ways: list[int]) -> None:
        """The quads of one face."""
        lines = [self._line(side) for side in sides]
        if not ways:
            self._grid(*lines)
        else:
            middle = self.fresh(1)
            starts = [line[ways[k - 1]] for k, line in enumerate(lines)]
            inner = [
                [start, *self.fresh(count - 1), *middle]
                for start, count in zip(starts, ways, strict=True)
            ]
            for k, line in enumerate(lines):
                self._grid(
                    line[: ways[k - 1] + 1],
                    inner[k],
                    inner[k - 1][::-1],
                    lines[k - 1][ways[k - 2] :],
                )
        self.marks.append((self.count, len(self.quads)))

    def _line(self, side: Side) -> list[int]:
        runs = [self.chains[n] if forwards else self.chains[n][::-1] for n, forwards in side]
        return [runs[0][0], *(vertex for run in runs for vertex in run[1:])]

    def _grid(self, below: list[int], right: list[int], above: list[int], left: list[int]) -> None:
        """Quads between four lines, counter-clockwise one after the other."""
        rows = [below]
        for k in range(1, len(right) - 1):
            rows.append([left[-1 - k], *self.fresh(len(below) - 2), right[k]])
        rows.append(above[::-1])
        for low, high in pairwise(rows):
            for k in range(len(below) - 1):
                self.quads.append([low[k], low[k + 1], high[k + 1], high[k]])


def _places(mesh: TriangleMesh, facets: FlatFaces, weave: _Weave, edge: float) -> FloatArray:
    """(V, 3) vertices: evenly along chains, and spread out over each face."""
    places = np.zeros((weave.count, 3))
    for chain, vertices in zip(facets.chains, weave.chains, strict=True):
        points = mesh.points[chain.vertices]
        along = np.append(0.0, np.linalg.norm(np.diff(points, axis=0), axis=1).cumsum())
        evenly = np.linspace(0.0, along[-1], len(vertices))
        for k in range(3):
            places[vertices, k] = np.interp(evenly, along, points[:, k])
    for face, triangles in enumerate(facets.triangles):
        (first, begin), (last, end) = weave.marks[face : face + 2]
        used, quads = np.unique(np.array(weave.quads[begin:end]), return_inverse=True)
        free = (used >= first) & (used < last)
        if free.any():
            evened = len(facets.sides[face]) != 4
            places[used] = spread(
                *(mesh, triangles, places[used], free, quads.reshape(-1, 4), edge), evened=evened
            )
    return places
