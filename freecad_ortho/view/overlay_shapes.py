"""Overlays of a net as plain arrays: lines, points and balls to draw on top of its faces."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from freecad_ortho.view.colours import palette
from solver.analysis.forces import edge_forces
from solver.analysis.spheres import star_curvatures
from solver.mesh.lines import ParameterLines
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows
from solver.offset.axes import torsion_free_axes
from solver.unroll.planes import developable_strip

Colour = tuple[float, float, float]

_FIRST: Colour = (0.85, 0.27, 0.16)
_SECOND: Colour = (0.12, 0.38, 0.70)
_OTHERS: Colour = (0.35, 0.35, 0.38)
_PURPLE: Colour = (0.48, 0.20, 0.58)
_ORANGE: Colour = (0.94, 0.58, 0.17)
_GREEN: Colour = (0.10, 0.52, 0.30)
# Lengths in mean edges.
_AXIS, _ARROW, _HEAD, _RULING = 0.6, 0.6, 0.18, 0.7
# In parts of the size of the net.
_UPSIDE = 0.1
_CAPS, _CAP_SEGMENTS = 200, 32
_WIDTH_CLASSES = 6
_WIDEST = 9.0


@dataclass(frozen=True, eq=False)
class Lines:
    """Segments of one colour: (N, 2, 3) ends in mm and a width in pixels."""

    ends: FloatArray
    colour: Colour
    width: float = 2.0


@dataclass(frozen=True, eq=False)
class Points:
    """Marks of one colour: (N, 3) places in mm and a size in pixels."""

    places: FloatArray
    colour: Colour
    size: float = 8.0


@dataclass(frozen=True, eq=False)
class Balls:
    """Transparent spheres: (N, 3) centres and (N,) radii in mm."""

    centres: FloatArray
    radii: FloatArray
    colour: Colour


Shape = Lines | Points | Balls


def parameter_lines(mesh: QuadMesh) -> list[Shape]:
    """The edges of u lines red, of v lines blue; grey where families cannot be told apart."""
    family = ParameterLines(mesh.connectivity).edge_family
    ends = mesh.vertices[mesh.connectivity.edges]
    colours = {0: _FIRST, 1: _SECOND, -1: _OTHERS}
    return [
        Lines(ends[family == number], colour, 2.5)
        for number, colour in colours.items()
        if (family == number).any()
    ]


def rulings(mesh: QuadMesh) -> list[Shape]:
    """The rulings of developable strips that stand along the parameter lines."""
    half = 0.5 * _RULING * mesh.mean_edge
    ends: dict[str, list[FloatArray]] = {}
    for line in ParameterLines.of(mesh).all:
        vertices = np.append(line.vertices, line.vertices[:1]) if line.closed else line.vertices
        points = mesh.vertices[vertices]
        strip = developable_strip(points, mesh.vertex_normals[vertices], closed=line.closed)
        reach = half * strip.rulings
        ends.setdefault(line.family, []).append(np.stack([points - reach, points + reach], axis=1))
    colours = {"u": _FIRST, "v": _SECOND}
    return [
        Lines(np.concatenate(found), colours.get(family, _OTHERS), 2.0)
        for family, found in ends.items()
    ]


def diagonals(mesh: QuadMesh) -> list[Shape]:
    """Both diagonals of every face, equal in length where the net is orthogonal."""
    corners = mesh.vertices[mesh.faces]
    return [Lines(np.concatenate([corners[:, [0, 2]], corners[:, [1, 3]]]), _PURPLE, 1.5)]


def medial_lines(mesh: QuadMesh) -> list[Shape]:
    """The lines between the midpoints of opposite edges, perpendicular on an orthogonal net."""
    corners = mesh.vertices[mesh.faces]
    middle = (corners + np.roll(corners, -1, axis=1)) / 2
    return [Lines(np.concatenate([middle[:, [0, 2]], middle[:, [1, 3]]]), _ORANGE, 2.0)]


def axes(mesh: QuadMesh) -> list[Shape]:
    """The torsion-free node axes, half to each side of the net."""
    half = _AXIS * mesh.mean_edge * torsion_free_axes(mesh).directions
    used = mesh.connectivity.referenced
    ends = np.stack([mesh.vertices - half, mesh.vertices + half], axis=1)
    return [Lines(ends[used], _GREEN, 2.5)]


def upside(mesh: QuadMesh) -> list[Shape]:
    """An arrow that stands on the upper side, in the middle of the net."""
    net = mesh.connectivity
    inner = np.flatnonzero(net.referenced)
    low, high = mesh.vertices[inner].min(axis=0), mesh.vertices[inner].max(axis=0)
    middle = inner[np.linalg.norm(mesh.vertices[inner] - (low + high) / 2, axis=1).argmin()]
    foot, normal = mesh.vertices[middle], mesh.vertex_normals[middle]
    length = _UPSIDE * float(np.linalg.norm(high - low))
    tip = foot + length * normal
    across = np.cross(normal, np.eye(3)[np.abs(normal).argmin()])
    barbs = tip - 0.25 * length * normal + 0.12 * length * np.outer([1.0, -1.0], across)
    ends = [np.stack([foot, tip]), *(np.stack([barb, tip]) for barb in barbs)]
    return [Lines(np.stack(ends), _GREEN, 3.0)]


def star_spheres(mesh: QuadMesh) -> list[Shape]:
    """Caps of the spheres that fit the stars best: a rim and two meridians each, a few of them."""
    curvatures, normals = star_curvatures(mesh)
    chosen = np.arange(0, len(curvatures), max(1, -(-len(curvatures) // _CAPS)))
    if not len(chosen):
        return []
    bend, normal = curvatures[chosen], normals[chosen]
    star = mesh.vertices[mesh.connectivity.stars[chosen]]
    spokes = star[:, 1:] - star[:, :1]
    reach = np.linalg.norm(spokes, axis=2).mean(axis=1)
    first = unit_rows(np.cross(normal, spokes[:, 0]))
    second = np.cross(normal, first)
    turn = np.linspace(0.0, 2 * np.pi, _CAP_SEGMENTS + 1)
    across = np.linspace(-1.0, 1.0, _CAP_SEGMENTS // 2 + 1)
    one, other = np.cos(turn), np.sin(turn)
    zero = np.zeros_like(across)
    ends = []
    for along, aside in ((one, other), (across, zero), (zero, across)):
        arc = reach[:, None] * np.hypot(along, aside)
        # Along the great circle of this arc length: sin and 1 - cos of the angle, over curvature.
        angle = bend[:, None] * arc
        out = arc * np.sinc(angle / np.pi)
        rise = 0.5 * bend[:, None] * (arc * np.sinc(angle / (2 * np.pi))) ** 2
        length = np.where(arc > 0, arc, 1.0)
        x, y = (reach[:, None] * part * out / length for part in (along, aside))
        line = (
            star[:, :1]
            + x[:, :, None] * first[:, None]
            + y[:, :, None] * second[:, None]
            + rise[:, :, None] * normal[:, None]
        )
        ends.append(np.stack([line[:, :-1], line[:, 1:]], axis=2).reshape(-1, 2, 3))
    return [Lines(np.concatenate(ends), _SECOND, 1.5)]


def supports(mesh: QuadMesh) -> list[Shape]:
    """Marks where the net stands: on its boundary."""
    net = mesh.connectivity
    return [Points(mesh.vertices[net.boundary_vertices & net.referenced], _GREEN, 9.0)]


def loads(mesh: QuadMesh) -> list[Shape]:
    """An arrow down to every vertex that carries a load."""
    net = mesh.connectivity
    tip = mesh.vertices[net.referenced & ~net.boundary_vertices]
    down = np.array([0.0, 0.0, -mesh.mean_edge])
    barbs = mesh.mean_edge * _HEAD * np.array([[0.5, 0.0, 1.0], [-0.5, 0.0, 1.0]])
    segments = [np.stack([tip - _ARROW * down, tip], axis=1)]
    segments += [np.stack([tip + barb, tip], axis=1) for barb in barbs]
    return [Lines(np.concatenate(segments), _FIRST, 1.5)]


def forces(mesh: QuadMesh) -> list[Shape]:
    """The edges as wide as their force under equal loads: red for tension, blue for compression."""
    if not mesh.connectivity.boundary_edges.any():
        return []
    force = edge_forces(mesh)
    largest = np.abs(force).max() or 1.0
    ends = mesh.vertices[mesh.connectivity.edges]
    rank = np.ceil(np.abs(force) / largest * _WIDTH_CLASSES).astype(int)
    red, blue = palette(np.array([0.95, 0.05]), signed=True).tolist()
    found: list[Shape] = []
    for sign, colour in ((1.0, red), (-1.0, blue)):
        for number in range(1, _WIDTH_CLASSES + 1):
            chosen = (rank == number) & (force * sign > 0)
            if chosen.any():
                width = _WIDEST * number / _WIDTH_CLASSES
                found.append(Lines(ends[chosen], tuple(colour), width))
    return found


def irregular_vertices(mesh: QuadMesh) -> list[Shape]:
    """Inner vertices with more or fewer than four edges."""
    net = mesh.connectivity
    irregular = net.referenced & ~net.boundary_vertices & ~net.regular
    return [Points(mesh.vertices[irregular], _FIRST, 10.0)]


def gauss_image(mesh: QuadMesh) -> list[Shape]:
    """The normals of the faces as a net on a sphere beside the mesh: a curve if developable."""
    used = mesh.vertices[mesh.connectivity.referenced]
    low, high = used.min(axis=0), used.max(axis=0)
    radius = 0.25 * float(np.linalg.norm(high - low))
    centre = np.array([high[0] + 1.5 * radius, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2])
    normals = mesh.face_normals
    pairs = mesh.connectivity.edge_faces[~mesh.connectivity.boundary_edges]
    return [
        Balls(centre[None], np.array([0.985 * radius]), (0.85, 0.86, 0.88)),
        Lines(centre + radius * normals[pairs], _PURPLE, 1.5),
        Points(centre + radius * normals, _PURPLE, 4.0),
    ]


# Name of the view provider's property -> what it shows, and whether it is quick enough to follow a
# mesh that moves.
OVERLAYS: dict[str, tuple[Callable[[QuadMesh], list[Shape]], bool]] = {
    "Upside": (upside, True),
    "ParameterLines": (parameter_lines, True),
    "Diagonals": (diagonals, True),
    "MedialLines": (medial_lines, True),
    "Axes": (axes, False),
    "Rulings": (rulings, False),
    "StarSpheres": (star_spheres, False),
    "IrregularVertices": (irregular_vertices, True),
    "Supports": (supports, True),
    "Loads": (loads, True),
    "Forces": (forces, False),
    "GaussImage": (gauss_image, True),
}
