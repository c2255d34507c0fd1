"""Pictures of docs/exchange.md: pages of the demo roof's drawings and labels.

Run with the project's Python:  python scripts/docs_exchange.py
Needs the packages of requirements-exchange.txt and requirements-dev.txt.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from freecad_ortho import api  # noqa: E402

NET = ROOT / "examples" / "data" / "demo_roof.obj"
PICTURES = ROOT / "docs" / "pictures" / "exchange"
# Pixels to a point of the page.
SHARP = 0.75
# The picture's name, the file, and the page whose text has these words.
PAGES = (
    ("plan", "drawings.pdf", "PLAN\r\n"),
    ("node", "drawings.pdf", "NODE-"),
    ("part", "drawings.pdf", "PART-P"),
    ("sheet", "drawings.pdf", "SHEET-001"),
    ("labels", "labels.pdf", ""),
)


def main() -> int:
    """Write the files of the demo roof, and the pictures."""
    loaded = api.read_mesh(NET)
    structure = api.fabricate(
        loaded.mesh, "nodes+beams+panels", ends="hub", hub_diameter=220.0, unit=loaded.unit
    )
    PICTURES.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as name:
        api.write_fabrication(
            structure,
            name,
            project="demo roof",
            sheet="3000x1500",
            write="drawings,labels",
            paper="a3",
        )
        for picture, file, words in PAGES:
            draw(Path(name) / file, words, PICTURES / f"{picture}.png")
    return 0


def draw(file: Path, words: str, picture: Path) -> None:
    """Draw the first page of a PDF file that has these words."""
    import pypdfium2

    for page in pypdfium2.PdfDocument(file):
        if words in page.get_textpage().get_text_range():
            page.render(scale=SHARP).to_pil().convert("L").quantize(16).save(picture, optimize=True)
            return
    raise SystemExit(f"{file.name}: no page has '{words.strip()}'")


if __name__ == "__main__":
    sys.exit(main())
