"""Makes the pictures of docs/gallery.md: each by the example of its name.

Run with the project's Python:  python scripts/docs_gallery.py
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from PIL import Image

ROOT = Path(__file__).resolve().parents[1]
PICTURES = ROOT / "docs" / "pictures" / "gallery"
EXAMPLES = (
    "six_multi_nets",
    "drawn_multi_net",
    "moebius_of_principal_net",
    "torsion_free_roof",
    "minimal_gridshell",
    "triangles_to_gridshell",
)
_COLOURS = 96


def main() -> None:
    """Make all pictures."""
    PICTURES.mkdir(parents=True, exist_ok=True)
    for name in EXAMPLES:
        target = PICTURES / f"{name}.png"
        subprocess.run(
            [sys.executable, "-m", f"examples.{name}", str(target)], cwd=ROOT, check=True
        )
        shrink(target)


def shrink(target: Path) -> None:
    """Save a picture with as few colours as the eye needs: a quarter of the size."""
    with Image.open(target) as picture:
        small = picture.convert("RGB").quantize(_COLOURS, dither=Image.Dither.NONE)
    small.save(target, optimize=True)


if __name__ == "__main__":
    main()
