"""The table of offset meshes in docs/sources.md, from the nets of the paper's authors."""

from __future__ import annotations

from bench import ROOT, SHARED, write

from freecad_ortho import api

NAMES = ("heart", "conical1", "botanic-garden-bubble-0")
NETS = ("principal", "circular", "conical")
KINDS = ("parallel", "vertex", "edge", "face")
EDGE, DISTANCE = 1000.0, 100.0


def table() -> str:
    """Largest miss of each kind on each net, in mm."""
    rows = [
        "| mesh | net | " + " | ".join(f"{kind}, mm" for kind in KINDS) + " |",
        "| --- | --- |" + " --- |" * len(KINDS),
    ]
    for name in NAMES:
        start = api.read_mesh(SHARED / f"{name}.obj").mesh
        start = start.scaled(EDGE / start.mean_edge)
        for net in NETS:
            mesh = api.optimise(start, net=net).mesh
            misses = [api.offset_mesh(mesh, DISTANCE, kind).miss.max() for kind in KINDS]
            rows.append(f"| {name} | {net} | " + " | ".join(f"{m:.1e}" for m in misses) + " |")
    return "\n".join(rows)


def main() -> None:
    """Write the table into the document."""
    write(ROOT / "docs" / "sources.md", "offset", table())


if __name__ == "__main__":
    main()
