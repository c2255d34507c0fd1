"""Beams as parts: names, flat patterns with their marks, measures."""

from __future__ import annotations

import numpy as np

from freecad_ortho.fabrication.bodies import Polyhedron
from freecad_ortho.fabrication.part import Measures, Part, part_names
from freecad_ortho.fabrication.pattern import FlatPattern, Mark, fitted_text_size
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.beams.geometry import LOOPS, BeamGeometry
from solver.mesh.quadmesh import FloatArray


def beam_parts(site: Site, geometry: BeamGeometry, thickness: float) -> tuple[Part, ...]:
    """Return one part for each chosen edge, in the order of the edges; thickness in mm."""
    edges = site.mesh.connectivity.edges.tolist()
    names = part_names("B", len(edges))
    families, lines = site.edge_family, site.lines.edge_line.tolist()
    twist = np.degrees(np.arcsin(np.clip(site.axes.twist, 0.0, 1.0)))
    arms = geometry.points - geometry.origin[:, None]
    corners = np.einsum("npk,nck->npc", arms, geometry.frame)
    parts = []
    for edge in np.flatnonzero(site.chosen_edges).tolist():
        name = names[edge]
        pattern = _flat_pattern(name, geometry.outline[edge], geometry.setback[edge], edges[edge])
        volume = float(geometry.volume[edge])
        parts.append(
            Part(
                name=name,
                kind="beam",
                body=Polyhedron(corners[edge], LOOPS),
                origin=geometry.origin[edge] + site.shift,
                frame=geometry.frame[edge],
                pattern=pattern,
                length=float(pattern.size[0]),
                width=float(geometry.height[edge]),
                thickness=thickness,
                area=pattern.area,
                volume=volume,
                mass=site.material.mass(volume),
                vertices=tuple(edges[edge]),
                family=families[edge],
                line=lines[edge],
                measures=Measures(
                    gap_mm=float(geometry.twist_mm[edge]), twist_deg=float(twist[edge])
                ),
            )
        )
    return tuple(parts)


def _flat_pattern(
    name: str, outline: FloatArray, setback: FloatArray, ends: list[int]
) -> FlatPattern:
    """Outline of the plate seen from its right side, the edge running to the right."""
    corner = outline - outline.min(axis=0)
    height = float(corner[:, 1].max())
    bottom_start, bottom_end, top_end, top_start = corner
    marks = []
    for side, (bottom, top, sign) in enumerate(
        [
            (bottom_start, top_start, 1.0),
            (bottom_end, top_end, -1.0),
            (bottom_end, top_end, -1.0),
            (bottom_start, top_start, 1.0),
        ]
    ):
        shift = np.array([sign * setback[side], 0.0])
        if setback[side] > 1e-6:
            marks.append(Mark(np.stack([bottom + shift, top + shift]), hidden=side > 1))
    start = max(bottom_start[0], top_start[0]) + max(setback[0], setback[3])
    end = min(bottom_end[0], top_end[0]) - max(setback[1], setback[2])
    # A third of the clear length for the name, a quarter at each end for its vertex.
    clear = max(end - start, 0.2 * (corner[:, 0].max()))
    middle = (start + end) / 2
    for vertex, sign in zip(ends, (-1.0, 1.0), strict=True):
        place = np.array([[middle + sign * 0.36 * clear, height / 2]])
        text = f"V{vertex}"
        size = fitted_text_size(text, 0.24 * clear, 0.5 * height, 15.0)
        marks.append(Mark(place, text, size))
    label_size = fitted_text_size(name, 0.4 * clear, height)
    return FlatPattern(corner, tuple(marks), np.array([middle, height / 2]), label_size)
