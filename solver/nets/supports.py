"""What carries a net that carries loads, and where it may slide."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from solver.errors import InputError
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.nets.constraints import (
    BoundaryGlide,
    Constraints,
    CurveGlide,
    Glide,
    SurfaceGlide,
    settled,
)
from solver.nets.net import Net
from solver.nets.settings import fixed_vertices
from solver.option import Option

# Edges at a corner where a border turns outwards.
_TIP = 2
# What a net that carries loads can be told of them.
SUPPORTS = Option(
    "supports",
    "",
    "text",
    "Stress nets: this carries the loads: boundary, which slides along its own curve but for its "
    "corners; corners or vertices such as 0,5,12, which stay; empty: as the net needs",
    written="boundary|corners|I,J",
    brief="what carries the loads; boundary slides along its own curve, but for its corners",
    stored="SupportRule",
)


@dataclass(frozen=True, eq=False)
class NetSupports:
    """Vertices that a net stands on, and those that keep every bit.

    Supports slide: a rib that ends on an edge beam may end beside where it was drawn, which leaves
    the net the room that it needs to run along the principal stresses. The beam's own reaction is
    any force, wherever on it the support comes to lie.

    Attributes:
        standing: (V,) true where a vertex is supported, fixed or not.
        fixed: (V,) true where a vertex does not move.
        corners: (V,) true where it does not only because a curve on which its neighbours slide
            turns there.
    """

    standing: BoolArray
    fixed: BoolArray
    corners: BoolArray

    def zigzag(self, mesh: QuadMesh, overhangs: bool) -> bool:
        """Tell whether the border on which they slide is only where the net ends.

        It turns back and forth where lines end one after the other, and it lies beyond that of the
        surface, or holds some face all around.

        Args:
            mesh: the start.
            overhangs: whether it overhangs the border of its surface.
        """
        net = mesh.connectivity
        if not (self.corners & (net.edge_valence > _TIP)).any():
            return False
        return overhangs or bool(self.fixed[net.faces].all(axis=1).any())

    def on_surface(
        self, mesh: QuadMesh, points: FloatArray, triangles: IntArray
    ) -> tuple[NetSupports, SurfaceGlide]:
        """Supports that slide on a surface, where the border of the net is only where it ends.

        A net that overhangs the border of its surface is cut there, and stands on what runs along
        the cut. Its own border zigzags: held at each of its corners it has no room.

        Args:
            mesh: the start.
            points: (V, 3) of the surface.
            triangles: (T, 3).

        Returns:
            the supports, and what those that are not fixed slide on.
        """
        fixed = self.fixed & ~self.corners
        loose = np.flatnonzero(self.standing & ~fixed & mesh.connectivity.boundary_vertices)
        free = NetSupports(self.standing, fixed, np.zeros_like(fixed))
        return free, SurfaceGlide(points, triangles, loose)

    def glides(self, mesh: QuadMesh, wanted: Constraints) -> tuple[Glide, ...]:
        """Curves on which supports slide that are neither fixed nor glide on something else.

        Args:
            mesh: the start, on whose border supports stay.
            wanted: settled constraints.
        """
        loose = self.standing & ~self.fixed
        for glide in wanted.glide:
            if not isinstance(glide, BoundaryGlide) and glide.vertices is not None:
                loose[glide.vertices] = False
        borders = settled(mesh, ~loose, Constraints(glide=(BoundaryGlide(),))).glide
        curves = [each for each in borders if isinstance(each, CurveGlide)]
        return tuple(each for each in curves if each.vertices is not None and len(each.vertices))


def supports_of(
    mesh: QuadMesh,
    net: Net,
    fix: str | Sequence[int | str],
    supports: str | Sequence[int | str] = "",
) -> NetSupports:
    """Tell what a net stands on.

    What is fixed is supported too. ``boundary`` slides along its own curve, but for corners; other
    supports stay where they are. Where neither is named, the net's own supports are meant.

    Args:
        mesh: the start.
        net: the net.
        fix: ``none``, ``corners``, ``boundary`` or vertex numbers.
        supports: ``boundary``, ``corners`` or vertex numbers; empty for what the net needs.

    Raises:
        InputError: supports of a net that carries no loads, a word or number that there is not.
    """
    fixed = fixed_vertices(mesh, fix)
    none = np.zeros_like(fixed)
    named = supports if isinstance(supports, str) else list(supports)
    if net.supports == "none":
        if named:
            raise InputError(f"supports: {net.name} nets carry no loads; fix vertices instead")
        return NetSupports(fixed, fixed, none)
    if not named and isinstance(fix, str) and fix.strip().lower() == "none":
        named = net.supports
    if not named:
        return NetSupports(fixed, fixed, none)
    standing = fixed_vertices(mesh, named) | fixed
    words = named.split(",") if isinstance(named, str) else named
    stays = [word for word in words if str(word).strip().lower() != "boundary"]
    fixed = fixed | fixed_vertices(mesh, stays)
    if len(stays) == len(words):
        return NetSupports(standing, fixed, none)
    corners = standing & mesh.connectivity.corners & ~fixed
    return NetSupports(standing, fixed | corners, corners)
