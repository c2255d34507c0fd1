"""Which parts stand together in an assembly of IFC: those of a system, of a line or of a ring."""

from __future__ import annotations

from freecad_ortho.fabrication.exchange.assembly import (
    ranks_by_line,
    ranks_by_ring,
    rings_of,
)
from freecad_ortho.fabrication.structure import Structure


def assembly_names(structure: Structure, by: str) -> dict[str, str]:
    """The name of the assembly of each part, by the names of parts; assemblies in their order.

    Args:
        structure: whose parts they are.
        by: "systems"; "lines", as ``sequence-by-line.csv`` goes, where parts on no line stand with
            the last one that begins at a vertex of theirs; "rings", as ``sequence-by-ring.csv``.
    """
    if by == "systems":
        return {
            part.name: system
            for system, result in structure.results.items()
            for part in result.parts
        }
    site, parts = structure.site, structure.parts
    rings = rings_of(site, parts)
    if by == "rings":
        ranks = ranks_by_ring(parts, rings)
        names = [f"ring {number}" for number in range(max(rings, default=0) + 1)]
    else:
        ranks = ranks_by_line(parts, site, rings)
        names = [f"line {line.family}{line.number}" for line in site.lines.all] or ["net"]
    ordered = sorted(range(len(parts)), key=lambda number: ranks[number][0])
    return {parts[number].name: names[ranks[number][0]] for number in ordered}
