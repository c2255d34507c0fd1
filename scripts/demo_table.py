"""The ten lines that close the demo, for an engineer."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from demo_picture import Begin, worst_orthogonality

from solver.analysis import measures
from solver.mesh.quadmesh import FloatArray, QuadMesh


def table(
    begin: Begin,
    net: QuadMesh,
    optimised: dict[str, Any],
    parts: Sequence[dict[str, str]],
    out: str,
    files: Sequence[str],
    seconds: float,
) -> str:
    """Put the demo's result into ten lines.

    Args:
        begin: what it began with, in mm.
        net: the exact net, in mm.
        optimised: the report of the optimisation.
        parts: rows of parts.csv.
        out: folder that holds the files.
        files: their names.
        seconds: time for everything.
    """
    beams = [row for row in parts if row["kind"] == "beam"]
    panels = [row for row in parts if row["kind"] == "panel"]
    heights = numbers(beams, "height_mm")
    drawn = begin.mesh
    moved = np.linalg.norm(net.vertices - drawn.vertices, axis=1)
    way = f"{optimised['status']} in {optimised['iterations']} steps, {optimised['seconds']:.1f} s"
    near = f"mean {moved.mean():,.0f} mm, most {moved.max():,.0f} mm"
    if begin.off_surface is not None:
        near = f"{begin.off_surface:,.0f} mm off the surface at most"
    size = " x ".join(f"{side / 1000:.3g}" for side in np.ptp(drawn.vertices, axis=0))
    orthogonality = [worst_orthogonality(mesh) for mesh in (drawn, net)]
    planarity = [float(measures.planarity(mesh).max()) for mesh in (drawn, net)]
    warp = [float(measures.diagonal_distances(mesh).max()) for mesh in (drawn, net)]
    rows = [
        ("mesh", f"{len(drawn.faces)} quads, {len(drawn.vertices)} vertices, {size} m"),
        ("orthogonality", f"worst face {arrow(orthogonality)} (unequal diagonals, 0 is exact)"),
        (
            "planarity",
            f"worst face {arrow(planarity)}, out of plane {warp[0]:.3g} mm -> {warp[1]:.2g} mm",
        ),
        ("moved" if begin.off_surface is None else "form", f"{near}; {way}"),
        (
            "beams",
            f"{len(beams)} plates, {numbers(beams, 'length_mm').sum() / 1000:,.0f} m in all, "
            f"{float(beams[0]['thickness_mm']):g} mm thick",
        ),
        (
            "beam twist",
            f"worst {numbers(beams, 'twist_deg').max():.1e} degrees (0 is torsion-free)",
        ),
        ("beam height", f"{heights.min():.1f} to {heights.max():.1f} mm"),
        (
            "panels",
            f"{len(panels)} plates, {numbers(panels, 'area_mm2').sum() / 1e6:,.1f} m2, "
            f"{float(panels[0]['thickness_mm']):g} mm thick",
        ),
        (
            "mass",
            f"{numbers(parts, 'mass_kg').sum() / 1000:,.3g} t of steel, all parts together",
        ),
        ("files", f"{out}/: {', '.join(files)}; {seconds:.0f} s"),
    ]
    width = max(len(name) for name, _ in rows)
    return "\n".join(f"{name:<{width}}  {text}" for name, text in rows)


def numbers(rows: Sequence[dict[str, str]], column: str) -> FloatArray:
    """Read one column of parts.csv."""
    return np.array([float(row[column]) for row in rows])


def arrow(values: Sequence[float]) -> str:
    """Write a measure before and after."""
    return f"{values[0]:.2g} -> {values[1]:.1e}"
