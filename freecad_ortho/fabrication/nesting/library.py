"""Dense nesting by an optional library (spyrrow), one sheet at a time.

The library packs outlines into a strip of given height, as short as it can, in single precision.
A sheet is the beginning of a strip: whatever lies beyond its width waits for the next one.
"""

from __future__ import annotations

import importlib.util
from collections.abc import Sequence

import numpy as np

from freecad_ortho.fabrication.nesting.sheet import Placement, turned
from freecad_ortho.fabrication.workshop import Workshop

LIBRARY = "spyrrow"
_SECONDS = 1
# Area of the outlines that are offered, in areas of the sheet: more than can fit.
_OFFER = 1.15
# Single precision at the size of a sheet, mm: outlines may come closer than asked by this much.
_PRECISION = 0.01


def is_there() -> bool:
    """Tell whether the library is installed."""
    return importlib.util.find_spec(LIBRARY) is not None


def one_sheet(items: Sequence[Placement], workshop: Workshop) -> tuple[Placement, ...]:
    """Lay as many patterns as fit onto one sheet, large ones first.

    Args:
        items: each turned so that it fits the sheet as it is.
        workshop: with a sheet size.

    Returns:
        Those that found room.
    """
    import spyrrow

    width, height = workshop.sheet or (0.0, 0.0)
    offered = _offered(items, width * height)
    spacing = workshop.spacing + _PRECISION
    strip = height - 2 * workshop.spacing
    angles = [0.0, 180.0] if workshop.grain == "along" else [0.0, 90.0, 180.0, 270.0]
    shapes = [turned(item.pattern.outline, item.angle_deg) for item in offered]
    entries = []
    for number, shape in enumerate(shapes):
        # An orientation that is higher than the strip brings the library down.
        sizes = np.ptp(shape, axis=0)
        fitting = [a for a in angles if sizes[1 if a % 180 == 0 else 0] < strip]
        if fitting:
            points = [tuple(point) for point in shape.tolist()]
            entries.append(spyrrow.Item(str(number), points, 1, fitting))
    if not entries:
        return ()
    search = spyrrow.StripPackingConfig(
        total_computation_time=None,
        exploration_time=_SECONDS,
        compression_time=_SECONDS,
        min_items_separation=spacing,
        num_workers=1,
        seed=workshop.seed,
    )
    solution = spyrrow.StripPackingInstance("", strip, entries).solve(search)
    result = []
    for placed in solution.placed_items:
        item, shape = offered[int(placed.id)], shapes[int(placed.id)]
        points = turned(shape, placed.rotation) + placed.translation
        room = width - 2 * workshop.spacing
        inside = (
            points.min() >= -_PRECISION
            and (points.max(axis=0) <= np.array([room, strip]) + _PRECISION).all()
        )
        if inside:
            shift = np.array(placed.translation) + workshop.spacing
            angle = (item.angle_deg + placed.rotation) % 360
            result.append(Placement(item.name, item.pattern, angle, shift))
    return tuple(result)


def _offered(items: Sequence[Placement], sheet: float) -> list[Placement]:
    chosen: list[Placement] = []
    area = 0.0
    for item in sorted(items, key=lambda item: (-item.pattern.area, item.name)):
        if area + item.pattern.area <= _OFFER * sheet:
            chosen.append(item)
            area += item.pattern.area
    return chosen
