"""What plates can be made: angles, sides, sizes, masses and holes of flat patterns."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from freecad_ortho.fabrication.pattern import FlatPattern
from solver.mesh.quadmesh import FloatArray, unit_rows

# Corners where an outline turns by less, degrees, are those of a curved side.
CORNER = 10.0
# What a cut may be off, mm: shorter sides are none.
_UNSEEN = 1.0


@dataclass(frozen=True)
class PlateLimits:
    """Bounds of flat plates.

    Attributes:
        angle_deg: smallest angle of a corner.
        side_mm: shortest side.
        aspect: longest by shortest side of the smallest box around a plate.
        smallest_mm: sides of the smallest box that can be worked on, the longer one first.
        largest_mm: sides of the largest box.
        mass_kg: heaviest.
        hole_to_edge: of the thickness, least distance from the edge of a hole to that of the plate.
        hole_to_corner: of the thickness, from the edge of a hole to a corner.
        hole: of the thickness, least diameter.
    """

    angle_deg: float
    side_mm: float
    aspect: float
    smallest_mm: tuple[float, float]
    largest_mm: tuple[float, float]
    mass_kg: float
    hole_to_edge: float = 2.0
    hole_to_corner: float = 6.0
    hole: float = 1.0

    def strictest(self, *others: PlateLimits) -> PlateLimits:
        """What these and others all allow."""
        every = (self, *others)
        return PlateLimits(
            angle_deg=max(each.angle_deg for each in every),
            side_mm=max(each.side_mm for each in every),
            aspect=min(each.aspect for each in every),
            smallest_mm=_pair(np.max([each.smallest_mm for each in every], axis=0)),
            largest_mm=_pair(np.min([each.largest_mm for each in every], axis=0)),
            mass_kg=min(each.mass_kg for each in every),
            hole_to_edge=max(each.hole_to_edge for each in every),
            hole_to_corner=max(each.hole_to_corner for each in every),
            hole=max(each.hole for each in every),
        )


# Holes: EN 12150-1, 7.4. Largest sizes: the stock sizes of EN 572-2, and what usual furnaces hold.
# Angles, sides and aspects are not in standards but in what makers publish: usual values. The mass
# is what one vacuum lifter of a usual crane takes.
LIMITS = {
    "glass": PlateLimits(30.0, 20.0, 10.0, (100.0, 100.0), (6000.0, 3210.0), 500.0),
    "strengthened-glass": PlateLimits(30.0, 20.0, 10.0, (300.0, 200.0), (6000.0, 2800.0), 500.0),
    "toughened-glass": PlateLimits(30.0, 20.0, 10.0, (300.0, 200.0), (6000.0, 2800.0), 500.0),
}


def complaints(
    pattern: FlatPattern, thickness: float, mass: float, name: str, limits: PlateLimits
) -> Iterator[str]:
    """Clauses on what a plate is beyond of, with the place where it is one.

    Args:
        pattern: of the plate.
        thickness: mm.
        mass: kg.
        name: of its material.
        limits: of that.
    """
    yield from _about_corners(as_cut(pattern.outline), name, limits)
    yield from _about_size(pattern.outline, name, limits)
    if mass > limits.mass_kg:
        yield f"weighs {mass:.0f} kg, {name} at most {limits.mass_kg:g} kg"
    yield from _about_holes(pattern, thickness, name, limits)


def wide_enough(outline: FloatArray, limits: PlateLimits) -> bool:
    """Tell whether the box of an outline (N, 2) is neither too small nor too long for its width."""
    longer, shorter = smallest_box(outline)
    least = limits.smallest_mm
    return longer >= least[0] and shorter >= least[1] and longer <= limits.aspect * shorter


def can_be_cut(outline: FloatArray, limits: PlateLimits) -> bool:
    """Tell whether box, corners and sides of an outline (N, 2) are not too small for a material."""
    corners = _about_corners(as_cut(outline), "", limits)
    return wide_enough(outline, limits) and not any(corners)


def corners_of(outline: FloatArray) -> FloatArray:
    """(K, 2) corners of an outline (N, 2) where it turns; between them sides may be curved."""
    return outline[np.abs(turns_of(outline)) >= CORNER]


def as_cut(outline: FloatArray) -> FloatArray:
    """An outline (N, 2) as a glazier cuts it, without sides that nobody sees."""
    steps = np.linalg.norm(np.roll(outline, -1, axis=0) - outline, axis=1)
    return outline[steps > _UNSEEN] if (steps > _UNSEEN).sum() > 2 else outline


def turns_of(outline: FloatArray) -> FloatArray:
    """(N,) by how many degrees a counter-clockwise outline turns at each point, left positive."""
    ahead = unit_rows(np.roll(outline, -1, axis=0) - outline)
    before = np.roll(ahead, 1, axis=0)
    sine = before[:, 0] * ahead[:, 1] - before[:, 1] * ahead[:, 0]
    return np.asarray(np.degrees(np.arctan2(sine, (before * ahead).sum(axis=1))))


def smallest_box(outline: FloatArray) -> tuple[float, float]:
    """Sides of the smallest box around an outline (N, 2), the longer one first, mm."""
    import shapely

    box = np.array(shapely.Polygon(outline).minimum_rotated_rectangle.exterior.coords)
    longer, shorter = sorted(np.linalg.norm(np.diff(box[:3], axis=0), axis=1).tolist())[::-1]
    return longer, shorter


def _about_corners(outline: FloatArray, name: str, limits: PlateLimits) -> Iterator[str]:
    turns = turns_of(outline)
    sharpest = int(turns.argmax())
    angle = 180.0 - float(turns[sharpest])
    if angle < limits.angle_deg:
        place = _words(outline[sharpest])
        yield f"its corner {place} has {angle:.1f} degrees, {name} needs {limits.angle_deg:g}"
    numbers = np.flatnonzero(np.abs(turns) >= CORNER)
    if len(numbers) < 2:
        return
    steps = np.linalg.norm(np.roll(outline, -1, axis=0) - outline, axis=1)
    way = np.concatenate([[0.0], np.cumsum(steps)])
    sides = np.roll(way[numbers], -1) - way[numbers]
    sides[-1] += way[-1]
    shortest = int(sides.argmin())
    if sides[shortest] < limits.side_mm:
        yield (
            f"its side from the corner {_words(outline[numbers[shortest]])} is "
            f"{sides[shortest]:.1f} mm long, {name} needs {limits.side_mm:g} mm"
        )


def _about_size(outline: FloatArray, name: str, limits: PlateLimits) -> Iterator[str]:
    longer, shorter = smallest_box(outline)
    size = f"{longer:.0f} x {shorter:.0f} mm"
    for beyond, what, bound in (
        (longer > limits.largest_mm[0] or shorter > limits.largest_mm[1], "at most", "largest_mm"),
        (
            longer < limits.smallest_mm[0] or shorter < limits.smallest_mm[1],
            "at least",
            "smallest_mm",
        ),
    ):
        if beyond:
            most, least = getattr(limits, bound)
            yield f"it is {size}, {name} {what} {most:g} x {least:g} mm"
    if longer > limits.aspect * shorter:
        yield f"it is {size}, {name} at most {limits.aspect:g} times as long as wide"


def _about_holes(
    pattern: FlatPattern, thickness: float, name: str, limits: PlateLimits
) -> Iterator[str]:
    if not pattern.holes:
        return
    import shapely

    rim, corners = shapely.Polygon(pattern.outline).exterior, corners_of(pattern.outline)
    for hole in pattern.holes:
        place, radius = _words(hole.centre), hole.diameter / 2
        if hole.diameter < limits.hole * thickness:
            yield (
                f"its hole {place} is {hole.diameter:g} mm wide, {name} needs "
                f"{limits.hole * thickness:g} mm"
            )
        to_edge = float(rim.distance(shapely.Point(hole.centre))) - radius
        if to_edge < limits.hole_to_edge * thickness:
            yield (
                f"its hole {place} is {to_edge:.1f} mm from an edge, {name} needs "
                f"{limits.hole_to_edge * thickness:g} mm"
            )
        to_corner = float(np.linalg.norm(corners - hole.centre, axis=1).min()) - radius
        if to_corner < limits.hole_to_corner * thickness:
            yield (
                f"its hole {place} is {to_corner:.1f} mm from a corner, {name} needs "
                f"{limits.hole_to_corner * thickness:g} mm"
            )


def _words(point: FloatArray) -> str:
    """A place of a flat pattern."""
    return f"at {point[0]:.0f}, {point[1]:.0f} mm of its pattern"


def _pair(sizes: FloatArray) -> tuple[float, float]:
    longer, shorter = sizes.tolist()
    return longer, shorter
