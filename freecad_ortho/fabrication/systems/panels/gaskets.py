"""Gaskets of framed panels as solids: strips between panel and pressure plate, panel and beam."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from freecad_ortho.fabrication.bodies import Prism
from freecad_ortho.fabrication.material import Material
from freecad_ortho.fabrication.part import Measures, Part
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.beams.frames import Frames
from freecad_ortho.fabrication.systems.beams.geometry import BeamGeometry
from freecad_ortho.fabrication.systems.panels.silicone import strips
from solver.mesh.quadmesh import FloatArray, unit_rows

# Part of the edge cover that a gasket takes, and the narrowest that is one, mm.
_OF_COVER, _LEAST = 0.8, 3.0
# Gaskets are not drawn where less than this is left for them, mm.
_THINNEST = 0.5
# Cosine of the angle to a member from which on a side does not run along it.
_ALONG = 0.99
# Ethylene propylene diene rubber, as glazing gaskets are made of: EN 12365.
RUBBER = Material("EPDM", 1250.0, 8.0, 8.0, 5.0)


@dataclass(frozen=True, eq=False)
class GasketPlanes:
    """Planes that gaskets lie against, one an edge: square to the edge's own upright.

    Attributes:
        heights: (E,) of the planes above the edges, mm; NaN where there is none.
        half: half the width of what lies there, mm.
        ends: (E, 2) where it begins and ends along the edges, mm; None for where gaskets do anyway.
        slopes: (E, 4) change of that across it, in the order of ``Cuts.slope``.
    """

    heights: FloatArray
    half: float
    ends: FloatArray | None = None
    slopes: FloatArray | None = None


@dataclass(frozen=True, eq=False)
class Gaskets:
    """What gaskets of panels are made between.

    Attributes:
        site: the net.
        frames: planes of the members along the edges.
        plates: lower sides of the pressure plates.
        beams: upper sides of the beams, None without any.
        joint: between two panels, mm.
        cover: of panels under plates, mm.
    """

    site: Site
    frames: Frames
    plates: GasketPlanes
    beams: GasketPlanes | None
    joint: float
    cover: float

    def parts(
        self, panels: Sequence[Part], rims: Sequence[tuple[FloatArray, FloatArray]]
    ) -> Iterator[Part]:
        """The gaskets of panels with these lower and upper outlines (N, 2).

        Named after the panel and its side, ``P0012-s1-above``. They are mitred at its corners, and
        as thick all along as the room is where it is least; what opens beside that they fill when
        pressed.
        """
        for panel, (under, over) in zip(panels, rims, strict=True):
            yield from self._along(panel, over, panel.thickness, self.plates)
            if self.beams is not None:
                yield from self._along(panel, under, 0.0, self.beams)

    def _along(
        self, panel: Part, outline: FloatArray, side: float, seats: GasketPlanes
    ) -> Iterator[Part]:
        """Those along the sides of an outline at a level of the panel, mm, up or down to seats."""
        width = min(_OF_COVER * self.cover, seats.half - self.joint / 2)
        if width < _LEAST:
            return
        where, sign = ("above", 1.0) if side > 0 else ("below", -1.0)
        rings = strips(outline, width)
        placed = [
            panel.origin - self.site.shift + ring @ panel.frame[:2] + side * panel.frame[2]
            for ring in rings
        ]
        edges = [self._edge(panel, points, seats) for points in placed]
        for number, (ring, points, edge) in enumerate(zip(rings, placed, edges, strict=True)):
            if edge is None:
                continue
            room = [sign * self._up_to(seats, edge, points, panel)]
            # At its mitres, and a bit before, a strip reaches the members of the next ones.
            ahead = width * unit_rows((points[1] - points[0])[None])
            for other, end, inward in (
                (number - 1, points[[0, 3]], ahead),
                ((number + 1) % len(rings), points[[1, 2]], -ahead),
            ):
                beside = edges[other]
                apart = np.linalg.norm(placed[other][:, None] - end, axis=2).min()
                if beside is not None and apart < width:
                    near = np.vstack([end, end + inward])
                    room.append(sign * self._up_to(seats, beside, near, panel))
            thick = float(np.concatenate(room).min())
            ring = self._within(seats, edge, ring, points)
            if thick >= _THINNEST and len(ring) > 2:
                levels = sorted((side, side + sign * thick))
                yield _gasket(panel, f"{panel.name}-s{number + 1}-{where}", ring, levels, width)

    def _within(
        self, seats: GasketPlanes, edge: int, ring: FloatArray, points: FloatArray
    ) -> FloatArray:
        """What of a strip, (4, 2) of a pattern and (4, 3) in place, lies where its seat is."""
        if seats.ends is None or seats.slopes is None:
            return ring
        arms = points - self.site.mesh.vertices[self.site.mesh.connectivity.edges[edge, 0]]
        ahead, left = arms @ self.frames.along[edge], arms @ self.frames.left[edge]
        on_left = bool(left.mean() > 0)
        first, last = seats.slopes[edge, [3, 2] if on_left else [0, 1]]
        start, end = seats.ends[edge]
        rows = np.column_stack([ring, ahead - start - first * np.abs(left)])
        rows = _kept(np.column_stack([rows, end - last * np.abs(left) - ahead]), 2)
        return _kept(rows, 3)[:, :2]

    def _up_to(self, seats: GasketPlanes, edge: int, points: FloatArray, panel: Part) -> FloatArray:
        """(N,) how far along the panel's normal the plane of a seat is from points (N, 3), mm."""
        up = self.frames.up[edge]
        start = self.site.mesh.vertices[self.site.mesh.connectivity.edges[edge, 0]]
        return np.asarray((seats.heights[edge] - (points - start) @ up) / (panel.frame[2] @ up))

    def _edge(self, panel: Part, ring: FloatArray, seats: GasketPlanes) -> int | None:
        """The edge whose member a strip (4, 3) of a panel lies at."""
        net, mesh = self.site.mesh.connectivity, self.site.mesh
        own = net.face_edges[panel.face]
        faces = net.edge_faces[own].ravel()
        near = np.unique(net.face_edges[faces[faces >= 0]])
        near = near[np.isfinite(seats.heights[near])]
        middle, along = ring[:2].mean(axis=0), ring[1] - ring[0]
        arms = middle - mesh.vertices[net.edges[near, 0]]
        ahead = np.einsum("ek,ek->e", arms, self.frames.along[near])
        across = np.abs(np.einsum("ek,ek->e", arms, self.frames.left[near]))
        turned = np.abs(self.frames.along[near] @ along) / np.linalg.norm(along)
        fits = (across < seats.half) & (turned > _ALONG)
        fits &= (ahead > 0) & (ahead < mesh.edge_lengths[near])
        if not fits.any():
            return None
        return int(near[np.where(fits, across, np.inf).argmin()])


def _kept(rows: FloatArray, column: int) -> FloatArray:
    """Corners of a convex outline, and of what it leaves where a column is not negative."""
    found = []
    for one, two in zip(rows, np.roll(rows, -1, axis=0), strict=True):
        if one[column] >= 0:
            found.append(one)
        if (one[column] >= 0) != (two[column] >= 0):
            share = one[column] / (one[column] - two[column])
            found.append(one + share * (two - one))
    return np.array(found).reshape(-1, rows.shape[1])


def beam_seats(beams: BeamGeometry | None) -> GasketPlanes | None:
    """The upper sides of beams."""
    if beams is None:
        return None
    up = beams.up(1)
    ends = up[:, None] * beams.slopes + np.column_stack([0 * beams.lengths, beams.lengths])
    ends = ends + beams.cuts.middle * [1.0, -1.0]
    heights = np.where(beams.built, up, np.nan)
    return GasketPlanes(heights, beams.section_half, ends, beams.cuts.slope)


def _gasket(
    panel: Part, name: str, ring: FloatArray, levels: Sequence[float], width: float
) -> Part:
    """A gasket over a convex outline (N, 2) of a panel between two of its levels, mm."""
    low, high = levels
    body = Prism(ring, low, high)
    length = float(np.linalg.norm(ring - np.roll(ring, -1, axis=0), axis=1).max())
    return replace(
        panel,
        name=name,
        kind="gasket",
        body=body,
        pattern=None,
        length=length,
        width=width,
        thickness=high - low,
        area=body.volume / (high - low),
        volume=body.volume,
        material=RUBBER,
        measures=Measures(),
        weighed=None,
        assembly="",
        note="",
    )
