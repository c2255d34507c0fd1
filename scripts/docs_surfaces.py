"""Makes the pictures of surfaces in docs/gallery.md: directions, net, and parts cut at the border.

Run with the project's Python:  python scripts/docs_surfaces.py [SURFACE ...]
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import numpy as np
from docs_align import EDGE, SURFACES, sheet
from docs_gallery import PICTURES, shrink

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from examples.drawing import GLASS, WOOD, Panel, draw  # noqa: E402
from freecad_ortho.fabrication import Beams, Panels, build  # noqa: E402
from solver import Constraints, QuadMesh, optimise  # noqa: E402
from solver.align.align import Aligned, aligned  # noqa: E402
from solver.align.reach import reaching  # noqa: E402
from solver.mesh.closest import TriangleSurface  # noqa: E402
from solver.mesh.quadmesh import FloatArray  # noqa: E402

_RISE, _BELOW = 48.0, -38.0
_A_PICTURE = 3
# Metres of the surfaces, millimetres of the parts.
_MM = 1000.0
# Thicker than they would be built, to be seen.
_SYSTEMS = Beams(450, 50), Panels(12, 10)


def row(name: str) -> list[Panel]:
    """Three views of one surface."""
    surface = TriangleSurface.from_quads(sheet(name, (121, 73)))
    made = aligned(surface.vertices, surface.triangles, edge=float(EDGE))
    close_to = reaching(made.mesh, surface.vertices, surface.triangles)
    net = optimise(made.mesh, "principal", constraints=Constraints(close_to=close_to)).mesh
    lines = [np.concatenate([line, line[:1]]) for line in made.border]
    singular = made.mesh.vertices[made.irregular]
    drawn = sheet(name, (31, 19))
    parts = bodies(net, made.border)
    return [
        Panel(name, None, rise=_RISE, ground=drawn, fine=crosses(made), lines=lines),
        Panel(f"{len(net.faces)} flat quads", net, rise=_RISE, lines=lines, points=singular),
        Panel("beams and panels, from below", None, rise=_BELOW, bodies=parts),
    ]


def crosses(made: Aligned) -> list[FloatArray]:
    """Some of the directions of the field, each a line (2, 3), one about every edge."""
    field, edge = made.field, made.mesh.mean_edge
    chosen: list[int] = []
    for number, place in enumerate(field.places):
        if not chosen or np.linalg.norm(field.places[chosen] - place, axis=1).min() > 1.5 * edge:
            chosen.append(number)
    arms = 0.5 * edge * field.directions[chosen]
    places = field.places[chosen, None]
    return [line for pair in np.stack([places - arms, places + arms], axis=2) for line in pair]


def bodies(net: QuadMesh, border: tuple[FloatArray, ...]) -> list[tuple[list[FloatArray], str]]:
    """Sides of beams and panels, in metres."""
    lines = [_MM * line for line in border]
    structure = build(net.scaled(_MM), _SYSTEMS, border=lines)
    found: dict[str, list[FloatArray]] = {GLASS: [], WOOD: []}
    for part in structure.parts:
        colour = GLASS if part.name.startswith("P") else WOOD
        for piece in part.body.pieces():
            corners = (part.origin + piece.corners @ part.frame) / _MM
            found[colour] += [corners[list(loop)] for loop in piece.loops]
    return [(sides, colour) for colour, sides in found.items()]


def main() -> None:
    """Make the pictures, three surfaces each."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", metavar="SURFACE")
    names = parser.parse_args().names or list(SURFACES)
    for start in range(0, len(names), _A_PICTURE):
        some = names[start : start + _A_PICTURE]
        target = PICTURES / f"surfaces-{start // _A_PICTURE + 1}.png"
        draw([panel for name in some for panel in row(name)], target, high=0.75)
        shrink(target)


if __name__ == "__main__":
    main()
