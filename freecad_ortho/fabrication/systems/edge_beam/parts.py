"""Pieces of edge beams as parts: names, flat patterns, cuts, and the list of bends."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from freecad_ortho.fabrication.bevels import bevels_of
from freecad_ortho.fabrication.bodies import Body, Polyhedron
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.pattern import FlatPattern, texts_between
from freecad_ortho.fabrication.profiled import ProfiledBody
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.edge_beam.geometry import EdgeGeometry
from freecad_ortho.fabrication.systems.edge_beam.rolled import RolledEdge
from freecad_ortho.fabrication.systems.edge_beam.sections import EdgeSection
from freecad_ortho.fabrication.systems.system import Table
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray

_SQUARE = np.array([1.0, 0.0, 0.0])
# Columns of the list of bends, beside the piece and its length.
_BENDS = ("bend_deg", "plan_deg", "elevation_deg", "turn_deg")


def edge_parts(
    site: Site, geometry: EdgeGeometry, section: EdgeSection, stock: float | None
) -> tuple[tuple[Part, ...], Table]:
    """The parts, and the table of their bends.

    Args:
        site: the net.
        geometry: of the pieces.
        section: of all of them.
        stock: length that longer pieces are cut into, square, mm.
    """
    outer = geometry.section(section.profile())
    inner = geometry.section(section.profile(section.wall))
    counts = np.ones(len(outer), dtype=int)
    if stock is not None:
        spans = outer[:, 1, :, 0].max(axis=1) - outer[:, 0, :, 0].min(axis=1)
        counts = np.maximum(np.ceil(spans / stock), 1).astype(int)
    names = _names(geometry, counts)
    angles = bends(geometry)
    parts, rows = [], []
    number = 0
    for piece, count in enumerate(counts.tolist()):
        for share in range(count):
            rings, ends = _cut(outer[piece], inner[piece], geometry, piece, share, count)
            name, beside = names[number], _beside(names, geometry, counts, piece, share)
            parts.append(_part(site, geometry, section, piece, name, beside, rings, ends))
            last = share == count - 1
            found = angles[piece] if last else np.zeros(len(_BENDS))
            sizes = round(parts[-1].length, 3), beside[1]
            rows.append((name, section.words, *sizes, *np.round(found, 6).tolist()))
            number += 1
    return tuple(parts), edge_table(rows)


def edge_table(rows: Sequence[tuple[Any, ...]]) -> Table:
    """The list of parts: name, section, length, the next one, and the angles to it."""
    columns = ("name", "section", "length_mm", "next", *_BENDS)
    return Table("edge-beam.csv", columns, tuple(rows))


def bends(geometry: EdgeGeometry) -> FloatArray:
    """(N, 4) angles from each piece to the next, degrees.

    Between the two; of that in plan (to the left) and in elevation (up), seen from the piece; by
    which the next one's section is turned about it, to the right.
    """
    own, ahead = geometry.frame, geometry.frame[geometry.behind]
    along = np.einsum("nck,nk->nc", own, ahead[:, 0])
    up = np.einsum("nck,nk->nc", own, ahead[:, 1])
    whole = np.arctan2(np.linalg.norm(along[:, 1:], axis=1), along[:, 0])
    plan = np.arctan2(-along[:, 2], along[:, 0])
    elevation = np.arctan2(along[:, 1], np.hypot(along[:, 0], along[:, 2]))
    turn = np.arctan2(up[:, 2], up[:, 1])
    return np.asarray(np.degrees(np.column_stack([whole, plan, elevation, turn])))


def _names(geometry: EdgeGeometry, counts: IntArray) -> list[str]:
    """E1-001 for the first piece of the first way."""
    ways = np.repeat(geometry.way, counts)
    digits = max(3, len(str(len(ways))))
    first = np.searchsorted(ways, ways)
    return [
        f"E{way + 1}-{number - start + 1:0{digits}d}"
        for number, (way, start) in enumerate(zip(ways.tolist(), first.tolist(), strict=True))
    ]


def _beside(
    names: list[str], geometry: EdgeGeometry, counts: IntArray, piece: int, share: int
) -> tuple[str, str]:
    """Names of the parts before and after one of a piece's shares."""
    firsts = np.concatenate([[0], np.cumsum(counts)])
    here = int(firsts[piece]) + share
    before = here - 1 if share else int(firsts[geometry.before[piece] + 1]) - 1
    behind = here + 1 if share < counts[piece] - 1 else int(firsts[geometry.behind[piece]])
    return names[before], names[behind]


def _cut(
    outer: FloatArray,
    inner: FloatArray,
    geometry: EdgeGeometry,
    piece: int,
    share: int,
    count: int,
) -> tuple[tuple[FloatArray, FloatArray], FloatArray]:
    """Corners (2, 4, 3) outside and inside of a share of a piece, and how its ends (2, 3) stand."""
    ends = geometry.mitres[piece].copy()
    rings = outer.copy(), inner.copy()
    low, high = outer[0, :, 0].max(), outer[1, :, 0].min()
    bounds = low + (high - low) * np.arange(count + 1) / count
    for end, place in ((0, share), (1, share + 1)):
        if 0 < place < count:
            ends[end] = _SQUARE
            for ring in rings:
                ring[end, :, 0] = bounds[place]
    return rings, ends


def _part(
    site: Site,
    geometry: EdgeGeometry,
    section: EdgeSection,
    piece: int,
    name: str,
    beside: tuple[str, str],
    rings: tuple[FloatArray, FloatArray],
    ends: FloatArray,
) -> Part:
    outer, inner = rings
    # The middle plane: lower and upper corner at the start, then at the end.
    flat = np.stack([outer[:, [0, 1]], outer[:, [3, 2]]]).mean(axis=0).reshape(-1, 3)
    low = flat.min(axis=0)
    # Where the planes of the ends cross the middle of the upper side.
    middles = outer[:, 1:3].mean(axis=1)[:, 0] - low[0]
    body = section.body(outer - low, inner - low, middles, ends)
    pattern, origin = None, low
    if isinstance(section, RolledEdge):
        origin = low + section.lift
    if section.kind == "plate":
        assert isinstance(body, Polyhedron)
        pattern = _pattern(name, (flat - low)[[0, 2, 3, 1], :2], beside)
        pattern = replace(pattern, bevels=bevels_of(body), seen="right")
    length = float(np.ptp(outer[..., 0]))
    bought: dict[str, Any] = {}
    if isinstance(section, RolledEdge):
        bought = {"section": section.words, "weighed": section.weighed(middles, ends)}
    return Part(
        name=name,
        kind="edge-beam",
        body=body,
        origin=geometry.start[piece] + origin @ geometry.frame[piece] + site.shift,
        frame=geometry.frame[piece],
        pattern=pattern,
        length=length if pattern is None else float(pattern.size[0]),
        width=section.height,
        thickness=section.width if pattern is not None else section.wall,
        area=_skin(section, body, outer) if pattern is None else pattern.area,
        volume=body.volume,
        material=site.material,
        note="" if pattern is not None else _cut_words(section, ends),
        section_width=None if pattern is not None else section.width,
        **bought,
    )


def _skin(section: EdgeSection, body: Body, outer: FloatArray) -> float:
    """Outer surface of a bar without its ends, mm2."""
    return body.skin if isinstance(body, ProfiledBody) else section.skin(outer)


def _pattern(name: str, outline: FloatArray, beside: tuple[str, str]) -> FlatPattern:
    """The plate seen from its right side, with the names of those that it meets."""
    start, end = max(outline[[0, 3], 0]), min(outline[[1, 2], 0])
    length, height = np.ptp(outline, axis=0).tolist()
    room = texts_between(name, beside, (start, end), height / 2, (length, height))
    return FlatPattern(outline, *room)


def _cut_words(section: EdgeSection, ends: FloatArray) -> str:
    """How a tube is sawn: the tilt of its cuts from square, in elevation and in plan."""
    words = [
        f"{end}: elevation {math.degrees(math.atan(-normal[1] / normal[0])):.2f}, "
        f"plan {math.degrees(math.atan(-normal[2] / normal[0])):.2f} deg"
        for end, normal in zip(("start", "end"), ends, strict=True)
    ]
    return "; ".join([section.words, *words])
