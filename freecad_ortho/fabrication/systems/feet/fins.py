"""Fins: plates that stand on the cap of a foot, welded, with the lamellas bolted to them."""

from __future__ import annotations

import numpy as np

from freecad_ortho.fabrication.bevels import bevels_of
from freecad_ortho.fabrication.bodies import Polyhedron, prism_sides
from freecad_ortho.fabrication.cleat import Cleat
from freecad_ortho.fabrication.drilled import drilled
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.pattern import FlatPattern, Hole, Mark, fitted_text_size
from freecad_ortho.fabrication.plates import plate_part
from freecad_ortho.fabrication.site import Site
from solver.mesh.quadmesh import FloatArray

# The cap stands out beside the fins for their welds, as these lean a little more than it, mm.
WELD = 15.0


def fin_parts(
    site: Site, cleat: Cleat, name: str, top: FloatArray, axis: FloatArray
) -> tuple[Part, Part]:
    """Both fins of a foot, on the sides of the lamellas that have no cleat.

    They share the cleat's bolts, and end in the plane of the cap.

    Args:
        site: the net.
        cleat: that joins the lamellas above the foot.
        name: of the foot.
        top: (3,) a point of the cap's upper side, in the site's mesh.
        axis: (3,) unit normal of the cap, upwards.
    """
    first, second = (_fin(site, cleat, leg, name, top, axis) for leg in (0, 1))
    return first, second


def _fin(site: Site, cleat: Cleat, leg: int, name: str, top: FloatArray, axis: FloatArray) -> Part:
    sizes, lies = cleat.sizes, cleat.legs[leg]
    up = np.copysign(1.0, float(cleat.up @ axis)) * cleat.up
    # y up along the corner, z away from the lamella.
    frame = np.stack([np.cross(up, -lies.out), up, -lies.out])
    inner = cleat.corner - (sizes.plate + 2 * lies.gap) * lies.out
    edge = sizes.reach - sizes.back
    ring = [
        inner + along * lies.way - across * lies.out
        for along, across in (
            (sizes.back - edge, 0.0),
            (sizes.reach, 0.0),
            (sizes.reach, sizes.thickness),
            (sizes.back - edge, sizes.thickness),
        )
    ]
    high = np.array(ring) + sizes.height / 2 * up
    falls = (high - top) @ axis / float(up @ axis)
    corners = np.concatenate([high - falls[:, None] * up, high])
    local = (corners - inner) @ frame.T
    body = Polyhedron(local, prism_sides(4))
    if body.volume < 0:
        local = local[[3, 2, 1, 0, 7, 6, 5, 4]]
        body = Polyhedron(local, prism_sides(4))
    flat = _outline(local)
    origin = np.append(flat.min(axis=0), 0.0)
    body = Polyhedron(local - origin, body.loops)
    places = (cleat.bolts(leg) - inner) @ frame.T - origin
    holes = tuple(Hole(place[:2], sizes.hole) for place in places)
    sides = tuple(_side_at(body, level) for level in (0.0, sizes.thickness))
    full = f"{name}-fin-{leg + 1}"
    pattern = _pattern(full, lies.part, flat - origin[:2], holes, body)
    return plate_part(
        site,
        full,
        "fin",
        drilled(body, holes, (0.0, sizes.thickness), (sides[0], sides[1])),
        (inner + origin @ frame, frame),
        pattern,
        sizes.thickness,
        vertices=(cleat.vertex,),
    )


def _outline(local: FloatArray) -> FloatArray:
    """(4, 2) corners of the middle plane, counter-clockwise from the lower left."""
    below: list[FloatArray] = []
    above: list[FloatArray] = []
    for ring, into in ((local[:4], below), (local[4:], above)):
        for x in (ring[:, 0].min(), ring[:, 0].max()):
            into.append(ring[np.isclose(ring[:, 0], x, atol=1e-6), :2].mean(axis=0))
    return np.array([below[0], below[1], above[1], above[0]])


def _side_at(body: Polyhedron, level: float) -> int:
    """Number of the side that lies at a height across the plate."""
    off = [float(np.abs(body.corners[list(loop), 2] - level).max()) for loop in body.loops]
    return int(np.argmin(off))


def _pattern(
    name: str, lamella: str, outline: FloatArray, holes: tuple[Hole, ...], body: Polyhedron
) -> FlatPattern:
    """The fin seen from the side away from its lamella, its names upright below the bolts."""
    width = float(np.ptp(outline[:, 0]))
    lowest = min(float(hole.centre[1]) for hole in holes) - holes[0].diameter / 2
    foot = float(outline[:2, 1].max())
    room = max(lowest - foot, 1.0)
    middle = np.array([width / 2, (lowest + foot) / 2])
    size = fitted_text_size(name, 0.9 * room, 0.4 * width, 8.0)
    words = fitted_text_size(lamella, 0.9 * room, 0.4 * width, 8.0)
    shift = np.array([width / 4, 0.0])
    return FlatPattern(
        outline,
        (Mark((middle + shift)[None], lamella, words, 90.0),),
        middle - shift,
        size,
        holes=holes,
        label_angle=90.0,
        bevels=bevels_of(body),
        seen="outside",
    )
