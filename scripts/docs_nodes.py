"""Makes the close pictures of nodes in docs/fabrication.md, each at a vertex of the demo's net.

Run with the project's Python:  python scripts/docs_nodes.py [KIND ...]
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path
from typing import Any

from docs_pictures import PICTURES, ROOT, api, draw_in_freecad, shrink

# Beams at the node of each kind.
KINDS: dict[str, dict[str, Any]] = {
    "bolted": {"section": "tube:100x60x5"},
    "ball": {"section": "chs:88.9x5"},
    "star": {"section": "I", "thickness": 10.0, "section_width": 80.0, "height": 160.0},
}
# A vertex inside of the demo's net, and how far around it parts are shown, mm.
VERTEX, REACH = 262, 420.0


def main() -> None:
    """Make the pictures of the kinds that are named, by default of all."""
    with tempfile.TemporaryDirectory() as folder:
        mesh = api.read_mesh(ROOT / "examples" / "data" / "demo_roof.obj").mesh
        net = api.optimise(mesh.scaled(1200.0 / mesh.mean_edge), net="principal").mesh
        api.write_mesh(Path(folder) / "net.obj", net, "mm")
        for kind in sys.argv[1:] or KINDS:
            draw(kind, Path(folder))


def draw(kind: str, folder: Path) -> None:
    """Have FreeCAD draw a node from near, one of its beams pulled back."""
    order = {
        "paths": [str(ROOT), str(ROOT / "scripts")],
        "mesh": str(folder / "net.obj"),
        "beams": KINDS[kind],
        "node": kind,
        "vertex": VERTEX,
        "reach": REACH,
        "picture": str(folder / f"{kind}.png"),
    }
    draw_in_freecad("docs_nodes_freecad.py", order, folder, seconds=900)
    shrink(folder / f"{kind}.png", PICTURES / f"node-{kind}.png", 800)


if __name__ == "__main__":
    main()
