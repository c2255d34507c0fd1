"""Which vertices stand on feet, and how far below them the beams reach."""

from __future__ import annotations

import numpy as np

from freecad_ortho.fabrication.cleat import OnCleats
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.beams.geometry import BeamGeometry
from freecad_ortho.fabrication.systems.edge_beam.geometry import EdgeGeometry
from freecad_ortho.fabrication.systems.edge_beam.path import paths_of
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray

# An axis that stands less upright than this, as the sine of its rise, carries no foot.
_FLAT = 0.3


def standing(site: Site, places: str) -> IntArray:
    """(N,) the vertices that a text names: corners, boundary, or numbers joined by commas.

    Of a net with a border its corners are the vertices within it that are nearest to its corners,
    its boundary are those within it at edges that it cuts.

    Raises:
        InputError: no such place or vertex, or an axis that lies flat there.
    """
    named = {"corners": _corners, "boundary": _boundary}
    found = named[places](site) if places in named else _numbered(site, places)
    if not found.any():
        raise InputError(
            f"foot at: the net has no {places}; name vertices by their numbers, 0,12,40"
        )
    numbers = np.flatnonzero(found)
    flat = np.abs(site.axes.directions[numbers, 2]) < _FLAT
    if flat.any():
        raise InputError(
            f"foot at: the axis at vertex {numbers[int(flat.argmax())]} lies too flat for a foot "
            "below it; name other vertices by their numbers"
        )
    return numbers


def _corners(site: Site) -> BoolArray:
    net = site.mesh.connectivity
    if site.trimming is None:
        return np.asarray(net.corners & net.referenced)
    within = np.flatnonzero(site.trimming.vertices(net.edges))
    found = np.zeros(len(site.mesh.vertices), dtype=bool)
    points = np.concatenate([path.points[path.corner] for path in paths_of(site)])
    for point in points:
        away = np.linalg.norm(site.mesh.vertices[within] - point, axis=1)
        found[within[int(away.argmin())]] = True
    return found


def _boundary(site: Site) -> BoolArray:
    net = site.mesh.connectivity
    if site.trimming is None:
        return np.asarray(net.boundary_vertices & net.referenced)
    within = site.trimming.vertices(net.edges)
    found = np.zeros_like(within)
    cut = within[net.edges].sum(axis=1) == 1
    found[net.edges[cut].ravel()] = True
    return found & within


def _numbered(site: Site, text: str) -> BoolArray:
    found = np.zeros(len(site.mesh.vertices), dtype=bool)
    for word in text.split(","):
        number = int(word) if word.strip().isdecimal() else -1
        if not 0 <= number < len(found):
            raise InputError(
                f"foot at: expected corners, boundary or numbers of vertices from 0 to "
                f"{len(found) - 1}, got '{word[:40]}'"
            )
        found[number] = True
    return found


def undersides(
    site: Site, numbers: IntArray, levels: tuple[float, float], reach: float
) -> FloatArray:
    """(N,) how far below vertices a level plate is clear of what meets there, along the axes, mm.

    Args:
        site: the net, and what was built on it.
        numbers: (N,) of the vertices.
        levels: lower and upper one of the beams along the axes, mm, where none were built.
        reach: of the plate from the axis, mm: beams that slope down come lower there.
    """
    beams = site.geometry_of("beams", BeamGeometry)
    edge_beam = site.geometry_of("edge-beam", EdgeGeometry)
    low, high = levels if beams is None else beams.levels
    length = np.linalg.norm(site.axes.offsets[numbers], axis=1)
    # Where the net's upper side faces down, its own lower side is above.
    down = -np.sign(site.axes.directions[numbers, 2])
    level = np.where(down < 0, -low, high) * length
    if edge_beam is not None:
        deepest = edge_beam.height - edge_beam.top + float(edge_beam.drop.max())
        level = np.maximum(level, np.where(down < 0, deepest, edge_beam.top))
    hubs = site.geometry_of("nodes", dict) or {}
    lamellas = site.geometry_of("lamellas", OnCleats)
    for row, vertex in enumerate(numbers.tolist()):
        axis = down[row] * site.axes.directions[vertex]
        if lamellas is not None:
            arms = lamellas.around[vertex] - site.mesh.vertices[vertex]
            level[row] = float((arms @ axis).max())
            continue
        steepest = _steepest(site, vertex, axis)
        level[row] += reach * steepest
        if vertex in hubs:
            arms = np.asarray(hubs[vertex]).reshape(-1, 3) - site.mesh.vertices[vertex]
            level[row] = max(level[row], float((arms @ axis).max()))
    return np.asarray(level)


def _steepest(site: Site, vertex: int, axis: FloatArray) -> float:
    """The steepest slope of the edges at a vertex towards an axis; 0 where none falls."""
    edges = site.mesh.connectivity.edges
    ends = edges[(edges == vertex).any(axis=1)]
    others = ends[ends != vertex]
    arms = site.mesh.vertices[others] - site.mesh.vertices[vertex]
    falls = arms @ axis
    across = np.sqrt(np.maximum((arms**2).sum(axis=1) - falls**2, 1e-12))
    return max(float((falls / across).max(initial=0.0)), 0.0)
