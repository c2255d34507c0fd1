"""Beams that run through as parts: folded plates in pieces, with the holes of their splices."""

from __future__ import annotations

from dataclasses import replace

from freecad_ortho.fabrication.folded import folded_plate
from freecad_ortho.fabrication.part import Part, part_names
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.beams.border import BorderEnds
from freecad_ortho.fabrication.systems.beams.fins import FinPlates
from freecad_ortho.fabrication.systems.beams.geometry import BeamGeometry, Splice
from freecad_ortho.fabrication.systems.beams.lines import chain, line_name
from freecad_ortho.fabrication.systems.beams.parts import line_part, name_after, names_across
from freecad_ortho.fabrication.systems.beams.spliced import (
    bolt_holes,
    drilled_chain,
    drilled_pattern,
    extended,
    joints,
    stretches,
)
from solver.mesh.lines import ParameterLine


def spliced_beams(
    site: Site,
    geometry: BeamGeometry,
    covers: FinPlates,
    every: int,
    lines: tuple[ParameterLine, ...],
    border: BorderEnds | None,
) -> tuple[tuple[Part, ...], tuple[Splice, ...]]:
    """Return the pieces of folded plates that run through, and what joins them.

    ``every`` is after how many nodes there is a splice, 0 for none.

    Raises:
        InputError: sizes that do not fit, or a flat pattern that overlaps itself.
    """
    across, nodes = names_across(site), part_names("N", len(site.mesh.vertices))
    room = geometry.lengths >= covers.splice_room
    if border is not None:
        room &= ~border.cut.any(axis=1)
    parts: list[Part] = []
    splices: list[Splice] = []
    for line in lines:
        whole = chain(site, geometry, line, covers.web / 2, None, border)
        name = name_after(line_name(line), parts)
        cuts = joints(line, every, room)
        made = stretches(whole, line, cuts, covers.clearance)
        names = [f"{name}-{k + 1}" if cuts else name for k in range(len(made))]
        # The first joint of a ring joins its last piece to its first.
        before, after = (names[-1:] + names, names) if line.closed else (names, names[1:])
        splices += [
            Splice(f"{name}-s{k + 1}", int(line.edges[cut]), (before[k], after[k]))
            for k, cut in enumerate(cuts)
        ]
        for stretch, own in zip(made, names, strict=True):
            long = extended(stretch, geometry.hub_radii > 0, covers.web)
            plate = folded_plate(long.chain)
            run = replace(line, vertices=long.vertices, edges=long.edges, closed=False)
            part = line_part(site, geometry, run, long.chain, plate, own, across, nodes)
            holes = bolt_holes(long, covers)
            if holes:
                body = drilled_chain(long, plate, holes, covers.bolt.hole)
                assert part.pattern is not None
                pattern = drilled_pattern(part.pattern, holes, covers.bolt.hole)
                part = replace(part, body=body, pattern=pattern, volume=body.volume)
            parts.append(part)
    return tuple(parts), tuple(splices)
