"""Dense nesting by an optional library (spyrrow), one sheet at a time.

The library packs outlines into a strip of given height, as short as it can, in single precision.
A sheet is the beginning of a strip: whatever lies beyond its width waits for the next one. Outlines
are given to it with half of the spacing around them, and what it returns is checked.
"""

from __future__ import annotations

import importlib.util
from collections.abc import Callable, Sequence

import numpy as np

from freecad_ortho.fabrication.nesting.sheet import Placement, turned
from freecad_ortho.fabrication.nesting.strip import LIBRARY, StripPacker
from freecad_ortho.fabrication.workshop import Workshop
from solver.isolated import Isolated, LibraryError
from solver.mesh.quadmesh import FloatArray

_SECONDS = 1
# What the search, its set-up and a busy machine may take together, in seconds.
_TIME_LIMIT = 60.0
# Area of the outlines that are offered, in areas of the sheet: more than can fit.
_OFFER = 1.15
# Single precision at the size of a sheet, mm: outlines may come closer than asked by this much.
_PRECISION = 0.01
# Corners of the spacing around an outline are cut off beyond so many halves of it.
_MITRE_LIMIT = 2.0


class Library:
    """The library in a process of its own, for all sheets of a nesting; use it in a ``with``."""

    def __init__(self, workshop: Workshop) -> None:
        self._workshop = workshop
        self._packer = Isolated(StripPacker)

    def __enter__(self) -> Library:
        """Return the library itself."""
        return self

    def __exit__(self, *_: object) -> None:
        """End its process."""
        self._packer.close()

    def one_sheet(
        self, items: Sequence[Placement], waiting: Callable[[], object]
    ) -> tuple[Placement, ...]:
        """Lay as many patterns as fit onto one sheet, large ones first.

        Args:
            items: each turned so that it fits the sheet as it is.
            waiting: called while the library works; may raise to stop.

        Returns:
            Those that found room: each once, on the sheet, no closer than the spacing.

        Raises:
            LibraryError: the library failed, or laid parts where they cannot lie.
        """
        width, height = self._workshop.sheet or (0.0, 0.0)
        half = self._workshop.spacing / 2
        strip = height - 2 * half
        angles = [0.0, 180.0] if self._workshop.grain == "along" else [0.0, 90.0, 180.0, 270.0]
        offered, outlines, turns = [], [], []
        for item in _offered(items, width * height):
            outline = _with_room(turned(item.pattern.outline, item.angle_deg), half + _PRECISION)
            sizes = np.ptp(outline, axis=0)
            fitting = [a for a in angles if sizes[1 if a % 180 == 0 else 0] < strip]
            if fitting:
                offered.append(item)
                outlines.append([tuple(point) for point in outline.tolist()])
                turns.append(fitting)
        if not offered:
            return ()
        placed = self._packer.call(
            *("pack", outlines, turns, strip, _SECONDS, self._workshop.seed),
            time_limit=_TIME_LIMIT,
            waiting=lambda part: waiting(),
        )
        result = []
        for number, turn, x, y in placed:
            item = offered[number]
            shift = np.array([x, y]) + half
            placement = Placement(item.name, item.pattern, (item.angle_deg + turn) % 360, shift)
            if placement.outline[:, 0].max() <= width - 2 * half + _PRECISION:
                result.append(placement)
        if result:
            _check(result, self._workshop)
        return tuple(result)


def is_there() -> bool:
    """Tell whether the library is installed."""
    return importlib.util.find_spec(LIBRARY) is not None


def _with_room(outline: FloatArray, room: float) -> FloatArray:
    """An outline with some room around it, without the corners that make no difference."""
    from shapely import Polygon

    grown = Polygon(outline).buffer(room, join_style="mitre", mitre_limit=_MITRE_LIMIT)
    return np.array(grown.simplify(_PRECISION / 2).exterior.coords)[:-1]


def _check(placements: Sequence[Placement], workshop: Workshop) -> None:
    from shapely import Polygon, STRtree, box

    names = [placement.name for placement in placements]
    if len(set(names)) < len(names):
        raise LibraryError("it laid a part twice")
    outlines = [Polygon(placement.outline) for placement in placements]
    least = max(workshop.spacing - _PRECISION, 0.0)
    width, height = workshop.sheet or (0.0, 0.0)
    inner = box(least, least, width - least, height - least)
    outside = [
        name for name, outline in zip(names, outlines, strict=True) if not inner.covers(outline)
    ]
    if outside:
        raise LibraryError(f"it laid {outside[0]} over the rim of the sheet")
    first, second = STRtree(outlines).query(outlines, predicate="dwithin", distance=least)
    for one, two in zip(first.tolist(), second.tolist(), strict=True):
        if one < two and outlines[one].distance(outlines[two]) < least:
            raise LibraryError(f"it laid {names[one]} too close to {names[two]}")


def _offered(items: Sequence[Placement], sheet: float) -> list[Placement]:
    chosen: list[Placement] = []
    area = 0.0
    for item in sorted(items, key=lambda item: (-item.pattern.area, item.name)):
        if area + item.pattern.area <= _OFFER * sheet:
            chosen.append(item)
            area += item.pattern.area
    return chosen
