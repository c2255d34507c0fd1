"""Sections of the catalogue along the edge."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_ortho.fabrication.profiled import ProfiledBody
from freecad_ortho.fabrication.profiles import Profile
from freecad_ortho.fabrication.profiles.end import End
from freecad_ortho.fabrication.systems.edge_beam.sections import EdgeSection
from solver.mesh.quadmesh import FloatArray


@dataclass(frozen=True)
class RolledEdge(EdgeSection):
    """A section of the catalogue below the level of its upper side, its middle on the border.

    Args:
        bought: with its roundings.
        rounded: whether solids have them; masses always do.
    """

    bought: Profile
    rounded: bool

    @classmethod
    def of(cls, profile: Profile, rounded: bool) -> RolledEdge:
        """That of a profile."""
        return cls("rolled", profile.height, profile.width, profile.wall, profile, rounded)

    def __post_init__(self) -> None:
        """The catalogue has checked its sizes."""

    @property
    def words(self) -> str:
        """As it is ordered."""
        return self.bought.name

    @property
    def lift(self) -> FloatArray:
        """(3,) from the middle of the lower side, where parts begin, to the middle of the box."""
        return np.array([0.0, self.height / 2, 0.0])

    def body(
        self, outer: FloatArray, inner: FloatArray, middles: FloatArray, ends: FloatArray
    ) -> ProfiledBody:
        """The body of one piece, in coordinates that begin in the middle of its box."""
        return self._member(
            self.bought if self.rounded else self.bought.less_round(), middles, ends
        )

    def weighed(self, middles: FloatArray, ends: FloatArray) -> float:
        """Volume with the roundings that the section has, mm3."""
        return self._member(self.bought, middles, ends).volume

    def _member(self, profile: Profile, middles: FloatArray, ends: FloatArray) -> ProfiledBody:
        up, right = (-ends[:, k] / ends[:, 0] for k in (1, 2))
        places = middles - self.height / 2 * up
        planes = [
            End(float(places[k]), float(up[k]), float(right[k]), -float(right[k])) for k in (0, 1)
        ]
        return ProfiledBody(profile, *planes)
