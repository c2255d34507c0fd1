"""Where beams end at the border of the surface: cut by the plane of its tangent and the axes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.beams.frames import Frames
from freecad_ortho.fabrication.systems.beams.geometry import Cuts
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.lines import ParameterLine
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
    def of(cls, site: Site, frames: Frames) -> BorderEnds | None:
        """Those of a site; None where it has no border."""
        trimming = site.trimming
        if trimming is None:
            return None
        edges = site.mesh.connectivity.edges
        count = len(edges)
        places = np.tile([0.0, 1.0], (count, 1))
        within = np.zeros(count, dtype=bool)
        lean, slant = np.zeros((2, count, 2))
        for edge, spans in trimming.spans.items():
            within[edge] = True
            places[edge] = max(spans, key=lambda span: span[1] - span[0])
            for end in np.flatnonzero(places[edge] != [0.0, 1.0]).tolist():
                place = float(places[edge, end])
                first, second = site.axes.offsets[edges[edge]]
                axis = (1 - place) * first + place * second
                along = trimming.along(edge, place)
                normal = np.cross(frames.left[edge] if along is None else along, axis)
                straight, sideways = normal @ frames.along[edge], -normal @ frames.left[edge]
                lean[edge, end] = axis @ frames.along[edge] / (axis @ frames.up[edge])
                flattest = max(abs(straight), abs(sideways) / _STEEPEST)
                slant[edge, end] = -sideways / np.copysign(flattest, straight)
        return cls(within, places != [0.0, 1.0], places, lean, slant)

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

    def runs(self, line: ParameterLine, built: BoolArray) -> list[ParameterLine]:
        """What is left of a line, piece by piece, of the edges (E,) that have beams."""
        edges, vertices = line.edges, line.vertices
        if line.closed:
            gaps = np.flatnonzero(~built[edges])
            if not len(gaps):
                return [line]
            turn = -(int(gaps[0]) + 1)
            edges = np.roll(edges, turn)
            vertices = np.roll(vertices, turn)
            vertices = np.append(vertices, vertices[0])
        breaks = np.flatnonzero(~built[edges])
        bounds = zip(np.r_[0, breaks + 1].tolist(), np.r_[breaks, len(edges)].tolist(), strict=True)
        return [
            replace(line, vertices=vertices[low : high + 1], edges=edges[low:high], closed=False)
            for low, high in bounds
            if high > low
        ]

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
