"""Profiles from their dimensions: rectangles, tubes, I, channels, tees and polygons.

Shear areas are those of EN 1993-1-1, 6.2.6 (3), 5/6 of solid sections. Torsion constants:

* solid rectangles: the series of Saint-Venant (Timoshenko, Goodier (1951), section 93);
* rectangular tubes: EN 10210-2, annex B; round tubes: twice the second moment of area;
* I: rectangles and the circles where they meet (El Darwish, Johnston (1965), Torsion of structural
  shapes), as catalogues of rolled sections have it; channels and tees: sum of b t3 / 3, which
  leaves their roots out and so is up to a tenth low;
* polygons: without holes the lesser of A4 / (40 Ip), Saint-Venant's estimate for compact sections,
  and A tm2 / 3 with tm = 2 A / perimeter for thin ones; with one hole Bredt's 4 Am2 tm / Pm, Am and
  Pm half way between both outlines, tm = A / Pm.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from freecad_ortho.fabrication.pattern import overlaps_itself, polygon_area
from freecad_ortho.fabrication.profiles.outline import moments
from freecad_ortho.fabrication.profiles.profile import Profile, Ring
from freecad_ortho.fabrication.profiles.rolled import Rolled
from freecad_ortho.fabrication.sizes import check_size
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    # Of the standard library from Python 3.11 on.
    from typing_extensions import Unpack

    from freecad_ortho.fabrication.profiles.profile import Called

_TERMS = np.arange(1, 40, 2)


def rectangle(width: float, height: float, **words: Unpack[Called]) -> Profile:
    """A solid rectangle."""
    check_size("section width", width)
    check_size("section height", height)
    area, long, short = width * height, max(width, height), min(width, height)
    # Beyond 20 the hyperbolic tangent is 1 and would overflow.
    series = (np.tanh(np.minimum(_TERMS * math.pi * long / short / 2, 20.0)) / _TERMS**5.0).sum()
    torsion = long * short**3 * (1 / 3 - 64 / math.pi**5 * short / long * series)
    return Profile(
        rings=(Ring(_box(width, height), np.zeros(4)),),
        torsion=float(torsion),
        shear_area_y=5 / 6 * area,
        shear_area_z=5 / 6 * area,
        wall=width,
        **words,
    )


def tube(
    height: float, width: float, wall: float, outer: float, inner: float, **words: Unpack[Called]
) -> Profile:
    """A rectangular tube with its corners' outer and inner radius, mm.

    Raises:
        InputError: walls that leave no hollow.
    """
    _refuse_thick(min(width, height), wall)
    rings = (
        Ring(_box(width, height), np.full(4, outer)),
        Ring(_box(width - 2 * wall, height - 2 * wall)[::-1], np.full(4, inner)),
    )
    area = _area(rings)
    middle = (outer + inner) / 2
    along = 2 * (width + height - 2 * wall) - 2 * middle * (4 - math.pi)
    within = (width - wall) * (height - wall) - middle**2 * (4 - math.pi)
    torsion = wall**3 * along / 3 + 4 * within**2 * wall / along
    return Profile(
        rings=rings,
        torsion=torsion,
        shear_area_y=area * width / (width + height),
        shear_area_z=area * height / (width + height),
        wall=wall,
        **words,
    )


def round_tube(diameter: float, wall: float, **words: Unpack[Called]) -> Profile:
    """A round tube.

    Raises:
        InputError: walls that leave no hollow.
    """
    check_size("section diameter", diameter)
    _refuse_thick(diameter, wall)
    hole = diameter - 2 * wall
    rings = (
        Ring(_box(diameter, diameter), np.full(4, diameter / 2)),
        Ring(_box(hole, hole)[::-1], np.full(4, hole / 2)),
    )
    shear = 2 / math.pi * _area(rings)
    return Profile(
        rings=rings,
        torsion=math.pi / 32 * (diameter**4 - hole**4),
        shear_area_y=shear,
        shear_area_z=shear,
        wall=wall,
        **words,
    )


def i_section(sizes: Rolled, **words: Unpack[Called]) -> Profile:
    """A rolled I or H."""
    height, width, web, flange, root = sizes
    right = [(width / 2, -height / 2), (width / 2, flange - height / 2)]
    right += [(web / 2, flange - height / 2), (web / 2, height / 2 - flange)]
    right += [(width / 2, height / 2 - flange), (width / 2, height / 2)]
    corners = np.array(right + [(-y, z) for y, z in reversed(right)])
    ring = Ring(corners, np.tile([0.0, 0.0, root, root, 0.0, 0.0], 2))
    area = _area((ring,))
    circle = ((root + web / 2) ** 2 + (root + flange) ** 2 - root**2) / (2 * root + flange)
    share = web / flange * (0.145 + 0.1 * root / flange)
    torsion = 2 / 3 * (width - 0.63 * flange) * flange**3
    torsion += (height - 2 * flange) * web**3 / 3 + 2 * share * circle**4
    return Profile(
        rings=(ring,),
        torsion=torsion,
        shear_area_y=area - (height - 2 * flange) * web,
        shear_area_z=max(
            area - 2 * width * flange + (web + 2 * root) * flange, (height - 2 * flange) * web
        ),
        wall=web,
        **words,
    )


def channel(sizes: Rolled, **words: Unpack[Called]) -> Profile:
    """A rolled U with parallel flanges that point to the right."""
    height, width, web, flange, root = sizes
    inner = web - width / 2
    lower = [(-width / 2, -height / 2), (width / 2, -height / 2)]
    lower += [(width / 2, flange - height / 2), (inner, flange - height / 2)]
    corners = np.array(lower + [(y, -z) for y, z in reversed(lower)])
    ring = Ring(corners, np.array([0.0, 0.0, 0.0, root, root, 0.0, 0.0, 0.0]))
    area = _area((ring,))
    return Profile(
        rings=(ring,),
        torsion=(2 * width * flange**3 + (height - 2 * flange) * web**3) / 3,
        shear_area_y=area - (height - 2 * flange) * web,
        shear_area_z=area - 2 * width * flange + (web + root) * flange,
        wall=web,
        **words,
    )


def tee(sizes: Rolled, **words: Unpack[Called]) -> Profile:
    """Half of a rolled I, cut along the middle of its web, with the flange at the top."""
    whole, width, web, flange, root = sizes
    height = whole / 2
    left = [(-width / 2, height / 2), (-width / 2, height / 2 - flange)]
    left += [(-web / 2, height / 2 - flange), (-web / 2, -height / 2)]
    corners = np.array(left + [(-y, z) for y, z in reversed(left)])
    ring = Ring(corners, np.array([0.0, 0.0, root, 0.0, 0.0, root, 0.0, 0.0]))
    area = _area((ring,))
    return Profile(
        rings=(ring,),
        torsion=(width * flange**3 + (height - flange) * web**3) / 3,
        shear_area_y=width * flange,
        shear_area_z=area - width * flange + (web + 2 * root) * flange / 2,
        wall=web,
        **words,
    )


def polygon(rings: Sequence[FloatArray], **words: Unpack[Called]) -> Profile:
    """Any section: an outline (n, 2) and those of its holes, y to the right and z up, mm.

    Raises:
        InputError: an outline that crosses itself or encloses nothing, a hole that is not within.
    """
    for ring in rings:
        _refuse_outline(ring)
    middle = (rings[0].min(axis=0) + rings[0].max(axis=0)) / 2
    turned = [
        ring[::-1] if (polygon_area(ring) > 0) == bool(number) else ring
        for number, ring in enumerate(rings)
    ]
    made = tuple(Ring(ring - middle, np.zeros(len(ring))) for ring in turned)
    outer, *holes = (abs(polygon_area(ring)) for ring in rings)
    lengths = [
        float(np.linalg.norm(ring - np.roll(ring, 1, axis=0), axis=1).sum()) for ring in rings
    ]
    area = outer - sum(holes)
    if area <= 0:
        raise InputError("section: the holes of the polygon leave nothing of it; draw them within")
    bare = Profile(rings=made, torsion=0.0, shear_area_y=area, shear_area_z=area, wall=0.0, **words)
    if holes:
        along = (lengths[0] + lengths[1]) / 2
        wall = area / along
        torsion = (outer + holes[0]) ** 2 * wall / along
    else:
        wall = 2 * area / lengths[0]
        polar = bare.inertia_y + bare.inertia_z
        torsion = min(area**4 / (40 * polar), area * wall**2 / 3)
    shear = 5 / 6 * area
    return Profile(
        rings=made, torsion=torsion, shear_area_y=shear, shear_area_z=shear, wall=wall, **words
    )


def _box(width: float, height: float) -> FloatArray:
    return np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]) * [width / 2, height / 2]


def _area(rings: Sequence[Ring]) -> float:
    return moments([side for ring in rings for side in ring.sides]).area


def _refuse_thick(size: float, wall: float) -> None:
    check_size("section wall", wall)
    if 2 * wall >= size:
        raise InputError(
            f"section: walls of {wall:g} mm leave no hollow in {size:g} mm; take thinner walls or "
            "a larger tube"
        )


def _refuse_outline(ring: FloatArray) -> None:
    if ring.ndim != 2 or ring.shape[1:] != (2,) or len(ring) < 3 or not np.isfinite(ring).all():
        raise InputError(
            "section: expected a polygon of at least three points, two numbers each in mm, got "
            f"{len(ring)}; write one point a line"
        )
    for size in np.ptp(ring, axis=0).tolist():
        check_size("section size", size)
    if polygon_area(ring) == 0 or overlaps_itself(ring):
        raise InputError(
            "section: the polygon crosses or touches itself; draw its outline once around"
        )
