"""Beams that run through as parts: folded plates in pieces, with the holes of their joints."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad_ortho.fabrication.folded import folded_plate
from freecad_ortho.fabrication.part import Part, part_names
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.beams.border import BorderEnds
from freecad_ortho.fabrication.systems.beams.fins import FinPlates
from freecad_ortho.fabrication.systems.beams.geometry import BeamGeometry, Splice
from freecad_ortho.fabrication.systems.beams.lines import chain, line_name
from freecad_ortho.fabrication.systems.beams.parts import line_part, name_after, names_across
from freecad_ortho.fabrication.systems.beams.sections import Section
from freecad_ortho.fabrication.systems.beams.spliced import (
    Stretch,
    bolt_holes,
    drilled_chain,
    drilled_pattern,
    joints,
    shortened,
    stretches,
)
from freecad_ortho.fabrication.systems.beams.web_holes import web_holes
from solver.mesh.lines import ParameterLine
from solver.mesh.quadmesh import FloatArray


class SplicedBeams:
    """Makes the pieces of folded plates that run through, and what joins them."""

    def __init__(
        self,
        site: Site,
        geometry: BeamGeometry,
        section: Section,
        covers: FinPlates,
        border: BorderEnds | None,
    ) -> None:
        self.site, self.geometry, self.covers, self.border = site, geometry, covers, border
        self.ends = site.mesh.connectivity.edges
        self.across, self.nodes = names_across(site), part_names("N", len(site.mesh.vertices))
        self.bored = web_holes(geometry, section, self.ends)
        # Splices keep away from the joints of a beam's ends and from the border.
        self.room = (geometry.lengths >= covers.splice_room) & ~geometry.meeting.any(axis=1)
        self.cut = np.zeros(self.ends.shape, dtype=bool) if border is None else border.cut
        self.room &= ~self.cut.any(axis=1)
        # By edge the name of its piece, where that is bolted to a node.
        self.names: dict[int, str] = {}

    def made(
        self, lines: tuple[ParameterLine, ...], every: int
    ) -> tuple[tuple[Part, ...], tuple[Splice, ...]]:
        """Return the pieces of lines and their splices.

        ``every`` is after how many nodes there is a splice, 0 for none.

        Raises:
            InputError: sizes that do not fit, or a flat pattern that overlaps itself.
        """
        parts: list[Part] = []
        splices: list[Splice] = []
        for line in lines:
            whole = chain(self.site, self.geometry, line, self.covers.web / 2, None, self.border)
            name = name_after(line_name(line), parts)
            cuts = joints(line, every, self.room)
            made = stretches(whole, line, cuts, self.covers.clearance)
            names = [f"{name}-{k + 1}" if cuts else name for k in range(len(made))]
            # The first joint of a ring joins its last piece to its first.
            before, after = (names[-1:] + names, names) if line.closed else (names, names[1:])
            splices += [
                Splice(f"{name}-s{k + 1}", int(line.edges[cut]), (before[k], after[k]))
                for k, cut in enumerate(cuts)
            ]
            parts += [
                self._piece(stretch, line, own) for stretch, own in zip(made, names, strict=True)
            ]
        return tuple(parts), tuple(splices)

    def _piece(self, stretch: Stretch, line: ParameterLine, name: str) -> Part:
        """One folded plate with its holes."""
        covers = self.covers
        self.names |= dict.fromkeys(stretch.edges[[0, -1]].tolist(), name)
        taken = (
            [0.0, 0.0] if stretch.chain.ends is None else [self._taken(stretch, k) for k in (0, 1)]
        )
        seated = shortened(stretch, (taken[0], taken[1]))
        plate = folded_plate(seated.chain)
        run = replace(line, vertices=seated.vertices, edges=seated.edges, closed=False)
        part = line_part(
            self.site, self.geometry, run, seated.chain, plate, name, self.across, self.nodes
        )
        holes = [*bolt_holes(seated, covers), *self._end_holes(stretch, taken[0])]
        if not holes:
            return part
        body = drilled_chain(seated, plate, holes, covers.bolt.hole)
        assert part.pattern is not None
        pattern = drilled_pattern(part.pattern, holes, covers.bolt.hole)
        return replace(part, body=body, pattern=pattern, volume=body.volume)

    def _end(self, stretch: Stretch, end: int) -> tuple[int, int]:
        """The edge at an end of a stretch, and which of its ends that is."""
        edge = int(stretch.edges[-end])
        return edge, int(self.ends[edge, 1] == stretch.vertices[-end])

    def _taken(self, stretch: Stretch, end: int) -> float:
        """How far a piece ends before the vertex there, less than 0 beyond it; mm."""
        vertex = int(stretch.vertices[-end])
        place = self._end(stretch, end)
        if vertex < 0 or self.cut[place]:
            return 0.0
        if not self.covers.running.ends[place]:
            return float(self.geometry.cuts.middle[place])
        return -self.covers.web if self.geometry.hub_radii[vertex] > 0 else 0.0

    def _end_holes(self, stretch: Stretch, taken: float) -> list[tuple[int, FloatArray]]:
        """The holes of ends that are bolted to fins or arms, as ``bolt_holes`` has them.

        ``taken`` is how far the piece begins behind its first vertex, mm.
        """
        found = []
        for number, edge in enumerate(stretch.edges.tolist()):
            if edge not in self.bored:
                continue
            ahead = float(stretch.chain.frame[number, 0] @ self.geometry.frame[edge, 0]) > 0
            for hole in self.bored[edge]:
                along, up = hole.centre.tolist()
                along = along if ahead else float(self.geometry.lengths[edge]) - along
                found.append((number, np.array([along - (0.0 if number else taken), up])))
        return found
