"""What the bolts of cleats bear, and how far the forces of a structural check use them.

A leg carries a force V along its corner and H square to it, in its plate: n bolts above each other,
a distance e from the corner. Shared out elastically (EN 1993-1-8, 3.12), with the moment V e about
the middle of two bolts that are p apart, the bolt that bears most takes

    sqrt((V / n)^2 + (H / n + V e / p)^2),

held against F, the lesser of what shears it in one plane and of what it and the thinner of leg and
lamella bear on each other (table 3.4). The bolts of the other leg are pulled by H instead: used
by sqrt((V / n)^2 + (V e / p)^2) / F + H / (1.4 n T) with the tension T that one bears. One bolt
alone takes no moment: the other leg has to.

What pulls the bolts of a leg off the corner bends it there: a plate h high and t thick, the bolts
a distance e off, yields through (EN 1993-1-1, 6.2.5, class 1) at the pull

    H = h t^2 f / (4 e).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

from freecad_ortho.fabrication.bolt_strength import Clamped
from freecad_ortho.fabrication.cleat import CleatSizes
from freecad_ortho.fabrication.material import MATERIALS, Material, metal_for


def clamped(sizes: CleatSizes, material: Material) -> Clamped | None:
    """How the bolts of a leg are built in; None where no bolt of the list passes their holes.

    Args:
        sizes: of the cleat.
        material: of the lamellas; cleats are of steel.
    """
    if sizes.bolt is None:
        return None
    levels = sizes.levels
    return Clamped(
        bolt=sizes.bolt,
        planes=1,
        plate=min(sizes.thickness, sizes.plate),
        head=sizes.thickness,
        edge=min(sizes.reach - sizes.back, sizes.rim),
        apart=levels[-1] - levels[0] if len(levels) > 1 else None,
        material=material,
    )


def cleat_report(every: Sequence[CleatSizes], material: Material) -> dict[str, Any]:
    """What the report says of the bolts of cleats: of those with the fewest in a leg."""
    if not every:
        return {}
    weakest = min(every, key=lambda sizes: (len(sizes.levels), -sizes.back))
    bolts = clamped(weakest, material)
    if bolts is None:
        return {}
    shear, bearing = bolts.shear, bolts.bearing
    assert shear is not None and weakest.bolt is not None
    return {
        "cleat_bolt": weakest.bolt.name,
        "cleat_bolts_a_leg": len(weakest.levels),
        "cleat_bolts_apart_mm": bolts.apart,
        "cleat_bolts_to_corner_mm": weakest.back,
        "cleat_bolt_tension_kN": round(bolts.tension / 1e3, 1),
        "cleat_bolt_shear_kN": round(shear / 1e3, 1),
        "cleat_bolt_bearing_kN": None if bearing is None else round(bearing / 1e3, 1),
        "cleat_thickness_mm": weakest.thickness,
        "cleat_leg_bends_kN": round(leg_bends(weakest, material) / 1e3, 2),
    }


def leg_bends(sizes: CleatSizes, material: Material) -> float:
    """Pull on the bolts of a leg, square to it, at which the leg yields at the corner, N.

    Args:
        sizes: of the cleat.
        material: of the lamellas.
    """
    metal = metal_for(material)
    # Plain steel counts as the weakest, as in what its plates bear.
    strength = MATERIALS["S235" if metal.name == "steel" else metal.name].bending_limit
    # Of plates on each other only what is beside the bolts of one of them counts.
    height = sizes.height - 2 * sizes.lift
    return height * sizes.thickness**2 * strength / (4 * sizes.back)


def cleats_used(lamellas: Mapping[str, Any], forces: Mapping[str, float]) -> str:
    """How far bolts of cleats are used by the largest forces at ends of members, in words.

    All that a member carries at its end is taken to pass by one leg.

    Args:
        lamellas: what the report says of these.
        forces: of a structural check, tension_kN, compression_kN, shear_kN and moment_kNm.
    """
    count, apart = lamellas["cleat_bolts_a_leg"], lamellas["cleat_bolts_apart_mm"]
    along = forces["shear_kN"]
    across = max(forces["tension_kN"], forces["compression_kN"])
    moment = 0.0 if apart is None else along * lamellas["cleat_bolts_to_corner_mm"] / apart
    shear, bearing = lamellas["cleat_bolt_shear_kN"], lamellas["cleat_bolt_bearing_kN"]
    plates = (
        "what the lamellas bear at their holes is not checked, as they are not of steel"
        if bearing is None
        else f"in the plates {bearing:g} kN"
    )
    bears = shear if bearing is None else min(shear, bearing)
    pulled = across / (1.4 * count * lamellas["cleat_bolt_tension_kN"])
    used = max(
        math.hypot(along / count, across / count + moment) / bears,
        math.hypot(along / count, moment) / bears + pulled,
    )
    said = "one bolt takes no moment" if apart is None else "with the moment about their middle"
    bends = lamellas["cleat_leg_bends_kN"]
    return (
        f"Bolts of the cleats, {count} {lamellas['cleat_bolt']} a leg, bear {shear:g} kN each in "
        f"shear (EN 1993-1-8, table 3.4), {plates}. If all that members carry at their ends, "
        f"{across:.3g} kN along and {along:.3g} kN across, passes by one cleat they are used to "
        f"{100 * used:.0f} % ({said}). The leg across, {lamellas['cleat_thickness_mm']:g} mm "
        f"thick, yields where it is pulled by {bends:g} kN (EN 1993-1-1, 6.2.5), used to "
        f"{100 * across / bends:.0f} % then. Moments in the members, "
        f"{forces['moment_kNm']:.3g} kNm at most, and fins of feet are not checked."
    )
