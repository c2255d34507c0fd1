"""Bodies whose sides are ruled: plane, or swept by a straight line between two edges."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from freecad_ortho.fabrication.bezier import bernstein, blend, gauss, raised, through
from freecad_ortho.fabrication.bodies import Body, Loops, Polyhedron
from freecad_ortho.fabrication.ruled_sides import Bore, RuledSide, Side
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    import cadquery

# Corners at one end of a block that has more points than its corners.
_RING = {16: 4}
# Parts of a block that two bodies are told apart by where whole blocks do not tell.
_PARTS = 8


@dataclass(frozen=True, eq=False)
class RuledBody(Body):
    """A closed body of plane and ruled sides.

    Attributes:
        corners: (N, 3) corner points, mm.
        sides: corner numbers around each side, counter-clockwise seen from outside. A side of four
            corners may be ruled: straight lines join the edge from the first to the second corner
            with that from the fourth to the third. All others are plane.
        handles: inner control points (M, 3) of the edges that are Bezier curves, by their corners,
            the smaller number first; all other edges are straight.
        blocks: (6, 3) or (8, 3) corners of prisms that together hold the body, one end's, then the
            other's; (16, 3) with the control points of curved edges after them.
        sheets: further sides, cut from surfaces.
        bores: holes through ``sides``.
        cells: whether the blocks are the body: they share no more than sides, and straight lines
            between the corners of each side sweep it.
    """

    corners: FloatArray
    sides: tuple[Side, ...]
    handles: Mapping[tuple[int, int], FloatArray] = field(default_factory=dict)
    blocks: tuple[FloatArray, ...] = ()
    sheets: tuple[RuledSide, ...] = ()
    bores: tuple[Bore, ...] = ()
    cells: bool = False

    @property
    def in_cells(self) -> bool:
        """Whether the blocks are."""
        return self.cells

    def pieces(self) -> tuple[Polyhedron, ...]:
        """The blocks."""
        if not self.blocks:
            return super().pieces()
        found = []
        for block in self.blocks:
            half = _RING.get(len(block), len(block) // 2)
            sides = [(k, (k + 1) % half, (k + 1) % half + half, k + half) for k in range(half)]
            ends = [tuple(range(half, 2 * half)), tuple(reversed(range(half)))]
            # Hulls of another number of points are another shape to the clash check.
            loops: Loops = tuple([*ends, *sides][:: -1 if len(block) in _RING else 1])
            found.append(Polyhedron(block, loops))
        return tuple(found)

    def filling(self, finer: int = 1) -> tuple[Polyhedron, ...]:
        """The blocks, shorter where sides are no planes: so they hold the body more closely."""
        if all(sheet.rails is None for sheet in self.sheets):
            return self.pieces()
        kinds: dict[int, list[FloatArray]] = {}
        for block in self.blocks:
            kinds.setdefault(len(block), []).append(block)
        blocks = [
            part
            for count, some in kinds.items()
            for part in (_shorter(np.array(some), _PARTS * finer) if count in (8, *_RING) else some)
        ]
        return replace(self, blocks=tuple(blocks)).pieces()

    def seen_from(self, origin: FloatArray, frame: FloatArray) -> RuledBody:
        """The same body seen from an ``origin`` (3,), its axes the rows of ``frame`` (3, 3)."""

        def seen(points: FloatArray) -> FloatArray:
            return np.asarray((points - origin) @ frame.T)

        return replace(
            self,
            corners=seen(self.corners),
            handles={ends: seen(inner) for ends, inner in self.handles.items()},
            blocks=tuple(seen(block) for block in self.blocks),
            sheets=tuple(
                each if each.rails is None else replace(each, rails=seen(each.rails))
                for each in self.sheets
            ),
            bores=tuple(
                replace(each, start=seen(each.start), end=seen(each.end)) for each in self.bores
            ),
        )

    @cached_property
    def points(self) -> FloatArray:
        """(N, 3) corners and control points."""
        return np.concatenate([self.corners, *self.handles.values()])

    def rails(self, side: Side) -> tuple[FloatArray, FloatArray]:
        """(P, 3) twice: control points of a side's two edges that straight lines join."""
        a, b, c, d = side
        one, other = self.poles(a, b), self.poles(d, c)
        count = max(len(one), len(other))
        return raised(one, count), raised(other, count)

    def poles(self, start: int, end: int) -> FloatArray:
        """(P, 3) control points of an edge, straight or not, from one corner to the other."""
        inner = self.handles.get((min(start, end), max(start, end)))
        if inner is None:
            return self.corners[[start, end]]
        inner = inner if start < end else inner[::-1]
        return np.concatenate([self.corners[[start]], inner, self.corners[[end]]])

    @cached_property
    def volume(self) -> float:
        """Volume by the divergence theorem; quadrature that is exact for these sides."""
        origin = self.corners[0]
        total = self._volume_to_ruled(origin) + self._volume_to_planes(origin)
        alike: dict[tuple[tuple[int, ...], ...], list[RuledSide]] = {}
        for sheet in self.sheets:
            if sheet.rails is None:
                total += self._volume_to_plane_sheet(sheet, origin)
            else:
                curves = (len(curve) for loop in sheet.places for curve in loop)
                alike.setdefault((sheet.rails.shape, tuple(curves)), []).append(sheet)
        total += sum(_volume_to_surfaces(sheets, origin) for sheets in alike.values())
        bored = (np.linalg.norm(b.end - b.start) * b.diameter**2 for b in self.bores)
        return total - np.pi / 4 * float(sum(bored))

    def _volume_to_ruled(self, origin: FloatArray) -> float:
        """Volume of the cones from a point to the sides of four corners."""
        rails: dict[int, list[FloatArray]] = {}
        for side in self.sides:
            if len(side) == 4:
                pair = np.array(self.rails(side)) - origin
                rails.setdefault(pair.shape[1], []).append(pair)
        total = 0.0
        for count, pairs in rails.items():
            # A product of two curves and a slope.
            u, weight_u = gauss((3 * count) // 2)
            v, weight_v = gauss(2)
            values, slopes = bernstein(count, u)
            poles = np.array(pairs)
            one, two = np.moveaxis(values @ poles, 1, 0)
            along_one, along_two = np.moveaxis(slopes @ poles, 1, 0)
            for place, weight in zip(v, weight_v, strict=True):
                point = (1 - place) * one + place * two
                along = (1 - place) * along_one + place * along_two
                flux = np.einsum("sqk,sqk->q", point, np.cross(along, two - one))
                total += weight * float(weight_u @ flux)
        return total / 3

    def _volume_to_planes(self, origin: FloatArray) -> float:
        """Volume of the cones from a point to the sides that do not have four corners."""
        fans = [
            (side[0], side[k], side[k + 1])
            for side in self.sides
            if len(side) != 4
            for k in range(1, len(side) - 1)
        ]
        if not fans:
            return 0.0
        a, b, c = np.moveaxis(self.corners[np.array(fans)] - origin, 1, 0)
        return float(np.einsum("tk,tk->", a, np.cross(b, c))) / 6

    def _volume_to_plane_sheet(self, sheet: RuledSide, origin: FloatArray) -> float:
        """Volume of the cone from a point to a plane side with curved edges."""
        start = self.corners[sheet.loops[0][0]]
        area = np.zeros(3)
        for loop in sheet.loops:
            for here, after in zip(loop, loop[1:] + loop[:1], strict=True):
                poles = self.poles(here, after) - start
                t, weight = gauss(len(poles))
                values, slopes = bernstein(len(poles), t)
                area += 0.5 * weight @ np.cross(values @ poles, slopes @ poles)
        return float(area @ (start - origin)) / 3

    def solid(self) -> cadquery.Solid:
        """Build the closed solid from shared edges; no boolean operation, no sewing."""
        from freecad_ortho.fabrication.ruled_solid import ruled_solid

        return ruled_solid(self)


def _shorter(blocks: FloatArray, parts: int) -> FloatArray:
    """Parts of blocks (B, 8 or 16, 3) along their rails, each with as many points."""
    ends = blocks[:, :8].reshape(-1, 2, 4, 3)
    inner = blocks[:, 8:].reshape(len(blocks), 2, 2, -1, 3)
    # (block, level, side, P, 3) control points of the four rails.
    poles = np.stack(
        [
            np.concatenate([rail[:, :, :1], inner[:, :, k], rail[:, :, 1:]], axis=2)
            for k, rail in enumerate([ends[:, :, [0, 1]], ends[:, :, [3, 2]]])
        ],
        axis=2,
    )
    count = poles.shape[3]
    found = []
    for start in range(parts):
        places = (start + np.linspace(0, 1, count)) / parts
        part = through(blend(count, places) @ poles)
        around = np.concatenate([part[:, :, 0, [0, -1]], part[:, :, 1, [-1, 0]]], axis=2)
        handles = part[:, :, :, 1:-1].reshape(len(blocks), -1, 3)
        found.append(np.concatenate([around.reshape(-1, 8, 3), handles], axis=1))
    return np.stack(found, axis=1).reshape(-1, *blocks.shape[1:])


def _volume_to_surfaces(sheets: Sequence[RuledSide], origin: FloatArray) -> float:
    """Volume of the cones from a point to what loops cut from ruled surfaces of one shape.

    With f the flux through the surface a unit of u and v, Green's theorem makes of its integral the
    one of (integral of f over u) dv around the loops.
    """
    rails = np.array([sheet.rails for sheet in sheets]) - origin
    curves = [[curve for loop in sheet.places for curve in loop] for sheet in sheets]
    most = max(len(curve) for curve in curves[0])
    count = rails.shape[2]
    t, weight = gauss((3 * count * most) // 2 + 1)
    values, slopes = bernstein(most, t)
    poles = np.stack([raised(np.array(some), most) for some in zip(*curves, strict=True)], axis=1)
    place, change = values @ poles, slopes @ poles
    u, v = place[..., 0], place[..., 1]
    share, weight_u = gauss((3 * count) // 2)
    bernsteins, derivatives = bernstein(count, (u[..., None] * share).ravel())
    shape = (*u.shape, len(share), 2, 3)
    at, along = (
        np.einsum("nqp,nrpk->nqrk", each.reshape(len(sheets), -1, count), rails).reshape(shape)
        for each in (bernsteins, derivatives)
    )
    across = at[..., 1, :] - at[..., 0, :]
    both = v[..., None, None]
    point = at[..., 0, :] + both * across
    slope = (1 - both) * along[..., 0, :] + both * along[..., 1, :]
    flux = np.einsum("ncsqk,ncsqk->ncsq", point, np.cross(slope, across)) @ weight_u
    return float(np.einsum("ncs,ncs,ncs,s->", flux, u, change[..., 1], weight)) / 3
