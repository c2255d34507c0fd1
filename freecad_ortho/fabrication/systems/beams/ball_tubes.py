"""Tubes between balls: about the lines between these, and sawn square before them."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from freecad_ortho.fabrication.part import part_names
from freecad_ortho.fabrication.profiled import ProfiledBody
from freecad_ortho.fabrication.profiles import Profile
from freecad_ortho.fabrication.profiles.end import End
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.beams.balls import BallJoints
from freecad_ortho.fabrication.systems.beams.geometry import LOOPS, BeamGeometry, NoRoom
from freecad_ortho.fabrication.systems.beams.rolled import RolledPiece, RolledSection
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import FloatArray

# Corners of a beam at its start in both of its rings; the others are at its end.
_AT_START = np.isin(np.arange(12) % 6, (0, 1, 5))


@dataclass(frozen=True)
class TubesOnBalls(RolledSection):
    """A round tube as the section of beams whose axes meet in the middle of balls."""

    @classmethod
    def of(cls, section: RolledSection) -> TubesOnBalls:
        """The same section.

        Raises:
            InputError: it is no round tube.
        """
        if section.profile.series != "chs":
            raise InputError(
                f"ends: cones of ball nodes are those of round tubes, got section {section.name}; "
                "take one such as chs:88.9x5, or other ends"
            )
        return cls(section.profile, section.rounded)

    def misfit(self, site: Site, geometry: BeamGeometry, meeting: BoolArray) -> FloatArray:
        """(V,) nothing, as axes meet; mm."""
        return np.zeros(len(site.mesh.vertices))

    def pieces(self, geometry: BeamGeometry) -> tuple[RolledPiece, ...]:
        """The tube alone."""
        corners = _corners(geometry, self.height)
        width = np.full(len(corners), self.height)
        bought = self.profile, self.drawn
        return (Tube("", "tube", corners, LOOPS, self.profile.wall, width, geometry, *bought),)


def joined_ends(geometry: BeamGeometry) -> BoolArray:
    """(E, 2) which ends of beams are cones; others are mitred, or cut by a border."""
    return np.asarray(geometry.meeting & (geometry.cuts.middle > 0))


def axis_level(geometry: BeamGeometry) -> float:
    """Of the middle of the balls along their axes, mm from the mesh."""
    return sum(geometry.levels) / 2


def with_tubes(geometry: BeamGeometry, height: float, edges: np.ndarray) -> BeamGeometry:
    """The geometry of beams with boxes about their tubes.

    Args:
        geometry: of the beams.
        height: diameter of the tubes, mm.
        edges: (E, 2) the vertices at their ends.

    Raises:
        NoRoom: an edge too short for what is at its ends.
    """
    joints = geometry.bolted
    assert isinstance(joints, BallJoints)
    corners = _corners(geometry, height)
    left = corners[:, ~_AT_START, 0].min(axis=1) - corners[:, _AT_START, 0].max(axis=1)
    left = np.where(geometry.built, left, np.inf)
    worst = int(np.argmin(left))
    if left[worst] < joints.tube / 2:
        length = float(geometry.lengths[worst])
        raise NoRoom(
            f"beam ends: {part_names('B', len(edges))[worst]} is on an edge {length:.1f} mm long, "
            f"balls, sleeves and cones take {length - float(left[worst]):.1f} mm of it"
        )
    points = geometry.start[:, None] + np.einsum("epc,eck->epk", corners, geometry.frame)
    return replace(geometry, points=points)


def _corners(geometry: BeamGeometry, height: float) -> FloatArray:
    """(E, 12, 3) of the boxes about tubes, see ``LOOPS``."""
    half, middle = height / 2, axis_level(geometry) * geometry.rise
    rings = [geometry.ring(middle + side, half) for side in (-half, half)]
    corners = np.concatenate(rings, axis=1)
    joined, stations = joined_ends(geometry), _stations(geometry)
    for end, chosen in enumerate((_AT_START, ~_AT_START)):
        square = np.broadcast_to(stations[:, end, None], (len(corners), int(chosen.sum())))
        corners[:, chosen, 0] = np.where(joined[:, end, None], square, corners[:, chosen, 0])
    return corners


def _stations(geometry: BeamGeometry) -> FloatArray:
    """(E, 2) where the axes of tubes begin and end along their edges, mm."""
    middles = ball_stations(geometry)
    return np.asarray(middles + np.array([1.0, -1.0]) * geometry.cuts.middle)


def ball_stations(geometry: BeamGeometry) -> FloatArray:
    """(E, 2) where the middles of balls lie along the edges between them, mm."""
    up = (axis_level(geometry) * geometry.rise)[:, None]
    ends = np.stack([0 * geometry.lengths, geometry.lengths], axis=1)
    return np.asarray(ends + up * geometry.slopes)


@dataclass(frozen=True, eq=False)
class Tube(RolledPiece):
    """The tubes, whose coordinates begin in the middle of their axes' beginnings."""

    def origin(self, edge: int) -> FloatArray:
        """Of the part's coordinates in those of its beam."""
        middle = axis_level(self.geometry) * float(self.geometry.rise[edge])
        return np.array([float(self.corners[edge][:, 0].min()), middle, 0.0])

    def cut_words(self, edge: int) -> tuple[str | None, str | None]:
        """How its start and end are sawn where they end before balls."""
        start, end = joined_ends(self.geometry)[edge].tolist()
        return "square" if start else None, "square" if end else None

    def _member(self, edge: int, origin: FloatArray, profile: Profile) -> ProfiledBody:
        body = super()._member(edge, origin, profile)
        ends = [body.first, body.last]
        for end in np.flatnonzero(joined_ends(self.geometry)[edge]).tolist():
            place = float(_stations(self.geometry)[edge, end])
            ends[end] = End(place - float(origin[0]), 0.0, 0.0, 0.0)
        return ProfiledBody(profile, *ends)
