"""How wide panels lie on the beams: the strip of a beam's upper side that is under a panel."""

from __future__ import annotations

import numpy as np

from freecad_ortho.fabrication.part import Measures
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.beams.geometry import BeamGeometry
from freecad_ortho.fabrication.systems.edge_beam.geometry import EdgeGeometry
from freecad_ortho.fabrication.systems.panels.geometry import sides_of
from solver.mesh.connectivity import Connectivity, SameSize
from solver.mesh.quadmesh import FloatArray


def bearings(
    connectivity: Connectivity,
    beams: BeamGeometry,
    sides: FloatArray,
    same: SameSize | None = None,
) -> FloatArray:
    """(F, 4) least width of each side's bearing, mm; negative beside the beam, NaN without one.

    Across the beam, from its side to the panel's edge, at the worst place along both: the edge is
    straight, so that is where either of them ends.

    Args:
        connectivity: of the net.
        beams: their geometry.
        sides: (F, 4, 2, 3) ends of the lower edges of each panel, in the site's mesh, mm.
        same: the faces of the panels where these are some, with equally many corners.
    """
    edge, on_left = sides_of(connectivity, same or connectivity.by_size[0])
    arms = sides - beams.start[edge][:, :, None]
    local = np.einsum("fsek,fsdk->fsed", arms, beams.frame[edge])
    station, right = local[..., 0], local[..., 2]
    from_middle = np.where(on_left[..., None], -right, right)
    # Corners of the beam's upper side there, in the order of ``LOOPS``.
    top = np.where(on_left[..., None], [11, 10], [7, 8])
    ends = beams.points[edge[..., None], top] - beams.start[edge][:, :, None]
    reach = np.einsum("fsek,fsk->fse", ends, beams.frame[edge][:, :, 0])
    first, last = reach.min(axis=2), reach.max(axis=2)
    low, high = station.min(axis=2), station.max(axis=2)
    shared = np.stack([np.maximum(low, first), np.minimum(high, last)], axis=2)
    span = station[..., 1] - station[..., 0]
    share = (shared - station[..., :1]) / np.where(span == 0, 1.0, span)[..., None]
    across = from_middle[..., :1] + share * (from_middle[..., 1:] - from_middle[..., :1])
    widths = beams.section_half - across.max(axis=2)
    return np.where(beams.built[edge] & (shared[..., 0] < shared[..., 1]), widths, np.nan)


def at_the_edge(site: Site, edge_beam: EdgeGeometry, gap: float) -> FloatArray:
    """(F, 2) width by which each panel lies on an edge beam on up to two sides, mm; NaN for none.

    A panel ends at the border, or half the gap before the boundary of a net that has none.
    """
    inset = 0.0 if site.trimming is not None else gap / 2
    carried = np.arange(2) < edge_beam.carries[:, None]
    return np.where(carried, edge_beam.bearing[:, None] - inset, np.nan)


def least_bearing(widths: FloatArray) -> FloatArray:
    """(F,) of each panel, mm: 0 at most where fewer than two of its sides have a beam."""
    carried = (~np.isnan(widths)).sum(axis=1)
    worst = np.where(np.isnan(widths), np.inf, widths).min(axis=1)
    return np.asarray(np.where(carried >= 2, worst, np.where(worst < 0, worst, 0.0)))


def measures_of(gaps: FloatArray, bearing: FloatArray | None) -> list[Measures]:
    """Of the panel in each face, from distances (F,) from planar and least bearings (F,), mm."""
    wide = [None] * len(gaps) if bearing is None else bearing.tolist()
    pairs = zip(gaps.tolist(), wide, strict=True)
    return [Measures(gap_mm=gap, bearing_mm=width) for gap, width in pairs]
