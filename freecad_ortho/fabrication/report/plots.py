"""Histograms as SVG text."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

import numpy as np

_BINS, _WIDTH, _HEIGHT = 24, 300, 120


def histogram(title: str, unit: str, values: Sequence[float], limit: float | None = None) -> str:
    """Draw how many parts have which value, and the limit where it is in sight."""
    data = np.asarray(values, dtype=float)
    low, high = float(data.min()), float(data.max())
    if high - low <= 1e-9 * max(abs(high), 1e-9):
        low, high = low - 0.5 * (abs(low) or 1), high + 0.5 * (abs(high) or 1)
    counts, _ = np.histogram(data, _BINS, (low, high))
    bar = _WIDTH / _BINS
    shapes = []
    for number, count in enumerate(counts.tolist()):
        tall = _HEIGHT * count / counts.max()
        if count:
            shapes.append(
                f'<rect class="bar" x="{number * bar:.2f}" y="{_HEIGHT - tall:.2f}" '
                f'width="{bar - 1:.2f}" height="{tall:.2f}"><title>{count} parts</title></rect>'
            )
    if limit is not None and low <= limit <= high:
        x = _WIDTH * (limit - low) / (high - low)
        shapes.append(f'<path class="limit" d="M{x:.1f} 0V{_HEIGHT}"/>')
    base = _HEIGHT + 16
    words = f"{title}, {unit}"
    return (
        f'<figure><svg xmlns="http://www.w3.org/2000/svg" role="img" aria-label="{escape(words)}" '
        f'viewBox="-6 -16 {_WIDTH + 12} {_HEIGHT + 40}"><text x="0" y="-4">{counts.max()}</text>'
        f'{"".join(shapes)}<path class="axis" d="M0 {_HEIGHT}H{_WIDTH}"/>'
        f'<text x="0" y="{base}">{low:.4g}</text>'
        f'<text x="{_WIDTH}" y="{base}" text-anchor="end">{high:.4g}</text></svg>'
        f"<figcaption>{escape(words)}</figcaption></figure>"
    )
