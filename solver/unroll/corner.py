"""The corner of a polyline, and the rulings there that make a strip's pattern turn as wanted.

At a corner with turning angle kappa the frame is t (mean direction), b (where it turns to) and n
(normal of the osculating plane). A ruling r has angles before and after with the two edges; in the
pattern the axis turns by their difference delta. With their mean sigma,

    r = (cos sigma cos(delta/2) / cos(kappa/2)) t + (sin sigma sin(delta/2) / sin(kappa/2)) b + z n

so that for every sigma there is one ruling on each side of the osculating plane that makes the
pattern turn by exactly delta, as long as abs(delta) <= kappa.

If the strip's planes before and after the corner lean by alpha and beta from n towards b, they meet
in a ruling whose pattern turns by (Napier's analogies)

    tan(delta / 2) = tan(kappa / 2) sin((alpha + beta) / 2) / cos((alpha - beta) / 2).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import FloatArray, unit_rows
from solver.unroll.strip import angle_between

# Below this turn a corner is straight: its osculating plane is noise and its pattern cannot turn.
STRAIGHT = 1e-9
_SAME_PLANE = 1e-12


@dataclass(frozen=True, eq=False)
class Corners:
    """Frames of consecutive pairs of edges.

    Args:
        before: (C, 3) unit directions of the edges that end at the corners.
        after: (C, 3) unit directions of the edges that begin there.
        upright: (C, 3) unit directions that ``normal`` shall have a component along; where the
            corner is straight they define the osculating plane.
    """

    before: FloatArray
    after: FloatArray
    upright: FloatArray

    @cached_property
    def half_turn(self) -> FloatArray:
        """(C,) kappa / 2."""
        return 0.5 * angle_between(self.before, self.after)

    @cached_property
    def straight(self) -> BoolArray:
        """(C,) true where there is no osculating plane."""
        return np.asarray(self.half_turn < STRAIGHT)

    @cached_property
    def tangent(self) -> FloatArray:
        """(C, 3) t."""
        return unit_rows(self.before + self.after)

    @cached_property
    def normal(self) -> FloatArray:
        """(C, 3) n, on the side of ``upright``."""
        osculating = unit_rows(np.cross(self.before, self.after))
        lean = np.einsum("ck,ck->c", self.upright, self.tangent)
        plain = unit_rows(self.upright - lean[:, None] * self.tangent)
        side = np.where(np.einsum("ck,ck->c", osculating, self.upright) < 0, -1.0, 1.0)
        return np.where(self.straight[:, None], plain, side[:, None] * osculating)

    @cached_property
    def inward(self) -> FloatArray:
        """(C, 3) b."""
        bend = self.after - self.before
        level = np.cross(self.normal, self.tangent)
        along = np.einsum("ck,ck->c", bend, level)
        return np.where(along < 0, -1.0, 1.0)[:, None] * level

    def turn_ratio(self, turns: FloatArray) -> FloatArray:
        """(C,) q = tan(delta / 2) / tan(kappa / 2), cut off at -1 and 1, which are the limits."""
        ratio = np.tan(turns / 2) / np.tan(np.maximum(self.half_turn, STRAIGHT))
        return np.where(self.straight, 0.0, np.clip(ratio, -1.0, 1.0))

    def rulings(self, turns: FloatArray) -> FloatArray:
        """(C, 3) unit rulings near ``upright`` that make the pattern turn by ``turns`` (C,).

        Where the corner turns less than its pattern should, the nearest: in the osculating plane.
        """
        half = np.maximum(self.half_turn, STRAIGHT)
        wanted = np.clip(turns / 2, -half, half)
        along = np.cos(wanted) / np.cos(half)
        aside = np.where(self.straight, 0.0, np.sin(wanted) / np.sin(half))
        slope = np.einsum("ck,ck->c", self.upright, self.tangent)
        room = np.sqrt(np.maximum(1 - aside**2, 0) / np.maximum(along**2 - aside**2, 1e-300))
        cosine = np.clip(slope / along, -room, room)
        sine = np.sqrt(1 - cosine**2)
        height = np.sqrt(np.maximum(1 - (cosine * along) ** 2 - (sine * aside) ** 2, 0.0))
        side = np.where(np.einsum("ck,ck->c", self.normal, self.upright) < 0, -1.0, 1.0)
        return unit_rows(
            (cosine * along)[:, None] * self.tangent
            + (sine * aside)[:, None] * self.inward
            + (side * height)[:, None] * self.normal
        )

    @cached_property
    def side(self) -> FloatArray:
        """(C,) 1 where t, b, n are right-handed, else -1."""
        volume = np.einsum("ck,ck->c", np.cross(self.tangent, self.inward), self.normal)
        return np.where(volume < 0, -1.0, 1.0)

    @cached_property
    def levels(self) -> tuple[FloatArray, FloatArray]:
        """(C, 3) twice: for the edge before and after, what leans are measured towards."""
        before, after = (
            self.side[:, None] * np.cross(self.normal, edge) for edge in (self.before, self.after)
        )
        return before, after

    def leans(self, before: FloatArray, after: FloatArray) -> tuple[FloatArray, FloatArray]:
        """(C,) angles alpha and beta, from n towards b, of planes through the edges.

        ``before`` and ``after`` (C, 3) are unit vectors in these planes, normal to the edges.
        """
        angles = []
        for level, upright in zip(self.levels, (before, after), strict=True):
            angles.append(
                np.arctan2(
                    np.einsum("ck,ck->c", upright, level),
                    np.einsum("ck,ck->c", upright, self.normal),
                )
            )
        return angles[0], angles[1]

    def meets(self, before: FloatArray, after: FloatArray) -> FloatArray:
        """(C, 3) unit rulings in which planes through the edges meet, given as for ``leans``.

        In the corner's frame their line is t: cos(kappa / 2) sin(alpha - beta),
        b: sin(kappa / 2) sin(alpha + beta), n: sin(kappa) cos(alpha) cos(beta); unlike the cross
        product of the planes' normals this stays exact at nearly straight corners. Where both
        planes are one the ruling is square to the axis.
        """
        alpha, beta = self.leans(before, after)
        half = self.half_turn
        parts = (
            np.cos(half) * np.sin(alpha - beta),
            np.sin(half) * np.sin(alpha + beta),
            np.sin(2 * half) * np.cos(alpha) * np.cos(beta),
        )
        frame = (self.tangent, self.inward, self.normal)
        lines = sum(
            (part[:, None] * axis for part, axis in zip(parts, frame, strict=True)),
            np.zeros_like(self.tangent),
        )
        mean = before + after
        square = mean - np.einsum("ck,ck->c", mean, self.tangent)[:, None] * self.tangent
        flat = np.linalg.norm(lines, axis=1) <= _SAME_PLANE
        lines = np.where(flat[:, None], square, lines)
        sign = np.where(np.einsum("ck,ck->c", lines, mean) < 0, -1.0, 1.0)
        return unit_rows(sign[:, None] * lines)
