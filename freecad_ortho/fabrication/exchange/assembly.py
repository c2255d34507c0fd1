"""Putting up a structure: in which order, what each part weighs, what meets at a node, and where.

Parts are put up ring by ring from the feet or the border on, or line by line: each stands there or
on what stands already. What neither reaches begins at its lowest vertex. Nodes come before the
beams that are bolted to them, panels when the beams around them stand, what holds panels after
these, splices after what they join.
"""

from __future__ import annotations

import heapq
from collections import Counter, defaultdict
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from freecad_ortho.fabrication.exchange.assembly_page import NodeArm, assembly_page
from freecad_ortho.fabrication.exchange.facets import facets
from freecad_ortho.fabrication.fasteners import Fasteners
from freecad_ortho.fabrication.part import Part, part_names
from freecad_ortho.fabrication.production import Production
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.tables import write_table
from solver.mesh.quadmesh import FloatArray

SEQUENCE_COLUMNS = (
    *("step", "name", "kind", "ring", "family", "line", "stands_on", "mass_kg"),
    *("x_mm", "y_mm", "z_mm", "placed_kg"),
)
BOOK_COLUMNS = (
    *("node", "ring", "order", "parts", "ends", "towards", "right_side_to"),
    *("angle_deg", "slope_deg"),
)
SURVEY_COLUMNS = ("point", "east_m", "north_m", "height_m")

Rank = tuple[int, ...]

# Which kinds go up before which others at the same place; all others are beams, or like them.
_FEET, _NODES, _BEAMS, _PANELS, _HOLDERS, _COVERS = range(6)
_TRADES = {
    "foot": _FEET,
    "foot-plate": _FEET,
    "node": _NODES,
    **dict.fromkeys(("panel", "bent panel", "patch", "louvre"), _PANELS),
    **dict.fromkeys(("pressure-plate", "adapter"), _HOLDERS),
    "cap": _COVERS,
}


@dataclass(frozen=True, eq=False)
class AssemblyStep:
    """One part that is put up.

    Attributes:
        part: which.
        held: names of the parts that stand already and meet it at a vertex, or that it joins.
    """

    part: Part
    held: tuple[str, ...]


def write_assembly(
    path: Path, production: Production, project: str, say: Callable[[float], None]
) -> None:
    """Write the two sequences, the node book and the points to be surveyed, and a page to print.

    Args:
        path: folder to make.
        production: of the structure.
        project: its name, the heading of the page.
        say: called with the fraction done; may raise to stop.

    Raises:
        OSError: a file cannot be written.
    """
    path.mkdir()
    structure = production.structure
    parts = structure.parts
    rings = rings_of(structure.site, parts)
    joined = bolted_to(structure.fasteners)
    centres = _centres(structure.parts, lambda done: say(0.8 * done))
    for name, ranks in (
        ("by-ring", ranks_by_ring(structure.parts, rings)),
        ("by-line", ranks_by_line(structure.parts, structure.site, rings)),
    ):
        steps = sequence(parts, ranks, rings, joined)
        if name == "by-ring":
            (path / "assembly.html").write_text(
                _page(steps, production, rings, project), encoding="utf-8"
            )
        rows = _sequence(steps, production, rings, centres)
        write_table(path / f"sequence-{name}.csv", SEQUENCE_COLUMNS, rows)
        say(0.9)
    write_table(path / "node-book.csv", BOOK_COLUMNS, _book(production, rings))
    write_table(path / "survey.csv", SURVEY_COLUMNS, _survey(production))


def rings_of(site: Site, parts: Sequence[Part]) -> list[int]:
    """Edges from each vertex to what a structure stands on.

    That are its feet; without any, the border of what is built, which is not the net's where that
    overhangs. What neither reaches is counted from its lowest vertex.
    """
    net = site.mesh.connectivity
    neighbours: dict[int, list[int]] = defaultdict(list)
    for one, other in net.edges.tolist():
        neighbours[one].append(other)
        neighbours[other].append(one)
    rings = [-1] * len(site.mesh.vertices)
    built = {vertex for part in parts for vertex in part.vertices}
    seeds = {v for part in parts if _trade(part) == _FEET for v in part.vertices}
    seeds = seeds or {
        vertex
        for vertex in built
        if net.boundary_vertices[vertex] or not built.issuperset(neighbours[vertex])
    }
    lowest = np.argsort(site.mesh.vertices[:, 2], kind="stable").tolist()
    first = [vertex for vertex in lowest if vertex in built]
    for begun in (sorted(seeds), *([vertex] for vertex in [*first, *lowest])):
        ahead, ring = [vertex for vertex in begun if rings[vertex] < 0], 0
        while ahead:
            for vertex in ahead:
                rings[vertex] = ring
            ahead = sorted({k for v in ahead for k in neighbours[v] if rings[k] < 0})
            ring += 1
    return rings


def ranks_by_ring(parts: Sequence[Part], rings: Sequence[int]) -> list[Rank]:
    """What is put up first has the least: parts by the furthest of their vertices' rings."""
    found: list[Rank] = []
    for number, owner in enumerate(_owners(parts)):
        part = parts[owner]
        here = [rings[vertex] for vertex in part.vertices] or [0]
        found.append((max(here), _trade(part), min(here), owner, number))
    return found


def ranks_by_line(parts: Sequence[Part], site: Site, rings: Sequence[int]) -> list[Rank]:
    """Parts by their parameter lines; those on none by the last line that begins them."""
    first: dict[int, int] = {}
    lines: dict[tuple[str, int], int] = {}
    for number, line in enumerate(site.lines.all):
        lines.setdefault((line.family, line.number), number)
        for vertex in line.vertices.tolist():
            first.setdefault(vertex, number)
    found: list[Rank] = []
    for number, owner in enumerate(_owners(parts)):
        part = parts[owner]
        place = max((first.get(vertex, 0) for vertex in part.vertices), default=0)
        if part.line is not None:
            place = lines.get((part.family, part.line), place)
        here = [rings[vertex] for vertex in part.vertices] or [0]
        found.append((place, _trade(part), max(here), min(here), owner, number))
    return found


def bolted_to(fasteners: Sequence[Fasteners]) -> dict[str, set[str]]:
    """Names of the parts that share a bolt with each part."""
    found: dict[str, set[str]] = defaultdict(set)
    for each in fasteners:
        for names in each.joins:
            for name in names:
                found[name].update(other for other in names if other != name)
    return found


def sequence(
    parts: Sequence[Part],
    ranks: Sequence[Rank],
    rings: Sequence[int],
    joined: Mapping[str, Collection[str]] | None = None,
) -> list[AssemblyStep]:
    """The parts in the order of their ranks, but none before it stands on something.

    Args:
        parts: all that are put up.
        ranks: one a part, its number last.
        rings: of the vertices.
        joined: names of the parts that those without a vertex, as splices, are bolted to: they come
            when all of these stand.
    """
    touching: dict[int, list[int]] = defaultdict(list)
    for number, part in enumerate(parts):
        for vertex in part.vertices:
            touching[vertex].append(number)
    below = [_carriers(number, parts, touching) for number in range(len(parts))]
    for number, owner in enumerate(_owners(parts)):
        below[number] |= {owner} - {number}
    holders = _joined(parts, joined or {})
    for number, others in holders.items():
        below[number] |= others
    carried: dict[int, list[int]] = defaultdict(list)
    for number, carriers in enumerate(below):
        for other in carriers:
            carried[other].append(number)
    waiting, standing = set(range(len(parts))), set[int]()
    ready = [
        ranks[number]
        for number, part in enumerate(parts)
        if not part.vertices or min(rings[vertex] for vertex in part.vertices) == 0
    ]
    heapq.heapify(ready)
    steps = []
    while waiting:
        if ready:
            rank = heapq.heappop(ready)
        else:
            # Parts that touch nothing that stands, as where some lines are built alone.
            rank = min(ranks[number] for number in waiting if not below[number])
        number = rank[-1]
        if number not in waiting or below[number]:
            continue
        beside = {k for vertex in parts[number].vertices for k in touching[vertex]}
        near = (beside | holders.get(number, set())) & standing
        held = tuple(parts[k].name for k in sorted(near))
        steps.append(AssemblyStep(parts[number], held))
        waiting.discard(number)
        standing.add(number)
        for other in carried[number]:
            below[other].discard(number)
            if other in holders and not below[other]:
                heapq.heappush(ready, ranks[other])
        for other in beside & waiting:
            heapq.heappush(ready, ranks[other])
    return steps


def _joined(parts: Sequence[Part], joined: Mapping[str, Collection[str]]) -> dict[int, set[int]]:
    """For parts without a vertex, the numbers of those with one that they are bolted to."""
    numbers = {part.name: number for number, part in enumerate(parts) if part.vertices}
    return {
        number: {numbers[name] for name in joined.get(part.name, ()) if name in numbers}
        for number, part in enumerate(parts)
        if not part.vertices
    }


def _trade(part: Part) -> int:
    return _TRADES.get(part.kind, _BEAMS)


def _owners(parts: Sequence[Part]) -> list[int]:
    """For each part the number of the one it goes up with: plates with the beam that they end."""
    numbers = {part.name: number for number, part in enumerate(parts)}
    return [numbers.get(part.name.split("-")[0], k) for k, part in enumerate(parts)]


def _carriers(number: int, parts: Sequence[Part], touching: dict[int, list[int]]) -> set[int]:
    """What a panel, or what holds it, lies on: earlier trades along an edge of it."""
    part = parts[number]
    trade = _trade(part)
    if trade < _PANELS:
        return set()
    met = Counter(other for vertex in part.vertices for other in touching[vertex])
    return {
        other
        for other, times in met.items()
        if times > 1 and _BEAMS <= _trade(parts[other]) < trade
    }


def _centres(parts: Sequence[Part], say: Callable[[float], None]) -> dict[str, FloatArray]:
    """Centre of gravity (3,) of each part in the structure's own coordinates, mm."""
    found = {}
    for number, part in enumerate(parts):
        if number % 16 == 0:
            say(number / len(parts))
        corners = facets(part).triangles
        base = corners[0, 0]
        arms = corners - base
        weights = np.einsum("tk,tk->t", arms[:, 0], np.cross(arms[:, 1], arms[:, 2]))
        centre = base + weights @ arms.sum(axis=1) / 4 / weights.sum()
        found[part.name] = part.origin + centre @ part.frame
    return found


def _sequence(
    steps: Sequence[AssemblyStep],
    production: Production,
    rings: Sequence[int],
    centres: dict[str, FloatArray],
) -> list[list[object]]:
    rows: list[list[object]] = []
    placed = 0.0
    for number, step in enumerate(steps, start=1):
        part = step.part
        placed += part.mass
        centre = production.structure.place.points(centres[part.name])
        rows.append(
            [
                *(number, part.name, part.kind),
                max((rings[vertex] for vertex in part.vertices), default=""),
                *(part.family, "" if part.line is None else part.line, " ".join(step.held)),
                *(f"{part.mass:.3f}", *(f"{value:.3f}" for value in centre), f"{placed:.3f}"),
            ]
        )
    return rows


def _book(production: Production, rings: Sequence[int]) -> list[list[object]]:
    """What meets at each node, counter-clockwise seen from the tip of its axis."""
    # Of what goes on ahead from here the right side looks clockwise, else the other way.
    along: dict[tuple[int, int], list[tuple[str, str, int]]] = defaultdict(list)
    for part in production.structure.parts:
        if part.face is not None or len(part.vertices) < 2:
            continue
        pairs = list(zip(part.vertices, part.vertices[1:], strict=False))
        for k, (one, other) in enumerate(pairs):
            along[one, other].append((part.name, "start" if k == 0 else "through", -1))
            end = "end" if k == len(pairs) - 1 else "through"
            along[other, one].append((part.name, end, 1))
    names = part_names("N", len(production.structure.site.mesh.vertices))
    rows: list[list[object]] = []
    for node in production.nodes:
        count = len(node.neighbours)
        for k, other in enumerate(node.neighbours):
            found = along[node.vertex, other]
            side = names[node.neighbours[(k + found[0][2]) % count]] if found else ""
            rows.append(
                [
                    *(node.name, rings[node.vertex], k + 1),
                    *(" ".join(each[0] for each in found), " ".join(each[1] for each in found)),
                    *(names[other], side),
                    *(f"{node.angles_deg[k]:.4f}", f"{node.slopes_deg[k]:.4f}"),
                ]
            )
    return rows


def _page(
    steps: Sequence[AssemblyStep], production: Production, rings: Sequence[int], project: str
) -> str:
    """Pictures of the steps ring by ring, and the node book."""
    order = [step.part for step in steps]
    stages: list[int] = []
    for part in order:
        # What has no vertex, as a splice, is in the picture of what it joined last.
        last = stages[-1] if stages else 0
        stages.append(max((rings[vertex] for vertex in part.vertices), default=last))
    book: dict[str, list[NodeArm]] = defaultdict(list)
    turn: dict[str, float] = defaultdict(float)
    for row in _book(production, rings):
        name, angle = str(row[0]), float(str(row[BOOK_COLUMNS.index("angle_deg")]))
        parts, ends, towards = (str(row[k]) for k in (3, 4, 5))
        words = ", ".join(
            f"{part} {end}" for part, end in zip(parts.split(), ends.split(), strict=True)
        )
        book[name].append(NodeArm(towards, words, turn[name]))
        turn[name] += angle
    return assembly_page(order, stages, [step.held for step in steps], list(book.items()), project)


def _survey(production: Production) -> list[list[object]]:
    """The vertices of the net at which parts meet, on site."""
    structure, datum = production.structure, production.workshop.datum
    in_model = structure.place.less(-structure.file_origin)
    points = datum.points(in_model, np.array([node.point for node in production.nodes]))
    return [
        [node.name, *(f"{value:.5f}" for value in point)]
        for node, point in zip(production.nodes, points.tolist(), strict=True)
    ]
