"""Metal cassettes: sheets whose edges are folded down, cut flat with a notch in every corner.

A fold with an inner radius r in a sheet of thickness t takes (r + K t) pi / 2 of the flat sheet: K
is where the fibre lies that keeps its length, by DIN 6935 (0.65 + log10(r / t) / 2) / 2, at most
1/2.
Folds begin r + t inside of the outline. Notches reach the lines where they begin, so nothing tears
there, and returns end where they stay clear of each other.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from freecad_ortho.fabrication.bodies import Body, Polyhedron
from freecad_ortho.fabrication.material import Material
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.pattern import Bend, polygon_area
from freecad_ortho.fabrication.plate_bodies import plate_body
from freecad_ortho.fabrication.systems.panels.geometry import inset
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    import cadquery

# What sheets are folded from.
METALS = ("steel", "S235", "S275", "S355", "stainless", "aluminium")
# Between two returns at a corner, mm.
_CLEAR = 1.0
# Sides that are shorter than this many depths are not folded.
_LONG = 2.0
# Points nearer to each other, mm, are one.
_SAME = 1e-9
# DIN 6935: bounds of K.
_LEAST_K, _MOST_K = 0.0, 0.5


@dataclass(frozen=True)
class Fold:
    """How edges are folded.

    Args:
        depth: of the returns, outside, mm.
        radius: inside of the folds, mm.
        thickness: of the sheet, mm.
        k: place of the fibre that keeps its length, from the inside, of the thickness; None for
            that of DIN 6935.

    Raises:
        InputError: sizes that cannot be folded.
    """

    depth: float
    radius: float
    thickness: float
    k: float | None = None

    def __post_init__(self) -> None:
        if self.depth <= self.back:
            raise InputError(
                f"fold: {self.depth:g} mm are less than the bend takes, {self.back:g} mm; take more"
            )

    @property
    def back(self) -> float:
        """From the outline to where folds begin, mm."""
        return self.radius + self.thickness

    @property
    def factor(self) -> float:
        """K."""
        if self.k is not None:
            return self.k
        found = (0.65 + math.log10(self.radius / self.thickness) / 2) / 2
        return min(max(found, _LEAST_K), _MOST_K)

    @property
    def allowance(self) -> float:
        """Length of the flat sheet that a fold takes, mm."""
        return math.pi / 2 * (self.radius + self.factor * self.thickness)

    @property
    def section(self) -> float:
        """Area of a fold and its return, mm2."""
        ring = math.pi / 4 * (self.back**2 - self.radius**2)
        return ring + (self.depth - self.back) * self.thickness


def refuse_brittle(material: Material) -> None:
    """Refuse what cannot be folded.

    Raises:
        InputError: naming what can.
    """
    if material.name not in METALS:
        raise InputError(
            f"fold: {material.name} cannot be folded; take {', '.join(METALS)}, or no fold"
        )


@dataclass(frozen=True, eq=False)
class Cassette(Body):
    """A sheet with folded edges; z = 0 is below its face, returns go down from there.

    Attributes:
        outline: (N, 2) from outside, counter-clockwise, mm.
        fold: of its edges.
    """

    outline: FloatArray
    fold: Fold

    @cached_property
    def folded(self) -> list[int]:
        """Numbers of the sides that are folded."""
        length = np.linalg.norm(np.roll(self.outline, -1, axis=0) - self.outline, axis=1)
        return np.flatnonzero(length >= _LONG * self.fold.depth).tolist()

    @cached_property
    def face(self) -> FloatArray:
        """(N, 2) what stays flat."""
        back = np.zeros(len(self.outline))
        back[self.folded] = self.fold.back
        return np.asarray(inset(self.outline[None], back[None])[0])

    @cached_property
    def roots(self) -> dict[int, FloatArray]:
        """(2, 2) by folded side: where its fold begins, from end to end."""
        found = {}
        for side in self.folded:
            start, end = self.face[[side, (side + 1) % len(self.face)]]
            along = (end - start) / np.linalg.norm(end - start)
            ends = start + self._less(side, 0) * along, end - self._less(side, 1) * along
            found[side] = np.array(ends)
        return found

    def _less(self, side: int, end: int) -> float:
        """By how much a return ends before a corner of the face, so that it is clear there, mm."""
        count = len(self.outline)
        beside = (side + 1) % count if end else (side - 1) % count
        corner = self.face[(side + end) % count]
        along, out = self._directions(side)
        outward = self._directions(beside)[1]
        thick = self.fold.thickness
        needed = thick + _CLEAR if beside in self.folded else 0.0
        points = [corner + (self.fold.back - inside) * out for inside in (0.0, thick)]
        clear = min(float((self.outline[beside] - point) @ outward) for point in points)
        sine = abs(float(along @ outward))
        return max(needed - clear, 0.0) / max(sine, 0.1)

    def _directions(self, side: int) -> tuple[FloatArray, FloatArray]:
        """Along a side and out of it."""
        step = self.outline[(side + 1) % len(self.outline)] - self.outline[side]
        along = step / np.linalg.norm(step)
        return along, np.array([along[1], -along[0]])

    @property
    def points(self) -> FloatArray:
        """Corners of the box around it."""
        levels = np.repeat([self.fold.thickness - self.fold.depth, self.fold.thickness], 2)
        low, high = self.outline.min(axis=0), self.outline.max(axis=0)
        return np.column_stack([np.tile(np.stack([low, high]), (2, 1)), levels])

    @property
    def volume(self) -> float:
        """The face, and section times length of each fold."""
        lengths = sum(float(np.linalg.norm(root[1] - root[0])) for root in self.roots.values())
        return float(polygon_area(self.face) * self.fold.thickness + self.fold.section * lengths)

    @property
    def fits(self) -> bool:
        """Whether there are folds, and all leave something of their sides and of the face."""
        if not self.folded:
            return False
        side = np.roll(self.outline, -1, axis=0) - self.outline
        left = np.roll(self.face, -1, axis=0) - self.face
        if (np.einsum("nd,nd->n", left, side) <= 0).any():
            return False
        return all(
            float((root[1] - root[0]) @ side[number]) > 0 for number, root in self.roots.items()
        )

    def flat(self) -> tuple[FloatArray, tuple[Bend, ...]]:
        """The sheet to cut, (M, 2), and the lines along which its edges are folded down."""
        straight = self.fold.depth - self.fold.back
        reach, middle = self.fold.allowance + straight, self.fold.allowance / 2
        points: list[FloatArray] = []
        bends = []
        for side, corner in enumerate(self.face):
            points.append(corner)
            if side in self.roots:
                root, out = self.roots[side], self._directions(side)[1]
                points += [root[0], root[0] + reach * out, root[1] + reach * out, root[1]]
                bends.append(Bend(root + middle * out, -90.0))
        ring = np.array(points)
        apart = np.linalg.norm(ring - np.roll(ring, 1, axis=0), axis=1) > _SAME
        return ring[apart], tuple(bends)

    def solid(self) -> cadquery.Solid:
        """Build the closed solid: the face, and each fold with its return along its side."""
        thick = self.fold.thickness
        plate = plate_body(self.face, self.face, thick).solid()
        solid: cadquery.Solid = plate.fuse(*map(self._return, self.roots)).Solids()[0]
        return solid

    def _return(self, side: int) -> cadquery.Solid:
        import cadquery

        fold, root, out = self.fold, self.roots[side], self._directions(side)[1]
        low, half = fold.thickness - fold.depth, math.sqrt(0.5)

        def at(away: float, level: float) -> cadquery.Vector:
            return cadquery.Vector(*(root[0] + away * out).tolist(), level)

        def arc(radius: float) -> cadquery.Edge:
            places = [(0.0, radius), (half * radius, half * radius), (radius, 0.0)]
            return cadquery.Edge.makeThreePointArc(
                *(at(away, up - fold.radius) for away, up in places)
            )

        corners = [at(0.0, 0.0), at(0.0, fold.thickness)]
        outer, inner = at(fold.back, -fold.radius), at(fold.radius, -fold.radius)
        ends = [at(fold.back, low), at(fold.radius, low)]
        line = cadquery.Edge.makeLine
        edges = [line(*corners), arc(fold.back), line(outer, ends[0]), line(*ends)]
        edges += [line(ends[1], inner), arc(fold.radius)]
        along = cadquery.Vector(*(root[1] - root[0]).tolist(), 0.0)
        wire = cadquery.Wire.assembleEdges(edges)
        return cadquery.Solid.extrudeLinear(wire, [], along)

    def pieces(self) -> tuple[Polyhedron, ...]:
        """The face, and boxes around folds and returns."""
        thick, back = self.fold.thickness, self.fold.back
        found = list(plate_body(self.face, self.face, thick).pieces())
        for side, root in self.roots.items():
            out = self._directions(side)[1]
            for near, far, low, high in (
                (0.0, back, -self.fold.radius, thick),
                (self.fold.radius, back, thick - self.fold.depth, -self.fold.radius),
            ):
                ring = np.array(
                    [root[0] + near * out, root[0] + far * out, root[1] + far * out]
                    + [root[1] + near * out]
                )
                box = plate_body(ring, ring, high - low)
                assert isinstance(box, Polyhedron)
                found.append(Polyhedron(box.corners + [0.0, 0.0, low], box.loops))
        return tuple(found)


def fold_report(fold: Fold, panels: Sequence[Part]) -> dict[str, object]:
    """What a report says of folded panels.

    Raises:
        InputError: none has room for folds.
    """
    flat = [panel.name for panel in panels if not isinstance(panel.body, Cassette)]
    if panels and len(flat) == len(panels):
        raise InputError(
            f"fold: no panel has room for folds {fold.depth:g} mm deep; take less, or 0 for none"
        )
    return {
        "cassettes": {
            "depth_mm": fold.depth,
            "radius_mm": fold.radius,
            "k_factor": fold.factor,
            "allowance_mm": fold.allowance,
            "folded": len(panels) - len(flat),
            "flat": flat,
        }
    }
