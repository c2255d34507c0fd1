"""The third layer of lamellas as parts, and what holds it on the others: angles, or bolts."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from freecad_ortho.fabrication.cleat import Cleat
from freecad_ortho.fabrication.fasteners import Fasteners, gathered
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.lamellas.axis import Lamella
from freecad_ortho.fabrication.systems.lamellas.bolted import layer_bolt, splice_bolts
from freecad_ortho.fabrication.systems.lamellas.cleat_parts import cleat_bolts, cleat_part
from freecad_ortho.fabrication.systems.lamellas.crossings import Crossing, at_vertices
from freecad_ortho.fabrication.systems.lamellas.parts import cut, lamella_part
from freecad_ortho.fabrication.systems.lamellas.splice_parts import splice_part
from freecad_ortho.fabrication.systems.lamellas.splices import pieces_of
from freecad_ortho.fabrication.systems.lamellas.third import ThirdLayer
from freecad_ortho.fabrication.systems.lamellas.ties import ties_of
from solver.mesh.quadmesh import FloatArray

# Bolts whose grips differ by less, mm, are of one; names that a message shows.
_STEP, _SHOWN = 0.5, 5
_Placed = tuple[FloatArray, FloatArray, tuple[str, ...]]


@dataclass(frozen=True, eq=False)
class Above:
    """What is built of a third layer, nothing where there is none.

    Attributes:
        grid: the lamellas below, with holes for its angles.
        pieces: its own, with their holes.
        ties: the angles that hold it.
        parts: of all of it: lamellas, splices, angles.
        bolts: that hold it.
        bolted: vertices at which one bolt passes all layers.
        lost: names of angles without room.
        report: numbers.
    """

    grid: list[Lamella]
    pieces: Sequence[Lamella] = ()
    ties: Sequence[Cleat] = ()
    parts: tuple[Part, ...] = ()
    bolts: tuple[Fasteners, ...] = ()
    bolted: frozenset[int] = frozenset()
    lost: Sequence[str] = ()
    report: dict[str, Any] = field(default_factory=dict)

    def words(self) -> list[str]:
        """What a user should know."""
        count, said = len(self.ties) + len(self.lost), []
        if self.lost:
            shown = ", ".join(self.lost[:_SHOWN]) + (" ..." if len(self.lost) > _SHOWN else "")
            said.append(
                f"lamellas: {len(self.lost)} of {count} angles that hold the third layer are left "
                f"out, as cleats, edges or bend lines leave them no room: {shown}; smaller holes "
                "or wider lamellas may make room"
            )
        bent = [piece.name for piece in self.pieces if piece.aim == "free"]
        if bent:
            said.append(
                "lamellas: the diagonals of this net are no geodesics, so the third layer's "
                "patterns are curved as they come; optimise for web for straight ones"
            )
        return said


def build_above(
    site: Site,
    layer: ThirdLayer,
    grid: list[Lamella],
    standing: bool,
    taken: Collection[int],
) -> Above:
    """Build a third layer on lamellas.

    Args:
        site: the net.
        layer: the lamellas along diagonals.
        grid: pieces of those of both families.
        standing: whether these stand.
        taken: vertices that have cleats of their own.

    Raises:
        InputError: holes that do not fit, or no room for splices.
    """
    settings, count = layer.settings, len(site.mesh.vertices)
    pieces, splices = pieces_of(layer.lamellas, settings, layer.crossed if standing else ())
    ties: list[Cleat] = []
    lost: list[str] = []
    if standing:
        ties, pieces, grid, lost = ties_of(pieces, grid, frozenset(taken), settings, count)
    met = _crossings(pieces, grid, standing)
    cuts = [cut(each, here, settings) for each, here in zip(pieces, met, strict=True)]
    lamellas = tuple(lamella_part(made, site, settings.position) for made in cuts)
    plates = tuple(splice_part(splice, site, settings) for splice in splices)
    bolts = splice_bolts(site, splices, plates, settings)
    if standing:
        bolts += cleat_bolts(ties, site, (), ())
    else:
        bolts += _triple_bolts(site, pieces, met, grid, layer)
    bolted = frozenset() if standing else {each.vertex for row in met for each in row}
    report = {
        "diagonals": len(layer.lamellas),
        "diagonal_family": ("first", "second")[layer.family],
        "diagonal_level_mm": settings.lifted,
        "triple_crossings": sum(bool(each.also) for row in met for each in row),
        "ties": len(ties),
    }
    return Above(
        grid,
        pieces,
        ties,
        lamellas + plates + tuple(cleat_part(tie, site) for tie in ties),
        bolts,
        frozenset(bolted),
        lost,
        report,
    )


def _crossings(
    pieces: Sequence[Lamella], grid: Sequence[Lamella], standing: bool
) -> list[list[Crossing]]:
    """Where pieces of the layer cross lamellas of the grid, in the order of their stations."""
    below = at_vertices(grid)
    found: list[list[Crossing]] = [[] for _ in pieces]
    for vertex, here in at_vertices(pieces).items():
        there = below.get(vertex, [])
        if not there:
            continue
        names = [grid[index].name for index, _ in there]
        other, at = there[0]
        for index, station in here:
            one = pieces[index].ribbon.strip.normals[station]
            cosine = abs(float(one @ grid[other].ribbon.strip.normals[at]))
            angle = float(np.degrees(np.arccos(min(cosine, 1.0))))
            found[index].append(
                Crossing(vertex, station, names[0], angle, None, not standing, tuple(names[1:]))
            )
    return [sorted(row, key=lambda crossing: crossing.station) for row in found]


def _triple_bolts(
    site: Site,
    pieces: Sequence[Lamella],
    met: Sequence[Sequence[Crossing]],
    grid: Sequence[Lamella],
    layer: ThirdLayer,
) -> tuple[Fasteners, ...]:
    """Bolts through three lying layers, through two where one is left out, their heads above."""
    settings = layer.settings
    bolt = layer_bolt(settings.hole, site.material)
    if bolt is None:
        return ()
    below = at_vertices(grid)
    by_plates: dict[float, list[_Placed]] = {}
    for piece, row in zip(pieces, met, strict=True):
        strip = piece.ribbon.strip
        for crossing in row:
            point, normal = strip.points[crossing.station], strip.normals[crossing.station]
            depths = [
                float((grid[index].ribbon.strip.points[station] - point) @ normal)
                for index, station in below[crossing.vertex]
            ]
            lowest = max(depths, key=abs)
            out = -np.copysign(1.0, lowest) * normal
            plates = abs(lowest) + settings.thickness
            plates = float(np.ceil(plates / _STEP - 1e-6) * _STEP)
            under = point + site.shift + (settings.thickness / 2 + bolt.washer) * out
            names = (piece.name, crossing.other, *crossing.also)
            by_plates.setdefault(plates, []).append((under, -out, names))
    return tuple(
        gathered(
            bolt,
            bolt.through(plates),
            plates + 2 * bolt.washer,
            2,
            True,
            "crossings of three layers",
            placed,
        )
        for plates, placed in sorted(by_plates.items())
    )
