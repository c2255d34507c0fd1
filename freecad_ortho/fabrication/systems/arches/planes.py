"""The planes in which lines of a net lie, and which of these lines a flat plate can follow."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_ortho.fabrication.site import Site
from freecad_ortho.words import counted
from solver.analysis.lines import nearest_plane
from solver.errors import InputError
from solver.mesh.lines import FAMILIES, ParameterLine
from solver.mesh.quadmesh import FloatArray, unit_rows

# How far vertices may be off the middle of a plate, mm.
OFF_MM = 1.0
# A line this near to the upright plane counts as straight: of all its planes that one is taken.
_STRAIGHT_MM = 0.01
# Angle between plate and surface normal from which on a plate does not carry, degrees.
_LEANS = 60.0


@dataclass(frozen=True, eq=False)
class LinePlane:
    """A line and its plane.

    Attributes:
        line: of the net.
        points: (K, 3) its vertices, put into the plane, mm.
        normal: (3,) unit normal of the plane.
        up: (3,) direction in the plane, square to the chord of the line, out of the surface.
        off_mm: largest distance of a vertex from the plane.
        lean_deg: largest angle between plane and surface normal.
    """

    line: ParameterLine
    points: FloatArray
    normal: FloatArray
    up: FloatArray
    off_mm: float
    lean_deg: float

    @classmethod
    def of(cls, site: Site, line: ParameterLine) -> LinePlane:
        """The plane nearest to an open line."""
        points, outward = site.mesh.vertices[line.vertices], site.mesh.vertex_normals[line.vertices]
        chord = points[-1] - points[0]
        mean = outward.mean(axis=0)
        normal, centre = _unit(np.cross(chord, mean)), points.mean(axis=0)
        if np.abs((points - centre) @ normal).max() > _STRAIGHT_MM:
            normal, centre = nearest_plane(points)
            chord = chord - (chord @ normal) * normal
        up = _unit(np.cross(normal, chord))
        sign = 1.0 if up @ mean >= 0 else -1.0
        off = (points - centre) @ normal
        lean = np.degrees(np.arcsin(np.clip(np.abs(outward @ normal), 0.0, 1.0)))
        return cls(
            line,
            points - off[:, None] * normal,
            sign * normal,
            sign * up,
            float(np.abs(off).max()),
            float(lean.max()),
        )


def chosen_planes(site: Site) -> tuple[list[LinePlane], list[str]]:
    """The planes of the chosen lines that are plane, and words on those that get no plate.

    Of both families that one is left out whose lines are not plane, where the other's are.

    Raises:
        InputError: no chosen line is plane.
    """
    every = [line for line in site.chosen_lines if line.family]
    if not every:
        raise InputError(
            "arches: the net has no two families of lines because of irregular vertices; take "
            "beams instead"
        )
    rings = [line for line in every if line.closed]
    planes = [LinePlane.of(site, line) for line in every if not line.closed]
    words, found = [], []
    for family in FAMILIES:
        own = [plane for plane in planes if plane.line.family == family]
        bent = [plane for plane in own if plane.off_mm > OFF_MM]
        if not bent:
            found += own
            continue
        worst = max(bent, key=lambda plane: plane.off_mm)
        words.append(
            f"family {family} gets no plates: its line {worst.line.number} leaves its plane by "
            f"{worst.off_mm:.3g} mm, plates allow {OFF_MM:g} mm"
        )
    leaning = [plane for plane in found if plane.lean_deg > _LEANS]
    if leaning:
        worst = max(leaning, key=lambda plane: plane.lean_deg)
        words.append(
            f"{counted(len(leaning), 'line')} left out whose plane leans by more than "
            f"{_LEANS:g} degrees from the surface normal, {_name(worst.line)} by "
            f"{worst.lean_deg:.0f}"
        )
        found = [plane for plane in found if plane.lean_deg <= _LEANS]
    if rings:
        words.append(
            f"{counted(len(rings), 'closed line')} left out, {_name(rings[0])} for one: cut the "
            "net open, or take beams there"
        )
    if not found:
        raise InputError(
            f"arches: {'; '.join(words)}; optimise the net to plane lines first (planar-lines)"
        )
    return found, [f"arches: {word}" for word in words]


def _name(line: ParameterLine) -> str:
    return f"line {line.number} of {line.family}"


def _unit(vector: FloatArray) -> FloatArray:
    return np.asarray(unit_rows(vector[None])[0])
