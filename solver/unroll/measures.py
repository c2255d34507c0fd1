"""Measures of a strip and its pattern, in the model's unit and in degrees."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.mesh.quadmesh import FloatArray
from solver.unroll.strip import Strip

# Newton steps to the circle nearest to points; from the algebraic one a few do.
_STEPS = 20
# Share of its rise up to a ruling by which the curvature of a strip may go on rising beyond it.
_OVERSHOOT = 0.25


@dataclass(frozen=True)
class StripMeasures:
    """Numbers of one strip; lengths in the model's unit.

    Attributes:
        length: of the axis.
        straightness: largest distance of the pattern's axis from the straight line nearest to it.
        radius: of the circle nearest to the pattern's axis, inf when it is straight.
        radius_spread: largest distance of the pattern's axis from that circle.
        lean_deg: largest angle between the surface normal and the strip's tangent plane (of a
            lying strip: between the tangent planes of surface and strip).
        twist_deg: largest angle by which the rulings at the ends of an edge miss a common plane.
        torsion_deg: largest turn of the strip about its axis per unit length.
        warp_deg: largest such turn within a face: what bending about the rulings does not make.
        smallest_bend_radius: within the width, inf when nothing bends.
        gap: largest difference in length between an outer edge of a face and its pattern: 0 when
            the strip is developable.
        admissible_width: width at which rulings would meet.
    """

    length: float
    straightness: float
    radius: float
    radius_spread: float
    lean_deg: float
    twist_deg: float
    torsion_deg: float
    warp_deg: float
    smallest_bend_radius: float
    gap: float
    admissible_width: float


def strip_measures(strip: Strip, width: float, normals: FloatArray) -> StripMeasures:
    """Measure a strip of this width against the (K, 3) unit directions that it should contain."""
    radius, spread = fitted_circle(strip.flat_points)
    lean = np.arcsin(np.clip(np.abs(np.einsum("ck,ck->c", strip.normals, normals)), 0, 1))
    turn = strip.bends * np.cos(strip.slant)
    torsion = np.abs(strip.twists + 0.5 * (turn[:-1] + turn[1:])) / strip.lengths
    return StripMeasures(
        length=float(strip.lengths.sum()),
        straightness=straightness(strip.flat_points),
        radius=radius,
        radius_spread=spread,
        lean_deg=float(np.degrees(lean.max())),
        twist_deg=float(np.degrees(np.abs(strip.twists).max())),
        torsion_deg=float(np.degrees(torsion.max())),
        warp_deg=float(np.degrees((np.abs(strip.twists) / strip.lengths).max())),
        smallest_bend_radius=smallest_bend_radius(strip, strip.reach(width / 2)),
        gap=developability_gap(strip, width),
        admissible_width=strip.admissible_width()[0],
    )


def straightness(points: FloatArray) -> float:
    """Largest distance of (K, 2) points from the straight line nearest to them."""
    arms = points - points.mean(axis=0)
    across = np.linalg.svd(arms, full_matrices=False)[2][1]
    return float(np.abs(arms @ across).max())


def fitted_circle(points: FloatArray) -> tuple[float, float]:
    """Radius of the circle nearest to (K, 2) points, and the largest distance from it.

    Two points, or points on a line up to rounding, have the radius inf.
    """
    size = float(np.abs(points - points[0]).max())
    if len(points) < 3 or straightness(points) <= 1e-13 * size:
        return np.inf, straightness(points)
    arms = (points - points.mean(axis=0)) / size
    system = np.concatenate([2 * arms, np.ones((len(arms), 1))], axis=1)
    solution = np.linalg.lstsq(system, (arms**2).sum(axis=1), rcond=None)[0]
    centre = solution[:2]
    # As curvature and distance of the nearest point, so that flat arcs stay well-posed.
    radius = float(np.sqrt(solution[2] + centre @ centre))
    for _ in range(_STEPS):
        spokes = arms - centre
        distance = np.linalg.norm(spokes, axis=1)
        system = np.concatenate([-spokes / distance[:, None], -np.ones((len(arms), 1))], axis=1)
        step = np.linalg.lstsq(system, radius - distance, rcond=None)[0]
        centre, radius = centre + step[:2], radius + float(step[2])
        if np.abs(step).max() <= 1e-14 * radius:
            break
    spread = np.abs(np.linalg.norm(arms - centre, axis=1) - radius).max()
    return float(radius * size), float(spread * size)


def developability_gap(strip: Strip, width: float) -> float:
    """Largest difference in length between an outer edge of a face and its flat pattern."""
    reach = strip.reach(width / 2)[:, None]
    worst = 0.0
    for side in (-1, 1):
        built = np.diff(strip.points + side * reach * strip.rulings, axis=0)
        flat = np.diff(strip.flat_points + side * reach * strip.flat_rulings, axis=0)
        miss = np.linalg.norm(built, axis=1) - np.linalg.norm(flat, axis=1)
        worst = max(worst, float(np.abs(miss).max()))
    return worst


def smallest_bend_radius(strip: Strip, reach: FloatArray, flat_ends: bool = True) -> float:
    """Smallest radius of a strip when its bends are spread over its faces.

    At the axis and at both edges: half the distance to the rulings before and after, measured
    square to the ruling, divided by the bend angle. Between two rulings the curvature may go on
    rising by a quarter of what it rose by before.

    Args:
        strip: at least two points.
        reach: (K,) how far each of its rulings goes to both sides.
        flat_ends: the first and last face stay flat whatever their length, as overhangs do.
    """
    inner = strip.flat_rulings[1:-1]
    sharpest = 0.0
    for side in (-1, 0, 1):
        points = strip.flat_points + side * reach[:, None] * strip.flat_rulings
        steps = np.diff(points, axis=0)
        before, after = (
            np.abs(step[:, 0] * inner[:, 1] - step[:, 1] * inner[:, 0])
            for step in (steps[:-1], steps[1:])
        )
        if not len(inner):
            break
        if flat_ends:
            before[0], after[-1] = after[0], before[-1]
        room = np.maximum(0.5 * (before + after), 1e-300)
        curvature = np.abs(strip.bends[1:-1]) / room
        steps = np.diff(curvature, prepend=curvature[0], append=curvature[-1])
        rise = np.maximum(np.maximum(steps[:-1], -steps[1:]), 0)
        sharpest = max(sharpest, float((curvature + _OVERSHOOT * rise).max()))
    return 1 / sharpest if sharpest > 1e-15 else np.inf
