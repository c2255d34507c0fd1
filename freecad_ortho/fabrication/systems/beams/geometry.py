"""Beams along single edges: straight prisms whose ends follow the node axes.

Seen along an axis, a beam is a strip of its width. Its ends are cut by planes parallel to the axis:

* mitred: between neighbouring strips the half-plane that contains the axis and bisects their angle
  cuts both; where they are more than a straight angle apart (the outer side of a boundary), both
  are cut square instead. So every beam stays in a wedge of its own and no two overlap.
* square, at a distance from the axis that leaves room for a hub, or for the beams of the other
  family that run through.

All sides are planar: the cut planes are parallel to the axis, which lies in the beam's plane.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from freecad_ortho.fabrication.sizes import rounded_down
from freecad_ortho.fabrication.systems.beams.balls import BallJoints
from freecad_ortho.fabrication.systems.beams.cover_plates import CoverPlates
from freecad_ortho.fabrication.systems.beams.end_plates import EndPlates
from freecad_ortho.fabrication.systems.beams.frames import Around, Frames, edge_name
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import FloatArray, QuadMesh

# Corners of a beam, one ring at the lower and one at the upper level: in the middle at the start,
# right, right, in the middle at the end, left, left; counter-clockwise from above.
LEFT_TOP = (6, 11, 10, 9)
RIGHT_TOP = (6, 7, 8, 9)
LOOPS = (
    tuple(range(6, 12)),
    tuple(range(5, -1, -1)),
    *((k, (k + 1) % 6, (k + 1) % 6 + 6, k + 6) for k in range(6)),
)
# Numbers of the right and the left one of these.
RIGHT_SIDE, LEFT_SIDE = 3, 6
# Part of a beam's length that its cuts must leave.
_LEAST_LEFT = 1e-3
# Sine of the angle from which on ends are cut along the side of what runs through.
_LEAST_SINE = 0.5


class NoRoom(InputError):
    """An edge too short for what stands at its ends, in words that do not say yet what helps."""


@dataclass(frozen=True, eq=False)
class Cuts:
    """Where the beams end, measured along their edges from the axes, mm.

    Attributes:
        middle: (E, 2) in the plane of the beam, at the start and end.
        slope: (E, 4) change per mm across the beam: right at the start, right at the end, left at
            the end, left at the start.
    """

    middle: FloatArray
    slope: FloatArray

    def setback(self, half: float) -> FloatArray:
        """(E, 4) at the sides of a beam of this half width, in the order of ``slope``."""
        return np.asarray(self.middle[:, [0, 1, 1, 0]] + half * self.slope)

    def where(self, chosen: BoolArray, other: Cuts) -> Cuts:
        """These cuts for the chosen ends (E, 2), other ones elsewhere."""
        return Cuts(
            np.where(chosen, self.middle, other.middle),
            np.where(chosen[:, [0, 1, 1, 0]], self.slope, other.slope),
        )


@dataclass(frozen=True)
class Splice:
    """A joint in the middle of an edge.

    Attributes:
        name: ``B-U003-s1`` joins ``B-U003-1`` and ``B-U003-2``.
        edge: number of the edge.
        pieces: names of the pieces that it joins.
    """

    name: str
    edge: int
    pieces: tuple[str, str]


@dataclass(frozen=True, eq=False)
class BeamGeometry:
    """All beams of a mesh as arrays, one row an edge; mm.

    Attributes:
        points: (E, 12, 3) corners of the box that the section fills, see ``LOOPS``.
        start: (E, 3) the start of each edge, origin of the beam's coordinates.
        frame: (E, 3, 3) rows along the edge, up in the plate, across it to the right.
        slopes: (E, 2) how far the axis at the start and end moves along the edge per mm up.
        lengths: (E,) of the edges.
        rise: (E,) mm up per level.
        cuts: where the beams end.
        setback: (E, 4) of the sides of the box, in the order of ``Cuts.slope``.
        outline: (E, 4, 2) the middle plane, along the edge and up, at the axes: lower start, lower
            end, upper end, upper start.
        height: (E,) of the beam.
        twist_mm: (E,) largest distance of the axes' ends from the beam's middle plane.
        levels: lower and upper level along the axes, mm from the mesh.
        section_half: half the width of the section, mm.
        built: (E,) true for the edges that have a beam.
        meeting: (E, 2) true for ends that meet others at a vertex.
        bolted: how they are bolted to nodes, None where they are not.
        hub_radii: (V,) from the axes to the faces of bolted hubs, the ends of the arms of stars, or
            the seats on balls, mm, 0 where there are none; empty for beams that are not bolted.
        splices: in the middle of edges, of beams that run through.
        folded: by edge the name of the folded plate of several edges that it is a part of, where
            that is bolted to a node.
    """

    points: FloatArray
    start: FloatArray
    frame: FloatArray
    slopes: FloatArray
    lengths: FloatArray
    rise: FloatArray
    cuts: Cuts
    setback: FloatArray
    outline: FloatArray
    height: FloatArray
    twist_mm: FloatArray
    levels: tuple[float, float]
    section_half: float
    built: BoolArray
    meeting: BoolArray
    bolted: EndPlates | CoverPlates | BallJoints | None
    hub_radii: FloatArray
    splices: tuple[Splice, ...] = ()
    folded: Mapping[int, str] = field(default_factory=dict)

    def ring(self, up: FloatArray, half: float) -> FloatArray:
        """(E, 6, 3) corners at heights ``up`` (E,) in the beam's own coordinates, see ``LOOPS``."""
        setback = self.cuts.setback(half)
        first = up * self.slopes[:, 0]
        last = self.lengths + up * self.slopes[:, 1]
        stations = np.stack(
            [
                first + self.cuts.middle[:, 0],
                first + setback[:, 0],
                last - setback[:, 1],
                last - self.cuts.middle[:, 1],
                last - setback[:, 2],
                first + setback[:, 3],
            ],
            axis=1,
        )
        sides = np.broadcast_to(half * np.array([0.0, 1.0, 1.0, 0.0, -1.0, -1.0]), stations.shape)
        return np.stack([stations, np.broadcast_to(up[:, None], stations.shape), sides], axis=2)

    def up(self, level: int) -> FloatArray:
        """(E,) height of the lower (0) or upper (1) side in the beam's own coordinates."""
        return self.levels[level] * self.rise


def beam_geometry(
    mesh: QuadMesh,
    levels: tuple[float, float],
    width: float,
    frames: Frames,
    cuts: Cuts,
    built: BoolArray,
) -> BeamGeometry:
    """Compute the box of every beam.

    Args:
        mesh: positions in mm.
        levels: lower and upper level along the axes, mm from the mesh.
        width: of the section, across the beam, mm.
        frames: planes of the beams.
        cuts: where they end.
        built: (E,) which edges have one.

    Raises:
        InputError: a height that does not fit an edge.
    """
    slopes = frames.slope / frames.rise[:, None]
    lengths = mesh.edge_lengths
    ends = [np.stack([level * frames.rise] * 2, axis=1) * slopes for level in levels]
    outline = np.stack(
        [
            np.stack([end + np.stack([0 * lengths, lengths], axis=1) for end in ends], axis=1),
            np.stack([np.stack([level * frames.rise] * 2, axis=1) for level in levels], axis=1),
        ],
        axis=-1,
    )
    level_lengths = outline[:, :, 1, 0] - outline[:, :, 0, 0]
    _refuse_height(mesh, levels[1] - levels[0], level_lengths)
    geometry = BeamGeometry(
        points=np.empty(0),
        start=mesh.vertices[mesh.connectivity.edges[:, 0]],
        frame=np.stack([frames.along, frames.up, -frames.left], axis=1),
        slopes=slopes,
        lengths=lengths,
        rise=frames.rise,
        cuts=cuts,
        setback=cuts.setback(width / 2),
        outline=np.concatenate([outline[:, 0], outline[:, 1, ::-1]], axis=1),
        height=(levels[1] - levels[0]) * frames.rise,
        twist_mm=np.abs(frames.miss).max(axis=1) * max(abs(level) for level in levels),
        levels=levels,
        section_half=width / 2,
        built=built,
        meeting=np.stack([built, built], axis=1),
        bolted=None,
        hub_radii=np.empty(0),
    )
    rings = np.concatenate([geometry.ring(geometry.up(k), width / 2) for k in (0, 1)], axis=1)
    points = geometry.start[:, None] + np.einsum("epc,eck->epk", rings, geometry.frame)
    return replace(geometry, points=points)


def mitred(frames: Frames, around: Around) -> Cuts:
    """Cut every end on the planes that bisect the angles to its neighbours."""
    count = len(frames.along)
    with np.errstate(divide="ignore"):
        halved = np.where(around.angle >= np.pi, 0.0, 1.0 / np.tan(around.angle / 2))
    built = around.left >= 0
    left, right = np.zeros((2, 2 * count))
    left[built] = halved[built]
    right[around.left[built]] = halved[built]
    slope = np.stack([right[:count], left[count:], right[count:], left[:count]], axis=1)
    return Cuts(np.zeros((count, 2)), slope * frames.slant[:, [0, 1, 1, 0]])


def square(frames: Frames, distance: FloatArray) -> Cuts:
    """Cut every end square, at distances (E, 2) from its axis."""
    return Cuts(distance * frames.slant, np.zeros((len(distance), 4)))


def hub_distance(mesh: QuadMesh, around: Around, width: float, distance: float) -> FloatArray:
    """(E, 2) the distance of a hub's side from the axis at every end.

    Raises:
        InputError: beams that would collide outside of the hub.
    """
    sharpest = np.where(around.left >= 0, around.angle, np.inf)
    half_edge = int(np.argmin(sharpest))
    angle = float(sharpest[half_edge])
    needed = width / 2 / np.tan(angle / 2) if angle < np.pi else 0.0
    if needed > distance:
        raise InputError(
            f"hub: at vertex {around.vertex[half_edge]} beams {width:g} mm wide meet at "
            f"{np.degrees(angle):.1f} degrees and collide outside of it; take a hub "
            f"{2 * (needed - distance):.1f} mm larger in diameter, or narrower beams"
        )
    return np.full((len(mesh.connectivity.edges), 2), distance)


def clear_of_through(around: Around, width: float, clearance: float) -> FloatArray:
    """(E, 2) how far a beam ends before its axis to stay clear of both neighbours' strips.

    All beams have the same width. The strip of a neighbour at angle b, |p x e| < width / 2, is left
    by both corners of the end at (1 + |cos b|) width / (2 sin b); behind the axis, b > 90 degrees,
    where the strip does not reach, also at (sin b / |cos b|) width / 2.
    """
    half = width / 2
    distance = np.zeros(len(around.vertex))
    built = np.flatnonzero(around.left >= 0)
    for half_edges, angles in (
        (built, around.angle[built]),
        (around.left[built], around.angle[built]),
    ):
        sine, cosine = np.sin(angles), np.cos(angles)
        with np.errstate(divide="ignore", invalid="ignore"):
            beside = (half * (1 + np.abs(cosine)) + clearance) / sine
            behind = half * sine / np.abs(cosine)
        reach = np.where(cosine < 0, np.minimum(np.where(sine > 0, beside, np.inf), behind), beside)
        reach = np.where(angles >= np.pi, 0.0, reach)
        np.maximum.at(distance, half_edges, reach)
    return distance.reshape(2, -1).T


def coped(
    frames: Frames, around: Around, through: BoolArray, width: float, clearance: float
) -> Cuts:
    """Cut ends along the sides of both neighbours that run through, a clearance before them.

    The side of a strip at an angle b is (width / 2 + clearance + y cos b) / sin b away, y to its
    own side of the beam. Where what runs through folds, the farther of both sides counts. Ends that
    meet it at less than 30 degrees are cut square.

    Args:
        frames: planes of the beams.
        around: their order around the axes.
        through: (E,) those that run through.
        width: of all of them, mm.
        clearance: mm.
    """
    half, count = width / 2, len(frames.along)
    stations, steep = np.zeros((3, 2 * count)), np.ones(2 * count, dtype=bool)
    runs = np.concatenate([through, through])
    built = np.flatnonzero(around.left >= 0)
    angles, after = around.angle[built], around.left[built]
    for half_edges, others, sign in ((built, after, 1.0), (after, built, -1.0)):
        met = runs[others] & (angles < np.pi)
        sine = np.where(met, np.sin(angles), 1.0)
        steep[half_edges[sine < _LEAST_SINE]] = False
        for row, side in enumerate((0.0, half, -half)):
            reach = (half + clearance + sign * side * np.cos(angles)) / np.maximum(sine, 1e-9)
            np.maximum.at(stations[row], half_edges, np.where(met, reach, 0.0))
    middle, left, right = stations
    left, right = (left - middle) / half, (right - middle) / half
    slope = np.stack([right[:count], left[count:], right[count:], left[:count]], axis=1)
    cuts = Cuts(middle.reshape(2, -1).T * frames.slant, slope * frames.slant[:, [0, 1, 1, 0]])
    gaps = clear_of_through(around, width, clearance)
    return cuts.where(steep.reshape(2, -1).T, square(frames, gaps))


def _refuse_height(mesh: QuadMesh, height: float, lengths: FloatArray) -> None:
    wrong = lengths.min(axis=1) <= _LEAST_LEFT * mesh.edge_lengths
    if wrong.any():
        shrink = (mesh.edge_lengths - lengths.min(axis=1)) / height
        largest = float((mesh.edge_lengths[wrong] / shrink[wrong]).min())
        raise InputError(
            f"beam height: {height:g} mm does not fit {edge_name(mesh, wrong)}, where "
            f"the axes meet before that; take less than {rounded_down(largest)} mm or "
            "another offset"
        )
