"""Where beams end at the border of the surface: cut by the plane of its tangent and the axes.

Beside an edge beam they end before it: parallel to its side in plan, along the axes upwards, so far
back that none of their four edges comes nearer than the clearance.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.beams.blocks import (
    beyond_end,
    blocks_of,
    cut_before,
    free_stretch,
    mean_normal,
)
from freecad_ortho.fabrication.systems.beams.frames import Frames
from freecad_ortho.fabrication.systems.beams.geometry import Cuts
from freecad_ortho.fabrication.systems.edge_beam.geometry import EdgeGeometry
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray

# A border that runs along a beam cuts it no more slanted than this, mm along per mm across.
_STEEPEST = 12.0
# Signs of ``Cuts.slope`` of a plane whose station rises to the right.
_SIGNS = np.array([1.0, -1.0, 1.0, -1.0])


@dataclass(frozen=True, eq=False)
class BorderEnds:
    """Ends of beams at a border, one row an edge.

    Attributes:
        within: (E,) true where something of the edge is within the border.
        cut: (E, 2) true where its beam ends at the border.
        places: (E, 2) where it begins and ends along the edge, 0 to 1.
        lean: (E, 2) how far the cut moves along the edge per mm up.
        slant: (E, 2) and per mm to the right.
    """

    within: BoolArray
    cut: BoolArray
    places: FloatArray
    lean: FloatArray
    slant: FloatArray

    @classmethod
    def of(
        cls, site: Site, frames: Frames, levels: tuple[float, float], half: float
    ) -> BorderEnds | None:
        """Those of a site; None where it has neither a border nor an edge beam.

        Args:
            site: the net.
            frames: planes of the beams.
            levels: lower and upper one along the axes, mm.
            half: half the width of the beams, mm.
        """
        edge_beam = site.geometry_of("edge-beam", EdgeGeometry)
        if site.trimming is None and edge_beam is None:
            return None
        ends = cls.at_border(site, frames)
        return ends if edge_beam is None else ends._before(edge_beam, site, frames, levels, half)

    @classmethod
    def at_border(cls, site: Site, frames: Frames) -> BorderEnds:
        """Ends at the border alone, all within where there is none."""
        edges = site.mesh.connectivity.edges
        count = len(edges)
        places = np.tile([0.0, 1.0], (count, 1))
        lean, slant = np.zeros((2, count, 2))
        trimming = site.trimming
        if trimming is None:
            every = np.ones(count, dtype=bool)
            return cls(every, np.zeros((count, 2), dtype=bool), places, lean, slant)
        within = np.zeros(count, dtype=bool)
        for edge, spans in trimming.spans.items():
            within[edge] = True
            places[edge] = max(spans, key=lambda span: span[1] - span[0])
            for end in np.flatnonzero(places[edge] != [0.0, 1.0]).tolist():
                place = float(places[edge, end])
                axis = _axis(site, edge, place)
                along = trimming.along(edge, place)
                normal = np.cross(frames.left[edge] if along is None else along, axis)
                lean[edge, end] = _lean(frames, edge, axis)
                slant[edge, end] = _slant(frames, edge, normal)
        return cls(within, places != [0.0, 1.0], places, lean, slant)

    def _before(
        self,
        edge_beam: EdgeGeometry,
        site: Site,
        frames: Frames,
        levels: tuple[float, float],
        half: float,
    ) -> BorderEnds:
        """These, or the ends before an edge beam where it is in the way."""
        blocks = blocks_of(edge_beam, site, frames, levels, half)
        within, cut, places = self.within.copy(), self.cut.copy(), self.places.copy()
        lean, slant = self.lean.copy(), self.slant.copy()
        lengths = site.mesh.edge_lengths
        for edge in sorted(blocks.keys() & set(np.flatnonzero(within).tolist())):
            spans = [(0.0, 1.0)] if site.trimming is None else site.trimming.spans[edge]
            free = free_stretch(spans, blocks[edge], float(lengths[edge]))
            if free is None:
                within[edge] = False
                continue
            span, bounds = free
            places[edge] = span
            for end in (0, 1):
                cut[edge, end] = span[end] != float(end)
                if bounds[end] is None:
                    continue
                own = beyond_end(blocks[edge], bounds, end)
                lean[edge, end] = _lean(frames, edge, _axis(site, edge, span[end]))
                slant[edge, end] = _slant(frames, edge, mean_normal(own, end))
                middle = cut_before(own, end, lean[edge, end], slant[edge, end])
                places[edge, end] = middle / lengths[edge]
        return BorderEnds(within, cut, places, lean, slant)

    def lengths(self, edge_lengths: FloatArray, cuts: Cuts, half: float) -> FloatArray:
        """(E,) what is left of each beam between what its ends take, mm."""
        taken = cuts.setback(half).reshape(-1, 4)[:, [[0, 3], [1, 2]]].max(axis=2)
        taken = np.where(self.cut, half * np.abs(self.slant), taken)
        span = self.places[:, 1] - self.places[:, 0]
        return np.asarray(span * edge_lengths - taken.sum(axis=1))

    def applied(
        self, frames: Frames, cuts: Cuts, edge_lengths: FloatArray, half: float
    ) -> tuple[Frames, Cuts]:
        """Frames and cuts with these ends; beams that would meet beyond the border keep apart.

        Args:
            frames: of the beams.
            cuts: at the vertices.
            edge_lengths: (E,) mm.
            half: half the width of the beams, mm.
        """
        back = np.stack([self.places[:, 0], 1.0 - self.places[:, 1]], axis=1)
        middle = back * edge_lengths[:, None]
        border = Cuts(middle, self.slant[:, [0, 1, 1, 0]] * _SIGNS)
        ends = np.array([0, 1, 1, 0])
        mitre = cuts.setback(half)
        near = ((mitre > border.setback(half))[:, [[0, 3], [1, 2]]]).any(axis=2) & self.cut
        apart = np.maximum(middle, np.where(near, cuts.middle, 0.0))
        sides = np.maximum(border.setback(half), np.where(near[:, ends], mitre, -np.inf))
        joined = Cuts(apart, (sides - apart[:, ends]) / half)
        slope = np.where(self.cut & ~near, self.lean * frames.rise[:, None], frames.slope)
        return replace(frames, slope=slope), joined.where(self.cut, cuts)

    def end_of(self, site: Site, edge: int, vertex: int) -> tuple[FloatArray, FloatArray] | None:
        """Point and offset where the beam of an edge ends towards a vertex; None at the vertex."""
        ends: IntArray = site.mesh.connectivity.edges[edge]
        end = int(ends[1] == vertex)
        if not self.cut[edge, end]:
            return None
        share = np.array([1.0 - self.places[edge, end], self.places[edge, end]])
        return share @ site.mesh.vertices[ends], share @ site.axes.offsets[ends]


def stub_words(names: Sequence[str], least: float) -> tuple[str, ...]:
    """A message where short beams are left out."""
    if not names:
        return ()
    shown = ", ".join(names[:5]) + (" ..." if len(names) > 5 else "")
    return (
        f"beams: left out at the border what is shorter than {least:g} mm: {shown}, {len(names)} "
        "in all; a smaller least length keeps it",
    )


def _axis(site: Site, edge: int, place: float) -> FloatArray:
    """(3,) the axis at a place along an edge."""
    first, second = site.axes.offsets[site.mesh.connectivity.edges[edge]]
    return np.asarray((1 - place) * first + place * second)


def _lean(frames: Frames, edge: int, axis: FloatArray) -> float:
    """How far an axis moves along an edge per mm up."""
    return float(axis @ frames.along[edge] / (axis @ frames.up[edge]))


def _slant(frames: Frames, edge: int, normal: FloatArray) -> float:
    """How far a cut with this normal moves along an edge per mm to the right."""
    straight, sideways = normal @ frames.along[edge], -normal @ frames.left[edge]
    flattest = max(abs(straight), abs(sideways) / _STEEPEST)
    return float(-sideways / np.copysign(flattest, straight))
