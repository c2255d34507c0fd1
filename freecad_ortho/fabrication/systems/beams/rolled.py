"""Beams with a section of the catalogue: one constant section, cut by the planes of their ends.

Their upper sides lie where the net has them, so that what lies on them is carried; as the section
is constant, their lower sides meet at a node only where the net has one height there.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_ortho.fabrication.bodies import Body
from freecad_ortho.fabrication.material import Material
from freecad_ortho.fabrication.profiled import ProfiledBody
from freecad_ortho.fabrication.profiles import Profile
from freecad_ortho.fabrication.profiles.end import End
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.beams.geometry import BeamGeometry
from freecad_ortho.fabrication.systems.beams.sections import SectionPiece, prism
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import FloatArray


@dataclass(frozen=True)
class RolledSection:
    """A section of the catalogue as that of all beams.

    Args:
        profile: with its roundings.
        rounded: whether solids have them; masses always do.
    """

    profile: Profile
    rounded: bool

    @property
    def overall_width(self) -> float:
        """Across the beam, mm."""
        return self.profile.width

    @property
    def height(self) -> float:
        """Of the section, mm."""
        return self.profile.height

    @property
    def drawn(self) -> Profile:
        """The profile as solids have it."""
        return self.profile if self.rounded else self.profile.less_round()

    def material(self, chosen: Material) -> Material:
        """The material of the beams, see :meth:`Profile.made_of`."""
        return self.profile.made_of(chosen)

    @property
    def name(self) -> str:
        """As it is ordered."""
        return self.profile.name

    def size(self, height: float) -> str:
        """What a beam is sawn from, in words."""
        return self.profile.name

    def pieces(self, geometry: BeamGeometry) -> tuple[SectionPiece, ...]:
        """The one part that a beam is made of."""
        top = geometry.up(1)
        corners = prism(geometry, top - self.height, top, self.overall_width / 2)
        width = np.full(len(top), self.height)
        bought = self.profile, self.drawn
        return (RolledPiece("", "tube", corners, (), self.profile.wall, width, geometry, *bought),)

    def misfit(self, site: Site, geometry: BeamGeometry, meeting: BoolArray) -> FloatArray:
        """(V,) how far lower sides of beams lie apart at each vertex, along its axis, mm.

        Args:
            site: with mesh and axes.
            geometry: of the beams.
            meeting: (E, 2) which ends meet others at a vertex.
        """
        ends, offsets = site.mesh.connectivity.edges, site.axes.offsets
        depth = self.height / geometry.rise[:, None] * np.linalg.norm(offsets, axis=1)[ends]
        least, most = np.full(len(offsets), np.inf), np.full(len(offsets), -np.inf)
        np.minimum.at(least, ends[meeting], depth[meeting])
        np.maximum.at(most, ends[meeting], depth[meeting])
        return np.asarray(np.where(most > least, most - least, 0.0))


@dataclass(frozen=True, eq=False)
class RolledPiece(SectionPiece):
    """The bodies of beams of one profile, whose coordinates begin in the middle of its box.

    Attributes:
        geometry: of the beams.
        profile: with its roundings.
        drawn: as solids have it.
    """

    geometry: BeamGeometry
    profile: Profile
    drawn: Profile

    def origin(self, edge: int) -> FloatArray:
        """Of the part's coordinates in those of its beam."""
        return super().origin(edge) + [0.0, self.profile.height / 2, 0.0]

    def body(self, edge: int, origin: FloatArray, turn: FloatArray) -> Body:
        """Body of one beam, in coordinates along it, up and to the right."""
        return self._member(edge, origin, self.drawn)

    def skin(self, edge: int) -> float:
        """Outer surface without its ends, mm2."""
        return self._member(edge, self.origin(edge), self.drawn).skin

    def weighed(self, edge: int) -> float | None:
        """Volume with the roundings that the section has, mm3."""
        return self._member(edge, self.origin(edge), self.profile).volume

    def _member(self, edge: int, origin: FloatArray, profile: Profile) -> ProfiledBody:
        beams = self.geometry
        slope_first, slope_last = beams.slopes[edge].tolist()
        before, after = beams.cuts.middle[edge].tolist()
        right_first, right_last, left_last, left_first = beams.cuts.slope[edge].tolist()
        along, up, _ = origin.tolist()
        first = before + up * slope_first - along
        last = float(beams.lengths[edge]) - after + up * slope_last - along
        return ProfiledBody(
            profile,
            End(first, slope_first, right_first, left_first),
            End(last, slope_last, -right_last, -left_last),
        )
