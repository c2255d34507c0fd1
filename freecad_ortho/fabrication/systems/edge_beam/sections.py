"""Sections of edge beams: plate, rectangular tube, round tube, bent strip."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_ortho.fabrication.bodies import BOX_SIDES, Body, Hollow, Polyhedron
from freecad_ortho.fabrication.round_tube import RoundTube
from freecad_ortho.fabrication.sizes import check_size
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray
from solver.option import one_of

SECTIONS = ("plate", "tube", "round", "strip")


def edge_section_beside(section: str) -> str:
    """What an edge beam's section is unless told: as wide as the beams' for what lies on both.

    A plate beside plates, a tube beside sections that are welded, the same beside one of the
    catalogue.
    """
    if section.isalpha():
        return "plate" if section == "plate" else "tube"
    return section


@dataclass(frozen=True)
class EdgeSection:
    """The cross section of an edge beam, below the level of its upper side.

    Args:
        kind: plate, tube, round or strip.
        height: mm; a round tube is as high as wide.
        width: mm.
        wall: thickness of a tube's wall, mm.

    Raises:
        InputError: an unknown kind, or sizes that make no section.
    """

    kind: str
    height: float
    width: float
    wall: float

    def __post_init__(self) -> None:
        one_of("edge section", self.kind, SECTIONS)
        check_size("edge height", self.height)
        check_size("edge width", self.width)
        if self.flat:
            return
        check_size("edge wall", self.wall)
        least = min(self.width, self.height)
        if 2 * self.wall >= least:
            raise InputError(
                f"edge wall: {self.wall:g} mm fills a tube of {least:g} mm; take less than "
                f"{least / 2:g} mm"
            )

    @property
    def flat(self) -> bool:
        """Whether it is cut from a plate."""
        return self.kind in ("plate", "strip")

    @property
    def words(self) -> str:
        """As it is ordered."""
        if self.kind == "round":
            return f"round tube {self.width:g} x {self.wall:g}"
        if self.kind == "tube":
            return f"tube {self.height:.1f} x {self.width:g} x {self.wall:g}"
        return f"{self.kind} {self.height:g} x {self.width:g}"

    def profile(self, inset: float = 0.0) -> FloatArray:
        """(4, 2) corners of the section's box, up and to the right, seen against its direction."""
        half, low, high = self.width / 2 - inset, inset - self.height, -inset
        return np.array([[low, -half], [high, -half], [high, half], [low, half]])

    def body(
        self, outer: FloatArray, inner: FloatArray, middles: FloatArray, ends: FloatArray
    ) -> Body:
        """The body of one piece.

        Args:
            outer: (2, 4, 3) corners of its box at both ends, in its coordinates.
            inner: (2, 4, 3) the same of a tube's opening.
            middles: (2,) where the planes of the ends cross the middle of the upper side.
            ends: (2, 3) their normals.
        """
        if self.kind == "plate":
            return Polyhedron(outer.reshape(-1, 3), BOX_SIDES)
        if self.kind == "tube":
            return _hollow(outer, inner)
        centre = outer[0, :, 1:].mean(axis=0)
        stations = middles + self.height / 2 * ends[:, 1] / ends[:, 0]
        return RoundTube(np.array([0.0, *centre]), stations, ends, self.width, self.wall)

    def skin(self, outer: FloatArray) -> float:
        """Outer surface of a tube without its ends, mm2, between ends (2, 4, 3) of its box."""
        sides = np.linalg.norm(outer[0, :, 1:] - np.roll(outer[0, :, 1:], -1, axis=0), axis=1)
        lengths = outer[1, :, 0] - outer[0, :, 0]
        if self.kind == "round":
            return float(np.pi * self.width * lengths.mean())
        return float(sides @ (lengths + np.roll(lengths, -1)) / 2)


def _hollow(outer: FloatArray, inner: FloatArray) -> Hollow:
    """A tube whose ends are frames of four trapezia."""
    corners = np.concatenate([outer, inner], axis=1).reshape(-1, 3)
    walls = []
    loops: list[tuple[int, ...]] = []
    # Corners 0 to 3 outside and 4 to 7 inside at the start, 8 to 15 at the end.
    for k in range(4):
        ahead = (k + 1) % 4
        loops += [
            (k, ahead, ahead + 8, k + 8),
            (ahead + 4, k + 4, k + 12, ahead + 12),
            (ahead, k, k + 4, ahead + 4),
            (k + 8, ahead + 8, ahead + 12, k + 12),
        ]
        ring = [k, ahead, ahead + 4, k + 4]
        walls.append(Polyhedron(corners[[*ring, *(number + 8 for number in ring)]], BOX_SIDES))
    return Hollow(corners, tuple(loops), tuple(walls))
