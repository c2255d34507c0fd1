"""Panels in faces of several sizes: those with equally many corners together, as arrays."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any, Protocol

import numpy as np

from freecad_ortho.fabrication.part import Measures, Part, part_names
from freecad_ortho.fabrication.plates import plate_part
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.beams.geometry import BeamGeometry
from freecad_ortho.fabrication.systems.panels.bearing import (
    bearings,
    least_bearing,
    measures_of,
)
from freecad_ortho.fabrication.systems.panels.geometry import (
    PanelGeometry,
    joint_widths,
    neighbours,
)
from freecad_ortho.fabrication.systems.panels.parts import plate_of
from freecad_ortho.fabrication.systems.panels.words import (
    UNDER_BEAMS,
    PanelSettings,
    faces_down,
    messages_of,
    report_of,
)
from freecad_ortho.fabrication.systems.system import SystemParts, sums
from solver.analysis.measures import diagonal_distances
from solver.errors import InputError
from solver.mesh.connectivity import SameSize
from solver.mesh.quadmesh import FloatArray, QuadMesh

# Gives the geometry of the panels in faces with equally many corners.
Making = Callable[[SameSize], PanelGeometry]


class Asked(PanelSettings, Protocol):
    """What may be asked of panels that only those with four corners have."""

    @property
    def frame(self) -> str:
        """How they are held."""

    @property
    def bending(self) -> str:
        """Whether they are bent."""

    @property
    def fold(self) -> float:
        """Depth of folded edges, mm."""

    @property
    def unheeded(self) -> tuple[str, ...]:
        """Words on what was given and does not count."""


def refuse_what_needs_quads(settings: Asked) -> None:
    """Refuse frames, bevels, folds and bent panels.

    Raises:
        InputError: naming what was asked for.
    """
    asked = {
        "frame": settings.frame != "none",
        "panel edge": settings.edge != "square",
        "bending": settings.bending != "none",
        "fold": bool(settings.fold),
    }
    for name, wanted in asked.items():
        if wanted:
            raise InputError(
                f"{name}: panels of faces of several sizes are flat plates with square edges, "
                "without frames; leave it out, or make quads of the faces first ('quads')"
            )


def _report(
    settings: PanelSettings, geometries: Sequence[PanelGeometry], bearing: FloatArray | None
) -> dict[str, Any]:
    """What is reported of panels in faces of several sizes, and how many have how many corners."""
    reports = [
        report_of(settings, geometry, np.ones(len(geometry.lift), bool), None, ())
        for geometry in geometries
    ]
    merged = reports[0] | {
        name: sum(report[name] for report in reports)
        for name in ("sides_shrunk_more", "corners_cut", "lifted_over_hubs")
    }
    clear = [each for report in reports if (each := report["clear_gap_min_mm"]) is not None]
    merged["clear_gap_min_mm"] = min(clear, default=None)
    merged["lift_max_mm"] = max(report["lift_max_mm"] for report in reports)
    if bearing is not None:
        merged |= {"offset": "on the beams", "bearing_min_mm": float(bearing.min())}
    merged["panels_by_corners"] = {
        str(geometry.planes.faces.shape[1]): len(geometry.lift) for geometry in geometries
    }
    return merged


def mixed_panels(
    settings: Asked, site: Site, making: Making, beams: BeamGeometry | None
) -> SystemParts:
    """Make a panel in every face.

    Args:
        settings: of the panels.
        site: the net, with faces of several sizes.
        making: gives the geometry of panels in faces of one size.
        beams: on which the panels lie.

    Raises:
        InputError: what only panels with four corners have, a face that the gap or hubs leave
            nothing of.
    """
    refuse_what_needs_quads(settings)
    net, gaps = site.mesh.connectivity, diagonal_distances(site.mesh)
    made = [making(same) for same in net.by_size]
    joints = _joints(site.mesh, made)
    groups = [
        (same, replace(geometry, clear=joints[same.half_edges]))
        for same, geometry in zip(net.by_size, made, strict=True)
    ]
    bearing = None
    if beams is not None:
        bearing = np.zeros(net.face_count)
        for same, geometry in groups:
            widths = bearings(net, beams, geometry.lower_edges(), same)
            bearing[same.numbers] = least_bearing(widths)
    measures = measures_of(gaps, bearing)
    made_parts = (part for group in groups for part in _parts(site, *group, settings, measures))
    parts = tuple(sorted(made_parts, key=lambda part: part.face or 0))
    report = _report(settings, [geometry for _, geometry in groups], bearing) | sums(parts)
    words = messages_of(report, float(gaps.max()), site.material)
    if beams is not None and faces_down(site.mesh):
        words += (UNDER_BEAMS,)
    return SystemParts(parts, report, (*words, *settings.unheeded))


def _joints(mesh: QuadMesh, geometries: list[PanelGeometry]) -> FloatArray:
    """(H,) width of the joint along each half-edge, mm; inf at the boundary."""
    net = mesh.connectivity
    sides = np.zeros((len(net.half_edges), 4, 3))
    for same, geometry in zip(net.by_size, geometries, strict=True):
        rings = zip((geometry.lower, geometry.upper), geometry.levels, strict=True)
        ends = [
            geometry.planes.in_space(geometry.corners.trimmed(ring), level) for ring, level in rings
        ]
        sides[same.half_edges] = np.concatenate(ends, axis=2)
    return joint_widths(net, sides)


def _parts(
    site: Site,
    same: SameSize,
    geometry: PanelGeometry,
    settings: PanelSettings,
    measures: Sequence[Measures],
) -> list[Part]:
    """Panels in faces of one size, with the measures of those in all faces."""
    names = part_names("P", site.mesh.connectivity.face_count)
    across = neighbours(site.mesh.connectivity, same)
    rings = [
        geometry.corners.trimmed(ring)
        for ring in (geometry.lower, geometry.upper, geometry.outline)
    ]
    made_of = settings.thickness, site.material
    parts = []
    for row, face in enumerate(same.numbers.tolist()):
        beside = [names[k] if k >= 0 else "" for k in across[row].tolist()]
        plate = plate_of(names[face], geometry, rings, row, made_of, beside)
        parts.append(
            plate_part(
                site,
                plate.name,
                "panel",
                plate.built_up.body(),
                (plate.origin, geometry.planes.frame[row]),
                plate.pattern,
                settings.thickness,
                vertices=tuple(same.faces[row].tolist()),
                face=face,
                measures=measures[face],
                weighed=plate.built_up.weighed(site.material.density),
            )
        )
    return parts
