"""Boxes into a sheet from below: each comes to lie as low as it can, then as far left.

Source: J. Jylanki, A thousand ways to pack the bin, 2010 (skyline, bottom-left).
"""

from __future__ import annotations

Segment = tuple[float, float, float]
# Boxes that fill a sheet exactly may miss by rounding.
_ROUNDING = 1e-9


class Skyline:
    """The upper rim of the boxes in a sheet that is being filled."""

    def __init__(self, width: float, height: float) -> None:
        self._height = height * (1 + _ROUNDING)
        self._width = width * (1 + _ROUNDING)
        self._rim: list[Segment] = [(0.0, width, 0.0)]

    def place(self, *sizes: tuple[float, float]) -> tuple[int, float, float] | None:
        """Put in one box, in the best of its possible sizes.

        Returns:
            The number of the size chosen and the box's lower left corner; None where none fits.
        """
        best: tuple[float, float, int] | None = None
        for number, (width, height) in enumerate(sizes):
            for start in range(len(self._rim)):
                found = self._level(start, width)
                if found is None or found + height > self._height:
                    continue
                key = (found + height, self._rim[start][0], number)
                if best is None or key < best:
                    best = key
        if best is None:
            return None
        top, x, number = best
        width, height = sizes[number]
        self._raise(x, x + width, top)
        return number, x, top - height

    def _level(self, start: int, width: float) -> float | None:
        """Height at which a box would lie whose left side stands at a segment's start."""
        left = self._rim[start][0]
        if left + width > self._width:
            return None
        level = 0.0
        for x, _, height in self._rim[start:]:
            if x >= left + width - _ROUNDING:
                break
            level = max(level, height)
        return level

    def _raise(self, left: float, right: float, top: float) -> None:
        rim: list[Segment] = []
        for x, end, height in self._rim:
            if x < left:
                rim.append((x, min(end, left), height))
            if end > right:
                rim.append((max(x, right), end, height))
        rim.append((left, right, top))
        self._rim = []
        for x, end, height in sorted(rim):
            if self._rim and self._rim[-1][2] == height:
                self._rim[-1] = (self._rim[-1][0], end, height)
            elif end - x > _ROUNDING:
                self._rim.append((x, end, height))
