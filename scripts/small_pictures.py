"""Figures as small PNG files. Imported before pyplot, it keeps windows shut."""

from __future__ import annotations

from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
from matplotlib.figure import Figure
from PIL import Image


def save(figure: Figure, path: Path, colours: int) -> None:
    """Write a figure with no more than so many colours, and close it."""
    figure.savefig(path)
    plt.close(figure)
    with Image.open(path) as picture:
        picture.convert("RGB").quantize(colours).save(path, optimize=True)
