"""Panels as parts: names, flat patterns with their marks, measures."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from freecad_ortho.fabrication.bevels import bevels_of
from freecad_ortho.fabrication.bodies import Body
from freecad_ortho.fabrication.material import Material
from freecad_ortho.fabrication.part import Measures, Part, part_names, piece_name
from freecad_ortho.fabrication.pattern import FlatPattern, Mark, fitted_text_size
from freecad_ortho.fabrication.plates import plate_part
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.panels.blunt import blunted, cut_off
from freecad_ortho.fabrication.systems.panels.build_ups import BuiltUp, layers_table
from freecad_ortho.fabrication.systems.panels.cassette import Cassette, Fold
from freecad_ortho.fabrication.systems.panels.cold import ColdBent, unbent
from freecad_ortho.fabrication.systems.panels.geometry import PanelGeometry, neighbours
from freecad_ortho.fabrication.systems.panels.slivers import PanelPieces, join_slivers
from freecad_ortho.fabrication.systems.panels.trimmed import Trimmed, trimmed, trimmed_pattern
from freecad_ortho.fabrication.systems.system import Table
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray


@dataclass(frozen=True, eq=False)
class PanelParts:
    """Panels, and what the border made of the faces.

    Attributes:
        parts: one a face or piece of one, in the order of the faces.
        layers: of these.
        left_out: narrow pieces by their names.
        joined: pieces that are part of others by theirs, with the names of these and how far they
            stand above the net there, mm.
        onto: (F,) the face of whose panel the sliver in a face is a part of; -1 for none.
        above: (F,) how far that stands above it, mm.
        blunt: by name, panels of which corners are cut off, and how far, mm.
    """

    parts: tuple[Part, ...]
    layers: tuple[BuiltUp, ...]
    left_out: dict[str, Trimmed]
    joined: dict[str, tuple[str, float]]
    onto: IntArray
    above: FloatArray
    blunt: dict[str, float]

    @property
    def table(self) -> Table:
        """The list of layers."""
        return layers_table([part.name for part in self.parts], self.layers)


def panel_parts(
    site: Site,
    geometry: PanelGeometry,
    thickness: float,
    measures: Sequence[Measures],
    least_width: float = 0.0,
    join: bool = False,
    formed: ColdBent | Fold | None = None,
    loose: BoolArray | None = None,
) -> PanelParts:
    """Return one part a face, or what the border leaves of it.

    Args:
        site: the net.
        geometry: corners of the panels.
        thickness: of the plates, mm.
        measures: of the panel in each face.
        least_width: pieces at the border that are narrower are left out, mm,
        join: or part of their neighbours where they fit on.
        formed: the faces where panels are bent into them, or how edges are folded. Bent ones with
            other than four corners, or whose layers stand back, are drawn flat; those too small
            for folds stay so.
        loose: (F,) faces with fewer than two beams under their panel: there pieces count as narrow
            up to twice the width, of glass up to four times it.

    Raises:
        InputError: layers that are set back too far.
    """
    faces = site.mesh.faces
    least = np.full(len(faces), least_width)
    if loose is not None:
        # What little of it the border leaves would lie on nothing, which is the worse for what
        # has to bear all around.
        least[loose] *= 2 if site.material.plate_limits is None else 4
    plates, pieces, blunt = _plates(site, geometry, thickness, least, join)
    names = part_names("P", len(faces))
    left_out = {name: piece for name, (_, piece) in pieces.narrow.items()}
    joined = {name: (names[face], high) for name, (face, high) in pieces.joined.items()}
    onto, above = pieces.covered
    made = [_formed(plate, geometry, thickness, formed) for plate in plates]
    parts = tuple(
        plate_part(
            site,
            plate.name,
            "panel",
            body,
            (origin, geometry.planes.frame[plate.face]),
            pattern,
            thickness,
            vertices=tuple(faces[plate.face].tolist()),
            face=plate.face,
            measures=measures[plate.face],
            weighed=None
            if isinstance(body, Cassette)
            else plate.built_up.weighed(site.material.density),
        )
        for plate, (body, pattern, origin) in zip(plates, made, strict=True)
    )
    layers = tuple(plate.built_up for plate in plates)
    return PanelParts(parts, layers, left_out, joined, onto, above, blunt)


class Plate(NamedTuple):
    """A panel, or a piece of one; its origin is the lower left corner of its pattern's box."""

    name: str
    face: int
    built_up: BuiltUp
    pattern: FlatPattern
    origin: FloatArray


def _plates(
    site: Site, geometry: PanelGeometry, thickness: float, least_width: FloatArray, join: bool
) -> tuple[list[Plate], PanelPieces, dict[str, float]]:
    """The panels, what the border left of the faces, and by name how much corners lost, mm.

    Pieces that are narrower than the least of their face (F,), or that cannot be made, are none.
    """
    names = part_names("P", len(site.mesh.faces))
    rings = [
        geometry.corners.trimmed(ring)
        for ring in (geometry.lower, geometry.upper, geometry.outline)
    ]
    whole = np.ones(len(names), dtype=bool) if site.trimming is None else site.trimming.whole
    pieces = PanelPieces(whole, {}, {}, limits=site.material.plate_limits)
    for face, some in _at_the_border(site, geometry, rings).items():
        outlines = [geometry.corners.outline(face, ring[face]) for ring in rings]
        wide = [each for each in some if each.width >= least_width[face]]
        pieces.wide[face] = [each for each in wide if pieces.can_be(each, outlines)]
        others = [each for each in some if each not in pieces.wide[face]]
        for number, piece in enumerate(others, len(pieces.wide[face])):
            pieces.narrow[piece_name(names[face], number)] = face, piece
    pieces.slivers = {name: face for name, (face, _) in pieces.narrow.items()}
    across = neighbours(site.mesh.connectivity)
    if join:
        join_slivers(pieces, geometry, rings, across)
    made, plates, blunt = pieces.made, [], dict[str, float]()
    made_of = thickness, site.material
    for face in np.flatnonzero(made).tolist():
        beside = [names[k] if k >= 0 and made[k] else "" for k in across[face].tolist()]
        if face not in pieces.wide:
            plates.append(plate_of(names[face], geometry, rings, face, made_of, beside))
        for number, piece in enumerate(pieces.wide.get(face, ())):
            name = piece_name(names[face], number)
            outlines = [geometry.corners.outline(face, ring[face]) for ring in rings]
            if pieces.limits is not None:
                blunter = blunted(piece, outlines, pieces.limits) or piece
                if blunter is not piece:
                    blunt[name] = cut_off(piece, blunter)
                piece = blunter
            plates.append(_cut_plate(name, geometry, face, piece, made_of, beside))
    return plates, pieces, blunt


def _formed(
    plate: Plate, geometry: PanelGeometry, thickness: float, formed: ColdBent | Fold | None
) -> tuple[Body, FlatPattern, FloatArray]:
    """Solid, pattern and origin of a panel.

    It is bent where it has four corners and its layers are of one size: then its pattern is the
    flat plate that is bent into it. Its edges are folded where it has room for that.
    """
    if isinstance(formed, Fold):
        cassette = Cassette(plate.built_up.under, formed)
        if cassette.fits:
            return _folded(plate, geometry, cassette)
    if not isinstance(formed, ColdBent) or not plate.built_up.bends:
        return plate.built_up.body(), plate.pattern, plate.origin
    corner = plate.origin - geometry.planes.middle[plate.face]
    low = geometry.planes.frame[plate.face, :2] @ corner
    body = formed.body(plate.face, plate.built_up.under, low, thickness)
    flat = unbent(body.corners[:4])
    return body, replace(plate.pattern, outline=flat - flat.min(axis=0)), plate.origin


def _folded(
    plate: Plate, geometry: PanelGeometry, cassette: Cassette
) -> tuple[Body, FlatPattern, FloatArray]:
    """A panel with folded edges; its coordinates begin where the flat sheet does."""
    flat, bends = cassette.flat()
    low = flat.min(axis=0)
    pattern = replace(
        plate.pattern,
        outline=flat - low,
        marks=tuple(replace(mark, points=mark.points - low) for mark in plate.pattern.marks),
        label=plate.pattern.label - low,
        bends=tuple(replace(bend, points=bend.points - low) for bend in bends),
        bevels=(),
    )
    body = replace(cassette, outline=cassette.outline - low)
    return body, pattern, plate.origin + low @ geometry.planes.frame[plate.face, :2]


def _at_the_border(
    site: Site, geometry: PanelGeometry, rings: Sequence[FloatArray]
) -> dict[int, list[Trimmed]]:
    """The pieces of the panels that the border cuts, by face."""
    if site.trimming is None:
        return {}
    found = {}
    for face in site.trimming.regions:
        under, over, outline = (geometry.corners.outline(face, ring[face]) for ring in rings)
        regions = site.trimming.flat_regions(face, geometry.planes.flat[face])
        found[face] = trimmed(under, over, outline, regions)
    return found


def plate_of(
    name: str,
    geometry: PanelGeometry,
    rings: Sequence[FloatArray],
    face: int,
    made_of: tuple[float, Material],
    beside: list[str],
) -> Plate:
    """The panel of one row of a geometry.

    Args:
        name: of the panel.
        geometry: of panels in faces with equally many corners.
        rings: trimmed lower, upper and whole outlines of all of them.
        face: number of the row.
        made_of: thickness, mm, and material.
        beside: names of the panels across the sides, "" where there is none.
    """
    low = geometry.outline[face].min(axis=0)
    under, over, outline = (geometry.corners.outline(face, ring[face]) - low for ring in rings)
    built_up = BuiltUp.of((under, over), *made_of, name)
    pattern = _flat_pattern(name, outline, geometry.outline[face] - low, beside)
    pattern = replace(pattern, bevels=bevels_of(built_up.whole), seen="above")
    return Plate(name, face, built_up, pattern, geometry.origin[face])


def _cut_plate(
    name: str,
    geometry: PanelGeometry,
    face: int,
    piece: Trimmed,
    made_of: tuple[float, Material],
    beside: list[str],
) -> Plate:
    """A piece that the border leaves."""
    low = piece.outline.min(axis=0)
    piece = piece.moved(-low)
    built_up = BuiltUp.of((piece.under, piece.over), *made_of, name, piece.cutouts)
    told = ["" if side is None else beside[side] for side in geometry.corners.sides(face)]
    pattern = trimmed_pattern(name, piece, told)
    pattern = replace(pattern, bevels=bevels_of(built_up.whole), seen="above")
    corner = np.append(low, geometry.levels[0, face])
    origin = geometry.planes.middle[face] + corner @ geometry.planes.frame[face]
    return Plate(name, face, built_up, pattern, origin)


def _flat_pattern(
    name: str, outline: FloatArray, corner: FloatArray, beside: list[str]
) -> FlatPattern:
    """Outline seen from above, neighbours' names along the sides, a tick at the first corner.

    Args:
        name: of the panel.
        outline: (N, 2) the plate to cut.
        corner: (4, 2) the same before corners are cut off.
        beside: names of the panels across the sides, "" where there is none.
    """
    side = np.roll(corner, -1, axis=0) - corner
    length = np.linalg.norm(side, axis=1)
    along = side / length[:, None]
    inward = np.stack([-along[:, 1], along[:, 0]], axis=1)
    middle = corner.mean(axis=0)
    # The circle around the middle that stays inside; text is kept in or outside of half of it.
    radius = float(np.abs(np.einsum("kd,kd->k", inward, middle - corner)).min())
    # Where the first corner is cut off, the outline begins with the two points that it leaves.
    uncut = np.abs(outline[0] - corner[0]).max() < 1e-9
    first = corner[0] if uncut else outline[:2].mean(axis=0)
    marks = [Mark(np.stack([first, first + 0.15 * (middle - first)]))]
    for k, text in enumerate(beside):
        if text:
            size = fitted_text_size(text, 0.5 * float(length[k]), 0.3 * radius, 12.0)
            place = (corner[k] + corner[(k + 1) % len(corner)]) / 2 + 0.2 * radius * inward[k]
            angle = float(np.degrees(np.arctan2(along[k, 1], along[k, 0])))
            marks.append(Mark(place[None], text, size, angle))
    label_size = min(1.1 * radius / float(np.hypot(len(name), 1)), 30.0)
    return FlatPattern(outline, tuple(marks), middle, label_size)
