"""Splice plates as parts."""

from __future__ import annotations

import numpy as np

from freecad_ortho.fabrication.bodies import BOX_SIDES, Polyhedron
from freecad_ortho.fabrication.drilled import Drill, DrilledBody
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.pattern import FlatPattern, Hole, Mark, fitted_text_size
from freecad_ortho.fabrication.plates import plate_part
from freecad_ortho.fabrication.ruled import RuledBody
from freecad_ortho.fabrication.ruled_sides import Bore
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.lamellas.bolts import bolts, half_length
from freecad_ortho.fabrication.systems.lamellas.settings import LamellaSettings
from freecad_ortho.fabrication.systems.lamellas.splices import SplicePlate, square_end


def outer_side(splice: SplicePlate, settings: LamellaSettings) -> int:
    """Side of the lamella that its plate lies on, along its normal: 1 or -1."""
    return -1 if not settings.standing and splice.lamella.family == "v" else 1


def stand_off(splice: SplicePlate, settings: LamellaSettings) -> float:
    """How far the plate stands off, mm: by as much as the edges of a twisted lamella do."""
    ribbon, face = splice.lamella.ribbon, splice.joint.face
    reach = max(abs(ribbon.lower), abs(ribbon.upper))
    turn = abs(float(ribbon.strip.twists[face])) * half_length(settings)
    return float(reach * np.sin(turn / ribbon.strip.lengths[face]))


def splice_part(splice: SplicePlate, site: Site, settings: LamellaSettings) -> Part:
    """Return the plate: flat, as wide and thick as the lamella, on the outer one of its sides.

    Where the lamella twists, the plate stands off by as much as its edges do from its middle.
    """
    lamella, joint = splice.lamella, splice.joint
    ribbon = lamella.ribbon
    strip = ribbon.strip
    outer, thickness = outer_side(splice, settings), ribbon.thickness
    point, up = square_end(strip, joint)
    along = strip.along[joint.face]
    frame = np.stack([along, up, np.cross(along, up)])
    level = 0.5 * (ribbon.lower + ribbon.upper)
    origin = point + level * up + outer * (thickness + stand_off(splice, settings)) * frame[2]
    pattern = _pattern(splice, settings)
    middle = pattern.size / 2
    flat = np.column_stack([pattern.outline - middle, np.zeros(4)])
    lift = np.array([0.0, 0.0, thickness / 2])
    whole = np.concatenate([flat - lift, flat + lift])
    drills = tuple(
        Drill(np.append(hole.centre - middle, 0.0), lift / lift[2], hole.diameter, thickness)
        for hole in pattern.holes
    )
    bores = tuple(
        Bore(each.centre - lift, each.centre + lift, each.diameter, (1, 0)) for each in drills
    )
    body = DrilledBody(
        Polyhedron(whole, BOX_SIDES), RuledBody(whole, BOX_SIDES, bores=bores), drills
    )
    return plate_part(
        site,
        splice.name,
        "splice",
        body,
        (origin, frame),
        pattern,
        thickness,
        family=lamella.family,
        line=lamella.line,
    )


def _pattern(splice: SplicePlate, settings: LamellaSettings) -> FlatPattern:
    """A rectangle with bolt holes, the joint, and the names of the plate and of both pieces."""
    half, width, hole = half_length(settings), settings.width, settings.hole
    outline = np.array([[0.0, 0.0], [2 * half, 0.0], [2 * half, width], [0.0, width]])
    distance, level = bolts(settings).T
    distance = distance + settings.clearance / 2
    places = [
        np.array([half + side * away, width / 2 + up])
        for side in (-1, 1)
        for away, up in zip(distance, level, strict=True)
    ]
    # Names stand between the outer bolts and the edges.
    free = width / 2 - float(level.max()) - hole / 2
    above, below = width - free / 2, free / 2
    marks = [Mark(np.array([[half, 0.0], [half, width]]))]
    for name, x in zip(splice.pieces, (half / 2, 1.5 * half), strict=True):
        size = fitted_text_size(name, 0.9 * half, free, 12.0)
        marks.append(Mark(np.array([[x, below]]), name, size))
    size = fitted_text_size(splice.name, 1.8 * half, free, 12.0)
    holes = tuple(Hole(place, hole) for place in places)
    return FlatPattern(outline, tuple(marks), np.array([half, above]), size, holes=holes)
