"""Cleats as parts: their flat patterns and their bolts."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

import numpy as np

from freecad_ortho.fabrication.bolts import Bolt, bolt_in
from freecad_ortho.fabrication.cleat import Cleat
from freecad_ortho.fabrication.fasteners import Fasteners, gathered
from freecad_ortho.fabrication.material import metal_for
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.pattern import Bend, FlatPattern, Hole, Mark, fitted_text_size
from freecad_ortho.fabrication.site import Site
from solver.mesh.quadmesh import FloatArray

# Bolts whose grips differ by less, mm, are of one.
_STEP = 0.5
_Placed = tuple[FloatArray, FloatArray, tuple[str, ...]]


def cleat_part(cleat: Cleat, site: Site) -> Part:
    """Return the part.

    Its flat pattern is that of the middle of the plate, without an allowance for the fold, seen
    from inside the corner.
    """
    body, sizes = cleat.body(), cleat.sizes
    pattern = _pattern(cleat)
    length, width = pattern.size.tolist()
    return Part(
        name=cleat.name,
        kind="cleat",
        body=body,
        origin=cleat.origin + site.shift,
        frame=cleat.frame,
        pattern=pattern,
        length=length,
        width=width,
        thickness=sizes.thickness,
        area=pattern.area,
        volume=body.volume,
        material=metal_for(site.material),
        vertices=(cleat.vertex,),
    )


def _pattern(cleat: Cleat) -> FlatPattern:
    """Both legs beside each other with the fold between them."""
    sizes, half = cleat.sizes, cleat.developed
    height, low = sizes.height, cleat.drop
    outline = np.array([[0.0, 0.0], [2 * half, 0.0], [2 * half, height], [0.0, height]])
    if cleat.askew:
        ends = [0.0, sizes.reach - cleat.fold, 2 * half - sizes.reach + cleat.fold, 2 * half]
        rises = [cleat.rise(0, sizes.reach), 0.0, 0.0, cleat.rise(1, sizes.reach)]
        below = np.column_stack([ends, low + np.array(rises)])
        outline = np.concatenate([below, below[::-1] + [0.0, height]])
    off = half - (sizes.reach - sizes.back)
    # Seen from inside the corner, the fold upright, the first leg is on the left.
    holes = tuple(
        Hole(np.array([half + side * off, low + height / 2 + level]), sizes.hole)
        for leg, side in enumerate((-1.0, 1.0))
        for level in (cleat.levels(leg) + cleat.rise(leg, sizes.back)).tolist()
    )
    fold = Bend(
        np.array([[half, low], [half, low + height]]),
        180.0 - float(np.degrees(cleat.angle)),
    )
    room = 2 * off - sizes.hole
    size = fitted_text_size(cleat.name, 0.45 * room, height / 4, 8.0)
    marks = []
    for number, (leg, side) in enumerate(zip(cleat.legs, (-1.0, 1.0), strict=True)):
        level = low + cleat.rise(number, 0.25 * room) + height / 4
        place = np.array([[half + side * 0.25 * room, level]])
        words = fitted_text_size(leg.part, 0.45 * room, height / 4, 8.0)
        marks.append(Mark(place, leg.part, words))
    label = np.array([half + 0.25 * room, low + cleat.rise(1, 0.25 * room) + 0.6 * height])
    return FlatPattern(
        outline, tuple(marks), label, size, holes=holes, bends=(fold,), seen="corner"
    )


def cleat_bolts(
    cleats: Iterable[Cleat], site: Site, standing: Collection[int], feet: Sequence[str]
) -> tuple[Fasteners, ...]:
    """Bolts through lamellas and legs, and at feet through their fins, heads on the far side.

    Args:
        cleats: in their places.
        site: the net.
        standing: vertices on feet.
        feet: names that feet would have, one a vertex.
    """
    by_grip: dict[tuple[float, float, bool], list[_Placed]] = {}
    kinds: dict[tuple[float, float, bool], Bolt] = {}
    for cleat in cleats:
        sizes = cleat.sizes
        if sizes.bolt is None:
            continue
        stands = cleat.vertex in standing
        # Above feet both sides are of steel, as a fin lies under the heads.
        bolt = bolt_in(sizes.hole) if stands else sizes.bolt
        assert bolt is not None
        for number, leg in enumerate(cleat.legs):
            below = sizes.plate + 2 * leg.gap + (sizes.thickness if stands else 0.0)
            thick = _STEP * np.ceil((below + sizes.thickness) / _STEP - 1e-6)
            key = float(thick), bolt.diameter, stands
            kinds[key] = bolt
            fin = (f"{feet[cleat.vertex]}-fin-{number + 1}",) if stands else ()
            for place in cleat.bolts(number):
                under = place + site.shift - (below + bolt.washer) * leg.out
                joins = *fin, leg.part, cleat.name
                by_grip.setdefault(key, []).append((under, leg.out, joins))
    found = []
    for key, placed in sorted(by_grip.items(), key=lambda each: each[0]):
        bolt = kinds[key]
        holds = "feet, lamellas and cleats" if key[2] else "lamellas and cleats"
        grip = key[0] + 2 * bolt.washer
        found.append(gathered(bolt, bolt.through(key[0]), grip, 2, True, holds, placed))
    return tuple(found)
