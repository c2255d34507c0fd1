"""Panels as parts: names, flat patterns with their marks, measures."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad_ortho.fabrication.bevels import bevels_of
from freecad_ortho.fabrication.bodies import Polyhedron, prism_sides
from freecad_ortho.fabrication.part import Measures, Part, part_names
from freecad_ortho.fabrication.pattern import FlatPattern, Mark, fitted_text_size
from freecad_ortho.fabrication.plates import plate_part
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.panels.geometry import PanelGeometry, neighbours
from solver.mesh.quadmesh import FloatArray


def panel_parts(
    site: Site,
    geometry: PanelGeometry,
    thickness: float,
    gaps: FloatArray,
    bearing: FloatArray | None,
) -> tuple[Part, ...]:
    """Return one part a face, in the order of the faces.

    Args:
        site: the net.
        geometry: corners of the panels.
        thickness: of the plates, mm.
        gaps: (F,) distance of each face from planar, mm.
        bearing: (F,) least width on the beams, mm; None without beams.
    """
    connectivity = site.mesh.connectivity
    names = part_names("P", len(connectivity.faces))
    across = neighbours(connectivity).tolist()
    faces = connectivity.faces.tolist()
    rings = geometry.lower, geometry.upper, geometry.outline
    lower, upper, whole = (geometry.corners.trimmed(ring) for ring in rings)
    parts = []
    for face, name in enumerate(names):
        beside = [names[other] if other >= 0 else "" for other in across[face]]
        low = geometry.outline[face].min(axis=0)
        under, over, outline = (
            geometry.corners.outline(face, sides[face]) - low for sides in (lower, upper, whole)
        )
        count = len(outline)
        corners = np.column_stack(
            [np.concatenate([under, over]), np.repeat([0.0, thickness], count)]
        )
        body = Polyhedron(corners, prism_sides(count))
        pattern = _flat_pattern(name, outline, geometry.outline[face] - low, beside)
        pattern = replace(pattern, bevels=bevels_of(body), seen="above")
        parts.append(
            plate_part(
                site,
                name,
                "panel",
                body,
                (geometry.origin[face], geometry.planes.frame[face]),
                pattern,
                thickness,
                vertices=tuple(faces[face]),
                face=face,
                measures=Measures(
                    gap_mm=float(gaps[face]),
                    bearing_mm=None if bearing is None else float(bearing[face]),
                ),
            )
        )
    return tuple(parts)


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
            place = (corner[k] + corner[(k + 1) % 4]) / 2 + 0.2 * radius * inward[k]
            angle = float(np.degrees(np.arctan2(along[k, 1], along[k, 0])))
            marks.append(Mark(place[None], text, size, angle))
    label_size = min(1.1 * radius / float(np.hypot(len(name), 1)), 30.0)
    return FlatPattern(outline, tuple(marks), middle, label_size)
