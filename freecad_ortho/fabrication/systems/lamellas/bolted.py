"""The bolts of lamellas in their places: through splices, and where two layers cross."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence

import numpy as np

from freecad_ortho.fabrication.bolts import Bolt, bolt_in, on_wood
from freecad_ortho.fabrication.drilled import DrilledBody
from freecad_ortho.fabrication.fasteners import Fasteners, gathered
from freecad_ortho.fabrication.material import Material
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.lamellas.axis import Lamella
from freecad_ortho.fabrication.systems.lamellas.crossings import Crossing
from freecad_ortho.fabrication.systems.lamellas.settings import LamellaSettings
from freecad_ortho.fabrication.systems.lamellas.splice_parts import outer_side, stand_off
from freecad_ortho.fabrication.systems.lamellas.splices import SplicePlate
from solver.mesh.quadmesh import FloatArray

# Plates that stand off their lamella by about the same, mm, have bolts of one grip.
_STEP = 0.5
_Placed = tuple[FloatArray, FloatArray, tuple[str, ...]]


def layer_bolt(hole: float, material: Material) -> Bolt | None:
    """What plates of a material are bolted with through holes of a diameter, mm; None for none."""
    bolt = bolt_in(hole)
    return on_wood(bolt) if bolt is not None and material.wood else bolt


def splice_bolts(
    site: Site, splices: Sequence[SplicePlate], plates: Sequence[Part], settings: LamellaSettings
) -> tuple[Fasteners, ...]:
    """Bolts through splice plates and the ends that they join, their heads on the plates.

    Args:
        site: what they are of.
        splices: the joints.
        plates: their parts.
        settings: of the lamellas.
    """
    bolt = layer_bolt(settings.hole, site.material)
    if bolt is None:
        return ()
    by_gap: dict[float, list[_Placed]] = {}
    for splice, plate in zip(splices, plates, strict=True):
        assert isinstance(plate.body, DrilledBody)
        gap = _STEP * math.ceil(stand_off(splice, settings) / _STEP - 1e-6)
        out = outer_side(splice, settings) * plate.frame[2]
        drills = plate.body.drills
        for number, drill in enumerate(drills):
            middle = plate.origin + drill.centre @ plate.frame
            under = middle + (settings.thickness / 2 + bolt.washer) * out
            piece = splice.pieces[0 if 2 * number < len(drills) else 1]
            by_gap.setdefault(gap, []).append((under, -out, (plate.name, piece)))
    return tuple(
        _through(bolt, 2 * settings.thickness + gap, "splices of lamellas", each)
        for gap, each in sorted(by_gap.items())
    )


def crossing_bolts(
    site: Site,
    lamellas: Sequence[Lamella],
    met: Sequence[Sequence[Crossing]],
    settings: LamellaSettings,
    taken: Collection[int] = (),
) -> tuple[Fasteners, ...]:
    """Bolts through both layers of lying lamellas, their heads on family u.

    Where vertices are ``taken``, bolts of a third layer pass through all.
    """
    bolt = layer_bolt(settings.hole, site.material)
    by_name = {lamella.name: lamella for lamella in lamellas}
    placed: list[_Placed] = []
    for lamella, row in zip(lamellas, met, strict=True):
        if lamella.family != "u":
            continue
        for crossing in row:
            if not crossing.bolted or bolt is None or crossing.vertex in taken:
                continue
            other = by_name[crossing.other]
            there = other.stations[other.vertices.index(crossing.vertex)]
            strip = lamella.ribbon.strip
            point, normal = strip.points[crossing.station], strip.normals[crossing.station]
            away = point - other.ribbon.strip.points[there]
            out = np.copysign(1.0, float(away @ normal)) * normal
            under = point + site.shift + (settings.thickness / 2 + bolt.washer) * out
            placed.append((under, -out, (lamella.name, other.name)))
    if bolt is None or not placed:
        return ()
    plates = 2 * settings.thickness + settings.clearance
    return (_through(bolt, plates, "crossings of lamellas", placed),)


def _through(bolt: Bolt, plates: float, holds: str, placed: Sequence[_Placed]) -> Fasteners:
    grip = plates + 2 * bolt.washer
    return gathered(bolt, bolt.through(plates), grip, 2, True, holds, placed)
