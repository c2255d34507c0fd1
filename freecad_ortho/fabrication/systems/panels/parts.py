"""Panels as parts: names, flat patterns with their marks, measures."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad_ortho.fabrication.bevels import bevels_of
from freecad_ortho.fabrication.bodies import BOX_SIDES, Polyhedron
from freecad_ortho.fabrication.part import Measures, Part, part_names
from freecad_ortho.fabrication.pattern import FlatPattern, Mark, fitted_text_size
from freecad_ortho.fabrication.plates import plate_part
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.panels.geometry import PanelGeometry, neighbours
from solver.mesh.quadmesh import FloatArray


def panel_parts(
    site: Site, geometry: PanelGeometry, thickness: float, gaps: FloatArray
) -> tuple[Part, ...]:
    """Return one part a face, in the order of the faces.

    Args:
        site: the net.
        geometry: corners of the panels.
        thickness: of the plates, mm.
        gaps: (F,) distance of each face from planar, mm.
    """
    connectivity = site.mesh.connectivity
    names = part_names("P", len(connectivity.faces))
    across = neighbours(connectivity).tolist()
    faces = connectivity.faces.tolist()
    arms = geometry.points - geometry.origin[:, None]
    corners = np.einsum("npk,nck->npc", arms, geometry.frame)
    parts = []
    for face, name in enumerate(names):
        beside = [names[other] if other >= 0 else "" for other in across[face]]
        body = Polyhedron(corners[face], BOX_SIDES)
        pattern = _flat_pattern(name, geometry.outline[face], beside)
        pattern = replace(pattern, bevels=bevels_of(body), seen="above")
        parts.append(
            plate_part(
                site,
                name,
                "panel",
                body,
                (geometry.origin[face], geometry.frame[face]),
                pattern,
                thickness,
                vertices=tuple(faces[face]),
                face=face,
                measures=Measures(gap_mm=float(gaps[face])),
            )
        )
    return tuple(parts)


def _flat_pattern(name: str, outline: FloatArray, beside: list[str]) -> FlatPattern:
    """Outline seen from above, neighbours' names along the sides, a tick at the first corner."""
    corner = outline - outline.min(axis=0)
    side = np.roll(corner, -1, axis=0) - corner
    length = np.linalg.norm(side, axis=1)
    along = side / length[:, None]
    inward = np.stack([-along[:, 1], along[:, 0]], axis=1)
    middle = corner.mean(axis=0)
    # The circle around the middle that stays inside; text is kept in or outside of half of it.
    radius = float(np.abs(np.einsum("kd,kd->k", inward, middle - corner)).min())
    tick = corner[0] + 0.15 * (middle - corner[0])
    marks = [Mark(np.stack([corner[0], tick]))]
    for k, text in enumerate(beside):
        if text:
            size = fitted_text_size(text, 0.5 * float(length[k]), 0.3 * radius, 12.0)
            place = (corner[k] + corner[(k + 1) % 4]) / 2 + 0.2 * radius * inward[k]
            angle = float(np.degrees(np.arctan2(along[k, 1], along[k, 0])))
            marks.append(Mark(place[None], text, size, angle))
    label_size = min(1.1 * radius / float(np.hypot(len(name), 1)), 30.0)
    return FlatPattern(corner, tuple(marks), middle, label_size)
