"""Can a panel be put in between its neighbours: bevelled sides that lean together on the way in.

Square panels go in along their own normals, with what stays clear of the gap. Bevelled sides are
parallel to the planes of the beams; where the surface is hollow these lean together, and the panel
is wider at its lower face than the opening that its neighbours leave above.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from scipy.optimize import linprog

from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.beams.frames import beam_frames
from freecad_ortho.fabrication.systems.panels.geometry import sides_of
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import FloatArray

# What a panel may press into the joints, mm.
_EXACT = 1e-6


def closing(
    normals: FloatArray, inward: FloatArray, beside: BoolArray, thickness: float, gap: float
) -> FloatArray:
    """(F,) by how much sides close in on the way in, mm, along the direction that is best.

    Exact where that exceeds the gap along the panel's normal, else as it is along the normal.

    Args:
        normals: (F, 3) of the panels.
        inward: (F, 4, 3) unit normals of the planes that the sides are parallel to, into the face.
        beside: (F, 4) true where there is a neighbour.
        thickness: of the panels, mm.
        gap: between neighbours, mm.
    """
    lean = -thickness * np.einsum("fck,fk->fc", inward, normals)
    found = np.where(beside, lean, 0.0).max(axis=1)
    for face in np.flatnonzero(found > gap + _EXACT).tolist():
        found[face] = _along_the_best_way(normals[face], inward[face][beside[face]], thickness)
    return np.asarray(np.maximum(found, 0.0))


def _along_the_best_way(normal: FloatArray, inward: FloatArray, thickness: float) -> float:
    """The least that sides (S, 3) close in by, in any direction that rises by 1."""
    across = np.linalg.svd(normal[None])[2][1:]
    sides = np.column_stack([-inward @ across.T, -np.ones(len(inward))])
    solved = linprog([0, 0, 1], A_ub=sides, b_ub=inward @ normal, bounds=[(None, None)] * 3)
    # Unbounded where the sides leave a way out that opens for ever.
    return thickness * max(float(solved.fun), 0.0) if solved.success else 0.0


def judged(
    parts: Sequence[Part], closes: FloatArray, gap: float
) -> tuple[tuple[Part, ...], list[str]]:
    """Panels with what keeps them from being put in, and a message where something does.

    Args:
        parts: the panels.
        closes: by how much the sides of each close in on the way in, mm.
        gap: between neighbours, mm.
    """
    stuck = np.flatnonzero(closes > gap + _EXACT).tolist()
    if not stuck:
        return tuple(parts), []
    result = list(parts)
    for panel in stuck:
        words = (
            f"cannot be put in last, its bevelled sides close in by {closes[panel]:.3g} mm on the "
            f"way and the gap is {gap:g} mm"
        )
        result[panel] = replace(parts[panel], assembly=words)
    first = result[stuck[0]]
    return tuple(result), [
        f"panels: {len(stuck)} of {len(parts)} cannot be put in between their neighbours, "
        f"{first.name} for one: it {first.assembly}; a larger gap, thinner panels or square edges "
        "help"
    ]


def inward_normals(site: Site) -> FloatArray:
    """(F, 4, 3) normals of the beams' planes at the sides of each face, into the face."""
    net = site.mesh.connectivity
    edges, on_left = sides_of(net, net.by_size[0])
    left = beam_frames(site.mesh, site.axes).left[edges]
    return np.where(on_left[:, :, None], left, -left)
