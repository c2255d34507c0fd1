"""Nets sampled from one or several parametric surfaces along their own parameter lines."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from solver.errors import InputError
from solver.mesh.border import Border, fitted, straight_corners
from solver.mesh.closest import TriangleSurface
from solver.mesh.coarsen import compact
from solver.mesh.connectivity import BoolArray
from solver.mesh.grid import grid_faces, grid_mesh
from solver.mesh.intersections import crossing_faces
from solver.mesh.join import joined
from solver.mesh.mirror import size_of
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.option import number_within, one_of
from solver.sentence import Sentence

# Points on a line by which lengths are measured; lines of each family for that; points a side for
# an area of which no more than the size is wanted.
_FINE = 129
_LINES = 9
_COARSE = 25
# Points a side of the triangles that stand for a surface while a net is fitted to its border.
_STAND_IN = 49
# Sides shorter than this part of the surface are points; ends nearer than this are the same.
_POINT = 1e-6
# Sides of neighbouring surfaces that differ by less than this part of their length are one.
_SAME_SIDE = 1e-3
_MOST = 2_000_000


@dataclass(frozen=True, eq=False)
class ParametricSurface:
    """A rectangle of parameters on a surface, or what a border leaves of it.

    Attributes:
        evaluate: (k,) u and (k,) v to (k, 3) points, in the model's unit.
        u: first and last u.
        v: first and last v.
        inside: (k,) u and (k,) v to (k,) flags where a border trims the rectangle, else None.
        border: closed polylines (n, 3) along all borders of a trimmed surface.
        name: what messages call it.
        cut: whether the first u, last u, first v, last v are cuts through a larger surface.
        foot: (k, 3) points near the surface to the nearest ones on it, where that is known exactly.
    """

    evaluate: Callable[[FloatArray, FloatArray], FloatArray]
    u: tuple[float, float]
    v: tuple[float, float]
    inside: Callable[[FloatArray, FloatArray], BoolArray] | None = None
    border: tuple[FloatArray, ...] = ()
    name: str = "face"
    foot: Callable[[FloatArray], FloatArray] | None = None
    cut: tuple[bool, bool, bool, bool] = (False, False, False, False)

    @property
    def area(self) -> float:
        """About its area, that of the whole rectangle, from a coarse grid."""
        points = self.grid(np.linspace(*self.u, _COARSE), np.linspace(*self.v, _COARSE))
        one, two = points[1:, 1:] - points[:-1, :-1], points[1:, :-1] - points[:-1, 1:]
        return 0.5 * float(np.linalg.norm(np.cross(one, two), axis=2).sum())

    def part(self, u: tuple[float, float], v: tuple[float, float]) -> ParametricSurface:
        """The surface between fractions 0 to 1 of its parameters.

        Raises:
            InputError: fractions that do not rise from 0 towards 1.
        """
        ends = []
        for name, (low, high), (first, last) in (("u", self.u, u), ("v", self.v, v)):
            if not 0 <= first < last <= 1:
                raise InputError(
                    f"{name} part: expected 0 <= first < last <= 1, got {first:g} and {last:g}"
                )
            ends.append((low + first * (high - low), low + last * (high - low)))
        cut = (u[0] > 0, u[1] < 1, v[0] > 0, v[1] < 1)
        return replace(self, u=ends[0], v=ends[1], cut=cut)

    def scaled(self, factor: float) -> ParametricSurface:
        """The same in another unit, with the same parameters."""
        evaluate, foot = self.evaluate, self.foot
        return replace(
            self,
            evaluate=lambda u, v: factor * evaluate(u, v),
            border=tuple(factor * line for line in self.border),
            foot=None if foot is None else lambda points: factor * foot(points / factor),
        )

    def points(self, u: FloatArray, v: FloatArray) -> FloatArray:
        """(m, n, 3) points at (m, n) parameters."""
        return np.asarray(self.evaluate(u.ravel(), v.ravel())).reshape(*u.shape, 3)

    def grid(self, u: FloatArray, v: FloatArray) -> FloatArray:
        """(m, n, 3) points where (m,) lines u cross (n,) lines v."""
        return self.points(*np.meshgrid(u, v, indexing="ij"))


@dataclass(frozen=True, eq=False)
class SampledNet:
    """A net sampled from surfaces.

    Attributes:
        mesh: the net.
        remarks: what a user should know about it, in plain words.
    """

    mesh: QuadMesh
    remarks: tuple[str, ...]


def sampled(
    surfaces: Sequence[ParametricSurface],
    *,
    counts: tuple[int, int] | None = None,
    edge: float | None = None,
    spacing: str = "length",
    outside: str = "snap",
) -> SampledNet:
    """Sample one net from surfaces, joined where they meet.

    Args:
        surfaces: at least one; neighbours share whole sides.
        counts: vertices along u and v of the first; what shares a side takes its count over.
        edge: wanted edge length instead, in the model's unit.
        spacing: ``length`` for edges of even length, ``parameter`` for equal steps of u and v.
        outside: what becomes of faces that a border cuts: ``snap`` moves border vertices onto it,
            ``drop`` keeps whole faces only.

    Raises:
        InputError: no or too small counts, a side that shrinks to a point, a net that meets itself.
    """
    if not surfaces:
        raise InputError("faces: expected at least one, got none; select a face")
    one_of("spacing", spacing, ("length", "parameter"))
    one_of("outside", outside, ("snap", "drop"))
    outlines = [_Outline(surface) for surface in surfaces]
    numbers = _counts(outlines, counts, edge)
    blend = len(surfaces) > 1 and spacing == "length"
    made, remarks = [], []
    for outline, count in zip(outlines, numbers, strict=True):
        mesh, words = _one(outline, count, spacing, blend, outside)
        _refuse_crossing(mesh, outline.surface.name)
        made.append(mesh)
        remarks += words
    mesh = made[0]
    if len(made) > 1:
        mesh, left = joined(made, [outline.size for outline in outlines])
        parts = int(mesh.connectivity.components.max()) + 1
        if parts > 1:
            remarks.append(
                Sentence("{} separate parts: not all faces meet along whole sides", parts)
            )
        elif left:
            remarks.append(Sentence("{} vertices lie beside a seam and could not be joined", left))
    return SampledNet(mesh, tuple(remarks))


class _Outline:
    """The four sides of a surface: v = first (0), u = last (1), v = last (2), u = first (3)."""

    def __init__(self, surface: ParametricSurface) -> None:
        self.surface = surface
        u, v = (np.linspace(*ends, _FINE) for ends in (surface.u, surface.v))
        few = (np.linspace(*surface.u, _LINES), np.linspace(*surface.v, _LINES))
        self.along = (surface.grid(u, few[1]), surface.grid(few[0], v).transpose(1, 0, 2))
        if not all(np.isfinite(lines).all() for lines in self.along):
            raise InputError(f"{surface.name}: has no points at some parameters; trim it there")
        self.size = size_of(self.along[0].reshape(-1, 3))
        self.closed = tuple(
            bool(np.abs(lines[0] - lines[-1]).max() < _POINT * self.size) for lines in self.along
        )
        self.steps = tuple(np.linalg.norm(np.diff(x, axis=0), axis=2) for x in self.along)
        self.lengths = tuple(float(step.sum(axis=0).mean()) for step in self.steps)
        self._refuse_points()

    def _refuse_points(self) -> None:
        for k, (name, ends) in enumerate((("v", self.surface.v), ("u", self.surface.u))):
            lengths = self.steps[k].sum(axis=0)
            for end in (0, -1):
                if lengths[end] < _POINT * self.size:
                    raise InputError(
                        f"{self.surface.name}: its side {name} = {ends[end]:.4g} shrinks to a "
                        f"point; stop short of it (a smaller part of {name}, such as 0.05 to "
                        "0.95), or give triangles of it (STL)"
                    )

    def side(self, k: int) -> FloatArray:
        """(9, 3) points at even lengths along a side."""
        direction, end = k % 2, 0 if k in (0, 3) else -1
        run = np.append(0.0, np.cumsum(self.steps[direction][:, end]))
        place = np.linspace(0, run[-1], _LINES)
        line = self.along[direction][:, end]
        return np.stack([np.interp(place, run, line[:, c]) for c in range(3)], axis=1)

    def parameters(self, direction: int, count: int, spacing: str, end: int | None) -> FloatArray:
        """(count,) parameters in a direction, even in the mean or along one end's side."""
        ends = (self.surface.u, self.surface.v)[direction]
        whole = count + self.closed[direction]
        result = np.linspace(*ends, whole)
        if spacing == "length":
            steps = self.steps[direction]
            steps = steps.mean(axis=1) if end is None else steps[:, end]
            run = np.append(0.0, np.cumsum(steps))
            result = np.interp(np.linspace(0, run[-1], whole), run, np.linspace(*ends, _FINE))
            result[0], result[-1] = ends
        return result[:count]


def _counts(
    outlines: list[_Outline], counts: tuple[int, int] | None, edge: float | None
) -> list[tuple[int, int]]:
    """Vertices along u and v of each surface; directions joined by shared sides have one count."""
    if (counts is None) == (edge is None):
        raise InputError("sampling: expected either counts or an edge length; give one")
    if edge is not None:
        number_within("edge", edge)
    label = _directions(outlines)
    chosen: dict[int, int] = {}
    for surface, outline in enumerate(outlines):
        for direction in (0, 1):
            key, closed = label[2 * surface + direction], outline.closed[direction]
            if key in chosen:
                continue
            if counts is not None:
                count = int(counts[direction])
            else:
                mean = np.mean([
                    outlines[k // 2].lengths[k % 2] for k in range(len(label)) if label[k] == key
                ])  # fmt: skip
                count = max(round(float(mean) / float(edge or 1.0)) + 1 - closed, 2 + closed)
            if count < 2 + closed:
                raise InputError(
                    f"sampling: expected at least {2 + closed} vertices along "
                    f"{'uv'[direction]} of {outline.surface.name}, got {count}; take more"
                )
            chosen[key] = count
    result = [(chosen[label[2 * k]], chosen[label[2 * k + 1]]) for k in range(len(outlines))]
    if sum(m * n for m, n in result) > _MOST:
        raise InputError(f"sampling: more than {_MOST} vertices; take fewer or a longer edge")
    return result


def _directions(outlines: list[_Outline]) -> list[int]:
    """A label for each surface's u and v; the same where shared sides join them."""
    label = list(range(2 * len(outlines)))
    sides = [[outline.side(k) for k in range(4)] for outline in outlines]
    for a in range(len(outlines)):
        for b in range(a + 1, len(outlines)):
            for k in range(4):
                for other in range(4):
                    if _same_side(sides[a][k], sides[b][other]):
                        old, new = label[2 * b + other % 2], label[2 * a + k % 2]
                        label = [new if entry == old else entry for entry in label]
    return label


def _same_side(one: FloatArray, two: FloatArray) -> bool:
    length = float(np.linalg.norm(np.diff(one, axis=0), axis=1).sum())
    return any(float(np.abs(one - other).max()) < _SAME_SIDE * length for other in (two, two[::-1]))


def _one(
    outline: _Outline, count: tuple[int, int], spacing: str, blend: bool, outside: str
) -> tuple[QuadMesh, list[str]]:
    """Net of one surface, and what there is to say about it."""
    surface, (m, n) = outline.surface, count
    u = outline.parameters(0, m, spacing, None)[:, None] + np.zeros(n)
    v = outline.parameters(1, n, spacing, None)[None, :] + np.zeros((m, 1))
    if blend:
        # Every side evenly by its own length, so that neighbours meet vertex by vertex.
        share_u, share_v = ((x - a) / (b - a) for x, (a, b) in ((u, surface.u), (v, surface.v)))
        first, last = (outline.parameters(0, m, spacing, end)[:, None] for end in (0, -1))
        left, right = (outline.parameters(1, n, spacing, end)[None, :] for end in (0, -1))
        u, v = (1 - share_v) * first + share_v * last, (1 - share_u) * left + share_u * right
    mesh = grid_mesh(surface.points(u, v), *outline.closed)
    if surface.inside is None:
        return mesh, []
    # Centres across a seam need the parameter beyond it.
    ahead_u = np.append(u, u[:1] + surface.u[1] - surface.u[0], axis=0) if outline.closed[0] else u
    across = 0.5 * (ahead_u[1:] + ahead_u[:-1])
    ahead_v = v
    if outline.closed[1]:
        ahead_v = np.append(v, v[:, :1] + surface.v[1] - surface.v[0], axis=1)
    up = 0.5 * (ahead_v[:, 1:] + ahead_v[:, :-1])
    rows, columns = across.shape[0], up.shape[1]
    middle_u = across[:, np.minimum(np.arange(columns), n - 1)]
    middle_v = up[np.minimum(np.arange(rows), m - 1), :]
    if outside == "drop":
        corners = surface.inside(u.ravel(), v.ravel())
        kept = corners[mesh.faces].all(axis=1)
    else:
        kept = surface.inside(middle_u.ravel(), middle_v.ravel())
    if not kept.any():
        raise InputError(f"{surface.name}: no quad lies inside its border; take a finer sampling")
    held = np.zeros((m, n), dtype=bool)
    for k, line in enumerate((held[0], held[-1], held[:, 0], held[:, -1])):
        line[:] |= surface.cut[k]
    held = held.ravel()[np.unique(mesh.faces[kept])]
    mesh = compact(mesh, mesh.faces[kept])
    return (mesh, []) if outside == "drop" else _snapped(surface, mesh, held)


def _snapped(
    surface: ParametricSurface, mesh: QuadMesh, held: BoolArray
) -> tuple[QuadMesh, list[str]]:
    """The net with its border vertices on the border of the surface."""
    fine = surface.grid(np.linspace(*surface.u, _STAND_IN), np.linspace(*surface.v, _STAND_IN))
    quads = grid_faces(_STAND_IN, _STAND_IN)
    triangles = TriangleSurface(
        fine.reshape(-1, 3), np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    )
    mesh, dropped = fitted(mesh, triangles, Border.of_polylines(surface.border), held)
    if surface.foot is not None:
        mesh = mesh.with_vertices(surface.foot(mesh.vertices))
    words: list[str] = []
    if dropped:
        words.append(
            Sentence(
                "{}: {} quads at the border had no room and were left out", surface.name, dropped
            )
        )
    if straight := straight_corners(mesh):
        words.append(
            Sentence("{}: {} quads at the border have a straight corner", surface.name, straight)
        )
    return mesh, words


def _refuse_crossing(mesh: QuadMesh, name: str) -> None:
    pairs = crossing_faces(mesh)
    if len(pairs):
        one, two = pairs[0]
        raise InputError(
            f"{name}: the sampled net meets itself at {len(pairs)} places, first where quads {one} "
            f"and {two} cross; split the face there, sample a part of it or more finely"
        )
