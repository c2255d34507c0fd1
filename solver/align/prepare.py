"""A design surface made ready for a net: mended, smooth, carried on, fine enough."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from solver.align.apron import extended
from solver.align.features import creased
from solver.align.jets import face_tensors, fitted
from solver.align.mend import mended, relaxed
from solver.align.refine import refined
from solver.align.triangle_mesh import TriangleMesh
from solver.mesh.quadmesh import FloatArray
from solver.sentence import Measured, Sentence

# In edges of the net: how far curvature is looked for, and what the surface is carried on by; how
# far points count for that, also of noisy ones, and how fine the strips are; the longest edge of a
# triangle.
_RADIUS, _APRON, _OUTWARDS, _NOISY, _STRIPS, _LONGEST = 1.0, 2.0, 1.5, 3.0, 6, 0.5
# By what part of an edge a net overhangs the border at least: its vertices move when it is made
# exact, and the border is to be covered then too.
_MARGIN = 0.25
# A surface that leaves its smooth fit by more than this part of an edge is rough.
_ROUGH = 2e-3
# This near to a crease, in edges, nothing is smoothed.
_BLUNT = 1.5
# An opening less than this part of an edge across is a fault of the triangles.
_PINHOLE = 0.25
# So is one shorter than an edge that is as narrow as this part of it; narrower than the last, it
# is shut.
_SLIT, _SHUT = 0.02, 1e-6
# How often points of a rough surface move along it, to the middle of their neighbours.
_RELAXED = 5


@dataclass(frozen=True, eq=False)
class Work:
    """A surface made ready: carried on beyond its border, fine enough, with its curvature.

    Attributes:
        mesh: the triangles.
        inner: how many of them are the surface's own.
        covered: how many are to be covered by the net: these, and the strip along the border.
        tensors: (T, 2, 2) shape operators in the triangles' frames.
    """

    mesh: TriangleMesh
    inner: int
    covered: int
    tensors: FloatArray

    @classmethod
    def of(cls, surface: TriangleMesh, edge: float, shorter: float, noisy: bool) -> Work:
        """Carry a smooth surface on, fit its curvature, and refine it."""
        margin = _MARGIN * shorter
        larger, covered = carried(surface, _APRON * edge, edge, noisy, margin)
        jets = fitted(larger, np.arange(len(larger.points)), _RADIUS * edge)
        inner = len(surface.triangles)
        mesh, tensors, counts = refined(
            larger, jets.shape_tensors(), (inner, covered - inner), _LONGEST * shorter
        )
        return cls(mesh, counts[0], sum(counts), face_tensors(mesh, tensors))


def prepared(
    surface: TriangleMesh, edge: float, shorter: float, remarks: list[str]
) -> tuple[TriangleMesh, Work]:
    """Make a surface ready.

    Args:
        surface: as it was given.
        edge: wanted edge length.
        shorter: the shorter of the two wanted edge lengths.
        remarks: gets a sentence where the surface is rough.

    Returns:
        the surface without its noise, with the same numbers of points, and what to work on.
    """
    smooth, rough = smoothed(mended(surface, edge), edge)
    if rough:
        remarks.append(
            Sentence(
                "the surface is rough, by {} within an edge; the net is on a smooth one through it",
                Measured(rough, digits=2),
            )
        )
    return smooth, Work.of(smooth, edge, shorter, rough > 0)


def openings(surface: TriangleMesh, edge: float, remarks: list[str]) -> list[list[int]]:
    """Vertices of the border's loops without pinholes and slits, which are taken for faults.

    Where faces meet whose vertices along the seam are not the same, it gapes between some of them.
    """
    loops = surface.loops()
    spans = [float(np.linalg.norm(np.ptp(surface.points[loop], axis=0))) for loop in loops]
    across = [
        min(span, _width(surface.points[loop], span)) if span < edge else span
        for loop, span in zip(loops, spans, strict=True)
    ]
    faults = [
        span <= _PINHOLE * edge or wide <= _SLIT * edge
        for span, wide in zip(spans, across, strict=True)
    ]
    kept = [loop for loop, fault in zip(loops, faults, strict=True) if not fault]
    if not kept or len(kept) == len(loops):
        return loops
    gapes = [wide for wide, fault in zip(across, faults, strict=True) if fault]
    if max(gapes) > _SHUT * edge:
        widest = Measured(max(gapes), digits=2)
        remarks.append(Sentence("pinholes are closed: {}, {} across at most", len(gapes), widest))
    return kept


def _width(loop: FloatArray, span: float) -> float:
    """About how wide an opening is across its longest extent."""
    turned = np.cross(loop - loop[0], np.roll(loop, -1, axis=0) - loop[0]).sum(axis=0)
    return float(np.linalg.norm(turned)) / max(span, float(np.finfo(float).tiny))


def carried(
    surface: TriangleMesh, width: float, edge: float, noisy: bool, margin: float | None = None
) -> tuple[TriangleMesh, int]:
    """Carry a surface on beyond its border by a width, for a net with edges of a length.

    Of points that have been noisy, one degree less is believed, and more of them are asked.

    Returns:
        the larger surface, and how many of its triangles are the given ones and those of a strip of
        the width ``margin`` along the border.
    """
    size = float(np.sqrt(2 * surface.areas.mean()))
    step = min(max(size, edge / _STRIPS), edge)
    radius = (_NOISY if noisy else _OUTWARDS) * edge
    return extended(surface, width, step, radius, 2 if noisy else 3, margin)


def smoothed(surface: TriangleMesh, edge: float) -> tuple[TriangleMesh, float]:
    """The surface without its noise, and how much that was, 0 where there is hardly any.

    What is rough within an edge has no lines to follow.
    """
    jets = fitted(surface, np.arange(len(surface.points)), _RADIUS * edge)
    off = jets.coefficients[:, 0] * jets.scale
    sharp = creased(surface, edge)
    if sharp.any():
        # A crease is no roughness.
        ends = np.unique(np.concatenate([side[sharp] for side in surface.ends]))
        off[cKDTree(surface.points[ends]).query(surface.points)[0] < _BLUNT * edge] = 0.0
    rough = float(np.sqrt((off * off).mean()))
    if rough < _ROUGH * edge:
        return surface, 0.0
    points = surface.points + off[:, None] * jets.axes[:, 2]
    return relaxed(TriangleMesh(points, surface.triangles), _RELAXED), rough
